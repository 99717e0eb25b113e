"""Matrices in folders."""

import glob
import multiprocessing
import os
import subprocess
import sys

import numpy as np
import pytest

import surface_mesh_geodesics as smg
from meshes import grid

V, F = grid(8, 0.2)
S = smg.Solver(V, F)


def stored(folder):
    return np.concatenate([np.load(f) for f in sorted(glob.glob(f"{folder}/rows_*.npy"))])


def test_the_stored_matrix_has_the_same_bits(tmp_path):
    sources = [0, 7, (3, [0.2, 0.3, 0.5])]
    assert S.store_matrix(tmp_path / "all") == (len(V), len(V))
    assert np.array_equal(stored(tmp_path / "all"), S.matrix())
    assert S.store_matrix(str(tmp_path / "some"), sources, [4, 9], threads=1) == (3, 3)
    assert np.array_equal(stored(tmp_path / "some"), S.matrix(sources, [4, 9]))
    assert S.store_matrix(tmp_path / "single", float32=True)[0] == len(V)
    assert np.array_equal(stored(tmp_path / "single"), S.matrix().astype(np.float32))


def test_sparse_and_symmetric_matrices(tmp_path):
    sparse = pytest.importorskip("scipy.sparse")
    S.store_matrix(tmp_path / "near", radius=0.3)
    shards = [name[: -len(".data.npy")] for name in sorted(glob.glob(f"{tmp_path}/near/rows_*.data.npy"))]
    rows = [sparse.csr_matrix(tuple(np.load(f"{name}.{part}.npy") for part in ("data", "indices", "indptr")),
                              shape=(len(np.load(f"{name}.indptr.npy")) - 1, len(V))) for name in shards]
    assert (sparse.vstack(rows) != S.sparse_matrix(0.3)).nnz == 0
    S.store_matrix(tmp_path / "upper", [1, 4, 9, 16], [1, 4, 9, 16], symmetric=True)
    upper = np.concatenate([np.load(f) for f in sorted(glob.glob(f"{tmp_path}/upper/rows_*.npy"))])
    expected = S.matrix([1, 4, 9, 16], [1, 4, 9, 16])[np.triu_indices(4, 1)]
    assert np.abs(upper - expected).max() < 1e-12


def store_part(folder, rows):
    return smg.Solver(V, F).store_matrix(folder, rows=rows, threads=1)


def test_processes_share_a_folder(tmp_path):
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        pool.starmap(store_part, [(str(tmp_path), (0, 40)), (str(tmp_path), (40, len(V)))])
    assert S.store_matrix(tmp_path) == (len(V), len(V)) and np.array_equal(stored(tmp_path), S.matrix())


def test_an_interrupted_call_goes_on(tmp_path):
    def stop(part):
        raise KeyError("enough")

    points, faces = grid(60, 0.02)
    s = smg.Solver(points, faces)
    with pytest.raises(KeyError):
        s.store_matrix(tmp_path, range(200), threads=1, progress=stop)
    assert s.store_matrix(tmp_path, range(200)) == (200, 200)
    assert np.array_equal(stored(tmp_path), s.matrix(range(200)))


def test_errors(tmp_path):
    S.store_matrix(tmp_path / "m", [0, 1])
    with pytest.raises(ValueError, match="m"):
        S.store_matrix(tmp_path / "m", [0, 2])
    with pytest.raises(ValueError):
        smg.Solver(2 * V, F).store_matrix(tmp_path / "m", [0, 1])
    with pytest.raises(ValueError, match="rows"):
        S.store_matrix(tmp_path / "m", [0, 1], rows=3)
    with pytest.raises(ValueError, match=r"rows\[1\]"):
        S.store_matrix(tmp_path / "m", [0, 1], rows=(3, 1))
    with pytest.raises(ValueError):
        S.store_matrix(tmp_path / "symmetric", [0, 1], [2, 3], symmetric=True)
    with pytest.raises(OSError):
        (tmp_path / "file").write_text("")
        S.store_matrix(tmp_path / "file" / "below", [0, 1])
    with pytest.raises(TypeError):
        S.store_matrix(7)
    with pytest.raises(ValueError, match="null character"):
        S.store_matrix(f"{tmp_path}/a\0b")
    (tmp_path / "m" / "manifest.json").write_text("{")
    with pytest.raises(ValueError, match=r"m.manifest\.json: the manifest is damaged"):
        S.store_matrix(tmp_path / "m", [0, 1])


def test_the_order_of_peeling_is_a_permutation_that_a_symmetric_matrix_takes(tmp_path):
    order = S.peeling_order()
    assert order.dtype == np.int64 and np.array_equal(np.sort(order), np.arange(len(V)))
    d = S.distances(int(order[-1]))
    assert np.all(np.diff(d[order]) <= 1e-12)
    S.store_matrix(tmp_path, order, order, symmetric=True)
    expected = S.matrix(order, order)[np.triu_indices(len(V), 1)]
    assert np.array_equal(stored(tmp_path), expected)
    assert np.array_equal(S.peeling_order([4]), [4]) and len(S.peeling_order([])) == 0
    with pytest.raises(IndexError, match=r"vertices\[0\] is 81"):
        S.peeling_order([len(V)])


def peak_of_memory(folder, rows):
    """In kB, of a process that stores so many rows. (The largest size is that of the process, not of its parent.)"""
    program = (f"import sys; sys.path.insert(0, {os.path.dirname(__file__)!r})\n"
               f"import surface_mesh_geodesics as smg; from meshes import grid\n"
               f"s = smg.Solver(*grid(60, 0.02)); s.store_matrix({str(folder)!r}, range({rows}), float32=True)\n"
               "print([line.split()[1] for line in open('/proc/self/status') if line.startswith('VmHWM')][0])")
    return int(subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout)


@pytest.mark.skipif(not os.path.exists("/proc/self/status"), reason="the system does not tell the size of a process")
def test_memory_does_not_depend_on_the_number_of_rows(tmp_path):
    few, many = peak_of_memory(tmp_path / "few", 100), peak_of_memory(tmp_path / "many", 1600)
    matrix = sum(os.path.getsize(f) for f in glob.glob(f"{tmp_path}/many/rows_*.npy")) // 1024
    assert matrix > 23000 and many - few < matrix / 8
