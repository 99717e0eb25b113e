"""Curves as sources of distances."""

import pickle

import numpy as np
import pytest

import surface_mesh_geodesics as smg
from meshes import grid, sphere, two_components


def diagonal(n):
    """The diagonal of a grid, as vertices."""
    return np.arange(n + 1) * (n + 2)


def test_distances_from_the_border_of_a_square():
    V, F = grid(11)
    s = smg.Solver(V, F)
    (border,) = s.border_curves()
    expected = np.minimum(V[:, :2], 1 - V[:, :2]).min(axis=1)
    assert np.allclose(s.distances(border), expected, atol=1e-13)
    assert np.allclose(s.distances([border]), expected, atol=1e-13)
    assert np.allclose(s.distances((border, 0)), expected, atol=1e-13)
    assert border.closed and len(border.places[0]) == 44


def test_a_curve_through_faces_along_edges_and_a_point():
    V, F = grid(10)
    s = smg.Solver(V, F)
    expected = np.abs(V[:, 0] - V[:, 1]) / np.sqrt(2)
    assert np.allclose(s.distances(smg.Curve(diagonal(10))), expected, atol=1e-13)
    # From the middle of one edge to that of another: the point (0.05, 0) to (0.1, 0.05), within face 0.
    a, b = [0.5, 0.5, 0], [0, 0.5, 0.5]
    assert F[0].tolist() == [0, 11, 12]
    d = s.distances(smg.Curve([(0, a), (0, b)]))
    p, q = np.array([0.05, 0]), np.array([0.1, 0.05])
    t = np.clip((V[:, :2] - p) @ (q - p) / ((q - p) @ (q - p)), 0, 1)
    assert np.allclose(d, np.linalg.norm(V[:, :2] - p - t[:, None] * (q - p), axis=1), atol=1e-13)
    assert np.array_equal(d, s.distances(smg.Curve(([0, 0], [a, b]))))
    assert np.allclose(s.distances(smg.Curve(7)), s.distances(7), atol=1e-14)


def test_curves_mixed_with_points_offsets_targets_and_a_radius():
    V, F = grid(10, 0.2, 3)
    s = smg.Solver(V, F)
    curve = smg.Curve(diagonal(10))
    parts = [s.distances(curve) + 0.3, s.distances(10), s.distances((5, [0.2, 0.3, 0.5])) + 0.1]
    sources, offsets = [curve, 10, (5, [0.2, 0.3, 0.5])], [0.3, 0, 0.1]
    d, nearest = s.distances(sources, offsets=offsets, return_nearest=True)
    assert np.allclose(d, np.min(parts, axis=0), rtol=1e-12)
    assert np.allclose(d, np.array(parts)[nearest, np.arange(len(V))], rtol=1e-12) and set(nearest) == {0, 1, 2}
    assert np.array_equal(s.distances(sources, offsets=offsets, targets=[7, 3]), d[[7, 3]])
    assert s.distances(sources, offsets=offsets, targets=[]).shape == (0,)
    near = s.distances(curve, radius=0.2)
    assert np.array_equal(np.isinf(near), s.distances(curve) > 0.2)
    assert np.array_equal(s.distances(curve, threads=2), s.distances(curve))


def test_feet_are_where_shortest_paths_begin():
    V, F = sphere(16)
    s = smg.Solver(V, F)
    curve = smg.Curve([1 + 7 * 16 + k for k in range(16)], closed=True)  # around the equator
    d, (face, weights) = s.distances([curve, 0], offsets=[0, 0.5], return_foot=True)
    assert face.shape == (len(V),) and weights.shape == (len(V), 3)
    for v in range(0, len(V), 9):
        path = s.path((face[v], weights[v]), v)
        offset = 0.5 if np.allclose(path.points[0], V[0], atol=1e-9) else 0
        assert path.length + offset == pytest.approx(d[v], abs=1e-12)
    d, nearest, feet = s.distances(np.array([3, 9]), return_nearest=True, return_foot=True)
    assert np.allclose(d, s.distances([3, 9]), rtol=1e-13) and set(nearest) == {0, 1}
    points = (V[F[feet[0]]] * feet[1][:, :, None]).sum(axis=1)
    assert np.allclose(points, V[np.array([3, 9])[nearest]], atol=1e-14)


def test_no_foot_where_no_curve_reaches():
    V, F = two_components()
    s = smg.Solver(V, F)
    d, nearest, (face, weights) = s.distances(smg.Curve([0, 1]), return_nearest=True, return_foot=True)
    assert np.array_equal(np.isinf(d), face < 0) and np.array_equal(np.isinf(d), nearest < 0)
    assert np.isinf(d[16:]).all() and np.isfinite(d[:16]).all() and not weights[16:].any()


def test_signed_distances():
    V, F = grid(10)
    s = smg.Solver(V, F)
    d = s.signed_distances(smg.Curve(diagonal(10)))
    assert np.allclose(d, (V[:, 0] - V[:, 1]) / np.sqrt(2), atol=1e-13)
    assert np.array_equal(s.signed_distances([smg.Curve(diagonal(10)[::-1])]), -d)
    assert np.array_equal(np.isinf(s.signed_distances(smg.Curve(diagonal(10)), radius=0.3)), np.abs(d) > 0.3)
    assert s.signed_distances(smg.Curve([12, 13, 24, 23], closed=True))[12] == 0
    with pytest.raises(ValueError, match="separate"):
        s.signed_distances(smg.Curve([60, 61]))
    with pytest.raises(ValueError, match="needs points"):
        smg.Solver.from_edge_lengths(3, [[0, 1, 2]], [[3, 5, 4]]).signed_distances(smg.Curve([0, 1]))


def test_shortest_paths_make_curves():
    V, F = sphere(16)
    s = smg.Solver(V, F)
    places = [0, 100, (200, [0.2, 0.3, 0.5])]
    curve = s.shortest_path_curve(places, closed=True)
    on_curve = s.distances(curve)
    assert on_curve[0] < 1e-12 and on_curve[100] < 1e-12
    assert (on_curve <= s.distances(places) + 1e-12).all()
    paths = [s.path(a, b) for a, b in ((0, 100), (100, places[2]), (places[2], 0))]
    assert np.allclose(on_curve, np.min([s.distances(smg.Curve((p.faces, p.barycentric))) for p in paths], axis=0),
                       atol=1e-12)
    assert np.isfinite(s.signed_distances(curve)).all()
    assert np.array_equal(s.distances(s.shortest_path_curve(5)), s.distances(smg.Curve(5)))
    V, F = two_components()
    with pytest.raises(ValueError, match=r"places\[1\] and the next place are not connected"):
        smg.Solver(V, F).shortest_path_curve([0, 1, 20])


def test_curves_of_no_place_and_of_one():
    s = smg.Solver(np.eye(3), np.zeros((0, 3), int))
    assert s.distances(s.shortest_path_curve([1])).tolist() == [np.inf, 0, np.inf]
    for call in (lambda: s.shortest_path_curve([]), lambda: s.distances(smg.Curve([])),
                 lambda: s.distances([0, smg.Curve(([], np.zeros((0, 3))))])):
        with pytest.raises(ValueError, match="places"):
            call()


def test_curves_on_surfaces_without_points_and_around_faces():
    V, F = grid(6)
    plain = smg.Solver(V, F)
    lengths = np.linalg.norm(V[np.roll(F, -1, axis=1)] - V[F], axis=2)
    by_lengths = smg.Solver.from_edge_lengths(len(V), F, lengths)
    curve = smg.Curve(np.arange(7))
    assert np.allclose(by_lengths.distances(curve), plain.distances(curve), atol=1e-13)
    wall = [f for f in range(len(F)) if 3 <= V[F[f]][:, 0].mean() * 6 < 4 and V[F[f]][:, 1].mean() < 0.9]
    around = plain.avoiding(wall).distances(curve)
    assert (around >= plain.distances(curve) - 1e-13).all() and around[-7] > plain.distances(curve)[-7] + 0.1
    assert len(pickle.loads(pickle.dumps(plain)).border_curves()) == 1
    # The borders of the faces that are left: the wall ends at the border.
    left = [f for f in range(len(F)) if f not in wall]
    rest, beside = smg.Solver(V, F[left]), plain.avoiding(wall)
    expected = rest.distances(rest.border_curves())
    assert (beside.distances(beside.border_curves()) == expected).all() and np.isfinite(expected).all()
    assert (expected != plain.distances(plain.border_curves())).any()


@pytest.mark.parametrize("places, error, message", [
    ([0, 40], ValueError, "curve"), ([], ValueError, "curve"),
    ([0, 99], IndexError, r"places of sources\[1\]\[1\] is 99"),
    ([0, 1.5], ValueError, "not an integer"), ((0, [1, 1, 1]), ValueError, "coordinates"), (None, ValueError, "type"),
    (smg.Curve([0, 1]), ValueError, "type"),
])
def test_bad_curves(places, error, message):
    V, F = grid(6)
    with pytest.raises(error, match=message):
        smg.Solver(V, F).distances([0, smg.Curve(places)])


def test_calls_that_take_no_curves_say_so():
    V, F = grid(6)
    s = smg.Solver(V, F)
    curve = smg.Curve([0, 1])
    for call in (s.matrix, s.directions, s.voronoi, s.labels, s.paths, s.sparse_matrix):
        with pytest.raises((ValueError, TypeError)):
            call(*([0.5, curve] if call == s.sparse_matrix else [curve, 3] if call == s.paths else [curve]))
    with pytest.raises(ValueError, match="offsets"):
        s.distances([curve, 3], offsets=[1])
