"""Small meshes: pairs (V, F)."""

import numpy as np


def grid(n=12, height=0.0, seed=0):
    """A square of side 1 with (n+1)^2 vertices, flat or rough."""
    x, y = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1), indexing="ij")
    z = height * np.random.default_rng(seed).random(x.shape)
    V = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    i = (np.arange(n)[:, None] * (n + 1) + np.arange(n)[None, :]).ravel()
    F = np.concatenate([np.stack([i, i + n + 1, i + n + 2], axis=1), np.stack([i, i + n + 2, i + 1], axis=1)])
    return V, F


def sphere(n=24):
    """A closed surface with poles, of 2 n (n - 1) faces."""
    theta = np.linspace(0, np.pi, n + 1)[1:-1]
    phi = np.linspace(0, 2 * np.pi, n, endpoint=False)
    ring = np.stack([np.sin(theta)[:, None] * np.cos(phi), np.sin(theta)[:, None] * np.sin(phi),
                     np.cos(theta)[:, None] + 0 * phi], axis=-1).reshape(-1, 3)
    V = np.concatenate([[[0, 0, 1]], ring, [[0, 0, -1]]])
    last = len(V) - 1
    F = []
    for j in range(n):
        k = (j + 1) % n
        F.append([0, 1 + j, 1 + k])
        for r in range(n - 2):
            a, b, c, d = 1 + r * n + j, 1 + r * n + k, 1 + (r + 1) * n + j, 1 + (r + 1) * n + k
            F += [[a, c, d], [a, d, b]]
        F.append([last, 1 + (n - 2) * n + k, 1 + (n - 2) * n + j])
    return V, np.array(F)


def two_components():
    """Two squares that are apart, and a vertex without a face."""
    V, F = grid(3)
    return np.concatenate([V, V + [5, 0, 0], [[9, 9, 9]]]), np.concatenate([F, F + len(V)])


def write_off(path, V, F):
    lines = ["OFF", f"{len(V)} {len(F)} 0"]
    lines += [" ".join(repr(float(x)) for x in p) for p in V]
    lines += ["3 " + " ".join(str(int(i)) for i in f) for f in F]
    path.write_text("\n".join(lines) + "\n")
