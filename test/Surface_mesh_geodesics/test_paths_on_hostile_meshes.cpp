// Paths on small random meshes of the worst kind. Each path is found, leads from face to face, and is as long as its
// distance. fuzz_paths_on_hostile_meshes.cpp checks many more meshes.

#include "hostile_meshes.h"

#include <CGAL/Surface_mesh_geodesics/internal/interface/Path_solver.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Path_search.h>

#include <cstddef>
#include <cstdint>
#include <iostream>

using namespace test_meshes;

namespace {

// Tests the search for paths, which is the last resort, on meshes that do not need it.
void every_path_is_found_by_search()
{
  namespace internal = CGAL::Surface_mesh_geodesics::internal;
  using Vertex_index_map = boost::property_map<Mesh, boost::vertex_index_t>::const_type;
  using Face_index_map = boost::property_map<Mesh, boost::face_index_t>::const_type;
  using Vertex_point_map = boost::property_map<Mesh, CGAL::vertex_point_t>::const_type;
  for(const Indexed_mesh& mesh : small_collection(20260409))
  {
    test_support::Scope scope("search on " + mesh.name);
    const Mesh tm = to_face_graph(mesh);
    internal::Path_solver<Mesh, Vertex_index_map, Face_index_map> solver(tm, get(boost::vertex_index, tm),
                                                                             get(boost::face_index, tm));
    const Vertex_point_map points = get(CGAL::vertex_point, tm);
    solver.build_mesh(internal::Shape_from_points<double, Mesh, Vertex_point_map>(tm, points));
    solver.begin_sources();
    solver.add_source_location(Face_location(*faces(tm).begin(), {.2, .3, .5}));
    solver.run(false, [](std::size_t, double) { return true; });
    internal::Path_search<double> search(solver.mesh(), solver.field());
    for(const internal::Vertex_id v : solver.field().reached)
    {
      internal::Path_steps<double> steps;
      const double distance = solver.field().distance[v];
      CHECK(search.from_vertex(v, 1e-12 * distance, steps));
      double length = 0.;
      for(const auto& step : steps)
      {
        length += step.gap;
      }
      CHECK_CLOSE(length, distance, 2e-12);
      CHECK(solver.field().is_source(steps.empty() ? v : steps.back().vertex));
    }
  }
}

} // namespace

int main()
{
  every_path_is_found_by_search();
  const std::uint64_t seed = 1;
  std::cout << "seed " << seed << "\n";
  hostile_meshes::paths_on_hostile_meshes(15000, seed, 20);
  return test_support::test_result();
}
