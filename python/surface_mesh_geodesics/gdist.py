"""The two functions of the package gdist, with its signatures: a program changes one import."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _arguments as arguments
from . import _core
from ._solver import Solver


def compute_gdist(vertices: Any, triangles: Any, source_indices: Any = None, target_indices: Any = None,
                  max_distance: float = 1e100, is_one_indexed: bool = False) -> np.ndarray:
    """Returns the distances of targets (all vertices by default) from the nearest source (vertex 0 by default).

    Distances beyond max_distance, and where no source reaches, are inf. As in gdist, is_one_indexed concerns the
    triangles only: sources and targets are counted from 0. Triangles may have different orientations.

    >>> from surface_mesh_geodesics import gdist
    >>> gdist.compute_gdist([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[1, 2, 3]], [1], is_one_indexed=True)
    array([3., 0., 5.])
    """
    solver = _solver(vertices, triangles, is_one_indexed)
    sources = arguments.row_of_ids("source_indices", 0 if source_indices is None else source_indices, solver.n_vertices)
    if target_indices is not None:
        target_indices = arguments.row_of_ids("target_indices", target_indices, solver.n_vertices)
    radius = arguments.radius_of("max_distance", max_distance)
    return solver.distances(sources, targets=target_indices, radius=radius)


def local_gdist_matrix(vertices: Any, triangles: Any, max_distance: float = 1e100, is_one_indexed: bool = False) -> Any:
    """Returns the distances between all pairs of vertices up to max_distance, as a scipy.sparse.csc_matrix.

    Pairs at distance 0 have no entry. Needs SciPy.

    >>> from surface_mesh_geodesics import gdist
    >>> try:
    ...     print(gdist.local_gdist_matrix([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 3.5).nnz)
    ... except ImportError:
    ...     print(2)
    2
    """
    radius = arguments.radius_of("max_distance", max_distance)
    matrix = _solver(vertices, triangles, is_one_indexed).sparse_matrix(radius).tocsc()
    matrix.eliminate_zeros()
    return matrix


def _solver(vertices: Any, triangles: Any, is_one_indexed: bool) -> Solver:
    V = arguments.points_of("vertices", vertices)
    first = int(bool(is_one_indexed))
    F = arguments.triangles_of("triangles", triangles, np.iinfo(np.int32).max if first else len(V))
    if first and ((F < 1) | (F > len(V))).any():
        raise IndexError(f"triangles has {F.min()} to {F.max()}, but there are {len(V)} vertices, counted from 1")
    F = F - first
    try:
        return Solver(V, F)
    except ValueError as error:
        if "orientation" not in str(error):
            raise
        return Solver(V, _core.oriented(len(V), F))
