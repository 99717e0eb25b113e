#!/usr/bin/env python3
"""Prints the times of the steps of a build and of its tests, the largest first, and the sums.

Usage: print_times.py BUILD_FOLDER [NUMBER]
       print_times.py --self-test

Reads Ninja's log of the last build of each file (.ninja_log; make has no log) and CTest's log of its last run. NUMBER
limits the lines of each list (default: 12). Times are seconds on the clock, of one job among several.
"""

import pathlib
import re
import tempfile

from complaints import report, run_script

OBJECT = re.compile(r"CMakeFiles/(?P<target>[^/]+)\.dir/(?:.*/)?(?P<file>[^/]+)\.o(bj)?$")
TEST = re.compile(r'^\d+/\d+ Test(?:ing)?: (?P<name>.+)$|^Test time = +(?P<seconds>[0-9.]+) sec', re.MULTILINE)


def times_of_build(folder):
    """Pairs of seconds and a name. A file that was built more than once counts with its last time."""
    log = folder / ".ninja_log"
    if not log.is_file():
        return []
    seconds = {}
    for line in log.read_text(encoding="utf-8").splitlines():
        fields = line.split("\t")
        if line.startswith("#") or len(fields) < 4:
            continue
        match = OBJECT.search(fields[3])
        name = f"{match['target']}: {match['file']}" if match else f"link or make {fields[3]}"
        seconds[name] = (int(fields[1]) - int(fields[0])) / 1000.0
    return [(time, name) for name, time in seconds.items()]


def times_of_tests(folder):
    log = folder / "Testing/Temporary/LastTest.log"
    if not log.is_file():
        return []
    times, name = [], None
    for match in TEST.finditer(log.read_text(encoding="utf-8", errors="replace")):
        if match["name"]:
            name = match["name"]
        elif name:
            times.append((float(match["seconds"]), name))
            name = None
    return times


def lines_of(title, times, number):
    if not times:
        return [f"{title}: no times are noted"]
    total = sum(time for time, _ in times)
    lines = [f"{title}: {len(times)}, {total:.0f} s in all, one after the other; the longest:"]
    return lines + [f"{time:9.1f} s  {name}" for time, name in sorted(times, reverse=True)[:number]]


def print_times(folder, number):
    lines = lines_of("Built files", times_of_build(folder), number) + lines_of("Tests", times_of_tests(folder), number)
    print("\n".join(lines))


# --- self-test -------------------------------------------------------------------------------------------------------

NINJA_LOG = """# ninja log v5
0\t500\t0\ttest/CMakeFiles/tests_1.dir/tests_1.cpp.o\t1
0\t2500\t0\ttest/CMakeFiles/tests_1.dir/tests_1.cpp.o\t1
2500\t2600\t0\ttest/tests_1\t2
"""
TEST_LOG = """1/2 Testing: plots
Output:
Test time =   0.25 sec
2/2 Testing: header/g++/a.h
Test time =   7.50 sec
"""


def self_test():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        found = [lines_of("Tests", times_of_tests(folder), 9)]
        (folder / ".ninja_log").write_text(NINJA_LOG, encoding="utf-8")
        (folder / "Testing/Temporary").mkdir(parents=True)
        (folder / "Testing/Temporary/LastTest.log").write_text(TEST_LOG, encoding="utf-8")
        found += [sorted(times_of_build(folder)), sorted(times_of_tests(folder))]
    expected = [
        ["Tests: no times are noted"],
        [(0.1, "link or make test/tests_1"), (2.5, "tests_1: tests_1.cpp")],
        [(0.25, "plots"), (7.5, "header/g++/a.h")],
    ]
    failures = [f"found {f}, expected {e}" for f, e in zip(found, expected) if f != e]
    return report(failures, f"self-test: {len(expected)} cases")


def main(folder, number=12):
    print_times(pathlib.Path(folder), int(number))
    return 0


if __name__ == "__main__":
    run_script(__doc__, self_test, main, [1, 2])
