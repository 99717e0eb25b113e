"""What is accepted, what is rejected, and how."""

import copy
import pickle

import numpy as np
import pytest

import surface_mesh_geodesics as smg
from meshes import grid, sphere

V, F = grid(4, 0.2)
EXPECTED = smg.Solver(V, F).distances(3)


@pytest.mark.parametrize("dtype", [np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.int64, np.uint64,
                                   np.float32, np.float64])
def test_types_of_faces(dtype):
    assert np.array_equal(smg.Solver(V, F.astype(dtype)).distances(3), EXPECTED)


@pytest.mark.parametrize("change", [np.asfortranarray, lambda a: a[::-1][::-1], lambda a: np.repeat(a, 2, axis=0)[::2],
                                    lambda a: a.tolist(), lambda a: a.astype(a.dtype.newbyteorder(">"))])
def test_layouts(change):
    assert np.array_equal(smg.Solver(change(V), change(F)).distances(3), EXPECTED)


def test_float32_points_are_exact_numbers():
    single = V.astype(np.float32)
    assert np.array_equal(smg.Solver(single, F).distances(3), smg.Solver(single.astype(float), F).distances(3))


def test_arrays_do_not_change_and_are_not_kept():
    v, f = V.copy(), F.copy()
    s = smg.Solver(v, f)
    s.distances(3)
    s.voronoi([0, 5])
    assert np.array_equal(v, V) and np.array_equal(f, F)
    v[:] = 0
    f[:] = 0
    assert np.array_equal(pickle.loads(pickle.dumps(s)).distances(3), EXPECTED)
    v.flags.writeable = f.flags.writeable = False
    frozen = V.copy()
    frozen.flags.writeable = False
    assert np.array_equal(smg.Solver(frozen, F).distances(3), EXPECTED)


def nan_points():
    points = V.copy()
    points[2, 1] = np.nan
    return points


@pytest.mark.parametrize("points, faces, error, message", [
    (V[:, :2], F, ValueError, r"V has shape \(25, 2\)"),
    (V.ravel(), F, ValueError, r"V has shape"),
    (nan_points(), F, ValueError, r"V\[2, 1\] is nan"),
    (V > 0, F, ValueError, "bool"),
    (V + 1j, F, ValueError, "complex"),
    ([["a", "b", "c"]], F, ValueError, "V"),
    (V, F + 1, IndexError, r"F\[\d+, \d\] is 25, but there are 25 vertices"),
    (V, F - 1, IndexError, r"is -1, but there are 25 vertices"),
    (V, F + 0.5, ValueError, r"F\[0, 0\] is 0.5, not an integer"),
    (V, np.zeros((3, 4), int), ValueError, r"F\[0\] has 4 corners"),
    (V, [[0, 1, 2], [0, 1, 2, 3]], ValueError, r"F\[1\] has 4 corners"),
    (V, [[0, 1, 2], [0, 1]], ValueError, r"F\[1\] has 2 corners"),
    (V, F.ravel(), ValueError, r"F has shape"),
    (V, F > 2, ValueError, "bool"),
    (V, [[0, 1, 1]], ValueError, r"F\[0\] has a vertex twice"),
    (V, [[0, 1, 2], [0, 1, 3]], ValueError, r"F\[1\] does not fit"),
    (V, np.vstack([F, F[:1, ::-1]]), ValueError, r"F\[\d+\] does not fit"),
])
def test_bad_meshes(points, faces, error, message):
    with pytest.raises(error, match=message):
        smg.Solver(points, faces)


@pytest.mark.parametrize("sources, error, message", [
    (25, IndexError, "sources is 25, but there are 25 vertices"),
    (-1, IndexError, "sources is -1"),
    ([0, 99], IndexError, r"sources\[1\] is 99"),
    (1.5, ValueError, "sources is 1.5, not an integer"),
    (np.nan, ValueError, "sources"),
    ([[0, 1]], ValueError, "sources has shape"),
    ("0", ValueError, "sources has the type"),
    (b"0", ValueError, "sources has the type"),
    (None, ValueError, "sources has the type"),
    ({1: 2}, ValueError, "sources has the type"),
    (np.ma.masked_equal([1, 2], 2), ValueError, "sources has masked elements"),
    ([2**64], (ValueError, IndexError), "sources"),
    ((32, [1, 0, 0]), IndexError, "face of sources is 32, but there are 32 faces"),
    ((0, [1, 1, 1]), ValueError, "coordinates .* of sources"),
    ((0, [2, -1, 0]), ValueError, "coordinates .* of sources"),
    ((0, [1, 0]), ValueError, "coordinates of sources have the shape"),
    ([3, (0, [np.nan, 0, 0])], ValueError, r"coordinates .* of sources\[1\]"),
    (([0, 1], [[1, 0, 0], [1, 0]]), ValueError, "coordinates of sources is not an array of numbers"),
    ((0, [None, 0, 1]), ValueError, "coordinates of sources has the type object"),
    ([(0, [1, 0, 0]), [1, 2]], ValueError, r"sources\[1\] is"),
    ([(0, [1, 0, 0]), []], ValueError, r"sources\[1\] is"),
    ([(0, [1, 0, 0]), ([1, 2], [[1, 0, 0], [1, 0, 0]])], ValueError, r"sources\[1\]"),
])
def test_bad_sources(sources, error, message):
    with pytest.raises(error, match=message):
        smg.Solver(V, F).distances(sources)


@pytest.mark.parametrize("options, message", [
    ({"offsets": [0, 1]}, "offsets has shape"), ({"offsets": [-1]}, r"offsets\[0\] is -1"),
    ({"offsets": [np.inf]}, r"offsets\[0\] is inf"), ({"radius": -1}, "radius"), ({"radius": np.nan}, "radius"),
    ({"threads": 0}, "threads"), ({"threads": 1.5}, "threads"), ({"threads": True}, "threads"),
    ({"targets": [[1]]}, "targets"), ({"targets": (0, [1, 0, 0])}, "targets"), ({"radius": "0.5"}, "radius"),
    ({"radius": [0.5]}, "radius"), ({"radius": None}, "radius"), ({"threads": np.nan}, "threads"),
    ({"threads": 10**30}, "threads"), ({"offsets": ["1"]}, "offsets"), ({"offsets": [1j]}, "offsets"),
    ({"progress": 5}, "progress"), ({"targets": [], "radius": -1}, "radius"),
])
def test_bad_options(options, message):
    with pytest.raises(ValueError, match=message):
        smg.Solver(V, F).distances(0, **options)


def test_pairs_of_arrays_of_any_length():
    s = smg.Solver(V, F)
    rows = np.eye(3)
    for faces, weights in (([0, 1], rows[:2]), ((0, 1), rows[:2].tolist()), ((0, 1), ((1, 0, 0), (0, 1, 0))),
                           ([0, 1, 2], rows), ((0, 1, 2), rows)):
        assert (s.distances((faces, weights)) == s.distances(list(zip(faces, weights)))).all()
    assert np.isinf(s.distances((np.array([], int), np.zeros((0, 3))))).all()
    assert np.isinf(s.distances(([], np.zeros((0, 3))))).all()
    assert (s.distances((3, 4)) == s.distances([3, 4])).all()
    assert (s.distances(((0, [1, 0, 0]), (1, [0, 1, 0]))) == s.distances(([0, 1], rows[:2]))).all()
    with pytest.raises(ValueError, match="coordinates of sources have the shape"):
        s.distances((0, (1, 0)))


def test_faces_as_booleans():
    s = smg.Solver(V, F)
    flags = [f % 7 == 0 for f in range(len(F))]
    d = s.avoiding(flags).distances(12)
    assert (d == s.avoiding(np.array(flags)).distances(12)).all()
    assert (d == s.avoiding(np.flatnonzero(flags)).distances(12)).all()
    with pytest.raises(ValueError, match="faces has shape"):
        s.avoiding([True, False])


def test_zeros_without_a_sign():
    s = smg.Solver(V, F)
    assert not np.signbit(s.distances(0, offsets=-0.0)[0])
    assert not np.signbit(s.trace(12, 0, -0.0).length)


def test_edges_that_form_no_triangle():
    with pytest.raises(ValueError, match=r"L\[0, 2\] is 5.0, longer than the two other edges together"):
        smg.Solver.from_edge_lengths(3, [[0, 1, 2]], [[1, 1, 5]])


def test_the_mesh_is_copied():
    points, faces = V.copy(), F.copy()
    s = smg.Solver(points, faces)
    points[:], faces[:] = 0, 0
    other = pickle.loads(pickle.dumps(s))
    assert (other.matrix() == smg.Solver(V, F).matrix()).all() and (s.matrix() == other.matrix()).all()
    assert other.distances((3, [.5, .25, .25])).tolist() == s.distances((3, [.5, .25, .25])).tolist()


def test_coordinates_of_other_types():
    s = smg.Solver(V, F)
    for dtype, bound in ((np.float32, 1e-6), (np.float16, 1e-2)):
        for b in np.random.default_rng(1).dirichlet([1, 1, 1], 50).astype(dtype):
            exact = b.astype(float) / b.astype(float).sum()
            assert np.allclose(s.distances((7, b)), s.distances((7, exact)), atol=bound)


def test_sequences_of_places():
    s = smg.Solver(V, F)
    pair = (7, [0.2, 0.3, 0.5])
    expected = np.minimum(s.distances(pair), s.distances(3))
    of_tuples = (7, (0.2, 0.3, 0.5))
    for places in ([3, pair], (pair, 3), [pair, np.int64(3)], [pair, [3]], [3, of_tuples], (of_tuples, 3)):
        assert np.array_equal(s.distances(places), expected)


class Frame:
    """Like a table of pandas: iterating gives the names of the columns."""

    def __init__(self, values):
        self.values = values

    def __array__(self, dtype=None):
        return np.asarray(self.values, dtype)

    def __iter__(self):
        return iter("abc")


def test_objects_that_convert_to_arrays():
    assert np.array_equal(smg.Solver(Frame(V), Frame(F)).distances(Frame([3])), EXPECTED)


def test_bad_calls():
    s = smg.Solver(V, F)
    v = s.voronoi([0, 24])
    for call, message in ((lambda: s.isolines(EXPECTED, None), "levels"),
                          (lambda: s.isolines(EXPECTED, [[1]]), "levels"),
                          (lambda: s.exact_isolines(0, np.nan), "levels"), (lambda: s.certify(["1"] * 25, 0), "d has"),
                          (lambda: v.cut("0.1"), "tolerance"), (lambda: v.cut(1e-9), "tolerance"),
                          (lambda: v.boundaries([0]), "site"), (lambda: s.sample(np.nan), "n is"),
                          (lambda: s.remesh(5, iterations=2**40), "iterations"),
                          (lambda: s.relax([0], threshold=-1), "threshold"),
                          (lambda: s.relax([0], on_iteration=1), "on_iteration"),
                          (lambda: s.relax((0, [1, 0, 0])), "sites"), (lambda: s.labels([0], [1, 2]), "weights"),
                          (lambda: v.cell_mesh([0]), "site"), (lambda: v.boundary_polylines(0, -1), "tolerance"),
                          (lambda: smg.Solver(V, None), "F has"),
                          (lambda: smg.Solver.from_edge_lengths(3, [[0, 1, 2]], [[1, 1], [1]]), "L "),
                          (lambda: s.isolines(EXPECTED * np.nan, 1), "d"), (lambda: s.remesh(26), "n is 26"),
                          (lambda: smg.page(V, F, EXPECTED * np.nan), "distances"),
                          (lambda: smg.plot(V, []), "no faces")):
        with pytest.raises(ValueError, match=message):
            call()


def test_no_sources():
    d, nearest = smg.Solver(V, F).distances([], return_nearest=True)
    assert np.isinf(d).all() and (nearest == -1).all()


def test_empty_meshes():
    empty = smg.Solver(np.zeros((0, 3)), np.zeros((0, 3), int))
    assert empty.distances([]).shape == (0,) and empty.matrix().shape == (0, 0)
    points = smg.Solver(V[:3], [])
    assert points.distances(1).tolist() == [np.inf, 0, np.inf]


def test_random_arguments_raise_only_documented_errors():
    random = np.random.default_rng(5)
    s = smg.Solver(*sphere(8))
    n, m = s.n_vertices, s.n_faces
    values = [0, 3, -1, n, [0, 5], [], (3, [0.2, 0.3, 0.5]), (m, [1, 0, 0]), [(0, [1, 0, 0]), 4], np.arange(4), 2.0,
              [np.nan], "x", {"a": 1}, [[1, 2], [3]], np.zeros((2, 2)), (1, 2), (1, [2, 3]), range(3), np.int8(4)]
    numbers = [None, 1, 0.3, -1, np.nan, np.inf, [0.1], [0.1, 0.2], "y"]
    calls = [lambda a, b, c: s.distances(a, offsets=c, targets=b if random.random() < 0.3 else None),
             lambda a, b, c: s.paths(a, b, threads=1), lambda a, b, c: s.path(a, b),
             lambda a, b, c: s.matrix(a, b), lambda a, b, c: s.voronoi(a, c),
             lambda a, b, c: s.exact_isolines(a, c), lambda a, b, c: s.sparse_matrix(c, a, b)]
    outcomes = {"done": 0, "rejected": 0}
    for _ in range(600):
        call = calls[random.integers(len(calls))]
        try:
            call(values[random.integers(len(values))], values[random.integers(len(values))],
                 numbers[random.integers(len(numbers))])
            outcomes["done"] += 1
        except (ValueError, IndexError):
            outcomes["rejected"] += 1
    assert min(outcomes.values()) > 50


def test_repr_version_and_pickle():
    s = smg.Solver(V, F)
    assert repr(s) == "Solver(25 vertices, 32 faces)"
    assert smg.__version__.count(".") == 2
    assert "source=0" in repr(s.path(0, 3)) and "2 sites" in repr(s.voronoi([0, 5]))
    L = np.ones((1, 3))
    t = pickle.loads(pickle.dumps(smg.Solver.from_edge_lengths(3, [[0, 1, 2]], L)))
    assert np.allclose(t.distances(0), [0, 1, 1])


class Named_solver(smg.Solver):
    """A class of a user, with another constructor and an attribute of its own."""

    def __init__(self, name, mesh):
        super().__init__(*mesh)
        self.name = name
        self.values = {"a": np.arange(3)}


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_classes_that_derive_from_solvers_are_pickled(protocol):
    s = Named_solver("square", (V, F))
    t = pickle.loads(pickle.dumps(s, protocol))
    assert type(t) is Named_solver and t.name == "square" and t.values["a"].tolist() == [0, 1, 2]
    assert np.array_equal(t.distances(3), EXPECTED) and repr(t) == repr(s)
    for copied in (copy.copy(s), copy.deepcopy(s)):
        assert copied.name == "square" and np.array_equal(copied.distances(3), EXPECTED)
    flat = pickle.loads(pickle.dumps(Named_solver.from_edge_lengths(3, [[0, 1, 2]], np.ones((1, 3))), protocol))
    assert type(flat) is Named_solver and np.allclose(flat.distances(0), [0, 1, 1])
