#!/usr/bin/env python3
"""Makes plots and tables of the results of run_benchmark.sh.

Usage: plot_benchmark.py FOLDER_WITH_CSV OUTPUT_FOLDER

Reads those of these files that exist: growth.csv, anisotropy.csv, sources.csv, reach.csv, rules.csv, face_queries.csv,
threads.csv, matrix.csv and against_shortest_path_all.csv. Writes an SVG file of the same name for each of them and
tables.md, with the tables of the manual. The description of an SVG file has the lines of the CSV file, and so the
numbers that the plot shows.
"""

import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)
from matplotlib.ticker import NullFormatter, ScalarFormatter  # noqa: E402

# The same numbers give the same bits: files have no date and no random names.
matplotlib.rcParams["svg.hashsalt"] = "Surface_mesh_geodesics"
matplotlib.rcParams["svg.fonttype"] = "none"
matplotlib.rcParams["font.size"] = 9
matplotlib.rcParams["axes.grid"] = True
matplotlib.rcParams["axes.axisbelow"] = True
matplotlib.rcParams["grid.linewidth"] = 0.4
matplotlib.rcParams["axes.spines.top"] = False
matplotlib.rcParams["axes.spines.right"] = False


def read(path):
    """Returns the comment lines of a file, and the lines of its table."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    return [line[2:] for line in lines if line.startswith("# ")], [line for line in lines if not line.startswith("#")]


def rows_of(lines):
    """Returns the rows of a table as dictionaries. Values that look like numbers become numbers."""
    rows = []
    for row in csv.DictReader(lines):
        for key, value in row.items():
            try:
                row[key] = float(value)
            except (TypeError, ValueError):
                pass
        rows.append(row)
    return rows


def groups(rows, key):
    """Groups the rows by the value of a column, in the order of appearance."""
    result = {}
    for row in rows:
        result.setdefault(row[key], []).append(row)
    return result


def plain_axis(axis):
    axis.set_major_formatter(ScalarFormatter())
    axis.set_minor_formatter(NullFormatter())


def error_bars(axes, x, rows, name, **style):
    middle = [row[name] for row in rows]
    low = [row[name] - row[name + "_min"] for row in rows]
    high = [row[name + "_max"] - row[name] for row in rows]
    axes.errorbar(x, middle, yerr=[low, high], marker="o", markersize=4, capsize=2, linewidth=1.2, **style)


def save(figure, path, lines):
    """Writes a figure with its table as the description. The same numbers give the same bits."""
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None, "Description": "\n".join(lines)})
    plt.close(figure)


def draw_file(name, source, path):
    """Draws the plot of a question from a CSV file. Returns its title, the comments of the file, and its table."""
    comments, lines = read(source)
    figure, title, text = QUESTIONS[name](rows_of(lines))
    save(figure, path, lines)
    return title, comments, text


def number(value, digits=1):
    """Formats a number for a table."""
    if isinstance(value, str):
        return value
    if value == int(value) and digits == 0:
        return f"{int(value):,}"
    return f"{value:,.{digits}f}"


def table(columns, rows):
    """Returns a table in Markdown. `columns` are pairs of a heading and a function of a row."""
    lines = ["| " + " | ".join(head for head, _ in columns) + " |", "|" + "--:|" * len(columns)]
    for row in rows:
        lines.append("| " + " | ".join(cell(row) for _, cell in columns) + " |")
    return "\n".join(lines)


def spread(name):
    return lambda row: f"{number(row[name])} ({number(row[name + '_min'])}–{number(row[name + '_max'])})"


# --- one function for each question; it returns a figure, a title and a table ----------------------------------------


def growth(rows):
    figure, (time, windows, memory) = plt.subplots(1, 3, figsize=(10, 3.2))
    for mesh, of_mesh in groups(rows, "mesh").items():
        if len(of_mesh) < 2:
            continue
        faces = [row["faces"] for row in of_mesh]
        error_bars(time, faces, of_mesh, "run_ms", label=f"{mesh}: propagation")
        error_bars(time, faces, of_mesh, "read_ms", label=f"{mesh}: reading the mesh")
        windows.plot(faces, [row["windows_per_face"] for row in of_mesh], marker="o", markersize=4, label=mesh)
        first = of_mesh[0]
        root = [first["windows_per_face"] * (f / first["faces"]) ** 0.5 for f in faces]
        windows.plot(faces, root, linestyle=":", color="gray", label="square root of the number of faces")
        memory.plot(faces, [row["mesh_bytes_per_face"] for row in of_mesh], marker="o", markersize=4,
                    label="mesh and results")
        memory.plot(faces, [row["window_mb"] * 2**20 / row["faces"] for row in of_mesh], marker="s", markersize=4,
                    label="windows")
    for axes in (time, windows, memory):
        axes.set_xscale("log")
        axes.set_xlabel("faces")
    time.set_yscale("log")
    windows.set_ylim(bottom=0)
    time.set_ylabel("processor time, ms")
    windows.set_ylabel("windows per face")
    memory.set_ylabel("bytes per face")
    memory.set_ylim(bottom=0)
    for axes in (time, windows, memory):
        axes.legend(fontsize=7)
    return figure, "Growth", table([
        ("mesh", lambda r: f"{r['mesh']}, level {int(r['subdivisions'])}"),
        ("faces", lambda r: number(r["faces"], 0)),
        ("reading the mesh, ms", spread("read_ms")),
        ("propagation, ms", spread("run_ms")),
        ("share of reading", lambda r: f"{100 * r['read_share']:.0f} %"),
        ("windows", lambda r: number(r["windows"], 0)),
        ("windows per face", lambda r: number(r["windows_per_face"])),
        ("ns per window", lambda r: number(r["ns_per_window"])),
        ("bytes per face", lambda r: number(r["mesh_bytes_per_face"], 0)),
        ("windows, MB", lambda r: number(r["window_mb"])),
    ], rows)


def anisotropy(rows):
    figure, axes = plt.subplots(figsize=(4, 3))
    axes.plot([row["stretch"] for row in rows], [row["ns_per_window"] for row in rows], marker="o", markersize=4)
    axes.set_xscale("log", base=2)
    axes.set_xticks([row["stretch"] for row in rows], [f"{row['stretch']:g}" for row in rows])
    axes.set_ylim(bottom=0)
    axes.set_xlabel("stretch of the torus")
    axes.set_ylabel("ns per window")
    return figure, "Anisotropy", table([
        ("stretch", lambda r: number(r["stretch"], 0)),
        ("run, ms", spread("run_ms")),
        ("windows", lambda r: number(r["windows"], 0)),
        ("ns per window", lambda r: number(r["ns_per_window"])),
    ], rows)


def sources(rows):
    figure, axes = plt.subplots(figsize=(4, 3))
    for mesh, of_mesh in groups(rows, "mesh").items():
        error_bars(axes, [row["sources"] for row in of_mesh], of_mesh, "run_ms", label=mesh)
    axes.set_xscale("log")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("sources")
    axes.set_ylabel("processor time, ms")
    axes.legend(fontsize=7)
    return figure, "Number of sources", table([
        ("mesh", lambda r: r["mesh"]),
        ("sources", lambda r: number(r["sources"], 0)),
        ("run, ms", spread("run_ms")),
        ("windows", lambda r: number(r["windows"], 0)),
    ], rows)


def reach(rows):
    figure, axes = plt.subplots(figsize=(4.5, 3.2))
    for (faces, of_size), style in zip(groups(rows, "faces").items(), ["-", "--", ":"]):
        for end, of_end in groups(of_size, "end").items():
            axes.plot([row["vertices_reached"] for row in of_end], [row["run_ms"] for row in of_end], marker=".",
                      linestyle=style, label=f"{int(faces):,} faces, {end}")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("vertices reached")
    axes.set_ylabel("processor time, ms")
    axes.legend(fontsize=7)
    return figure, "Computations that end early", table([
        ("mesh", lambda r: f"{r['mesh']}, {int(r['faces']):,} faces"),
        ("end", lambda r: r["end"]),
        ("part of the largest distance", lambda r: f"{r['part_of_largest_distance']:g}"),
        ("run, ms", lambda r: number(r["run_ms"], 3)),
        ("vertices reached", lambda r: number(r["vertices_reached"], 0)),
        ("µs per vertex", lambda r: number(r["us_per_vertex"], 2)),
    ], rows)


def rules(rows):
    meshes = groups(rows, "mesh")
    figure, (windows, time) = plt.subplots(1, 2, figsize=(9, 3.2))
    names = list(groups(rows, "rules"))
    width = 0.8 / len(meshes)
    for i, (mesh, of_mesh) in enumerate(meshes.items()):
        x = [names.index(row["rules"]) + i * width for row in of_mesh]
        windows.bar(x, [row["windows_per_face"] for row in of_mesh], width, label=mesh)
        time.bar(x, [row["run_ms"] for row in of_mesh], width, label=mesh)
    for axes, label in ((windows, "windows per face"), (time, "processor time, ms")):
        axes.set_xticks([i + 0.4 - width / 2 for i in range(len(names))])
        axes.set_xticklabels(names, rotation=20, ha="right")
        axes.set_yscale("log")
        axes.set_ylabel(label)
        axes.legend(fontsize=7)
    return figure, "Rules left out", table([
        ("mesh", lambda r: r["mesh"]),
        ("rules", lambda r: r["rules"]),
        ("run, ms", spread("run_ms")),
        ("windows propagated", lambda r: number(r["windows_propagated"], 0)),
        ("windows per face", lambda r: number(r["windows_per_face"])),
        ("windows alive", lambda r: number(r["windows_alive"], 0)),
    ], rows)


def speedups(rows, label, title, columns):
    figure, axes = plt.subplots(figsize=(4, 3))
    most = 1
    for key, of_key in groups(rows, label).items():
        parallel = [row for row in of_key if not isinstance(row["threads"], str)]
        if not parallel:
            continue
        most = max(most, int(max(row["threads"] for row in parallel)))
        axes.plot([row["threads"] for row in parallel], [row["speedup"] for row in parallel], marker="o", markersize=4,
                  label=f"{int(key):,} faces" if label == "faces" else key)
    axes.plot([1, most], [1, most], linestyle=":", color="gray", label="as many times as threads")
    axes.set_xticks(range(1, most + 1) if most <= 8 else [2**k for k in range(most.bit_length())])
    axes.set_ylim(bottom=0)
    axes.set_xlabel("threads")
    axes.set_ylabel("speedup over the sequential run")
    axes.legend(fontsize=7)
    threads = ("threads", lambda r: r["threads"] if isinstance(r["threads"], str) else number(r["threads"], 0))
    time = "call_ms" if "call_ms" in rows[0] else "run_ms"
    return figure, title, table(columns + [
        threads, (time.replace("_", ", "), spread(time)), ("speedup", lambda r: number(r["speedup"], 2))], rows)


def face_queries(rows):
    all_sources = groups(rows, "sources")
    figure, all_axes = plt.subplots(1, len(all_sources), figsize=(3.2 * len(all_sources), 3),
                                    sharey=True, squeeze=False)
    numbers = [1, 10, 100, 1000, 100000]
    for axes, (sources, of_sources) in zip(all_axes[0], all_sources.items()):
        for row in of_sources:
            axes.plot(numbers, [row[f"total_{n}_ms"] for n in numbers], marker=".", label=row["alternative"])
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel(f"queries in faces, {int(sources)} source" + ("s" if sources > 1 else ""))
    all_axes[0][0].set_ylabel("processor time with building, ms")
    all_axes[0][0].legend(fontsize=7)
    return figure, "Queries in faces", table([
        ("sources", lambda r: number(r["sources"], 0)),
        ("windows are kept", lambda r: "never" if r["alternative"] == "backward" else r["alternative"]),
        ("build, ms", lambda r: number(r["build_ms"], 0)),
        ("first query, ms", lambda r: number(r["first_query_ms"], 3)),
        ("next queries, µs", lambda r: number(r["query_us"], 1)),
        ("memory built, MB", lambda r: number(r["memory_built_mb"])),
        ("memory at the end, MB", lambda r: number(r["memory_end_mb"])),
        ("keeping pays from", lambda r: number(r["break_even_queries"], 0)),
    ], rows)


def threads_of_one_source(rows):
    return speedups(rows, "faces", "Threads for one source", [("faces", lambda r: number(r["faces"], 0))])


def matrix(rows):
    return speedups(rows, "matrix", "Threads for a matrix",
                    [("matrix", lambda r: r["matrix"]), ("rows", lambda r: number(r["rows"], 0))])


def against(rows):
    rows = sorted((row for row in rows if row["time_ratio"] != ""), key=lambda row: row["time_ratio"])
    figure, axes = plt.subplots(figsize=(6, 0.16 * len(rows) + 1))
    axes.barh([row["mesh"] for row in rows], [row["time_ratio"] for row in rows])
    axes.set_xlabel("time of Surface_mesh_shortest_path / time of geodesic_distances()")
    axes.tick_params(axis="y", labelsize=6)
    return figure, "Ratios against Surface_mesh_shortest_path", table([
        ("mesh", lambda r: r["mesh"]),
        ("faces", lambda r: number(r["faces"], 0)),
        ("original, ms", spread("original_ms")),
        ("ours, ms", spread("ours_ms")),
        ("ratio", lambda r: number(r["time_ratio"])),
    ], rows)


QUESTIONS = {
    "growth": growth,
    "anisotropy": anisotropy,
    "sources": sources,
    "reach": reach,
    "rules": rules,
    "face_queries": face_queries,
    "threads": threads_of_one_source,
    "matrix": matrix,
    "against_shortest_path_all": against,
}


def main(arguments):
    if len(arguments) != 2:
        print(__doc__)
        return 2
    source, target = pathlib.Path(arguments[0]), pathlib.Path(arguments[1])
    target.mkdir(parents=True, exist_ok=True)
    sections = []
    for name in QUESTIONS:
        path = source / (name + ".csv")
        if not path.exists():
            continue
        if len(read(path)[1]) < 2:
            continue
        title, comments, text = draw_file(name, path, target / (name + ".svg"))
        sections.append(f"## {title}\n\n" + "".join(f"- {line}\n" for line in comments) + f"\n{text}\n")
    (target / "tables.md").write_text("\n".join(sections), encoding="utf-8")
    print(f"{len(sections)} plots and tables in {target}")
    return 0 if sections else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
