#!/usr/bin/env python3
"""Checks that an example prints what the manual shows below it.

Usage: check_example_output.py MANUAL_FOLDER DATA_FOLDER PROGRAM | --self-test

In a page of the manual, `\\cgalExample{.../NAME.cpp}` is followed by `\\verbatim`, the command
`$ ../NAME [arguments]`, the output, and `\\endverbatim`. The program runs with these arguments in an empty folder with
data/ in it. Three dots stand for anything in a line, a line of three dots for any number of lines. Numbers with a
point may differ by a part in ten thousand; everything else must be equal.
"""

import os
import pathlib
import re
import shlex
import subprocess
import tempfile

from complaints import report, run_script

TOLERANCE = 1e-4
# Three dots, or a number with a point that no dots follow.
PLACEHOLDER = re.compile(r"(\.\.\.|-?\d+\.\d+(?:e[-+]?\d+)?(?!\d*\.\.\.))")


def shown_run(manual, name):
    """The arguments and the lines of output that the manual shows for an example, or None."""
    begin = manual.find(f"/{name}.cpp}}")
    if begin < 0:
        return None
    end = manual.find("\\cgalExample", begin)
    section = manual[begin:end if end >= 0 else len(manual)]
    block = re.search(r"^\\verbatim\n(.*?)^\\endverbatim$", section, re.DOTALL | re.MULTILINE)
    if block is None:
        return None
    command, *output = block.group(1).splitlines() or [""]
    words = shlex.split(command)
    return (words[2:], output) if words[:2] == ["$", f"../{name}"] else None


def line_matches(shown, printed):
    pattern, expected = "", []
    for i, part in enumerate(PLACEHOLDER.split(shown)):
        if i % 2 == 0:  # the text between the placeholders
            pattern += re.escape(part)
        elif part == "...":
            pattern += ".*"
        else:
            pattern += r"(-?\d+(?:\.\d+)?(?:e[-+]?\d+)?)"  # a whole number is printed without a point
            expected.append(float(part))
    match = re.fullmatch(pattern, printed)
    return match is not None and all(
        abs(float(found) - number) <= TOLERANCE * max(1, abs(number))
        for found, number in zip(match.groups(), expected))


def lines_match(shown, printed):
    if not shown:
        return not printed
    if shown[0] == "...":
        return any(lines_match(shown[1:], printed[i:]) for i in range(len(printed) + 1))
    return bool(printed) and line_matches(shown[0], printed[0]) and lines_match(shown[1:], printed[1:])


def self_test():
    cases = [
        ("a 1.5", "a 1.5", True), ("a 1.5", "a 1.50001", True), ("a 1.5", "a 1.51", False), ("a 15", "a 15", True),
        ("a 15", "a 16", False), ("time: ...", "time: 3 ms", True), ("time: ...", "Time: 3 ms", False),
        ("1.62... %", "1.62295 %", True), ("1.62... %", "1.63 %", False), ("from -1.5", "from 1.5", False),
        ("a\n...\nz", "a\nb\nc\nz", True), ("a\n...\nz", "a\nz", True), ("a\n...\nz", "a\nb", False),
        ("a", "a\nb", False), ("a\nb", "a", False), ("a (b)", "a (b)", True),
    ]
    failures = [case for case in cases if lines_match(case[0].split("\n"), case[1].split("\n")) != case[2]]
    manual = "\\cgalExample{P/a.cpp}\n\\cgalExample{P/b.cpp}\n\n\\verbatim\n$ ../b x 2\nb 1\n\\endverbatim\n"
    if shown_run(manual, "a") is not None or shown_run(manual, "b") != (["x", "2"], ["b 1"]):
        failures.append("the position of the command and the output")
    if any(shown_run(manual.replace(old, new), "b") is not None for old, new in (("../b", "../a"), ("$ ", ""))):
        failures.append("output without its command")
    return report(failures, f"self-test: {len(cases) + 2} cases")


def main(*paths):
    manual, data, program = (pathlib.Path(path).absolute() for path in paths)
    pages = "".join(page.read_text(encoding="utf-8") for page in sorted(manual.glob("*.txt")))
    run = shown_run(pages, program.stem)
    if run is None:
        print(f"{manual}: no page shows a command with its output for {program.stem}")
        return 1
    program_arguments, shown = run
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(data, pathlib.Path(folder) / "data")
        process = subprocess.run([str(program), *program_arguments], cwd=folder, capture_output=True, text=True,
                                 check=False)
    printed = process.stdout.splitlines()
    if process.returncode == 0 and lines_match(shown, printed):
        return 0
    print(f"{program.stem} ends with {process.returncode} and prints", *printed, sep="\n")
    print("\nthe manual shows", *shown, sep="\n")
    return 1


if __name__ == "__main__":
    run_script(__doc__, self_test, main, [3])
