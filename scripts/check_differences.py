#!/usr/bin/env python3
"""Checks that the manual has the table of differences from Surface_mesh_shortest_path that a program prints.

Usage: check_differences.py PAGE PROGRAM [VERSION...] | --self-test

The table follows the line `<!-- printed table: differences -->` of the page. The program prints the version of CGAL and
the rows. The column of the other class is compared only for the given versions of CGAL: others may have fixed it.
"""

import subprocess

from complaints import report, run_script

MARK = "<!-- printed table: differences -->"
COLUMN_OF_THE_OTHER_CLASS = 3


def rows(lines):
    """The cells of the lines of a table."""
    return [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in lines if line.startswith("|")]


def table_of_manual(text):
    lines = text.split(MARK, 1)[1].lstrip("\n").splitlines() if MARK in text else []
    end = next((i for i, line in enumerate(lines) if not line.startswith("|")), len(lines))
    return rows(lines[:end])


def faults(shown, printed, compares_other_class):
    if not shown:
        return ["the manual has no table"]
    if len(shown) != len(printed):
        return [f"{len(shown)} rows in the manual, {len(printed)} are printed"]
    result = []
    for a, b in zip(shown, printed):
        if not compares_other_class and len(a) == len(b) > COLUMN_OF_THE_OTHER_CLASS:
            a, b = list(a), list(b)
            a[COLUMN_OF_THE_OTHER_CLASS] = b[COLUMN_OF_THE_OTHER_CLASS] = ""
        if a != b:
            result.append(f"in the manual: {' | '.join(a)}\n     printed: {' | '.join(b)}")
    return result


def self_test():
    manual = f"text\n{MARK}\n\n| a | 1 | q | x | 2 |\n|---|--:|---|---|---|\n\n| b | 1 |\n"
    shown = table_of_manual(manual)
    line = "|---|--:|---|---|---|"
    same, mended = rows(["CGAL 5.5", "| a | 1 | q | x | 2 |", line]), rows(["| a | 1 | q | 2 | 2 |", line])
    cases = {
        "the same table": (faults(shown, same, True), False),
        "another answer of the other class": (faults(shown, mended, True), True),
        "a mended class": (faults(shown, mended, False), False),
        "another answer of ours": (faults(shown, rows(["| a | 1 | q | x | 3 |", line]), False), True),
        "a row too few": (faults(shown, same[:1], False), True),
        "no table": (faults(table_of_manual("no table"), same, False), True),
    }
    complaints = [name for name, (found, is_fault) in cases.items() if bool(found) != is_fault]
    if len(shown) != 2:
        complaints.append("rows below the table are treated as its own")
    return report(complaints, f"self-test: {len(cases)} cases")


def main(page, program, *versions):
    with open(page, encoding="utf-8") as manual:
        shown = table_of_manual(manual.read())
    lines = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
    version = next((line.split()[1] for line in lines if line.startswith("CGAL ")), "")
    return report(faults(shown, rows(lines), version in versions), f"CGAL {version}: {len(shown)} rows")


if __name__ == "__main__":
    run_script(__doc__, self_test, main, range(2, 100))
