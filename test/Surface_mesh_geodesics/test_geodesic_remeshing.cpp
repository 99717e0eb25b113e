// Lloyd relaxation, remeshing by the dual, and the report of what prevents a manifold dual.

#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace test_meshes;
namespace Geodesics = CGAL::Surface_mesh_geodesics;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

int Euler_characteristic(const Mesh& mesh)
{
  return static_cast<int>(num_vertices(mesh)) - static_cast<int>(num_edges(mesh)) + static_cast<int>(num_faces(mesh));
}

// Returns the largest area of a cell, divided by the mean area.
double unevenness(const Mesh& mesh, const std::vector<vertex_descriptor>& sites)
{
  Voronoi voronoi(mesh);
  voronoi.add_sites(sites);
  double largest = 0, sum = 0;
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    largest = (std::max)(largest, voronoi.area(i));
    sum += voronoi.area(i);
  }
  return largest * static_cast<double>(sites.size()) / sum;
}

void relaxation_makes_cells_even(std::uint64_t seed)
{
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : {noisy_sphere(3, .02, seed), torus(1., .4, 40, 20), rough_terrain(20, .5, seed)})
  {
    const test_support::Scope scope(indexed.name);
    const Mesh mesh = to_face_graph(indexed);
    std::vector<vertex_descriptor> sites, moved, same;
    for(int i = 0; i < 20; ++i)
      sites.push_back(vertex_descriptor(static_cast<Mesh::size_type>(random.index(num_vertices(mesh)))));
    CHECK_EQUAL(Geodesics::geodesic_Lloyd_relaxation(mesh, sites, 0, std::back_inserter(same)), std::size_t(0));
    CHECK(same == sites);
    const std::size_t n = Geodesics::geodesic_Lloyd_relaxation(mesh, sites, 50, std::back_inserter(moved));
    CHECK_EQUAL(moved.size(), sites.size());
    CHECK(n > 1);
    CHECK(unevenness(mesh, moved) < unevenness(mesh, sites));
    // a relaxation that has converged does not move its sites
    if(n < 50)
    {
      same.clear();
      CHECK_EQUAL(Geodesics::geodesic_Lloyd_relaxation(mesh, moved, 3, std::back_inserter(same)), std::size_t(0));
      CHECK(same == moved);
    }
  }
}

void remeshing_keeps_topology_and_volume(std::uint64_t seed)
{
  for(const Indexed_mesh& indexed : {noisy_sphere(4, .01, seed), torus(1., .4, 48, 24),
                                     midpoint_subdivision(jittered(genus_2_polycube(), .1, seed), 3)})
  {
    const test_support::Scope scope(indexed.name);
    const Mesh mesh = to_face_graph(indexed);
    Mesh output;
    const Geodesics::Geodesic_dual_report report = Geodesics::geodesic_remeshing(mesh, 150, output);
    CHECK(report.is_manifold());
    CHECK_EQUAL(num_vertices(output), std::size_t(150));
    CHECK(CGAL::is_triangle_mesh(output));
    CHECK(CGAL::is_valid_polygon_mesh(output));
    CHECK(CGAL::is_closed(output));
    CHECK_EQUAL(Euler_characteristic(output), Euler_characteristic(mesh));
    const double before = CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh));
    const double after = CGAL::to_double(CGAL::Polygon_mesh_processing::volume(output));
    CHECK(after > .8 * before && after < 1.05 * before); // the volume is negative if the orientation is wrong
  }
  const Mesh patch = to_face_graph(rough_terrain(24, .3, seed));
  CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> polyhedron;
  const Geodesics::Geodesic_dual_report report
    = Geodesics::geodesic_remeshing(patch, 60, polyhedron, CGAL::parameters::number_of_iterations(2u));
  CHECK(report.is_manifold());
  CHECK(polyhedron.is_valid() && !polyhedron.is_closed());
  CHECK_EQUAL(polyhedron.size_of_vertices(), std::size_t(60));
}

// One cell that is the whole sphere; two cells with a closed edge.
void one_or_two_cells_have_no_dual()
{
  const Mesh sphere = to_face_graph(icosphere(2));
  Mesh output;
  Geodesics::Geodesic_dual_report r = Geodesics::geodesic_remeshing(sphere, 1, output);
  CHECK(!r.is_manifold());
  CHECK(r.cells_that_are_not_disks == std::vector<std::size_t>{0});
  r = Geodesics::geodesic_remeshing(sphere, 2, output);
  CHECK(!r.is_manifold());
  CHECK(r.cells_that_are_not_disks.empty());
  CHECK((r.pairs_without_triangle == Pairs{{0, 1}}));
  CHECK_EQUAL(r.cells_without_triangle.size(), std::size_t(2));
  CHECK_EQUAL(num_vertices(output), std::size_t(0));
}

// Three cells on a thin torus are rings.
void ring_cells_are_reported()
{
  const Mesh ring = to_face_graph(torus(1., .2, 36, 9));
  Voronoi voronoi(ring);
  for(std::size_t i = 0; i < 3; ++i)
    voronoi.add_site(vertex_descriptor(static_cast<Mesh::size_type>(num_vertices(ring) / 3 * i)));
  const Geodesics::Geodesic_dual_report r = Geodesics::check_geodesic_dual(voronoi);
  CHECK(!r.is_manifold());
  CHECK_EQUAL(r.cells_that_are_not_disks.size(), std::size_t(3));
}

vertex_descriptor nearest_vertex(const Mesh& mesh, const Kernel::Point_3& p)
{
  return *std::min_element(vertices(mesh).begin(), vertices(mesh).end(), [&](auto a, auto b)
  { return CGAL::squared_distance(mesh.point(a), p) < CGAL::squared_distance(mesh.point(b), p); });
}

// Three sites on the equator of a sphere: all cells meet at two vertices. With one more site at a pole, the dual is a
// tetrahedron.
void cells_with_two_common_vertices_are_reported()
{
  const Mesh sphere = to_face_graph(noisy_sphere(3, .01, 7));
  Voronoi voronoi(sphere);
  for(std::size_t i = 0; i < 3; ++i)
  {
    const double angle = 2 * pi * static_cast<double>(i) / 3;
    voronoi.add_site(nearest_vertex(sphere, Kernel::Point_3(std::cos(angle), std::sin(angle), 0)));
  }
  const Geodesics::Geodesic_dual_report r = Geodesics::check_geodesic_dual(voronoi);
  CHECK(!r.is_manifold());
  CHECK_EQUAL(r.triples_with_several_vertices.size(), std::size_t(1));
  CHECK(r.cells_that_are_not_disks.empty());
  voronoi.add_site(nearest_vertex(sphere, Kernel::Point_3(0, 0, 1)));
  Mesh output;
  CHECK(Geodesics::geodesic_dual_mesh(voronoi, output).is_manifold());
  CHECK_EQUAL(num_faces(output), std::size_t(4));
}

// Sites along a strip: edges run from border to border, and the cell in the middle has two parts of boundary.
void edges_from_border_to_border_are_reported()
{
  const Mesh mesh = to_face_graph(flat_patch(30, 2, 0., false, 1));
  Voronoi voronoi(mesh);
  for(const double x : {.1, .5, .9})
    voronoi.add_site(*std::min_element(vertices(mesh).begin(), vertices(mesh).end(), [&](auto a, auto b)
    {
      const double width = 30;
      return std::abs(mesh.point(a).x() - width * x) + mesh.point(a).y()
           < std::abs(mesh.point(b).x() - width * x) + mesh.point(b).y();
    }));
  const Geodesics::Geodesic_dual_report r = Geodesics::check_geodesic_dual(voronoi);
  CHECK(!r.is_manifold());
  CHECK((r.pairs_without_triangle == Pairs{{0, 1}, {1, 2}}));
  CHECK(r.cells_with_several_boundaries == std::vector<std::size_t>{1});
}

// Without an iteration, the sites are neither moved nor checked.
void no_iteration_moves_no_site()
{
  test_support::Scope scope("no iterations");
  const Mesh mesh = to_face_graph(icosphere(1));
  const std::vector<vertex_descriptor> sites = {vertex_descriptor(3), boost::graph_traits<Mesh>::null_vertex()};
  std::vector<vertex_descriptor> moved;
  CHECK_EQUAL(Geodesics::geodesic_Lloyd_relaxation(mesh, sites, 0, std::back_inserter(moved)), std::size_t(0));
  CHECK(moved == sites);
  moved.clear();
  CHECK(throws<Invalid_input>(
    [&] { Geodesics::geodesic_Lloyd_relaxation(mesh, sites, 1, std::back_inserter(moved)); }));
  CHECK(moved.empty());
}

// A site that is an isolated vertex stays there, and the scale of the mesh does not matter.
void an_isolated_site_stays()
{
  const Indexed_mesh indexed = two_components_and_an_isolated_vertex();
  const vertex_descriptor isolated(static_cast<unsigned int>(indexed.points.size() - 1));
  const std::vector<vertex_descriptor> sites = {vertex_descriptor(0), isolated, vertex_descriptor(50)};
  std::vector<vertex_descriptor> expected;
  for(const int exponent : {0, 600, -600})
  {
    test_support::Scope scope("isolated site, scale 2^" + std::to_string(exponent));
    const Mesh mesh = to_face_graph(scaled(indexed, std::ldexp(1., exponent)));
    std::vector<vertex_descriptor> moved;
    Geodesics::geodesic_Lloyd_relaxation(mesh, sites, 3, std::back_inserter(moved));
    CHECK(moved.size() == 3 && moved[1] == isolated);
    if(exponent == 0)
      expected = moved;
    CHECK(moved == expected);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260402);
  one_or_two_cells_have_no_dual();
  ring_cells_are_reported();
  cells_with_two_common_vertices_are_reported();
  edges_from_border_to_border_are_reported();
  no_iteration_moves_no_site();
  an_isolated_site_stays();
  relaxation_makes_cells_even(seed);
  remeshing_keeps_topology_and_volume(seed);
  return test_result();
}
