#!/usr/bin/env python3
"""Draws the figures of the manual that explain the theory and the rooms of the code, as SVG files.

Usage: draw_theory_figures.py [FOLDER] | --check

The default folder is doc/Surface_mesh_geodesics/fig. --check compares the files there with what this script draws.
Points are computed, not placed by eye: lines that seem to meet do meet. The colors are those of Okabe and Ito, which
color-blind readers can tell apart.
"""

import math
import pathlib
import sys

from complaints import report

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "doc" / "Surface_mesh_geodesics" / "fig"

BLUE, ORANGE, GREEN, PURPLE, GRAY = "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#888888"
LIGHT_BLUE, LIGHT_ORANGE, LIGHT_GREEN, LIGHT_GRAY = "#BBDDF2", "#F6D0B5", "#BFE8DA", "#EEEEEE"


# --- points ----------------------------------------------------------------------------------------------------------


def intersection(p, q, r, s):
    """The intersection of the lines pq and rs."""
    (px, py), (qx, qy), (rx, ry), (sx, sy) = p, q, r, s
    determinant = (qx - px) * (sy - ry) - (qy - py) * (sx - rx)
    t = ((rx - px) * (sy - ry) - (ry - py) * (sx - rx)) / determinant
    return (px + t * (qx - px), py + t * (qy - py))


def between(p, q, t):
    return (p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]))


def toward(p, q, length):
    return between(p, q, length / math.dist(p, q))


# --- drawing ---------------------------------------------------------------------------------------------------------


class Picture:
    """A drawing whose y axis points upward."""

    def __init__(self, left, bottom, right, top, scale=80):
        self.left, self.top, self.scale = left, top, scale
        self.width, self.height = (right - left) * scale, (top - bottom) * scale
        self.elements = []

    def position(self, p):
        return f"{(p[0] - self.left) * self.scale:.1f}", f"{(self.top - p[1]) * self.scale:.1f}"

    def add(self, element):
        self.elements.append("  " + element)

    def polygon(self, points, fill, stroke="none", width=1.5):
        path = " ".join(",".join(self.position(p)) for p in points)
        self.add(f'<polygon points="{path}" fill="{fill}" stroke="{stroke}" stroke-width="{width}" '
                 'stroke-linejoin="round"/>')

    def curve(self, points, color="black", width=1.5, dashes=None, arrow=False):
        path = " ".join(",".join(self.position(p)) for p in points)
        dash = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.add(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="{width}"{dash} '
                 'stroke-linecap="round"/>')
        if arrow:
            self.tip(points[-2], points[-1], color)

    def line(self, p, q, color="black", width=1.5, dashes=None, arrow=False):
        self.curve([p, q], color, width, dashes, arrow)

    def tip(self, p, q, color):
        """The tip of an arrow from p, at q."""
        length = 0.13 * 80 / self.scale
        direction = math.atan2(q[1] - p[1], q[0] - p[0])
        wings = [(q[0] - length * math.cos(direction + turn), q[1] - length * math.sin(direction + turn))
                 for turn in (0.42, -0.42)]
        self.polygon([q, wings[0], wings[1]], color)

    def dot(self, p, color="black", radius=4):
        x, y = self.position(p)
        self.add(f'<circle cx="{x}" cy="{y}" r="{radius}" fill="{color}"/>')

    def text(self, p, words, color="black", shift=(0, 0), anchor="middle", slanted=True, size=17):
        x, y = self.position((p[0] + shift[0], p[1] + shift[1]))
        style = ' font-style="italic"' if slanted else ""
        self.add(f'<text x="{x}" y="{y}" fill="{color}" text-anchor="{anchor}" font-size="{size}"{style}>{words}'
                 '</text>')

    def label(self, p, words, color="black", shift=(0, 0), anchor="middle", size=15):
        self.text(p, words, color, shift, anchor, slanted=False, size=size)

    def __str__(self):
        size = f'width="{self.width:.0f}" height="{self.height:.0f}" viewBox="0 0 {self.width:.0f} {self.height:.0f}"'
        return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="DejaVu Sans, sans-serif">',
                          '  <rect width="100%" height="100%" fill="white"/>'] + self.elements + ["</svg>", ""])


# --- the figures -----------------------------------------------------------------------------------------------------


def window():
    """A window, the strip that it crossed, and its two parts beyond the next face."""
    picture = Picture(-0.8, -3.5, 5.2, 3.1)
    a, b, c, d, image = (0, 0), (4, 0), (1.7, 2.6), (2.2, -1.4), (0.3, -3.0)
    begin, end = (0.45, 0), (2.9, 0)
    on_left, on_right = intersection(image, begin, a, c), intersection(image, end, c, b)
    picture.polygon([image, begin, end], LIGHT_BLUE)
    picture.polygon([begin, on_left, c, on_right, end], LIGHT_BLUE)
    for face in ([a, b, c], [a, b, d], [a, d, image]):
        picture.polygon(face, "none", "black", 1.5)
    for ray in (on_left, c, on_right):
        picture.line(image, ray, BLUE, 1.5, dashes="6,4")
    picture.line(begin, end, BLUE, 5)
    picture.line(on_left, c, ORANGE, 5)
    picture.line(c, on_right, GREEN, 5)
    picture.dot(image, BLUE, 5)
    picture.text(a, "A", shift=(-0.2, -0.05))
    picture.text(b, "B", shift=(0.2, -0.05))
    picture.text(c, "C", shift=(0, 0.15))
    picture.label(image, "image of the pseudo-source", BLUE, shift=(0.2, -0.25), anchor="start")
    picture.label((3.0, 0), "interval", BLUE, shift=(0.25, 0.13))
    picture.label(between(a, c, 0.75), "to the left", ORANGE, shift=(-0.2, 0.1), anchor="end")
    picture.label(between(c, b, 0.2), "to the right", GREEN, shift=(0.25, 0.1), anchor="start")
    return picture


def pairs_of_windows():
    """Why the part of the right window on the left of K is dominated."""
    picture = Picture(-0.5, -3.7, 4.9, 0.8)
    a, b = (0, 0), (4.4, 0)
    left, right = (0.8, -2.2), (3.7, -3.2)
    begin0, k, begin1, end1 = (0.4, 0), (2.6, 0), (1.3, 0), (3.9, 0)
    x = (1.7, 0)
    y = intersection(left, k, right, x)
    picture.polygon([left, begin0, k], LIGHT_BLUE)
    picture.polygon([right, begin1, end1], LIGHT_ORANGE)
    picture.polygon([intersection(left, k, right, begin1), begin1, k], LIGHT_GRAY)
    for image, ends, color in ((left, (begin0, k), BLUE), (right, (begin1, end1), ORANGE)):
        for point in ends:
            picture.line(image, point, color, 1.5)
    picture.line(right, x, ORANGE, 1.5, dashes="6,4")
    picture.line(a, b, "black", 2)
    picture.line(begin0, k, BLUE, 5)
    picture.line(k, end1, ORANGE, 5)
    picture.line((1.3, 0.07), (2.6, 0.07), GRAY, 4, dashes="5,5")
    for point, color in ((left, BLUE), (right, ORANGE), (y, "black"), (k, "black")):
        picture.dot(point, color)
    picture.text(a, "A", shift=(-0.2, -0.05))
    picture.text(b, "B", shift=(0.2, -0.05))
    picture.text(k, "K", shift=(0.1, 0.17))
    picture.text(y, "Y", shift=(0.28, -0.03))
    picture.text(left, "w₀", BLUE, shift=(-0.3, -0.1))
    picture.text(right, "w₁", ORANGE, shift=(0.3, -0.1))
    picture.label((1.9, 0), "dominated part of w₁", GRAY, shift=(-0.45, 0.25))
    return picture


def rule_1():
    """One angle, two sides: where the windows of a list go."""
    picture = Picture(-0.8, -2.9, 5.3, 3.1)
    a, b, c = (0, 0), (4.4, 0), (2.3, 2.6)
    images = [(1.0, -2.3), (2.1, -2.5), (3.6, -2.3)]
    intervals = [(0.35, 1.95), (1.6, 2.9), (2.45, 4.1)]
    colors, lights = [BLUE, GREEN, ORANGE], [LIGHT_BLUE, LIGHT_GREEN, LIGHT_ORANGE]
    s = intersection(images[1], c, a, b)
    for image, (begin, end), light in zip(images, intervals, lights):
        picture.polygon([image, (begin, 0), (end, 0)], light)
    # The part of the left window that reaches the right edge is left out, and its mirror image too.
    last, first = intersection(images[0], c, a, b), intersection(images[2], c, a, b)
    on_edges = [(intersection(images[0], (0.35, 0), a, c), c),
                (intersection(images[1], (1.6, 0), a, c), intersection(images[1], (2.9, 0), c, b)),
                (c, intersection(images[2], (4.1, 0), c, b))]
    picture.polygon([(0.35, 0), *on_edges[0], last], lights[0])
    picture.polygon([first, *on_edges[2], (4.1, 0)], lights[2])
    picture.polygon([(1.6, 0), on_edges[1][0], c, on_edges[1][1], (2.9, 0)], lights[1])
    picture.polygon([a, b, c], "none", "black", 1.5)
    for (begin, end), color in zip(intervals, colors):
        picture.line((begin, 0), (end, 0), color, 5)
    for image, pair, color in zip(images, on_edges, colors):
        for point in pair:
            picture.line(image, point, color, 1.5, dashes="6,4")
        picture.dot(image, color)
    picture.line(images[1], c, "black", 2)
    picture.dot(s)
    picture.dot(c)
    picture.text(a, "A", shift=(-0.2, -0.05))
    picture.text(b, "B", shift=(0.2, -0.05))
    picture.text(c, "C", shift=(0, 0.17))
    picture.text(s, "S", shift=(0.2, -0.3))
    picture.text(images[1], "wₛ", GREEN, shift=(0.3, -0.1))
    picture.label(images[0], "only to AC", BLUE, shift=(0, -0.35))
    picture.label(images[2], "only to CB", ORANGE, shift=(0, -0.35))
    return picture


def wavefront():
    """A visit of a vertex: it carries the lists on its edges through the faces around it, in both directions."""
    picture = Picture(-2.2, -2.3, 5.6, 2.3, 70)
    center = (0, 0)
    ring = [(2.0 * math.cos(angle), 2.0 * math.sin(angle)) for angle in (math.pi * (2 * i + 1) / 6 for i in range(6))]
    for i in range(6):
        reached = i in (3, 4)  # the two faces below
        picture.polygon([center, ring[i], ring[(i + 1) % 6]], LIGHT_GRAY if reached else "white", "black", 1.5)
    for i in (3, 4, 5):
        picture.line(toward(center, ring[i], 0.35), toward(center, ring[i], 1.75), PURPLE, 5)
    for i in (5, 0, 1, 2):
        middle = between(ring[i], ring[(i + 1) % 6], 0.5)
        picture.line(between(ring[i], middle, 0.25), between(ring[(i + 1) % 6], middle, 0.25), GREEN, 5)
    for begin, end, radius, color in ((-20, 95, 0.95, BLUE), (200, 85, 1.3, ORANGE)):
        steps = [begin + (end - begin) * k / 30 for k in range(31)]
        arc = [(radius * math.cos(math.radians(t)), radius * math.sin(math.radians(t))) for t in steps]
        picture.curve(arc, color, 2, arrow=True)
    picture.dot(center, "black", 6)
    picture.text(center, "v", shift=(0.14, 0.2))
    words = (("lists that wait on the edges of v", PURPLE), ("carried counterclockwise", BLUE),
             ("carried clockwise", ORANGE), ("lists that wait afterward", GREEN),
             ("faces that were reached before", GRAY))
    for k, (text, color) in enumerate(words):
        picture.label((2.1, 1.2 - 0.55 * k), text, color, anchor="start")
    return picture


def redundant_windows():
    """Faces behind the wavefront: only faces that a curve crosses keep their windows."""
    picture = Picture(-0.3, -0.9, 8.8, 4.3, 60)
    sites, radius, side = [(3.0, 2.0), (5.0, 2.2)], 2.0, 0.5
    height = side * math.sqrt(3) / 2
    columns, rows = 15, 4.2 / height

    def distances(p):
        return [math.dist(p, site) for site in sites]

    for row in range(int(rows)):
        for column in range(columns):
            x, y = column * side + (row % 2) * side / 2, row * height
            upright = [(x, y), (x + side, y), (x + side / 2, y + height)]
            shift = side / 2
            inverted = [(x + side, y), (x + shift, y + height), (x + side + shift, y + height)]
            for face in (upright, inverted):
                far = max(min(distances(p)) for p in face)
                nearest = {min((0, 1), key=lambda i, p=p: distances(p)[i]) for p in face}
                fill = "white" if far > radius + 0.35 else LIGHT_ORANGE if far > radius - 0.35 else \
                    LIGHT_BLUE if len(nearest) == 2 else LIGHT_GRAY
                picture.polygon(face, fill, GRAY, 0.7)
    middle = between(*sites, 0.5)
    across = (-(sites[1][1] - sites[0][1]), sites[1][0] - sites[0][0])
    length = math.hypot(*across)
    half = math.sqrt((radius - 0.35)**2 - (math.dist(*sites) / 2)**2)
    curve = [(middle[0] + t * across[0] / length, middle[1] + t * across[1] / length) for t in (-half, half)]
    picture.line(*curve, BLUE, 3)
    for site in sites:
        picture.dot(site, "black", 5)
    for k, (fill, words) in enumerate(((LIGHT_ORANGE, "wavefront: kept"), (LIGHT_BLUE, "crossed: cut, then removed"),
                                       (LIGHT_GRAY, "one site: removed"))):
        x = (0.0, 2.7, 6.4)[k]
        picture.polygon([(x, -0.65), (x + 0.25, -0.65), (x + 0.25, -0.4), (x, -0.4)], fill, GRAY)
        picture.label((x + 0.35, -0.6), words, anchor="start", size=13)
    return picture


def arc_in_face():
    """The curve between two cells in a face, if the paths bend at different distances: a piece of a hyperbola."""
    picture = Picture(-1.2, -1.8, 5.6, 3.6)
    a, b, c = (0, 0), (4.8, 0), (2.0, 3.2)
    first, second, offset = (0.9, -1.2), (4.3, -0.9), 1.1  # how much farther the first pseudo-source is from its site

    def difference(p):
        return math.dist(p, first) + offset - math.dist(p, second)

    def point_at_height(y):
        low, high = -1.0, 6.0
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (middle, high) if difference((middle, y)) < 0 else (low, middle)
        return (low, y)

    def is_inside(p):
        (px, py) = p
        edges = ((a, b), (b, c), (c, a))
        return all((qx - rx) * (py - ry) - (qy - ry) * (px - rx) >= 0 for (rx, ry), (qx, qy) in edges)

    hyperbola = [p for p in (point_at_height(3.2 * k / 200) for k in range(201)) if is_inside(p)]
    if hyperbola[-1][0] < c[0]:
        left, right = [a] + hyperbola, [hyperbola[0], b, c] + hyperbola[::-1]
    else:
        left, right = [a] + hyperbola + [c], [b] + hyperbola[::-1]
    picture.polygon(left, LIGHT_BLUE)
    picture.polygon(right, LIGHT_ORANGE)
    picture.polygon([a, b, c], "none", "black", 1.5)
    on_arc = hyperbola[len(hyperbola) // 2]
    for image, color in ((first, BLUE), (second, ORANGE)):
        picture.line(image, on_arc, color, 1.5, dashes="6,4")
        picture.dot(image, color, 5)
    picture.curve(hyperbola, "black", 3)
    picture.dot(hyperbola[0])
    picture.dot(hyperbola[-1])
    picture.label(first, "image, offset 1.1", BLUE, shift=(-0.1, -0.35))
    picture.label(second, "image, offset 0", ORANGE, shift=(0, -0.35))
    picture.label(between(a, on_arc, 0.5), "cell", BLUE, shift=(0.0, 0.25))
    picture.label(between(b, on_arc, 0.45), "cell", ORANGE, shift=(0, 0.45))
    picture.label(hyperbola[-1], "arc", shift=(-0.15, 0.1), anchor="end")
    return picture


# Room -> its position (column, row), and the rooms right below it, which its arrows lead to.
ROOMS = {
    "public headers": ((2, 7), ["applications", "interface"]),
    "applications": ((2, 6), ["interface"]),
    "interface": ((2, 5), ["certificate"]),
    "certificate": ((2, 4), ["propagation", "paths", "Voronoi"]),
    "propagation": ((-0.6, 3), ["window"]),
    "paths": ((2, 3), ["window"]),
    "Voronoi": ((4.6, 3), ["window"]),
    "window": ((2, 2), ["surface"]),
    "surface": ((2, 1), ["numeric"]),
    "numeric": ((2, 0), []),
}
WORDS_OF_ROOMS = {
    "public headers": "documentation, declarations", "applications": "sampling, remeshing, writers",
    "interface": "meshes, kernels, maps", "certificate": "checks, lower bound", "propagation": "wavefront, visits, runs",
    "paths": "tracing, isolines", "Voronoi": "cells, arcs, curves", "window": "lists, pruning, lanes",
    "surface": "triangles, sources", "numeric": "plane, tolerances",
}


def rooms():
    """The folders of internal/, and the direction of the includes."""
    picture = Picture(-1.9, -0.45, 5.9, 7.45, 80)
    half_width, half_height = 1.15, 0.31
    for name, ((x, y), below) in ROOMS.items():
        fill = LIGHT_ORANGE if y == 7 else LIGHT_BLUE if y > 4 else LIGHT_GREEN if y > 1 else LIGHT_GRAY
        corners = [(x + i * half_width, y + j * half_height) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        picture.polygon(corners, fill, "black", 1.5)
        picture.label((x, y), name, shift=(0, 0.03))
        picture.label((x, y), WORDS_OF_ROOMS[name], "#444444", shift=(0, -0.2), size=12)
        for other in below:
            (to_x, to_y), _ = ROOMS[other]
            if (name, other) == ("public headers", "interface"):
                right = x + half_width
                picture.curve([(right, y), (right + 0.35, y), (right + 0.35, to_y), (right, to_y)], arrow=True)
                continue
            shift = 0.25 * (to_x - x)
            picture.line((x + shift, y - half_height), (to_x - shift, to_y + half_height), arrow=True)
    return picture


def is_blocked(x, y):
    """The squares of the floor of the example paths_around_obstacles."""
    return ((x == 9 and y not in (3, 4)) or (x == 19 and y != 15) or (x == 4 and 8 <= y <= 11)
            or (13 <= x <= 15 and 9 <= y <= 10) or (x == 24 and y in (6, 12)))


def halves(x, y):
    """The two triangles that make_grid() of CGAL makes of a square."""
    return ((x, y), (x + 1, y), (x, y + 1)), ((x + 1, y), (x + 1, y + 1), (x, y + 1))


def shortest_way(nodes, start, end, neighbors):
    """The shortest way in a graph of points, by Dijkstra's method without a queue."""
    length, before, waiting = {start: 0}, {}, set(nodes) | {start, end}
    while waiting:
        p = min(waiting, key=lambda q: (length.get(q, math.inf), q))
        waiting.remove(p)
        if p == end:
            break
        for q in neighbors(p):
            if q in waiting and length[p] + math.dist(p, q) < length.get(q, math.inf) - 1e-9:
                length[q], before[q] = length[p] + math.dist(p, q), p
    way = [end]
    while way[-1] != start:
        way.append(before[way[-1]])
    return way[::-1]


def obstacles():
    """The exact way around walls and pillars, and the way through the centers of edges."""
    columns, rows = 30, 20
    squares = [(x, y) for x in range(columns) for y in range(rows)]
    blocked = [s for s in squares if is_blocked(*s)]
    picture = Picture(-0.6, -0.6, columns + 0.6, rows + 0.6, 24)

    def crosses(p, q, square):
        """Whether a segment meets the inside of a square, which goes on beyond the border of the floor."""
        first, last = 0.0, 1.0
        for a, b, place, size in ((p[0], q[0], square[0], columns), (p[1], q[1], square[1], rows)):
            low, high = place - (place == 0) + 1e-9, place + 1 + (place + 1 == size) - 1e-9
            if a == b:
                if not low < a < high:
                    return False
                continue
            ends = sorted(((low - a) / (b - a), (high - a) / (b - a)))
            first, last = max(first, ends[0]), min(last, ends[1])
        return first < last

    corners = sorted({(x + i, y + j) for x, y in blocked for i in (0, 1) for j in (0, 1)})
    corners = [c for c in corners if sum(is_blocked(c[0] - i, c[1] - j) for i in (0, 1) for j in (0, 1)) == 1
               and 0 < c[0] < columns and 0 < c[1] < rows]

    def visible_from(p):
        return [q for q in corners + ends if q != p and not any(crosses(p, q, s) for s in blocked)]

    # The graph of the centers of edges: those of one triangle are neighbors.
    around = {}
    for x, y in squares:
        if not is_blocked(x, y):
            for triangle in halves(x, y):
                middles = [between(triangle[k], triangle[(k + 1) % 3], 0.5) for k in range(3)]
                for place in middles + list(triangle):
                    around.setdefault(place, set()).update(middles)
    for end in ((columns, 0), (columns, rows)):
        for place in sorted(around[end]):
            around[place] = around[place] | {end}

    picture.polygon([(0, 0), (columns, 0), (columns, rows), (0, rows)], "none", "black", 1.5)
    for x, y in blocked:
        picture.polygon([(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)], GRAY, GRAY, 1)
    for x, y in squares:
        if not is_blocked(x, y):
            for triangle in halves(x, y):
                picture.polygon(triangle, "none", LIGHT_GRAY, 0.7)
    start = (0, 0)
    for end in ((columns, 0), (columns, rows)):
        ends = [start, end]
        centers = [place for place in around if place[0] % 1 or place[1] % 1]
        picture.curve(shortest_way(centers, start, end, lambda p: sorted(around[p])), ORANGE, 2, dashes="6,4")
        picture.curve(shortest_way(corners, start, end, visible_from), BLUE, 3)
        picture.dot(end)
    picture.dot(start)
    return picture


# The walls of the example paths_between_walls, on a floor of 12 x 8 squares.
WALLS = (((4, 0), (4, 6)), ((8, 2), (8, 8)), ((8, 4), (11, 4)))


def walls():
    """The exact ways between walls without thickness."""
    columns, rows = 12, 8
    picture = Picture(-0.4, -0.4, columns + 0.4, rows + 0.4, 56)
    start, targets = (1, 1), ((3, 1), (5, 1), (11, 1), (10, 6))
    free_ends = [(4, 6), (8, 2), (11, 4)]

    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    def is_seen(p, q):
        return not any(side(p, q, a) * side(p, q, b) < 0 and side(a, b, p) * side(a, b, q) < 0 for a, b in WALLS)

    for x in range(columns):
        for y in range(rows):
            for triangle in halves(x, y):
                picture.polygon(triangle, "none", LIGHT_GRAY, 0.7)
    picture.polygon([(0, 0), (columns, 0), (columns, rows), (0, rows)], "none", "black", 1.5)
    for a, b in WALLS:
        picture.line(a, b, "black", 4)
    for target in targets:
        nodes = free_ends + [start, target]
        way = shortest_way(nodes, start, target, lambda p, all_of=tuple(nodes): [q for q in all_of if is_seen(p, q)])
        picture.curve(way, BLUE, 3)
        picture.dot(target)
        picture.label(target, f"{sum(math.dist(p, q) for p, q in zip(way, way[1:])):.2f}", shift=(0.1, 0.22),
                      anchor="start")
    picture.dot(start)
    return picture


FIGURES = (window, pairs_of_windows, rule_1, wavefront, redundant_windows, arc_in_face, rooms, obstacles, walls)


def main(arguments):
    if len(arguments) > 1:
        print(__doc__)
        return 2
    check = arguments == ["--check"]
    folder = FOLDER if check or not arguments else pathlib.Path(arguments[0])
    complaints = []
    for figure in FIGURES:
        path, text = folder / f"theory_{figure.__name__}.svg", str(figure())
        if check:
            if not path.exists() or path.read_text(encoding="utf-8") != text:
                complaints.append(f"{path} is not what this script draws")
        else:
            path.write_text(text, encoding="utf-8")
    return report(complaints, f"{len(FIGURES)} figures")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
