from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from . import _arguments as arguments

if TYPE_CHECKING:
    from ._core import Diagram


class Voronoi:
    """The exact geodesic Voronoi diagram of sites. Made by `Solver.voronoi()`.

    labels     (n,) the site that is nearest to each vertex; -1 where no site reaches
    distances  (n,) the distances of the vertices from their sites, minus the weights of the sites

    >>> import surface_mesh_geodesics as smg
    >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
    >>> v = s.voronoi([0, 1])
    >>> v.labels, v.areas.round(12), v.adjacency
    (array([0, 1, 1, 0]), array([2., 2.]), array([[0, 1]]))
    >>> v.centroids.round(12).tolist(), v.triangles.shape, v.colors.shape
    ([[0.5, 1.0, 0.0], [1.5, 1.0, 0.0]], (0, 3), (2, 3))
    """

    def __init__(self, diagram: Diagram, n_sites: int, extent: float, has_points: bool) -> None:
        self._diagram = diagram
        self._extent = extent
        self._has_points = has_points
        self.n_sites = n_sites
        self.labels, self.distances = diagram.at_vertices()

    @property
    def areas(self) -> np.ndarray:
        """(k,) the areas of the cells, in the square of the unit of the points. Their sum is the area reached."""
        return self._diagram.areas()

    @property
    def centroids(self) -> np.ndarray:
        """(k, 3) the centers of mass of the cells in space; they need not lie on the surface."""
        self._needs_points("centroids")
        return self._diagram.centroids()

    @property
    def adjacency(self) -> np.ndarray:
        """(p, 2) the pairs of cells with a common edge, each once, the smaller number first."""
        return self._diagram.adjacency()

    @property
    def colors(self) -> np.ndarray:
        """(k, 3) a color for each cell, from 0 to 255; cells with a common edge differ."""
        return self._diagram.colors()

    @property
    def triangles(self) -> np.ndarray:
        """(t, 3) the sites around each vertex of the diagram: the triangles of the dual."""
        return self._diagram.dual()

    def boundaries(self, site: int, tolerance: float | None = None) -> list[np.ndarray]:
        """Returns the curves around the cell of a site, without the border of the mesh.

        Each is an array of shape (k, 3); a closed curve ends with its first point. Segments of lines differ from the
        curves by at most `tolerance`, by default a thousandth of the extent of the mesh, at least a millionth.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> [line[:, 0].round(12).tolist() for line in s.voronoi([0, 1]).boundaries(0)]
        [[1.0, 1.0, 1.0]]
        """
        self._needs_points("boundaries")
        if np.ndim(site) != 0:
            raise ValueError(f"site is {site!r}, but one number is needed")
        site = int(arguments.ids_of("site", site, self.n_sites, "sites"))
        return self._diagram.boundaries(site, self._tolerance(tolerance))

    def cut(self, tolerance: float | None = None) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Returns the mesh cut along the diagram: points (n, 3), faces (m, 3), and the cell of each face (m,), -1 where
        no site reaches.

        `tolerance` as for boundaries(). The first points are the vertices of the mesh.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> V, F, cell = s.voronoi([0, 1]).cut()
        >>> float(V[F[cell == 0]][:, :, 0].max().round(12)), float(V[F[cell == 1]][:, :, 0].min().round(12))
        (1.0, 1.0)
        """
        self._needs_points("cut")
        return self._diagram.cut(self._tolerance(tolerance))

    def __repr__(self) -> str:
        return f"Voronoi({self.n_sites} sites, {len(self.labels)} vertices)"

    def _tolerance(self, tolerance: float | None) -> float:
        if tolerance is None:
            return self._extent / 1000 if self._extent > 0 else 1.0
        # A smaller one gives millions of points.
        least = 1e-6 * self._extent
        return arguments.length_of("tolerance", tolerance, least, f"at least {least:g}, a millionth of the extent")

    def _needs_points(self, name: str) -> None:
        if not self._has_points:
            raise ValueError(f"{name} needs points, but this surface is given by edge lengths")
