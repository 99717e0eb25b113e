// Runs CGAL::Surface_mesh_shortest_path and geodesic_distances() side by side: distances of all vertices from one
// vertex. Prints one line of comma separated values per mesh; lines that start with '#' describe the machine.
//
// Every measurement runs in its own process (this program starts itself again), so that the peak of memory belongs to
// one method, and no run profits from memory or caches that another one has warmed up. The runs of the two
// methods alternate, and the ratio of times is the median of the ratios of adjacent runs: a machine that becomes
// slower for a while affects both alike.
//
// What is timed:
//   original: construction, one source, build_sequence_tree(), the distance of every vertex;
//   ours:     the whole call of geodesic_distances() with the map of distances.
// Neither includes reading the mesh and destroying the original's object. The time is the processor time of the
// process, user and system: both methods use one thread, so it equals the elapsed time on an idle machine, and other
// programs on a shared machine do not add to it. (--clock wall measures the elapsed time.) Memory is the peak of the
// resident memory of the process after the start of the method, minus the memory that was resident after the mesh was
// read and the array of the distances was written once.

#include "benchmark_support.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

// The report of a measuring process; the answers are the distances of all vertices.
struct Report
{
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  std::uint64_t windows_propagated = 0;
  std::uint64_t added_memory_kb = 0;
  double milliseconds = 0;
};

// ---------------------------------------------------------------------------------------------------------------------
// The measuring process
// ---------------------------------------------------------------------------------------------------------------------

template <class Kernel, class Mesh>
void measure_original(const Mesh& mesh, typename Mesh::Vertex_index source, std::vector<double>& distances,
                      clockid_t clock, Report& report)
{
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  const std::uint64_t resident = start_of_memory_measurement();
  const double start = milliseconds_now(clock);
  CGAL::Surface_mesh_shortest_path<Traits> shortest_paths(mesh);
  shortest_paths.add_source_point(source);
  shortest_paths.build_sequence_tree();
  for(typename Mesh::Vertex_index v : mesh.vertices())
  {
    const double distance = shortest_paths.shortest_distance_to_source_points(v).first;
    distances[v] = (distance < 0) ? std::numeric_limits<double>::infinity() : distance;
  }
  report.milliseconds = milliseconds_now(clock) - start;
  report.added_memory_kb = added_memory(resident);
}

template <class Mesh>
void measure_ours(Mesh& mesh, typename Mesh::Vertex_index source, std::vector<double>& distances, clockid_t clock,
                  Report& report)
{
  Geodesics::Propagation_statistics statistics;
  auto distance_map = mesh.template add_property_map<typename Mesh::Vertex_index, double>("v:distance", 0).first;

  const std::uint64_t resident = start_of_memory_measurement();
  const double start = milliseconds_now(clock);
  Geodesics::geodesic_distances(mesh, distance_map, source, CGAL::parameters::statistics(&statistics));
  report.milliseconds = milliseconds_now(clock) - start;
  report.added_memory_kb = added_memory(resident);
  report.windows_propagated = statistics.windows_propagated;
  for(typename Mesh::Vertex_index v : mesh.vertices())
  {
    distances[v] = get(distance_map, v);
  }
}

template <class Kernel>
int measuring_process(const Settings& settings)
{
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  Mesh mesh;
  if(const int code = read_wanted_mesh(settings, mesh))
  {
    return code;
  }
  // Vertex 0, or the first vertex with a face: the original cannot start at a vertex without faces.
  typename Mesh::Vertex_index source = *mesh.vertices().begin();
  while(mesh.is_isolated(source))
  {
    ++source;
  }
  Report report;
  report.vertices = mesh.number_of_vertices();
  report.faces = mesh.number_of_faces();
  std::vector<double> distances(mesh.number_of_vertices(), 0.);
  if(settings.method == "original")
  {
    measure_original<Kernel>(mesh, source, distances, settings.clock_id(), report);
  }
  else
  {
    measure_ours(mesh, source, distances, settings.clock_id(), report);
  }
  send_and_exit(settings, report, distances);
}

// ---------------------------------------------------------------------------------------------------------------------
// The process that compares
// ---------------------------------------------------------------------------------------------------------------------

struct Series
{
  std::vector<double> milliseconds, added_mb;
  std::vector<double> distances; // of the last run
  Report last;
  bool failed = false;

  void add(const Report& report)
  {
    milliseconds.push_back(report.milliseconds);
    added_mb.push_back(static_cast<double>(report.added_memory_kb) / 1024);
    last = report;
  }
};

void print_times(const Series& series)
{
  if(series.milliseconds.empty())
  {
    std::cout << ",,,";
    return;
  }
  const auto range = std::minmax_element(series.milliseconds.begin(), series.milliseconds.end());
  std::cout << ',' << cell(median(series.milliseconds), 2) << ',' << cell(*range.first, 2) << ','
            << cell(*range.second, 2);
}

void print_row(const Settings& settings, const std::string& mesh, const Series& original, const Series& ours)
{
  const Report& any = ours.milliseconds.empty() ? original.last : ours.last;
  std::cout << file_name(mesh) << ',' << settings.subdivisions << ',' << any.faces << ',' << any.vertices;
  print_times(original);
  print_times(ours);

  const double time_ratio = median_ratio(original.milliseconds, ours.milliseconds);
  const double original_mb = median(original.added_mb), ours_mb = median(ours.added_mb);
  std::cout << ',' << cell(time_ratio, 2) << ',' << cell(original_mb, 2) << ',' << cell(ours_mb, 2) << ','
            << cell(original_mb / ours_mb, 2) << ',';
  if(!ours.milliseconds.empty())
  {
    const double windows = static_cast<double>(ours.last.windows_propagated);
    std::cout << ours.last.windows_propagated << ',' << cell(1e6 * median(ours.milliseconds) / windows, 2);
  }
  else
  {
    std::cout << ',';
  }
  std::cout << ',';
  if(!original.milliseconds.empty() && !ours.milliseconds.empty())
  {
    std::cout << largest_relative_difference(ours.distances, original.distances);
  }
  std::cout << std::endl;
}

// Returns false if a measurement failed unexpectedly.
bool compare_on(const Settings& settings, const std::string& mesh)
{
  Series original, ours;
  original.failed = !settings.wants("original");
  ours.failed = !settings.wants("ours");
  bool good = true;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    for(Series* series : {&original, &ours})
    {
      if(series->failed)
      {
        continue;
      }
      const char* method = (series == &original) ? "original" : "ours";
      Report report;
      const int code = run_measurement(settings, mesh, method, {}, report, series->distances);
      if(code == 0)
      {
        series->add(report);
      }
      else if(is_skipped(code, mesh, method))
      {
        return true;
      }
      else
      {
        series->failed = true;
        good = false;
      }
    }
  }
  print_row(settings, mesh, original, ours);
  return good;
}

void print_header(const Settings& settings)
{
  print_machine(settings);
  std::cout << "# source: vertex 0; " << settings.clock << " times in ms, " << settings.repetitions
            << " runs of each method in turn, "
            << "each in its own process; added memory in MB (2^20 bytes)\n"
            << "mesh,subdivisions,faces,vertices,original_ms,original_ms_min,original_ms_max,ours_ms,ours_ms_min,"
               "ours_ms_max,time_ratio,original_added_mb,ours_added_mb,memory_ratio,windows_propagated,ns_per_window,"
               "largest_relative_difference"
            << std::endl;
}

// ---------------------------------------------------------------------------------------------------------------------

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    std::cerr << "usage: " << argv[0] << " [options] mesh...\n";
    print_common_usage();
    return EXIT_FAILURE;
  }
  if(settings.is_measuring())
  {
    try
    {
      return (settings.kernel == "epick")
                 ? measuring_process<CGAL::Exact_predicates_inexact_constructions_kernel>(settings)
                 : measuring_process<CGAL::Simple_cartesian<double>>(settings);
    }
    catch(const std::exception& error)
    {
      std::cerr << error.what() << std::endl;
      return method_failed;
    }
  }
  if(settings.print_header)
  {
    print_header(settings);
  }
  bool good = true;
  for(const std::string& mesh : settings.meshes)
  {
    good = compare_on(settings, mesh) && good;
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
