#!/usr/bin/env python3
"""Checks that the tests find faults: puts one fault at a time into the headers and runs tests until one fails.

Usage: check_mutations.py [--jobs N] [NAME...]   tries all mutants, or the named ones in this order
       check_mutations.py --list                 prints the name and the fault of each mutant
       check_mutations.py --check-table          checks that each header still has the text that a mutant replaces, once
       check_mutations.py --self-test            tests this program itself

mutants.py lists the mutants: a header, a text that occurs in it once, its replacement, why that is a fault, and the
tests that should find it. The script works on a copy of the sources and changes nothing in place. A test catches a
mutant if it fails, crashes, or needs far more time or memory than without the fault. An equivalent mutant changes no
answer: it has a reason in the table and is expected to survive. A mutant that does not compile, and a test that fails
without a fault, are mistakes in the table and not results.

Succeeds if the tests catch at least 95 % of the mutants that are not equivalent, and all survivors are equivalent.

The environment variable CXX is the compiler (g++), WORK_FOLDER the work folder (build/mutation). The headers of CGAL
are compiled once for all mutants; a mutant costs about ten seconds for each test that it needs, and the run of the test.
"""

import argparse
import concurrent.futures
import dataclasses
import hashlib
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.dont_write_bytecode = True

# At least this share of the mutants has to be caught.
LEAST_RATE = 0.95

# A test that runs longer than PATIENCE + PATIENCE_FACTOR times its time without a fault, in seconds, hangs.
PATIENCE_FACTOR = 10
PATIENCE = 20

# The most bytes that a test may use.
MEMORY = 6 << 30

# Headers that most tests include and that no mutant changes.
COMMON_HEADERS = ("CGAL/Simple_cartesian.h", "CGAL/Exact_predicates_inexact_constructions_kernel.h",
                  "CGAL/Surface_mesh.h", "CGAL/Polyhedron_3.h", "CGAL/boost/graph/generators.h",
                  "CGAL/boost/graph/IO/polygon_mesh_io.h", "CGAL/AABB_tree.h",
                  "CGAL/Polygon_mesh_processing/measure.h", "algorithm", "iostream", "random", "thread",
                  "unordered_map")

ROOT = pathlib.Path(__file__).resolve().parent.parent


@dataclasses.dataclass(frozen=True)
class Mutant:
    """One fault. `file` is the header below include/. `equivalent` is empty, or says why no test can find the fault."""

    name: str
    file: str
    text: str
    replacement: str
    fault: str
    tests: tuple
    equivalent: str = ""


class Table_error(Exception):
    """A mutant that cannot be tried."""


@dataclasses.dataclass(frozen=True)
class Sources:
    """The folders of headers and test programs, and the options of the compiler. `common` are headers of libraries."""

    include: pathlib.Path
    tests: pathlib.Path
    flags: tuple
    libraries: tuple = ()
    common: tuple = ()


def mutated(mutant, include):
    """The text of the header with the fault."""
    path = include / mutant.file
    if not path.is_file():
        raise Table_error(f"{mutant.file} does not exist")
    text = path.read_text(encoding="utf-8")
    number = text.count(mutant.text)
    if number != 1:
        raise Table_error(f"the text to be replaced occurs {number} times in {mutant.file}: {mutant.text!r}")
    if mutant.text == mutant.replacement:
        raise Table_error("changes nothing")
    return text.replace(mutant.text, mutant.replacement)


def complaints_about(mutants, sources):
    complaints = []
    names = [m.name for m in mutants]
    complaints += [f"{name}: several mutants have this name" for name in sorted(set(names)) if names.count(name) > 1]
    for m in mutants:
        try:
            mutated(m, sources.include)
        except Table_error as error:
            complaints.append(f"{m.name}: {error}")
        complaints += [f"{m.name}: there is no test {t}" for t in m.tests if not (sources.tests / f"{t}.cpp").is_file()]
        if not m.fault or not m.tests:
            complaints.append(f"{m.name}: has no fault, or no tests")
    return complaints


class Laboratory:
    """Compiles tests with a fault and without, and runs them."""

    def __init__(self, sources, folder):
        self.sources = sources
        self.folder = folder
        self.compiler = os.environ.get("CXX", "g++")
        self.lock = threading.Lock()
        self.times = {}  # of tests without a fault, in seconds
        self.locks = {}
        self.has_common = False

    def compile(self, test, overlay, folder):
        """Compiles a test and returns the program. Headers in the folder `overlay` hide those of the package."""
        program = folder / test
        overlays = [f"-I{overlay}"] if overlay else []
        own = [f"-I{self.sources.include}", f"-I{self.sources.tests / 'include'}"]
        source = self.sources.tests / f"{test}.cpp"
        # A test that defines macros defines them before its first include.
        common = [] if "#define" in source.read_text(encoding="utf-8") else self.precompiled()
        self.call_compiler([*common, *overlays, *own, str(source), "-o", str(program), *self.sources.libraries],
                           folder / f"{test}.log", test)
        return program

    def call_compiler(self, arguments, log, what):
        done = subprocess.run([self.compiler, *self.sources.flags, *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            log.write_text(done.stdout, encoding="utf-8")
            raise Table_error(f"{what} does not compile, see {log}")

    def precompiled(self):
        """The arguments for the headers of libraries, which are compiled once. They are half of the work."""
        if not self.sources.common:
            return []
        header = self.folder / "common/common.h"
        with self.lock:
            if not self.has_common:
                header.parent.mkdir(parents=True, exist_ok=True)
                header.write_text("".join(f"#include <{name}>\n" for name in self.sources.common), encoding="utf-8")
                self.call_compiler(["-x", "c++-header", str(header), "-o", f"{header}.gch"],
                                   header.parent / "common.log", "common.h")
                self.has_common = True
        return ["-include", str(header)]

    def run(self, program, folder, limit):
        """Runs a test. Returns '' if it passes, or how it failed, and its time."""
        # Tests read and write files: each run has a folder of its own.
        place = folder / "tests"
        if not place.exists():
            shutil.copytree(self.sources.tests, place)
        start = time.monotonic()
        with open(folder / f"{program.name}.log", "w", encoding="utf-8", errors="replace") as log:
            process = subprocess.Popen([str(program)], cwd=place, stdout=log, stderr=subprocess.STDOUT,
                                       start_new_session=True, preexec_fn=limit_resources)
            try:
                status = process.wait(limit)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                return "does not end", time.monotonic() - start
        passed = time.monotonic() - start
        if status < 0:
            return f"crashes, {signal.Signals(-status).name}", passed
        return ("" if status == 0 else "fails"), passed

    def time_without_fault(self, test):
        """The time of a test without a fault. The test has to pass."""
        with self.lock:
            lock = self.locks.setdefault(test, threading.Lock())
        with lock:
            if test not in self.times:
                self.times[test] = self.known_time(test)
            return self.times[test]

    def known_time(self, test):
        """The time from an earlier run with the same sources, or measured now."""
        folder = self.folder / "without_fault" / test
        record = folder / "seconds"
        state = self.state_of_sources(test)
        if record.is_file():
            known = record.read_text(encoding="utf-8").split()
            if len(known) == 2 and known[0] == state:
                return float(known[1])
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        program = self.compile(test, None, folder)
        failure, seconds = self.run(program, folder, None)
        if failure:
            raise Table_error(f"{test} {failure} without any fault, see {folder / test}.log")
        clean(folder, test)
        record.write_text(f"{state} {seconds:.3f}\n", encoding="utf-8")
        return seconds

    def state_of_sources(self, test):
        """A hash of everything that the program is built from and reads."""
        state = hashlib.sha256(self.compiler.encode())
        files = [p for folder in (self.sources.include, self.sources.tests / "include", self.sources.tests / "data")
                 for p in sorted(folder.rglob("*")) if p.is_file()]
        for path in [*files, self.sources.tests / f"{test}.cpp"]:
            state.update(path.name.encode() + b"\0" + path.read_bytes())
        return state.hexdigest()

    def verdict(self, mutant):
        """The test that catches a mutant, and how; or None."""
        folder = self.folder / "mutants" / mutant.name
        shutil.rmtree(folder, ignore_errors=True)
        overlay = folder / "include"
        header = overlay / mutant.file
        header.parent.mkdir(parents=True)
        header.write_text(mutated(mutant, self.sources.include), encoding="utf-8")
        for test in mutant.tests:
            limit = PATIENCE + PATIENCE_FACTOR * self.time_without_fault(test)
            program = self.compile(test, overlay, folder)
            failure, _ = self.run(program, folder, limit)
            clean(folder, test)
            if failure:
                return test, failure
        return None


def clean(folder, test):
    """Removes the program and its folder. The header and the output of the run stay."""
    (folder / test).unlink(missing_ok=True)
    shutil.rmtree(folder / "tests", ignore_errors=True)


def limit_resources():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


@dataclasses.dataclass
class Tally:
    caught: int = 0
    equivalent: int = 0
    survivors: list = dataclasses.field(default_factory=list)
    wrongly_equivalent: list = dataclasses.field(default_factory=list)
    errors: list = dataclasses.field(default_factory=list)

    def is_good(self):
        number = self.caught + len(self.survivors)
        return (not self.survivors and not self.wrongly_equivalent and not self.errors
                and self.caught >= LEAST_RATE * number)

    def print(self):
        number = self.caught + len(self.survivors)
        for name, error in self.errors:
            print(f"ERROR {name}: {error}")
        if self.survivors:
            print("survivors that are not listed as equivalent: " + ", ".join(self.survivors))
        if self.wrongly_equivalent:
            print("listed as equivalent, but caught: " + ", ".join(self.wrongly_equivalent))
        rate = 100 * self.caught / number if number > 0 else 100
        print(f"{self.caught} of {number} mutants caught ({rate:.1f} %), {self.equivalent} more are equivalent")


def try_mutants(mutants, laboratory, jobs):
    """Tries all mutants and prints a line for each, in their order."""
    tally = Tally()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for mutant, future in [(m, pool.submit(laboratory.verdict, m)) for m in mutants]:
            try:
                verdict = future.result()
            except Table_error as error:
                tally.errors.append((mutant.name, error))
                print(f"{mutant.name}: ERROR, {error}", flush=True)
                continue
            if verdict is not None:
                print(f"{mutant.name}: caught by {verdict[0]}, which {verdict[1]}", flush=True)
            else:
                print(f"{mutant.name}: survived" + (f" (equivalent: {mutant.equivalent})" if mutant.equivalent else ""),
                      flush=True)
            if verdict is not None and mutant.equivalent:
                tally.wrongly_equivalent.append(mutant.name)
            elif verdict is not None:
                tally.caught += 1
            elif mutant.equivalent:
                tally.equivalent += 1
            else:
                tally.survivors.append(mutant.name)
    return tally


def sources_of_package(root):
    flags = ["-std=c++17", "-O1", "-frounding-math", "-w"]
    if pathlib.Path("/usr/include/eigen3").is_dir():
        flags.append("-I/usr/include/eigen3")
    return Sources(root / "include", root / "test/Surface_mesh_geodesics", tuple(flags),
                   ("-lgmp", "-lmpfr", "-pthread"), COMMON_HEADERS)


def copy_of_sources(sources, folder):
    """A copy of the sources, so that work on them can go on."""
    copy = folder / "sources"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(sources.include, copy / "include")
    shutil.copytree(sources.tests, copy / "tests")
    return Sources(copy / "include", copy / "tests", sources.flags, sources.libraries, sources.common)


# --- self-test -------------------------------------------------------------------------------------------------------

HEADER = """inline int twice(int n)
{
  int sum = 0;
  for(int i = 0; i < 2; ++i)
    sum += n; // n again
  return sum;
}
"""

PROGRAMS = {
    "test_twice": '#include "twice.h"\nint main() { return twice(3) == 6 ? 0 : 1; }\n',
    "test_zero": '#include "twice.h"\nint main() { return twice(0) == 0 ? 0 : 1; }\n',
    "test_wrong": '#include "twice.h"\nint main() { return twice(3) == 7 ? 0 : 1; }\n',
}


def small(name, text, replacement, tests=("test_twice",), equivalent=""):
    return Mutant(name, "twice.h", text, replacement, "for the self-test", tuple(tests), equivalent)


# For each mutant of the small header: words of its line, and whether the check succeeds.
EXPECTED = [
    (small("caught", "i < 2", "i < 3"), "caught by test_twice, which fails", True),
    (small("second test", "i < 2", "i < 3", ("test_zero", "test_twice")), "caught by test_twice", True),
    (small("crash", "return sum;", "return *static_cast<volatile int*>(nullptr);"), "which crashes", True),
    (small("hang", "return sum;", "for(volatile int i = 0;;) ++i;"), "which does not end", True),
    (small("nothing changed", "n again", "n once more"), "survived", False),
    (small("equivalent", "i < 2", "i <= 1", equivalent="the same numbers"), "survived (equivalent: the same", True),
    (small("not equivalent", "i < 2", "i < 3", equivalent="wrong"), "caught by test_twice", False),
    (small("not there", "i < 4", "i < 3"), "ERROR, the text to be replaced occurs 0 times", False),
    (small("not once", "sum", "n"), "ERROR, the text to be replaced occurs 3 times", False),
    (small("the same", "i < 2", "i < 2"), "ERROR, changes nothing", False),
    (small("no program", "i < 2", "i < "), "ERROR, test_twice does not compile", False),
    (small("bad test", "i < 2", "i < 3", ("test_wrong",)), "ERROR, test_wrong fails without any fault", False),
]


def self_test():
    global PATIENCE
    PATIENCE = 2
    failures = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        sources = Sources(folder / "include", folder / "tests", ("-O0", "-w"))
        for path, text in [(sources.include / "twice.h", HEADER),
                           *((sources.tests / f"{n}.cpp", t) for n, t in PROGRAMS.items())]:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8")
        for mutant, words, succeeds in EXPECTED:
            lines = []
            tally = run_quietly(lambda m=mutant: try_mutants([m], Laboratory(sources, folder / "work"), 1), lines)
            if words not in "".join(lines):
                failures.append(f"{mutant.name}: {''.join(lines).strip()!r} instead of {words!r}")
            if tally.is_good() != succeeds:
                failures.append(f"{mutant.name}: the check {'fails' if succeeds else 'succeeds'}")
        table = [m for m, words, _ in EXPECTED if "to be replaced" in words or "nothing" in words]
        if len(complaints_about(table + [EXPECTED[0][0]] * 2, sources)) != len(table) + 1:
            failures.append("complaints about a table")
        if (sources.include / "twice.h").read_text(encoding="utf-8") != HEADER:
            failures.append("a header has been changed in place")
    for failure in failures:
        print(failure)
    print(f"self-test: {len(EXPECTED)} mutants, {len(failures)} failures")
    return 1 if failures else 0


def run_quietly(function, lines):
    """Runs a function and collects what it prints."""

    class Collector:
        def write(self, text):
            lines.append(text)

        def flush(self):
            pass

    standard, sys.stdout = sys.stdout, Collector()
    try:
        return function()
    finally:
        sys.stdout = standard


# ---------------------------------------------------------------------------------------------------------------------


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--jobs", type=int, default=1, help="the number of mutants at a time")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--check-table", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    if arguments.self_test:
        return self_test()

    import mutants as table
    mutants = [Mutant(*row) for row in table.MUTANTS]
    unknown = set(arguments.names) - {m.name for m in mutants}
    if unknown:
        parser.error("unknown mutants: " + ", ".join(sorted(unknown)))
    if arguments.names:
        mutants = sorted((m for m in mutants if m.name in arguments.names), key=lambda m: arguments.names.index(m.name))
    if arguments.list:
        for m in mutants:
            print(f"{m.name} ({m.file.rsplit('/', 1)[-1]}): {m.fault}")
        print(f"{len(mutants)} mutants")
        return 0

    sources = sources_of_package(ROOT)
    complaints = complaints_about(mutants, sources)
    for complaint in complaints:
        print(complaint)
    if complaints or arguments.check_table:
        print(f"{len(mutants)} mutants, {len(complaints)} complaints")
        return 1 if complaints else 0
    folder = pathlib.Path(os.environ.get("WORK_FOLDER", ROOT / "build/mutation")).resolve()
    tally = try_mutants(mutants, Laboratory(copy_of_sources(sources, folder), folder), arguments.jobs)
    tally.print()
    return 0 if tally.is_good() else 1


if __name__ == "__main__":
    sys.exit(main())
