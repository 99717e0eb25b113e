// Components of one mesh may differ in size by a factor of up to 10^60: each has the answers that it has alone. Smaller
// components are rejected; see test_invalid_input.cpp.

#include "Voronoi_test_helpers.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

namespace SMG = CGAL::Surface_mesh_geodesics;
using Distances = Mesh::Property_map<vertex_descriptor, double>;

// A flat piece of two triangles, twice as large as the unit.
Indexed_mesh large_component()
{
  return scaled(flat_patch(1, 1, 0., false, 1), 2.);
}

// The small component comes first, or last.
void a_small_component_has_the_answers_it_has_alone(const Indexed_mesh& small, double unit, bool is_first,
                                                    test_support::Random& random)
{
  test_support::Scope scope(small.name + " in the unit " + std::to_string(std::log10(unit)));
  const Indexed_mesh part = scaled(small, unit), large = large_component();
  Mesh alone = to_face_graph(small);
  Mesh tm = to_face_graph(is_first ? side_by_side(part, large, "both") : side_by_side(large, part, "both"));
  const std::size_t shift = is_first ? 0 : large.points.size();
  const double size = size_of(alone) * unit;
  const std::size_t source = random.index(small.points.size());
  Geodesic_paths expected(alone), found(tm);
  expected.add_source_point(vertex(source));
  found.add_source_point(vertex(source + shift));
  for(std::size_t i = 0; i < small.points.size(); ++i)
  {
    const double d = expected.shortest_distance_to_source_points(vertex(i)).first,
                 e = found.shortest_distance_to_source_points(vertex(i + shift)).first;
    CHECK_CLOSE(e / unit, d, 1e-13 * (1 + d));
    const std::vector<Coordinates> path = checked_path(found, Surface_point(vertex(i + shift)), tm, size);
    CHECK(path.size() >= (i == source ? 1 : 2));
    CHECK(path.front() == coordinates(vertex(i + shift), tm));
    CHECK(path.back() == coordinates(vertex(source + shift), tm));
    CHECK_CLOSE(polyline_length(path) / unit, e / unit, 1e-12 * (1 + d));
  }
  for(std::size_t i = 0; i < large.points.size(); ++i)
  {
    CHECK(found.shortest_distance_to_source_points(vertex(i + (is_first ? small.points.size() : 0))).first < 0);
  }
  const Distances distances = tm.add_property_map<vertex_descriptor, double>("v:distance", 0.).first;
  SMG::geodesic_distances(tm, distances, vertex(source + shift));
  CHECK(SMG::certify_geodesic_distances(tm, distances, vertex(source + shift)).is_certified());
}

// Checks the areas of the cells of two sites: the ends of an edge of the small component, or points in one face of it.
void a_small_component_has_the_cells_it_has_alone(double unit, bool is_first, bool are_vertices)
{
  test_support::Scope scope("cells in the unit " + std::to_string(std::log10(unit)));
  const Indexed_mesh small = saddle_patch(4), part = scaled(small, unit), large = large_component();
  const Mesh alone = to_face_graph(small);
  const Mesh tm = to_face_graph(is_first ? side_by_side(part, large, "both") : side_by_side(large, part, "both"));
  Voronoi expected(alone), found(tm);
  for(Voronoi* diagram : {&expected, &found})
  {
    const bool is_shifted = diagram == &found && !is_first;
    const std::size_t v = is_shifted ? large.points.size() : 0, f = is_shifted ? large.faces.size() : 0;
    for(const std::size_t k : {std::size_t(0), std::size_t(1)})
    {
      if(are_vertices)
      {
        diagram->add_site(vertex(v + k));
      }
      else
      {
        const Voronoi::Barycentric_coordinates b = {{.5, k == 0 ? .2 : .3, k == 0 ? .3 : .2}};
        diagram->add_site(std::make_pair(face_descriptor(static_cast<Mesh::size_type>(f)), b));
      }
    }
  }
  for(const std::size_t k : {std::size_t(0), std::size_t(1)})
  {
    CHECK(expected.area(k) > 0);
    CHECK_CLOSE(found.area(k) / unit / unit, expected.area(k), 1e-12);
  }
  CHECK(SMG::certify_geodesic_Voronoi_diagram(found).is_certified());
}

// A component without lengths is equivalent to a point.
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
      a_small_component_has_the_answers_it_has_alone(flat_patch(6, 6, 0., false, 1), unit, is_first, random);
      a_small_component_has_the_answers_it_has_alone(icosphere(1), unit, is_first, random);
      a_small_component_has_the_answers_it_has_alone(saddle_patch(4), unit, is_first, random);
      a_small_component_has_the_answers_it_has_alone(flat_patch(1, 1, 0., false, 1), unit, is_first, random);
      a_small_component_has_the_cells_it_has_alone(unit, is_first, true);
      a_small_component_has_the_cells_it_has_alone(unit, is_first, false);
    }
  }
  components_without_lengths_are_accepted();
  return test_result();
}
