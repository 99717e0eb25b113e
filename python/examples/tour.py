"""A tour of the package on a bumpy surface: prints what it finds, and draws a picture of each step.

Usage: tour.py [FOLDER_FOR_PICTURES]    (needs Matplotlib for the pictures)
"""

import pathlib
import sys

import numpy as np

import surface_mesh_geodesics as smg


def bumpy_torus(m=90, n=45):
    """A torus with bumps: points (m n, 3) and triangles (2 m n, 3)."""
    i, j = np.meshgrid(np.arange(m), np.arange(n), indexing="ij")
    u, v = 2 * np.pi * i / m, 2 * np.pi * j / n
    r = 1 + 0.15 * np.sin(5 * u) * np.cos(3 * v)
    V = np.stack([(2.5 + r * np.cos(v)) * np.cos(u), (2.5 + r * np.cos(v)) * np.sin(u), r * np.sin(v)], axis=-1)
    a, b = i * n + j, (i + 1) % m * n + j
    c, d = (i + 1) % m * n + (j + 1) % n, i * n + (j + 1) % n
    return V.reshape(-1, 3), np.concatenate([np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)]).reshape(-1, 3)


V, F = bumpy_torus()
s = smg.Solver(V, F)
print(s)

# Distances from one vertex, and the proof that they are right.
d = s.distances(0)
far = int(d.argmax())
print(f"the farthest vertex is {far}, at {d[far]:.6f}; certified: {s.certify(d, 0).is_certified()}")

# The shortest path there, and lines of equal distance.
path = s.path(0, far)
print(path)
lines = s.isolines(d, np.arange(0.5, d.max(), 0.5))
print(f"{len(lines)} isolines")

# Distances from a whole curve: the path. Their feet are the nearest points of the curve.
from_path, (foot_face, foot_weights) = s.distances(smg.Curve((path.faces, path.barycentric)), return_foot=True)
feet = (V[F[foot_face]] * foot_weights[:, :, None]).sum(axis=1)
print(f"no vertex is farther than {from_path.max():.6f} from the path, in space {np.linalg.norm(V - feet, axis=1).max():.6f}")

# The directions in which shortest paths leave vertex 0. The straightest geodesic in one of them leads to the vertex,
# unless the path bends on its way.
d, angle = s.directions(0)
near = int(np.abs(d - 1).argmin())
traced = s.trace(0, angle[near], d[near])
print(f"tracing ends at {np.linalg.norm(traced.points[-1] - V[near]):.1e} from vertex {near}")

# Faces in the middle of the path become an obstacle.
obstacle = path.faces[60:80]
around = s.avoiding(obstacle).path(0, far)
print(f"around {len(np.unique(obstacle))} faces, the path is longer by {around.length - path.length:.1e}")

# Sites spread over the surface, and the regions that are nearest to each of them.
sites = s.sample(25)
v = s.voronoi(sites)
print(f"{len(v.adjacency)} pairs of neighbors, areas from {v.areas.min():.3f} to {v.areas.max():.3f}")
V2, F2, cell = v.cut()

# A coarser mesh, and distances between its corners on the original surface.
V3, F3 = s.remesh(400)
D = s.matrix(sites, sites)
print(f"{len(V3)} vertices, {len(F3)} faces; mean distance of two sites {D.mean():.3f}")


def in_front(lines):
    """The parts of lines on the upper half of the torus, which a view from above shows: lines are drawn on top of the
    surface, also those behind it."""
    pieces = []
    for line in lines:
        turns = np.flatnonzero(np.diff(line[:, 2] > 0)) + 1
        pieces += [piece for piece in np.split(line, turns) if piece[0, 2] > 0 and len(piece) > 1]
    return pieces


def draw(folder):
    import matplotlib

    matplotlib.use("Agg")
    folder.mkdir(parents=True, exist_ok=True)
    front = sites[V[sites, 2] > 0]
    pictures = {
        "distances": smg.plot(V, F, 0.5 * np.floor(2 * d), lines=in_front([p.points for p in s.paths(0, front)]),
                              points=V[front], title="distances in bands of 0.5, and shortest paths"),
        "from_a_curve": smg.plot(V, F, 0.25 * np.floor(4 * from_path), lines=in_front([path.points]),
                                 title="distances from a curve, in bands of 0.25"),
        "isolines": smg.plot(V, F, lines=in_front(lines), title="isolines"),
        "cells": smg.plot(V2, F2, np.random.default_rng(1).permutation(len(sites))[cell], cmap="tab20",
                          lines=in_front([line for i in range(len(sites)) for line in v.boundaries(i)]),
                          points=V[front], title="Voronoi diagram, and the sites in front"),
        "remeshed": smg.plot(V3, F3, title="400 vertices"),
    }
    pictures["cells"].figure.axes[-1].remove()  # the scale: numbers of cells mean nothing
    for name, axes in pictures.items():
        axes.view_init(90, -90)
        axes.figure.savefig(folder / f"{name}.png", dpi=110)
    print(f"pictures in {folder}")


if len(sys.argv) > 1:
    try:
        draw(pathlib.Path(sys.argv[1]))
    except ImportError:
        print("no pictures: Matplotlib is not installed")
