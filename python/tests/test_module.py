"""Interruption, memory, docstrings, the program for the command line, gdist."""

import base64
import csv
import doctest
import gc
import importlib
import json
import os
import pkgutil
import re
import resource
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pytest

import surface_mesh_geodesics as smg
from surface_mesh_geodesics import gdist
from meshes import grid, sphere, write_off


@pytest.mark.parametrize("call", ["s.distances(0)", "s.distances(0, threads=2)", "s.voronoi(list(range(0, n, 97)))",
                                  "s.matrix()", "s.paths(0, np.arange(n))", "s.sample(n)", "s.remesh(500)",
                                  "v.cut()", "s.exact_isolines(0, np.linspace(.1, 3, 1000))", "s.certify(d, 0)",
                                  "s.path(np.arange(0, n, 7), 5, threads=2)", "s.voronoi([0, 99], threads=2)",
                                  "s.labels([0, 99])", "s.relax([0, 99])", "smg.Solver(V, F)", "v.cell_mesh(0)",
                                  "s.trace(5, .3, 1e9)", "s.directions([0, 99])", "s.peeling_order()",
                                  "s.sparse_matrix(.5)", "smg.Solver(V, F).distances(0, radius=0)",
                                  "s.store_matrix(folder, threads=2)", "s.store_matrix(folder, threads=1)",
                                  "s.store_matrix(folder, symmetric=True)", "s.distances(curve)",
                                  "s.signed_distances(curve)", "s.shortest_path_curve(np.arange(0, n, 97))"])
def test_ctrl_c(call, tmp_path):
    program = textwrap.dedent(f"""
        import numpy as np, os, signal, sys, threading, time
        sys.path.insert(0, {os.path.dirname(__file__)!r})
        import surface_mesh_geodesics as smg
        from meshes import sphere
        V, F = sphere(150)
        s = smg.Solver(V, F)
        n = s.n_vertices
        d, v, curve = s.distances(0), s.voronoi([0, 99]), smg.Curve(1 + np.arange(150), closed=True)
        sent, folder, end = [], {str(tmp_path / "folder")!r}, time.monotonic() + 120
        def interrupt():
            sent.append(time.process_time())
            os.kill(os.getpid(), signal.SIGINT)
        threading.Timer(.1, interrupt).start()
        try:
            while time.monotonic() < end:
                {call}
        except KeyboardInterrupt:
            print("interrupted after", time.process_time() - sent[0])
            print("works" if np.isfinite(s.distances(0)).all() else "broken")
        """)
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=300)
    assert "interrupted after" in done.stdout and "works" in done.stdout, done.stderr
    seconds = float(re.search("interrupted after (.*)", done.stdout)[1])  # of the processors, for all threads
    print(f"{call} ends after {seconds:.3f} s")  # pytest -s shows it
    assert seconds < 2  # at once, for a program that would take minutes; 0.2 s of an idle machine


@pytest.mark.parametrize("call", ["s.distances(0)", "smg.Solver(V, F)", "v.areas", "s.matrix(range(9))", "v.cut()"])
def test_program_ends_while_daemon_threads_try_again(call):
    program = textwrap.dedent(f"""
        import sys, threading, time
        sys.path.insert(0, {os.path.dirname(__file__)!r})
        import surface_mesh_geodesics as smg
        from meshes import sphere
        V, F = sphere(60)
        s = smg.Solver(V, F)
        v = s.voronoi([0, 99])
        def work():
            while True:
                try:
                    {call}
                except Exception:
                    pass
        for _ in range(2):
            threading.Thread(target=work, daemon=True).start()
        time.sleep(.3)
        print("end")
        """)
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
    assert done.returncode == 0 and done.stdout == "end\n", done.stderr


def test_program_ends_while_a_daemon_thread_computes():
    program = textwrap.dedent(f"""
        import sys, threading, time
        sys.path.insert(0, {os.path.dirname(__file__)!r})
        import surface_mesh_geodesics as smg
        from meshes import sphere
        s = smg.Solver(*sphere(100))
        threading.Thread(target=lambda: s.matrix(), daemon=True).start()
        time.sleep(.3)
        print("end")
        """)
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
    assert done.returncode == 0 and done.stdout == "end\n", done.stderr


@pytest.mark.parametrize("progress", ["lambda part: time.sleep(.01)", "lambda part: np.ones(10**6).sum()", "print"])
def test_program_ends_while_a_progress_function_runs(progress):
    program = textwrap.dedent(f"""
        import atexit, sys, threading, time
        atexit.register(lambda: print(s.distances(0).max() > 0))  # after the daemon thread has stopped
        sys.path.insert(0, {os.path.dirname(__file__)!r})
        import numpy as np, surface_mesh_geodesics as smg
        from meshes import sphere
        V, F = sphere(100)
        s, other = smg.Solver(V, F), smg.Solver(V, F)
        threading.Thread(target=lambda: other.matrix(progress={progress}), daemon=True).start()
        time.sleep(.3)
        """)
    for _ in range(3):
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
        assert done.returncode == 0 and done.stdout.endswith("True\n"), done.stderr


@pytest.mark.parametrize("call", ["voronoi(sites)", "voronoi(sites, threads=2)", "relax(sites, iterations=2)",
                                  "distances(sites, threads=2)", "labels(sites, threads=2)"])
def test_progress_is_called_during_runs_from_many_sites(call):
    s = smg.Solver(*sphere(250))
    sites = list(range(0, s.n_vertices, 20))
    parts = []
    eval(f"s.{call.replace(')', ', progress=parts.append)')}", {"s": s, "sites": sites, "parts": parts})
    assert any(0 < part < 1 for part in parts)


def test_progress_is_called_and_may_raise():
    s = smg.Solver(*sphere(150))
    parts = []
    s.voronoi(list(range(0, s.n_vertices, 50)), progress=parts.append)
    assert parts and all(0 <= p <= 1 for p in parts) and parts == sorted(parts)

    def stop(part):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        s.matrix(progress=stop)
    assert np.isfinite(s.distances(0)).all()


def test_rows_that_have_begun_are_interrupted():
    s = smg.Solver(*grid(300, 0.001))
    s.distances(0, radius=0)

    def stop(part):
        parts.append(part)
        raise RuntimeError("enough")

    for call in (lambda: s.matrix([0], threads=1, progress=stop), lambda: s.matrix([0, 1], threads=2, progress=stop),
                 lambda: s.matrix([(0, [0.2, 0.3, 0.5])], threads=1, progress=stop),
                 lambda: s.sparse_matrix(9, [0, 1], progress=stop)):
        parts = []
        with pytest.raises(RuntimeError, match="enough"):
            call()
        assert parts == [0]
    assert np.isfinite(s.matrix([0], [5])).all()


def test_progress_may_not_use_the_solver_that_computes():
    s, other = smg.Solver(*sphere(60)), smg.Solver(*sphere(8))
    found = []

    def use(part):
        found.append(other.distances(0).max())  # another one is fine
        s.distances(0)

    with pytest.raises(RuntimeError, match="uses the solver that computes"):
        s.matrix(progress=use, threads=1)
    assert len(found) == 1 and np.isfinite(s.distances(0)).all()


def test_other_threads_run_during_a_computation():
    s = smg.Solver(*sphere(150))
    count = [0]
    stop = threading.Event()

    def tick():
        while not stop.is_set():
            count[0] += 1
            time.sleep(0.001)

    ticker = threading.Thread(target=tick)
    ticker.start()
    s.matrix(range(20), threads=1)
    stop.set()
    ticker.join()
    assert count[0] > 10


def test_memory_does_not_grow():
    V, F = grid(20, 0.1)

    def use(n):
        for _ in range(n):
            s = smg.Solver(V, F)
            s.distances(0)
            s.path(0, 30)
            s.voronoi([0, 100]).cut()
        gc.collect()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    use(100)
    before = use(100)
    assert use(500) - before < 4000  # kB


def test_results_are_counted_once():
    s = smg.Solver(*grid(5))
    d = s.distances(0)
    assert sys.getrefcount(d) == 2
    del s
    gc.collect()
    assert np.isfinite(d).all()


def test_examples_in_docstrings():
    modules = [smg] + [importlib.import_module(f"surface_mesh_geodesics.{m.name}")
                       for m in pkgutil.iter_modules(smg.__path__) if m.name != "_core"]
    results = [doctest.testmod(m) for m in modules]
    assert sum(r.attempted for r in results) > 40 and sum(r.failed for r in results) == 0


def test_each_docstring_has_an_example():
    assert ">>>" in smg.__doc__
    for module in (smg, gdist):
        for name in getattr(module, "__all__", ("compute_gdist", "local_gdist_matrix")):
            thing = getattr(module, name)
            if not callable(thing):
                continue
            assert ">>>" in thing.__doc__, name
            for member, value in vars(thing).items() if isinstance(thing, type) else []:
                if not member.startswith("_") and (callable(value) or isinstance(value, (classmethod, property))):
                    assert ">>>" in value.__doc__, f"{name}.{member}"


def test_import_is_light():
    program = ("import sys, numpy; import surface_mesh_geodesics; "
               "print([m for m in ('scipy', 'matplotlib') if m in sys.modules])")
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stdout.strip() == "[]"


def test_gdist_needs_no_import_of_its_own():
    program = "import surface_mesh_geodesics as smg; print(smg.gdist.compute_gdist.__name__)"
    assert subprocess.check_output([sys.executable, "-c", program], text=True) == "compute_gdist\n"


def test_gdist():
    V, F = grid(6, 0.2)
    d = smg.Solver(V, F).distances(0)
    assert np.array_equal(gdist.compute_gdist(V, F.astype(np.int32)), d)
    one = gdist.compute_gdist(V, F + 1, np.array([4], np.int32), np.array([1, 2], np.int32), is_one_indexed=True)
    assert np.array_equal(one, smg.Solver(V, F).distances(4, targets=[1, 2]))
    assert np.isinf(gdist.compute_gdist(V, F, max_distance=0.3)).any()
    beyond = np.where(F + 1 == len(V), len(V) + 1, F + 1)
    with pytest.raises(IndexError, match=f"triangles has 1 to {len(V) + 1}, .* {len(V)} vertices, counted from 1"):
        gdist.compute_gdist(V, beyond, is_one_indexed=True)
    mixed = F.copy()
    mixed[::3] = mixed[::3, ::-1]
    assert np.allclose(gdist.compute_gdist(V, mixed), d, rtol=1e-12)
    strip = [[k, (k + 2) % 5, (k + 1) % 5] for k in range(5)]  # a Moebius band
    with pytest.raises(ValueError, match="two sides"):
        gdist.compute_gdist(np.random.default_rng(1).random((5, 3)), strip)
    pytest.importorskip("scipy")
    M = gdist.local_gdist_matrix(V, F, 0.4)
    D = smg.Solver(V, F).matrix()
    assert M.format == "csc" and np.allclose(M.toarray(), np.where(D <= 0.4, D, 0), rtol=1e-12)


def test_joblib_processes_give_the_same_numbers():
    joblib = pytest.importorskip("joblib")
    s = smg.Solver(*sphere(16))
    rows = joblib.Parallel(n_jobs=2)(joblib.delayed(s.distances)(i) for i in range(6))
    assert all(np.array_equal(row, s.distances(i)) for i, row in enumerate(rows))


def largest_distance(mesh):
    return smg.Solver(*mesh).distances(0).max()


def test_dask_processes_give_the_same_numbers():
    dask = pytest.importorskip("dask")
    meshes = [sphere(8), sphere(10), grid(6, 0.2)]
    expected = [largest_distance(m) for m in meshes]
    found = dask.compute(*[dask.delayed(largest_distance)(m) for m in meshes], scheduler="processes", num_workers=2)
    assert list(found) == expected


def test_a_local_cluster_of_dask_gives_the_same_numbers():
    dask, distributed = pytest.importorskip("dask"), pytest.importorskip("distributed")
    meshes = [sphere(8), sphere(10), grid(6, 0.2)]
    s = smg.Solver(*meshes[0])
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster):
            largest = dask.compute(*[dask.delayed(largest_distance)(m) for m in meshes])
            rows = dask.compute(*[dask.delayed(s.distances)(i) for i in range(4)])  # a solver is sent to processes
    assert list(largest) == [largest_distance(m) for m in meshes]
    assert all(np.array_equal(row, s.distances(i)) for i, row in enumerate(rows))


def test_plot(tmp_path):
    pytest.importorskip("matplotlib").use("Agg")
    V, F = sphere(12)
    s = smg.Solver(V, F)
    d = s.distances(0)
    axes = smg.plot(V, F, d, lines=s.isolines(d, [1.0]), points=V[:1], title="distances")
    axes.figure.savefig(tmp_path / "picture.png")
    assert (tmp_path / "picture.png").stat().st_size > 5000
    smg.plot(V, F, np.arange(len(F)), axes=axes)
    for lines in (s.isolines(d, [0.3, 1.0, 2.0]), s.path(0, 50), [s.path(0, 50), s.path(0, 60)], s.path(0, 50).points):
        number = len(axes.lines)
        smg.plot(V, F, lines=lines, axes=axes)
        assert len(axes.lines) - number == (1 if not isinstance(lines, list) else len(lines))
    with pytest.raises(ValueError, match="values has shape"):
        smg.plot(V, F, d[:-1])


def test_page(tmp_path):
    V, F = sphere(24)
    s = smg.Solver(V, F)
    d = s.distances(0)
    if not any(p.is_file() for p in smg.pages.THREE):
        with pytest.raises(FileNotFoundError, match="three.js"):
            smg.page(V, F, d)
        return
    page = smg.page(V, F, d, paths=[s.path(0, 300)], title="<a & b>", file=tmp_path / "page.html")
    text = (tmp_path / "page.html").read_text()
    assert text == page.text and "<title>&lt;a &amp; b&gt;</title>" in text and not re.search("@[A-Za-z_.]+@", text)
    data = json.loads(re.search('<script id="data" type="application/json">(.*?)</script>', text)[1])
    assert data["title"] == "<a & b>" and data["largest"] == d.max()
    assert np.array_equal(np.frombuffer(base64.b64decode(data["distances"]), "<f4"), d.astype(np.float32))
    assert np.allclose(np.diff(data["isolines"]), data["isolines"][0]) and 5 <= len(data["isolines"]) <= 10
    assert page._repr_html_().startswith("<iframe srcdoc=")
    with pytest.raises(ValueError, match="distances has shape"):
        smg.page(V, F, d[1:])


def test_page_of_a_diagram():
    if not any(p.is_file() for p in smg.pages.THREE):
        pytest.skip("three.js is not there")
    s = smg.Solver(*sphere(16))
    sites = s.sample(5)
    v = s.voronoi(sites)
    V, F, cell = v.cut()
    d = smg.Solver(V, F).distances(sites)
    data = json.loads(re.search('<script id="data" type="application/json">(.*?)</script>',
                                smg.page(V, F, d, cells=cell, colors=v.colors).text)[1])
    assert np.array_equal(np.frombuffer(base64.b64decode(data["cells"]), "<u4"), cell)
    assert len(set(data["cellColors"])) == 5 and all(re.fullmatch("#[0-9a-f]{6}", c) for c in data["cellColors"])
    assert data["isolines"] == []
    with pytest.raises(IndexError, match="cells"):
        smg.page(V, F, d, cells=cell, colors=v.colors[:4])
    with pytest.raises(ValueError, match="colors has shape"):
        smg.page(V, F, d, cells=cell, colors=np.zeros((3, 4)))
    unreached = np.where(cell == 0, -1, cell)
    assert "cells" in smg.page(V, F, d, cells=unreached, colors=v.colors).text
    with pytest.raises(ValueError, match="cells has shape"):
        smg.page(V, F, d, cells=cell[1:], colors=v.colors)


# --- the same bits as the program for the command line ---

PROGRAM = os.environ.get("SURFACE_MESH_GEODESICS_PROGRAM")


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=True).stdout


def table(*arguments):
    return list(csv.DictReader(run(*arguments).splitlines()))


@pytest.mark.skipif(PROGRAM is None, reason="SURFACE_MESH_GEODESICS_PROGRAM names no program")
@pytest.mark.parametrize("mesh", [sphere(20), grid(15, 0.3)])
def test_same_numbers_as_the_program(mesh, tmp_path):
    V, F = mesh
    s = smg.Solver(V, F)
    file = tmp_path / "mesh.off"
    write_off(file, V, F)
    rows = table("distances", file, "--source", 3)
    assert [float(r["distance"]) for r in rows] == s.distances(3).tolist()
    if len(s.border_curves()) > 0:
        rows = table("distances", file, "--source-border")
        assert [float(r["distance"]) for r in rows] == s.distances(s.border_curves()).tolist()
    rows = table("path", file, "--source", 3, "--target", 70)
    assert float(rows[0]["length"]) == s.path(3, 70).length
    path = s.path(3, 70)
    assert int(rows[0]["points"]) == len(path)
    file_of_path = tmp_path / "path.polylines.txt"
    run("path", file, "--source", 3, "--target", 70, "-o", file_of_path)
    numbers = [float(x) for x in file_of_path.read_text().split()]
    assert numbers[0] == len(path) and numbers[1:] in (path.points.ravel().tolist(), path.points[::-1].ravel().tolist())
    sites = s.sample(7, first=[3])
    rows = table("sample", file, "--number", 7, "--first", 3, "--quiet")
    assert [int(r["vertex"]) for r in rows] == sites.tolist()
    by_vertex = table("voronoi", file, "--site", ",".join(map(str, sites)), "--vertices", "--quiet")
    rows = table("voronoi", file, "--site", ",".join(map(str, sites)), "--quiet")
    v = s.voronoi(sites)
    assert [float(r["area"]) for r in rows] == v.areas.tolist()
    assert [int(r["site"]) for r in by_vertex] == v.labels.tolist()
    assert [float(r["distance"]) for r in by_vertex] == v.distances.tolist()
    text = run("matrix", file, "--source", 3, "--source", 8)
    head, *rows = [row.split(",") for row in text.splitlines() if row]
    found = np.array(rows, float)
    # Without targets, the matrix is that of the sources, which label its rows and columns. It is computed above the
    # diagonal.
    assert head == ["source", "3", "8"] and found[:, 0].tolist() == [3, 8]
    assert np.array_equal(np.triu(found[:, 1:]), np.triu(s.matrix([3, 8], [3, 8])))


@pytest.mark.skipif(PROGRAM is None, reason="SURFACE_MESH_GEODESICS_PROGRAM names no program")
@pytest.mark.parametrize("mesh", [sphere(20), grid(15, 0.3)])
def test_same_numbers_of_sources_obstacles_meshes_and_stores(mesh, tmp_path):
    V, F = mesh
    s = smg.Solver(V, F)
    file, places, avoided, coarse = (tmp_path / name for name in ("mesh.off", "places", "avoided", "coarse.off"))
    write_off(file, V, F)
    places.write_text("7 0.2 0.3 0.5\n11 0.5 0.25 0.25\n")
    sources = ([7, 11], [[.2, .3, .5], [.5, .25, .25]])
    rows = table("distances", file, "--source-file", places, "--radius", .6)
    d, nearest = s.distances(sources, radius=.6, return_nearest=True)
    assert [float(r["distance"]) for r in rows] == d.tolist() and np.isinf(d).any()
    assert [int(r["source"]) for r in rows] == nearest.tolist()

    avoided.write_text("\n".join(map(str, range(40, 60))))
    rows = table("distances", file, "--source", 3, "--avoid", avoided, "--quiet")
    d = s.avoiding(range(40, 60)).distances(3)
    assert [float(r["distance"]) for r in rows] == d.tolist() and (d > s.distances(3)).any()
    path = table("path", file, "--source", 3, "--target", 120, "--avoid", avoided)[0]
    assert float(path["length"]) == s.avoiding(range(40, 60)).path(3, 120).length

    V = V * np.random.default_rng(1).uniform(.97, 1.03, V.shape)  # symmetric samples are ties, which last digits decide
    s = smg.Solver(V, F)
    write_off(file, V, F)
    run("remesh", file, "--number", 30, "--iterations", 3, "-o", coarse, "--quiet")
    points, faces = s.remesh(30, iterations=3)
    _, sizes, *lines = [line for line in coarse.read_text().splitlines() if line.strip() and not line.startswith("#")]
    n, m = map(int, sizes.split()[:2])
    # Files and results may have the triangles in another order, and with it the points.
    theirs = np.array([line.split() for line in lines[:n]], float)
    corners = np.array([line.split()[1:4] for line in lines[n:n + m]], int)
    assert sorted(theirs.tolist()) == sorted(points.tolist())
    assert _triangles(theirs, corners) == _triangles(points, faces)

    for name, options, more in (("whole", {}, []), ("half", {"symmetric": True}, ["--symmetric"]),
                                ("near", {"radius": .5, "float32": True}, ["--radius", .5, "--float32"])):
        ours, theirs = tmp_path / f"{name}_ours", tmp_path / f"{name}_theirs"
        s.store_matrix(ours, **options)
        run("matrix", file, "--source", "all", "--store", theirs, *more)
        assert sorted(f.name for f in ours.iterdir()) == sorted(f.name for f in theirs.iterdir())
        for f in ours.glob("*.npy"):
            assert f.read_bytes() == (theirs / f.name).read_bytes()


@pytest.mark.skipif(PROGRAM is None, reason="SURFACE_MESH_GEODESICS_PROGRAM names no program")
def test_same_numbers_of_signs_lines_and_certificates(tmp_path):
    V, F = grid(15, 0.3)
    s = smg.Solver(V, F)
    file, distances, lines = (tmp_path / name for name in ("mesh.off", "distances.csv", "lines.obj"))
    write_off(file, V, F)
    rows = table("distances", file, "--source-border", "--signed", "--quiet")
    assert [float(r["distance"]) for r in rows] == s.signed_distances(s.border_curves()).tolist()

    run("distances", file, "--source", 3, "-o", distances, "--lines", lines, "--spacing", .3)
    d = s.distances(3)
    levels = [.3 * i for i in range(1, 100) if .3 * i < d.max()]
    ours = [point for lines_of_level in s.exact_isolines(3, levels) for line in lines_of_level for point in line]
    theirs = [line.split()[1:] for line in lines.read_text().splitlines() if line.startswith("v ")]
    assert len(levels) > 2
    assert np.array_equal(np.unique(np.array(ours), axis=0), np.unique(np.array(theirs, float), axis=0))

    for offset in (0, .125):  # right distances, and wrong ones
        rows = distances.read_text().splitlines()
        cells = rows[50].split(",")
        cells[1] = repr(float(cells[1]) + offset)
        d[int(cells[0])] += offset
        distances.write_text("\n".join([*rows[:50], ",".join(cells), *rows[51:]]) + "\n")
        done = subprocess.run([PROGRAM, "check", file, "--source", "3", "--distances", distances], capture_output=True,
                              text=True)
        found = {row.split(",")[0]: row.split(",")[1:] for row in done.stdout.splitlines()[1:] if row}
        conditions = s.certify(d, 3).conditions
        assert list(found) == list(conditions) and (done.returncode != 0) == (offset != 0)
        for name, c in conditions.items():
            vertex = "" if c.vertex < 0 else str(c.vertex)
            assert [int(found[name][0]), float(found[name][1]), found[name][2]] == [
                c.number_of_checks, c.violation, vertex], name


def _triangles(V, F):
    """The triangles as sorted lists of points, each beginning with its least point."""
    return sorted(min([t[k:] + t[:k] for k in range(3)]) for t in V[F].tolist())
