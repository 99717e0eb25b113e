// The boundaries of cells as polylines: they are closed, as long as their arcs, and know the vertices of the diagram;
// in the plane they enclose the areas of the cells.

#include "cell_test_helpers.h"
#include "mesh_operations.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace test_meshes;
using Voronoi = Diagram_of_cells;
using Polyline = Voronoi::Boundary_polyline;

double length_of(const Voronoi& voronoi, const Polyline& p)
{
  double sum = 0;
  for(std::size_t k = 1; k < p.locations.size(); ++k)
    sum += std::sqrt(CGAL::squared_distance(voronoi.point(p.locations[k - 1]), voronoi.point(p.locations[k])));
  return sum;
}

// Twice the area on the left, for a mesh in the plane z = 0, is the sum of cross products.
double area_of(const Voronoi& voronoi, const Polyline& p)
{
  double sum = 0;
  for(std::size_t k = 1; k < p.locations.size(); ++k)
  {
    const auto a = voronoi.point(p.locations[k - 1]), b = voronoi.point(p.locations[k]);
    sum += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return sum;
}

double length_of_border(const Mesh& mesh)
{
  double sum = 0;
  for(const auto e : edges(mesh))
    if(is_border(e, mesh))
      sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum;
}

Kernel::Triangle_3 triangle(const Mesh& mesh, face_descriptor f)
{
  const auto h = halfedge(f, mesh);
  return Kernel::Triangle_3(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                            mesh.point(target(next(h, mesh), mesh)));
}

// Each segment is in the face of its second point, and each vertex at its place and one of the cell.
void check_points(const Mesh& mesh, const Voronoi& voronoi, std::size_t site, const Polyline& p)
{
  const double rounding = 1e-9 * extent_from_first_vertex(mesh);
  CHECK_EQUAL(p.locations.size(), p.vertices.size());
  for(std::size_t k = 0; k < p.locations.size(); ++k)
  {
    const auto point = voronoi.point(p.locations[k]);
    if(k > 0 && !triangle(mesh, p.locations[k].first).is_degenerate())
      CHECK(std::sqrt(CGAL::squared_distance(voronoi.point(p.locations[k - 1]),
                                             triangle(mesh, p.locations[k].first))) < rounding);
    if(p.vertices[k] == Voronoi::null_site())
      continue;
    const auto& v = voronoi.vertices()[p.vertices[k]];
    CHECK(std::sqrt(CGAL::squared_distance(point, v.point())) < rounding);
    CHECK(std::binary_search(v.sites().begin(), v.sites().end(), site));
  }
  if(p.is_closed)
  {
    CHECK(p.locations.front() == p.locations.back());
    CHECK_EQUAL(p.vertices.front(), p.vertices.back());
  }
}

// Counts how often each vertex of the diagram is on the polylines; the ends of a closed one count once.
void count_vertices(const Polyline& p, std::map<std::size_t, std::size_t>& uses)
{
  for(std::size_t k = p.is_closed ? 1 : 0; k < p.vertices.size(); ++k)
    if(p.vertices[k] != Voronoi::null_site())
      ++uses[p.vertices[k]];
}

// Checks the polylines of all cells, with the border of the mesh and without. Returns how many loops there are.
std::size_t check_polylines(const Mesh& mesh, const Voronoi& voronoi, bool is_generic)
{
  const double size = extent_from_first_vertex(mesh), tolerance = 1e-6 * size;
  double all = 0;
  std::size_t number_of_loops = 0;
  std::map<std::size_t, std::size_t> uses, uses_with_border;
  for(std::size_t i = 0; i < voronoi.number_of_sites(); ++i)
  {
    double arcs = 0, open = 0;
    for(const Voronoi::Arc& a : voronoi.arcs(i))
      arcs += a.length();
    const std::vector<Polyline> polylines = voronoi.boundary_polylines(i, tolerance);
    CHECK_EQUAL(polylines.size(), voronoi.boundary(i).size());
    for(const Polyline& p : polylines)
    {
      check_points(mesh, voronoi, i, p);
      count_vertices(p, uses);
      open += length_of(voronoi, p);
    }
    CHECK_NEAR(open, arcs, 1e-4 * arcs);
    for(const Polyline& p : voronoi.boundary_polylines(i, tolerance, true))
    {
      CHECK(p.is_closed);
      check_points(mesh, voronoi, i, p);
      count_vertices(p, uses_with_border);
      all += length_of(voronoi, p);
      ++number_of_loops;
    }
  }
  double expected = voronoi.number_of_sites() == 0 ? 0. : length_of_border(mesh);
  for(const Voronoi::Edge& e : voronoi.edges())
    expected += 2 * e.length();
  CHECK_NEAR(all, expected, 1e-4 * expected);
  // Each vertex is on the boundaries of its cells, once on each.
  CHECK(uses == uses_with_border);
  for(const Voronoi::Vertex& v : voronoi.vertices())
    if(is_generic)
      CHECK_EQUAL(uses[v.index()], v.sites().size());
  return number_of_loops;
}

void add_random_sites(const Mesh& mesh, std::size_t n, double largest_weight, test_support::Random& random,
                      Voronoi& voronoi)
{
  for(std::size_t i = 0; i < n; ++i)
  {
    const face_descriptor f(static_cast<Mesh::size_type>(random.index(num_faces(mesh))));
    const double a = i % 3 == 2 ? 0. : random.uniform(), b = i % 3 != 0 ? 0. : random.uniform();
    voronoi.add_site(Voronoi::Face_location(f, {a * (1 - b), b, (1 - a) * (1 - b)}),
                     random.uniform(0., largest_weight));
  }
}

void polylines_of_random_diagrams_are_right(std::uint64_t seed)
{
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : small_collection(seed))
    for(const std::size_t n : {1u, 2u, 6u, 20u})
      for(const double weight : {0., .05})
      {
        const test_support::Scope scope(indexed.name + ", " + std::to_string(n) + " sites");
        const Mesh mesh = to_face_graph(indexed);
        if(!CGAL::is_closed(mesh) && indexed.name.find("component") != std::string::npos)
          continue; // components that no site reaches have a border, too
        Voronoi voronoi(mesh);
        add_random_sites(mesh, n, weight * extent_from_first_vertex(mesh), random, voronoi);
        check_polylines(mesh, voronoi, false);
      }
}

// The loops of a cell in the plane enclose its area, also where the domain has holes, and the cells, too.
void loops_in_the_plane_enclose_the_cells(std::uint64_t seed)
{
  test_support::Random random(seed);
  std::size_t number_with_holes = 0;
  for(const Indexed_mesh& indexed :
      {flat_patch(6, 5, .3, true, seed), square_with_holes(1), square_with_holes(2), flat_patch(9, 9, .1, false, seed)})
    for(const std::size_t n : {1u, 2u, 3u, 5u, 12u, 30u})
      for(const double weight : {0., .05, .2})
      {
        const test_support::Scope scope(indexed.name + ", " + std::to_string(n) + " sites");
        const Mesh mesh = to_face_graph(indexed);
        const double size = extent_from_first_vertex(mesh), tolerance = 1e-6 * size;
        Voronoi voronoi(mesh);
        add_random_sites(mesh, n, weight * size, random, voronoi);
        check_polylines(mesh, voronoi, true);
        for(std::size_t i = 0; i < n; ++i)
        {
          const std::vector<Polyline> loops = voronoi.boundary_polylines(i, tolerance, true);
          double area = 0;
          for(const Polyline& p : loops)
            area += area_of(voronoi, p);
          CHECK_NEAR(area, voronoi.area(i), 1e-5 * size * size);
          // A domain of the plane with k loops has the characteristic 2 - k.
          if(!voronoi.is_empty(i))
            CHECK_EQUAL(static_cast<int>(loops.size()), 2 - voronoi.Euler_characteristic(i));
          number_with_holes += loops.size() > 1 ? 1 : 0;
        }
      }
  CHECK(number_with_holes > 10);
}

void polylines_of_symmetric_diagrams_are_right()
{
  for_each_symmetric_diagram([](const Mesh& mesh, const Voronoi& voronoi) { check_polylines(mesh, voronoi, false); });
}

// Known numbers of loops: none on a sphere with one cell, the border of a patch, the rings of a tube, and two squares
// that share a vertex, where the border has two loops.
void known_loops_are_found()
{
  const auto loops = [](const Indexed_mesh& indexed, const std::vector<std::size_t>& sites)
  {
    const test_support::Scope scope(indexed.name);
    const Mesh mesh = to_face_graph(indexed);
    Voronoi voronoi(mesh);
    for(const std::size_t s : sites)
      voronoi.add_site(vertex_descriptor(static_cast<Mesh::size_type>(s)));
    return check_polylines(mesh, voronoi, false);
  };
  CHECK_EQUAL(loops(icosphere(1), {3}), std::size_t(0));
  CHECK_EQUAL(loops(icosphere(2), {3, 80}), std::size_t(2));
  CHECK_EQUAL(loops(flat_patch(3, 3, .1, true, 1), {5}), std::size_t(1));
  CHECK_EQUAL(loops(prism_tube(6, 9, 1., 20.), {0}), std::size_t(2));
  const std::size_t last = prism_tube(6, 9, 1., 20.).points.size() - 1;
  CHECK_EQUAL(loops(prism_tube(6, 9, 1., 20.), {0, last / 2, last}), std::size_t(6));

  CHECK_EQUAL(loops(bow_tie(), {0}), std::size_t(2));
  CHECK_EQUAL(loops(bow_tie(), {2}), std::size_t(2));
  CHECK_EQUAL(loops(bow_tie(), {2, 5}), std::size_t(2));
  CHECK_EQUAL(loops(bow_tie(), {1, 5}), std::size_t(3)); // the cell of the first site passes through the shared vertex
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261124);
  known_loops_are_found();
  loops_in_the_plane_enclose_the_cells(seed);
  polylines_of_symmetric_diagrams_are_right();
  polylines_of_random_diagrams_are_right(seed);
  return test_result();
}
