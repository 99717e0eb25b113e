// One source, 1, 2, ... threads: geodesic_distances() from vertex 0 with the parallel tag, compared with the sequential
// tag. Prints one line of comma separated values per mesh, level of midpoint subdivision and number of threads. Times
// are elapsed times of the whole call, with reading the mesh: the machine must be idle. Runs with different numbers of
// threads alternate, and the speedup is the median of the ratios of adjacent runs. Without TBB (CGAL_LINKED_WITH_TBB),
// only the sequential tag is measured.
//
// The last line of a mesh tells what the machine allows: as many separate sequential runs at once as there are hardware
// threads. Their speedup counts all of them. They wait for nothing but memory, and share nothing but the mesh.

#include "runs_in_process.h"
#include "thread_counts.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <string>
#include <thread>
#include <vector>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

// Sequential runs from one source, each in a thread of its own with a map of its own.
class Separate_runs
{
public:
  Separate_runs(const Benchmark_mesh& mesh, std::size_t n)
    : m_mesh(mesh), m_distances(n, std::vector<double>(mesh.number_of_vertices()))
  {}

  // Runs the first n of them at once.
  void run(std::size_t n)
  {
    std::vector<std::thread> threads;
    for(std::size_t i = 1; i < n; ++i)
    {
      threads.emplace_back([this, i]() { run_one(m_distances[i]); });
    }
    run_one(m_distances[0]);
    for(std::thread& t : threads)
    {
      t.join();
    }
  }

private:
  void run_one(std::vector<double>& distances) const
  {
    const auto map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh));
    Geodesics::geodesic_distances(m_mesh, map, *m_mesh.vertices().begin());
  }

  const Benchmark_mesh& m_mesh;
  std::vector<std::vector<double>> m_distances;
};

// Prints the line of separate runs.
void measure_separate_runs(const Settings& settings, const Benchmark_mesh& mesh, const std::string& begin_of_line,
                           std::size_t windows)
{
  const std::size_t n = std::thread::hardware_concurrency();
  if(n < 2)
  {
    return;
  }
  Separate_runs runs(mesh, n);
  std::vector<double> one, all;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    one.push_back(milliseconds_of(CLOCK_MONOTONIC, [&]() { runs.run(1); }));
    all.push_back(milliseconds_of(CLOCK_MONOTONIC, [&]() { runs.run(n); }));
  }
  std::cout << begin_of_line << n << " separate runs," << Spread(all) << ','
            << cell(static_cast<double>(n) * median_ratio(one, all), 3) << ',' << windows << std::endl;
}

int main(int argc, char* argv[])
{
  Settings settings;
  settings.subdivisions = 2;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], " mesh...   (--subdivide K: levels up to K, default 2)");
  }
  print_head(settings, "distances of all vertices from vertex 0 by several threads, clock times",
             "mesh,subdivisions,faces,threads," + spread_columns("call_ms") + ",speedup,windows");
  for(const std::string& file : settings.meshes)
  {
    for(std::size_t level = 0; level <= settings.subdivisions; ++level)
    {
      Benchmark_mesh mesh;
      if(!read_mesh(file, level, mesh))
      {
        return EXIT_FAILURE;
      }
      const Benchmark_vertex source = *mesh.vertices().begin();
      auto distances = mesh.add_property_map<Benchmark_vertex, double>("v:distance", 0.).first;
      std::size_t windows[2] = {0, 0}; // of the sequential and the parallel runs
      const Scaling scaling(settings, [&](std::size_t threads) {
        Geodesics::Propagation_statistics statistics;
        const auto np = CGAL::parameters::statistics(&statistics);
        if(threads == 0)
          Geodesics::geodesic_distances(mesh, distances, source, np);
        else
          Geodesics::geodesic_distances<Parallel>(mesh, distances, source, np);
        windows[threads == 0 ? 0 : 1] = statistics.windows_propagated;
      });
      const std::string begin_of_line
        = file_name(file) + ',' + std::to_string(level) + ',' + std::to_string(mesh.number_of_faces()) + ',';
      for(const auto& entry : scaling.entries())
      {
        std::cout << begin_of_line << entry.name << ',' << entry.time << ',' << cell(entry.speedup, 3) << ','
                  << windows[entry.name == "sequential" ? 0 : 1] << std::endl;
      }
      measure_separate_runs(settings, mesh, begin_of_line, windows[0]);
    }
  }
  return EXIT_SUCCESS;
}
