// Single cells as meshes: valid, with the area and the topology of the cell, and with the faces that cut() makes.

#include "cell_test_helpers.h"
#include "mesh_operations.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace test_meshes;
namespace PMP = CGAL::Polygon_mesh_processing;
using Voronoi = Diagram_of_cells;

struct Cell
{
  Mesh mesh;
  Mesh::Property_map<face_descriptor, face_descriptor> face;
};

Cell cell_of(const Voronoi& voronoi, std::size_t i, double tolerance)
{
  Cell cell;
  cell.face = cell.mesh.add_property_map<face_descriptor, face_descriptor>("f:face").first;
  voronoi.cell_mesh(i, cell.mesh, cell.face, tolerance);
  return cell;
}

int Euler_characteristic(const Mesh& mesh)
{
  return static_cast<int>(num_vertices(mesh)) - static_cast<int>(num_edges(mesh)) + static_cast<int>(num_faces(mesh));
}

std::array<Kernel::Point_3, 3> corners(const Mesh& mesh, face_descriptor f)
{
  const auto h = halfedge(f, mesh);
  return {mesh.point(source(h, mesh)), mesh.point(target(h, mesh)), mesh.point(target(next(h, mesh), mesh))};
}

// Each new face lies in the face that the map names, and is oriented like it.
void check_faces(const Mesh& mesh, const Cell& cell)
{
  const double rounding = 1e-9 * extent_from_first_vertex(mesh);
  for(const face_descriptor f : faces(cell.mesh))
  {
    const std::array<Kernel::Point_3, 3> p = corners(cell.mesh, f), q = corners(mesh, cell.face[f]);
    const Kernel::Triangle_3 whole(q[0], q[1], q[2]);
    if(whole.is_degenerate())
      continue;
    for(const Kernel::Point_3& corner : p)
      CHECK(std::sqrt(CGAL::squared_distance(corner, whole)) < rounding);
    CHECK(CGAL::cross_product(p[1] - p[0], p[2] - p[0]) * CGAL::cross_product(q[1] - q[0], q[2] - q[0])
          > -rounding * rounding);
  }
}

// The corners of the faces of a mesh, sorted, to compare sets of faces.
using Corners = std::vector<std::array<Kernel::Point_3, 3>>;
void add_corners(const Mesh& mesh, face_descriptor f, Corners& all)
{
  std::array<Kernel::Point_3, 3> p = corners(mesh, f);
  std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
  all.push_back(p);
}

// The cells have the faces of cut(), with the same points.
void check_against_cut(const Voronoi& voronoi, double tolerance)
{
  Mesh cut;
  auto site = cut.add_property_map<face_descriptor, std::size_t>("f:site").first;
  voronoi.cut(cut, site, tolerance);
  std::vector<Corners> expected(voronoi.number_of_sites());
  for(const face_descriptor f : faces(cut))
    if(site[f] != Voronoi::null_site())
      add_corners(cut, f, expected[site[f]]);
  for(std::size_t i = 0; i < voronoi.number_of_sites(); ++i)
  {
    Corners found;
    const Cell cell = cell_of(voronoi, i, tolerance);
    for(const face_descriptor f : faces(cell.mesh))
      add_corners(cell.mesh, f, found);
    std::sort(found.begin(), found.end());
    std::sort(expected[i].begin(), expected[i].end());
    CHECK(found == expected[i]);
  }
}

// Whether a mesh is a disk, as CGAL sees it.
bool is_disk(Mesh& mesh)
{
  auto component = mesh.add_property_map<face_descriptor, std::size_t>("f:component").first;
  std::vector<boost::graph_traits<Mesh>::halfedge_descriptor> pinched;
  PMP::non_manifold_vertices(mesh, std::back_inserter(pinched));
  return PMP::connected_components(mesh, component) == 1 && pinched.empty() && Euler_characteristic(mesh) == 1;
}

// Returns how many cells of characteristic 1 are not disks.
std::size_t check_cells(const Mesh& mesh, const Voronoi& voronoi, bool is_generic)
{
  const double size = extent_from_first_vertex(mesh), tolerance = 1e-5 * size;
  std::size_t number_of_special_cells = 0;
  double length = 0;
  for(const Voronoi::Arc& a : voronoi.arcs())
    length += a.length();
  for(std::size_t i = 0; i < voronoi.number_of_sites(); ++i)
  {
    Cell cell = cell_of(voronoi, i, tolerance);
    CHECK(CGAL::is_triangle_mesh(cell.mesh));
    CHECK(CGAL::is_valid_polygon_mesh(cell.mesh));
    CHECK_NEAR(CGAL::to_double(PMP::area(cell.mesh)), voronoi.area(i), 2 * tolerance * length + 1e-12 * size * size);
    check_faces(mesh, cell);
    CHECK_EQUAL(num_faces(cell.mesh) == 0, voronoi.is_empty(i));
    if(is_generic)
      CHECK_EQUAL(Euler_characteristic(cell.mesh), voronoi.Euler_characteristic(i));
    // The mesh of a cell does not tell whether two curves touch inside a face.
    if(is_generic)
      CHECK_EQUAL(is_disk(cell.mesh), voronoi.is_disk(i));
    else
      CHECK(is_disk(cell.mesh) || !voronoi.is_disk(i));
    if(voronoi.Euler_characteristic(i) == 1 && !voronoi.is_disk(i))
      ++number_of_special_cells;
  }
  check_against_cut(voronoi, 10 * tolerance);
  return number_of_special_cells;
}

void random_cells_are_right(std::uint64_t seed)
{
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : small_collection(seed))
    for(const std::size_t n : {1u, 2u, 5u, 12u})
      for(const double weight : {0., .05})
      {
        const test_support::Scope scope(indexed.name + ", " + std::to_string(n) + " sites");
        const Mesh mesh = to_face_graph(indexed);
        Voronoi voronoi(mesh);
        for(std::size_t i = 0; i < n; ++i)
        {
          const face_descriptor f(static_cast<Mesh::size_type>(random.index(num_faces(mesh))));
          const double a = i % 3 == 2 ? 0. : random.uniform(), b = i % 3 != 0 ? 0. : random.uniform();
          voronoi.add_site(Voronoi::Face_location(f, {a * (1 - b), b, (1 - a) * (1 - b)}),
                           random.uniform(0., weight) * extent_from_first_vertex(mesh));
        }
        const std::size_t number_of_special_cells = check_cells(mesh, voronoi, true);
        CHECK(number_of_special_cells == 0 || indexed.name.find("random cuts") != std::string::npos);
      }
}

// A cell that touches itself has a pinched vertex.
void symmetric_cells_are_right()
{
  for_each_symmetric_diagram([](const Mesh& mesh, const Voronoi& voronoi) { check_cells(mesh, voronoi, false); });
}

// Rings on a tube, a whole sphere, an empty cell, and two squares that share a vertex.
void known_cells_are_right()
{
  const Mesh tube = to_face_graph(prism_tube(6, 9, 1., 20.));
  Voronoi rings(tube);
  for(const std::size_t i : {std::size_t(0), std::size_t(num_vertices(tube) / 2), std::size_t(num_vertices(tube) - 1)})
    rings.add_site(vertex_descriptor(static_cast<Mesh::size_type>(i)));
  rings.add_site(vertex_descriptor(0)); // empty
  check_cells(tube, rings, true);
  CHECK_EQUAL(num_faces(cell_of(rings, 3, 1e-3).mesh), std::size_t(0));
  CHECK_EQUAL(rings.Euler_characteristic(1), 0);

  const Mesh sphere = to_face_graph(icosphere(1));
  Voronoi whole(sphere);
  whole.add_site(vertex_descriptor(0));
  check_cells(sphere, whole, true);
  CHECK_EQUAL(Euler_characteristic(cell_of(whole, 0, 1e-3).mesh), 2);

  const Mesh pinched = to_face_graph(bow_tie());
  Voronoi squares(pinched);
  squares.add_site(vertex_descriptor(1));
  squares.add_site(vertex_descriptor(5));
  CHECK_EQUAL(check_cells(pinched, squares, true), std::size_t(1)); // the first cell passes through the shared vertex
  CHECK(!squares.is_disk(0) && squares.is_disk(1));
}

// A tube of four faces of width 1, and a corner of a cell at the middle of a face or on an edge.
Indexed_mesh square_tube(double first_z, double last_z)
{
  Indexed_mesh mesh;
  mesh.name = "square tube from " + std::to_string(first_z);
  for(double z = first_z; z <= last_z; z += 1)
    for(const auto& p : {std::array<double, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      mesh.points.push_back({p[0], p[1], z});
  for(std::size_t i = 0; i + 4 < mesh.points.size(); i += 4)
    for(std::size_t k = 0; k < 4; ++k)
      add_quadrilateral(mesh, i + k, i + (k + 1) % 4, i + 4 + (k + 1) % 4, i + 4 + k);
  return mesh;
}

// Returns the location at height z, at a fraction of the width of side k of a square tube.
Voronoi::Face_location on_tube(const Mesh& mesh, std::size_t k, double fraction, double z)
{
  const std::array<std::array<double, 2>, 5> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
  const Kernel::Point_3 p(corner[k][0] + fraction * (corner[k + 1][0] - corner[k][0]),
                          corner[k][1] + fraction * (corner[k + 1][1] - corner[k][1]), z);
  for(const face_descriptor f : faces(mesh))
  {
    const std::array<Kernel::Point_3, 3> q = corners(mesh, f);
    if(CGAL::squared_distance(p, Kernel::Triangle_3(q[0], q[1], q[2])) > 0)
      continue;
    const auto part = [&](std::size_t a, std::size_t b)
    { return std::sqrt(CGAL::squared_area(p, q[a], q[b]) / CGAL::squared_area(q[0], q[1], q[2])); };
    return {f, {part(1, 2), part(2, 0), part(0, 1)}};
  }
  return {};
}

// A site on one side of the tube and two on the other side, above and below: the first cell is a diamond with two
// corners at one point, where four parts of cells meet. That point is a vertex, on an edge, or inside a face.
void a_cell_that_touches_itself_is_no_disk()
{
  for(const double first_z : {-5., -5.5})
    for(const double fraction : {0., .5, .25})
    {
      const Indexed_mesh tube = square_tube(first_z, -first_z);
      const test_support::Scope scope(tube.name + ", at " + std::to_string(fraction));
      const Mesh mesh = to_face_graph(tube);
      Voronoi voronoi(mesh);
      voronoi.add_site(on_tube(mesh, 0, fraction, 0));
      voronoi.add_site(on_tube(mesh, 2, fraction, 2));
      voronoi.add_site(on_tube(mesh, 2, fraction, -2));
      check_cells(mesh, voronoi, false);
      for(std::size_t i = 0; i < 3; ++i)
        CHECK(!voronoi.is_disk(i));
      // Without the tie, the first cell is a disk.
      Voronoi generic(mesh);
      generic.add_site(on_tube(mesh, 0, fraction, 0));
      generic.add_site(on_tube(mesh, 2, fraction, 1.75));
      generic.add_site(on_tube(mesh, 2, fraction, -1.75));
      check_cells(mesh, generic, true);
      CHECK(generic.is_disk(0));
    }
}

// Two parts that share a vertex, and a vertex without faces.
void pinched_vertices_are_no_disks()
{
  Indexed_mesh parts;
  parts.points = {{0, 0, 0}, {1, 0, -1}, {0, 1, -1}, {-1, -1, -1}, {1, 0, 1}, {0, 1, 1}, {-1, -1, 1}, {9, 9, 9}};
  parts.faces = {{0, 1, 2}, {0, 2, 3}, {0, 5, 4}, {0, 6, 5}};
  const Mesh mesh = to_face_graph(parts);
  Voronoi voronoi(mesh);
  voronoi.add_site(vertex_descriptor(0), .1);
  voronoi.add_site(vertex_descriptor(7));
  voronoi.add_site(vertex_descriptor(4));
  CHECK_EQUAL(voronoi.Euler_characteristic(0), 1);
  CHECK_EQUAL(voronoi.Euler_characteristic(1), 1);
  CHECK(!voronoi.is_disk(0));
  CHECK(!voronoi.is_disk(1));
  CHECK(voronoi.is_disk(2));
}

// A Polyhedron_3 with a point map, behind other faces.
void a_cell_is_added_to_a_polyhedron()
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>, CGAL::Polyhedron_items_with_id_3>;
  const Mesh sphere = to_face_graph(icosphere(2));
  Voronoi voronoi(sphere);
  for(const Mesh::size_type i : {0u, 20u, 40u, 60u})
    voronoi.add_site(vertex_descriptor(i));
  Polyhedron polyhedron;
  std::map<boost::graph_traits<Polyhedron>::face_descriptor, face_descriptor> face;
  for(std::size_t i = 0; i < 4; ++i)
    voronoi.cell_mesh(i, polyhedron, boost::make_assoc_property_map(face), 1e-3,
                      CGAL::parameters::vertex_point_map(get(CGAL::vertex_point, polyhedron)));
  CHECK(polyhedron.is_valid());
  CHECK_EQUAL(face.size(), polyhedron.size_of_facets());
  CHECK_NEAR(PMP::area(polyhedron), CGAL::to_double(PMP::area(sphere)), 1e-9);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261125);
  known_cells_are_right();
  a_cell_is_added_to_a_polyhedron();
  a_cell_that_touches_itself_is_no_disk();
  pinched_vertices_are_no_disks();
  symmetric_cells_are_right();
  random_cells_are_right(seed);
  return test_result();
}
