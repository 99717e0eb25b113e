#!/usr/bin/env python3
"""Writes a sphere with bumps as an OFF file: the small mesh of the examples.

usage: make_bumpy_sphere.py [subdivisions] > bumpy_sphere.off

An icosahedron is subdivided `subdivisions` times (default 4: 5120 faces) and every point is moved along its ray by a
sum of a few waves, so that the surface has convex and saddle regions and no symmetry.
"""
import math
import sys

# amplitude, frequency along x, y, z, phase
WAVES = [(0.09, 5.1, 1.3, -2.2, 0.4), (0.07, -1.7, 6.3, 1.9, 1.1), (0.08, 2.3, -1.1, 5.7, 2.5), (0.03, 9.1, 7.7, -8.3, 0.0)]


def icosahedron():
    g = (1 + math.sqrt(5)) / 2
    points = []
    for a in (-1, 1):
        for b in (-g, g):
            points += [(0, a, b), (a, b, 0), (b, 0, a)]
    # Three points with pairwise distance 2 make a face. Faces are oriented outward.
    faces = []
    for i in range(12):
        for j in range(i + 1, 12):
            for k in range(j + 1, 12):
                p, q, r = points[i], points[j], points[k]
                if all(abs(math.dist(x, y) - 2) < 1e-9 for x, y in ((p, q), (q, r), (r, p))):
                    outside = (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2])
                               + p[2] * (q[0] * r[1] - q[1] * r[0])) > 0
                    faces.append((i, j, k) if outside else (i, k, j))
    return [normalized(p) for p in points], faces


def normalized(p):
    length = math.hypot(*p)
    return tuple(c / length for c in p)


def subdivided(points, faces):
    points = list(points)
    middle = {}

    def midpoint(i, j):
        key = (min(i, j), max(i, j))
        if key not in middle:
            middle[key] = len(points)
            points.append(normalized(tuple(a + b for a, b in zip(points[i], points[j]))))
        return middle[key]

    fine = []
    for i, j, k in faces:
        a, b, c = midpoint(i, j), midpoint(j, k), midpoint(k, i)
        fine += [(i, a, c), (j, b, a), (k, c, b), (a, b, c)]
    return points, fine


def bumpy(p):
    radius = 1 + sum(a * math.sin(x * p[0] + y * p[1] + z * p[2] + phase) for a, x, y, z, phase in WAVES)
    return tuple(radius * c for c in p)


def main():
    points, faces = icosahedron()
    for _ in range(int(sys.argv[1]) if len(sys.argv) > 1 else 4):
        points, faces = subdivided(points, faces)
    print("OFF\n%d %d 0" % (len(points), len(faces)))
    for p in points:
        print("%.6f %.6f %.6f" % bumpy(p))
    for f in faces:
        print("3 %d %d %d" % f)


if __name__ == "__main__":
    main()
