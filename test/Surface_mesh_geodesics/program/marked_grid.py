#!/usr/bin/env python3
"""Writes an OFF mesh as PLY files whose faces have properties, in all formats and with all types of numbers.

usage: marked_grid.py mesh.off marks.txt output_folder

The file of marks has the numbers of the marked faces. The property `mark` of a face is 0, or another number if the face
is marked; `other` is not 0 everywhere, and `list` is a list. The files are text_TYPE.ply, little_TYPE.ply and
big_TYPE.ply, for each name of a type.
"""
import struct
import sys

TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d",
         "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I", "float32": "f",
         "float64": "d"}
FORMATS = {"text": ("ascii", ""), "little": ("binary_little_endian", "<"), "big": ("binary_big_endian", ">")}


def main():
    mesh, marks, folder = sys.argv[1:4]
    with open(mesh, encoding="ascii") as file:
        words = file.read().split()[1:]
    vertices, faces = int(words[0]), int(words[1])
    numbers = words[3:]
    points = [tuple(float(x) for x in numbers[3 * v:3 * v + 3]) for v in range(vertices)]
    numbers = numbers[3 * vertices:]
    corners = [tuple(int(x) for x in numbers[4 * f + 1:4 * f + 4]) for f in range(faces)]
    with open(marks, encoding="ascii") as file:
        marked = {int(word) for word in file.read().split()}
    for name, (format_name, order) in FORMATS.items():
        for type_name, letter in TYPES.items():
            # a value that is 0 if only its first byte is read, or the last one, and -0.0, which is 0
            value = {"B": 128, "b": -1, "h": 256, "H": 256, "i": 65536, "I": 1 << 31, "f": 0.25, "d": 1e-300}[letter]
            zero = -0.0 if letter in "fd" else 0
            rows = [("BiiiB" + "ff" + letter + "H",
                     (3,) + c + (2, 1.5, 2.5, value if f in marked else zero, 7)) for f, c in enumerate(corners)]
            header = (f"ply\nformat {format_name} 1.0\ncomment property int mark\n"
                      f"element vertex {vertices}\nproperty double x\nproperty double y\nproperty double z\n"
                      f"element face {faces}\nproperty list uchar int vertex_indices\nproperty list uchar float list\n"
                      f"property {type_name} mark\nproperty ushort other\nend_header\n")
            with open(f"{folder}/{name}_{type_name}.ply", "wb") as file:
                file.write(header.encode("ascii"))
                for form, row in [("ddd", p) for p in points] + rows:
                    file.write(struct.pack(order + form, *row) if order
                               else (" ".join(repr(x) for x in row) + "\n").encode("ascii"))


if __name__ == "__main__":
    main()
