from __future__ import annotations

from typing import NamedTuple

import numpy as np

from . import _arguments as arguments
from ._core import Diagram


class Boundary(NamedTuple):
    """One curve around a cell as a polyline, with the cell on its left. Made by `Voronoi.boundary_polylines()`.

    >>> import surface_mesh_geodesics as smg
    >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
    >>> (line,) = s.voronoi([0, 1]).boundary_polylines(0)
    >>> line.points.shape, line.faces, line.vertices, line.is_closed
    ((3, 3), array([0, 0, 1]), array([-1, -1, -1]), False)
    """

    points: np.ndarray  #: (k, 3); the last is the first again if the curve is closed; zeros without points
    faces: np.ndarray  #: (k,), a face of each point; the segment before the point lies in it
    barycentric: np.ndarray  #: (k, 3), the coordinates of each point in its face
    vertices: np.ndarray  #: (k,), the number of the vertex of the diagram that the point is, or -1
    is_closed: bool  #: if not, both ends are at the border of the mesh


class DualReport(NamedTuple):
    """What `Voronoi.check_dual()` finds. Cells are numbers of sites; all lists but the last are faults.

    >>> import surface_mesh_geodesics as smg
    >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
    >>> report = s.voronoi([0, 1]).check_dual()
    >>> report.is_manifold, report.cells_without_triangle, report.pairs_without_triangle
    (False, [0, 1], [(0, 1)])
    """

    is_manifold: bool  #: the triangles form a manifold mesh
    is_triangulation: bool  #: they are the intrinsic Delaunay triangulation of the sites, and the only one
    is_polygon_mesh: bool  #: they form a mesh at all
    cells_that_are_not_disks: list[int]
    cells_with_several_boundaries: list[int]  #: they are disks, but meet the border of the mesh in several pieces
    cells_without_triangle: list[int]
    pairs_with_several_edges: list[tuple[int, int]]
    pairs_without_triangle: list[tuple[int, int]]  #: the common edge runs from border to border
    triples_with_several_vertices: list[list[int]]
    vertices_of_many_cells: list[list[int]]  #: more than three cells meet there


class Voronoi:
    """The exact geodesic Voronoi diagram of sites. Made by `Solver.voronoi()`.

    labels     (n,) the site that is nearest to each vertex; -1 where no site reaches
    distances  (n,) the distances of the vertices from their sites, minus the weights of the sites

    A diagram can be pickled; it is computed again then.

    >>> import surface_mesh_geodesics as smg
    >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
    >>> v = s.voronoi([0, 1])
    >>> v.labels, v.distances, v
    (array([0, 1, 1, 0]), array([0., 0., 2., 2.]), Voronoi(2 sites, 4 vertices))
    """

    def __init__(self, diagram: Diagram, n_sites: int, extent: float, has_points: bool) -> None:
        self._diagram = diagram
        self._extent = extent
        self._has_points = has_points
        self.n_sites = n_sites
        self.labels, self.distances = diagram.at_vertices()

    def __reduce__(self) -> tuple:
        return self._origin  # the diagram is computed again

    @property
    def areas(self) -> np.ndarray:
        """(k,) the areas of the cells, in the square of the unit of the points. Their sum is the area reached.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> s.voronoi([0, 1]).areas.round(12)
        array([2., 2.])
        """
        return self._diagram.areas()

    @property
    def centroids(self) -> np.ndarray:
        """(k, 3) the centers of mass of the cells in space; they need not lie on the surface.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> s.voronoi([0, 1]).centroids.round(12).tolist()
        [[0.5, 1.0, 0.0], [1.5, 1.0, 0.0]]
        """
        self._needs_points("centroids")
        return self._diagram.centroids()

    @property
    def adjacency(self) -> np.ndarray:
        """(p, 2) the pairs of cells with a common edge, each once, the smaller number first.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> s.voronoi([0, 1, 2, 3]).adjacency.tolist()[:2]
        [[0, 1], [0, 3]]
        """
        return self._diagram.adjacency()

    @property
    def colors(self) -> np.ndarray:
        """(k, 3) a color for each cell, from 0 to 255; cells with a common edge differ.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> s.voronoi([0, 1]).colors.shape
        (2, 3)
        """
        return self._diagram.colors()

    @property
    def is_disk(self) -> np.ndarray:
        """(k,) whether each cell with its boundary is a topological disk; an empty one is not.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> s.voronoi([0, 1, 0]).is_disk
        array([ True,  True, False])
        """
        return self._diagram.are_disks()

    @property
    def energy(self) -> float:
        """The sum over the cells of the integrals of squared distances from the sites in space; see Solver.relax().

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> round(s.voronoi([0, 1]).energy, 9)
        6.666666667
        """
        self._needs_points("energy")
        return self._diagram.energy()

    @property
    def triangles(self) -> np.ndarray:
        """(t, 3) the sites around each vertex of the diagram: the triangles of the dual.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> s.voronoi([0, 1, 2]).triangles.shape
        (1, 3)
        """
        return self._diagram.dual()

    def check_dual(self) -> DualReport:
        """Finds out whether the triangles of the dual form a surface, and where they do not.

        >>> import surface_mesh_geodesics as smg
        >>> V, F = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
        >>> smg.Solver(V, F).voronoi([0, 1, 2, 3]).check_dual().is_triangulation
        True
        """
        return DualReport(*self._diagram.check_dual())

    def boundaries(self, site: int, tolerance: float | None = None, *, along_border: bool = False) -> list[np.ndarray]:
        """Returns the curves around the cell of a site, as arrays of shape (k, 3): the points of boundary_polylines().

        A closed curve ends with its first point. Segments differ from the curves by at most `tolerance`, by default a
        thousandth of the diagonal of the mesh, at least a millionth. Curves end at the border of the mesh; with
        `along_border` they go on along it, and are all closed.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> [line[:, 0].round(12).tolist() for line in s.voronoi([0, 1]).boundaries(0)]
        [[1.0, 1.0, 1.0]]
        """
        self._needs_points("boundaries")
        return [line.points for line in self.boundary_polylines(site, tolerance, along_border=along_border)]

    def boundary_polylines(self, site: int, tolerance: float | None = None, *,
                           along_border: bool = False) -> list[Boundary]:
        """Returns the curves around the cell of a site, with the face and the coordinates of each point.

        The arguments are those of boundaries().

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> [(len(line.points), line.is_closed) for line in s.voronoi([0, 1]).boundary_polylines(0, along_border=True)]
        [(6, True)]
        """
        found = self._diagram.boundary_polylines(self._site(site), self._tolerance(tolerance), bool(along_border))
        return [Boundary(*line) for line in found]

    def cell_mesh(self, site: int, tolerance: float | None = None) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Returns the cell of a site as a mesh: points (n, 3), faces (m, 3), and the face of the surface that each face
        lies in, (m,). `tolerance` as for boundaries().

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> V, F, face = s.voronoi([0, 1]).cell_mesh(0)
        >>> float(V[:, 0].max().round(12)), F.shape[1], sorted(set(face.tolist()))
        (1.0, 3, [0, 1])
        """
        self._needs_points("cell_mesh")
        return self._diagram.cell_mesh(self._site(site), self._tolerance(tolerance))

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

    def _site(self, site: int) -> int:
        if np.ndim(site) != 0:
            raise ValueError(f"site is {site!r}, but one number is needed")
        return int(arguments.ids_of("site", site, self.n_sites, "sites"))

    def _tolerance(self, tolerance: float | None) -> float:
        if tolerance is None:
            return self._extent / 1000 if self._extent > 0 else 1.0
        # A smaller one gives millions of points.
        least = 1e-6 * self._extent
        return arguments.length_of("tolerance", tolerance, least, f"at least {least:g}, a millionth of the diagonal")

    def _needs_points(self, name: str) -> None:
        if not self._has_points:
            raise ValueError(f"{name} needs points, but this surface is given by edge lengths")
