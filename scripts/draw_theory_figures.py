#!/usr/bin/env python3
"""Draws the figures of the theory in the manual, as SVG files.

Usage: draw_theory_figures.py [FOLDER] | --check

The folder is doc/Surface_mesh_geodesics/fig if none is given. --check compares the files there with what would be
drawn. All lines that look as if they met do: points are computed, not placed by eye. Colours are those of Okabe and
Ito, which can be told apart by those who are blind to some colours.
"""

import math
import pathlib
import sys

from complaints import report

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "doc" / "Surface_mesh_geodesics" / "fig"

BLUE, ORANGE, GREEN, PURPLE, GREY = "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#888888"
LIGHT_BLUE, LIGHT_ORANGE, LIGHT_GREEN, LIGHT_GREY = "#BBDDF2", "#F6D0B5", "#BFE8DA", "#EEEEEE"


# --- points ----------------------------------------------------------------------------------------------------------


def crossing(p, q, r, s):
    """Where the lines pq and rs meet."""
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
    """A drawing with the y axis upwards."""

    def __init__(self, left, bottom, right, top, scale=80):
        self.left, self.top, self.scale = left, top, scale
        self.width, self.height = (right - left) * scale, (top - bottom) * scale
        self.elements = []

    def place(self, p):
        return f"{(p[0] - self.left) * self.scale:.1f}", f"{(self.top - p[1]) * self.scale:.1f}"

    def add(self, element):
        self.elements.append("  " + element)

    def polygon(self, points, fill, stroke="none", width=1.5):
        path = " ".join(",".join(self.place(p)) for p in points)
        self.add(f'<polygon points="{path}" fill="{fill}" stroke="{stroke}" stroke-width="{width}" '
                 'stroke-linejoin="round"/>')

    def curve(self, points, colour="black", width=1.5, dashes=None, arrow=False):
        path = " ".join(",".join(self.place(p)) for p in points)
        dash = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.add(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"{dash} '
                 'stroke-linecap="round"/>')
        if arrow:
            self.tip(points[-2], points[-1], colour)

    def line(self, p, q, colour="black", width=1.5, dashes=None, arrow=False):
        self.curve([p, q], colour, width, dashes, arrow)

    def tip(self, p, q, colour):
        """The tip of an arrow from p, at q."""
        length = 0.13 * 80 / self.scale
        direction = math.atan2(q[1] - p[1], q[0] - p[0])
        wings = [(q[0] - length * math.cos(direction + turn), q[1] - length * math.sin(direction + turn))
                 for turn in (0.42, -0.42)]
        self.polygon([q, wings[0], wings[1]], colour)

    def dot(self, p, colour="black", radius=4):
        x, y = self.place(p)
        self.add(f'<circle cx="{x}" cy="{y}" r="{radius}" fill="{colour}"/>')

    def text(self, p, words, colour="black", shift=(0, 0), anchor="middle", slanted=True, size=17):
        x, y = self.place((p[0] + shift[0], p[1] + shift[1]))
        style = ' font-style="italic"' if slanted else ""
        self.add(f'<text x="{x}" y="{y}" fill="{colour}" text-anchor="{anchor}" font-size="{size}"{style}>{words}'
                 '</text>')

    def label(self, p, words, colour="black", shift=(0, 0), anchor="middle", size=15):
        self.text(p, words, colour, shift, anchor, slanted=False, size=size)

    def __str__(self):
        size = f'width="{self.width:.0f}" height="{self.height:.0f}" viewBox="0 0 {self.width:.0f} {self.height:.0f}"'
        return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="DejaVu Sans, sans-serif">',
                          '  <rect width="100%" height="100%" fill="white"/>'] + self.elements + ["</svg>", ""])


# --- the figures -----------------------------------------------------------------------------------------------------


def window():
    """A window, the strip that it came through, and its two parts beyond the next face."""
    picture = Picture(-0.8, -3.5, 5.2, 3.1)
    a, b, c, d, image = (0, 0), (4, 0), (1.7, 2.6), (2.2, -1.4), (0.3, -3.0)
    begin, end = (0.45, 0), (2.9, 0)
    on_left, on_right = crossing(image, begin, a, c), crossing(image, end, c, b)
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
    """Why the part of the right window on the left of K is redundant."""
    picture = Picture(-0.5, -3.7, 4.9, 0.8)
    a, b = (0, 0), (4.4, 0)
    left, right = (0.8, -2.2), (3.7, -3.2)
    begin0, k, begin1, end1 = (0.4, 0), (2.6, 0), (1.3, 0), (3.9, 0)
    x = (1.7, 0)
    y = crossing(left, k, right, x)
    picture.polygon([left, begin0, k], LIGHT_BLUE)
    picture.polygon([right, begin1, end1], LIGHT_ORANGE)
    picture.polygon([crossing(left, k, right, begin1), begin1, k], LIGHT_GREY)
    for image, ends, colour in ((left, (begin0, k), BLUE), (right, (begin1, end1), ORANGE)):
        for point in ends:
            picture.line(image, point, colour, 1.5)
    picture.line(right, x, ORANGE, 1.5, dashes="6,4")
    picture.line(a, b, "black", 2)
    picture.line(begin0, k, BLUE, 5)
    picture.line(k, end1, ORANGE, 5)
    picture.line((1.3, 0.07), (2.6, 0.07), GREY, 4, dashes="5,5")
    for point, colour in ((left, BLUE), (right, ORANGE), (y, "black"), (k, "black")):
        picture.dot(point, colour)
    picture.text(a, "A", shift=(-0.2, -0.05))
    picture.text(b, "B", shift=(0.2, -0.05))
    picture.text(k, "K", shift=(0.1, 0.17))
    picture.text(y, "Y", shift=(0.28, -0.03))
    picture.text(left, "w₀", BLUE, shift=(-0.3, -0.1))
    picture.text(right, "w₁", ORANGE, shift=(0.3, -0.1))
    picture.label((1.9, 0), "redundant part of w₁", GREY, shift=(-0.45, 0.25))
    return picture


def rule_1():
    """One angle, two sides: where the windows of a list go."""
    picture = Picture(-0.8, -2.9, 5.3, 3.1)
    a, b, c = (0, 0), (4.4, 0), (2.3, 2.6)
    images = [(1.0, -2.3), (2.1, -2.5), (3.6, -2.3)]
    intervals = [(0.35, 1.95), (1.6, 2.9), (2.45, 4.1)]
    colours, lights = [BLUE, GREEN, ORANGE], [LIGHT_BLUE, LIGHT_GREEN, LIGHT_ORANGE]
    s = crossing(images[1], c, a, b)
    for image, (begin, end), light in zip(images, intervals, lights):
        picture.polygon([image, (begin, 0), (end, 0)], light)
    # What reaches the right edge, of the left window, is left out; and the mirror image.
    last, first = crossing(images[0], c, a, b), crossing(images[2], c, a, b)
    on_edges = [(crossing(images[0], (0.35, 0), a, c), c),
                (crossing(images[1], (1.6, 0), a, c), crossing(images[1], (2.9, 0), c, b)),
                (c, crossing(images[2], (4.1, 0), c, b))]
    picture.polygon([(0.35, 0), *on_edges[0], last], lights[0])
    picture.polygon([first, *on_edges[2], (4.1, 0)], lights[2])
    picture.polygon([(1.6, 0), on_edges[1][0], c, on_edges[1][1], (2.9, 0)], lights[1])
    picture.polygon([a, b, c], "none", "black", 1.5)
    for (begin, end), colour in zip(intervals, colours):
        picture.line((begin, 0), (end, 0), colour, 5)
    for image, pair, colour in zip(images, on_edges, colours):
        for point in pair:
            picture.line(image, point, colour, 1.5, dashes="6,4")
        picture.dot(image, colour)
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
    """A visit of a vertex: lists on its edges are carried through the faces around it, in both directions."""
    picture = Picture(-2.2, -2.3, 5.6, 2.3, 70)
    center = (0, 0)
    ring = [(2.0 * math.cos(angle), 2.0 * math.sin(angle)) for angle in (math.pi * (2 * i + 1) / 6 for i in range(6))]
    for i in range(6):
        reached = i in (3, 4)  # the two faces below
        picture.polygon([center, ring[i], ring[(i + 1) % 6]], LIGHT_GREY if reached else "white", "black", 1.5)
    for i in (3, 4, 5):
        picture.line(toward(center, ring[i], 0.35), toward(center, ring[i], 1.75), PURPLE, 5)
    for i in (5, 0, 1, 2):
        middle = between(ring[i], ring[(i + 1) % 6], 0.5)
        picture.line(between(ring[i], middle, 0.25), between(ring[(i + 1) % 6], middle, 0.25), GREEN, 5)
    for begin, end, radius, colour in ((-20, 95, 0.95, BLUE), (200, 85, 1.3, ORANGE)):
        steps = [begin + (end - begin) * k / 30 for k in range(31)]
        arc = [(radius * math.cos(math.radians(t)), radius * math.sin(math.radians(t))) for t in steps]
        picture.curve(arc, colour, 2, arrow=True)
    picture.dot(center, "black", 6)
    picture.text(center, "v", shift=(0.14, 0.2))
    words = (("lists that wait on the edges of v", PURPLE), ("carried counterclockwise", BLUE),
             ("carried clockwise", ORANGE), ("lists that wait afterwards", GREEN),
             ("faces that were reached before", GREY))
    for k, (text, colour) in enumerate(words):
        picture.label((2.1, 1.2 - 0.55 * k), text, colour, anchor="start")
    return picture


def redundant_windows():
    """Faces behind the wavefront: windows are kept where a curve crosses only."""
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
                    LIGHT_BLUE if len(nearest) == 2 else LIGHT_GREY
                picture.polygon(face, fill, GREY, 0.7)
    middle = between(*sites, 0.5)
    across = (-(sites[1][1] - sites[0][1]), sites[1][0] - sites[0][0])
    length = math.hypot(*across)
    half = math.sqrt((radius - 0.35)**2 - (math.dist(*sites) / 2)**2)
    curve = [(middle[0] + t * across[0] / length, middle[1] + t * across[1] / length) for t in (-half, half)]
    picture.line(*curve, BLUE, 3)
    for site in sites:
        picture.dot(site, "black", 5)
    for k, (fill, words) in enumerate(((LIGHT_ORANGE, "wavefront: kept"), (LIGHT_BLUE, "crossed: cut, then removed"),
                                       (LIGHT_GREY, "one site: removed"))):
        x = (0.0, 2.7, 6.4)[k]
        picture.polygon([(x, -0.65), (x + 0.25, -0.65), (x + 0.25, -0.4), (x, -0.4)], fill, GREY)
        picture.label((x + 0.35, -0.6), words, anchor="start", size=13)
    return picture


def arc_in_face():
    """The curve between two cells in a face, where the paths bend at different distances: a piece of a hyperbola."""
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
    for image, colour in ((first, BLUE), (second, ORANGE)):
        picture.line(image, on_arc, colour, 1.5, dashes="6,4")
        picture.dot(image, colour, 5)
    picture.curve(hyperbola, "black", 3)
    picture.dot(hyperbola[0])
    picture.dot(hyperbola[-1])
    picture.label(first, "image, offset 1.1", BLUE, shift=(-0.1, -0.35))
    picture.label(second, "image, offset 0", ORANGE, shift=(0, -0.35))
    picture.label(between(a, on_arc, 0.5), "cell", BLUE, shift=(0.0, 0.25))
    picture.label(between(b, on_arc, 0.45), "cell", ORANGE, shift=(0, 0.45))
    picture.label(hyperbola[-1], "arc", shift=(-0.15, 0.1), anchor="end")
    return picture


FIGURES = (window, pairs_of_windows, rule_1, wavefront, redundant_windows, arc_in_face)


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
