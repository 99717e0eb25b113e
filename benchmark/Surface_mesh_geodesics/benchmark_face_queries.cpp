// Three ways to answer queries at points inside faces, side by side. Prints one line of comma separated values per
// mesh, number of sources (random vertices) and alternative; lines that start with '#' describe the machine.
//
//   lazily:    Surface_mesh_geodesic_paths as it is: build_sequence_tree(), and the first query in a face repeats the
//              propagation and keeps the windows;
//   always:    the first propagation keeps the windows, even if no query in a face follows:
//              build_sequence_tree_for_faces();
//   backward:  no windows are kept; each query propagates from its point and reads the distances of the sources. The
//              distances of the corners of its face bound the propagation. The solver is reused, so the rest of the
//              mesh costs nothing.
//
// Every measurement runs in its own process (this program starts itself again), the ways alternate, and medians are
// printed. Times are processor times. Memory is the peak of the resident memory until all is built, and until the last
// query, minus the memory that was resident before the construction, with the mesh and the queries.

#include "benchmark_support.h"
#include "random_locations.h"
#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

using Traits = CGAL::Surface_mesh_shortest_path_traits<Benchmark_kernel, Benchmark_mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
using Solver = Geodesics::Geodesic_distance_solver<Benchmark_mesh>;
using Face_location = Paths::Face_location;

const std::array<std::string, 3> alternatives = {{"lazily", "always", "backward"}};

// The report of a measuring process; the answers are the distances. Times in ms.
struct Report
{
  std::uint64_t faces = 0;
  double build = 0, first_query = 0, query = 0;
  double built_mb = 0, end_mb = 0;

  // Builds, and answers n queries.
  double total(double n) const { return build + (n > 0 ? first_query + (n - 1) * query : 0.); }
};

struct Query_settings
{
  std::vector<std::size_t> numbers_of_sources = {1, 10, 50};
  std::size_t queries = 20000;
  std::size_t backward_queries = 50;
  std::size_t seed = 2026;

  bool read_option(const std::string& option, const std::string& value)
  {
    const std::size_t number = std::strtoul(value.c_str(), nullptr, 10);
    if(option == "--sources")
    {
      return read_numbers(value, numbers_of_sources);
    }
    if(option == "--queries" && number > 1)
    {
      queries = number;
    }
    else if(option == "--backward-queries" && number > 1)
    {
      backward_queries = number;
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
// The alternatives
// ---------------------------------------------------------------------------------------------------------------------

class Kept_windows
{
public:
  Kept_windows(const Benchmark_mesh& mesh, const std::vector<Benchmark_vertex>& sources, bool keeps_always)
    : m_paths(mesh)
  {
    m_paths.add_source_points(sources.begin(), sources.end());
    if(keeps_always)
    {
      m_paths.build_sequence_tree_for_faces();
    }
    else
    {
      m_paths.build_sequence_tree();
    }
  }

  double distance(const Face_location& q)
  {
    return m_paths.shortest_distance_to_source_points(q.first, q.second).first;
  }

private:
  Paths m_paths;
};

class Backward_runs
{
public:
  Backward_runs(const Benchmark_mesh& mesh, const std::vector<Benchmark_vertex>& sources)
    : m_mesh(mesh), m_sources(sources), m_solver(mesh), m_distances(mesh.num_vertices())
  {
    m_solver.compute_distances(sources);
    for(const Benchmark_vertex v : mesh.vertices())
    {
      m_distances[v] = m_solver.distance(v);
    }
  }

  double distance(const Face_location& q)
  {
    // Of several sources, some may be out of reach: then they are no targets.
    const std::vector<Benchmark_vertex> targets = m_sources.size() == 1 ? m_sources : std::vector<Benchmark_vertex>();
    const double radius = bound(q) * (1 + 1e-12); // more than rounding
    m_solver.compute_distances(q, CGAL::parameters::maximum_distance(radius).targets(targets));
    double nearest = std::numeric_limits<double>::infinity();
    for(const Benchmark_vertex v : m_sources)
    {
      nearest = (std::min)(nearest, m_solver.distance(v));
    }
    return nearest;
  }

private:
  // The length of the shortest path through a corner of the face.
  double bound(const Face_location& q) const
  {
    const Benchmark_kernel::Point_3 p = Paths::point(q.first, q.second, m_mesh);
    double result = std::numeric_limits<double>::infinity();
    for(const Benchmark_vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(q.first)))
    {
      result = (std::min)(result, m_distances[v] + std::sqrt(CGAL::squared_distance(p, m_mesh.point(v))));
    }
    return result;
  }

  const Benchmark_mesh& m_mesh;
  const std::vector<Benchmark_vertex>& m_sources;
  Solver m_solver;
  std::vector<double> m_distances;
};

// ---------------------------------------------------------------------------------------------------------------------
// The measuring process
// ---------------------------------------------------------------------------------------------------------------------

// `make()` returns a built alternative.
template <class Make>
[[noreturn]] void measure(const Settings& settings, const std::vector<Face_location>& queries, Report report,
                          const Make& make)
{
  const clockid_t clock = settings.clock_id();
  std::vector<double> answers(queries.size(), 0.);
  const std::uint64_t resident = start_of_memory_measurement();
  const double start = milliseconds_now(clock);
  auto alternative = make();
  report.build = milliseconds_now(clock) - start;
  report.built_mb = static_cast<double>(added_memory(resident)) / 1024;
  report.first_query = milliseconds_of(clock, [&]() { answers[0] = alternative.distance(queries[0]); });
  report.query = milliseconds_of(clock, [&]() {
    for(std::size_t i = 1; i < queries.size(); ++i)
    {
      answers[i] = alternative.distance(queries[i]);
    }
  });
  report.query /= static_cast<double>(queries.size() - 1);
  report.end_mb = static_cast<double>(added_memory(resident)) / 1024;
  send_and_exit(settings, report, answers);
}

int measuring_process(const Settings& settings, const Query_settings& query_settings)
{
  Benchmark_mesh mesh;
  if(const int code = read_wanted_mesh(settings, mesh))
  {
    return code;
  }
  Report report;
  report.faces = mesh.number_of_faces();
  const std::vector<Benchmark_mesh::Face_index> all_faces(mesh.faces().begin(), mesh.faces().end());
  const std::vector<Benchmark_vertex> all_vertices(mesh.vertices().begin(), mesh.vertices().end());
  Random_locations source_locations(query_settings.seed), query_locations(query_settings.seed + 1);
  std::vector<Benchmark_vertex> sources;
  for(std::size_t i = 0; i < query_settings.numbers_of_sources.front(); ++i)
  {
    sources.push_back(source_locations.element(all_vertices));
  }
  const bool is_backward = settings.method == alternatives[2];
  std::vector<Face_location> queries;
  for(std::size_t i = 0; i < (is_backward ? query_settings.backward_queries : query_settings.queries); ++i)
  {
    queries.push_back(query_locations.inner_location<Face_location>(all_faces));
  }
  if(is_backward)
  {
    measure(settings, queries, report, [&]() { return Backward_runs(mesh, sources); });
  }
  measure(settings, queries, report, [&]() { return Kept_windows(mesh, sources, settings.method == alternatives[1]); });
}

// ---------------------------------------------------------------------------------------------------------------------
// The process that compares
// ---------------------------------------------------------------------------------------------------------------------

// The medians of all quantities.
Report median_of(const std::vector<Report>& reports)
{
  Report result = reports.front();
  for(double Report::*quantity :
      {&Report::build, &Report::first_query, &Report::query, &Report::built_mb, &Report::end_mb})
  {
    std::vector<double> values;
    for(const Report& report : reports)
    {
      values.push_back(report.*quantity);
    }
    result.*quantity = median(values);
  }
  return result;
}

// The number of queries from which on keeping the windows takes less time in all than backward runs.
double break_even(const Report& kept, const Report& backward)
{
  const double n = std::ceil((kept.total(1) - backward.total(1)) / (backward.query - kept.query)) + 1;
  return (std::max)(n, 1.);
}

void print_row(const std::string& mesh, std::size_t number_of_sources, const std::string& alternative,
               const Report& report, double break_even_queries, double difference)
{
  std::cout << file_name(mesh) << ',' << report.faces << ',' << number_of_sources << ',' << alternative << ','
            << cell(report.build, 2) << ',' << cell(report.first_query, 3) << ',' << cell(1e3 * report.query, 3) << ','
            << cell(report.built_mb, 2) << ',' << cell(report.end_mb, 2);
  for(const double n : {1., 10., 100., 1000., 100000.})
  {
    std::cout << ',' << cell(report.total(n), 1);
  }
  std::cout << ',' << cell(break_even_queries, 0) << ',' << difference << std::endl;
}

// Returns false if a measurement failed unexpectedly.
bool compare_on(const Settings& settings, const Query_settings& query_settings, std::size_t number_of_sources,
                const std::string& mesh)
{
  const std::vector<std::string> own_options = {"--sources", std::to_string(number_of_sources),
                                                "--queries", std::to_string(query_settings.queries),
                                                "--backward-queries", std::to_string(query_settings.backward_queries),
                                                "--seed", std::to_string(query_settings.seed)};
  std::array<std::vector<Report>, 3> reports;
  std::array<std::vector<double>, 3> answers;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    for(std::size_t a = 0; a < alternatives.size(); ++a)
    {
      Report report;
      const int code = run_measurement(settings, mesh, alternatives[a], own_options, report, answers[a]);
      if(code != 0)
      {
        return is_skipped(code, mesh, alternatives[a]);
      }
      reports[a].push_back(report);
    }
  }
  const Report lazily = median_of(reports[0]);
  for(std::size_t a = 0; a < alternatives.size(); ++a)
  {
    const std::size_t common = (std::min)(answers[0].size(), answers[a].size());
    answers[0].resize(common); // the last alternative answers the fewest queries
    answers[a].resize(common);
    const Report report = median_of(reports[a]);
    const bool is_backward = a == 2;
    print_row(mesh, number_of_sources, alternatives[a], report,
              is_backward ? break_even(lazily, report) : std::numeric_limits<double>::quiet_NaN(),
              largest_relative_difference(answers[a], answers[0]));
  }
  return true;
}

void print_header(const Settings& settings, const Query_settings& query_settings)
{
  print_machine(settings);
  std::cout << "# sources: random vertices, seed " << query_settings.seed
            << "; queries: random points strictly inside faces, " << query_settings.queries << " of them, "
            << query_settings.backward_queries
            << " of the same for \"backward\"; medians of " << settings.repetitions
            << " runs of each kind in turn, each in its own process\n"
            << "# " << settings.clock
            << " times, in ms but for query_us; total_N_ms: build and N queries; memory in MB (2^20 bytes) above that "
               "of the mesh\n"
            << "# break_even_queries: from this number on \"lazily\" takes less time in all than \"backward\"\n"
            << "mesh,faces,sources,alternative,build_ms,first_query_ms,query_us,memory_built_mb,memory_end_mb,"
               "total_1_ms,total_10_ms,total_100_ms,total_1000_ms,total_100000_ms,break_even_queries,"
               "largest_relative_difference"
            << std::endl;
}

int main(int argc, char* argv[])
{
  Settings settings;
  Query_settings query_settings;
  if(!read_settings(argc, argv, settings, [&](const std::string& option, const std::string& value) {
       return query_settings.read_option(option, value);
     }))
  {
    std::cerr << "usage: " << argv[0] << " [options] mesh...\n"
              << "  --sources N,N,...     numbers of sources (1,10,50)\n"
              << "  --queries N           queries where windows are kept (20000)\n"
              << "  --backward-queries N  queries where each is a propagation (50)\n"
              << "  --seed N              of the random locations (2026)\n";
    print_common_usage();
    return EXIT_FAILURE;
  }
  if(settings.is_measuring())
  {
    try
    {
      return measuring_process(settings, query_settings);
    }
    catch(const std::exception& error)
    {
      std::cerr << error.what() << std::endl;
      return method_failed;
    }
  }
  if(settings.print_header)
  {
    print_header(settings, query_settings);
  }
  bool good = true;
  for(const std::string& mesh : settings.meshes)
  {
    for(const std::size_t number_of_sources : query_settings.numbers_of_sources)
    {
      good = compare_on(settings, query_settings, number_of_sources, mesh) && good;
    }
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
