"""Directions at sources, traced geodesics, faces to avoid."""

import pickle

import numpy as np
import pytest

import surface_mesh_geodesics as smg
from meshes import grid, sphere, two_components

V, F = grid(9, 0.1)
FLAT, FLAT_FACES = grid(8)
MIDDLE = 4 * 9 + 4


def without(V, F, avoided):
    return smg.Solver(V, np.delete(F, avoided, axis=0))


def wall():
    """The faces of the rough grid with their center in a bar that leaves a gap at one end."""
    center = V[F].mean(axis=1)
    return np.flatnonzero((abs(center[:, 0] - 0.5) < 0.12) & (center[:, 1] > 0.2))


# --- directions ---


def test_logarithm_of_a_flat_surface_is_the_surface():
    s = smg.Solver(FLAT, FLAT_FACES)
    d, angle = s.directions(MIDDLE)
    turn = s.direction_of(MIDDLE, [1, 0, 0])
    found = np.stack([d * np.cos(angle - turn), d * np.sin(angle - turn)], axis=1)
    assert np.abs(found - (FLAT - FLAT[MIDDLE])[:, :2]).max() < 1e-12
    assert np.array_equal(d, s.distances(MIDDLE)) and d[MIDDLE] == 0 and angle[MIDDLE] == 0


@pytest.mark.parametrize("source", [0, 37, (11, [0.2, 0.3, 0.5]), (30, [0.5, 0.5, 0])])
def test_tracing_leads_back_to_the_vertices(source):
    s = smg.Solver(*sphere(16))
    points = sphere(16)[0]
    d, angle = s.directions(source)
    for v in range(0, s.n_vertices, 5):
        if len(s.path(source, v)) > 1:
            end = s.trace(source, angle[v], d[v])
            assert np.linalg.norm(end.points[-1] - points[v]) < 1e-9
            assert end.end == "length" and abs(end.length - d[v]) < 1e-12


def test_directions_of_several_sources():
    s = smg.Solver(*two_components())
    d, angle, nearest = s.directions([0, 3], return_nearest=True)
    expected, sources = s.distances([0, 3], return_nearest=True)
    assert np.array_equal(d, expected) and np.array_equal(nearest, sources)
    assert np.array_equal(np.isnan(angle), np.isinf(d)) and np.array_equal(nearest == -1, np.isinf(d))
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip((d, angle), s.directions([0, 3], threads=2)))


def test_directions_can_be_interrupted():
    def stop(part):
        raise KeyError("enough")

    with pytest.raises(KeyError):
        smg.Solver(*grid(400)).directions(0, progress=stop)


# --- traced geodesics ---


def test_a_traced_geodesic_is_as_long_as_its_segments():
    s = smg.Solver(*sphere(20))
    for direction in np.linspace(0, 7, 12):
        t = s.trace((50, [0.1, 0.2, 0.7]), direction, 9)
        assert t.end == "length" and len(t) == len(t.faces) == len(t.barycentric)
        assert abs(np.linalg.norm(np.diff(t.points, axis=0), axis=1).sum() - 9) < 1e-12
        corners = sphere(20)[0][sphere(20)[1][t.faces]]
        assert np.abs((corners * t.barycentric[:, :, None]).sum(axis=1) - t.points).max() < 1e-12


def test_a_traced_geodesic_goes_on_where_it_ended():
    s = smg.Solver(V, F)
    whole, half = s.trace((70, [0.3, 0.3, 0.4]), 1.0, 0.3), s.trace((70, [0.3, 0.3, 0.4]), 1.0, 0.15)
    rest = s.trace((half.faces[-1], half.barycentric[-1]), half.direction, 0.15)
    assert np.linalg.norm(rest.points[-1] - whole.points[-1]) < 1e-12


def test_ends_of_traced_geodesics():
    s = smg.Solver(FLAT, FLAT_FACES)
    to_the_border = s.trace(MIDDLE, s.direction_of(MIDDLE, [0.3, 1, 0]), 9)
    assert to_the_border.end == "border" and abs(to_the_border.points[-1][1] - 1) < 1e-12
    nowhere = s.trace(MIDDLE, 1, 0)
    assert nowhere.length == 0 and nowhere.points.tolist() == [FLAT[MIDDLE].tolist()]


def test_tracing_needs_no_points():
    lengths = np.linalg.norm(V[np.roll(F, -1, axis=1)] - V[F], axis=2)
    t = smg.Solver.from_edge_lengths(len(V), F, lengths).trace((70, [0.3, 0.3, 0.4]), 1.0, 0.3)
    expected = smg.Solver(V, F).trace((70, [0.3, 0.3, 0.4]), 1.0, 0.3)
    assert np.array_equal(t.faces, expected.faces) and not t.points.any()
    assert np.abs(t.barycentric - expected.barycentric).max() < 1e-9


@pytest.mark.parametrize("arguments, message", [
    (([0, 1], 0, 1), "place has 2 places"), ((0, np.nan, 1), "direction is nan"), ((0, [1, 2], 1), "direction is"),
    ((0, 0, -1), "length is -1"), ((0, 0, np.inf), "length is inf"), (((0, [1, 1, 0]), 0, 1), "are not in the face"),
])
def test_bad_arguments_of_trace(arguments, message):
    with pytest.raises(ValueError, match=message):
        smg.Solver(V, F).trace(*arguments)


def test_bad_places_and_vectors():
    s = smg.Solver(*two_components())
    for call in (lambda: s.trace(s.n_vertices - 1, 0, 1), lambda: s.direction_of(s.n_vertices - 1, [1, 0, 0]),
                 lambda: s.direction_of(0, [0, 0, 0]), lambda: s.direction_of(0, [1, 0]),
                 lambda: s.direction_of(0, [1, np.nan, 0]), lambda: s.direction_of([0, 1], [1, 0, 0])):
        with pytest.raises(ValueError):
            call()
    with pytest.raises(IndexError):
        s.trace(s.n_vertices, 0, 1)


# --- faces to avoid ---


def test_avoided_faces_are_as_removed_ones():
    avoided = wall()
    s, expected = smg.Solver(V, F).avoiding(avoided), without(V, F, avoided)
    ends = [v for v in (0, 5, 50, 99) if v in np.delete(F, avoided, axis=0)]
    assert np.array_equal(s.distances(ends[0]), expected.distances(ends[0]))
    assert (s.distances(9) > smg.Solver(V, F).distances(9) + 0.1).any()
    assert np.array_equal(s.distances(ends, threads=2), expected.distances(ends, threads=2))
    assert np.array_equal(s.matrix(ends), expected.matrix(ends))
    assert (s.sparse_matrix(0.7, ends) != expected.sparse_matrix(0.7, ends)).nnz == 0
    assert s.path(ends[0], ends[-1]).points.tolist() == expected.path(ends[0], ends[-1]).points.tolist()
    assert np.array_equal(s.labels(ends)[0], expected.labels(ends)[0])
    for threads in (1, 2):
        assert np.allclose(s.voronoi(ends, threads=threads).areas, expected.voronoi(ends).areas, rtol=1e-12)
    lines, expected_lines = s.exact_isolines(ends[0], 0.4)[0], expected.exact_isolines(ends[0], 0.4)[0]
    assert len(lines) == len(expected_lines)
    d, angle = s.directions(ends[0])
    assert np.array_equal(d, s.distances(ends[0])) and np.array_equal(np.isnan(angle), np.isinf(d))


def test_forms_of_faces_to_avoid():
    avoided = wall()
    s = smg.Solver(V, F)
    is_avoided = np.zeros(len(F), bool)
    is_avoided[avoided] = True
    expected = s.avoiding(avoided).distances(3)
    assert np.array_equal(s.avoiding(is_avoided).distances(3), expected)
    assert np.array_equal(s.avoiding(avoided.tolist() * 2).distances(3), expected)
    assert np.array_equal(s.avoiding([]).distances(3), s.distances(3))
    assert np.array_equal(s.avoiding(avoided).avoiding([]).distances(3), s.distances(3))
    assert np.array_equal(pickle.loads(pickle.dumps(s.avoiding(avoided))).distances(3), expected)


def test_solvers_of_derived_classes_stay_so():
    class Named(smg.Solver):
        name = ""

    s = Named(V, F)
    s.name = "hill"
    around = s.avoiding([3])
    assert type(around) is Named and around.name == "hill"


def test_samples_and_sites_around_faces():
    around, rest = smg.Solver(V, F).avoiding(range(70)), smg.Solver(V, F[70:])
    corners = np.unique(F[70:])[[0, -1]]
    assert around.sample(5, first=corners[:1]).tolist() == rest.sample(5, first=corners[:1]).tolist()
    assert around.relax(corners, iterations=3).tolist() == rest.relax(corners, iterations=3).tolist()
    with pytest.raises(ValueError, match="inside of the faces to avoid"):
        smg.Solver(V, F).avoiding((F == 33).any(axis=1)).relax([33])


def test_applications_around_faces(tmp_path):
    around, rest = smg.Solver(V, F).avoiding(range(70)), smg.Solver(V, F[70:])
    corners = np.unique(F[70:])
    d = around.distances(int(corners[0]))
    assert around.certify(d, int(corners[0])).is_certified()
    assert not around.certify(smg.Solver(V, F).distances(int(corners[0])), int(corners[0])).is_certified()
    assert around.peeling_order(corners).tolist() == rest.peeling_order(corners).tolist()
    assert around.store_matrix(tmp_path, corners[:5], corners) == (5, 5)
    stored = np.concatenate([np.load(f) for f in sorted(tmp_path.glob("rows_*.npy"))])
    assert np.array_equal(stored, rest.matrix(corners[:5], corners))
    with pytest.raises(ValueError, match="of this call have the hash"):
        smg.Solver(V, F).store_matrix(tmp_path, corners[:5], corners)
    points, faces = smg.Solver(V, F).avoiding(wall()).remesh(20)
    expected, _ = without(V, F, wall()).remesh(20)
    assert sorted(points.tolist()) == sorted(expected.tolist()) and faces.max() < len(points)


def test_traces_end_at_faces_to_avoid():
    square = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
    start = (0, [0.25, 0.5, 0.25])  # at (1.5, 0.5)
    whole, half = (s.trace(start, s.direction_of(start, [-1, 0, 0]), 9) for s in (square, square.avoiding([1])))
    assert whole.end == half.end == "border"
    assert whole.length == pytest.approx(1.5) and half.length == pytest.approx(1)
    with pytest.raises(ValueError):
        square.avoiding([0]).trace(start, 0, 1)


def test_bad_faces_to_avoid():
    s = smg.Solver(V, F)
    with pytest.raises(IndexError, match=r"faces\[1\] is 9999"):
        s.avoiding([0, 9999])
    with pytest.raises(ValueError, match="there are 162 faces"):
        s.avoiding(np.zeros(3, bool))
    with pytest.raises(ValueError, match="one row of faces"):
        s.avoiding([[0, 1]])
    with pytest.raises(ValueError, match="source 0 is inside of the faces to avoid"):
        s.avoiding(range(len(F))).distances(3)
    with pytest.raises(ValueError, match="source"):
        center = (V[F].mean(axis=1) - [0.5, 0.5, 0]) ** 2
        inside = int(center[:, :2].sum(axis=1).argmin())
        s.avoiding([inside]).distances((inside, [0.3, 0.3, 0.4]))
