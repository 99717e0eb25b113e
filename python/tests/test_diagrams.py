import numpy as np
import pytest

import surface_mesh_geodesics as smg
from meshes import grid, sphere


def area(V, F):
    return 0.5 * np.linalg.norm(np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1)


def test_two_sites_divide_a_square():
    V, F = grid(10)
    v = smg.Solver(V, F).voronoi([0, 10])
    assert np.allclose(v.areas, 0.5, rtol=1e-12)
    assert v.adjacency.tolist() == [[0, 1]]
    (line,) = v.boundaries(0)
    assert np.allclose(line[:, 1], 0.5, atol=1e-12)
    assert np.allclose(v.centroids[:, 1], [0.25, 0.75], atol=1e-12)


def test_labels_areas_and_cut_agree():
    V, F = sphere(24)
    s = smg.Solver(V, F)
    sites = s.sample(12)
    v = s.voronoi(sites)
    d, nearest = s.distances(sites, return_nearest=True)
    assert np.allclose(v.distances, d, rtol=1e-12)
    assert (v.labels == nearest).mean() > 0.99 and np.array_equal(v.labels[sites], np.arange(12))
    assert v.areas.sum() == pytest.approx(area(V, F).sum(), rel=1e-12)
    V2, F2, cell = v.cut(1e-5)
    parts = np.bincount(cell, area(V2, F2), minlength=12)
    assert np.allclose(parts, v.areas, rtol=1e-4)
    for i in range(12):
        for line in v.boundaries(i):
            assert np.array_equal(line[0], line[-1])
            steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
            assert 0 < steps.max() < 0.5  # no jump from one edge to the next
    assert set(v.triangles.ravel()) == set(range(12))
    with pytest.raises(IndexError, match="site is 12"):
        v.boundaries(12)
    with pytest.raises(ValueError, match="tolerance"):
        v.cut(0)


def test_weights_and_points_of_faces():
    V, F = grid(10)
    s = smg.Solver(V, F)
    v = s.voronoi([0, 120], weights=[0, -5])
    assert (v.labels == 0).all() and v.areas[1] == 0
    located = s.voronoi([(0, [1 / 3, 1 / 3, 1 / 3]), (199, [0.2, 0.2, 0.6])])
    assert located.areas.sum() == pytest.approx(1, rel=1e-12)


def test_diagram_outlives_its_solver():
    V, F = sphere(12)
    v = smg.Solver(V, F).voronoi([0, 50])
    assert v.areas.sum() == pytest.approx(area(V, F).sum(), rel=1e-12)


def test_samples_and_remeshing():
    V, F = sphere(24)
    s = smg.Solver(V, F)
    samples = s.sample(20)
    assert len(set(samples.tolist())) == 20
    assert s.sample(5, first=[7]).tolist()[0] == 7 and len(s.sample(5, first=[7])) == 5
    assert len(s.sample(10**6, covering_radius=0.5)) < 200
    V2, F2 = s.remesh(80)
    assert V2.shape == (80, 3) and F2.shape[1] == 3
    edges = {tuple(sorted(e)) for f in F2.tolist() for e in zip(f, f[1:] + f[:1])}
    assert len(V2) - len(edges) + len(F2) == 2
    t = smg.Solver.from_edge_lengths(3, [[0, 1, 2]], [[1, 1, 1]])
    for name in ("sample", "remesh"):
        with pytest.raises(ValueError, match="needs points"):
            getattr(t, name)(3)
