import copy
import pickle

import numpy as np
import pytest

import surface_mesh_geodesics as smg
from meshes import grid, sphere, two_components


def area(V, F):
    return 0.5 * np.linalg.norm(np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1)


def test_threads_do_not_change_relaxation_and_remeshing():
    V, F = sphere(20)
    s = smg.Solver(V, F)
    sites = np.arange(0, len(V), 60)
    one, two, three = (s.relax(sites, iterations=2, threads=k) for k in (1, 2, 3))
    assert np.array_equal(two, three) and np.array_equal(one, two)
    (V1, F1), (V2, F2), (V3, F3) = (s.remesh(50, iterations=1, threads=k) for k in (1, 2, 3))
    assert np.array_equal(V2, V3) and np.array_equal(F2, F3) and np.array_equal(V1, V2) and np.array_equal(F1, F2)
    assert len(V1) - len(F1) / 2 == 2


def test_two_sites_divide_a_square():
    V, F = grid(10)
    v = smg.Solver(V, F).voronoi([0, 10])
    assert np.allclose(v.areas, 0.5, rtol=1e-12)
    assert v.adjacency.tolist() == [[0, 1]]
    (line,) = v.boundaries(0)
    assert np.allclose(line[:, 1], 0.5, atol=1e-12)
    assert np.allclose(v.centroids[:, 1], [0.25, 0.75], atol=1e-12)


@pytest.mark.parametrize("scale", [1e-170, 1e200])
def test_tolerances_fit_any_extent(scale):
    V, F = grid(4)
    diagram = smg.Solver(scale * V, F).voronoi([0, len(V) - 1])
    lines = diagram.boundary_polylines(0)
    assert len(lines) > 0 and max(len(line.points) for line in lines) < 1000
    diagram.boundary_polylines(0, tolerance=scale / 100)
    with pytest.raises(ValueError, match="tolerance"):
        diagram.boundary_polylines(0, tolerance=scale * 1e-9)


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


def test_diagrams_can_be_pickled():
    s = smg.Solver(*sphere(12))
    sites, weights = np.array([3, 50, 70]), np.array([0, .1, 0])
    v = s.voronoi(sites, weights)
    sites[0], weights[0] = 9, 5  # the diagram keeps its own
    for other in (pickle.loads(pickle.dumps(v)), copy.deepcopy(v)):
        assert (other.labels == v.labels).all() and (other.areas == v.areas).all()


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
    for name in ("sample", "remesh", "relax"):
        with pytest.raises(ValueError, match="needs points"):
            getattr(t, name)(3)
    flat = t.voronoi([0, 1])
    for call in (lambda: flat.cell_mesh(0), lambda: flat.energy):
        with pytest.raises(ValueError, match="needs points"):
            call()
    (line,) = flat.boundary_polylines(0)
    assert (line.points == 0).all() and np.allclose(line.barycentric.sum(axis=1), 1)


def enclosed(lines):
    """The area inside closed curves in the plane; curves around holes run clockwise."""
    return sum(0.5 * np.sum(p[:-1, 0] * p[1:, 1] - p[1:, 0] * p[:-1, 1]) for p in lines)


def test_boundary_polylines_enclose_the_cells():
    V, F = grid(12)
    sites = [0, 40, 100, 160, 84]
    v = smg.Solver(V, F).voronoi(sites, weights=[0, 0, 0.05, 0, 0.1])
    for i in range(5):
        lines = v.boundary_polylines(i, 1e-5, along_border=True)
        assert all(line.is_closed and np.array_equal(line.points[0], line.points[-1]) for line in lines)
        assert enclosed([line.points for line in lines]) == pytest.approx(v.areas[i], rel=1e-3)
        for line in lines + v.boundary_polylines(i):
            from_coordinates = np.einsum("kj,kjd->kd", line.barycentric, V[F[line.faces]])
            assert np.allclose(from_coordinates, line.points, atol=1e-13)
            assert line.vertices.min() >= -1 and line.vertices.max() < len(v.triangles)
        for points, line in zip(v.boundaries(i), v.boundary_polylines(i)):
            assert np.array_equal(points, line.points)


def test_cell_meshes_are_the_faces_of_the_cut():
    V, F = sphere(16)
    s = smg.Solver(V, F)
    v = s.voronoi(s.sample(7))
    assert v.is_disk.tolist() == [True] * 7
    V2, F2, cell = v.cut()
    for i in range(7):
        Vi, Fi, face = v.cell_mesh(i)
        assert len(Fi) == (cell == i).sum() and 0 <= face.min() and face.max() < len(F)
        assert area(Vi, Fi).sum() == pytest.approx(area(V2, F2[cell == i]).sum(), rel=1e-12)
        # Each triangle lies in the plane of its face.
        n = np.cross(V[F[face, 1]] - V[F[face, 0]], V[F[face, 2]] - V[F[face, 0]])
        assert np.abs(np.einsum("md,mkd->mk", n, Vi[Fi] - V[F[face, 0]][:, None])).max() < 1e-12
    assert s.voronoi([3]).is_disk.tolist() == [False]  # a sphere


def test_labels_are_those_of_the_diagram():
    V, F = sphere(24)
    for s in (smg.Solver(V, F), smg.Solver.from_edge_lengths(
            len(V), F, np.linalg.norm(V[np.roll(F, -1, axis=1)] - V[F], axis=2))):
        for sites, weights in (([3, 200, 411], None), ([3, 200, 411], [0.1, 0, -0.2]),
                               ([3, (40, [0.2, 0.3, 0.5])], [1, 2])):
            v = s.voronoi(sites, weights)
            labels, d = s.labels(sites, weights)
            assert np.array_equal(labels, v.labels) and np.allclose(d, v.distances, rtol=1e-13, atol=1e-14)
            by_two, by_three = s.labels(sites, weights, threads=2), s.labels(sites, weights, threads=3)
            assert np.array_equal(by_two[1], by_three[1]) and np.allclose(by_two[1], d, rtol=1e-13, atol=1e-14)
    V, F = two_components()
    labels, d = smg.Solver(V, F).labels([0])
    assert (labels[16:] == -1).all() and np.isinf(d[16:]).all()
    with pytest.raises(ValueError, match=r"weights\[1\] differs too much"):
        smg.Solver(V, F).labels([0, 1], weights=[1e308, -1e308])


def test_relaxation():
    V, F = sphere(20)
    s = smg.Solver(V, F)
    sites = np.arange(6)
    steps = []
    end = s.relax(sites, iterations=30, on_iteration=lambda *step: steps.append(step))
    assert [i for i, _, _ in steps] == list(range(1, len(steps) + 1))
    assert steps[0][2] == pytest.approx(s.voronoi(sites).energy, rel=1e-12)
    assert s.voronoi(end).energy < 0.5 * steps[0][2]
    assert s.voronoi(end).areas.min() > 0.5 * s.voronoi(end).areas.max()
    assert s.relax(sites, iterations=0).tolist() == sites.tolist()
    # It ends after the first move that is short enough.
    early = []
    s.relax(sites, iterations=30, threshold=0.3, on_iteration=lambda *step: early.append(step))
    assert early == steps[:len(early)] and early[-1][1] <= 0.3 and all(move > 0.3 for _, move, _ in early[:-1])
    seen = []
    s.remesh(60, iterations=3, on_iteration=lambda i, move, energy: seen.append((i, energy)))
    assert [i for i, _ in seen] == list(range(1, len(seen) + 1)) and all(energy > 0 for _, energy in seen)

    def stop(i, move, energy):
        raise KeyError(i)

    for call in (lambda: s.relax(sites, on_iteration=stop), lambda: s.relax(sites, iterations=1, on_iteration=stop),
                 lambda: s.remesh(60, on_iteration=stop)):
        with pytest.raises(KeyError, match="1"):
            call()
    samples, radius = s.sample(9, return_radius=True)
    assert radius == s.distances(samples).max()


def test_reports_on_duals():
    V, F = sphere(16)
    s = smg.Solver(V, F)
    few = s.voronoi([0, 1]).check_dual()
    assert not few.is_manifold and few.cells_without_triangle == [0, 1]
    many = s.voronoi(s.sample(40)).check_dual()
    assert many.is_manifold and many.is_triangulation == (many.vertices_of_many_cells == [])
    # Four cells meet in the middle of a square.
    V, F = grid(2)
    square = smg.Solver(V, F).voronoi([0, 2, 6, 8]).check_dual()
    assert square.vertices_of_many_cells == [[0, 1, 2, 3]] and not square.is_triangulation
