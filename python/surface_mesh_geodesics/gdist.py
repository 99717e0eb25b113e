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
    sources = 0 if source_indices is None else source_indices
    return _solver(vertices, triangles, is_one_indexed).distances(sources, targets=target_indices, radius=max_distance)


def local_gdist_matrix(vertices: Any, triangles: Any, max_distance: float = 1e100,
                       is_one_indexed: bool = False) -> Any:
    """Returns the distances between all pairs of vertices up to max_distance, as a scipy.sparse.csc_matrix.

    Pairs at distance 0 have no entry. Needs SciPy.

    >>> from surface_mesh_geodesics import gdist
    >>> gdist.local_gdist_matrix([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 3.5).nnz  # doctest: +SKIP
    2
    """
    matrix = _solver(vertices, triangles, is_one_indexed).sparse_matrix(max_distance).tocsc()
    matrix.eliminate_zeros()
    return matrix


def _solver(vertices: Any, triangles: Any, is_one_indexed: bool) -> Solver:
    V = arguments.points_of("vertices", vertices)
    F = np.asarray(triangles, dtype=np.int64) - 1 if is_one_indexed else triangles
    F = arguments.triangles_of("triangles", F, len(V))
    try:
        return Solver(V, F)
    except ValueError:
        return Solver(V, _core.oriented(len(V), F))
