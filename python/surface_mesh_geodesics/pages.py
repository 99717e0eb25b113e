"""Pages for browsers: a surface with its distances that one can turn and click, in one file that needs no network."""

from __future__ import annotations

import base64
import html
import json
import pathlib
import re
from typing import Any, Sequence

import numpy as np

from . import _arguments as arguments
from ._isolines import linear_isolines
from ._path import Path

TEMPLATES = pathlib.Path(__file__).parent / "page"
THREE = (TEMPLATES / "three.min.js", pathlib.Path("/usr/share/javascript/three/three.min.js"))
THREE_LICENSE = (TEMPLATES / "copyright", pathlib.Path("/usr/share/doc/libjs-three/copyright"))


class Page:
    """A page that `page()` has made. A notebook shows it.

    >>> import surface_mesh_geodesics as smg
    >>> smg.Page("<!doctype html><p>text").text
    '<!doctype html><p>text'
    """

    def __init__(self, text: str) -> None:
        self.text = text

    def write(self, file: Any) -> None:
        """Writes the page to a file.

        >>> import os, surface_mesh_geodesics as smg
        >>> smg.Page("<!doctype html><p>text").write(os.devnull)
        """
        pathlib.Path(file).write_text(self.text, encoding="utf-8")

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.text)}" width="100%" height="600"></iframe>'


def page(V: Any, F: Any, distances: Any, *, sources: Any = None, paths: Path | Sequence[Path] = (), levels: Any = None,
         cells: Any = None, colors: Any = None, title: str = "Geodesic distances", file: Any = None) -> Page:
    """Makes a page that shows distances on a mesh, and writes it to a file if one is named.

    distances  (n,) of the vertices; inf where no source reaches
    sources    vertices, or (k, 3) points, that are drawn; by default the vertex with the least distance
    paths      one shortest path, or several, that are drawn
    levels     the distances of isolines: multiples of the first one; by default about ten round numbers
    cells      (m,) the cell of each face or -1, of a mesh that Voronoi.cut() has made; without isolines then
    colors     (k, 3) the color of each cell, as Voronoi.colors has them; needed with cells

    Needs three.js (Debian: libjs-three); raises FileNotFoundError if it is not there.

    >>> import surface_mesh_geodesics as smg
    >>> V, F = [[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]
    >>> page = smg.page(V, F, smg.Solver(V, F).distances(0), file="distances.html")  # doctest: +SKIP
    """
    V = arguments.points_of("V", V)
    F = arguments.triangles_of("F", F, len(V))
    d = arguments.row_without_nan("distances", arguments.values_of("distances", distances, len(V)))
    paths = [paths] if isinstance(paths, Path) else paths
    if len(F) == 0:
        raise ValueError("F has no faces: there is nothing to show")
    used = V[np.unique(F)]
    center = (used.max(axis=0) + used.min(axis=0)) / 2
    largest = float(d[np.isfinite(d)].max(initial=0.0))
    if levels is None:
        levels = _round_levels(largest) if cells is None else np.zeros(0)
    levels = arguments.row_without_nan("levels", levels)
    if np.isinf(levels).any() or largest > np.finfo(np.float32).max:
        raise ValueError("a page shows finite levels, and distances up to 3e38")
    cell_data = {} if cells is None else _cells(cells, colors, len(F))
    if sources is None or arguments.numbers_of("sources", sources).ndim < 2:
        shown = V[arguments.row_of_ids("sources", int(np.argmin(d)) if sources is None else sources, len(V))]
    else:
        shown = arguments.points_of("sources", sources)
    lines = [_lines("isoline", linear_isolines(V, F, d, levels), center)]
    dots = [{"role": "source", "points": _floats(shown, center)}]
    if len(paths) > 0:
        lines.append(_lines("path", [p.points for p in paths if len(p) > 1], center))
        dots.append({"role": "target", "points": _floats(np.array([p.points[-1] for p in paths if len(p) > 0])
                                                         .reshape(-1, 3), center)})
    result = Page(_filled({
        "title": title, "subtitle": f"{len(V)} vertices, {len(F)} faces", "center": center.tolist(),
        "radius": float(np.hypot.reduce(np.ptp(used, axis=0)) / 2), "points": _floats(V, center),
        "triangles": _base64(F.astype("<u4")), "distances": _base64(d.astype("<f4")), "largest": largest,
        "isolines": levels.tolist(), "cellColors": [], "lines": lines, "dots": dots, **cell_data}, title))
    if file is not None:
        result.write(file)
    return result


def _round_levels(largest: float) -> np.ndarray:
    if not largest > 1e-300:
        return np.zeros(0)
    power = 10.0 ** np.floor(np.log10(largest / 10))
    step = power * min((f for f in (1, 2, 5, 10) if f * power >= largest / 10), default=10)
    return step * np.arange(1, int(largest / step) + 1)


def _cells(cells: Any, colors: Any, n: int) -> dict:
    shown = arguments.ids_of("colors", np.zeros((0, 3)) if colors is None else colors, 256, "shades")
    if shown.ndim != 2 or shown.shape[1] != 3:
        raise ValueError(f"colors has shape {shown.shape}, but (k, 3) is needed")
    numbers = arguments.values_of("cells", cells, n, "faces")
    of_colors = arguments.ids_of("cells", np.where(numbers == -1, 0, numbers), len(shown), "colors")
    numbers = np.where(numbers == -1, 0xFFFFFFFF, of_colors)
    return {"cells": _base64(numbers.astype("<u4")), "cellColors": ["#%02x%02x%02x" % tuple(c) for c in shown]}


def _lines(role: str, lines: Sequence[np.ndarray], center: np.ndarray) -> dict:
    points = np.concatenate(lines) if len(lines) else np.zeros((0, 3))
    return {"role": role, "lengths": _base64(np.array([len(line) for line in lines], dtype="<u4")),
            "points": _floats(points, center)}


def _floats(points: np.ndarray, center: np.ndarray) -> str:
    """Relative to the center, so that 32 bits are precise enough far from the origin."""
    return _base64((points - center).astype("<f4"))


def _base64(array: np.ndarray) -> str:
    return base64.b64encode(np.ascontiguousarray(array).tobytes()).decode("ascii")


def _filled(data: dict, title: str) -> str:
    # No character of the data ends the script element.
    text = json.dumps(data).replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")
    parts = {"TITLE": html.escape(title), "LICENSE": html.escape(_license()), "THREE": _read(THREE, "three.js"),
             "DATA": text, **{p.name: p.read_text(encoding="utf-8") for p in TEMPLATES.glob("*.js")}}
    template = (TEMPLATES / "page.html").read_text(encoding="utf-8")
    return re.sub("@(" + "|".join(map(re.escape, parts)) + ")@", lambda match: parts[match[1]], template)


def _read(places: Sequence[pathlib.Path], what: str) -> str:
    for place in places:
        if place.is_file():
            return place.read_text(encoding="utf-8")
    raise FileNotFoundError(f"{what} is not there (Debian: libjs-three); looked for {places[0]} and {places[-1]}")


def _license() -> str:
    """The copyright and the conditions of three.js, out of Debian's file."""
    text = _read(THREE_LICENSE, "the license of three.js")
    owner = re.search(r"Files: \*\nCopyright: ([^\n]*)\nLicense: Expat", text)
    conditions = re.search(r"\nLicense: Expat\n( [^\n]*(?:\n [^\n]*)*)", text)
    if owner is None or conditions is None:
        return text
    return f"Copyright {owner[1]}\n\n" + re.sub(r"(?m)^ \.?", "", conditions[1])
