#!/usr/bin/env python3
"""Checks the direction of the includes below an include folder.

Usage: check_include_levels.py INCLUDE_FOLDER | --self-test

Every file in CGAL/Surface_mesh_geodesics/internal/ names its level in a line `// level: N (name)`. The rules:

- A file includes only files of its own or of a lower level. Public headers are above all levels, except two plain
  value types that the inside throws and fills: they stand on level 0.
- The files of the levels 0 to 5 know neither meshes nor kernels, except those that translate from them.
- Only public headers include the licence header, and each of them does.
- The convenience header includes every public header, and nobody includes it.
- Includes have no cycle. Own headers are included with <>.
- Only cgal_compatibility.h asks for the version of CGAL.
"""

import pathlib
import re
import sys
import tempfile

from complaints import report

OWN = "CGAL/Surface_mesh_geodesics/"
INTERNAL = OWN + "internal/"
CONVENIENCE_HEADER = "CGAL/Surface_mesh_geodesics.h"
LICENCE_HEADER = "CGAL/license/Surface_mesh_geodesics.h"
PUBLIC_ON_LEVEL_0 = {OWN + "Propagation_statistics.h", OWN + "Invalid_geodesic_input.h"}
COMPATIBILITY = INTERNAL + "cgal_compatibility.h"

# The level of a public header: above every internal one.
PUBLIC_LEVEL = 1000
# Up to this level everything is templated on a number type only.
LAST_LEVEL_WITHOUT_MESHES = 5

# Headers of CGAL that bring neither a mesh nor a kernel.
PLAIN_CGAL_HEADERS = {
    "CGAL/Default.h",
    "CGAL/assertions.h",
    "CGAL/config.h",
    "CGAL/disable_warnings.h",
    "CGAL/enable_warnings.h",
    "CGAL/exceptions.h",
    "CGAL/number_utils.h",
    "CGAL/tags.h",
    "CGAL/use.h",
}

# How many lines from the top the line with the level may stand.
LEVEL_SEARCH_LINES = 40

BLOCK_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.MULTILINE)
LEVEL = re.compile(r"^// level: (\d+) \(.+\)[ \t]*$")


def may_see_meshes(name):
    """Whether an internal header translates between CGAL's meshes and ours."""
    base = name.rsplit("/", 1)[-1]
    return base.startswith("intrinsic_mesh_from_") or base in ("point_location.h", "cgal_compatibility.h")


def brings_mesh_or_kernel(include):
    if include.startswith("CGAL/"):
        return include not in PLAIN_CGAL_HEADERS
    return include.startswith(("boost/graph/", "boost/property_map/"))


def level_of(name, text, complaints):
    if name in PUBLIC_ON_LEVEL_0:
        return 0
    if not name.startswith(INTERNAL):
        return PUBLIC_LEVEL
    for line in text.splitlines()[:LEVEL_SEARCH_LINES]:
        match = LEVEL.match(line)
        if match:
            return int(match.group(1))
    complaints.append(f"{name}: no line '// level: N (name)' near the top")
    return PUBLIC_LEVEL


def includes_of(text):
    """The pairs (opening quote, path) of a file; what stands in block comments is no include."""
    return INCLUDE.findall(BLOCK_COMMENT.sub("", text))


def check_own_include(name, include, levels, complaints):
    if include not in levels:
        complaints.append(f"{name}: includes {include}, which does not exist")
    elif include == CONVENIENCE_HEADER:
        complaints.append(f"{name}: includes the convenience header")
    elif levels[include] > levels[name]:
        height = "a public header" if levels[include] == PUBLIC_LEVEL else f"level {levels[include]}"
        complaints.append(f"{name}: level {levels[name]}, but includes {include}, {height}")


def check_licence(name, includes, complaints):
    has_licence = LICENCE_HEADER in includes
    if name.startswith(INTERNAL):
        if has_licence:
            complaints.append(f"{name}: internal, but includes the licence header")
    elif name.startswith(OWN) and not has_licence:
        complaints.append(f"{name}: public, but does not include the licence header")


def check_convenience_header(texts, complaints):
    included = {include for _, include in includes_of(texts.get(CONVENIENCE_HEADER, ""))}
    for name in texts:
        if name.startswith(OWN) and not name.startswith(INTERNAL) and name not in included:
            complaints.append(f"{CONVENIENCE_HEADER}: does not include {name}")


def find_cycle(graph):
    """A list of names that include each other in a ring, or None."""
    finished = set()

    def visit(name, trail):
        if name in trail:
            return trail[trail.index(name):] + [name]
        if name in finished:
            return None
        for other in graph.get(name, ()):
            cycle = visit(other, trail + [name])
            if cycle:
                return cycle
        finished.add(name)
        return None

    for name in sorted(graph):
        cycle = visit(name, [])
        if cycle:
            return cycle
    return None


def check(folder):
    """Returns the number of files and the list of complaints."""
    complaints = []
    texts = {
        path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8")
        for path in sorted(pathlib.Path(folder).rglob("*.h"))
    }
    levels = {name: level_of(name, text, complaints) for name, text in texts.items()}
    graph = {}
    for name, text in texts.items():
        includes = includes_of(text)
        graph[name] = [include for _, include in includes if include in texts]
        check_licence(name, {include for _, include in includes}, complaints)
        knows_no_mesh = levels[name] <= LAST_LEVEL_WITHOUT_MESHES and not may_see_meshes(name)
        for quote, include in includes:
            if quote == '"':
                complaints.append(f'{name}: includes "{include}" with quotes')
            elif include == LICENCE_HEADER:
                continue
            elif include.startswith(OWN) or include == CONVENIENCE_HEADER:
                check_own_include(name, include, levels, complaints)
            elif knows_no_mesh and brings_mesh_or_kernel(include):
                complaints.append(f"{name}: level {levels[name]}, but includes <{include}>")
        if name != COMPATIBILITY and "CGAL_VERSION" in text:
            complaints.append(f"{name}: mentions CGAL_VERSION")
    check_convenience_header(texts, complaints)
    cycle = find_cycle(graph)
    if cycle:
        complaints.append("cycle of includes: " + " -> ".join(cycle))
    return len(texts), complaints


# --- self-test -------------------------------------------------------------------------------------------------------

LICENCE_LINE = f"#include <{LICENCE_HEADER}>\n"

# A small tree without a fault; each case of the self-test breaks one rule in it.
SOUND_TREE = {
    LICENCE_HEADER: "#include <CGAL/config.h>\n",
    CONVENIENCE_HEADER: f"#include <{OWN}door.h>\n#include <{OWN}Propagation_statistics.h>\n",
    OWN + "door.h": LICENCE_LINE + f"#include <{INTERNAL}high.h>\n#include <CGAL/Kernel_traits.h>\n",
    OWN + "Propagation_statistics.h": LICENCE_LINE,
    INTERNAL + "high.h": f"// level: 3 (high)\n#include <{INTERNAL}low.h>\n#include <{OWN}Propagation_statistics.h>\n",
    INTERNAL + "low.h": "// level: 0 (low)\n#include <CGAL/assertions.h>\n#include <vector>\n/* #include <CGAL/x.h> */\n",
    INTERNAL + "cgal_compatibility.h": "// level: 0 (low)\n#include <CGAL/version.h>\n#if CGAL_VERSION_NR\n#endif\n",
    INTERNAL + "intrinsic_mesh_from_x.h": "// level: 1 (surface)\n#include <CGAL/boost/graph/helpers.h>\n",
}

# What each fault writes into the tree, and words of the complaint it has to raise.
FAULTS = {
    "upwards": (
        {INTERNAL + "low.h": f"// level: 0 (low)\n#include <{INTERNAL}high.h>\n"},
        f"low.h: level 0, but includes {INTERNAL}high.h, level 3"),
    "no level": (
        {INTERNAL + "low.h": "#include <vector>\n"},
        "low.h: no line"),
    "internal includes public": (
        {INTERNAL + "low.h": f"// level: 9 (low)\n#include <{OWN}door.h>\n"},
        "door.h, a public header"),
    "statistics include level 3": (
        {OWN + "Propagation_statistics.h": LICENCE_LINE + f"#include <{INTERNAL}high.h>\n"},
        "Propagation_statistics.h: level 0, but includes"),
    "mesh": (
        {INTERNAL + "low.h": "// level: 0 (low)\n#include <CGAL/boost/graph/helpers.h>\n"},
        "low.h: level 0, but includes <CGAL/boost/graph/helpers.h>"),
    "kernel": (
        {INTERNAL + "low.h": "// level: 0 (low)\n  # include <CGAL/Simple_cartesian.h>\n"},
        "low.h: level 0, but includes <CGAL/Simple_cartesian.h>"),
    "boost graph": (
        {INTERNAL + "low.h": "// level: 0 (low)\n#include <boost/graph/graph_traits.hpp>\n"},
        "low.h: level 0, but includes <boost/graph/graph_traits.hpp>"),
    "quotes": (
        {INTERNAL + "low.h": '// level: 0 (low)\n#include "high.h"\n'},
        'low.h: includes "high.h" with quotes'),
    "missing file": (
        {INTERNAL + "low.h": f"// level: 0 (low)\n#include <{INTERNAL}gone.h>\n"},
        "gone.h, which does not exist"),
    "internal licence": (
        {INTERNAL + "low.h": "// level: 0 (low)\n" + LICENCE_LINE},
        "low.h: internal, but includes the licence header"),
    "public without licence": (
        {OWN + "door.h": "#include <vector>\n"},
        "door.h: public, but does not include the licence header"),
    "convenience header included": (
        {OWN + "door.h": LICENCE_LINE + f"#include <{CONVENIENCE_HEADER}>\n"},
        "door.h: includes the convenience header"),
    "convenience header incomplete": (
        {OWN + "window.h": LICENCE_LINE},
        f"does not include {OWN}window.h"),
    "version": (
        {INTERNAL + "low.h": "// level: 0 (low)\n#if CGAL_VERSION_NR\n#endif\n"},
        "low.h: mentions CGAL_VERSION"),
    "cycle": (
        {INTERNAL + "low.h": f"// level: 3 (high)\n#include <{INTERNAL}high.h>\n"},
        "cycle of includes"),
}


def check_tree(tree):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in tree.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return check(folder)[1]


def self_test():
    failures = [f"sound tree: {complaint}" for complaint in check_tree(SOUND_TREE)]
    for fault, (files, words) in FAULTS.items():
        if not any(words in complaint for complaint in check_tree({**SOUND_TREE, **files})):
            failures.append(f"not found: {fault}")
    return report(failures, f"self-test: {len(FAULTS)} faults")


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    if len(arguments) != 1:
        print(__doc__)
        return 2
    number_of_files, complaints = check(arguments[0])
    if number_of_files == 0:
        complaints.append(f"{arguments[0]}: there are no headers")
    return report(complaints, f"{number_of_files} headers")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
