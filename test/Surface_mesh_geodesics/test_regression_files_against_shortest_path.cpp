// The small meshes of data/ give the distances of Surface_mesh_shortest_path, with one source at a vertex.
//
// Files without a comparison, and why: needle_dup_position and cap_zero_area (the original reads freed memory or misses
// paths at edges without length and faces without area), isolated_vertex and pinched_vertex (an assertion of the
// original fails), grid5_huge_1e9 (the original is wrong by 1e-2; test_regressions checks the distances),
// edge_three_faces and index_out_of_range (not valid meshes), needle_* and cap* (see test_needles_and_caps).

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_shortest_path.h>

#include <cmath>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

using Original_traits
  = CGAL::Surface_mesh_shortest_path_traits<CGAL::Exact_predicates_inexact_constructions_kernel, Mesh>;
using Original = CGAL::Surface_mesh_shortest_path<Original_traits>;

void distances_are_those_of_the_original(const std::string& name)
{
  test_support::Scope scope(name);
  const Mesh tm = load_data(name);
  for(const vertex_descriptor s : vertices(tm))
  {
    const std::vector<double> ours = distances(tm, s);
    Original original(tm);
    original.add_source_point(s);
    for(const vertex_descriptor v : vertices(tm))
    {
      const double d = original.shortest_distance_to_source_points(v).first;
      if(d < 0)
      {
        CHECK(std::isinf(ours[std::size_t(v)]));
      }
      else
      {
        CHECK(std::abs(ours[std::size_t(v)] - d) <= 1e-12 * d);
      }
    }
  }
}

} // namespace

int main()
{
  for(const char* name :
      {"L_shape", "cone64", "cube", "grid4", "grid5", "grid6", "grid7", "grid8", "grid9", "grid5_tiny_1e-9",
       "kite_pp3d30", "octahedron", "saddle_fan8", "single_triangle", "square100_gc111", "strip4", "tetra",
       "two_components", "two_tri_square", "two_tri_square_b"})
  {
    distances_are_those_of_the_original(name);
  }
  return test_result();
}
