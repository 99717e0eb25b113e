#!/usr/bin/env python3
"""Runs the program on damaged OFF, OBJ and PLY files: truncated at every length, bytes and numbers replaced, counts
that promise too much, indices out of range. Each run has to end with status 0, or with a documented one and one line of
message, within ten seconds and one GB of memory. Prints how many runs ended how; a file on which a run went wrong is
kept. Arguments: see --help."""

import argparse
import collections
import os
import pathlib
import random
import re
import resource
import struct
import subprocess
import sys

SECONDS = 10
BYTES_OF_MEMORY = 1 << 30
DOCUMENTED = {0, 1, 2, 3, 4}
NUMBERS = [b"nan", b"inf", b"-inf", b"1e400", b"-1e400", b"1e-400", b"-1", b"0", b"3", b"99", b"2147483648",
           b"4294967295", b"4294967296", b"18446744073709551615", b"99999999999999999999", b"0x10", b"1e5", b"", b"x"]

POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0.5)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 4), (1, 4, 3), (2, 3, 4)]
MOEBIUS_STRIP = [(0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 0, 4), (4, 0, 1)]


def off(points=None, faces=None):
    points, faces = points or POINTS, faces or FACES
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(str, p)) for p in points]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    return ("\n".join(lines) + "\n").encode()


def obj():
    lines = ["# a comment", "o thing"] + ["v " + " ".join(map(str, p)) for p in POINTS] + ["vn 0 0 1", "vt 0 0"]
    lines += ["f " + " ".join(f"{i + 1}/1/1" for i in f) for f in FACES[:3]]
    lines += ["f " + " ".join(str(i - len(POINTS)) for i in f) for f in FACES[3:]]  # counted from the end
    return ("\n".join(lines) + "\n").encode()


def ply(kind, type_of_size="uchar"):
    header = f"ply\nformat {kind} 1.0\ncomment c\nelement vertex {len(POINTS)}\n" \
             "property float x\nproperty float y\nproperty float z\n" \
             f"element face {len(FACES)}\nproperty list {type_of_size} int vertex_indices\nend_header\n"
    if kind == "ascii":
        lines = [" ".join(map(str, p)) for p in POINTS] + [" ".join(map(str, (3, *f))) for f in FACES]
        return (header + "\n".join(lines) + "\n").encode()
    order = "<" if kind == "binary_little_endian" else ">"
    return header.encode() + b"".join(struct.pack(order + "3f", *p) for p in POINTS) \
        + b"".join(struct.pack(order + ("B3i" if type_of_size == "uchar" else "I3i"), 3, *f) for f in FACES)


SOUND = {"a.off": off(), "a.obj": obj(), "ascii.ply": ply("ascii"), "little.ply": ply("binary_little_endian"),
         "big.ply": ply("binary_big_endian"), "wide.ply": ply("binary_little_endian", "uint"),
         "wide_ascii.ply": ply("ascii", "uint")}


def truncated(data):
    """The file cut off at every length."""
    return [data[:n] for n in range(len(data))]


def with_numbers_replaced(data):
    """Each number of the text in turn by each of NUMBERS. (Of binary files, those of the header.)"""
    end = data.find(b"end_header")
    text = data[:end] if b"format binary" in data else data
    return [data[:m.start()] + number + data[m.end():]
            for m in re.finditer(rb"(?<![\w.])-?\d+(\.\d+)?(?![\w.])", text) for number in NUMBERS]


def with_lines_changed(data):
    """Each line left out, and repeated."""
    lines = data.split(b"\n")
    return [b"\n".join(lines[:i] + lines[i + 1:]) for i in range(len(lines))] \
        + [b"\n".join(lines[:i] + [lines[i]] * 2 + lines[i:]) for i in range(len(lines))]


def with_extremes_of_binary(data):
    """Each four bytes of the binary part in turn by integers and floats that are extreme."""
    begin = data.find(b"end_header\n") + len(b"end_header\n")
    if b"format binary" not in data:
        return []
    words = [b"\xff\xff\xff\xff", b"\x7f\xff\xff\xff", b"\xff\xff\xff\x7f", b"\x00\x00\x00\x80", b"\x00\x00\xc0\x7f",
             b"\x7f\x80\x00\x00"]
    return [data[:i] + w + data[i + 4:] for i in range(begin, len(data) - 3) for w in words]


def with_random_damage(data, rounds, generator):
    """Single bits and bytes, several of them, pieces doubled or moved."""
    result = []
    for _ in range(40 * rounds):
        damaged = bytearray(data)
        for _ in range(generator.choice([1, 1, 1, 2, 5])):
            i = generator.randrange(len(damaged))
            kind = generator.randrange(4)
            if kind == 0:
                damaged[i] ^= 1 << generator.randrange(8)
            elif kind == 1:
                damaged[i] = generator.randrange(256)
            elif kind == 2:
                damaged[i:i] = damaged[generator.randrange(len(damaged)):][:generator.randrange(1, 20)]
            else:
                del damaged[i:i + generator.randrange(1, 10)]
                if not damaged:
                    break
        result.append(bytes(damaged))
    return result


def meshes_that_are_none():
    return [off(faces=FACES + [(0, 2, 1)]), off(faces=FACES + [(0, 1, 2)]), off(faces=[(0, 0, 1)]), off(faces=[(0, 1)]),
            off(faces=[(0,)]), off(faces=[(0, 1, 7)]), off(faces=MOEBIUS_STRIP), off(faces=[(0, 1, 2, 3, 4)]),
            off(points=[(1e308, -1e308, 0)] * 5), off(points=[(0, 0, 0)] * 5), b"OFF\n4000000000 1 0\n0 0 0\n",
            b"OFF\n1 4000000000 0\n0 0 0\n", b"OFF BINARY\n" + bytes(100), b"STOFF\n" + off(), b"4OFF\n" + off(),
            b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n"]


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (BYTES_OF_MEMORY, BYTES_OF_MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def fault_of(program, arguments):
    """Runs the program; returns its status and what is wrong with the run, or None."""
    try:
        run = subprocess.run([program, *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, timeout=SECONDS, preexec_fn=limit_memory, check=False)
    except subprocess.TimeoutExpired:
        return None, f"did not end within {SECONDS} s"
    message = run.stderr.decode(errors="replace")
    if run.returncode not in DOCUMENTED:
        return run.returncode, f"status {run.returncode}: {message[:200]}"
    if run.returncode == 2:
        return 2, f"the command line is blamed: {message[:200]}"
    if run.returncode != 0 and "surface_mesh_geodesics: error: " not in message:
        return run.returncode, f"no message: {message[:200]}"
    if run.returncode == 1 and "not enough memory" in message:
        return 1, "a small file takes more than a GB"
    return run.returncode, None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=1, help="the amount of random damage")
    parser.add_argument("--share", type=int, default=1, help="only each of so many files, chosen at random")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    generator = random.Random(arguments.seed)
    print(f"seed {arguments.seed}, {arguments.rounds} rounds")
    files = [("none.off", data) for data in meshes_that_are_none()]
    for name, data in SOUND.items():
        for damaged in (truncated(data), with_numbers_replaced(data), with_lines_changed(data),
                        with_extremes_of_binary(data), with_random_damage(data, arguments.rounds, generator)):
            files += [(name, d) for d in generator.sample(damaged, -(-len(damaged) // arguments.share))]
    status_of_sound = set()
    for name, data in SOUND.items():
        path = arguments.folder / name
        path.write_bytes(data)
        status_of_sound.add(fault_of(arguments.program, ["distances", str(path), "--source", "0"]))
    assert status_of_sound == {(0, None)}, status_of_sound
    counts = collections.Counter()
    faults = 0
    for name, data in files:
        path = arguments.folder / name
        path.write_bytes(data)
        for command in (["info", str(path)], ["distances", str(path), "--source", "0"]):
            status, fault = fault_of(arguments.program, command)
            counts[status] += 1
            if fault is not None:
                faults += 1
                kept = arguments.folder / f"fault_{faults}{path.suffix}"
                kept.write_bytes(data)
                print(f"FAILED: {command[0]} {kept}: {fault}")
    assert counts[0] > 0 and counts[3] > 0, counts
    print(f"{len(files)} damaged files; runs by status: "
          + ", ".join(f"{status}: {n}" for status, n in sorted(counts.items(), key=str)) + f"; {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
