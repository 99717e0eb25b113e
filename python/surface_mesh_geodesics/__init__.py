"""Exact geodesic distances, shortest paths and geodesic Voronoi diagrams on triangle meshes.

>>> import numpy as np, surface_mesh_geodesics as smg
>>> V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
>>> F = np.array([[0, 1, 2], [0, 2, 3]])
>>> s = smg.Solver(V, F)
>>> [round(float(d), 6) for d in s.distances(1)]
[1.0, 0.0, 1.0, 1.414214]
>>> round(s.path(1, 3).length, 6)
1.414214

Lengths and distances have the unit of the points. Vertices and faces are counted from 0. A point of a face is a pair
(face, barycentric coordinates), with the coordinates in the order of the corners in F.
"""

from . import gdist
from ._core import __version__
from ._certificate import Certificate
from ._path import Curve, Path, TracedGeodesic
from ._solver import Solver
from ._voronoi import Boundary, DualReport, Voronoi
from .pages import Page, page
from .pictures import plot

__all__ = ["Boundary", "Certificate", "Curve", "DualReport", "Page", "Path", "Solver", "TracedGeodesic", "Voronoi",
           "gdist", "page", "plot", "__version__"]
