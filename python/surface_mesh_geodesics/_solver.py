from __future__ import annotations

import os
from typing import Any, Callable

import numpy as np

from . import _core
from . import _arguments as arguments
from ._certificate import Certificate, Condition
from ._isolines import linear_isolines
from ._path import Curve, Path, TracedGeodesic
from ._voronoi import Voronoi

Progress = Callable[[float], Any]
OnIteration = Callable[[int, float, float], Any]
NO_IDS = np.zeros(0, dtype=np.int64)


class Solver:
    """Geodesic computations on one triangle mesh.

    V  (n, 3) points: any type of numbers and any memory layout
    F  (m, 3) triangles: vertices counted from 0

    The mesh is copied; the arrays are never changed. It may have borders, holes, handles, several components and
    isolated vertices, but an edge has at most two faces, of the same orientation, and two closed surfaces must not
    share a vertex. All calls raise ValueError or IndexError, with the argument, the element and the rule, if an
    argument is wrong. `threads` says how many threads a call may take; None stands for all.

    >>> import surface_mesh_geodesics as smg
    >>> smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    Solver(3 vertices, 1 faces)

    A *source* is a vertex, or a pair (face, barycentric coordinates); several are given as a list, an array of
    vertices, or a pair of arrays (faces, coordinates). A `Curve` is a source of `distances()`, too.

    Several threads may use one solver; computations of distances and paths wait for the one before. Computations run
    without the lock of the interpreter. Ctrl-C ends them within 0.2 seconds if there are 75,000 faces. What takes
    seconds is the last step of a relaxation or a remeshing of a million faces, and `areas`, `energy` and `check_dual()`
    of a diagram with thousands of sites. `progress` is called with a number from 0 to 1 some twenty times a second, and
    never if the call is short; it must not use the solver that computes (RuntimeError). Solvers can be pickled, as
    those of derived classes with their attributes; the mesh is read again then. A process must not be forked while
    another of its threads computes.
    """

    def __init__(self, V: Any, F: Any) -> None:
        points = arguments.points_of("V", V)
        faces = arguments.triangles_of("F", F, len(points))
        self._set_up(points, faces, None)

    @classmethod
    def from_edge_lengths(cls, n: int, F: Any, L: Any) -> Solver:
        """Makes a solver for a surface without points.

        n  number of vertices
        F  (m, 3) triangles
        L  (m, 3) lengths: L[f, k] is that of the edge from F[f, k] to the next corner; equal in both faces of an edge

        Points of paths are zeros then; their faces and barycentric coordinates tell where they are. Isolines, samples,
        remeshing, and the lines and centroids of Voronoi diagrams need points.

        >>> import surface_mesh_geodesics as smg
        >>> smg.Solver.from_edge_lengths(3, [[0, 1, 2]], [[3, 5, 4]]).distances(0)
        array([0., 3., 4.])
        """
        n = arguments.count_of("n", n, 0)
        faces = arguments.triangles_of("F", F, n)
        lengths = arguments.numbers_of("L", L)
        if lengths.shape != faces.shape and (lengths.size > 0 or faces.size > 0):
            raise ValueError(f"L has shape {lengths.shape}, but F has {faces.shape}")
        lengths = arguments.points_of("L", lengths.reshape(-1, 3))
        arguments.check_elements("L", lengths, lengths < 0, "but a length must not be negative")
        most = (1 + 1e-9) * (np.roll(lengths, 1, 1) + np.roll(lengths, 2, 1))  # beyond rounding
        arguments.check_elements("L", lengths, lengths > most, "longer than the two other edges together")
        solver = cls.__new__(cls)
        solver._set_up(np.zeros((n, 3)), faces, lengths)
        return solver

    def avoiding(self, faces: Any) -> Solver:
        """Returns a solver for the same surface whose paths lead around faces. They may run along the rim of these.

        faces  ids of faces, in place of those that this solver avoids, or (m,) booleans

        Distances are inf where no way leads around. A source or a place inside of the avoided faces is an error; one at
        their rim is not. Vertices and faces keep their numbers. `remesh()` leaves the faces out. `trace()` ends there.
        Surfaces without points cannot avoid any.

        >>> import surface_mesh_geodesics as smg
        >>> V = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 0]]
        >>> s = smg.Solver(V, [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
        >>> s.avoiding([1, 2, 3]).distances(0).round(3)
        array([0.   , 2.   ,   inf,   inf, 1.414])
        """
        self._needs("avoiding", points=True)
        avoided = arguments.faces_of("faces", faces, self.n_faces)
        solver = self.__class__.__new__(self.__class__)
        solver.__setstate__({**self.__getstate__(), "_avoided": avoided})
        return solver

    # --- distances ---

    def distances(self, sources: Any, *, offsets: Any = None, targets: Any = None, radius: float = np.inf,
                  return_nearest: bool = False, return_foot: bool = False, threads: int | None = 1,
                  progress: Progress | None = None) -> Any:
        """Returns the distances of all vertices from their nearest sources, (n,) float64, inf where none reaches.

        A source may be a `Curve`, or a list may mix curves with vertices and pairs. The distance from a curve is the
        smallest one from any of its points, and exact. It takes one thread.

        offsets         a number for each source that is added to its distances
        targets         vertices: only their distances are computed and returned, in their order
        radius          distances beyond it are inf
        return_nearest  also return (n,) the positions of the nearest sources, -1 where none reaches; of several that
                        are equally near, any
        return_foot     also return where the shortest paths begin: a pair of arrays, (n,) faces, -1 where none reaches,
                        and (n, 3) coordinates
        threads         how many threads; None for all. All numbers above 1 give the same bits; 1 may give other last
                        digits

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> s.distances([1, (0, [1, 0, 0])], offsets=[0, 1], return_nearest=True)
        (array([1., 0., 5.]), array([1, 0, 0]))
        >>> s.distances([smg.Curve([0, 1]), 2])
        array([0., 0., 0.])
        """
        has_curves = return_foot or arguments.has_curves(sources)
        given = self._curves("sources", sources) if has_curves else self._places("sources", sources)
        ids = NO_IDS if targets is None else self._vertices("targets", targets)
        added = arguments.offsets_of("offsets", offsets, len(given) if has_curves else len(given[0]))
        options = (arguments.radius_of("radius", radius), bool(return_nearest or return_foot),
                   arguments.call_of(threads, progress))
        if targets is not None and len(ids) == 0:
            found = np.zeros(0), NO_IDS.copy(), np.zeros((0, 3)), NO_IDS.copy(), np.zeros((0, 3))
        else:
            compute = self._surface.curve_distances if has_curves else self._surface.distances
            found = compute(given, added, ids, *options)
        parts = (True, found[0]), (return_nearest, found[1]), (return_foot, found[3:])
        result = tuple(part for is_wanted, part in parts if is_wanted)
        return result if len(result) > 1 else found[0]

    def signed_distances(self, curves: Any, *, radius: float = np.inf, threads: int | None = 1,
                         progress: Progress | None = None) -> np.ndarray:
        """Returns the distances from curves that separate the surface, negative on one side, (n,) float64.

        curves  a `Curve` or a list of them. Every way from one side to the other crosses a curve: they are closed, or
                lead from border to border
        radius  distances beyond it are inf or -inf

        The negative side is on the left of the first segment of the first curve, seen from outside; in a component
        without that segment, of the first one there. Components without a curve have inf. The surface needs points.
        Takes one thread, whatever `threads` says.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> s.signed_distances(smg.Curve([0, 2])).round(6)
        array([ 0.      ,  1.414214,  0.      , -1.414214])
        """
        self._needs("signed_distances", points=True)
        return self._surface.signed_distances(self._curves("curves", curves), arguments.radius_of("radius", radius),
                                              arguments.call_of(threads, progress))

    def border_curves(self) -> list[Curve]:
        """Returns the borders of the surface as closed curves. The rim of faces to avoid is a border.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 0]],
        ...                [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
        >>> s.distances(s.border_curves())
        array([0., 0., 0., 0., 1.])
        """
        return [Curve(corners[1:], True) for corners in self._surface.border_curves()]

    def matrix(self, sources: Any = None, targets: Any = None, *, threads: int | None = None,
               progress: Progress | None = None) -> np.ndarray:
        """Returns the distances D[i, j] from source i to target j, a vertex. None stands for all vertices.

        >>> import surface_mesh_geodesics as smg
        >>> smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).matrix([0, 1])
        array([[0., 3., 4.],
               [3., 0., 5.]])
        """
        places, ids = self._rows_and_columns(sources, targets)
        return self._surface.matrix(places, ids, arguments.call_of(threads, progress))

    def sparse_matrix(self, radius: float, sources: Any = None, targets: Any = None, *, threads: int | None = None,
                      progress: Progress | None = None) -> Any:
        """Returns the distances up to a radius, as a scipy.sparse.csr_matrix.

        Distances of 0 are stored, too. Without SciPy, returns the triple (data, indices, indptr).

        >>> import surface_mesh_geodesics as smg
        >>> S = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).sparse_matrix(3.5, [0])
        >>> S.data if hasattr(S, "data") else S[0]
        array([0., 3.])
        """
        places, ids = self._rows_and_columns(sources, targets)
        pointers, columns, values = self._surface.sparse_matrix(places, ids, arguments.radius_of("radius", radius),
                                                                arguments.call_of(threads, progress))
        try:
            from scipy.sparse import csr_matrix
        except ImportError:
            return values, columns, pointers
        return csr_matrix((values, columns, pointers), shape=(len(places.vertex), len(ids)))

    def store_matrix(self, folder: Any, sources: Any = None, targets: Any = None, *, float32: bool = False,
                     symmetric: bool = False, radius: float = np.inf, rows: tuple[int, int] | None = None,
                     mesh_name: str = "", threads: int | None = None,
                     progress: Progress | None = None) -> tuple[int, int]:
        """Stores the matrix of `matrix()` in a folder, and goes on where an earlier call for the folder has ended.

        float32    round the distances to 32 bits
        symmetric  row i has the distances from source i to the sources i + 1, i + 2, ... only, which are the targets;
                   peeling_order() is the order of the sources that takes least time
        radius     store the distances up to it, as a sparse matrix
        rows       a pair (a, b): compute the files whose first row is in a, ..., b - 1
        mesh_name  a name for the manifest, such as the file of the mesh

        The rows are in files of NumPy's format, rows_*.npy, whose names sort in the order of the rows. Several
        processes may work on one folder. Returns how many rows of the range are stored, and how many there are. What
        is stored stays after Ctrl-C. A folder with another matrix is a ValueError, and a file that cannot be written an
        OSError. The surface needs points.

        >>> import glob, tempfile, surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     s.store_matrix(folder, [0, 1]), [np.load(f) for f in sorted(glob.glob(f"{folder}/rows_*.npy"))]
        ((2, 2), [array([[0., 3., 4.],
               [3., 0., 5.]])])
        """
        self._needs("store_matrix", points=True)
        places, ids = self._rows_and_columns(sources, targets)
        return self._surface.store_matrix(places, ids, os.fsencode(folder), bool(float32), bool(symmetric),
                                          arguments.radius_of("radius", radius), arguments.rows_of("rows", rows),
                                          os.fsencode(str(mesh_name)), arguments.call_of(threads, progress))

    def peeling_order(self, vertices: Any = None) -> np.ndarray:
        """Returns vertices in an order in which the rows of a symmetric matrix take little time.

        In each component, they are sorted by descending distance from an end of it. None stands for all vertices. The
        surface needs points.

        >>> import surface_mesh_geodesics as smg
        >>> smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).peeling_order()
        array([1, 0, 2])
        """
        self._needs("peeling_order", points=True)
        every = np.arange(self.n_vertices)
        return self._surface.peeling_order(self._vertices("vertices", every if vertices is None else vertices))

    def certify(self, d: Any, sources: Any, *, offsets: Any = None, radius: float = np.inf,
                threads: int | None = None, progress: Progress | None = None) -> Certificate:
        """Proves distances right or wrong, no matter who computed them.

        d        (n,) the distances of all vertices from the sources, inf where none reaches. NaN is wrong, not an error
        threads  how many threads; None for all. The result does not depend on it

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> s.certify([3, 0, 5], 1).is_certified(), s.certify([3, 0, 5.1], 1).is_certified()
        (True, False)
        """
        places = self._places("sources", sources)
        added = arguments.offsets_of("offsets", offsets, len(places.vertex))
        worst, conditions = self._surface.certify(arguments.values_of("d", d, self.n_vertices), places, added,
                                                  arguments.radius_of("radius", radius),
                                                  arguments.call_of(threads, progress))
        return Certificate(worst, {name: Condition(*rest) for name, *rest in conditions})

    def shortest_path_curve(self, places: Any, closed: bool = False, *, threads: int | None = 1,
                            progress: Progress | None = None) -> Curve:
        """Returns the curve that joins places by shortest paths, one after the other. Each takes the time of a
        path() from another source.

        places  given as several sources are
        closed  whether a last path leads from the last place to the first one

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> s.distances(s.shortest_path_curve([1, 3])).round(6)
        array([1.414214, 0.      , 1.414214, 0.      ])
        """
        ends = arguments.single_places(self._places("places", places))
        call = arguments.call_of(threads, progress)
        if len(ends) == 0:
            raise ValueError("places has no places, but a curve has at least one")
        if len(ends) == 1:
            return Curve(places, closed)
        legs = [self._surface.paths(*pair, call)[0] for pair in zip(ends, ends[1:] + ends[:1] * bool(closed))]
        for i, leg in enumerate(legs):
            if leg[1] < 0:
                raise ValueError(f"places[{i}] and the next place are not connected")
        return Curve(tuple(np.concatenate(arrays) for arrays in zip(*(leg[3:] for leg in legs))), closed)

    # --- paths ---

    def path(self, source: Any, target: Any, *, threads: int | None = 1, progress: Progress | None = None) -> Path:
        """Returns the shortest path from a source, or from the nearest of several, to a target.

        The first call computes what all paths from the same sources need, in as many threads as it is told; further
        ones are fast.

        >>> import surface_mesh_geodesics as smg
        >>> p = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).path(1, 2)
        >>> p.length, p.points.tolist()
        (5.0, [[3.0, 0.0, 0.0], [0.0, 4.0, 0.0]])
        """
        (found,) = self._surface.paths(self._places("source", source), self._place("target", target),
                                       arguments.call_of(threads, progress))
        return Path(*found)

    def paths(self, sources: Any, targets: Any, *, threads: int | None = None,
              progress: Progress | None = None) -> list[Path]:
        """Returns for each target the shortest path from its nearest source. Targets are given as sources are.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> [(p.source, p.length) for p in s.paths([0, 1], [0, 2])]
        [(0, 0.0), (0, 4.0)]
        """
        found = self._surface.paths(self._places("sources", sources), self._places("targets", targets),
                                    arguments.call_of(threads, progress))
        return [Path(*path) for path in found]

    def exact_isolines(self, sources: Any, levels: Any, *, threads: int | None = 1,
                       progress: Progress | None = None) -> list[list[np.ndarray]]:
        """Returns for each level the lines of all points at this distance from the sources, arrays of shape (k, 3).

        Points on edges are exact, and chords join them in faces. A closed line ends with its first point. Nearer
        points are on the left of a line, seen from the side from which triangles are counterclockwise.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> [line[[0, -1]].round(9).tolist() for line in s.exact_isolines(0, 2)[0]]
        [[[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]]
        """
        self._needs("exact_isolines", points=True)
        return self._surface.isolines(self._places("sources", sources), arguments.row_without_nan("levels", levels),
                                      arguments.call_of(threads, progress))

    def isolines(self, d: Any, levels: Any) -> list[np.ndarray]:
        """Returns the lines where a function on the surface has one of the levels, as arrays of shape (k, 3).

        d  (n,) values at the vertices, such as distances; linear in each face. Faces with infinite values have none.

        Takes one thread.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> s.isolines(s.distances(0), 2)[0].tolist()
        [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]
        """
        self._needs("isolines", points=True)
        values = arguments.row_without_nan("d", arguments.values_of("d", d, self.n_vertices))
        return linear_isolines(*self._surface.arrays(), values, arguments.row_without_nan("levels", levels))

    # --- directions ---

    def directions(self, sources: Any, *, return_nearest: bool = False, threads: int | None = 1,
                   progress: Progress | None = None) -> tuple[np.ndarray, ...]:
        """Returns the logarithmic map: the distance of each vertex from its nearest source, (n,), inf where none
        reaches, and the direction in which its shortest path leaves the source, (n,), NaN where none reaches.

        return_nearest  also return (n,) the positions of the nearest sources, -1 where none reaches

        A direction is an angle in radians, counterclockwise as the corners of the faces. At a point of a face it is
        counted from the edge between the first two corners of the face in F. At a vertex it is counted from an edge
        that depends only on the mesh, and scaled such that a full turn is 2 pi; at the border it is not scaled, and
        counted from the first edge. `direction_of()` tells the direction of a vector of space.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> s.directions(0)[1].round(6)
        array([0.      , 0.      , 1.570796])
        """
        found = self._surface.directions(self._places("sources", sources), arguments.call_of(threads, progress))
        return found if return_nearest else found[:2]

    def trace(self, place: Any, direction: float, length: float) -> TracedGeodesic:
        """Returns the straightest geodesic from a place in a direction: the exponential map.

        place      a vertex, or a pair (face, coordinates)
        direction  an angle as `directions()` returns it
        length     in the unit of the points

        The geodesic is straight in each face and across edges; at a vertex it goes on with equal angles on both sides.
        It ends at the border, and at faces that the solver avoids.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> t = s.trace((0, [0.5, 0.5, 0]), s.direction_of((0, [0.5, 0.5, 0]), [0, 1, 0]), 5)
        >>> t.length, t.end, t.points.round(12).tolist()
        (2.0, 'border', [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 0.0]])
        """
        end = ("length", "border", "singularity")
        found = self._surface.trace(self._place("place", place), arguments.finite_of("direction", direction),
                                    arguments.finite_of("length", length, 0.0, "finite and not negative"))
        return TracedGeodesic(found[0], end[found[1]], *found[2:])

    def direction_of(self, place: Any, vector: Any) -> float:
        """Returns the direction of a vector of space at a place, as `directions()` counts directions.

        The vector is projected to the plane of the face of the place; at a vertex, of one of its faces.

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> s.direction_of((0, [0.5, 0.25, 0.25]), [1, 1, 7]) * 4 / np.pi
        1.0
        """
        self._needs("direction_of", points=True)
        return self._surface.direction_of(self._place("place", place), arguments.finite_row_of("vector", vector, 3))

    # --- diagrams, samples ---

    def voronoi(self, sites: Any, weights: Any = None, *, threads: int | None = 1,
                progress: Progress | None = None) -> Voronoi:
        """Returns the exact geodesic Voronoi diagram of sites, which are given as sources are.

        weights  a number for each site that is subtracted from its distances: a larger weight gives a larger cell

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> v = s.voronoi([0, 1])
        >>> v.labels, v.areas.round(12), v.adjacency
        (array([0, 1, 1, 0]), array([2., 2.]), array([[0, 1]]))
        """
        places = arguments.Places(*(array.copy() for array in self._places("sites", sites)))
        n = len(places.vertex)
        return self._voronoi(places, arguments.weights_of("weights", weights, n), arguments.call_of(threads, progress))

    def labels(self, sites: Any, weights: Any = None, *, threads: int | None = 1,
               progress: Progress | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Returns the nearest site of each vertex, (n,), -1 where none reaches, and the distance from it, (n,).

        These are `labels` and `distances` of the diagram of `voronoi()`, at the price of `distances()`. Sites and
        `weights` as there, threads as in `distances()`.

        >>> import surface_mesh_geodesics as smg
        >>> smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).labels([1, 2], weights=[0, 3])
        (array([1, 0, 1]), array([ 1.,  0., -3.]))
        """
        places = self._places("sites", sites)
        given = arguments.weights_of("weights", weights, len(places.vertex))
        largest = float(given.max()) if len(given) > 0 else 0.0
        with np.errstate(over="ignore"):
            offsets = largest - given
        if np.isinf(offsets).any():
            raise ValueError(f"weights[{np.argmax(offsets)}] differs too much from the largest one")
        d, nearest, *_ = self._surface.distances(places, offsets, NO_IDS, np.inf, True,
                                                 arguments.call_of(threads, progress))
        return nearest, d - largest

    def sample(self, n: int, *, first: Any = None, covering_radius: float = 0.0, return_radius: bool = False,
               threads: int | None = 1, progress: Progress | None = None) -> Any:
        """Returns vertices that are spread evenly over the surface, each the farthest from those before it.

        first            vertices that are samples already; they count among the n and come first in the result, all of
                         them even if there are more than n
        covering_radius  sampling ends when no vertex is farther from its nearest sample
        return_radius    return a pair: the samples, and the largest finite distance of a vertex from its nearest sample

        Takes one thread, whatever `threads` says: each sample depends on those before.

        >>> import surface_mesh_geodesics as smg
        >>> smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).sample(2, first=[1])
        array([1, 2])
        """
        self._needs("sample", points=True)
        given = NO_IDS if first is None else self._vertices("first", first)
        found, radius = self._surface.sample(arguments.count_of("n", n, 0), given,
                                             arguments.radius_of("covering_radius", covering_radius),
                                             arguments.call_of(threads, progress)[1])
        samples = np.concatenate([given, found])
        return (samples, radius) if return_radius else samples

    def relax(self, sites: Any, *, iterations: int = 10, threshold: float = 0.0,
              on_iteration: OnIteration | None = None, threads: int | None = 1,
              progress: Progress | None = None) -> np.ndarray:
        """Moves sites, which are vertices, to the centers of their cells again and again (Lloyd); returns where they
        end, in their order.

        iterations    at most so many diagrams are computed
        threshold     the relaxation ends when no site moves farther than this in space
        on_iteration  a function that is called after each iteration, with its number from 1, the largest move of a
                      site, and the energy before: the sum over the cells of the integrals of squared distances in space
        threads       how many threads; None for all. The result does not depend on it

        >>> import surface_mesh_geodesics as smg
        >>> V = [[x, y, 0] for x in range(5) for y in range(2)]
        >>> F = [f for i in (0, 2, 4, 6) for f in ([i, i + 2, i + 3], [i, i + 3, i + 1])]
        >>> smg.Solver(V, F).relax([0, 1], on_iteration=lambda i, move, energy: print(i, round(move, 6)))
        1 2.0
        2 0.0
        array([4, 5])
        """
        self._needs("relax", points=True)
        return self._surface.relax(self._vertices("sites", sites),
                                   arguments.relaxation_of(iterations, threshold, on_iteration),
                                   arguments.call_of(threads, progress))

    def remesh(self, n: int, *, iterations: int = 10, threshold: float = 0.0, on_iteration: OnIteration | None = None,
               threads: int | None = 1, progress: Progress | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Returns points (n, 3) and faces (m, 3) of a coarser mesh with even triangles.

        The vertices are samples that are relaxed; the arguments are those of `relax()`. The result has the handles and
        borders of the surface, and more than n vertices where it needs them. A component with few vertices stays as it
        is.

        >>> import surface_mesh_geodesics as smg
        >>> V = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
        >>> V2, F2 = smg.Solver(V, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]).remesh(4, iterations=0)
        >>> V2.shape, F2.shape
        ((4, 3), (4, 3))
        """
        self._needs("remesh", points=True)
        return self._surface.remesh(arguments.count_of("n", n, 3, max(3, self.n_vertices)),
                                    arguments.relaxation_of(iterations, threshold, on_iteration),
                                    arguments.call_of(threads, progress))

    # --- the mesh ---

    @property
    def n_vertices(self) -> int:
        """The number of vertices.

        >>> import surface_mesh_geodesics as smg
        >>> smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).n_vertices
        3
        """
        return self._sizes[0]

    @property
    def n_faces(self) -> int:
        """The number of faces.

        >>> import surface_mesh_geodesics as smg
        >>> smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).n_faces
        1
        """
        return self._sizes[1]

    def __repr__(self) -> str:
        return f"Solver({self.n_vertices} vertices, {self.n_faces} faces)"

    def __getstate__(self) -> dict:
        return {**self.__dict__, "_surface": self._surface.arrays()}

    def __setstate__(self, state: dict) -> None:
        self.__dict__.update(state)
        lengths = np.zeros((0, 3)) if self._lengths is None else self._lengths
        self._surface = _core.Surface(*state["_surface"], lengths, self._avoided)

    def _set_up(self, points: np.ndarray, faces: np.ndarray, lengths: np.ndarray | None) -> None:
        diagonal = np.ptp(points, axis=0) if len(points) > 0 else np.zeros(3)
        extent = np.hypot.reduce(diagonal) if lengths is None else lengths.max(initial=0.0)
        self.__setstate__({"_surface": (points, faces), "_sizes": (len(points), len(faces)), "_avoided": NO_IDS,
                           "_extent": float(extent), "_lengths": None if lengths is None else lengths.copy()})

    def _voronoi(self, places: arguments.Places, weights: np.ndarray, call: tuple[int, Any]) -> Voronoi:
        voronoi = Voronoi(self._surface.diagram(places, weights, call), len(places.vertex), self._extent,
                          self._lengths is None)
        voronoi._origin = self._voronoi, (places, weights.copy(), (call[0], None))
        return voronoi

    def _places(self, name: str, values: Any) -> arguments.Places:
        return arguments.places_of(name, values, self.n_vertices, self.n_faces)

    def _curves(self, name: str, values: Any) -> list[tuple[arguments.Places, bool]]:
        return arguments.curves_of(name, values, self.n_vertices, self.n_faces)

    def _place(self, name: str, value: Any) -> arguments.Places:
        places = self._places(name, value)
        if len(places.vertex) != 1:
            raise ValueError(f"{name} has {len(places.vertex)} places, but one is needed")
        return places

    def _vertices(self, name: str, values: Any) -> np.ndarray:
        return arguments.row_of_ids(name, values, self.n_vertices)

    def _rows_and_columns(self, sources: Any, targets: Any) -> tuple[arguments.Places, np.ndarray]:
        every = np.arange(self.n_vertices, dtype=np.int64)
        places = self._places("sources", every if sources is None else sources)
        return places, every if targets is None else self._vertices("targets", targets)

    def _needs(self, name: str, *, points: bool) -> None:
        if points and self._lengths is not None:
            raise ValueError(f"{name}() needs points, but this surface is given by edge lengths")
