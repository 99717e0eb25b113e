import threading

import numpy as np
import pytest

import surface_mesh_geodesics as smg
from meshes import grid, sphere, two_components


def flat_distances(V, source):
    return np.linalg.norm(V - V[source], axis=1)


def test_plane_has_straight_distances():
    V, F = grid(15)
    d = smg.Solver(V, F).distances(17)
    assert np.allclose(d, flat_distances(V, 17), rtol=1e-13, atol=1e-15)
    assert d.dtype == np.float64 and d.flags.writeable


def test_sources_in_all_forms_agree():
    V, F = grid(6, 0.3)
    s = smg.Solver(V, F)
    expected = s.distances(8)
    for same in ([8], np.array([8]), (8,), np.int32(8), np.array(8), np.array([8.0]), range(8, 9), [8, 8]):
        assert np.array_equal(s.distances(same), expected)


def test_points_of_faces():
    V, F = grid(6)
    s = smg.Solver(V, F)
    b = [0.2, 0.3, 0.5]
    p = np.array(b) @ V[F[20]]
    expected = np.linalg.norm(V - p, axis=1)
    for same in ((20, b), [(20, b)], ([20], [b]), (np.array([20]), np.array([b]))):
        assert np.allclose(s.distances(same), expected, rtol=1e-13)
    both, nearest = s.distances([3, (20, b)], return_nearest=True)
    assert np.allclose(both, np.minimum(expected, flat_distances(V, 3)), rtol=1e-13)
    assert set(nearest) == {0, 1} and nearest[3] == 0


def test_offsets_radius_targets_and_nearest():
    V, F = grid(10)
    s = smg.Solver(V, F)
    a, b = s.distances(0), s.distances(120)
    d, nearest = s.distances([0, 120], offsets=[0.5, 0.0], return_nearest=True)
    assert np.allclose(d, np.minimum(a + 0.5, b), rtol=1e-13)
    assert np.array_equal(nearest, np.where(a + 0.5 < b, 0, 1))
    near = s.distances(0, radius=0.45)
    assert np.array_equal(np.isinf(near), a > 0.45) and np.allclose(near[a <= 0.45], a[a <= 0.45], rtol=1e-13)
    assert np.allclose(s.distances(0, targets=[5, 3, 5]), a[[5, 3, 5]], rtol=1e-13)
    assert s.distances(0, targets=[]).shape == (0,)


def test_unreachable_vertices():
    V, F = two_components()
    s = smg.Solver(V, F)
    d, nearest = s.distances(0, return_nearest=True)
    assert np.isinf(d[16:]).all() and np.isfinite(d[:16]).all()
    assert (nearest[16:] == -1).all() and (nearest[:16] == 0).all()
    assert s.distances(32)[32] == 0 and np.isinf(s.distances(32)[:32]).all()


def test_edge_lengths_are_enough():
    V, F = sphere(12)
    L = np.linalg.norm(V[np.roll(F, -1, axis=1)] - V[F], axis=2)
    s, t = smg.Solver(V, F), smg.Solver.from_edge_lengths(len(V), F, L)
    assert np.allclose(s.distances(5), t.distances(5), rtol=1e-12)
    path, flat = s.path(5, 60), t.path(5, 60)
    assert abs(path.length - flat.length) < 1e-12 and len(path) == len(flat)
    corners = np.einsum("kj,kjd->kd", flat.barycentric, V[F[flat.faces]])
    assert np.allclose(corners, path.points, atol=1e-9)
    for call in (lambda: t.isolines(t.distances(0), 1.0), lambda: t.exact_isolines(0, 1.0),
                 lambda: t.voronoi([0]).cut(), lambda: t.voronoi([0]).centroids, lambda: t.voronoi([0]).boundaries(0)):
        with pytest.raises(ValueError, match="needs points"):
            call()
    long = L.copy()
    long[3, 1] *= 1.01
    with pytest.raises(ValueError, match="same edge"):
        smg.Solver.from_edge_lengths(len(V), F, long)
    with pytest.raises(ValueError, match=r"L\[3, 1\]"):
        L[3, 1] *= -1
        smg.Solver.from_edge_lengths(len(V), F, L)


def test_threads_do_not_change_certificates():
    V, F = sphere(20)
    s = smg.Solver(V, F)
    d = s.distances(7)
    for values in (d, d * (1 + 1e-7)):
        one, two, three, every = (s.certify(values, 7, threads=k) for k in (1, 2, 3, None))
        assert one.worst_violation == two.worst_violation == three.worst_violation == every.worst_violation
        assert one.conditions == two.conditions == three.conditions == every.conditions


def test_threads_do_not_change_bits():
    V, F = sphere(40)
    s = smg.Solver(V, F)
    one, two, three = s.distances(7), s.distances(7, threads=2), s.distances(7, threads=3)
    assert np.array_equal(two, three)
    assert np.allclose(one, two, rtol=1e-13)
    assert np.array_equal(s.distances(7, threads=None).shape, one.shape)


def test_threads_do_not_change_paths_and_diagrams():
    V, F = sphere(40)
    by_threads = [smg.Solver(V, F) for _ in range(3)]
    one, two, three = (s.path(7, 500, threads=k + 1) for k, s in enumerate(by_threads))
    assert np.array_equal(two.points, three.points) and np.array_equal(one.points, two.points)
    assert one.length == two.length == three.length
    one, two, three = (s.voronoi([3, 300, 900], threads=k + 1) for k, s in enumerate(by_threads))
    assert np.array_equal(two.areas, three.areas) and np.array_equal(one.areas, two.areas)
    assert np.array_equal(two.labels, three.labels) and np.array_equal(one.labels, two.labels)
    one, two, three = (s.exact_isolines(7, 1, threads=k + 1)[0] for k, s in enumerate(by_threads))
    assert all(np.array_equal(a, b) and np.array_equal(b, c) for a, b, c in zip(one, two, three))


def test_matrices():
    V, F = grid(7, 0.2)
    s = smg.Solver(V, F)
    D = s.matrix()
    assert D.shape == (64, 64) and np.allclose(D, D.T, rtol=1e-12) and (np.diag(D) == 0).all()
    assert np.array_equal(s.matrix([3, 9], [1, 2, 3], threads=1), D[np.ix_([3, 9], [1, 2, 3])])
    assert np.allclose(D[9], s.distances(9), rtol=1e-13)
    scipy = pytest.importorskip("scipy.sparse")
    S = s.sparse_matrix(0.4, threads=2)
    assert isinstance(S, scipy.csr_matrix) and S.shape == (64, 64)
    near = D <= 0.4
    assert S.nnz == near.sum()
    assert np.allclose(S.toarray(), np.where(near, D, 0), rtol=1e-12)


def test_certificate_accepts_and_refutes():
    V, F = sphere(16)
    s = smg.Solver(V, F)
    d = s.distances([0, 40])
    assert s.certify(d, [0, 40]).is_certified()
    d[100] *= 1 + 1e-6
    certificate = s.certify(d, [0, 40])
    assert not certificate.is_certified()
    assert any(c.vertex == 100 for c in certificate.conditions.values())


def test_several_python_threads_use_one_solver():
    V, F = sphere(20)
    s = smg.Solver(V, F)
    expected = {i: smg.Solver(V, F).distances(i) for i in range(8)}
    found = {}

    def work(i):
        for _ in range(5):
            found[i] = s.distances(i)
            s.path(i, 100)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(8)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert all(np.array_equal(found[i], expected[i]) for i in range(8))
