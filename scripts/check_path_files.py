#!/usr/bin/env python3
"""Reads the files that the example paths_from_several_sources has written, as other programs would.

Usage: check_path_files.py FOLDER

The polylines.txt, OBJ and legacy VTK files have to follow their formats and to hold the same polylines, digit by digit:
no point twice in a row, two points or more in each, and one source number for each in the VTK file.
"""

import pathlib
import sys


def points_of(words):
    """Triples of numbers."""
    if len(words) % 3 != 0:
        raise ValueError("coordinates are not in threes")
    numbers = [float(word) for word in words]
    return [tuple(numbers[i:i + 3]) for i in range(0, len(numbers), 3)]


def read_polylines(path):
    result = []
    for line in path.read_text().splitlines():
        words = line.split()
        points = points_of(words[1:])
        if int(words[0]) != len(points):
            raise ValueError(f"{words[0]} points announced, {len(points)} there")
        result.append(points)
    return result


def read_obj(path):
    vertices, result = [], []
    for line in path.read_text().splitlines():
        kind, *words = line.split()
        if kind == "v":
            vertices += points_of(words)
        elif kind == "l":
            result.append([vertices[int(word) - 1] for word in words])
        else:
            raise ValueError(f"line of kind {kind}")
    return result


def expect(words, *expected):
    for word, right in zip(words, expected, strict=True):
        if right is not None and word != right:
            raise ValueError(f"{word} instead of {right}")


def read_vtk(path):
    lines = iter(path.read_text().splitlines())
    if next(lines) != "# vtk DataFile Version 3.0":
        raise ValueError("no VTK file")
    next(lines)  # the title
    expect(next(lines).split(), "ASCII")
    expect(next(lines).split(), "DATASET", "POLYDATA")
    head = next(lines).split()
    expect(head, "POINTS", None, "double")
    points = [points_of(next(lines).split())[0] for _ in range(int(head[1]))]
    head = next(lines).split()
    expect(head, "LINES", None, None)
    cells = [[int(word) for word in next(lines).split()] for _ in range(int(head[1]))]
    if sum(len(cell) for cell in cells) != int(head[2]) or any(cell[0] != len(cell) - 1 for cell in cells):
        raise ValueError("the sizes of the lines are wrong")
    expect(next(lines).split(), "CELL_DATA", str(len(cells)))
    expect(next(lines).split(), "SCALARS", "source", "int", "1")
    expect(next(lines).split(), "LOOKUP_TABLE", "default")
    sources = [int(line) for line in lines]
    if len(sources) != len(cells) or any(source < 0 for source in sources):
        raise ValueError("there is not one source for each line")
    return [[points[i] for i in cell[1:]] for cell in cells]


def main(arguments):
    if len(arguments) != 1:
        print(__doc__)
        return 2
    folder = pathlib.Path(arguments[0])
    polylines = read_polylines(folder / "paths.polylines.txt")
    for name, read in (("paths.obj", read_obj), ("paths.vtk", read_vtk)):
        if read(folder / name) != polylines:
            print(f"{name} does not hold the lines of paths.polylines.txt")
            return 1
    for line in polylines:
        if len(line) < 2 or any(p == q for p, q in zip(line, line[1:])):
            print("a line of one point, or with a point twice in a row")
            return 1
    print(f"{len(polylines)} paths, {sum(len(line) for line in polylines)} points, the same in three formats")
    return 0 if polylines else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
