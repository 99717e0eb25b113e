"""The measured figures of the README and of the manual, made of the tables in benchmark/.../results.

check_figures.py compares them with what the documents say, and writes them. A document has a line

    <!-- table: NAME -->

above each measured table; TABLES has what belongs below it. Figures in the text are not marked: SENTENCES has the words
around them, with the figures filled in.
"""

import csv
import math
import pathlib
import re
import statistics

# The name in the results -> the file that run_benchmark.sh writes.
CSV_FILES = {
    "standard_meshes": "against_shortest_path.csv",
    "paths": "paths_against_shortest_path.csv",
    "face_queries": "face_queries.csv",
    "Voronoi_diagram": "voronoi.csv",
    "heat_method": "against_heat_method.csv",
    "certified_meshes": "certified_meshes.csv",
    "all_meshes": "against_shortest_path_all.csv",
    "growth": "growth.csv",
    "anisotropy": "anisotropy.csv",
    "sources": "sources.csv",
    "reach": "reach.csv",
    "rules": "rules.csv",
    "threads": "threads.csv",
    "matrix": "matrix.csv",
}

# The picture in the manual -> the results that it shows; draw_plots.py draws it.
PLOTS = {
    "plot_ratios.svg": "all_meshes",
    "plot_growth.svg": "growth",
}


class Results:
    """The CSV files of a folder, and which of them have been asked for."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.used = set()

    def rows(self, name, **wanted):
        """All rows whose columns have the wanted values."""
        self.used.add(name)
        with open(self.folder / (name + ".csv"), encoding="utf-8") as file:
            table = list(csv.DictReader(line for line in file if not line.startswith("#")))
        return [row for row in table if all(row[key] == str(value) for key, value in wanted.items())]

    def row(self, name, **wanted):
        """The only such row."""
        rows = self.rows(name, **wanted)
        if len(rows) != 1:
            raise ValueError(f"{name}.csv: {len(rows)} rows instead of one with {wanted}")
        return rows[0]

    def comment(self, name, pattern):
        """What the parentheses of a regular expression hold, in the comments on top of the file."""
        with open(self.folder / (name + ".csv"), encoding="utf-8") as file:
            comments = "".join(line for line in file if line.startswith("#"))
        found = re.search(pattern, comments)
        if not found:
            raise ValueError(f"{name}.csv: no {pattern} in the comments")
        return found.group(1)

    def values(self, name, column, **wanted):
        """A column of these rows, as numbers; without the places where nothing was measured."""
        return [float(row[column]) for row in self.rows(name, **wanted) if row[column] != ""]


# --- numbers ---------------------------------------------------------------------------------------------------------


def plain(text, digits):
    """With a fixed number of digits behind the point, and commas between thousands; nothing if there is nothing."""
    return "" if text == "" else f"{float(text):,.{digits}f}"


def rounded(text):
    """With three digits, two below ten, one below a hundredth; never in powers of ten."""
    if text == "":
        return ""
    number = float(text)
    if number >= 10:
        return f"{number:,.0f}" if number >= 99.95 else f"{number:.1f}"
    digits = 1 if number == 0 else 1 - math.floor(math.log10(number) + 1e-9)
    text = f"{number:.{digits}f}"
    return text.rstrip("0") if number < 0.01 else text


def spread(row, column):
    """A median with the least and the greatest value."""
    if row[column] == "":
        return ""
    digits = 1 if float(row[column]) < 1000 else 0
    middle, low, high = (f"{float(row[column + end]):,.{digits}f}" for end in ("", "_min", "_max"))
    return f"{middle} ({low}–{high})"


def bound(values, formula=False):
    """The power of ten with one digit that all values stay below: 4.2e-15 gives 5e-15."""
    largest = max(values)
    exponent = math.floor(math.log10(largest))
    digit = math.ceil(largest / 10.0**exponent)
    if digit == 10:
        digit, exponent = 1, exponent + 1
    return f"\\f$ {digit} \\cdot 10^{{{exponent}}} \\f$" if formula else f"{digit}e{exponent}"


def listed(texts):
    """a, b and c"""
    return ", ".join(texts[:-1]) + " and " + texts[-1]


def in_words(number):
    words = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"]
    return words[int(number)] if int(number) < len(words) else str(number)


def mesh_name(row):
    times = {"0": "", "1": ", subdivided once", "2": ", subdivided twice"}[row["subdivisions"]]
    return row["mesh"].rsplit(".", 1)[0] + times


def markdown(titles, rows, words=1):
    """A table whose first columns are words and whose others are numbers."""
    rule = "|" + "|".join(["---"] * words + ["--:"] * (len(titles) - words)) + "|"
    lines = ["| " + " | ".join(titles) + " |", rule]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


# --- tables ----------------------------------------------------------------------------------------------------------


def standard_meshes(results):
    return markdown(
        ["mesh", "faces", "original, ms", "ours, ms", "time ratio", "original, added MB", "ours, added MB",
         "memory ratio"],
        [[mesh_name(row), plain(row["faces"], 0), spread(row, "original_ms"), spread(row, "ours_ms"),
          plain(row["time_ratio"], 1), plain(row["original_added_mb"], 1), plain(row["ours_added_mb"], 2),
          plain(row["memory_ratio"], 1)] for row in results.rows("standard_meshes")])


PATH_QUANTITIES = [
    ("build for vertices, ms", "build_vertices_ms"),
    ("build for all points, ms", "build_faces_ms"),
    ("memory for vertices, MB", "memory_vertices_mb"),
    ("memory for all points, MB", "memory_faces_mb"),
    ("distance of a vertex, \\f$ \\mu \\f$s", "vertex_query_us"),
    ("distance of a point, \\f$ \\mu \\f$s", "face_query_us"),
    ("path from a vertex, \\f$ \\mu \\f$s", "vertex_path_us"),
    ("path from a point, \\f$ \\mu \\f$s", "face_path_us"),
]


def paths_on_bunny(results):
    columns = results.rows("paths", mesh="bunny00.off", subdivisions=0)
    titles = [""]
    for row in columns:
        plural = "s" if row["sources"] != "1" else ""
        titles += [f"{row['sources']} source{plural}: original", "ours", "ratio"]
    return markdown(titles, [
        [title] + [rounded(row[kind + quantity]) for row in columns for kind in ("original_", "ours_", "ratio_")]
        for title, quantity in PATH_QUANTITIES])


def paths_on_other_meshes(results):
    names = ["build_vertices_ms", "build_faces_ms", "memory_vertices_mb", "memory_faces_mb", "face_query_us",
             "vertex_path_us", "face_path_us"]
    titles = {name: title.rsplit(",", 1)[0] for title, name in PATH_QUANTITIES}
    return markdown(
        ["mesh, faces, sources"] + [titles[name] for name in names],
        [[f"{mesh_name(row)}, {plain(row['faces'], 0)}, {row['sources']}"] + [rounded(row["ratio_" + n]) for n in names]
         for row in results.rows("paths") if mesh_name(row) != "bunny00"])


def face_queries(results):
    names = {"always": "always", "backward": "never", "lazily": "when asked for"}
    rows = []
    for sources in dict.fromkeys(row["sources"] for row in results.rows("face_queries")):
        for alternative, name in names.items():
            row = results.row("face_queries", sources=sources, alternative=alternative)
            rows.append([sources, name, plain(row["build_ms"], 0), rounded(row["first_query_ms"]),
                         plain(row["query_us"], 1 if float(row["query_us"]) < 100 else 0),
                         plain(row["memory_built_mb"], 1), plain(row["memory_end_mb"], 1)]
                        + [plain(row[f"total_{n}_ms"], 0) for n in (1, 100, 100000)])
    return markdown(["sources", "windows are kept", "build, ms", "first query, ms", "next queries, \\f$ \\mu \\f$s",
                     "memory built, MB", "memory at the end, MB", "1 query, ms", "100 queries, ms",
                     "100,000 queries, ms"], rows, words=2)


def Voronoi_diagram(results):
    columns = [("distances, ms", "distances_ms", 0), ("windows all kept, ms", "all_kept_ms", 0),
               ("removal, ms", "removal_ms", 0), ("diagram, ms", "diagram_ms", 0),
               ("diagram / distances", "diagram_over_distances", 1), ("windows kept", "windows_kept", 0),
               ("at once", "windows_at_once", 0), ("ratio", "ratio_of_windows", 1), ("all kept, MB", "all_kept_mb", 0),
               ("diagram, MB", "diagram_mb", 0), ("arcs", "arcs", 0), ("vertices", "vertices", 0)]
    return markdown(
        ["mesh", "faces", "sites"] + [title for title, _, _ in columns],
        [[mesh_name(row), plain(row["faces"], 0), plain(row["sites"], 0)]
         + [plain(row[name], digits) for _, name, digits in columns]
         for row in results.rows("Voronoi_diagram", naive_ms="")])


VARIANTS = {"direct": "direct", "intrinsic": "Delaunay"}


def heat_method_times(results):
    columns = ["heat_first_ms", "exact_first_ms", "ratio_first", "heat_next_ms", "exact_next_ms", "ratio_next",
               "heat_added_mb", "exact_added_mb"]
    return markdown(
        ["mesh", "faces", "variant", "first source: heat, ms", "exact, ms", "heat / exact",
         "next source: heat, ms", "exact, ms", "heat / exact", "heat, added MB", "exact, added MB"],
        [[mesh_name(row), plain(row["faces"], 0), VARIANTS[row["variant"]]] + [rounded(row[name]) for name in columns]
         for row in results.rows("heat_method")])


def heat_method_errors(results):
    columns = ["mean_error_percent", "largest_error_percent", "largest_error_of_extent_percent"]
    return markdown(
        ["mesh", "faces", "variant", "mean error, %", "largest error, %",
         "largest error, % of the largest distance"],
        [[mesh_name(row), plain(row["faces"], 0), VARIANTS[row["variant"]]] + [rounded(row[name]) for name in columns]
         for row in results.rows("heat_method")])


def all_meshes(results):
    return markdown(
        ["mesh", "faces", "original, ms", "ours, ms", "time ratio", "memory ratio", "windows per face", "ns per window"],
        [[mesh_name(row), plain(row["faces"], 0), rounded(row["original_ms"]), rounded(row["ours_ms"]),
          plain(row["time_ratio"], 1), plain(row["memory_ratio"], 1),
          plain(float(row["windows_propagated"]) / float(row["faces"]), 1), plain(row["ns_per_window"], 0)]
         for row in results.rows("all_meshes")])


def growth(results):
    return markdown(
        ["mesh", "faces", "reading, ms", "run without reading, ms", "part of reading, %", "windows per face",
         "ns per window", "mesh, bytes per face", "windows at once, MB"],
        [[mesh_name(row), plain(row["faces"], 0), rounded(row["read_ms"]), rounded(row["run_ms"]),
          plain(100 * float(row["read_share"]), 0), plain(row["windows_per_face"], 1), plain(row["ns_per_window"], 1),
          plain(row["mesh_bytes_per_face"], 0), rounded(row["window_mb"])] for row in results.rows("growth")])


def anisotropy(results):
    return markdown(
        ["stretched", "faces", "run, ms", "windows", "windows per list", "ns per window"],
        [[row["stretch"] + " times", plain(row["faces"], 0), spread(row, "run_ms"), plain(row["windows"], 0),
          plain(float(row["windows"]) / float(row["lists"]), 1), plain(row["ns_per_window"], 1)]
         for row in results.rows("anisotropy")])


def sources(results):
    return markdown(
        ["sources", "run, ms", "windows", "ns per window"],
        [[row["sources"], rounded(row["run_ms"]), plain(row["windows"], 0), plain(row["ns_per_window"], 0)]
         for row in results.rows("sources")])


def reach(results):
    return markdown(
        ["mesh, faces", "end of the run", "part of the largest distance", "run, ms", "vertices reached", "windows",
         "\\f$ \\mu \\f$s per vertex"],
        [[f"{row['mesh'].rsplit('.', 1)[0]}, {plain(row['faces'], 0)}", row["end"], row["part_of_largest_distance"], rounded(row["run_ms"]), plain(row["vertices_reached"], 0),
          plain(row["windows"], 0), rounded(row["us_per_vertex"])] for row in results.rows("reach")],
        words=2)


def rules(results):
    return markdown(
        ["mesh", "rules", "run, ms", "windows propagated", "windows per face", "windows at once"],
        [[row["mesh"].rsplit(".", 1)[0], row["rules"], spread(row, "run_ms"), plain(row["windows_propagated"], 0),
          plain(row["windows_per_face"], 1), plain(row["windows_alive"], 0)] for row in results.rows("rules")],
        words=2)


def threads(results):
    return markdown(
        ["mesh", "faces", "threads", "run, ms", "speedup"],
        [[mesh_name(row), plain(row["faces"], 0), row["threads"], spread(row, "run_ms"), rounded(row["speedup"])]
         for row in results.rows("threads")])


def matrix(results):
    return markdown(
        ["matrix", "rows", "threads", "ms per row", "speedup"],
        [[row["matrix"], row["rows"], row["threads"], rounded(row["ms_per_row"]), rounded(row["speedup"])]
         for row in results.rows("matrix")])


TABLES = {table.__name__: table for table in (
    standard_meshes, paths_on_bunny, paths_on_other_meshes, face_queries, Voronoi_diagram, heat_method_times,
    heat_method_errors, all_meshes, growth, anisotropy, sources, reach, rules, threads, matrix)}

# --- sentences -------------------------------------------------------------------------------------------------------

README = "README.md"
SUBMISSION = "doc/submission/specification.md"
MANUAL = "doc/Surface_mesh_geodesics/Surface_mesh_geodesics.txt"


def short(number):
    """With two digits, or without a fraction."""
    return f"{float(number):.1f}" if float(number) < 9.95 else f"{float(number):.0f}"


def on_bunny(results, column):
    """A column for 1, 10 and 50 sources, as "a, b and c"."""
    return listed([short(row[column]) for row in results.rows("paths", mesh="bunny00.off", subdivisions=0)])


def sentences_about_distances(results):
    differences = results.values("standard_meshes", "largest_relative_difference")
    windows = results.values("standard_meshes", "windows_propagated", mesh="bunny00.off")
    bunny = results.row("standard_meshes", mesh="bunny00.off", subdivisions=0)
    counts = results.row("growth", mesh="bunny00.off", subdivisions=0)
    times = results.values("standard_meshes", "time_ratio")
    memory = results.values("standard_meshes", "memory_ratio")
    runs = in_words(results.comment("standard_meshes", r"(\d+) runs of each"))
    compiler = results.comment("standard_meshes", r"compiler: g\+\+ (\d+\.\d+)")
    version = results.comment("standard_meshes", r"# CGAL ([\d.]+),")
    return [
        (SUBMISSION, f"{min(times):.0f} to {max(times):.0f} times faster on the three standard meshes of the benchmark "
                     f"and in {min(memory):.0f} to {max(memory):.0f} times less memory"),
        (README, f"median (range) of the processor times of {runs} runs of each in turn"),
        (MANUAL, f"median (range) of the processor times of {runs} runs of each in turn"),
        (README, f"(Intel Xeon, g++ {compiler}, `-O3 -DNDEBUG -frounding-math`, CGAL {version}, one thread)"),
        (MANUAL, f"(Intel Xeon, g++ {compiler}, `-O3 -DNDEBUG -frounding-math`, CGAL {version}, "
                 f"`Simple_cartesian<double>`, one thread)"),
        (README, f"All distances of the first three agree to {bound(differences)} relative."),
        (MANUAL, f"The distances of the first three meshes agree to {bound(differences, formula=True)} relative."),
        (MANUAL, f"{listed([f'{number / 1e6:.3g}' for number in windows])} million are propagated on the three "
                 "bunnies."),
        (MANUAL, f"all vertices from vertex 0) {int(counts['windows']) / 1e6:.3g} million windows are propagated in "
                 f"{int(counts['lists']) / 1000:.0f} thousand lists, during {int(counts['visits']) / 1000:.0f} thousand "
                 "visits of vertices."),
        (MANUAL, f"on the scan of the first figure it takes {short(float(bunny['original_ms']) / 1000)} seconds and "
                 f"{float(bunny['original_added_mb']) / 1024:.1f} GB, "
                 f"{short(bunny['time_ratio'])} times the time and {short(bunny['memory_ratio'])} times the memory of"),
    ]


def sentences_about_paths(results):
    def column(name):
        return on_bunny(results, name)

    runs = results.comment("paths", r"medians of (\d+) runs of each")
    return [
        (MANUAL, f"(`--no-standard --paths --paths-repetitions {runs}`; medians of {in_words(runs)} runs, ratios are "
                 "medians of the ratios of neighbouring runs)"),
        (README, f"`Surface_mesh_geodesic_paths` is built {column('ratio_build_vertices_ms')} times faster for 1, 10 "
                 f"and 50 sources ({column('ratio_build_faces_ms')} times with what queries inside faces need), in "
                 f"{column('ratio_memory_vertices_mb')} times less memory ({column('ratio_memory_faces_mb')} times)."),
        (MANUAL, f"Building is {column('ratio_build_vertices_ms')} times faster with 1, 10 and 50 sources on bunny00, "
                 f"and takes {column('ratio_memory_vertices_mb')} times less memory;"),
        (MANUAL, f"it is {column('ratio_build_faces_ms')} times faster with what queries inside faces need, in "
                 f"{column('ratio_memory_faces_mb')} times less memory."),
        (MANUAL, f"The distance of a point inside a face is found {column('ratio_face_query_us')} times faster;"),
        (MANUAL, f"paths from points inside faces {column('ratio_face_path_us')} times, paths from vertices "
                 f"{column('ratio_vertex_path_us')} times."),
        (MANUAL, f"at worst {min(results.values('paths', 'ratio_vertex_path_us')):.2f} times as fast (armadillo)."),
    ]


def sentences_about_face_queries(results):
    always = results.rows("face_queries", alternative="always")
    lazily = results.rows("face_queries", alternative="lazily")
    backward = results.rows("face_queries", alternative="backward")

    def ratios(column):
        return [float(a[column]) / float(b[column]) for a, b in zip(always, lazily)]

    even = [row["break_even_queries"] for row in backward]
    percents = listed([f"{100 * (ratio - 1):.0f}" for ratio in ratios("build_ms")])
    differences = results.values("face_queries", "largest_relative_difference")
    runs = results.comment("face_queries", r"medians of (\d+) runs of each")
    return [
        (MANUAL, f"queries at random points inside faces: medians of {in_words(runs)} runs, as printed by "
                 f"`benchmark_face_queries bunny00.off --repetitions {runs}`"),
        (MANUAL, f"The distances agree to {bound(differences, formula=True)} relative."),
        (MANUAL, f"from {even[0]} queries on with one source, from {even[1]} with ten and from {even[2]} with fifty"),
        (MANUAL, f"with {percents} percent more time for one, ten and fifty sources"),
        (MANUAL, f"with {listed([short(ratio) for ratio in ratios('memory_built_mb')])} times the memory"),
    ]


def sentences_about_Voronoi_diagrams(results):
    arcs = [100 * share for share in results.values("Voronoi_diagram", "arcs_over_removal", sites=30)]
    naive = results.values("Voronoi_diagram", "naive_over_diagram", mesh="armadillo.off")[0]
    runs = in_words(results.comment("Voronoi_diagram", r"(\d+) runs of each method \(the naive one once\)"))
    return [
        (MANUAL, f"Times are medians of {runs} runs; that of bunny00 subdivided twice, and the naive way below, were "
                 "run once:"),
        (MANUAL, f"With 30 sites they take {arcs[0]:.0f} and {arcs[1]:.0f} percent of the time of the propagation on "
                 f"bunny00 and armadillo, and {arcs[2]:.0f} percent on bunny00 subdivided twice"),
        (MANUAL, f"takes {naive:.0f} times the time of the diagram on armadillo."),
    ]


def sentences_about_the_heat_method(results):
    def span(column):
        values = results.values("heat_method", column)
        return f"{short(min(values))} to {short(max(values))}"

    runs = in_words(results.comment("heat_method", r"medians of (\d+) runs of each"))
    slower = [1 / ratio for ratio in results.values("heat_method", "ratio_next")]
    place = max(results.values("heat_method", "place_of_largest_error_percent"))
    return [
        (MANUAL, f"medians of the processor times of {runs} runs of each in turn, as `run_benchmark.sh"),
        (MANUAL, f"the exact distances come {span('ratio_first')} times sooner"),
        (MANUAL, f"each takes {short(min(slower))} to {short(max(slower))} times as long as a further estimate"),
        (MANUAL, f"The mean error is {span('mean_error_percent')} percent, the largest one "
                 f"{span('largest_error_percent')} percent, near the source: no farther than {math.ceil(10 * place) / 10:.1f} percent of "
                 "the largest distance"),
    ]


def sentences_about_certificates(results):
    rows = results.rows("certified_meshes")
    certified = [row for row in rows if row["result"] == "certified"]
    refused = [row for row in rows if row["preparation"].endswith("triangulated")]
    compared = [row for row in certified if row["original"] == "computed"]
    refuted = [row for row in compared if row["violation_of_original"] != ""]
    equal = [float(row["largest_relative_difference"]) for row in compared if row not in refuted]
    worst = results.values("certified_meshes", "worst_violation", result="certified")
    violations = [f"\\f$ {mantissa} \\cdot 10^{{{int(exponent)}}} \\f$ on `{row['mesh']}`" for row in refuted
                  for mantissa, exponent in [f"{float(row['violation_of_original']):.1e}".split("e")]]
    return [
        (MANUAL, f"Of the {len(rows)} files of \\cgal's data, {len(certified)} are certified, {len(refused)} of them "
                 f"after they have been triangulated; violations stay below {bound(worst, formula=True)}."),
        (MANUAL, f"`Surface_mesh_shortest_path` finds the same distances on {len(equal)} of the {len(compared)} where "
                 f"it ends within a minute, to {bound(equal, formula=True)} relative; on the others its distances "
                 f"violate the conditions by {listed(violations)}: they are too long."),
    ]


def sentences_about_all_meshes(results):
    times = results.values("all_meshes", "time_ratio")
    memory = results.values("all_meshes", "memory_ratio")
    runs = results.comment("all_meshes", r"(\d+) runs of each method")
    return [
        (MANUAL, f"`run_benchmark.sh --all --no-standard --all-repetitions {runs}` measures all triangle meshes of "
                 f"\\cgal's data with 5,000 faces and more, in {in_words(runs)} run{'' if runs == '1' else 's'} of "
                 "each method."),
        (MANUAL, f"On {len(times)} meshes the ratio of times is {short(min(times))} to {short(max(times))}, with a median "
                 f"of {statistics.median(times):.1f}, and the ratio of memory {short(min(memory))} to "
                 f"{short(max(memory))}, with a median of {statistics.median(memory):.1f}."),
    ]


def sentences_about_questions(results):
    questions = ("growth", "anisotropy", "sources", "reach", "rules", "threads", "matrix")
    (runs,) = {results.comment(name, r"median, least and greatest of (\d+) runs") for name in questions}
    return [
        (MANUAL, f"medians of {in_words(runs)} runs (`--questions-repetitions {runs}`),"),
    ]


def sentences(results):
    """Pairs of a document and words that stand in it, wherever its lines end."""
    return (sentences_about_distances(results) + sentences_about_paths(results) + sentences_about_face_queries(results)
            + sentences_about_Voronoi_diagrams(results) + sentences_about_the_heat_method(results)
            + sentences_about_certificates(results) + sentences_about_all_meshes(results)
            + sentences_about_questions(results))
