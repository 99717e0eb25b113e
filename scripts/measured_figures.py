"""The measured tables and figures of the README and of the manual, computed from benchmark/.../results.

A document marks a table with a line of its own above it, and a figure in a sentence with a comment before the number:

    <!-- table: NAME -->
    ... is <!-- figure: NAME -->69 times faster ...

TABLES and figures() say what belongs there. check_figures.py compares the documents with them and rewrites them. This
file knows no sentence of any document.
"""

import csv
import math
import pathlib
import re
import statistics

# The name in the results -> the file that run_benchmark.sh writes.
CSV_FILES = {
    "standard_meshes": "against_shortest_path.csv", "all_meshes": "against_shortest_path_all.csv",
    "paths": "paths_against_shortest_path.csv", "heat_method": "against_heat_method.csv",
    "Voronoi_diagram": "voronoi.csv",
} | {name: name + ".csv" for name in (
    "face_queries", "certified_meshes", "growth", "anisotropy", "sources", "reach", "rules", "threads", "matrix")}

# The picture in the manual -> the results that it shows; draw_plots.py draws it.
PLOTS = {"plot_ratios.svg": "all_meshes", "plot_growth.svg": "growth"}


class Results:
    """The CSV files of a folder; remembers which of them have been read."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.used = set()

    def rows(self, name, **wanted):
        """All rows whose columns have the wanted values."""
        self.used.add(name)
        with open(self.folder / (name + ".csv"), encoding="utf-8") as file:
            table = list(csv.DictReader(line for line in file if not line.startswith("#")))
        return [row for row in table if all(row[key] == str(value) for key, value in wanted.items())]

    def comment(self, name, pattern):
        """The first group of a regular expression, in the comments on top of the file."""
        with open(self.folder / (name + ".csv"), encoding="utf-8") as file:
            comments = "".join(line for line in file if line.startswith("#"))
        found = re.search(pattern, comments)
        if not found:
            raise ValueError(f"{name}.csv: no {pattern} in the comments")
        return found.group(1)

    def values(self, name, column, **wanted):
        """A column of these rows, as numbers. Skips empty cells, where nothing was measured."""
        return [float(row[column]) for row in self.rows(name, **wanted) if row[column] != ""]


# --- numbers ---------------------------------------------------------------------------------------------------------


def plain(text, digits=0):
    """A fixed number of digits behind the point, and commas between thousands. Empty text stays empty."""
    return "" if text == "" else f"{float(text):,.{digits}f}"


def rounded(text):
    """Three digits, two below ten, one below a hundredth; never a power of ten."""
    if text == "":
        return ""
    number = float(text)
    if number >= 10:
        return f"{number:,.0f}" if number >= 99.95 else f"{number:.1f}"
    digits = 1 if number == 0 else 1 - math.floor(math.log10(number) + 1e-9)
    text = f"{number:.{digits}f}"
    return text.rstrip("0") if number < 0.01 else text


def short(number):
    """Two digits below ten, no fraction above."""
    return f"{float(number):.1f}" if float(number) < 9.95 else f"{float(number):.0f}"


def bound(values):
    """The least number with one digit that all values stay below: 4.2e-15 gives 5e-15."""
    exponent = math.floor(math.log10(max(values)))
    digit = math.ceil(max(values) / 10.0**exponent)
    return f"1e{exponent + 1}" if digit == 10 else f"{digit}e{exponent}"


def mesh_name(row):
    times = {"0": "", "1": ", subdivided once", "2": ", subdivided twice"}[row.get("subdivisions", "0")]
    return row["mesh"].rsplit(".", 1)[0] + times


# --- tables ----------------------------------------------------------------------------------------------------------
# A column is a title and a function that makes a cell of a row of the CSV file.


def column(title, key, form=plain, **options):
    return title, lambda row: form(row[key], **options)


def spread(title, key):
    """A median with the least and the greatest value."""
    def cell(row):
        if row[key] == "":
            return ""
        digits = 1 if float(row[key]) < 1000 else 0
        middle, low, high = (f"{float(row[key + end]):,.{digits}f}" for end in ("", "_min", "_max"))
        return f"{middle} ({low}–{high})"
    return title, cell


MESH, FACES = ("mesh", mesh_name), column("faces", "faces")
MICROSECONDS = "\\f$ \\mu \\f$s"


def markdown(titles, rows, words=1):
    """A table whose first columns are words and whose others are numbers."""
    rule = "|" + "|".join(["---"] * words + ["--:"] * (len(titles) - words)) + "|"
    return ["| " + " | ".join(titles) + " |", rule] + ["| " + " | ".join(row) + " |" for row in rows]


def table(name, *columns, words=1, skip=lambda row: False, **wanted):
    """The function of the results that makes the table with these columns of one file."""
    return lambda results: markdown(
        [title for title, _ in columns],
        [[cell(row) for _, cell in columns] for row in results.rows(name, **wanted) if not skip(row)], words)


def paths_on_bunny(results):
    columns = results.rows("paths", mesh="bunny00.off", subdivisions=0)
    titles = [""]
    for row in columns:
        titles += [f"{row['sources']} source{'' if row['sources'] == '1' else 's'}: original", "ours", "ratio"]
    return markdown(titles, [
        [title] + [rounded(row[kind + quantity]) for row in columns for kind in ("original_", "ours_", "ratio_")]
        for quantity, title in PATH_QUANTITIES.items()])


PATH_QUANTITIES = {
    "build_vertices_ms": "build for vertices, ms", "build_faces_ms": "build for all points, ms",
    "memory_vertices_mb": "memory for vertices, MB", "memory_faces_mb": "memory for all points, MB",
    "vertex_query_us": f"distance of a vertex, {MICROSECONDS}", "face_query_us": f"distance of a point, {MICROSECONDS}",
    "vertex_path_us": f"path from a vertex, {MICROSECONDS}", "face_path_us": f"path from a point, {MICROSECONDS}",
}
WAYS = {"always": "always", "backward": "never", "lazily": "when asked for"}
VARIANT = ("variant", lambda row: {"direct": "direct", "intrinsic": "Delaunay"}[row["variant"]])
TABLES = {
    "standard_meshes": table("standard_meshes", MESH, FACES, spread("original, ms", "original_ms"),
        spread("ours, ms", "ours_ms"), column("time ratio", "time_ratio", digits=1),
        column("original, added MB", "original_added_mb", digits=1),
        column("ours, added MB", "ours_added_mb", digits=2), column("memory ratio", "memory_ratio", digits=1)),
    "paths_on_bunny": paths_on_bunny,
    "paths_on_other_meshes": table("paths",
        ("mesh, faces, sources", lambda row: f"{mesh_name(row)}, {plain(row['faces'], 0)}, {row['sources']}"),
        *(column(title.rsplit(",", 1)[0], "ratio_" + key, rounded) for key, title in PATH_QUANTITIES.items()
          if key != "vertex_query_us"),
        skip=lambda row: mesh_name(row) == "bunny00"),
    "face_queries": table("face_queries", column("sources", "sources", str),
        ("windows are kept", lambda row: WAYS[row["alternative"]]), column("build, ms", "build_ms"),
        column("first query, ms", "first_query_ms", rounded),
        (f"next queries, {MICROSECONDS}", lambda row: plain(row["query_us"], 1 if float(row["query_us"]) < 100 else 0)),
        column("memory built, MB", "memory_built_mb", digits=1),
        column("memory at the end, MB", "memory_end_mb", digits=1), column("1 query, ms", "total_1_ms"),
        column("100 queries, ms", "total_100_ms"), column("100,000 queries, ms", "total_100000_ms"), words=2),
    "Voronoi_diagram": table("Voronoi_diagram", MESH, FACES, column("sites", "sites"),
        column("distances, ms", "distances_ms"), column("windows all kept, ms", "all_kept_ms"),
        column("removal, ms", "removal_ms"), column("diagram, ms", "diagram_ms"),
        column("diagram / distances", "diagram_over_distances", digits=1), column("windows kept", "windows_kept"),
        column("at once", "windows_at_once"), column("ratio", "ratio_of_windows", digits=1),
        column("all kept, MB", "all_kept_mb"), column("diagram, MB", "diagram_mb"), column("arcs", "arcs"),
        column("vertices", "vertices"), naive_ms=""),
    "heat_method_times": table("heat_method", MESH, FACES, VARIANT,
        column("first source: heat, ms", "heat_first_ms", rounded), column("exact, ms", "exact_first_ms", rounded),
        column("heat / exact", "ratio_first", rounded), column("next source: heat, ms", "heat_next_ms", rounded),
        column("exact, ms", "exact_next_ms", rounded), column("heat / exact", "ratio_next", rounded),
        column("heat, added MB", "heat_added_mb", rounded), column("exact, added MB", "exact_added_mb", rounded)),
    "heat_method_errors": table("heat_method", MESH, FACES, VARIANT,
        column("mean error, %", "mean_error_percent", rounded),
        column("largest error, %", "largest_error_percent", rounded),
        column("largest error, % of the largest distance", "largest_error_of_extent_percent", rounded)),
    "all_meshes": table("all_meshes", MESH, FACES, column("original, ms", "original_ms", rounded),
        column("ours, ms", "ours_ms", rounded), column("time ratio", "time_ratio", digits=1),
        column("memory ratio", "memory_ratio", digits=1),
        ("windows per face", lambda row: plain(float(row["windows_propagated"]) / float(row["faces"]), 1)),
        column("ns per window", "ns_per_window")),
    "growth": table("growth", MESH, FACES, column("reading, ms", "read_ms", rounded),
        column("run without reading, ms", "run_ms", rounded),
        ("part of reading, %", lambda row: plain(100 * float(row["read_share"]), 0)),
        column("windows per face", "windows_per_face", digits=1), column("ns per window", "ns_per_window", digits=1),
        column("mesh, bytes per face", "mesh_bytes_per_face"), column("windows at once, MB", "window_mb", rounded)),
    "anisotropy": table("anisotropy", ("stretched", lambda row: row["stretch"] + " times"), FACES,
        spread("run, ms", "run_ms"), column("windows", "windows"),
        ("windows per list", lambda row: plain(float(row["windows"]) / float(row["lists"]), 1)),
        column("ns per window", "ns_per_window", digits=1)),
    "sources": table("sources", column("sources", "sources", str), column("run, ms", "run_ms", rounded),
        column("windows", "windows"), column("ns per window", "ns_per_window")),
    "reach": table("reach", ("mesh, faces", lambda row: f"{row['mesh'].rsplit('.', 1)[0]}, {plain(row['faces'], 0)}"),
        column("end of the run", "end", str), column("part of the largest distance", "part_of_largest_distance", str),
        column("run, ms", "run_ms", rounded), column("vertices reached", "vertices_reached"),
        column("windows", "windows"), column(f"{MICROSECONDS} per vertex", "us_per_vertex", rounded), words=2),
    "rules": table("rules", MESH, column("rules", "rules", str), spread("run, ms", "run_ms"),
        column("windows propagated", "windows_propagated"), column("windows per face", "windows_per_face", digits=1),
        column("windows at once", "windows_alive"), words=2),
    "threads": table("threads", MESH, FACES, column("threads", "threads", str), spread("run, ms", "run_ms"),
        column("speedup", "speedup", rounded)),
    "matrix": table("matrix", column("matrix", "matrix", str), column("rows", "rows", str),
        column("threads", "threads", str), column("ms per row", "ms_per_row", rounded),
        column("speedup", "speedup", rounded)),
}


# --- figures in sentences --------------------------------------------------------------------------------------------


def figures(results):
    """Name -> number, as a sentence shows it."""
    rows, values = results.rows, results.values
    bunny = rows("standard_meshes", mesh="bunny00.off", subdivisions=0)[0]
    counts = rows("growth", mesh="bunny00.off", subdivisions=0)[0]
    found = {
        "compiler": results.comment("standard_meshes", r"compiler: g\+\+ (\d+\.\d+)"),
        "CGAL_version": results.comment("standard_meshes", r"# CGAL ([\d.]+),"),
        "bunny_original_seconds": short(float(bunny["original_ms"]) / 1000),
        "bunny_original_gigabytes": f"{float(bunny['original_added_mb']) / 1024:.1f}",
        "bunny_time_ratio": short(bunny["time_ratio"]), "bunny_memory_ratio": short(bunny["memory_ratio"]),
        "windows_in_millions": f"{int(counts['windows']) / 1e6:.3g}",
        "lists_in_thousands": f"{int(counts['lists']) / 1000:.0f}",
        "visits_in_thousands": f"{int(counts['visits']) / 1000:.0f}",
        "number_of_all_meshes": str(len(rows("all_meshes"))),
    }
    for name in ("standard_meshes", "paths", "face_queries", "Voronoi_diagram", "heat_method", "all_meshes", "growth"):
        found[f"{name}_runs"] = results.comment(name, r"(\d+) runs")

    def add_range(name, numbers, form=short):
        found.update({f"{name}_min": form(min(numbers)), f"{name}_max": form(max(numbers))})

    for ratio in ("time_ratio", "memory_ratio"):
        add_range(f"standard_meshes_{ratio}", values("standard_meshes", ratio), round)
        add_range(f"all_meshes_{ratio}", values("all_meshes", ratio))
        found[f"all_meshes_{ratio}_median"] = f"{statistics.median(values('all_meshes', ratio)):.1f}"
    for quantity in PATH_QUANTITIES:
        if quantity != "vertex_query_us":
            add_range(f"paths_{quantity}", values("paths", f"ratio_{quantity}", mesh="bunny00.off", subdivisions=0))
    found["paths_worst"] = f"{min(values('paths', 'ratio_vertex_path_us')):.2f}"
    for name in ("standard_meshes", "face_queries"):
        found[f"{name}_difference"] = bound(values(name, "largest_relative_difference"))
    for row in rows("face_queries", alternative="backward"):
        found[f"break_even_{row['sources']}"] = row["break_even_queries"]
    shares = values("Voronoi_diagram", "arcs_over_removal", sites=30)
    for name, share in zip(("bunny", "armadillo", "fine_bunny"), shares):
        found[f"arcs_percent_{name}"] = f"{100 * share:.0f}"
    found["naive_over_diagram"] = f"{values('Voronoi_diagram', 'naive_over_diagram', mesh='armadillo.off')[0]:.0f}"
    for quantity in ("ratio_first", "mean_error_percent", "largest_error_percent"):
        add_range(f"heat_{quantity}", values("heat_method", quantity))
    add_range("heat_slower_next", [1 / ratio for ratio in values("heat_method", "ratio_next")])
    radii = values("heat_method", "place_of_largest_error_percent")
    found["heat_radius_percent"] = f"{math.ceil(10 * max(radii)) / 10:.1f}"
    return {name: str(number) for name, number in (found | certificates(rows("certified_meshes"))).items()}


def certificates(rows):
    certified = [row for row in rows if row["result"] == "certified"]
    compared = [row for row in certified if row["original"] == "computed"]
    refuted = [row for row in compared if row["violation_of_original"] != ""]
    same = [float(row["largest_relative_difference"]) for row in compared if row not in refuted]
    return {"certified_files": len(rows), "certified": len(certified), "certified_compared": len(compared),
            "certified_triangulated": sum(row["preparation"].endswith("triangulated") for row in rows),
            "certified_violation": bound([float(row["worst_violation"] or 0) for row in certified]),
            "certified_same": len(same), "certified_difference": bound(same)} | {
                f"violation_of_{row['mesh'].split('.')[0]}": f"{float(row['violation_of_original']):.1e}"
                for row in refuted}
