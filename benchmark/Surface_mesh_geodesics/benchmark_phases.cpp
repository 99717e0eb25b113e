// What limits the parallel propagation: distances of all vertices from vertex 0 with one thread, which measures each
// phase and each visit. Prints one line of comma separated values per mesh and level of midpoint subdivision: the time,
// its parts, and the speedup over this one thread that is predicted for 2, 4, 8, 16 and 64 threads (Phase_clock.h).
// Times are those of the propagation alone, without reading the mesh. The machine must be idle.

#include "Phase_clock.h"
#include "benchmark_surface.h"
#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Worker_team.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Parallel_distance_propagation.h>

#include <algorithm>

namespace {

namespace geodesics = CGAL::Surface_mesh_geodesics::internal;

using Propagation
  = geodesics::Parallel_distance_propagation<double, geodesics::All_pruning_rules, geodesics::Calling_thread,
                                             geodesics::No_window_keeper, Phase_clock>;

// The run of median time.
Phase_clock measure(const Settings& settings, const Benchmark_mesh& mesh, double sharing_cost)
{
  const Benchmark_surface surface = surface_of(mesh);
  geodesics::Vertex_distance_field<double> field;
  Propagation propagation(surface.mesh(), field);
  std::vector<Phase_clock> clocks;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    propagation.restart();
    propagation.add_source(surface.id(*mesh.vertices().begin()), 0.);
    propagation.clock().start(sharing_cost);
    propagation.run([](std::size_t, double) { return true; });
    propagation.clock().stop();
    clocks.push_back(propagation.clock());
  }
  const auto middle = clocks.begin() + static_cast<std::ptrdiff_t>(clocks.size() / 2);
  std::nth_element(clocks.begin(), middle, clocks.end(),
                   [](const Phase_clock& a, const Phase_clock& b) { return a.total() < b.total(); });
  return *middle;
}

void print_row(const std::string& file, std::size_t level, std::size_t faces, const Phase_clock& clock,
               double sharing_cost)
{
  const double ms = 1e-6;
  std::cout << file_name(file) << ',' << level << ',' << faces << ',' << cell(ms * clock.total(), 3) << ','
            << cell(ms * clock.visits(), 3) << ',' << cell(ms * clock.parts(), 3) << ','
            << cell(ms * clock.outside(), 3) << ',' << clock.number_of_shared_phases() << ','
            << cell(sharing_cost / 1000, 3) << ',' << cell(clock.serial_share(), 4);
  for(std::size_t i = 0; i < Phase_clock::threads.size(); ++i)
    std::cout << ',' << cell(clock.predicted_speedup(i), 2);
  std::cout << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  settings.subdivisions = 2;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], " mesh...   (--subdivide K: levels up to K, default 2)");
  }
  const double sharing_cost = sharing_cost_ns();
  std::string columns = "mesh,subdivisions,faces,run_ms,visits_ms,parts_ms,outside_ms,shared_phases,sharing_us,"
                        "serial_share";
  for(const std::size_t n : Phase_clock::threads)
  {
    columns += ",predicted_" + std::to_string(n);
  }
  print_head(settings, "phases of the parallel propagation from vertex 0 with one thread, clock times", columns);
  return print_rows_by_level(settings, [&](const std::string& file, std::size_t level, const Benchmark_mesh& mesh)
  { print_row(file, level, mesh.number_of_faces(), measure(settings, mesh, sharing_cost), sharing_cost); });
}
