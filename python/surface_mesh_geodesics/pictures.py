"""Pictures with Matplotlib, which is imported when a picture is drawn."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np

from . import _arguments as arguments
from ._path import Path


def plot(V: Any, F: Any, values: Any = None, *, lines: Sequence[np.ndarray] = (), points: Any = None,
         axes: Any = None, cmap: str = "viridis", title: str | None = None) -> Any:
    """Draws a mesh, and returns the axes.

    values  (n,) numbers of the vertices, or else (m,) of the faces, shown as colors; infinite ones are gray
    lines   arrays of shape (k, 3), paths, or one of these
    points  (k, 3), drawn as dots
    axes    three-dimensional axes of Matplotlib to draw in; new ones by default

    Lines and dots are drawn on top of the surface, also those behind it. Raises ImportError without Matplotlib.

    >>> import surface_mesh_geodesics as smg
    >>> axes = smg.plot([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], [0, 3, 4])  # doctest: +SKIP
    """
    import matplotlib.pyplot as plt

    V = arguments.points_of("V", V)
    F = arguments.triangles_of("F", F, len(V))
    if len(F) == 0:
        raise ValueError("F has no faces: there is nothing to draw")
    if axes is not None and not hasattr(axes, "plot_trisurf"):
        raise ValueError("axes are not three-dimensional")
    if axes is None:
        axes = plt.figure(figsize=(7, 7)).add_subplot(projection="3d")
    surface = axes.plot_trisurf(V[:, 0], V[:, 1], V[:, 2], triangles=F, color="0.85", linewidth=0, antialiased=False,
                                shade=values is None)
    if values is not None:
        shown = np.ma.masked_invalid(_values_of_faces(arguments.row_of_numbers("values", values), V, F))
        colors = plt.get_cmap(cmap).with_extremes(bad="0.7")
        scale = plt.Normalize(shown.min() if shown.count() else 0, shown.max() if shown.count() else 1)
        surface.set_facecolor(colors(scale(shown)))
        axes.figure.colorbar(plt.cm.ScalarMappable(scale, colors), ax=axes, shrink=0.6)
    lines = [lines] if isinstance(lines, Path) or isinstance(lines, np.ndarray) and lines.ndim == 2 else lines
    # (Else Matplotlib hides all of a line behind the surface, or nothing.)
    axes.computed_zorder = False
    for i, line in enumerate(lines):
        line = arguments.points_of(f"lines[{i}]", line.points if isinstance(line, Path) else line)
        axes.plot(*line.T, color="black", linewidth=1.5, zorder=10)
    if points is not None:
        axes.scatter(*arguments.points_of("points", points).T, color="red", s=20, zorder=11)
    if np.ptp(V, axis=0).max() > 0:
        axes.set_box_aspect(np.maximum(np.ptp(V, axis=0), 1e-3 * np.ptp(V, axis=0).max()), zoom=1.3)
    axes.set_axis_off()
    if title is not None:
        axes.set_title(title)
    return axes


def _values_of_faces(values: np.ndarray, V: np.ndarray, F: np.ndarray) -> np.ndarray:
    if values.shape == (len(V),):
        return values[F].mean(axis=1)
    if values.shape == (len(F),):
        return values
    raise ValueError(f"values has shape {values.shape}, but there are {len(V)} vertices and {len(F)} faces")
