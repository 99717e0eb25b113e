#!/usr/bin/python3
"""Renders a surface to a PNG file, without a screen: a mesh with colored distances, as distances_as_colored_mesh writes
it, a mesh without colors, or the cells and arcs of a Voronoi diagram, as write_geodesic_Voronoi_diagram() writes them.

usage: render_picture.py mesh.ply|mesh.off|diagram.vtk picture.png [options]
  --lines paths.polylines.txt  paths on top of the mesh, as paths_from_several_sources writes them; paths that end at the
                        same source have the same color
  --isolines lines.vtk|lines.polylines.txt  thin dark lines on top, as the program writes them with --lines
  --curves curves.polylines.txt  thick lines on top: white, which stands out on distances, or black on cells
  --edges               the edges of a mesh without colors, and flat faces
  --size WIDTHxHEIGHT   size of the picture (900x900)
  --view X,Y,Z          direction from the mesh to the eye (0,0,1)
  --up X,Y,Z            direction that points upward in the picture (0,1,0)
  --zoom F              1: the whole mesh with a margin (1)

Needs Debian's python3-vtk9, and xvfb if there is no display.

If the vertices have a property "distance", each pixel gets its color from its distance, instead of a mixture of the
colors of the corners. Borders of bands are then as sharp as the picture allows, on coarse meshes too. The colors
themselves are always those of the file.
"""
import argparse
import math
import os
import shutil
import struct
import sys

PLY_TYPES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H",
             "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f",
             "double": "d", "float64": "d"}


def read_ply(name):
    """Returns the vertices, as a dictionary of columns, and the faces, as lists of indices, of a PLY file."""
    with open(name, "rb") as file:
        if file.readline().strip() != b"ply":
            sys.exit("%s is not a PLY file" % name)
        elements = []
        while True:
            words = file.readline().decode("ascii").split()
            if not words or words[0] == "end_header":
                break
            if words[0] == "format" and words[1] != "binary_little_endian":
                sys.exit("only binary little endian PLY files are read")
            if words[0] == "element":
                elements.append((words[1], int(words[2]), []))
            if words[0] == "property":
                elements[-1][2].append(words[1:])
        data = file.read()
    columns, faces, position = {}, [], 0
    for element, count, properties in elements:
        if element == "vertex":
            row = struct.Struct("<" + "".join(PLY_TYPES[p[0]] for p in properties))
            rows = list(row.iter_unpack(data[position:position + count * row.size]))
            columns = {p[-1]: [r[i] for r in rows] for i, p in enumerate(properties)}
            position += count * row.size
        elif element == "face":
            for _ in range(count):
                for p in properties:
                    if p[0] != "list":
                        position += struct.calcsize("<" + PLY_TYPES[p[0]])
                        continue
                    length, = struct.unpack_from("<" + PLY_TYPES[p[1]], data, position)
                    position += struct.calcsize("<" + PLY_TYPES[p[1]])
                    values = struct.Struct("<%d%s" % (length, PLY_TYPES[p[2]]))
                    faces.append(values.unpack_from(data, position))
                    position += values.size
        else:
            break  # the rest is not drawn
    return columns, faces


def read_off(name):
    """Returns the points and the faces of an OFF file."""
    with open(name, encoding="ascii") as file:
        words = [word for line in file for word in line.split("#")[0].split()]
    if words[0] != "OFF":
        sys.exit("%s is not an OFF file" % name)
    number_of_points, number_of_faces = int(words[1]), int(words[2])
    numbers_of_points = [float(word) for word in words[4:4 + 3 * number_of_points]]
    points = list(zip(*[iter(numbers_of_points)] * 3))
    faces, position = [], 4 + 3 * number_of_points
    for _ in range(number_of_faces):
        length = int(words[position])
        faces.append([int(word) for word in words[position + 1:position + 1 + length]])
        position += 1 + length
    return points, faces


def lookup_table(vtk, distances, colors, largest, size=8192):
    """A table from distance to color, read off the vertices. Linear between the samples of a band; jumps between two
    bands, halfway between the nearest vertices of both sides. Distances with a sign begin below 0."""
    samples = sorted((d, c) for d, c in zip(distances, colors) if math.isfinite(d))
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(size)
    least = min(samples[0][0], 0) if samples else 0
    table.SetTableRange(least, largest)
    table.SetNanColor(0.5, 0.5, 0.5, 1)
    k = 0
    for i in range(size):
        d = least + (largest - least) * (i + 0.5) / size
        while k + 1 < len(samples) and samples[k + 1][0] <= d:
            k += 1
        (d0, c0), (d1, c1) = samples[k], samples[min(k + 1, len(samples) - 1)]
        t = (d - d0) / (d1 - d0) if d1 > d0 else 0
        t = min(max(t, 0), 1)
        if max(abs(a - b) for a, b in zip(c0, c1)) > 20:
            t = 0 if t < 0.5 else 1
        table.SetTableValue(i, *[((1 - t) * a + t * b) / 255 for a, b in zip(c0, c1)], 1)
    return table


def make_actor(vtk, columns, faces):
    points = vtk.vtkPoints()
    points.SetNumberOfPoints(len(columns["x"]))
    for i, p in enumerate(zip(columns["x"], columns["y"], columns["z"])):
        points.SetPoint(i, p)
    cells = vtk.vtkCellArray()
    for face in faces:
        cells.InsertNextCell(len(face), face)
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)

    colors = list(zip(columns["red"], columns["green"], columns["blue"]))
    mapper = vtk.vtkPolyDataMapper()
    if "distance" in columns:
        distances = columns["distance"]
        largest = max((d for d in distances if math.isfinite(d)), default=1) or 1
        scalars = vtk.vtkDoubleArray()
        for d in distances:
            scalars.InsertNextValue(d if math.isfinite(d) else math.nan)
        mapper.SetLookupTable(lookup_table(vtk, distances, colors, largest))
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
    else:
        scalars = vtk.vtkUnsignedCharArray()
        scalars.SetNumberOfComponents(3)
        for color in colors:
            scalars.InsertNextTuple3(*color)
    mesh.GetPointData().SetScalars(scalars)

    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    mapper.SetInputConnection(normals.GetOutputPort())
    return actor_with_surface(vtk, mapper)


def actor_of_lines(vtk, lines, radius):
    """Lines as tubes, in the colors of their cells if there are any, otherwise nearly black."""
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputData(lines)
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(8)
    tubes.SetCapping(1)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(tubes.GetOutputPort())
    actor = actor_with_surface(vtk, mapper)
    if lines.GetCellData().GetScalars() is None:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(0.1, 0.1, 0.1)
    return actor


def make_mesh_actors(vtk, points, faces, has_edges):
    """A mesh without colors: with its edges and flat faces, or smooth."""
    mesh = vtk.vtkPolyData()
    vtk_points = vtk.vtkPoints()
    for point in points:
        vtk_points.InsertNextPoint(point)
    cells, edges = vtk.vtkCellArray(), vtk.vtkCellArray()
    for face in faces:
        cells.InsertNextCell(len(face), face)
    for edge in sorted({tuple(sorted((face[i - 1], face[i]))) for face in faces for i in range(len(face))}):
        edges.InsertNextCell(2, edge)
    mesh.SetPoints(vtk_points)
    mesh.SetPolys(cells)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    surface = actor_with_surface(vtk, mapper)
    surface.GetProperty().SetColor(0.62, 0.78, 0.92)
    if not has_edges:
        return [surface]
    surface.GetProperty().SetInterpolationToFlat()
    lines = vtk.vtkPolyData()
    lines.SetPoints(vtk_points)
    lines.SetLines(edges)
    return [surface, actor_of_lines(vtk, lines, 0.0012 * mesh.GetLength())]


def read_poly_data(vtk, name):
    reader = vtk.vtkPolyDataReader()
    reader.SetFileName(name)
    reader.ReadAllScalarsOn()
    reader.Update()
    return reader.GetOutput()


def read_polylines(vtk, name):
    """The lines of a file of CGAL's polylines, and the last point of each."""
    points, cells, ends = vtk.vtkPoints(), vtk.vtkCellArray(), []
    with open(name, encoding="ascii") as file:
        for line in file:
            coordinates = [float(word) for word in line.split()[1:]]
            polyline = list(zip(*[iter(coordinates)] * 3))
            cells.InsertNextCell(len(polyline), [points.InsertNextPoint(point) for point in polyline])
            ends.append(polyline[-1])
    lines = vtk.vtkPolyData()
    lines.SetPoints(points)
    lines.SetLines(cells)
    return lines, ends


def make_path_actor(vtk, name):
    """Paths, colored by their sources, which are their last points."""
    paths, ends = read_polylines(vtk, name)
    colors = vtk.vtkUnsignedCharArray()
    colors.SetNumberOfComponents(3)
    sources = []
    for end in ends:
        if end not in sources:
            sources.append(end)
        colors.InsertNextTuple3(*PATH_COLORS[sources.index(end) % len(PATH_COLORS)])
    paths.GetCellData().SetScalars(colors)
    return actor_of_lines(vtk, paths, 0.0035 * paths.GetLength())


def make_isoline_actor(vtk, name, size):
    lines = read_polylines(vtk, name)[0] if name.endswith(".polylines.txt") else read_poly_data(vtk, name)
    lines.GetCellData().SetScalars(None)
    lines.GetPointData().SetScalars(None)
    return actor_of_lines(vtk, lines, 0.0012 * size)


def make_curve_actor(vtk, name, size, is_on_cells):
    actor = actor_of_lines(vtk, read_polylines(vtk, name)[0], 0.0035 * size)
    if not is_on_cells:
        actor.GetProperty().SetColor(1, 1, 1)
    return actor


def actor_with_surface(vtk, mapper):
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    surface = actor.GetProperty()
    surface.SetAmbient(0.28)
    surface.SetDiffuse(0.78)
    surface.SetSpecular(0.08)
    surface.SetSpecularPower(20)
    return actor


# Light colors that readers with any color vision can tell apart, by their lightness as well (after Okabe and Ito).
CELL_COLORS = [(230, 159, 0), (86, 180, 233), (0, 158, 115), (240, 228, 66), (120, 150, 220), (213, 94, 0),
               (204, 121, 167), (235, 235, 235)]

# Colors that stand out on such cells and on bands.
PATH_COLORS = [(213, 94, 0), (20, 20, 20), (255, 255, 255), (204, 60, 140)]


def colors_of_sites(neighbors):
    """Different colors for neighboring sites, as long as there are enough colors."""
    color = {}
    for site in sorted(neighbors, key=lambda s: (-len(neighbors[s]), s)):
        taken = [color[n] for n in neighbors[site] if n in color]
        color[site] = min(range(len(CELL_COLORS)), key=lambda c: (taken.count(c), (c - site) % len(CELL_COLORS)))
    return {site: CELL_COLORS[c] for site, c in color.items()}


def make_diagram_actors(vtk, name):
    """The cells and the arcs of a diagram."""
    diagram = read_poly_data(vtk, name)
    data = diagram.GetCellData()
    site, left, right = (data.GetArray(n) for n in ("site", "left_site", "right_site"))
    number_of_lines = diagram.GetNumberOfLines()
    neighbors = {int(site.GetValue(i)): set() for i in range(number_of_lines, diagram.GetNumberOfCells())}
    for i in range(number_of_lines):
        a, b = int(left.GetValue(i)), int(right.GetValue(i))
        neighbors.setdefault(a, set()).add(b)
        neighbors.setdefault(b, set()).add(a)
    color = colors_of_sites(neighbors)

    colors = vtk.vtkUnsignedCharArray()
    colors.SetNumberOfComponents(3)
    for i in range(number_of_lines, diagram.GetNumberOfCells()):
        colors.InsertNextTuple3(*color[int(site.GetValue(i))])
    cells = vtk.vtkPolyData()
    cells.SetPoints(diagram.GetPoints())
    cells.SetPolys(diagram.GetPolys())
    cells.GetCellData().SetScalars(colors)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(cells)
    normals.SplittingOff()
    cell_mapper = vtk.vtkPolyDataMapper()
    cell_mapper.SetInputConnection(normals.GetOutputPort())

    arcs = vtk.vtkPolyData()
    arcs.SetPoints(diagram.GetPoints())
    arcs.SetLines(diagram.GetLines())
    return [actor_with_surface(vtk, cell_mapper), actor_of_lines(vtk, arcs, 0.0015 * diagram.GetLength())]


def numbers(text):
    return tuple(float(n) for n in text.split(","))


def render(vtk, actors, options):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    lights = vtk.vtkLightKit()
    lights.SetKeyLightIntensity(0.88)
    lights.SetKeyLightWarmth(0.5)
    lights.SetFillLightWarmth(0.5)
    lights.SetHeadLightWarmth(0.5)
    lights.SetBackLightWarmth(0.5)
    lights.SetKeyToFillRatio(2.5)
    lights.AddLightsToRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*options.view)
    camera.SetViewUp(*options.up)
    camera.SetViewAngle(20)
    renderer.ResetCamera()
    camera.Zoom(1.35 * options.zoom)
    renderer.ResetCameraClippingRange()

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    # Twice the size, averaged below: smooth borders that do not depend on the antialiasing of the driver.
    window.SetSize(2 * options.width, 2 * options.height)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    half = vtk.vtkImageShrink3D()
    half.SetInputConnection(grab.GetOutputPort())
    half.SetShrinkFactors(2, 2, 1)
    half.MeanOn()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(options.picture)
    writer.SetCompressionLevel(9)
    writer.SetInputConnection(half.GetOutputPort())
    writer.Write()


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("mesh")
    parser.add_argument("picture")
    parser.add_argument("--lines")
    parser.add_argument("--isolines")
    parser.add_argument("--curves")
    parser.add_argument("--edges", action="store_true")
    parser.add_argument("--size", default="900x900")
    parser.add_argument("--view", type=numbers, default=(0, 0, 1))
    parser.add_argument("--up", type=numbers, default=(0, 1, 0))
    parser.add_argument("--zoom", type=float, default=1)
    options = parser.parse_args()
    options.width, options.height = (int(n) for n in options.size.split("x"))

    if "DISPLAY" not in os.environ and shutil.which("xvfb-run"):
        os.execvp("xvfb-run", ["xvfb-run", "-a", sys.executable] + sys.argv)
    try:
        import vtk
    except ImportError:
        sys.exit("VTK for Python is missing: apt-get install python3-vtk9 xvfb (and use /usr/bin/python3)")

    if options.mesh.endswith(".vtk"):
        actors = make_diagram_actors(vtk, options.mesh)
    elif options.mesh.endswith(".off"):
        actors = make_mesh_actors(vtk, *read_off(options.mesh), options.edges)
    else:
        actors = [make_actor(vtk, *read_ply(options.mesh))]
    if options.lines:
        actors.append(make_path_actor(vtk, options.lines))
    size = actors[0].GetLength()
    if options.isolines:
        actors.append(make_isoline_actor(vtk, options.isolines, size))
    if options.curves:
        actors.append(make_curve_actor(vtk, options.curves, size, options.mesh.endswith(".vtk")))
    render(vtk, actors, options)


if __name__ == "__main__":
    main()
