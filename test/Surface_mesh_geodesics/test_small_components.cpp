// Components of one mesh may differ in size: each is computed as if the other were not there, down to a factor of
// 10^60. Beyond that lengths would underflow, and the mesh is refused.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

namespace SMG = CGAL::Surface_mesh_geodesics;
using Reason = SMG::Invalid_geodesic_input::Reason;
using Lengths = Mesh::Property_map<Mesh::Edge_index, double>;
using Distances = Mesh::Property_map<vertex_descriptor, double>;

// A flat piece of two triangles, twice as large as the unit.
Indexed_mesh large_component()
{
  return scaled(flat_patch(1, 1, 0., false, 1), 2.);
}

std::vector<Kernel::Point_3> path_of(const Geodesic_paths& paths, vertex_descriptor v)
{
  std::vector<Kernel::Point_3> points;
  paths.shortest_path_points_to_source_points(v, std::back_inserter(points));
  return points;
}

double length_of(const std::vector<Kernel::Point_3>& points, double unit)
{
  double length = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
  {
    const auto d = (points[i] - points[i - 1]) / unit;
    length += std::sqrt(d.squared_length());
  }
  return length * unit;
}

// The small component comes first, or last. Its vertices are `first`, ... in both meshes.
void small_component_is_as_if_alone(const Indexed_mesh& small, double unit, bool is_first, test_support::Random& random)
{
  test_support::Scope scope(small.name + " in the unit " + std::to_string(std::log10(unit)));
  const Indexed_mesh part = scaled(small, unit), large = large_component();
  Mesh alone = to_face_graph(small);
  Mesh tm = to_face_graph(is_first ? side_by_side(part, large, "both") : side_by_side(large, part, "both"));
  const std::size_t shift = is_first ? 0 : large.points.size();
  const auto vertex_of = [](std::size_t i) { return vertex_descriptor(static_cast<Mesh::size_type>(i)); };
  const std::size_t source = random.index(small.points.size());
  Geodesic_paths expected(alone), found(tm);
  expected.add_source_point(vertex_of(source));
  found.add_source_point(vertex_of(source + shift));
  for(std::size_t i = 0; i < small.points.size(); ++i)
  {
    const double d = expected.shortest_distance_to_source_points(vertex_of(i)).first,
                 e = found.shortest_distance_to_source_points(vertex_of(i + shift)).first;
    CHECK_CLOSE(e / unit, d, 1e-13 * (1 + d));
    const std::vector<Kernel::Point_3> path = path_of(found, vertex_of(i + shift));
    CHECK(path.size() >= (i == source ? 1 : 2));
    CHECK(path.front() == tm.point(vertex_of(i + shift)));
    CHECK(path.back() == tm.point(vertex_of(source + shift)));
    CHECK_CLOSE(length_of(path, unit) / unit, e / unit, 1e-12 * (1 + d));
  }
  for(std::size_t i = 0; i < large.points.size(); ++i)
  {
    CHECK(found.shortest_distance_to_source_points(vertex_of(i + (is_first ? small.points.size() : 0))).first < 0);
  }
  const Distances distances = tm.add_property_map<vertex_descriptor, double>("v:distance", 0.).first;
  SMG::geodesic_distances(tm, distances, vertex_of(source + shift));
  CHECK(SMG::certify_geodesic_distances(tm, distances, vertex_of(source + shift)).is_certified());
}

void check_refused(const std::string& what, std::size_t first_face, std::size_t last_face, Mesh& tm, Lengths lengths,
                   bool uses_points)
{
  test_support::Scope scope(what);
  const Distances distances = tm.add_property_map<vertex_descriptor, double>("v:distance", -7.).first;
  bool is_refused = false;
  try
  {
    if(uses_points)
    {
      SMG::geodesic_distances(tm, distances, vertex_descriptor(0));
    }
    else
    {
      SMG::geodesic_distances_from_edge_lengths(tm, lengths, distances, vertex_descriptor(0));
    }
  }
  catch(const SMG::Invalid_geodesic_input& e)
  {
    is_refused = true;
    CHECK(e.reason() == Reason::TOO_SMALL);
    CHECK(first_face <= e.element() && e.element() < last_face);
  }
  CHECK(is_refused);
  CHECK(distances[vertex_descriptor(0)] == -7.);
}

// Also where lengths become zero on the way.
void components_that_are_too_small_are_refused(double unit)
{
  const Indexed_mesh large = large_component(), small = flat_patch(3, 2, .1, false, 2);
  Mesh tm = to_face_graph(side_by_side(large, scaled(small, unit), "both"));
  const Lengths lengths = tm.add_property_map<Mesh::Edge_index, double>("e:length", 0.).first;
  const Mesh shape = to_face_graph(side_by_side(large, small, "both"));
  for(const auto e : edges(tm))
  {
    const auto h = halfedge(e, shape);
    const bool is_small = source(h, shape).idx() >= large.points.size();
    lengths[e] = std::sqrt((shape.point(target(h, shape)) - shape.point(source(h, shape))).squared_length())
               * (is_small ? unit : 1.);
  }
  check_refused("points", large.faces.size(), num_faces(tm), tm, lengths, true);
  check_refused("lengths", large.faces.size(), num_faces(tm), tm, lengths, false);
}

// A component without lengths is as good as a point.
void components_without_lengths_are_accepted()
{
  Mesh tm = to_face_graph(side_by_side(scaled(cube(), 0.), cube(), "both"));
  const Distances distances = tm.add_property_map<vertex_descriptor, double>("v:distance", 0.).first;
  SMG::geodesic_distances(tm, distances, vertex_descriptor(0));
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(distances[v], v.idx() < 8 ? 0. : std::numeric_limits<double>::infinity());
  }
  CHECK(SMG::certify_geodesic_distances(tm, distances, vertex_descriptor(0)).is_certified());
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20261122));
  for(const bool is_first : {true, false})
  {
    for(const double unit : {1e-6, 1e-14, 1e-15, 1e-20, 1e-40, 1e-59})
    {
      small_component_is_as_if_alone(flat_patch(6, 6, 0., false, 1), unit, is_first, random);
      small_component_is_as_if_alone(icosphere(1), unit, is_first, random);
      small_component_is_as_if_alone(saddle_patch(4), unit, is_first, random);
      small_component_is_as_if_alone(flat_patch(1, 1, 0., false, 1), unit, is_first, random);
    }
  }
  for(const double unit : {1e-61, 1e-80, 1e-150, 1e-170, 1e-300})
  {
    components_that_are_too_small_are_refused(unit);
  }
  components_without_lengths_are_accepted();
  return test_result();
}
