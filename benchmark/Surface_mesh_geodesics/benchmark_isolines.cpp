// What isolines cost: distances of all vertices from vertex 0 without lines; with about 20 lines at round distances
// that are found on the way, geodesic_isolines(); and with the same lines from all windows,
// Surface_mesh_geodesic_paths::isolines(). Prints one line of comma separated values per mesh.
//
// Each way has a process of its own, which this program starts, and the ways alternate. Times are processor times of
// the calls, with reading the user's mesh. Memory is the peak of the resident memory of the process during the call,
// with the mesh of the user.

#include "benchmark_support.h"
#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_isolines.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

using Point = Benchmark_kernel::Point_3;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Benchmark_kernel, Benchmark_mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

const std::array<std::string, 3> ways = {{"without", "on_the_way", "from_all_windows"}};

// The report of a measuring process; the answers are the distances.
struct Report
{
  std::uint64_t faces = 0, lines = 0, points = 0;
  double milliseconds = 0, megabytes = 0;
};

// Multiples of 1, 2 or 5 times a power of ten, about 20 of them.
std::vector<double> round_levels(double largest)
{
  const double wanted = largest / 21, power = std::pow(10., std::floor(std::log10(wanted)));
  const double digits = wanted / power, step = power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
  std::vector<double> levels;
  for(int i = 1; i * step < largest; ++i)
  {
    levels.push_back(i * step);
  }
  return levels;
}

// Computes the distances of all vertices, and counts the lines of the levels and their points.
void compute(const Benchmark_mesh& mesh, const std::string& way, const std::vector<double>& levels,
             std::vector<double>& distances, Report& report)
{
  const Benchmark_vertex source = *mesh.vertices().begin();
  const auto map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  if(way == ways[0])
  {
    Geodesics::geodesic_distances(mesh, map, source);
  }
  else if(way == ways[1])
  {
    std::vector<std::pair<std::size_t, std::vector<Point>>> lines;
    Geodesics::geodesic_isolines(mesh, source, levels, std::back_inserter(lines),
                                 CGAL::parameters::vertex_distance_map(map));
    report.lines = lines.size();
    for(const auto& line : lines)
    {
      report.points += line.second.size();
    }
  }
  else
  {
    Paths paths(mesh);
    paths.add_source_point(source);
    paths.build_sequence_tree_for_faces();
    std::vector<std::vector<Point>> lines;
    for(const double level : levels)
    {
      paths.isolines(level, std::back_inserter(lines));
    }
    report.lines = lines.size();
    for(const auto& line : lines)
    {
      report.points += line.size();
    }
    for(const Benchmark_vertex v : mesh.vertices())
    {
      distances[v] = paths.shortest_distance_to_source_points(v).first;
    }
  }
}

// The levels come from a first run, which is not measured.
[[noreturn]] void measure(const Settings& settings, const Benchmark_mesh& mesh)
{
  std::vector<double> distances(mesh.num_vertices(), 0.);
  Report report;
  compute(mesh, ways[0], {}, distances, report);
  const std::vector<double> levels = round_levels(*std::max_element(distances.begin(), distances.end()));
  start_of_memory_measurement();
  report.faces = mesh.number_of_faces();
  report.milliseconds
    = milliseconds_of(settings.clock_id(), [&]() { compute(mesh, settings.method, levels, distances, report); });
  report.megabytes = static_cast<double>(status_kilobytes("VmHWM:")) / 1024;
  send_and_exit(settings, report, distances);
}

// Returns false if a measurement failed unexpectedly.
bool compare_on(const Settings& settings, const std::string& mesh)
{
  std::array<std::vector<double>, 3> milliseconds, megabytes;
  std::array<std::vector<double>, 3> answers;
  std::array<Report, 3> report;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    for(std::size_t w = 0; w < ways.size(); ++w)
    {
      const int code = run_measurement(settings, mesh, ways[w], {}, report[w], answers[w]);
      if(code != 0)
      {
        return is_skipped(code, mesh, ways[w]);
      }
      milliseconds[w].push_back(report[w].milliseconds);
      megabytes[w].push_back(report[w].megabytes);
    }
  }
  std::cout << file_name(mesh) << ',' << settings.subdivisions << ',' << report[0].faces << ','
            << report[1].lines << ',' << report[1].points;
  for(std::size_t w = 0; w < ways.size(); ++w)
  {
    std::cout << ',' << Spread(milliseconds[w]) << ',' << cell(median(megabytes[w]), 1);
  }
  for(const std::size_t w : {1u, 2u})
  {
    std::cout << ',' << cell(median(milliseconds[w]) / median(milliseconds[0]), 2) << ','
              << cell(median(megabytes[w]) / median(megabytes[0]), 2);
  }
  std::cout << ',' << (report[1].lines == report[2].lines && report[1].points == report[2].points) << ','
            << largest_relative_difference(answers[1], answers[0]) << std::endl;
  return true;
}

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
      Benchmark_mesh mesh;
      if(const int code = read_wanted_mesh(settings, mesh))
      {
        return code;
      }
      measure(settings, mesh);
    }
    catch(const std::exception& error)
    {
      std::cerr << error.what() << std::endl;
      return method_failed;
    }
  }
  if(settings.print_header)
  {
    print_machine(settings);
    std::cout << "# distances from vertex 0, without lines, with about 20 lines on the way, and with the same lines "
                 "from all windows; medians of "
              << settings.repetitions << " runs of each kind in turn, each in its own process\n"
              << "# " << settings.clock
              << " times of whole calls in ms: median, least and greatest; memory: peak of the process in MB "
                 "(2^20 bytes)\n"
              << "mesh,subdivisions,faces,lines,points";
    for(const std::string& way : ways)
    {
      std::cout << ',' << spread_columns(way + "_ms") << ',' << way << "_mb";
    }
    for(const std::size_t w : {1u, 2u})
    {
      std::cout << ',' << ways[w] << "_time_ratio," << ways[w] << "_memory_ratio";
    }
    std::cout << ",equal_lines,largest_relative_difference" << std::endl;
  }
  bool good = true;
  for(const std::string& mesh : settings.meshes)
  {
    good = compare_on(settings, mesh) && good;
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
