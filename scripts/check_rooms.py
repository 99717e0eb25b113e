#!/usr/bin/env python3
"""Checks the direction of the includes below an include folder.

Usage: check_rooms.py INCLUDE_FOLDER | --self-test

The folders of CGAL/Surface_mesh_geodesics/internal/ are rooms, and their order is the architecture (ROOMS below):

- A file includes files of its own room or of a lower one. Rooms that share a rank do not include each other.
- A public header is above all rooms, unless it includes neither a header of the package nor a mesh nor a kernel. Then
  it is a plain value type and below all rooms, which may fill it in or throw it.
- Rooms below `interface` know neither meshes nor kernels.
- A room has at most 15 files, and a README.md that names each of them and each subfolder. A subfolder of a room counts
  as a room of its own.
- The includes from folder to folder have no cycle: a room includes a subfolder of its own, or the subfolder includes
  its room, but not both.
- Only public headers include the license header, and each of them does.
- The convenience header includes every public header, and no header includes it.
- Includes have no cycle. Own headers are included with <>.
- Only cgal_compatibility.h asks for the version of CGAL.
- Each member of Tolerance has a caller: a tolerance that nobody uses is a dead copy of one that stands elsewhere.
"""

import pathlib
import re
import tempfile

from complaints import report, run_script

OWN = "CGAL/Surface_mesh_geodesics/"
INTERNAL = OWN + "internal/"
CONVENIENCE_HEADER = "CGAL/Surface_mesh_geodesics.h"
LICENSE_HEADER = "CGAL/license/Surface_mesh_geodesics.h"
TOLERANCE = INTERNAL + "numeric/Tolerance.h"
COMPATIBILITY = INTERNAL + "numeric/cgal_compatibility.h"

# From the ground up; rooms of one line do not include each other.
ROOMS = (
    ("numeric",),
    ("surface",),
    ("window",),
    ("propagation", "paths", "Voronoi"),
    ("certificate",),
    ("interface",),
    ("applications",),
)
RANK = {room: rank for rank, rooms in enumerate(ROOMS) for room in rooms}
FIRST_RANK_WITH_MESHES = RANK["interface"]
PUBLIC_RANK = len(ROOMS)
PLAIN_RANK = -1
MOST_FILES_IN_ROOM = 15

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

BLOCK_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
LINE_COMMENT = re.compile(r"//[^\n]*")
MEMBER_OF_TOLERANCE = re.compile(r"\bstatic (?:constexpr )?\w+ (\w+)\(\)")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.MULTILINE)


def room_of(name):
    """The room of an internal header; None for a public one, and for one that is in no room."""
    parts = name[len(INTERNAL):].split("/") if name.startswith(INTERNAL) else []
    return parts[0] if len(parts) > 1 and parts[0] in RANK else None


def folder_of(name):
    return pathlib.PurePosixPath(name).parent.as_posix()


def brings_mesh_or_kernel(include):
    if include.startswith("CGAL/"):
        return include not in PLAIN_CGAL_HEADERS
    return include.startswith(("boost/graph/", "boost/property_map/"))


def includes_of(text):
    """The pairs (opening quote, path) of a file; ignores block comments."""
    return INCLUDE.findall(BLOCK_COMMENT.sub("", text))


def is_plain(name, text):
    """Whether a header is public and includes neither a header of the package nor a mesh nor a kernel."""
    if not name.startswith(OWN) or name.startswith(INTERNAL):
        return False
    return not any(
        include.startswith(OWN) or include == CONVENIENCE_HEADER or brings_mesh_or_kernel(include)
        for _, include in includes_of(text) if include != LICENSE_HEADER)


def ranks_of(texts):
    """The rank of each header; a lower one may be included by a higher one."""
    return {
        name: PLAIN_RANK if is_plain(name, text) else RANK.get(room_of(name), PUBLIC_RANK)
        for name, text in texts.items()
    }


def check_own_include(name, include, ranks, complaints):
    if include not in ranks:
        complaints.append(f"{name}: includes {include}, which does not exist")
    elif include == CONVENIENCE_HEADER:
        complaints.append(f"{name}: includes the convenience header")
    elif ranks[include] > ranks[name]:
        complaints.append(f"{name}: includes {include} of a higher room")
    elif ranks[include] == ranks[name] and room_of(include) != room_of(name) and room_of(name):
        complaints.append(f"{name}: includes {include} of a sibling room")


def check_rooms(folder, names, complaints):
    """Every internal header is in a room; a room and each of its subfolders is small and has a first page."""
    entries = {}  # the headers and subfolders of each folder
    for name in names:
        if not name.startswith(INTERNAL):
            continue
        if room_of(name) is None:
            complaints.append(f"{name}: in no room")
            continue
        path = pathlib.PurePosixPath(name)
        entries.setdefault(path.parent.as_posix(), set()).add(path.name)
        for above in list(path.parents)[1:]:
            if room_of(above.as_posix() + "/"):
                entries.setdefault(above.as_posix(), set()).add(path.relative_to(above).parts[0] + "/")
    for room, contents in sorted(entries.items()):
        check_room(pathlib.Path(folder), room, contents, complaints)


def check_room(folder, room, contents, complaints):
    """`contents` has the names of the headers, and those of the subfolders with a slash behind."""
    size = sum(not entry.endswith("/") for entry in contents)
    if size > MOST_FILES_IN_ROOM:
        complaints.append(f"{room}: {size} files, at most {MOST_FILES_IN_ROOM} are allowed")
    page = folder / room / "README.md"
    if not page.is_file():
        complaints.append(f"{room}: no README.md")
        return
    text = page.read_text(encoding="utf-8")
    for entry in sorted(contents):
        if f"`{entry}`" not in text:
            complaints.append(f"{room}/README.md: does not name {entry}")


def check_license(name, includes, complaints):
    has_license = LICENSE_HEADER in includes
    if name.startswith(INTERNAL):
        if has_license:
            complaints.append(f"{name}: internal, but includes the license header")
    elif name.startswith(OWN) and not has_license:
        complaints.append(f"{name}: public, but does not include the license header")


def check_convenience_header(texts, complaints):
    included = {include for _, include in includes_of(texts.get(CONVENIENCE_HEADER, ""))}
    for name in texts:
        if name.startswith(OWN) and not name.startswith(INTERNAL) and name not in included:
            complaints.append(f"{CONVENIENCE_HEADER}: does not include {name}")


def check_tolerances(texts, complaints):
    """Each member of Tolerance is called by another file, or by another member."""
    own_text = LINE_COMMENT.sub("", texts.get(TOLERANCE, ""))
    others = "\n".join(LINE_COMMENT.sub("", text) for name, text in texts.items() if name != TOLERANCE)
    for member in MEMBER_OF_TOLERANCE.findall(own_text):
        is_called_here = len(re.findall(rf"\b{member}\(\)", own_text)) > 1
        if not is_called_here and not re.search(rf"(?:Tolerance<[^<>]*>|\bT)::{member}\(\)", others):
            complaints.append(f"{TOLERANCE}: nobody calls {member}()")


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


def check_folders(graph, complaints):
    """`graph` has the includes of each file; a folder includes what its own files include."""
    folders = {}
    for name, included in graph.items():
        if name.startswith(INTERNAL):
            others = {folder_of(other) for other in included if other.startswith(INTERNAL)}
            folders.setdefault(folder_of(name), set()).update(others - {folder_of(name)})
    cycle = find_cycle(folders)
    if cycle:
        complaints.append("cycle of folders: " + " -> ".join(cycle))


def check(folder):
    """Returns the number of files and the list of complaints."""
    complaints = []
    texts = {
        path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8")
        for path in sorted(pathlib.Path(folder).rglob("*.h"))
    }
    check_rooms(folder, texts, complaints)
    graph = {}
    ranks = ranks_of(texts)
    for name, text in texts.items():
        includes = includes_of(text)
        graph[name] = [include for _, include in includes if include in texts]
        check_license(name, {include for _, include in includes}, complaints)
        knows_no_mesh = name.startswith(INTERNAL) and name != COMPATIBILITY and ranks[name] < FIRST_RANK_WITH_MESHES
        for quote, include in includes:
            if quote == '"':
                complaints.append(f'{name}: includes "{include}" with quotes')
            elif include == LICENSE_HEADER:
                continue
            elif include.startswith(OWN) or include == CONVENIENCE_HEADER:
                check_own_include(name, include, ranks, complaints)
            elif knows_no_mesh and brings_mesh_or_kernel(include):
                complaints.append(f"{name}: includes <{include}>, but its room knows no mesh")
        if name != COMPATIBILITY and "CGAL_VERSION" in text:
            complaints.append(f"{name}: mentions CGAL_VERSION")
    check_convenience_header(texts, complaints)
    check_tolerances(texts, complaints)
    cycle = find_cycle(graph)
    if cycle:
        complaints.append("cycle of includes: " + " -> ".join(cycle))
    check_folders(graph, complaints)
    return len(texts), complaints


# --- self-test -------------------------------------------------------------------------------------------------------

LICENSE_LINE = f"#include <{LICENSE_HEADER}>\n"

HIGH, LOW = INTERNAL + "window/high.h", INTERNAL + "numeric/low.h"

# A small tree without a fault; each case of the self-test breaks one rule in it.
SOUND_TREE = {
    LICENSE_HEADER: "#include <CGAL/config.h>\n",
    CONVENIENCE_HEADER: f"#include <{OWN}door.h>\n#include <{OWN}Propagation_statistics.h>\n",
    OWN + "door.h": LICENSE_LINE + f"#include <{HIGH}>\n#include <CGAL/Kernel_traits.h>\n",
    OWN + "Propagation_statistics.h": LICENSE_LINE,
    HIGH: f"#include <{LOW}>\n#include <{OWN}Propagation_statistics.h>\n",
    LOW: "#include <CGAL/assertions.h>\n#include <vector>\n/* #include <CGAL/x.h> */\nTolerance<FT>::length();\n",
    TOLERANCE: "static FT unit() { return 1; }\nstatic FT length() { return 2 * unit(); }\n",
    COMPATIBILITY: "#include <CGAL/version.h>\n#if CGAL_VERSION_NR\n#endif\n",
    INTERNAL + "interface/mesh.h": (
        f"#include <CGAL/boost/graph/helpers.h>\n#include <{INTERNAL}propagation/shelf/tool.h>\n"),
    INTERNAL + "window/shelf/tool.h": f"#include <{LOW}>\n",
    INTERNAL + "window/user.h": f"#include <{INTERNAL}window/shelf/tool.h>\n",
    INTERNAL + "propagation/shelf/tool.h": f"#include <{INTERNAL}propagation/run.h>\n",
    INTERNAL + "propagation/run.h": f"#include <{HIGH}>\n",
    INTERNAL + "numeric/README.md": "# A room: `low.h`, `other.h`, `Tolerance.h`, `cgal_compatibility.h`\n",
    INTERNAL + "window/README.md": "# A room: `high.h`, `user.h`, `shelf/`\n",
    INTERNAL + "window/shelf/README.md": "# A subfolder: `tool.h`\n",
    INTERNAL + "propagation/README.md": "# A room: `run.h`, `shelf/`\n",
    INTERNAL + "propagation/shelf/README.md": "# A subfolder: `tool.h`\n",
    INTERNAL + "interface/README.md": "# A room: `mesh.h`\n",
}

# What each fault writes into the tree, and words of the complaint it has to raise.
FAULTS = {
    "upward": (
        {LOW: f"#include <{HIGH}>\n"},
        f"low.h: includes {HIGH} of a higher room"),
    "sibling": (
        {INTERNAL + "paths/path.h": "#include <vector>\n", INTERNAL + "Voronoi/README.md": "# A room\n",
         INTERNAL + "Voronoi/cell.h": f"#include <{INTERNAL}paths/path.h>\n"},
        "of a sibling room"),
    "no room": (
        {INTERNAL + "stray.h": "#include <vector>\n"},
        "stray.h: in no room"),
    "unknown room": (
        {INTERNAL + "attic/stray.h": "#include <vector>\n"},
        "stray.h: in no room"),
    "crowded room": (
        {INTERNAL + f"paths/file_{i}.h": "#include <vector>\n" for i in range(MOST_FILES_IN_ROOM + 1)},
        "paths: 16 files"),
    "crowded subfolder": (
        {INTERNAL + f"window/shelf/file_{i}.h": "#include <vector>\n" for i in range(MOST_FILES_IN_ROOM)},
        "window/shelf: 16 files"),
    "subfolder without first page": (
        {INTERNAL + "window/attic/tool.h": "#include <vector>\n"},
        "window/attic: no README.md"),
    "first page without a file": (
        {INTERNAL + "window/stray.h": "#include <vector>\n"},
        "window/README.md: does not name stray.h"),
    "first page without a file of which it names a part": (
        {INTERNAL + "numeric/ow.h": "#include <vector>\n"},
        "numeric/README.md: does not name ow.h"),
    "first page of a subfolder without a file": (
        {INTERNAL + "window/shelf/stray.h": "#include <vector>\n"},
        "window/shelf/README.md: does not name stray.h"),
    "first page without a subfolder": (
        {INTERNAL + "window/README.md": "# A room: `high.h`, `user.h`\n"},
        "window/README.md: does not name shelf/"),
    "room without first page": (
        {INTERNAL + "surface/mesh.h": "#include <vector>\n"},
        "surface: no README.md"),
    "internal includes public": (
        {LOW: f"#include <{OWN}door.h>\n"},
        "of a higher room"),
    "room includes a public header that includes a room": (
        {OWN + "Propagation_statistics.h": LICENSE_LINE + f"#include <{LOW}>\n"},
        f"high.h: includes {OWN}Propagation_statistics.h of a higher room"),
    "room includes a public header that includes a mesh": (
        {OWN + "Propagation_statistics.h": LICENSE_LINE + "#include <CGAL/boost/graph/helpers.h>\n"},
        f"high.h: includes {OWN}Propagation_statistics.h of a higher room"),
    "room includes a public header that includes a public header": (
        {OWN + "Propagation_statistics.h": LICENSE_LINE + f"#include <{OWN}door.h>\n"},
        f"high.h: includes {OWN}Propagation_statistics.h of a higher room"),
    "mesh": (
        {LOW: "#include <CGAL/boost/graph/helpers.h>\n"},
        "low.h: includes <CGAL/boost/graph/helpers.h>"),
    "kernel": (
        {LOW: "  # include <CGAL/Simple_cartesian.h>\n"},
        "low.h: includes <CGAL/Simple_cartesian.h>"),
    "boost graph": (
        {LOW: "#include <boost/graph/graph_traits.hpp>\n"},
        "low.h: includes <boost/graph/graph_traits.hpp>"),
    "quotes": (
        {LOW: '#include "high.h"\n'},
        'low.h: includes "high.h" with quotes'),
    "missing file": (
        {LOW: f"#include <{INTERNAL}numeric/gone.h>\n"},
        "gone.h, which does not exist"),
    "internal license": (
        {LOW: LICENSE_LINE},
        "low.h: internal, but includes the license header"),
    "public without license": (
        {OWN + "door.h": "#include <vector>\n"},
        "door.h: public, but does not include the license header"),
    "convenience header included": (
        {OWN + "door.h": LICENSE_LINE + f"#include <{CONVENIENCE_HEADER}>\n"},
        "door.h: includes the convenience header"),
    "convenience header incomplete": (
        {OWN + "window.h": LICENSE_LINE},
        f"does not include {OWN}window.h"),
    "version": (
        {LOW: "#if CGAL_VERSION_NR\n#endif\n"},
        "low.h: mentions CGAL_VERSION"),
    "dead tolerance": (
        {LOW: "// Tolerance<FT>::length()\n"},
        "Tolerance.h: nobody calls length()"),
    "cycle": (
        {INTERNAL + "numeric/other.h": f"#include <{LOW}>\n", LOW: f"#include <{INTERNAL}numeric/other.h>\n"},
        "cycle of includes"),
    "cycle of a room and its subfolder": (
        {INTERNAL + "window/shelf/tool.h": f"#include <{HIGH}>\n"},
        "cycle of folders"),
    "cycle of two subfolders": (
        {INTERNAL + "window/attic/README.md": "# A subfolder: `tool.h`, `other.h`\n",
         INTERNAL + "window/attic/tool.h": f"#include <{INTERNAL}window/shelf/tool.h>\n",
         INTERNAL + "window/attic/other.h": "#include <vector>\n",
         INTERNAL + "window/shelf/other.h": f"#include <{INTERNAL}window/attic/other.h>\n"},
        "cycle of folders"),
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


def main(folder):
    number_of_files, complaints = check(folder)
    if number_of_files == 0:
        complaints.append(f"{folder}: there are no headers")
    return report(complaints, f"{number_of_files} headers")


if __name__ == "__main__":
    run_script(__doc__, self_test, main, [1])
