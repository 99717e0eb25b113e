#!/usr/bin/env python3
"""Checks that every measured figure in the README and in the manual stands in the committed results of the benchmark.

Usage: check_figures.py                   checks
       check_figures.py --update          writes tables and figures anew, and then checks
       check_figures.py --take FOLDER     copies what run_benchmark.sh has written to FOLDER (as a rule build/benchmark)
                                          to the results, and then does the same
       check_figures.py --self-test

Complaints are raised by a table that differs from its CSV file, by a table with numbers that is not marked as a
measured one, by words about measured figures that are not in the text, and by results that nothing refers to. What
belongs where is in measured_figures.py. An update also puts new figures between words that are there; other words, and
numbers that are written as words, are left to an author.
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
# A table that a program prints: another script compares it, as check_differences.py does.
PRINTED = re.compile(r"^<!-- printed table: \w+ -->$")
FIGURE = re.compile(r"(?<![\w.])\d+(?:,\d{3})*(?:\.\d+)?(?:e-?\d+)?(?!\w)")
NUMBER = re.compile(r"^[\d.,~ ]*\d[\d.,]*( |$)")


class Contents:
    """What the documents have to say: functions that make tables, and one that makes sentences."""

    def __init__(self, tables, sentences):
        self.tables = tables
        self.sentences = sentences


OURS = Contents(measured_figures.TABLES, measured_figures.sentences)
DOCUMENTS = [measured_figures.README, measured_figures.MANUAL, measured_figures.SUBMISSION]


def table_after(lines, begin):
    """The range of lines of the table below a mark; one empty line may stand between."""
    if begin < len(lines) and lines[begin] == "":
        begin += 1
    end = begin
    while end < len(lines) and lines[end].startswith("|"):
        end += 1
    return begin, end


def has_numbers(row):
    return any(NUMBER.match(cell.strip()) for cell in row.strip("|").split("|")[1:])


def check_tables(name, text, tables, results, complaints):
    """Compares the marked tables of a document; returns the document with the tables as they should be."""
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
            complaints.append(f"{name}:{i + 1}: there is no table {mark.group(1)}")
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
        i = end
    return "\n".join(output)


def words(text):
    return " ".join(text.split())


def with_figures_of(sentence, text):
    """The text with the figures of a sentence, where it has these words with other figures; lines stay as they are."""
    parts = re.split(f"({FIGURE.pattern})", words(sentence))
    pattern = "".join(f"({FIGURE.pattern})" if i % 2 else re.escape(part).replace("\\ ", r"\s+")
                      for i, part in enumerate(parts))
    matches = list(re.finditer(pattern, text))
    if len(matches) != 1:
        return text
    match = matches[0]
    figures, begin, result = parts[1::2], match.start(), text[:match.start()]
    for i, figure in enumerate(figures, start=1):
        result += text[begin:match.start(i)] + figure
        begin = match.end(i)
    return result + text[begin:]


def check(root, documents, contents):
    """Returns the complaints, and the documents with the tables as they should be."""
    root, complaints, right = pathlib.Path(root), [], {}
    results = measured_figures.Results(root / RESULTS)
    for name in documents:
        text = (root / name).read_text(encoding="utf-8")
        right[name] = check_tables(name, text, contents.tables, results, complaints)
    for name, sentence in contents.sentences(results):
        if words(sentence) not in words((root / name).read_text(encoding="utf-8")):
            complaints.append(f"{name}: does not say\n  {words(sentence)}")
    for path in sorted((root / RESULTS).glob("*.csv")):
        if path.stem not in results.used:
            complaints.append(f"{RESULTS}/{path.name}: nothing refers to these results")
    return complaints, right


def update(root, documents, contents):
    right = check(root, documents, contents)[1]
    for name, sentence in contents.sentences(measured_figures.Results(pathlib.Path(root) / RESULTS)):
        if words(sentence) not in words(right[name]):
            right[name] = with_figures_of(sentence, right[name])
    for name, text in right.items():
        (pathlib.Path(root) / name).write_text(text, encoding="utf-8")


def take(folder, root):
    """Copies new results and plots; those that run_benchmark.sh has not been asked for stay as they are."""
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
    lambda results: [("text.md", f"it takes {results.row('times', mesh='cow')['ms'][:3]} ms")])

SOUND_TEXT = """# Title

<!-- table: times -->

| mesh | ms |
|---|--:|
| cow | 1.2 |
| pig | 3.0 |

On the cow it takes
1.2 ms.

| folder | content |
|---|---|
| test | the tests |

<!-- printed table: answers -->

| program | 1.5 |
|---|---|
| test | 2.5 |
"""
SOUND_TABLE = "# machine\nmesh,ms\ncow,1.234\npig,2.999\n"

# What each fault changes, and words of the complaint it has to raise.
FAULTS = {
    "another number": (("cow | 1.2", "cow | 1.1"), "says     | cow | 1.1 |"),
    "a line too few": (("| pig | 3.0 |\n", ""), "says     no line"),
    "a line too many": (("| pig | 3.0 |\n", "| pig | 3.0 |\n| cat | 9.9 |\n"), "measured no line"),
    "another figure": (("takes\n1.2", "takes\n1.3"), "does not say"),
    "other words": (("it takes", "it took"), "does not say"),
    "no mark": (("<!-- table: times -->", ""), "without a mark"),
    "no mark of a printed table": (("<!-- printed table: answers -->", ""), "without a mark"),
    "unknown table": (("table: times", "table: sizes"), "there is no table sizes"),
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
    for fault, ((old, new), expected) in FAULTS.items():
        complaints, _, after = complaints_of(SOUND_TEXT.replace(old, new, 1), SOUND_TABLE)
        if not any(expected in complaint for complaint in complaints):
            failures.append(f"not found: {fault}")
        if bool(after) != (fault in ("other words", "unknown table") or fault.startswith("no mark")):
            failures.append(f"not mended by an update: {fault}")
    complaints, _, after = complaints_of(SOUND_TEXT, SOUND_TABLE.replace("1.234", "1.35"))
    if len(complaints) != 2 or after:
        failures.append(f"new results: {complaints}, after an update: {after}")
    if not any("nothing refers" in complaint for complaint in complaints_of(SOUND_TEXT, SOUND_TABLE, ["x.csv"])[0]):
        failures.append("not found: results that nothing refers to")
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
