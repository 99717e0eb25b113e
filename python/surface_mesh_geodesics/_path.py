from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True, eq=False)
class Curve:
    """A curve on a surface, which may be a source of distances: straight segments from place to place.

    places  given as several sources are; two in a row are in one face, and so are the ends of a closed curve
    closed  whether a last segment leads from the last place to the first one

    A curve may cross, touch and repeat itself. The places of a `Path` p make the curve along it:
    Curve((p.faces, p.barycentric)).

    >>> import surface_mesh_geodesics as smg
    >>> s = smg.Solver([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
    >>> s.distances(smg.Curve([0, 1]))
    array([0., 0., 2., 2.])
    """

    places: Any
    closed: bool = False


@dataclass(frozen=True, eq=False)
class Path:
    """A shortest path from a source to a target; without points if no source reaches the target.

    Consecutive points lie in one face. The lengths between them add up to `length`, up to rounding.

    >>> import surface_mesh_geodesics as smg
    >>> smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).path(1, 2)
    Path(length=5, source=0, 2 points)
    """

    length: float  #: in the unit of the points; infinite if there is no path
    source: int  #: the position of the source among the sources; -1 if there is no path
    points: np.ndarray  #: (k, 3), from the source to the target
    faces: np.ndarray  #: (k,), a face of each point; -1 for a vertex without faces
    barycentric: np.ndarray  #: (k, 3), the coordinates of each point in its face

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"Path(length={self.length:.6g}, source={self.source}, {len(self.points)} points)"


@dataclass(frozen=True, eq=False)
class TracedGeodesic:
    """The straightest geodesic from a place in a direction. The segment before a point lies in the face of the point.

    >>> import surface_mesh_geodesics as smg
    >>> smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).trace((0, [1, 0, 0]), 0, 2)
    TracedGeodesic(length=2, end='length', 2 points)
    """

    length: float  #: in the unit of the points; less than was asked for unless `end` is 'length'
    end: str  #: why it ends: 'length', 'border', or 'singularity' (nothing is straight on there)
    direction: float  #: in which it would go on from its last point
    points: np.ndarray  #: (k, 3)
    faces: np.ndarray  #: (k,), the face of each point
    barycentric: np.ndarray  #: (k, 3), the coordinates of each point in its face

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"TracedGeodesic(length={self.length:.6g}, end={self.end!r}, {len(self.points)} points)"
