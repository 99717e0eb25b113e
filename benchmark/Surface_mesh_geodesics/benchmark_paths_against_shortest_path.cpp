// Runs CGAL::Surface_mesh_shortest_path and CGAL::Surface_mesh_geodesic_paths side by side: building, distance queries
// and path queries at vertices and in faces, for 1, 10 and 50 source points strictly inside random faces. Prints one
// line of comma separated values per mesh and number of sources; lines that start with '#' describe the machine.
//
// Every measurement runs in its own process (this program starts itself again). There are three kinds:
//   original:        Surface_mesh_shortest_path; what it builds serves queries at vertices and in faces;
//   ours, vertices:  Surface_mesh_geodesic_paths with build_sequence_tree(), then queries at vertices;
//   ours, faces:     Surface_mesh_geodesic_paths with build_sequence_tree_for_faces(), then queries in faces.
// They alternate, and a ratio is the median of the ratios of adjacent runs: a machine that becomes slower for a
// while affects all alike.
//
// What is timed:
//   build:   construction, adding the sources, and the function that builds;
//   queries: shortest_distance_to_source_points() at random vertices, or at random points strictly inside faces;
//   paths:   shortest_path_points_to_source_points() from such locations, into a vector.
// Neither includes reading the mesh and destroying the object. The time is the processor time of the process: all
// methods use one thread, and other programs on a shared machine do not add to it. (--clock wall measures the elapsed
// time.) Memory is the peak of the resident memory from the start of the construction to the last path, minus the
// memory that was resident before, with the mesh, the locations of the queries and the array of the answers.

#include "benchmark_support.h"
#include "random_locations.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

// The report of a measuring process. The answers are the distances of the vertices, the lengths of the paths from the
// vertices, the distances of the points in faces, and the lengths of the paths from these points. Times are in ms per
// build and in microseconds per query; NaN if the process does not measure them.
struct Report
{
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  double added_mb = none;
  double build = none;
  double vertex_query = none, face_query = none;
  double vertex_path = none, face_path = none;
  double points_per_vertex_path = none, points_per_face_path = none;
};

// The options of this program only.
struct Path_settings
{
  std::vector<std::size_t> numbers_of_sources = {1, 10, 50};
  std::size_t queries = 20000;
  std::size_t paths = 1000;
  std::size_t seed = 2026;

  bool read_option(const std::string& option, const std::string& value)
  {
    const std::size_t number = std::strtoul(value.c_str(), nullptr, 10);
    if(option == "--sources")
    {
      return read_numbers(value, numbers_of_sources);
    }
    if(option == "--queries" && number > 0)
    {
      queries = number;
    }
    else if(option == "--paths" && number > 0)
    {
      paths = number;
    }
    else if(option == "--seed")
    {
      seed = number;
    }
    else
    {
      return false;
    }
    return true;
  }
};

// ---------------------------------------------------------------------------------------------------------------------
// The measuring process
// ---------------------------------------------------------------------------------------------------------------------

template <class Point>
double polyline_length(const std::vector<Point>& points)
{
  double length = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
  {
    length += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
  }
  return points.empty() ? std::numeric_limits<double>::infinity() : length; // without a path, the distance is infinite
}

template <class Paths>
struct Query_locations
{
  using Triangle_mesh = typename Paths::Triangle_mesh;
  using vertex_descriptor = typename Paths::vertex_descriptor;
  using face_descriptor = typename Paths::face_descriptor;
  using Face_location = typename Paths::Face_location;

  std::vector<Face_location> sources, in_faces;
  std::vector<vertex_descriptor> at_vertices;

  Query_locations(const Triangle_mesh& mesh, std::size_t number_of_sources, const Path_settings& settings)
  {
    const std::vector<vertex_descriptor> all_vertices(vertices(mesh).begin(), vertices(mesh).end());
    const std::vector<face_descriptor> all_faces(faces(mesh).begin(), faces(mesh).end());
    Random_locations source_locations(settings.seed), query_locations(settings.seed + 1);
    for(std::size_t i = 0; i < number_of_sources; ++i)
    {
      sources.push_back(source_locations.inner_location<Face_location>(all_faces));
    }
    for(std::size_t i = 0; i < settings.queries; ++i)
    {
      at_vertices.push_back(query_locations.element(all_vertices));
      in_faces.push_back(query_locations.inner_location<Face_location>(all_faces));
    }
  }
};

// One interface for queries at vertices and in faces.
template <class Paths>
auto distance_to(Paths& paths, typename Paths::vertex_descriptor v)
{
  return paths.shortest_distance_to_source_points(v).first;
}

template <class Paths>
auto distance_to(Paths& paths, const typename Paths::Face_location& location)
{
  return paths.shortest_distance_to_source_points(location.first, location.second).first;
}

template <class Paths, class Points>
void path_to(Paths& paths, typename Paths::vertex_descriptor v, Points& points)
{
  paths.shortest_path_points_to_source_points(v, std::back_inserter(points));
}

template <class Paths, class Points>
void path_to(Paths& paths, const typename Paths::Face_location& location, Points& points)
{
  paths.shortest_path_points_to_source_points(location.first, location.second, std::back_inserter(points));
}

// Returns microseconds per query; writes the distances to `answers`.
template <class Paths, class Location>
double measure_queries(Paths& paths, const std::vector<Location>& locations, double* answers, clockid_t clock)
{
  const double start = milliseconds_now(clock);
  for(std::size_t i = 0; i < locations.size(); ++i)
  {
    const double distance = distance_to(paths, locations[i]);
    answers[i] = (distance < 0) ? std::numeric_limits<double>::infinity() : distance;
  }
  return 1e3 * (milliseconds_now(clock) - start) / static_cast<double>(locations.size());
}

// Returns microseconds per path.
template <class Paths, class Location>
double measure_paths(Paths& paths, const std::vector<Location>& locations, std::size_t number, clockid_t clock,
                     double& points_per_path)
{
  std::vector<typename Paths::Point_3> points;
  std::size_t number_of_points = 0;
  const double start = milliseconds_now(clock);
  for(std::size_t i = 0; i < number; ++i)
  {
    points.clear();
    path_to(paths, locations[i], points);
    number_of_points += points.size();
  }
  const double time = milliseconds_now(clock) - start;
  points_per_path = static_cast<double>(number_of_points) / static_cast<double>(number);
  return 1e3 * time / static_cast<double>(number);
}

template <class Paths, class Location>
void write_path_lengths(Paths& paths, const std::vector<Location>& locations, std::size_t number, double* answers)
{
  std::vector<typename Paths::Point_3> points;
  for(std::size_t i = 0; i < number; ++i)
  {
    points.clear();
    path_to(paths, locations[i], points);
    answers[i] = polyline_length(points);
  }
}

// `build(paths)` builds.
template <class Paths, class Build>
int measure(const Settings& settings, const Path_settings& path_settings, bool with_vertices, bool with_faces,
            const Build& build)
{
  typename Paths::Triangle_mesh mesh;
  if(const int code = read_wanted_mesh(settings, mesh))
  {
    return code;
  }
  const Query_locations<Paths> locations(mesh, path_settings.numbers_of_sources.front(), path_settings);
  const clockid_t clock = settings.clock_id();
  const std::size_t queries = path_settings.queries, number_of_paths = path_settings.paths;
  Report report;
  report.vertices = mesh.number_of_vertices();
  report.faces = mesh.number_of_faces();
  std::vector<double> answers(2 * (queries + number_of_paths), 0.);
  double* const of_vertices = answers.data();
  double* const of_faces = of_vertices + queries + number_of_paths;

  const std::uint64_t resident = start_of_memory_measurement();
  const double start = milliseconds_now(clock);
  Paths paths(mesh);
  for(const typename Paths::Face_location& source : locations.sources)
  {
    paths.add_source_point(source.first, source.second);
  }
  build(paths);
  report.build = milliseconds_now(clock) - start;
  if(with_vertices)
  {
    report.vertex_query = measure_queries(paths, locations.at_vertices, of_vertices, clock);
    report.vertex_path =
        measure_paths(paths, locations.at_vertices, number_of_paths, clock, report.points_per_vertex_path);
  }
  if(with_faces)
  {
    report.face_query = measure_queries(paths, locations.in_faces, of_faces, clock);
    report.face_path = measure_paths(paths, locations.in_faces, number_of_paths, clock, report.points_per_face_path);
  }
  report.added_mb = static_cast<double>(added_memory(resident)) / 1024;

  if(with_vertices)
  {
    write_path_lengths(paths, locations.at_vertices, number_of_paths, of_vertices + queries);
  }
  if(with_faces)
  {
    write_path_lengths(paths, locations.in_faces, number_of_paths, of_faces + queries);
  }
  send_and_exit(settings, report, answers);
}

template <class Kernel>
int measuring_process(const Settings& settings, const Path_settings& path_settings)
{
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  using Original = CGAL::Surface_mesh_shortest_path<Traits>;
  using Ours = CGAL::Surface_mesh_geodesic_paths<Traits>;
  if(settings.method == "original")
  {
    return measure<Original>(settings, path_settings, true, true, [](Original& o) { o.build_sequence_tree(); });
  }
  if(settings.method == "ours, vertices")
  {
    return measure<Ours>(settings, path_settings, true, false, [](Ours& o) { o.build_sequence_tree(); });
  }
  return measure<Ours>(settings, path_settings, false, true, [](Ours& o) { o.build_sequence_tree_for_faces(); });
}

// ---------------------------------------------------------------------------------------------------------------------
// The process that compares
// ---------------------------------------------------------------------------------------------------------------------

struct Series
{
  std::string method;
  bool is_wanted;
  std::vector<Report> reports;
  std::vector<double> answers; // of the last run

  std::vector<double> values(double Report::*quantity) const
  {
    std::vector<double> result;
    for(const Report& report : reports)
    {
      result.push_back(report.*quantity);
    }
    return result;
  }
};

// ,original,ours,ratio
void print_comparison(const Series& original, const Series& ours, double Report::*quantity, int digits)
{
  const std::vector<double> a = original.values(quantity), b = ours.values(quantity);
  std::cout << ',' << cell(median(a), digits) << ',' << cell(median(b), digits) << ',' << cell(median_ratio(a, b), 2);
}

// The part of the answers that begins at `first`.
std::vector<double> part(const std::vector<double>& answers, std::size_t first, std::size_t number)
{
  const auto begin = answers.begin() + static_cast<std::ptrdiff_t>(first);
  return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(number));
}

void print_row(const Settings& settings, const Path_settings& path_settings, std::size_t number_of_sources,
               const std::string& mesh, const Series& original, const Series& ours_vertices, const Series& ours_faces)
{
  Report any;
  for(const Series* series : {&original, &ours_vertices, &ours_faces})
  {
    any = series->reports.empty() ? any : series->reports.back();
  }
  std::cout << file_name(mesh) << ',' << settings.subdivisions << ',' << any.faces << ',' << any.vertices << ','
            << number_of_sources;
  print_comparison(original, ours_vertices, &Report::build, 2);
  print_comparison(original, ours_faces, &Report::build, 2);
  print_comparison(original, ours_vertices, &Report::vertex_query, 4);
  print_comparison(original, ours_faces, &Report::face_query, 4);
  print_comparison(original, ours_vertices, &Report::vertex_path, 3);
  print_comparison(original, ours_faces, &Report::face_path, 3);
  print_comparison(original, ours_vertices, &Report::added_mb, 2);
  print_comparison(original, ours_faces, &Report::added_mb, 2);
  std::cout << ',' << cell(median(ours_vertices.values(&Report::points_per_vertex_path)), 1) << ','
            << cell(median(ours_faces.values(&Report::points_per_face_path)), 1);

  // With several sources the original does not always return the distance from the nearest one.
  if(number_of_sources != 1 || original.reports.empty() || ours_vertices.reports.empty() || ours_faces.reports.empty())
  {
    std::cout << ",," << std::endl;
    return;
  }
  const std::size_t queries = path_settings.queries, paths = path_settings.paths, half = queries + paths;
  const auto difference = [&](std::size_t first, std::size_t number) {
    return (std::max)(
        largest_relative_difference(part(ours_vertices.answers, first, number), part(original.answers, first, number)),
        largest_relative_difference(part(ours_faces.answers, half + first, number),
                                    part(original.answers, half + first, number)));
  };
  std::cout << ',' << difference(0, queries) << ',' << difference(queries, paths) << std::endl;
}

// Returns false if a measurement failed unexpectedly.
bool compare_on(const Settings& settings, const Path_settings& path_settings, std::size_t number_of_sources,
                const std::string& mesh)
{
  std::array<Series, 3> all = {{{"original", settings.wants("original"), {}, {}},
                                {"ours, vertices", settings.wants("ours"), {}, {}},
                                {"ours, faces", settings.wants("ours"), {}, {}}}};
  const std::vector<std::string> own_options = {
      "--sources", std::to_string(number_of_sources),   "--queries", std::to_string(path_settings.queries),
      "--paths",   std::to_string(path_settings.paths), "--seed",    std::to_string(path_settings.seed)};
  bool good = true;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    for(Series& series : all)
    {
      if(!series.is_wanted)
      {
        continue;
      }
      Report report;
      const int code = run_measurement(settings, mesh, series.method, own_options, report, series.answers);
      if(code == 0)
      {
        series.reports.push_back(report);
      }
      else if(is_skipped(code, mesh, series.method))
      {
        return true;
      }
      else
      {
        series.is_wanted = false;
        good = false;
      }
    }
  }
  print_row(settings, path_settings, number_of_sources, mesh, all[0], all[1], all[2]);
  return good;
}

void print_header(const Settings& settings, const Path_settings& path_settings)
{
  print_machine(settings);
  std::cout << "# sources: points strictly inside random faces, seed " << path_settings.seed << "; medians of "
            << settings.repetitions << " runs of each kind in turn, each in its own process\n"
            << "# " << settings.clock << " times: builds in ms, queries (mean of " << path_settings.queries
            << ") and paths (mean of " << path_settings.paths << ") in microseconds; added memory in MB (2^20 bytes)\n"
            << "mesh,subdivisions,faces,vertices,sources";
  for(const char* quantity : {"build_vertices_ms", "build_faces_ms", "vertex_query_us", "face_query_us",
                              "vertex_path_us", "face_path_us", "memory_vertices_mb", "memory_faces_mb"})
  {
    std::cout << ",original_" << quantity << ",ours_" << quantity << ",ratio_" << quantity;
  }
  std::cout << ",points_per_vertex_path,points_per_face_path,largest_distance_difference,"
               "largest_path_length_difference"
            << std::endl;
}

// ---------------------------------------------------------------------------------------------------------------------

void print_usage(const char* program)
{
  std::cerr << "usage: " << program << " [options] mesh...\n"
            << "  --sources N,N,...     numbers of sources (1,10,50)\n"
            << "  --queries N           distance queries of each kind (20000)\n"
            << "  --paths N             paths of each kind, from the first locations of the queries (1000)\n"
            << "  --seed N              of the random locations (2026)\n";
  print_common_usage();
}

int main(int argc, char* argv[])
{
  Settings settings;
  Path_settings path_settings;
  if(!read_settings(argc, argv, settings, [&](const std::string& option, const std::string& value) {
       return path_settings.read_option(option, value);
     }))
  {
    print_usage(argv[0]);
    return EXIT_FAILURE;
  }
  path_settings.paths = (std::min)(path_settings.paths, path_settings.queries);
  if(settings.is_measuring())
  {
    try
    {
      return (settings.kernel == "epick")
                 ? measuring_process<CGAL::Exact_predicates_inexact_constructions_kernel>(settings, path_settings)
                 : measuring_process<CGAL::Simple_cartesian<double>>(settings, path_settings);
    }
    catch(const std::exception& error)
    {
      std::cerr << error.what() << std::endl;
      return method_failed;
    }
  }
  if(settings.print_header)
  {
    print_header(settings, path_settings);
  }
  bool good = true;
  for(const std::string& mesh : settings.meshes)
  {
    for(std::size_t number_of_sources : path_settings.numbers_of_sources)
    {
      good = compare_on(settings, path_settings, number_of_sources, mesh) && good;
    }
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
