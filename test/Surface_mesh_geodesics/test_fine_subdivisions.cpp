// Subdivided surfaces with sharp edges between flat regions: many rays graze flat vertices, and many distances tie. The
// distances do not depend on the subdivision, on the pruning rules, or on the numbers of lanes, threads and concurrent
// visits, and they are certified. Arguments: names of files with meshes to use instead.

#include "distance_test_helpers.h"
#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"
#include "thread_team.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Parallel_distance_propagation.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

namespace internal = SMG::internal;

const double tolerance = 1e-12;

struct Without_pair_rules : internal::All_pruning_rules
{
  static constexpr bool pair_rules = false;
};

// The first vertices of a finer mesh are those of the coarser one.
void check_first_distances(const std::vector<double>& found, const std::vector<double>& expected)
{
  for(std::size_t v = 0; v < expected.size(); ++v)
  {
    CHECK_CLOSE(found[v], expected[v], tolerance);
  }
}

template <class Propagation>
void check_propagation(Propagation& propagation, const internal::Vertex_distance_field<double>& field,
                       internal::Vertex_id source, const std::vector<double>& expected)
{
  propagation.restart();
  propagation.add_source(source, 0.);
  CHECK(propagation.run([](std::size_t, double) { return true; }));
  for(std::size_t v = 0; v < expected.size(); ++v)
  {
    CHECK_CLOSE(field.distance[v], expected[v], tolerance);
  }
}

// All variants of the code, on the intrinsic mesh itself, whose vertices have indices of their own.
void check_ways(const Mesh& tm, std::size_t source, bool takes_rules_out)
{
  const internal::Intrinsic_mesh<double> mesh = intrinsic_mesh(tm);
  const internal::Vertex_id s = static_cast<internal::Vertex_id>(source % mesh.number_of_vertices());
  internal::Vertex_distance_field<double> field;
  internal::Distance_propagation<double> scalar(mesh, field, internal::No_window_keeper(), internal::Lane_choice::ONE);
  scalar.add_source(s, 0.);
  CHECK(scalar.run([](std::size_t, double) { return true; }));
  const std::vector<double> expected = field.distance;
  {
    test_support::Scope scope("lanes");
    internal::Distance_propagation<double> propagation(mesh, field);
    check_propagation(propagation, field, s, expected);
    CHECK(field.distance == expected);
  }
  if(takes_rules_out)
  {
    test_support::Scope scope("without rules 2 and 3");
    internal::Distance_propagation<double, Without_pair_rules> propagation(mesh, field);
    check_propagation(propagation, field, s, expected);
  }
  for(const std::size_t number_of_stars : {std::size_t(1), std::size_t(7), std::size_t(64), std::size_t(1000)})
  {
    test_support::Scope scope("two threads, visits under way: " + std::to_string(number_of_stars));
    internal::Parallel_distance_propagation<double, internal::All_pruning_rules, Thread_team> propagation(
      mesh, field, number_of_stars, Thread_team(2));
    check_propagation(propagation, field, s, expected);
  }
}

void subdivisions_keep_distances(const Indexed_mesh& coarse, std::size_t times, bool takes_rules_out)
{
  test_support::Scope scope(coarse.name);
  const Mesh tm = to_face_graph(coarse);
  for(const std::size_t source : {std::size_t(0), std::size_t(num_vertices(tm) / 2)})
  {
    const std::vector<double> expected = distances(tm, vertex(source));
    Indexed_mesh indexed = coarse;
    for(std::size_t i = 0; i < times; ++i)
    {
      test_support::Scope level("subdivided " + std::to_string(i + 1) + " times");
      indexed = midpoint_subdivision(indexed);
      Mesh finer = to_face_graph(indexed);
      const auto map = finer.add_property_map<vertex_descriptor, double>("v:distance", 0.).first;
      CHECK(SMG::geodesic_distances(finer, map, vertex(source)));
      check_first_distances(values_at_vertices(finer, map), expected);
      if(i == 0)
      {
        if(source == 0)
        {
          CHECK(SMG::certify_geodesic_distances(finer, map, vertex(source)).is_certified(tolerance));
        }
        check_ways(finer, source, takes_rules_out);
      }
    }
  }
}

} // namespace

int main(int argc, char* argv[])
{
  for(int i = 1; i < argc; ++i)
  {
    Mesh tm;
    if(CHECK(CGAL::IO::read_polygon_mesh(argv[i], tm)))
    {
      subdivisions_keep_distances(to_indexed_mesh(tm, argv[i]), 2, false);
    }
  }
  if(argc == 1)
  {
    subdivisions_keep_distances(midpoint_subdivision(genus_2_polycube(), 2), 3, true);
    subdivisions_keep_distances(prism_tube(12, 6, 1., 3.), 4, true);
  }
  return test_result();
}
