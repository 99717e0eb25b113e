#!/usr/bin/env python3
"""What the Python module adds to the time of C++.

usage: benchmark_python.py PROGRAM MESH.off [--targets N] [--repetitions N] [--flags TEXT]

PROGRAM is benchmark_python, which measures the same calls in C++. The two run in turn, each in its own process, with
one thread. Prints comma separated values, one line for each call: medians in ms, and the median of the ratios of
adjacent runs. The module surface_mesh_geodesics must be importable.
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time

# As in benchmark_python.cpp.
TARGETS_AT_A_TIME = 10000
NUMBER_OF_PROPAGATIONS = 15


def read_off(file):
    import numpy as np
    with open(file, encoding="utf-8") as text:
        words = text.read().split()
    n, m = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * n], dtype=np.float64).reshape(n, 3)
    faces = np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=np.int64).reshape(m, 4)
    return points, np.ascontiguousarray(faces[:, 1:])


def milliseconds(work):
    begin = time.perf_counter()
    work()
    return 1000 * (time.perf_counter() - begin)


def measure(mesh, targets_file):
    """In a process of its own: prints the three times. Building is all that precedes the first distances."""
    import numpy as np
    import surface_mesh_geodesics as smg
    points, faces = read_off(mesh)
    targets = np.loadtxt(targets_file, dtype=np.int64)
    solvers = []

    def first_distances():
        solvers.append(smg.Solver(points, faces))
        solvers[0].distances(0)

    first = milliseconds(first_distances)
    solver = solvers[0]
    distances = min(milliseconds(lambda: solver.distances(0)) for _ in range(NUMBER_OF_PROPAGATIONS))
    solver.path(0, 1)

    def paths():
        for begin in range(0, len(targets), TARGETS_AT_A_TIME):
            solver.paths(0, targets[begin:begin + TARGETS_AT_A_TIME], threads=1)

    print(first - distances, distances, milliseconds(paths), sep=",")


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as info:
        names = [line.split(":")[1].strip() for line in info if line.startswith("model name")]
    return names[0] if names else "unknown"


def import_time():
    code = "import numpy, time; t = time.perf_counter(); import surface_mesh_geodesics; print(time.perf_counter() - t)"
    return 1000 * float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)


def times_of(command):
    output = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return [float(number) for number in output.strip().split(",")]


def compare(arguments):
    import numpy as np
    points, faces = read_off(arguments.mesh)
    with tempfile.TemporaryDirectory() as folder:
        targets = os.path.join(folder, "targets.txt")
        np.savetxt(targets, np.random.default_rng(2026).integers(0, len(points), arguments.targets), fmt="%d")
        runs = [(times_of([arguments.program, arguments.mesh, targets]),
                 times_of([sys.executable, __file__, "--measure", "", arguments.mesh, "--targets-file", targets]))
                for _ in range(arguments.repetitions)]
    print(f"# machine: {processor()}, {os.cpu_count()} hardware threads")
    print(f"# Python {sys.version.split()[0]}, NumPy {np.__version__}; flags of C++: {arguments.flags}")
    print(f"# from vertex 0, one thread; clock times in ms, medians of {arguments.repetitions} runs in turn; distances: "
          f"each the least of {NUMBER_OF_PROPAGATIONS}; ratios are Python / C++")
    mesh = os.path.basename(arguments.mesh)
    print("mesh,subdivisions,faces,call,cpp_ms,python_ms,ratio")
    for i, call in enumerate(("building and reading", "distances", f"{arguments.targets} paths")):
        times = (statistics.median(cpp[i] for cpp, _ in runs), statistics.median(python[i] for _, python in runs),
                 statistics.median(python[i] / cpp[i] for cpp, python in runs))
        print(mesh, 0, len(faces), call, *(f"{time:.3f}" for time in times), sep=",")
    print(mesh, 0, len(faces), "import", "", f"{statistics.median(import_time() for _ in range(9)):.1f}", "", sep=",")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("mesh")
    parser.add_argument("--targets", type=int, default=100000)
    parser.add_argument("--repetitions", type=int, default=7)
    parser.add_argument("--flags", default="flags not given")
    parser.add_argument("--measure", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--targets-file", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.measure:
        measure(arguments.mesh, arguments.targets_file)
    else:
        compare(arguments)


if __name__ == "__main__":
    main()
