#!/usr/bin/env python3
"""Measures the code: files, lines, comments, functions, assertions.

Usage: measure_code.py [--revision REV] [--against REV] [--functions N]
       measure_code.py --check
       measure_code.py --self-test

  --revision REV   measures that revision of the repository instead of the working tree
  --against REV    prints a second column with the figures of that revision, as the state before
  --functions N    names the N longest functions of each part (default: 3)
  --check          prints what exceeds a limit (LIMITS below), and fails if anything does

Shares of comments are those of the lines with text, without the copyright block. The length of a function is the number
of lines between its braces.
"""

import argparse
import dataclasses
import io
import pathlib
import re
import statistics
import subprocess
import sys
import tarfile
import tempfile

from complaints import report
from cpp_outline import outline

ROOT = pathlib.Path(__file__).resolve().parent.parent
OWN = "include/CGAL/Surface_mesh_geodesics/"
INTERNAL = OWN + "internal/"
PROGRAM_FOLDERS = ("demo", "app", "benchmark", "examples", "test")

# Their bulk is documentation.
LONG_FILES = {OWN + "Surface_mesh_geodesic_paths.h", OWN + "Surface_mesh_geodesic_Voronoi_diagram.h"}
# They contain only includes.
HEADERS_WITHOUT_DOCUMENTATION = {
    "include/CGAL/Surface_mesh_geodesics.h",
    "include/CGAL/license/Surface_mesh_geodesics.h",
}

# In the order of the output.
ORDER_OF_PARTS = ("include", "public", "internal", "demo", "benchmark", "examples", "test")

LIMITS = {
    "lines of a function in include/": 50,
    "lines of a function in test/": 60,
    "90th percentile of the lines of a function in include/": 20,
    "lines of a file": 600,
    "columns of a line": 120,
    "percent of comments in a public header": 40,
    "percent of comments in a room": 20,
    "rooms": 8,
    "percent of include/ in one room": 30,
}

ASSERTION = re.compile(r"CGAL_(assertion|precondition|postcondition)(_msg|_code)?")
EXPENSIVE_ASSERTION = re.compile(r"CGAL_expensive(st)?_(assertion|precondition|postcondition)(_msg|_code)?")


@dataclasses.dataclass
class File:
    name: str
    outline: object
    line_lengths: list

    @property
    def part(self):
        """`public`, the name of a room, or the name of the folder at the top."""
        if self.name.startswith(INTERNAL):
            folders = self.name[len(INTERNAL):].split("/")
            return folders[0] if len(folders) > 1 else "(no room)"
        if self.name.startswith("include/"):
            return "public"
        return "demo" if self.name.startswith("app/") else self.name.split("/")[0]

    @property
    def is_header_of_package(self):
        return self.name.startswith("include/")

    @property
    def comment_percent(self):
        return percent(self.outline.number_of_comment_lines, self.outline.number_of_text_lines)


def percent(part, whole):
    return 100.0 * part / whole if whole else 0.0


def file_of(name, text):
    return File(name, outline(text), [len(line) for line in text.splitlines()])


def read_files(root):
    """The C++ files of the package below `root`."""
    files = []
    for folder in ("include",) + PROGRAM_FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cpp") and path.is_file():
                name = path.relative_to(root).as_posix()
                try:
                    files.append(file_of(name, path.read_text(encoding="utf-8")))
                except ValueError as error:
                    raise SystemExit(f"{name}: {error}") from error
    return files


def read_revision(revision):
    """The files of a revision; of the working tree, if it is None."""
    if revision is None:
        return read_files(ROOT)
    archive = subprocess.run(["git", "-C", str(ROOT), "archive", revision], stdout=subprocess.PIPE, check=True).stdout
    with tempfile.TemporaryDirectory() as folder:
        with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
            members = [each for each in tar.getmembers() if each.name.endswith((".h", ".cpp")) and each.isfile()]
            tar.extractall(folder, members=members)
        return read_files(pathlib.Path(folder))


# --- figures ---------------------------------------------------------------------------------------------------------


def quantile(values, share):
    """The smallest value that at least `share` of the values do not exceed."""
    values = sorted(values)
    return values[max(0, -(-round(share * 1000) * len(values) // 1000) - 1)] if values else 0


def longest_functions(files, number):
    functions = [(function.length, function.name, file) for file in files for function in file.outline.functions]
    functions.sort(key=lambda each: (-each[0], each[1]))
    return [f"{name} {length} ({file.name.split('/')[-1]})" for length, name, file in functions[:number]]


def lines_in_namespace_internal(file):
    return sum(last - first + 1 for name, first, last in file.outline.namespaces if name.split("::")[-1] == "internal")


def number_of_mutable_members(file):
    """Without `mutable` behind the parameters of a lambda."""
    tokens = file.outline.tokens
    return sum(token.text == "mutable" and tokens[i - 1].text not in (")", "]") for i, token in enumerate(tokens))


def number_of_matches(files, pattern):
    return sum(pattern.fullmatch(token.text) is not None for file in files for token in file.outline.tokens)


def figures_of_size(files):
    text = sum(file.outline.number_of_text_lines for file in files)
    comments = sum(file.outline.number_of_comment_lines for file in files)
    return {
        "files": len(files),
        "lines": sum(file.outline.number_of_lines for file in files),
        "lines of the longest file": max((file.outline.number_of_lines for file in files), default=0),
        "comments, %": round(percent(comments, text), 1),
    }


def figures_of_functions(files):
    lengths = [function.length for file in files for function in file.outline.functions]
    figures = {
        "functions": len(lengths),
        "lines of a function: median": statistics.median_low(lengths) if lengths else 0,
        "lines of a function: 90th percentile": quantile(lengths, 0.9),
        "lines of a function: largest": max(lengths, default=0),
    }
    for limit in (35, 50, 60):
        figures[f"functions of more than {limit} lines"] = sum(length > limit for length in lengths)
    return figures


def figures_of_contracts(files):
    return {
        "assertions": number_of_matches(files, ASSERTION),
        "expensive assertions": number_of_matches(files, EXPENSIVE_ASSERTION),
        "mutable members": sum(map(number_of_mutable_members, files)),
    }


def figures_of_public_headers(files):
    """One figure for each header, and what they keep in namespaces called internal."""
    figures = {"lines in namespace internal": sum(map(lines_in_namespace_internal, files))}
    for file in files:
        if file.name not in HEADERS_WITHOUT_DOCUMENTATION:
            figures[f"comments, %: {file.name.split('/')[-1]}"] = round(file.comment_percent, 1)
    return figures


def parts_of(files):
    """The files of each part; `internal` is the sum of the rooms, `include` the sum of all headers."""
    parts = {
        "include": [file for file in files if file.is_header_of_package],
        "public": [file for file in files if file.part == "public"],
        "internal": [file for file in files if file.name.startswith(INTERNAL)],
    }
    for file in sorted(parts["internal"], key=lambda file: file.part):
        parts.setdefault(f"internal/{file.part}", []).append(file)
    for file in files:
        if not file.is_header_of_package:
            parts.setdefault(file.part, []).append(file)
    return parts


def figures_of(files):
    """For each part: a dictionary of figures."""
    parts = parts_of(files)
    lines_of_include = sum(file.outline.number_of_lines for file in parts["include"])
    figures = {}
    for part, files_of_part in parts.items():
        figures[part] = {**figures_of_size(files_of_part), **figures_of_functions(files_of_part)}
        if part in ("include", "public", "internal") or part.startswith("internal/"):
            figures[part].update(figures_of_contracts(files_of_part))
            share = percent(figures[part]["lines"], lines_of_include)
            figures[part]["share of the lines of include/, %"] = round(share, 1)
        if part == "public":
            figures[part].update(figures_of_public_headers(files_of_part))
    return figures


# --- limits ----------------------------------------------------------------------------------------------------------


def complaints_about_functions(files):
    complaints = []
    for file in files:
        folder = "include/" if file.is_header_of_package else "test/"
        if not file.name.startswith(folder):
            continue
        limit = LIMITS[f"lines of a function in {folder}"]
        complaints += [
            f"{file.name}:{function.first_line}: {function.name} has {function.length} lines, at most {limit} are "
            "allowed"
            for function in file.outline.functions if function.length > limit]
    lengths = [function.length for file in files if file.is_header_of_package for function in file.outline.functions]
    limit = LIMITS["90th percentile of the lines of a function in include/"]
    if quantile(lengths, 0.9) > limit:
        complaints.append(f"include/: a tenth of the functions have more than {limit} lines")
    return complaints


def complaints_about_files(files):
    complaints = []
    most_lines = LIMITS["lines of a file"]
    least_percent = LIMITS["percent of comments in a public header"]
    for file in files:
        lines = file.outline.number_of_lines
        if lines > most_lines and file.name not in LONG_FILES:
            complaints.append(f"{file.name}: {lines} lines, at most {most_lines} are allowed")
        documents = file.part == "public" and file.name not in HEADERS_WITHOUT_DOCUMENTATION
        if documents and file.comment_percent < least_percent:
            complaints.append(f"{file.name}: {file.comment_percent:.1f} % are comments, at least {least_percent} % are "
                              "expected of a public header")
    return complaints


def complaints_about_lines(files):
    limit = LIMITS["columns of a line"]
    return [
        f"{file.name}:{number}: {length} columns, at most {limit} are allowed"
        for file in files for number, length in enumerate(file.line_lengths, 1) if length > limit]


def complaints_about_rooms(files):
    complaints = []
    figures = figures_of(files)
    rooms = [part for part in figures if part.startswith("internal/")]
    if len(rooms) < LIMITS["rooms"]:
        complaints.append(f"{INTERNAL}: {len(rooms)} rooms, at least {LIMITS['rooms']} are expected")
    for room in rooms:
        share = figures[room]["share of the lines of include/, %"]
        if share > LIMITS["percent of include/ in one room"]:
            complaints.append(f"{room}: {share} % of the lines of include/, at most "
                              f"{LIMITS['percent of include/ in one room']} % are allowed")
        comments = figures[room]["comments, %"]
        if comments < LIMITS["percent of comments in a room"]:
            complaints.append(f"{room}: {comments} % are comments, at least {LIMITS['percent of comments in a room']} "
                              "% are expected")
    return complaints


def complaints_about(files):
    return (complaints_about_functions(files) + complaints_about_files(files) + complaints_about_lines(files)
            + complaints_about_rooms(files))


# --- output ----------------------------------------------------------------------------------------------------------


def print_figures(files, files_before, number_of_functions):
    figures = figures_of(files)
    before = figures_of(files_before) if files_before is not None else {}
    for part in sorted(set(figures) | set(before), key=lambda part: (ORDER_OF_PARTS.index(part.split("/")[0]), part)):
        print(f"\n{part}")
        values, values_before = figures.get(part, {}), before.get(part, {})
        for key in list(values) + [key for key in values_before if key not in values]:
            columns = [values_before.get(key, "-")] if files_before is not None else []
            columns.append(values.get(key, "-"))
            print(f"  {key:55}" + "".join(f"{column:>10}" for column in columns))
        longest = longest_functions(parts_of(files).get(part, []), number_of_functions)
        if longest:
            print("  longest: " + ", ".join(longest))


# --- self-test -------------------------------------------------------------------------------------------------------

SAMPLE = r"""// Copyright (c) 2026
// All rights reserved.

#include <vector>
// A comment.
namespace CGAL {
namespace internal {

template <class T, class = std::enable_if_t<(sizeof(T) > 1)>>
class Box : public std::vector<T>
{
public:
  explicit Box(T value)
    : std::vector<T>{value}
    , first_{value}, second_(a[b[0]])
  {
    CGAL_assertion(value > 0); // not a comment line
    call([&]() mutable {
      CGAL_expensive_assertion(true);
    });
  }
  ~Box() {}
  bool operator()(int i) const noexcept(noexcept(f(i))) { return i < 3 && "}"[0] == '}'; }
  Box& operator=(const Box& other) = default;
  bool operator==(const Box& other) const
  {
    /* two

       lines */
    return R"(}{)" == 1'000;
  }
private:
  T first_{}, second_ = {1};
  mutable int cache_{0};
  static constexpr auto square = [](int x) { return x * x; };
  enum class Kind { a, b };
};

} // namespace internal

__attribute__((target("avx2"))) inline auto free_function(int x = 3) -> std::array<int, 2>
{
  struct Local
  {
    int f() { return 1; }
  };

  return {1, 2};
}

} // namespace CGAL
"""

SAMPLE_FUNCTIONS = [("Box::Box", 4), ("Box::~Box", 1), ("Box::operator()", 1), ("Box::operator==", 4),
                    ("free_function", 6)]


def check_sample():
    """The figures of the sample above, counted by hand."""
    file = file_of(OWN + "sample.h", SAMPLE)
    found = {
        "functions": [(function.name, function.length) for function in file.outline.functions],
        "comment lines": file.outline.number_of_comment_lines,
        "text lines": file.outline.number_of_text_lines,
        "lines in namespace internal": lines_in_namespace_internal(file),
        "mutable members": number_of_mutable_members(file),
        "assertions": number_of_matches([file], ASSERTION),
        "expensive assertions": number_of_matches([file], EXPENSIVE_ASSERTION),
    }
    expected = {
        "functions": SAMPLE_FUNCTIONS,
        "comment lines": 3,
        "text lines": len([line for line in SAMPLE.splitlines() if line.strip()]) - 2,
        "lines in namespace internal": 33,
        "mutable members": 1,
        "assertions": 1,
        "expensive assertions": 1,
    }
    return [f"{key}: found {found[key]}, expected {expected[key]}" for key in expected if found[key] != expected[key]]


def function_of(lines):
    return "void f()\n{\n" + "  g();\n" * lines + "}\n"


def sound_tree():
    tree = {INTERNAL + f"room_{i}/file.h": "// A comment.\n" * 2 + function_of(4) for i in range(LIMITS["rooms"])}
    tree[OWN + "door.h"] = "// A comment.\n" * 10 + function_of(5)
    tree["test/test_x.cpp"] = function_of(60)
    return tree


# What each fault writes into the tree, and words of the complaint it has to raise.
FAULTS = {
    "long function": ({INTERNAL + "room_0/file.h": function_of(51)}, "f has 51 lines"),
    "long test": ({"test/test_x.cpp": function_of(61)}, "f has 61 lines"),
    "many long functions": ({INTERNAL + f"room_{i}/file.h": function_of(21) for i in range(3)}, "a tenth"),
    "long file": ({"benchmark/x.cpp": "int i;\n" * 601}, "601 lines"),
    "long file of a test": ({"test/x.cpp": "int i;\n" * 601}, "601 lines"),
    "long line": ({"demo/x.cpp": "// " + "x" * 117 + "\n// " + "x" * 118 + "\n"}, "demo/x.cpp:2: 121 columns"),
    "no documentation": ({OWN + "door.h": "// A comment.\n" * 3 + function_of(5)}, "27.3 % are comments"),
    "room without comments": ({INTERNAL + "room_0/file.h": function_of(4)}, "internal/room_0: 0.0 % are comments"),
    "few rooms": ({INTERNAL + "room_0/file.h": None}, "7 rooms"),
    "large room": ({INTERNAL + "room_0/other.h": "int i;\n" * 40}, "internal/room_0: 4"),
}


def complaints_about_tree(tree):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in tree.items():
            path = pathlib.Path(folder) / name
            if text is not None:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
        return complaints_about(read_files(pathlib.Path(folder)))


def self_test():
    failures = check_sample()
    failures += [f"sound tree: {complaint}" for complaint in complaints_about_tree(sound_tree())]
    for fault, (files, words) in FAULTS.items():
        if not any(words in complaint for complaint in complaints_about_tree({**sound_tree(), **files})):
            failures.append(f"not found: {fault}")
    return report(failures, f"self-test: {len(FAULTS)} faults")


def main():
    parser = argparse.ArgumentParser(usage=__doc__, add_help=False)
    parser.add_argument("--revision")
    parser.add_argument("--against")
    parser.add_argument("--functions", type=int, default=3)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if options.self_test:
        return self_test()
    files = read_revision(options.revision)
    if options.check:
        return report(complaints_about(files), f"{len(files)} files")
    before = read_revision(options.against) if options.against else None
    print_figures(files, before, options.functions)
    return 0


if __name__ == "__main__":
    sys.exit(main())
