"""The measured tables and figures of the README and of the manual, computed from benchmark/.../results.

A document marks a table with a line of its own above it, and a figure in a sentence with a comment before the number:

    <!-- table: NAME -->
    ... is <!-- figure: NAME -->69 times faster ...

TABLES and figures() compute the contents. check_figures.py compares the documents with them and rewrites the documents.
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
    "Voronoi_diagram": "voronoi.csv"} | {name: name + ".csv" for name in (
    "face_queries", "isolines", "curves", "directions", "obstacles", "certified_meshes", "growth", "anisotropy",
    "sources", "reach", "rules", "instruction_sets", "schedulers", "flat_vertices", "threads", "phases", "matrix",
    "matrix_store", "rows", "interleaved_rows", "brain", "uses_of_diagrams", "python", "compile_times", "remeshing",
    "ordinary_case", "small_component", "earlier_version", "short_lists")}

# The picture in the manual -> the results that it shows; draw_plots.py draws it.
PLOTS = {"plot_ratios.svg": "all_meshes", "plot_growth.svg": "growth"}


class Results:
    """The CSV files of a folder; remembers which of them have been read."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.used = set()

    def lines(self, name):
        return (self.folder / (name + ".csv")).read_text(encoding="utf-8").splitlines()

    def rows(self, name, **wanted):
        """All rows whose columns have the wanted values."""
        self.used.add(name)
        table = csv.DictReader(line for line in self.lines(name) if not line.startswith("#"))
        return [row for row in table if all(row[key] == str(value) for key, value in wanted.items())]

    def comment(self, name, pattern):
        """The first group of a regular expression, in the comments on top of the file."""
        found = re.search(pattern, "\n".join(line for line in self.lines(name) if line.startswith("#")))
        if not found:
            raise ValueError(f"{name}.csv: no {pattern} in the comments")
        return found.group(1)

    def values(self, name, column, **wanted):
        """A column of these rows, as numbers. Skips empty cells, where nothing was measured."""
        return [float(row[column]) for row in self.rows(name, **wanted) if row[column] != ""]


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
    text = f"{number:.{1 if number == 0 else 1 - math.floor(math.log10(number) + 1e-9)}f}"
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


# A column is a pair of a title and a function that makes a cell from a row, or a text "title: key", possibly followed
# by a blank and .1, .2 or .3 (digits behind the point), ~ (rounded), $ (text), ± (median and range).


def spread(row, key):
    if row[key] == "":
        return ""
    digits = 1 if float(row[key]) < 1000 else 0
    middle, low, high = (f"{float(row[key + end]):,.{digits}f}" for end in ("", "_min", "_max"))
    return f"{middle} ({low}–{high})"


FORMS = {"": lambda row, key: plain(row[key]), ".1": lambda row, key: plain(row[key], 1),
         ".2": lambda row, key: plain(row[key], 2), ".3": lambda row, key: plain(row[key], 3),
         "~": lambda row, key: rounded(row[key]),
         "$": lambda row, key: row[key], "±": spread}


def column(text):
    title, key = text.rsplit(": ", 1)
    key, _, form = key.partition(" ")
    return title, lambda row: FORMS[form](row, key)


MESH, FACES, MICROSECONDS = ("mesh", mesh_name), "faces: faces", "\\f$ \\mu \\f$s"


def markdown(titles, rows, words=1):
    """A table whose first columns are words and whose others are numbers."""
    rule = "|" + "|".join(["---"] * words + ["--:"] * (len(titles) - words)) + "|"
    return ["| " + " | ".join(titles) + " |", rule] + ["| " + " | ".join(row) + " |" for row in rows]


def table(name, *columns, words=1, skip=lambda row: False, **wanted):
    """The function of the results that makes the table with these columns of one file."""
    columns = [column(c) if isinstance(c, str) else c for c in columns]
    return lambda results: markdown(
        [title for title, _ in columns],
        [[cell(row) for _, cell in columns] for row in results.rows(name, **wanted) if not skip(row)], words)


def paths_on_bunny(results):
    columns = results.rows("paths", mesh="bunny00.off", subdivisions=0)
    numbers = [f"{row['sources']} source{'' if row['sources'] == '1' else 's'}" for row in columns]
    return markdown([""] + [title for n in numbers for title in (f"{n}: original", "ours", "ratio")], [
        [title] + [rounded(row[kind + quantity]) for row in columns for kind in ("original_", "ours_", "ratio_")]
        for quantity, title in PATH_QUANTITIES.items()])


def schedulers(results):
    """The systems of the thesis, with trimming and without it in the same row."""
    columns = [column(c) for c in ("run, ms: run_ms .1", "time / VTP: time_over_VTP .2", "created: windows_created",
                                   "propagated: windows_propagated", "peak: peak_windows")]
    without = {(row["mesh"], row["faces"], row["variant"]): row for row in results.rows("schedulers", trimming="no")}
    titles = [title for title, _ in columns]
    return markdown(
        ["system", "mesh", "faces", f"with trimming: {titles[0]}", *titles[1:], f"without: {titles[0]}", *titles[1:]],
        [[row["variant"], mesh_name(row), plain(row["faces"])] + [
            cell(r) for r in (row, without[row["mesh"], row["faces"], row["variant"]]) for _, cell in columns]
         for row in results.rows("schedulers", trimming="yes")], words=2)


def thesis_tables(results):
    """Tables 4.1 to 4.5 of the thesis: its models and our meshes, and for each variant three ratios to VTP."""
    meshes = {}
    for row in results.rows("schedulers"):
        if row["trimming"] != "no":
            meshes.setdefault((mesh_name(row), plain(row["faces"])), {})[row["variant"]] = row
    variants = THESIS_VARIANTS.items()
    return markdown(["mesh", "faces"] + [f"{table}: {variant}" for variant, table in variants], [
        [*mesh] + [" / ".join(f"{float(rows[v][key]):.2f}" for key in THESIS_RATIOS) if v in rows else ""
                   for v, _ in variants] for mesh, rows in meshes.items()])


def matrix_plan(results):
    """All pairs of larger meshes: a power of the number of vertices between and beyond the measured meshes."""
    points = sorted((float(row["vertices"]), float(row["ms_per_row"])) for row in results.rows("matrix_store"))

    def milliseconds(n):
        k = max(1, min(len(points) - 1, sum(size < n for size, _ in points)))
        (n0, t0), (n1, t1) = points[k - 1], points[k]
        return t1 * (n / n1) ** (math.log(t1 / t0) / math.log(n1 / n0))

    def duration(hours):
        if hours < 1 / 60:
            return f"{rounded(max(0.01, 3600 * hours))} s"
        return f"{rounded(60 * hours)} min" if hours < 1 else f"{rounded(hours)} h" if hours < 48 else (
            f"{rounded(hours / 24)} days" if hours < 24 * 730 else f"{rounded(hours / 8766)} years")

    rows = []
    for n in MATRIX_PLAN_SIZES:
        hours = n * milliseconds(n) / 3.6e6
        rows.append([f"{n:,}", rounded(milliseconds(n)), rounded(4 * n * n / 1e9), rounded(2 * n * (n - 1) / 1e9)]
                    + [duration(hours / cores) for cores in (1, 100, 1000)])
    return markdown(["vertices", "ms per row", "all pairs, GB", "each pair once, GB", "1 core", "100 cores",
                     "1,000 cores"], rows)


MATRIX_PLAN_SIZES = (5_000, 38_000, 164_000, 1_000_000)
THESIS_VARIANTS = {"VTP-Exhaustive": "4.1", "VTP-Trimming": "4.2", "VTP-CH": "4.3", "VTP-MMP": "4.3", "FTP": "4.4",
                   "OPVTP": "4.5"}
THESIS_RATIOS = ("time_over_VTP", "windows_over_VTP", "peak_over_VTP")
PATH_QUANTITIES = {
    "build_vertices_ms": "build for vertices, ms", "build_faces_ms": "build for all points, ms",
    "memory_vertices_mb": "memory for vertices, MB", "memory_faces_mb": "memory for all points, MB",
    "vertex_query_us": f"distance of a vertex, {MICROSECONDS}", "face_query_us": f"distance of a point, {MICROSECONDS}",
    "vertex_path_us": f"path from a vertex, {MICROSECONDS}", "face_path_us": f"path from a point, {MICROSECONDS}",
}
WAYS = {"always": "always", "backward": "never", "lazily": "when asked for"}
VARIANT = ("variant", lambda row: {"direct": "direct", "intrinsic": "Delaunay"}[row["variant"]])
def nanoseconds_per_face(row):
    return 1e6 * float(row["read_ms"]) / float(row["faces"])


TABLES = {
    "standard_meshes": table("standard_meshes", MESH, FACES, "original, ms: original_ms ±", "ours, ms: ours_ms ±",
        "time ratio: time_ratio .1", "original, added MB: original_added_mb .1", "ours, added MB: ours_added_mb .2",
        "memory ratio: memory_ratio .1"),
    "paths_on_bunny": paths_on_bunny,
    "paths_on_other_meshes": table("paths",
        ("mesh, faces, sources", lambda row: f"{mesh_name(row)}, {plain(row['faces'], 0)}, {row['sources']}"),
        *(f"{title.rsplit(',', 1)[0]}: ratio_{key} ~" for key, title in PATH_QUANTITIES.items()
          if key != "vertex_query_us"),
        skip=lambda row: mesh_name(row) == "bunny00"),
    "face_queries": table("face_queries", "sources: sources $",
        ("windows are kept", lambda row: WAYS[row["alternative"]]), "build, ms: build_ms",
        "first query, ms: first_query_ms ~",
        (f"next queries, {MICROSECONDS}", lambda row: plain(row["query_us"], 1 if float(row["query_us"]) < 100 else 0)),
        "memory built, MB: memory_built_mb .1", "memory at the end, MB: memory_end_mb .1", "1 query, ms: total_1_ms",
        "100 queries, ms: total_100_ms", "100,000 queries, ms: total_100000_ms", words=2),
    "isolines": table("isolines", MESH, FACES, "lines: lines", "without, ms: without_ms ~",
        "on the way, ms: on_the_way_ms ~", "from all windows, ms: from_all_windows_ms ~", "without, MB: without_mb .1", "on the way, MB: on_the_way_mb .1",
        "from all windows, MB: from_all_windows_mb .1", "on the way / without: time: on_the_way_time_ratio .1",
        "memory: on_the_way_memory_ratio .2"),
    "curves": table("curves", MESH, FACES, "border edges: border_vertices", "from curves, ms: curves_ms",
        "from vertices, ms: vertices_ms", "ratio: ratio .2", "windows and strips: curve_windows",
        "windows: vertex_windows", "their memory, ratio: memory_ratio .2",
        "memory of the call, ratio: call_memory_ratio .2"),
    "directions": table("directions", MESH, FACES, "distances, ms: distances_ms .1",
        "distances for paths, ms: build_ms .1", "directions, ms: directions_ms .1",
        "directions / distances: directions_ratio .2", "both / distances: both_ratio .2"),
    "obstacles": table("obstacles", MESH, FACES, "faces to avoid: faces_avoided", "no obstacles, ms: distances_ms .1",
        "an empty range, ms: none_avoided_ms .1", "faces to avoid, ms: avoided_ms .1",
        "filtered graph, ms: filtered_ms .1", "mesh of the rest, ms: rest_ms .1",
        "empty range / no obstacles: none_ratio .2", "faces to avoid / rest: avoided_ratio .2",
        "filtered graph / rest: filtered_ratio .2"),
    "ordinary_case": table("ordinary_case", MESH, FACES, "before, ms: before_ms .1", "now, ms: now_ms .1",
        "now / before: time_ratio .2", "instructions now / before: instructions_ratio .3", "same bits: same_bits $"),
    "earlier_version": table("earlier_version", MESH, FACES, "before, ms: before_ms .1", "now, ms: now_ms .1",
        "now / before: time_ratio .2"),
    "Voronoi_diagram": table("Voronoi_diagram", MESH, FACES, "sites: sites", "distances, ms: distances_ms",
        "windows all kept, ms: all_kept_ms", "removal, ms: removal_ms", "diagram, ms: diagram_ms",
        "diagram / distances: diagram_over_distances .1", "windows kept: windows_kept", "at once: windows_at_once",
        "ratio: ratio_of_windows .1", "all kept, MB: all_kept_mb", "diagram, MB: diagram_mb", "arcs: arcs",
        "vertices: vertices", naive_ms=""),
    "heat_method_times": table("heat_method", MESH, FACES, VARIANT, "first source: heat, ms: heat_first_ms ~",
        "exact, ms: exact_first_ms ~", "heat / exact: ratio_first ~", "next source: heat, ms: heat_next_ms ~",
        "exact, ms: exact_next_ms ~", "heat / exact: ratio_next ~", "heat, added MB: heat_added_mb ~",
        "exact, added MB: exact_added_mb ~"),
    "heat_method_errors": table("heat_method", MESH, FACES, VARIANT, "mean error, %: mean_error_percent ~",
        "largest error, %: largest_error_percent ~",
        "largest error, % of the largest distance: largest_error_of_extent_percent ~"),
    "all_meshes": table("all_meshes", MESH, FACES, "original, ms: original_ms ~", "ours, ms: ours_ms ~",
        "time ratio: time_ratio .1", "memory ratio: memory_ratio .1",
        ("windows per face", lambda row: plain(float(row["windows_propagated"]) / float(row["faces"]), 1)),
        "ns per window: ns_per_window"),
    "growth": table("growth", MESH, FACES, "reading, ms: read_ms ~",
        ("reading, ns per face", lambda row: plain(nanoseconds_per_face(row), 0)),
        "reading, speedup by two threads: reading_speedup ~", "run without reading, ms: run_ms ~",
        ("part of reading, %", lambda row: plain(100 * float(row["read_share"]), 0)),
        "windows per face: windows_per_face .1", "ns per window: ns_per_window .1",
        "mesh, bytes per face: mesh_bytes_per_face", "windows at once, MB: window_mb ~"),
    "anisotropy": table("anisotropy", ("stretched", lambda row: row["stretch"] + " times"), FACES, "run, ms: run_ms ±",
        "windows: windows", ("windows per list", lambda row: plain(float(row["windows"]) / float(row["lists"]), 1)),
        "ns per window: ns_per_window .1"),
    "sources": table("sources", "sources: sources $", "run, ms: run_ms ~", "windows: windows",
        "ns per window: ns_per_window"),
    "short_lists": table("short_lists", MESH, FACES, "windows: windows", "lists: lists",
        "instructions of a list: instructions_per_list"),
    "reach": table("reach", ("mesh, faces", lambda row: f"{row['mesh'].rsplit('.', 1)[0]}, {plain(row['faces'], 0)}"),
        "end of the run: end $", "part of the largest distance: part_of_largest_distance $", "run, ms: run_ms ~",
        "vertices reached: vertices_reached", "windows: windows", f"{MICROSECONDS} per vertex: us_per_vertex ~",
        words=2),
    "rules": table("rules", MESH, "rules: rules $", "run, ms: run_ms ±", "windows propagated: windows_propagated",
        "windows per face: windows_per_face .1", "windows at once: windows_alive", words=2),
    "instruction_sets": table("instruction_sets", MESH, FACES, "lanes: lanes", "propagation, ms: run_ms ±",
        "one lane / these: one_lane_over_this .2", "two lanes / these: two_lanes_over_this .2"),
    "schedulers": schedulers,
    "thesis_tables": thesis_tables,
    "flat_vertices": table("flat_vertices", MESH, FACES, "flat vertices, %: flat_percent", "faces left: coarse_faces",
        "windows: windows", "left: coarse_windows", "run, ms: run_ms ±", "one by one, ms: coarse_ms ±",
        "time ratio: time_ratio .2", "if it took no time: largest_time_ratio .2", "along lines, ms: lines_ms ±",
        "time ratio: lines_ratio .2",
        skip=lambda row: row["run_ms"] == ""),
    "small_component": table("small_component", MESH, FACES, "faces of the component: component_faces",
        "source elsewhere, ms: large_ms ±", "source on the component, ms: small_ms ±",
        "the component alone, ms: alone_ms .3", "original, ms: original_ms ±", "original / ours: ratio .1"),
    "threads": table("threads", MESH, FACES, "threads: threads $", "call, ms: call_ms ±", "speedup: speedup ~"),
    "phases": table("phases", MESH, FACES, "run, ms: run_ms ~", "serial share: serial_share .3",
        "2 threads: predicted_2 ~", "4: predicted_4 ~", "8: predicted_8 ~", "16: predicted_16 ~",
        "64: predicted_64 ~"),
    "uses_of_diagrams": table("uses_of_diagrams", MESH, FACES, "sites: sites", "distances, ms: distances_ms",
        "labels, ms: labels_ms", "diagram, ms: diagram_ms", "two threads, ms: two_threads_ms",
        "ten iterations, ms: relaxation_ms", "certificate, ms: certificate_ms",
        "diagram / distances: diagram_over_distances .1", "two threads: speedup .1",
        "ten iterations / diagram: relaxation_over_diagram .1", "certificate / diagram: certificate_over_diagram .1"),
    "python": table("python", MESH, FACES, "call: call $", "C++, ms: cpp_ms ~", "Python, ms: python_ms ~",
        "Python / C++: ratio .2"),
    "compile_times": table("compile_times", "program: program $", "seconds: seconds ±", "memory, MB: memory_mb",
        "time / original: ratio .2"),
    "matrix_plan": matrix_plan,
    "matrix_store": table("matrix_store", MESH, "vertices: vertices", "ms per row: ms_per_row ~",
        ("rows per second", lambda row: rounded(1000 / float(row["ms_per_row"]))),
        "storing adds, %: storing_percent .1", "elapsed, %: storing_elapsed_percent .1", "memory, MB: memory_mb"),
    "rows": table("rows", MESH, "order: order $", "ms per full row: ms_per_full_row ~",
                  "ending at the last target: ending_to_full .2", "pruned: pruned_to_full .2", words=2),
    "interleaved_rows": table("interleaved_rows", MESH, "rows in turn: rows_in_turn",
                              "ms per row, one by one: ms_per_row ~",
                              "in turn, in parts of that: in_turn_to_one_by_one .2"),
    "brain": table("brain", "mesh: mesh $", "vertices: vertices", "radius, mm: radius_mm",
                   "pairs for each vertex: entries_per_row", "seconds: seconds ~"),
    "matrix": table("matrix", "matrix: matrix $", "rows: rows $", "threads: threads $", "ms per row: ms_per_row ~",
        "speedup: speedup ~"),
}


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
        **{f"{key}_in_thousands": f"{int(counts[key]) / 1000:.0f}" for key in ("lists", "visits")},
        "number_of_all_meshes": str(len(rows("all_meshes"))),
    }
    for name in ("standard_meshes", "paths", "face_queries", "Voronoi_diagram", "heat_method", "all_meshes", "growth"):
        found[f"{name}_runs"] = results.comment(name, r"(\d+) runs")
    def add_range(name, numbers, form=short):
        found.update({f"{name}_min": form(min(numbers)), f"{name}_max": form(max(numbers))})
    found["question_runs"] = results.comment("sources", r"(\d+) runs")
    add_range("reading_ns", [nanoseconds_per_face(row) for row in rows("growth")], round)
    add_range("reading_speedup", values("growth", "reading_speedup"), "{:.1f}".format)
    add_range("reading_percent", [100 * share for share in values("growth", "read_share")], round)
    found["bytes_per_face"] = round(max(values("growth", "mesh_bytes_per_face")))
    for mesh in ("refined_elephant", "armadillo"):
        found[f"time_ratio_{mesh}"] = round(values("standard_meshes", "time_ratio", mesh=mesh + ".off", subdivisions=0)[0])
    for mesh, name in (("bunny00", ""), ("refined_elephant", "_elephant")):
        for subdivisions, speedup in enumerate(values("threads", "speedup", mesh=mesh + ".off", threads=2)):
            found[f"speedup_2_{subdivisions}{name}"] = f"{speedup:.2f}"
    add_range("speedup_1", values("threads", "speedup", threads=1), "{:.2f}".format)
    add_range("earlier_ratio", values("earlier_version", "time_ratio", subdivisions=0), "{:.2f}".format)
    found["earlier_ratio_median"] = f"{statistics.median(values('earlier_version', 'time_ratio', subdivisions=0)):.2f}"
    found["earlier_ratio_fine"] = f"{values('earlier_version', 'time_ratio', subdivisions=2)[0]:.2f}"
    add_range("separate_speedup", [float(row["speedup"]) for row in rows("threads", threads="2 separate runs")
                                   if int(row["faces"]) >= 10000], "{:.1f}".format)
    for n in (8, 16):
        found[f"speedup_{n}_predicted"] = f"{values('phases', f'predicted_{n}', subdivisions=2)[0]:.1f}"
    for name, numbers_of_sites in (("few", (30,)), ("many", (1000, 2000))):
        for figure, key in ((f"diagram_{name}", "diagram_over_distances"), (f"diagram_{name}_threads", "speedup")):
            add_range(figure, [x for n in numbers_of_sites for x in values("uses_of_diagrams", key, sites=n)],
                      "{:.1f}".format)
    found["two_windows_armadillo"] = plain(
        values("short_lists", "instructions_per_list", mesh="armadillo.off", windows=2)[0])
    add_range("curve_ratio", values("curves", "ratio"), "{:.1f}".format)
    found["compile_ratio"] = f"{values('compile_times', 'ratio', program='drop_in_shortest_paths')[0]:.1f}"
    for ratio in ("time_ratio", "memory_ratio"):
        add_range(f"standard_meshes_{ratio}", values("standard_meshes", ratio), round)
        add_range(f"all_meshes_{ratio}", values("all_meshes", ratio))
        found[f"all_meshes_{ratio}_median"] = f"{statistics.median(values('all_meshes', ratio)):.1f}"
    for quantity in PATH_QUANTITIES.keys() - {"vertex_query_us"}:
        add_range(f"paths_{quantity}", values("paths", f"ratio_{quantity}", mesh="bunny00.off", subdivisions=0))
    found["paths_worst"] = f"{min(values('paths', 'ratio_vertex_path_us')):.2f}"
    for name in ("standard_meshes", "face_queries"):
        found[f"{name}_difference"] = bound(values(name, "largest_relative_difference"))
    for row in rows("face_queries", alternative="backward"):
        found[f"break_even_{row['sources']}"] = row["break_even_queries"]
    shares = values("Voronoi_diagram", "arcs_over_removal", sites=30)
    for name, share in zip(("bunny", "armadillo", "fine_bunny"), shares):
        found[f"arcs_percent_{name}"] = f"{100 * share:.0f}"
    add_range("removal_ratio", [float(row["removal_ms"]) / float(row["distances_ms"])
                                for row in rows("Voronoi_diagram", naive_ms="")], "{:.1f}".format)
    found["naive_over_diagram"] = f"{values('Voronoi_diagram', 'naive_over_diagram', mesh='armadillo.off')[0]:.0f}"
    for quantity in ("ratio_first", "mean_error_percent", "largest_error_percent"):
        add_range(f"heat_{quantity}", values("heat_method", quantity))
    add_range("heat_slower_next", [1 / ratio for ratio in values("heat_method", "ratio_next")])
    flat = values("flat_vertices", "flat_percent", subdivisions=0)
    gains = values("flat_vertices", "time_ratio", subdivisions=0)
    found |= {"flat_meshes": len(flat), "flat_measured": len(gains), "flat_half": sum(share >= 50 for share in flat),
              "flat_gains": sum(gain >= 1.5 for gain in gains),
              "flat_difference": bound(values("flat_vertices", "largest_relative_difference")),
              "flat_lines_difference": bound(values("flat_vertices", "lines_difference"))}
    for subdivisions, name in enumerate(("data", "once", "twice")):
        for ratio in ("time_ratio", "largest_time_ratio") + ("lines_ratio",) * (subdivisions > 0):
            add_range(f"flat_{name}_{ratio}", values("flat_vertices", ratio, subdivisions=subdivisions), "{:.2f}".format)
    radii = values("heat_method", "position_of_largest_error_percent")
    found["heat_radius_percent"] = f"{math.ceil(10 * max(radii)) / 10:.1f}"
    return {name: str(number) for name, number in (found | certificates(rows("certified_meshes")) | remeshing(rows("remeshing"))).items()}


def remeshing(rows):
    added = [int(row["added_samples"]) for row in rows if row["rounds"] != "0"]
    found = {"remeshed_runs": len(rows),
             "remeshed_same": sum(row["is_manifold"] == row["same_topology"] == "yes" for row in rows),
             "remeshed_degenerate": sum(int(row["new_degenerate_faces"]) > int(row["degenerate_faces"]) for row in rows),
             "remeshed_without": added.count(0), "remeshed_whole": len(rows) - len(added),
             "remeshed_more": len(added) - added.count(0),
             "remeshed_added_median": round(statistics.median(n for n in added if n > 0)),
             "remeshed_kept": sum(row["kept_components"] != "0" for row in rows),
             "remeshed_rounds": max(int(row["rounds"]) for row in rows)}
    for n in ("200", "1000"):
        distances = [float(row["distance_percent"]) for row in rows if row["samples"] == n and row["rounds"] != "0"]
        found["remeshed_distance_" + n] = f"{statistics.median(distances):.1f}"
    return found


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
