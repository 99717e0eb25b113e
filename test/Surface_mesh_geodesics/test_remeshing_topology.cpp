// geodesic_remeshing() with too few samples: it adds some, and the new mesh is manifold, with the Euler characteristic
// and the borders of each component. Tips, holes, strips, pinched vertices, tiny components.

#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test_meshes;
namespace Geodesics = CGAL::Surface_mesh_geodesics;
namespace PMP = CGAL::Polygon_mesh_processing;
using halfedge_descriptor = boost::graph_traits<Mesh>::halfedge_descriptor;
using Report = Geodesics::Geodesic_remeshing_report;
using Topology = std::pair<long, long>; // the Euler characteristic and the number of borders

// In ascending order. Vertices without faces do not count.
std::vector<Topology> topology_of_components(const Mesh& mesh)
{
  Mesh copy = mesh;
  auto component = copy.add_property_map<face_descriptor, std::size_t>("f:test").first;
  std::vector<Topology> topology(PMP::connected_components(copy, component));
  for(const auto f : faces(copy))
    ++topology[component[f]].first;
  const auto face_of = [&](auto h) { return CGAL::is_border(h, copy) ? face(opposite(h, copy), copy) : face(h, copy); };
  for(const auto e : edges(copy))
    --topology[component[face_of(halfedge(e, copy))]].first;
  for(const auto v : vertices(copy))
    if(!copy.is_isolated(v))
      ++topology[component[face_of(halfedge(v, copy))]].first;
  std::vector<halfedge_descriptor> borders;
  PMP::extract_boundary_cycles(copy, std::back_inserter(borders));
  for(const auto h : borders)
    ++topology[component[face_of(h)]].second;
  std::sort(topology.begin(), topology.end());
  return topology;
}

bool has_area(const Mesh& mesh, face_descriptor f)
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Exact> corners;
  for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
    corners.push_back(Exact(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()));
  return !CGAL::collinear(corners[0], corners[1], corners[2]);
}

// Remeshes, and compares with `expected`, the mesh with split vertices.
Report check_topology(const Mesh& mesh, std::size_t n, const Mesh& expected, Mesh& output)
{
  const test_support::Scope scope(std::to_string(n) + " samples");
  const Report report = Geodesics::geodesic_remeshing(mesh, n, output, CGAL::parameters::number_of_iterations(2));
  CHECK(report.is_complete && report.is_manifold());
  CHECK(CGAL::is_triangle_mesh(output) && CGAL::is_valid_polygon_mesh(output));
  std::vector<halfedge_descriptor> pinched;
  PMP::non_manifold_vertices(output, std::back_inserter(pinched));
  CHECK(pinched.empty());
  CHECK(topology_of_components(output) == topology_of_components(expected));
  CHECK_EQUAL(report.number_of_components, topology_of_components(expected).size());
  CHECK_EQUAL(report.number_of_vertices, num_vertices(output));
  CHECK(std::all_of(faces(output).begin(), faces(output).end(), [&](auto f) { return has_area(output, f); }));
  if(report.kept_components.empty() && report.number_of_components_of_samples == 0)
    CHECK_EQUAL(num_vertices(output), report.number_of_samples + report.number_of_added_samples);
  return report;
}

Report check_topology(const Indexed_mesh& indexed, std::size_t n)
{
  const test_support::Scope scope(indexed.name);
  const Mesh mesh = to_face_graph(indexed);
  Mesh output;
  return check_topology(mesh, n, mesh, output);
}

void few_samples_become_more(std::uint64_t seed)
{
  for(const Indexed_mesh& indexed :
      {noisy_sphere(3, .02, seed), torus(1., .2, 36, 12),
       midpoint_subdivision(jittered(genus_2_polycube(), .1, seed), 3),
       prism_tube(6, 40, .2, 10.), midpoint_subdivision(square_with_holes(2), 2), flat_patch(30, 3, 0., false, 1)})
    for(const std::size_t n : {0u, 2u, 20u})
    {
      const Report report = check_topology(indexed, n);
      CHECK_EQUAL(report.number_of_samples, n);
      CHECK(report.kept_components.empty());
      CHECK(n > 2u || report.number_of_added_samples > 0);
      CHECK(report.number_of_rounds < 30);
    }
}

// A corner of the border and a spike, both so acute that the cell of the neighbor reaches around the tip: without
// samples side by side, there would be no end.
void tips_get_samples_side_by_side()
{
  for(const double width : {.3, .05, .001})
  {
    const Indexed_mesh corner{"corner", {{0, 0, 0}, {1, 0, 0}, {1, width, 0}}, {{0, 1, 2}}};
    CHECK(check_topology(midpoint_subdivision(corner, 4), 10).kept_components.empty());
    if(width < .05)
      continue; // a spike needs samples all along, at distances of its width
    const double w = width / 2;
    const Indexed_mesh spike{"spike",
                             {{0, 0, 0}, {1, w, 0}, {1, -w / 2, w}, {1, -w / 2, -w}},
                             {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    CHECK(check_topology(midpoint_subdivision(spike, 4), 10).kept_components.empty());
  }
}

// Samples on the border stay there: the points of the first samples, which the relaxation does not move.
void samples_on_the_border_stay()
{
  const Mesh mesh = to_face_graph(flat_patch(16, 16, .2, true, 5));
  Mesh output;
  const std::size_t n = 60;
  check_topology(mesh, n, mesh, output);
  std::set<std::array<double, 3>> points;
  for(const auto v : vertices(output))
    points.insert({output.point(v).x(), output.point(v).y(), output.point(v).z()});
  std::vector<vertex_descriptor> samples;
  Geodesics::geodesic_farthest_point_sampling(mesh, n, std::back_inserter(samples));
  std::size_t number_on_border = 0;
  for(const auto v : samples)
    if(CGAL::is_border(v, mesh))
    {
      ++number_on_border;
      CHECK_EQUAL(points.count({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}), std::size_t(1));
    }
  CHECK(number_on_border > 10);
}

// If all vertices are samples, the faces are those of the mesh, also if the dual would have others.
void meshes_without_further_vertices_stay()
{
  for(const Indexed_mesh& indexed : {cube(), irregular_tetrahedron(), rough_terrain(5, 1., 3)})
    for(const std::size_t more : {0u, 100u})
    {
      const Mesh mesh = to_face_graph(indexed);
      Mesh output;
      const Report report = check_topology(mesh, num_vertices(mesh) + more, mesh, output);
      CHECK_EQUAL(report.number_of_components_of_samples, std::size_t(1));
      CHECK_EQUAL(report.number_of_rounds + report.number_of_added_samples, std::size_t(0));
      CHECK_EQUAL(num_faces(output), num_faces(mesh));
      CHECK_CLOSE(PMP::area(output), PMP::area(mesh), 1e-14);
    }
}

// A small torus has no dual with fewer samples than vertices, and is next to a sphere that has one. The report says
// where it is.
void small_components_stay()
{
  const Indexed_mesh small = transformed(torus(1., .4, 3, 3), "small torus", [](const Coordinates& p)
  { return Coordinates{p[0] + 9, p[1], p[2]}; });
  const Indexed_mesh both = side_by_side(icosphere(3), small, "sphere and small torus");
  for(const std::size_t n : {1u, 3u, 8u})
  {
    const Report report = check_topology(both, n);
    CHECK_EQUAL(report.kept_components.size(), std::size_t(1));
    CHECK_EQUAL(report.kept_components[0].number_of_vertices, std::size_t(9));
    CHECK_EQUAL(report.kept_components[0].number_of_faces, std::size_t(18));
    CHECK(report.kept_components[0].point[0] > 5);
  }
  CHECK(check_topology(two_components_and_an_isolated_vertex(), 7).kept_components.empty());
}

// Where all points of a component are equal, or on a line, no cell has an area, and there is no dual. Such a component
// stays, alone or next to a torus that has a dual.
void components_without_area_stay()
{
  const auto point = [](const Coordinates&) { return Coordinates{5, 5, 5}; };
  const auto line = [](const Coordinates& p) { return Coordinates{p[0] + 5, 5, 5}; };
  const auto two_points = [](const Coordinates& p) { return Coordinates{p[0] < 3 ? 5. : 7., 5, 5}; };
  for(const Indexed_mesh& flat : {flat_patch(6, 6, 0., false, 1), torus(1., .4, 8, 6)})
    for(const Indexed_mesh& without_area : {transformed(flat, "a point", point), transformed(flat, "a line", line),
                                            transformed(flat, "two points", two_points)})
      for(const Indexed_mesh& indexed : {without_area,
                                         side_by_side(torus(1., .4, 20, 10), without_area, "beside a torus")})
        for(const std::size_t n : {0u, 1u, 3u, 5u, 40u})
        {
          const test_support::Scope scope(flat.name + ", " + without_area.name + ", " + indexed.name + ", "
                                          + std::to_string(n) + " samples");
          const Mesh mesh = to_face_graph(indexed);
          Mesh output;
          const Report report = Geodesics::geodesic_remeshing(mesh, n, output);
          CHECK(report.is_complete && CGAL::is_valid_polygon_mesh(output));
          CHECK(topology_of_components(output) == topology_of_components(mesh));
          CHECK_EQUAL(report.number_of_vertices, num_vertices(output));
          CHECK_EQUAL(report.kept_components.size(), std::size_t(1));
          CHECK(report.kept_components.empty()
                || report.kept_components[0].number_of_faces == without_area.faces.size());
          CHECK_EQUAL(std::count_if(faces(output).begin(), faces(output).end(),
                                    [&](auto f) { return !has_area(output, f); }),
                      static_cast<std::ptrdiff_t>(without_area.faces.size()));
        }
}

// Two squares that share a vertex, and two spheres that do: each umbrella gets a vertex of its own.
void pinched_vertices_are_split()
{
  const Mesh mesh = to_face_graph(midpoint_subdivision(bow_tie(), 4));
  Mesh split = mesh, output;
  CHECK_EQUAL(PMP::duplicate_non_manifold_vertices(split), std::size_t(1));
  Report report = check_topology(mesh, 30, split, output);
  CHECK_EQUAL(report.number_of_split_vertices, std::size_t(1));
  CHECK_EQUAL(report.number_of_components, std::size_t(2));
}

// Two edges between the same vertices, from a flip: three indices do not tell the faces, so the copy has more of them.
void faces_with_equal_corners_are_divided()
{
  Mesh mesh = to_face_graph(regular_tetrahedron());
  CGAL::Euler::flip_edge(halfedge(*edges(mesh).begin(), mesh), mesh);
  CHECK_EQUAL(num_edges(mesh), std::size_t(6));
  Mesh output;
  const Report report = check_topology(mesh, 4, mesh, output);
  CHECK_EQUAL(num_faces(output), std::size_t(24));
  CHECK_EQUAL(report.number_of_components_of_samples, std::size_t(1));
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261123);
  few_samples_become_more(seed);
  tips_get_samples_side_by_side();
  samples_on_the_border_stay();
  meshes_without_further_vertices_stay();
  small_components_stay();
  components_without_area_stay();
  pinched_vertices_are_split();
  faces_with_equal_corners_are_divided();
  return test_result();
}
