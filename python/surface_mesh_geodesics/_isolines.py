from __future__ import annotations

import numpy as np


def linear_isolines(points: np.ndarray, faces: np.ndarray, values: np.ndarray, levels: np.ndarray) -> list[np.ndarray]:
    """Lines of a function that is linear in each face. A vertex counts as above the level if it has the value itself,
    so that a line crosses edges only."""
    finite = np.isfinite(values[faces]).all(axis=1) if len(faces) else np.zeros(0, dtype=bool)
    return [line for level in levels for line in _lines_of_level(points, faces[finite], values, level)]


def _lines_of_level(points: np.ndarray, faces: np.ndarray, values: np.ndarray, level: float) -> list[np.ndarray]:
    above = values >= level
    mixed = faces[above[faces].any(axis=1) & ~above[faces].all(axis=1)]
    edges = np.stack([mixed, np.roll(mixed, -1, axis=1)], axis=2)  # (m, 3, 2)
    is_crossed = above[edges[:, :, 0]] != above[edges[:, :, 1]]
    crossed = np.sort(edges[is_crossed], axis=1)
    unique, inverse = np.unique(crossed, axis=0, return_inverse=True)
    a, b = unique[:, 0], unique[:, 1]
    t = (level - values[a]) / (values[b] - values[a])
    nodes = points[a] + t[:, None] * (points[b] - points[a])
    lines = [nodes[chain] for chain in _chains(inverse.reshape(-1, 2), len(unique))]
    return [line for line in lines if (line != line[0]).any()]  # around a vertex with this value, all are equal


def _chains(segments: np.ndarray, n: int) -> list[list[int]]:
    """Joins segments to chains; each node has one or two segments. A closed chain ends with its first node."""
    neighbors: list[list[int]] = [[] for _ in range(n)]
    for p, q in segments.tolist():
        neighbors[p].append(q)
        neighbors[q].append(p)
    is_used = [False] * n
    ends = [i for i in range(n) if len(neighbors[i]) == 1]
    chains = []
    for first in ends + list(range(n)):
        if is_used[first]:
            continue
        is_used[first] = True
        chain = [first]
        while following := [q for q in neighbors[chain[-1]] if not is_used[q]]:
            is_used[following[0]] = True
            chain.append(following[0])
        if len(neighbors[first]) == 2 and (len(chain) > 2 or neighbors[first] == [chain[-1]] * 2):
            chain.append(first)
        chains.append(chain)
    return chains
