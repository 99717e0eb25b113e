#!/usr/bin/env python3
"""Checks that every measured figure in the README and in the manual agrees with the committed results of the benchmark.

Usage: check_figures.py                   checks
       check_figures.py --update          rewrites tables and figures, then checks
       check_figures.py --take FOLDER     copies what run_benchmark.sh has written to FOLDER (usually build/benchmark) to
                                          the results, then does the same as --update
       check_figures.py --self-test

A table follows the line `<!-- table: NAME -->`; a figure in a sentence follows the comment `<!-- figure: NAME -->`.
measured_figures.py computes both. The check complains about a table or a figure that differs from the results, an
unknown name, a table with numbers that has no mark, a table with text right below, and results or figures that no
document uses. In Markdown, a mark of a figure must not begin a line, because a comment there ends the paragraph.
"""

import pathlib
import re
import sys
import tempfile

import measured_figures
from complaints import report

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = "benchmark/Surface_mesh_geodesics/results"
PICTURES = "doc/Surface_mesh_geodesics/fig"
MARK = re.compile(r"^<!-- table: (\w+) -->$")
# A table that a program prints; another script, such as check_differences.py, compares it.
PRINTED = re.compile(r"^<!-- printed table: \w+ -->$")
FIGURE = re.compile(r"<!-- figure: (\w+) -->(\d+(?:,\d{3})*(?:\.\d+)*(?:e-?\d+)?)?")
NUMBER = re.compile(r"^[\d.,~ ]*\d[\d.,]*( |$)")


class Contents:
    """What the documents quote: functions that make tables, and one that computes the figures."""

    def __init__(self, tables, figures):
        self.tables = tables
        self.figures = figures


OURS = Contents(measured_figures.TABLES, measured_figures.figures)
DOCUMENTS = ["README.md", "doc/submission/specification.md"] + sorted(
    str(path.relative_to(ROOT)) for path in (ROOT / "doc" / "Surface_mesh_geodesics").glob("*.txt"))


def table_after(lines, begin):
    """The range of lines of the table below a mark. One empty line may separate them."""
    if begin < len(lines) and lines[begin] == "":
        begin += 1
    end = begin
    while end < len(lines) and lines[end].startswith("|"):
        end += 1
    return begin, end


def has_numbers(row):
    return any(NUMBER.match(cell.strip()) for cell in row.strip("|").split("|")[1:])


def check_tables(name, text, tables, results, complaints):
    """Compares the marked tables of a document. Returns the document with the right tables."""
    lines, output, i = text.split("\n"), [], 0
    while i < len(lines):
        if PRINTED.match(lines[i]):
            end = table_after(lines, i + 1)[1]
            output += lines[i:end]
            i = end
            continue
        mark = MARK.match(lines[i])
        if not mark:
            if lines[i].startswith("|") and has_numbers(lines[i]):
                complaints.append(f"{name}:{i + 1}: a table with numbers and without a mark <!-- table: ... -->")
            output.append(lines[i])
            i += 1
            continue
        if mark.group(1) not in tables:
            complaints.append(f"{name}:{i + 1}: unknown table {mark.group(1)}")
            output.append(lines[i])
            i += 1
            continue
        begin, end = table_after(lines, i + 1)
        wanted = tables[mark.group(1)](results)
        for k in range(max(len(wanted), end - begin)):
            found = lines[begin + k] if begin + k < end else "no line"
            row = wanted[k] if k < len(wanted) else "no line"
            if found != row:
                complaints.append(f"{name}:{begin + k + 1}: table {mark.group(1)}\n  says     {found}\n"
                                  f"  measured {row}")
        output += [lines[i], ""] + wanted
        if end < len(lines) and lines[end] != "": # the text would become a row of the table
            complaints.append(f"{name}:{end + 1}: no empty line below the table {mark.group(1)}")
            output.append("")
        i = end
    return "\n".join(output)


def check_figures(name, text, figures, quoted, complaints):
    """Compares the marked figures of a document. Returns the document with the right figures."""
    def right(match):
        figure, number = match.groups()
        line = text.count("\n", 0, match.start()) + 1
        quoted.add(figure)
        if name.endswith(".md") and text[:match.start()].rpartition("\n")[2].strip() == "":
            complaints.append(f"{name}:{line}: the mark of {figure} begins a line, which ends the paragraph")
        if figure not in figures:
            complaints.append(f"{name}:{line}: unknown figure {figure}")
            return match.group(0)
        if number != figures[figure]:
            complaints.append(f"{name}:{line}: figure {figure} says {number}, measured {figures[figure]}")
        return f"<!-- figure: {figure} -->{figures[figure]}"
    return FIGURE.sub(right, text)


def check(root, documents, contents):
    """Returns the complaints, and the documents with the right tables and figures."""
    root, complaints, right, quoted = pathlib.Path(root), [], {}, set()
    results = measured_figures.Results(root / RESULTS)
    figures = contents.figures(results)
    for name in documents:
        text = (root / name).read_text(encoding="utf-8")
        text = check_tables(name, text, contents.tables, results, complaints)
        right[name] = check_figures(name, text, figures, quoted, complaints)
    for path in sorted((root / RESULTS).glob("*.csv")):
        if path.stem not in results.used:
            complaints.append(f"{RESULTS}/{path.name}: no document uses these results")
    complaints += [f"no document quotes the figure {name}" for name in figures if name not in quoted]
    return complaints, right


def update(root, documents, contents):
    for name, text in check(root, documents, contents)[1].items():
        (pathlib.Path(root) / name).write_text(text, encoding="utf-8")


def take(folder, root):
    """Copies new results and plots. Results that run_benchmark.sh has not measured stay as they are."""
    files = {f"{RESULTS}/{name}.csv": file for name, file in measured_figures.CSV_FILES.items()}
    for picture, name in measured_figures.PLOTS.items():
        files[f"{PICTURES}/{picture}"] = "plots/" + measured_figures.CSV_FILES[name].replace(".csv", ".svg")
    taken = 0
    for target, file in files.items():
        source = pathlib.Path(folder) / file
        if source.exists():
            (root / target).write_text(source.read_text(encoding="utf-8"), encoding="utf-8")
            print(f"{source} -> {target}")
            taken += 1
    return taken


# --- self-test -------------------------------------------------------------------------------------------------------

TEST_CONTENTS = Contents(
    {"times": lambda results: ["| mesh | ms |", "|---|--:|"]
     + [f"| {row['mesh']} | {float(row['ms']):.1f} |" for row in results.rows("times")]},
    lambda results: {"cow": results.rows("times", mesh="cow")[0]["ms"][:3]})

SOUND_TEXT = """# Title

<!-- table: times -->

| mesh | ms |
|---|--:|
| cow | 1.2 |
| pig | 3.0 |

On the cow it takes <!-- figure: cow -->1.2, or less.

| folder | content |
|---|---|
| test | the tests |

<!-- printed table: answers -->

| program | 1.5 |
|---|---|
| test | 2.5 |
"""
SOUND_TABLE = "# machine\nmesh,ms\ncow,1.234\npig,2.999\n"

# What each fault changes, words of the complaint it raises, and whether an update mends it.
FAULTS = {
    "another number": (("cow | 1.2", "cow | 1.1"), "says     | cow | 1.1 |", True),
    "a line too few": (("| pig | 3.0 |\n", ""), "says     no line", True),
    "a line too many": (("| pig | 3.0 |\n", "| pig | 3.0 |\n| cat | 9.9 |\n"), "measured no line", True),
    "text below": (("3.0 |\n\nOn", "3.0 |\nOn"), "no empty line", True),
    "another figure": (("-->1.2", "-->1.3"), "says 1.3, measured 1.2", True),
    "no number": (("-->1.2,", "-->"), "says None, measured 1.2", True),
    "a mark at the beginning of a line": (("takes <!--", "takes\n<!--"), "begins a line", False),
    "unknown figure": (("figure: cow", "figure: cat"), "unknown figure cat", False),
    "a figure without a mark": (("<!-- figure: cow -->", ""), "no document quotes the figure cow", False),
    "no mark": (("<!-- table: times -->", ""), "without a mark", False),
    "no mark of a printed table": (("<!-- printed table: answers -->", ""), "without a mark", False),
    "unknown table": (("table: times", "table: sizes"), "unknown table sizes", False),
}


def complaints_of(text, table, further_files=()):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / RESULTS).mkdir(parents=True)
        (root / "text.md").write_text(text, encoding="utf-8")
        (root / RESULTS / "times.csv").write_text(table, encoding="utf-8")
        for name in further_files:
            (root / RESULTS / name).write_text(table, encoding="utf-8")
        complaints, right = check(root, ["text.md"], TEST_CONTENTS)
        update(root, ["text.md"], TEST_CONTENTS)
        after = check(root, ["text.md"], TEST_CONTENTS)[0]
        return complaints, right["text.md"], after


def self_test():
    failures = []
    complaints, right, _ = complaints_of(SOUND_TEXT, SOUND_TABLE)
    if complaints or right != SOUND_TEXT:
        failures.append(f"sound text: {complaints}")
    for fault, ((old, new), expected, is_mended) in FAULTS.items():
        complaints, _, after = complaints_of(SOUND_TEXT.replace(old, new, 1), SOUND_TABLE)
        if not any(expected in complaint for complaint in complaints):
            failures.append(f"not found: {fault}")
        if bool(after) == is_mended:
            failures.append(f"after an update: {fault}: {after}")
    complaints, _, after = complaints_of(SOUND_TEXT, SOUND_TABLE.replace("1.234", "1.35"))
    if len(complaints) != 2 or after:
        failures.append(f"new results: {complaints}, after an update: {after}")
    if not any("no document uses" in complaint for complaint in complaints_of(SOUND_TEXT, SOUND_TABLE, ["x.csv"])[0]):
        failures.append("not found: unused results")
    return report(failures, f"self-test: {len(FAULTS) + 2} faults")


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    if len(arguments) == 2 and arguments[0] == "--take":
        if take(arguments[1], ROOT) == 0:
            print(f"no results in {arguments[1]}")
            return 1
        update(ROOT, DOCUMENTS, OURS)
    elif arguments == ["--update"]:
        update(ROOT, DOCUMENTS, OURS)
    elif arguments:
        print(__doc__)
        return 2
    return report(check(ROOT, DOCUMENTS, OURS)[0], f"{len(DOCUMENTS)} documents")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
