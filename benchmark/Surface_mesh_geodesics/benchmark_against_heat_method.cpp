// Runs CGAL's Heat_method_3 and Geodesic_distance_solver side by side: distances of all vertices from one vertex, and
// from others after that. Prints one line of comma separated values per mesh and variant of the heat method; lines that
// start with '#' describe the machine. The errors of the heat method are relative to the distances of the solver, which
// are exact up to rounding.
//
// Every measurement runs in its own process (this program starts itself again), and the runs of the methods
// alternate; a ratio is the median of the ratios of adjacent runs.
//
// What is timed:
//   first:  construction (for the heat method: with its factorizations), one source, the distances of all vertices;
//   next:   the distances of all vertices from another source, with the same object (mean of --next sources).
// Neither includes reading the mesh and destroying the objects. The time is the processor time of the process.
// Memory is the peak of the resident memory of the process from the construction on, minus the memory that was
// resident after the mesh was read and the arrays of the distances were written once.

#include "benchmark_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

// The options of this program only.
struct Own_settings
{
  std::size_t next = 5; // sources after the first one

  bool read(const std::string& option, const std::string& value)
  {
    return read_number_option(option, value, "--next", next);
  }

  std::vector<std::string> as_arguments() const { return {"--next", std::to_string(next)}; }
};

// The report of a measuring process; the answers are the distances of all vertices from the first source.
struct Report
{
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  std::uint64_t added_memory_kb = 0;
  double first_milliseconds = 0;
  double next_milliseconds = 0;
};

// ---------------------------------------------------------------------------------------------------------------------
// The measuring process
// ---------------------------------------------------------------------------------------------------------------------

template <class Mesh>
class Exact_distances
{
  using Vertex = typename Mesh::Vertex_index;

  const Mesh& m_mesh;
  Geodesics::Geodesic_distance_solver<Mesh> m_solver;

public:
  explicit Exact_distances(const Mesh& mesh)
    : m_mesh(mesh), m_solver(mesh)
  {}

  template <class Distance_map>
  void compute(Vertex source, Distance_map distance)
  {
    m_solver.compute_distances(source);
    for(Vertex v : m_mesh.vertices())
    {
      put(distance, v, m_solver.distance(v));
    }
  }
};

template <class Mesh, class Mode>
class Heat_distances
{
  using Vertex = typename Mesh::Vertex_index;

  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, Mode> m_heat_method;

public:
  explicit Heat_distances(const Mesh& mesh)
    : m_heat_method(mesh)
  {}

  template <class Distance_map>
  void compute(Vertex source, Distance_map distance)
  {
    m_heat_method.clear_sources();
    m_heat_method.add_source(source);
    m_heat_method.estimate_geodesic_distances(distance);
  }
};

template <class Method, class Mesh>
std::vector<double> measure(Mesh& mesh, const Settings& settings, const Own_settings& own, Report& report)
{
  using Vertex = typename Mesh::Vertex_index;
  auto distance = mesh.template add_property_map<Vertex, double>("v:distance", 0).first;
  auto other_distance = mesh.template add_property_map<Vertex, double>("v:other_distance", 0).first;
  std::mt19937_64 random(2026); // the same other sources for all methods
  std::vector<Vertex> others;
  while(others.size() < own.next)
  {
    const Vertex v(static_cast<typename Mesh::size_type>(random() % mesh.number_of_vertices()));
    if(!mesh.is_isolated(v))
    {
      others.push_back(v);
    }
  }

  const std::uint64_t resident = start_of_memory_measurement();
  const double start = milliseconds_now(settings.clock_id());
  Method method(mesh);
  method.compute(*mesh.vertices().begin(), distance);
  const double middle = milliseconds_now(settings.clock_id());
  for(const Vertex v : others)
  {
    method.compute(v, other_distance);
  }
  const double end = milliseconds_now(settings.clock_id());
  report.added_memory_kb = added_memory(resident);
  report.first_milliseconds = middle - start;
  report.next_milliseconds = (end - middle) / static_cast<double>(others.size());

  std::vector<double> answers;
  for(const Vertex v : mesh.vertices())
  {
    answers.push_back(get(distance, v));
  }
  return answers;
}

template <class Kernel>
int measuring_process(const Settings& settings, const Own_settings& own)
{
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  Mesh mesh;
  if(const int code = read_wanted_mesh(settings, mesh))
  {
    return code;
  }
  if(mesh.is_isolated(*mesh.vertices().begin()))
  {
    return not_wanted;
  }
  Report report;
  report.vertices = mesh.number_of_vertices();
  report.faces = mesh.number_of_faces();
  std::vector<double> answers;
  if(settings.method == "exact")
  {
    answers = measure<Exact_distances<Mesh>>(mesh, settings, own, report);
  }
  else if(settings.method == "direct")
  {
    answers = measure<Heat_distances<Mesh, CGAL::Heat_method_3::Direct>>(mesh, settings, own, report);
  }
  else
  {
    answers = measure<Heat_distances<Mesh, CGAL::Heat_method_3::Intrinsic_Delaunay>>(mesh, settings, own, report);
  }
  send_and_exit(settings, report, answers);
}

// ---------------------------------------------------------------------------------------------------------------------
// The process that compares
// ---------------------------------------------------------------------------------------------------------------------

struct Series
{
  std::string method;
  std::vector<double> first_ms, next_ms, added_mb;
  std::vector<double> distances; // of the last run
  Report last;
  bool failed = false;

  void add(const Report& report)
  {
    first_ms.push_back(report.first_milliseconds);
    next_ms.push_back(report.next_milliseconds);
    added_mb.push_back(static_cast<double>(report.added_memory_kb) / 1024);
    last = report;
  }
};

// The errors of estimates at the vertices that the source reaches, except the source.
struct Errors
{
  double mean = 0;                // relative to the distance of the vertex
  double largest = 0;             // relative to the distance of the vertex
  double position_of_largest = 0; // the distance of the vertex with the largest error, relative to the largest distance
  double largest_of_extent = 0;   // relative to the largest distance
  std::size_t not_finite = 0;     // estimates that are not finite; excluded from the errors above
};

Errors errors_of(const std::vector<double>& estimates, const std::vector<double>& distances)
{
  Errors errors;
  std::size_t number = 0;
  double extent = 0, largest_difference = 0, sum = 0;
  for(std::size_t i = 0; i < distances.size(); ++i)
  {
    if(!(distances[i] > 0) || !std::isfinite(distances[i]))
    {
      continue;
    }
    extent = (std::max)(extent, distances[i]);
    if(!std::isfinite(estimates[i]))
    {
      ++errors.not_finite;
      continue;
    }
    const double difference = std::abs(estimates[i] - distances[i]);
    ++number;
    sum += difference / distances[i];
    if(difference / distances[i] > errors.largest)
    {
      errors.largest = difference / distances[i];
      errors.position_of_largest = distances[i];
    }
    largest_difference = (std::max)(largest_difference, difference);
  }
  errors.mean = sum / static_cast<double>(number);
  errors.largest_of_extent = largest_difference / extent;
  errors.position_of_largest /= extent;
  return errors;
}

void print_row(const Settings& settings, const std::string& mesh, const Series& heat, const Series& exact)
{
  const Errors errors = errors_of(heat.distances, exact.distances);
  const double heat_mb = median(heat.added_mb), exact_mb = median(exact.added_mb);
  std::cout << file_name(mesh) << ',' << settings.subdivisions << ',' << exact.last.faces << ',' << exact.last.vertices
            << ',' << heat.method << ',' << cell(median(heat.first_ms), 2) << ','
            << cell(median(exact.first_ms), 2) << ',' << cell(median_ratio(heat.first_ms, exact.first_ms), 3) << ','
            << cell(median(heat.next_ms), 2) << ',' << cell(median(exact.next_ms), 2) << ','
            << cell(median_ratio(heat.next_ms, exact.next_ms), 3) << ',' << cell(heat_mb, 2) << ','
            << cell(exact_mb, 2) << ',' << cell(heat_mb / exact_mb, 2) << ','
            << cell(100 * errors.mean, 3) << ',' << cell(100 * errors.largest, 3) << ','
            << cell(100 * errors.position_of_largest, 3) << ',' << cell(100 * errors.largest_of_extent, 3) << ','
            << errors.not_finite << std::endl;
}

// Returns false if a measurement failed unexpectedly.
bool compare_on(const Settings& settings, const Own_settings& own, const std::string& mesh)
{
  std::vector<Series> all(3);
  all[0].method = "exact";
  all[1].method = "direct";
  all[2].method = "intrinsic";
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    for(Series& series : all)
    {
      Report report;
      const int code = series.failed ? method_failed
                                     : run_measurement(settings, mesh, series.method, own.as_arguments(), report,
                                                       series.distances);
      if(code == 0)
      {
        series.add(report);
      }
      else if(!series.failed && is_skipped(code, mesh, series.method))
      {
        return true;
      }
      else
      {
        series.failed = true;
      }
    }
  }
  bool good = !all[0].failed;
  for(std::size_t i = 1; i < all.size(); ++i)
  {
    good = good && !all[i].failed;
    if(!all[0].failed && !all[i].failed)
    {
      print_row(settings, mesh, all[i], all[0]);
    }
  }
  return good;
}

void print_header(const Settings& settings, const Own_settings& own)
{
  print_machine(settings);
  std::cout << "# source: vertex 0, then " << own.next << " random vertices; " << settings.clock
            << " times in ms, medians of " << settings.repetitions
            << " runs of each method in turn, each in its own process; added memory in MB (2^20 bytes)\n"
            << "# errors in percent, of the distances from vertex 0: of the distance of the vertex, or of the largest "
               "distance\n"
            << "mesh,subdivisions,faces,vertices,variant,heat_first_ms,exact_first_ms,ratio_first,heat_next_ms,"
               "exact_next_ms,ratio_next,heat_added_mb,exact_added_mb,ratio_memory,mean_error_percent,"
               "largest_error_percent,position_of_largest_error_percent,largest_error_of_extent_percent,"
               "estimates_not_finite"
            << std::endl;
}

// ---------------------------------------------------------------------------------------------------------------------

int main(int argc, char* argv[])
{
  Settings settings;
  Own_settings own;
  if(!read_settings(argc, argv, settings,
                    [&](const std::string& option, const std::string& value) { return own.read(option, value); }))
  {
    std::cerr << "usage: " << argv[0] << " [options] mesh...\n"
              << "  --next N              sources after the first one (5)\n";
    print_common_usage();
    return EXIT_FAILURE;
  }
  if(settings.is_measuring())
  {
    try
    {
      return (settings.kernel == "epick")
                 ? measuring_process<CGAL::Exact_predicates_inexact_constructions_kernel>(settings, own)
                 : measuring_process<CGAL::Simple_cartesian<double>>(settings, own);
    }
    catch(const std::exception& error)
    {
      std::cerr << error.what() << std::endl;
      return method_failed;
    }
  }
  if(settings.print_header)
  {
    print_header(settings, own);
  }
  bool good = true;
  for(const std::string& mesh : settings.meshes)
  {
    good = compare_on(settings, own, mesh) && good;
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
