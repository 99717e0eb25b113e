#!/usr/bin/env python3
"""Reads the file that the example paths_from_several_sources writes, as another program would.

Usage: check_path_file.py DATA_FOLDER PROGRAM

The program runs without arguments in an empty folder with data/ in it. Each line of the file has the number of points
of a path, and the points. The number is the printed one, no point is repeated, the length of the path is the printed
distance, and two paths end at the same point if and only if the program has printed the same source for them.
"""

import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PRINTED_PATH = re.compile(r"face \d+: source (\d+), distance (\S+), (\d+) points")
PRINTED_DIGITS = 1e-5


def points_of(line):
    words = line.split()
    if len(words) != 1 + 3 * int(words[0]):
        raise ValueError(f"{words[0]} points announced, but {len(words) - 1} coordinates found")
    numbers = [float(word) for word in words[1:]]
    return [tuple(numbers[i:i + 3]) for i in range(0, len(numbers), 3)]


def complaints_about(polylines, printed):
    """The faults of paths, given the printed (source, distance, number of points) of each."""
    if not polylines or len(polylines) != len(printed):
        return [f"{len(polylines)} paths in the file, but {len(printed)} were printed"]
    result = []
    for i, (line, (_, distance, number)) in enumerate(zip(polylines, printed)):
        length = sum(math.dist(p, q) for p, q in zip(line, line[1:]))
        if len(line) != number or any(p == q for p, q in zip(line, line[1:])):
            result.append(f"path {i} has {len(line)} points instead of {number}, or repeats one")
        if abs(length - distance) > PRINTED_DIGITS * distance:
            result.append(f"path {i} has the length {length} instead of {distance}")
    ends = {(source, line[-1]) for (source, _, _), line in zip(printed, polylines)}
    if not len(ends) == len({source for source, _ in ends}) == len({point for _, point in ends}):
        result.append("paths to one source end at several points, or paths to several sources at one")
    return result


def main(arguments):
    if len(arguments) != 2:
        print(__doc__)
        return 2
    data, program = (pathlib.Path(argument).absolute() for argument in arguments)
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(data, pathlib.Path(folder) / "data")
        run = subprocess.run([str(program)], cwd=folder, capture_output=True, text=True, check=True)
        lines = (pathlib.Path(folder) / "paths.polylines.txt").read_text(encoding="ascii").splitlines()
    printed = [(int(source), float(distance), int(number))
               for source, distance, number in PRINTED_PATH.findall(run.stdout)]
    complaints = complaints_about([points_of(line) for line in lines], printed)
    print(*(complaints or [f"{len(lines)} paths, as long as printed"]), sep="\n")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
