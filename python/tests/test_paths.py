import numpy as np
import pytest

import surface_mesh_geodesics as smg
from meshes import grid, sphere, two_components


def check_path(path, V, F, start, end):
    pieces = np.linalg.norm(np.diff(path.points, axis=0), axis=1)
    assert pieces.sum() == pytest.approx(path.length, rel=1e-12)
    assert np.allclose(path.points[0], start, atol=1e-13) and np.allclose(path.points[-1], end, atol=1e-13)
    from_coordinates = np.einsum("kj,kjd->kd", path.barycentric, V[F[path.faces]])
    assert np.allclose(from_coordinates, path.points, atol=1e-13)


def test_paths_on_a_sphere():
    V, F = sphere(20)
    s = smg.Solver(V, F)
    d = s.distances(50)
    for target in (0, 1, 77, 200, len(V) - 1):
        path = s.path(50, target)
        assert path.length == pytest.approx(d[target], rel=1e-12) and path.source == 0
        check_path(path, V, F, V[50], V[target])


def test_many_targets_and_sources():
    V, F = grid(9, 0.4)
    s = smg.Solver(V, F)
    d, nearest = s.distances([0, 99], return_nearest=True)
    paths = s.paths([0, 99], np.arange(len(V)))
    assert np.allclose([p.length for p in paths], d, rtol=1e-12)
    for v, path in enumerate(paths):
        check_path(path, V, F, V[[0, 99][path.source]], V[v])
    alone = s.paths([0, 99], np.arange(len(V)), threads=1)
    assert all(np.array_equal(p.points, q.points) for p, q in zip(paths, alone))


def test_points_of_faces_are_ends():
    V, F = grid(5)
    s = smg.Solver(V, F)
    a, b = (3, [0.6, 0.3, 0.1]), (40, [0.1, 0.1, 0.8])
    p, q = np.array(a[1]) @ V[F[3]], np.array(b[1]) @ V[F[40]]
    path = s.path(a, b)
    assert path.length == pytest.approx(np.linalg.norm(q - p), rel=1e-13)
    check_path(path, V, F, p, q)
    corner = s.distances(b)
    for v in range(len(V)):
        mixed = s.path([v, a], b)
        assert mixed.source == (0 if corner[v] < path.length else 1)


def test_no_path():
    V, F = two_components()
    s = smg.Solver(V, F)
    path = s.path(0, 20)
    assert path.length == np.inf and path.source == -1 and path.points.shape == (0, 3) and len(path) == 0
    assert s.path(32, 32).length == 0 and s.path(32, 32).faces.tolist() == [-1]
    with pytest.raises(ValueError, match="vertex 32 has no face"):
        s.paths([0, 32, (0, [1, 0, 0])], [1])


def test_isolines():
    V, F = grid(20)
    s = smg.Solver(V, F)
    d = s.distances(0)
    (line,) = s.isolines(d, 0.5)
    assert np.allclose(np.linalg.norm(line, axis=1), 0.5, atol=2e-3)
    ((exact,),) = s.exact_isolines(0, [0.5])
    on_edges = np.linalg.norm(exact, axis=1)
    assert np.allclose(on_edges, 0.5, rtol=1e-11)
    assert s.isolines(d, 99.0) == [] and s.exact_isolines(0, 99.0) == [[]]


def test_closed_isoline_ends_with_its_first_point():
    V, F = sphere(16)
    s = smg.Solver(V, F)
    (line,) = s.isolines(s.distances(0), 1.0)
    assert np.array_equal(line[0], line[-1]) and len(line) > 16


def test_isoline_of_two_segments_is_closed():
    pillow = smg.Solver([[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 1]])
    (line,) = pillow.isolines(pillow.distances(0), 1.0)
    assert np.array_equal(line[0], line[-1]) and len(line) == 3
