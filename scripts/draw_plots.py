#!/usr/bin/env python3
"""Draws the plots of the manual from the committed results of the benchmark.

Usage: draw_plots.py [FOLDER] | --check | --self-test

The default folder is doc/Surface_mesh_geodesics/fig. --check compares the numbers in the description of each plot with
the results. If matplotlib has the version that has drawn the plot, it also draws the plot again and compares the bits.
Only drawing needs matplotlib (Debian: python3-matplotlib).
"""

import importlib
import pathlib
import re
import sys
import tempfile
import xml.etree.ElementTree

import measured_figures
from complaints import report

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = ROOT / "benchmark" / "Surface_mesh_geodesics" / "results"
FIGURES = ROOT / "doc" / "Surface_mesh_geodesics" / "fig"
DESCRIPTION = "{http://purl.org/dc/elements/1.1/}description"
DRAWN_BY = re.compile(r"Matplotlib v([\d.]+)")


def table(path):
    """The lines of a file with results, without comments."""
    return [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]


def description(picture):
    """The lines of the description of an SVG file."""
    found = xml.etree.ElementTree.parse(picture).getroot().iter(DESCRIPTION)
    return [line for element in found for line in (element.text or "").strip().splitlines()]


def draw(picture, results, path):
    """Draws a plot of the manual into a file."""
    sys.path.insert(0, str(RESULTS.parent))
    plot_benchmark = importlib.import_module("plot_benchmark")
    name = pathlib.Path(measured_figures.CSV_FILES[measured_figures.PLOTS[picture]]).stem
    plot_benchmark.draw_file(name, results, path)


def version_of_matplotlib():
    """The version of matplotlib, or None if it is not installed."""
    try:
        return importlib.import_module("matplotlib").__version__
    except ImportError:
        return None


def complaints_about(picture, results, figures):
    """The complaints about one plot."""
    path = figures / picture
    if not path.exists():
        return [f"{picture}: does not exist"]
    if description(path) != table(results):
        return [f"{picture}: shows other numbers than those in {results.name}; run scripts/draw_plots.py"]
    drawn_by = DRAWN_BY.search(path.read_text(encoding="utf-8"))
    if drawn_by is None or drawn_by.group(1) != version_of_matplotlib():
        return []
    with tempfile.TemporaryDirectory() as folder:
        again = pathlib.Path(folder) / picture
        draw(picture, results, again)
        return [] if again.read_bytes() == path.read_bytes() else [f"{picture}: would be drawn differently"]


def check(figures):
    return [complaint for picture, name in measured_figures.PLOTS.items()
            for complaint in complaints_about(picture, RESULTS / (name + ".csv"), figures)]


def self_test():
    """Puts faults into copies of the plots. The check must find each of them."""
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for picture, name in measured_figures.PLOTS.items():
            text = (FIGURES / picture).read_text(encoding="utf-8")
            number = table(RESULTS / (name + ".csv"))[1].split(",")[-1]
            faults = {"another number": text.replace(number, "1" + number, 1),
                      "no description": re.sub(r"(?s)<dc:description>.*</dc:description>", "", text)}
            if DRAWN_BY.search(text).group(1) == version_of_matplotlib():
                faults["another line"] = text.replace('d="M ', 'd="M 1', 1)
            for fault, faulty in faults.items():
                (folder / picture).write_text(faulty, encoding="utf-8")
                if faulty == text or not complaints_about(picture, RESULTS / (name + ".csv"), folder):
                    failures.append(f"not found: {picture}, {fault}")
    return report(failures, f"self-test: {len(measured_figures.PLOTS)} plots")


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    if arguments == ["--check"]:
        return report(check(FIGURES), f"{len(measured_figures.PLOTS)} plots")
    if len(arguments) > 1 or (arguments and arguments[0].startswith("-")):
        print(__doc__)
        return 2
    folder = pathlib.Path(arguments[0]) if arguments else FIGURES
    folder.mkdir(parents=True, exist_ok=True)
    for picture, name in measured_figures.PLOTS.items():
        draw(picture, RESULTS / (name + ".csv"), folder / picture)
    print(f"{len(measured_figures.PLOTS)} plots in {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
