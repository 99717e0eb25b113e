// Measures the geodesic Voronoi diagram of 1, 10, 30, 100 and 1000 random vertices: time, memory and the number of
// windows kept, with and without redundant window removal, next to the distances from the same sites alone. Optionally
// measures the naive method: one CGAL::Surface_mesh_shortest_path for each site, and the nearest site of each vertex.
// Prints one line of comma separated values per mesh and number of sites.
//
// Every measurement runs in its own process (this program starts itself again). The kinds of measurements:
//   distances:  one propagation from all sites, no windows kept;
//   all kept:   the same, keeping each window that is propagated (window-VTP without removal); no arcs;
//   removal:    the same, removing redundant windows; faces in several cells are dropped, so there are no arcs;
//   diagram:    Surface_mesh_geodesic_Voronoi_diagram::build(): removal, and all arcs, vertices and edges;
//   naive:      one Surface_mesh_shortest_path per site, with queries at all vertices (--naive N: up to N sites).
// They alternate, and ratios are medians of the ratios of adjacent runs. The time of each kind includes reading the
// user's mesh into the intrinsic mesh. The time is the processor time of the process. Memory is the peak of the
// resident memory from the start of the construction to the end, minus the memory that was resident before.

#include "benchmark_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;

namespace internal = CGAL::Surface_mesh_geodesics::internal;

using Solver = internal::Path_solver<Mesh, Diagram::Vertex_index_map, Diagram::Face_index_map>;

struct Report
{
  std::uint64_t faces = 0;
  double time = 0; // ms
  double added_mb = 0;
  std::uint64_t kept = 0;    // the number of windows that were kept
  std::uint64_t at_once = 0; // the largest number of kept windows at one time
  std::uint64_t waiting = 0; // the largest number of windows on the wavefront at one time
  std::uint64_t arcs = 0, vertices = 0;
};

struct Voronoi_settings
{
  std::vector<std::size_t> numbers_of_sites = {1, 10, 30, 100, 1000};
  std::size_t naive = 0;
  std::size_t seed = 2026;

  bool read_option(const std::string& option, const std::string& value)
  {
    if(option == "--sites")
    {
      numbers_of_sites.clear();
      std::istringstream list(value);
      for(std::string item; std::getline(list, item, ',');)
      {
        numbers_of_sites.push_back(std::strtoul(item.c_str(), nullptr, 10));
      }
      return !numbers_of_sites.empty()
             && std::count(numbers_of_sites.begin(), numbers_of_sites.end(), std::size_t(0)) == 0;
    }
    std::size_t* const target = option == "--naive" ? &naive : option == "--seed" ? &seed : nullptr;
    if(target == nullptr)
    {
      return false;
    }
    *target = std::strtoul(value.c_str(), nullptr, 10);
    return true;
  }
};

std::vector<Mesh::Vertex_index> random_sites(const Mesh& mesh, std::size_t n, std::size_t seed)
{
  std::mt19937_64 generator(seed);
  std::vector<Mesh::Vertex_index> sites;
  for(std::size_t i = 0; i < n; ++i)
  {
    sites.push_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(generator() % mesh.number_of_vertices())));
  }
  return sites;
}

// ---------------------------------------------------------------------------------------------------------------------
// The measuring process
// ---------------------------------------------------------------------------------------------------------------------

// Receives the faces in several cells, and ignores them.
struct No_consumer
{
  void add(const internal::Divided_face<double>&) {}
};

// The propagation of a diagram, without arcs.
void propagate(const Mesh& mesh, const std::vector<Mesh::Vertex_index>& sites, const std::string& method,
               Report& report)
{
  using Removal = internal::Redundant_window_removal<double, No_consumer>;
  using Shape = internal::Shape_from_points<double, Mesh, Diagram::Vertex_point_map>;
  const auto go_on = [](std::size_t, double) { return true; };
  Solver solver(mesh, get(boost::vertex_index, mesh), get(boost::face_index, mesh));
  solver.build_mesh(Shape(mesh, get(CGAL::vertex_point, mesh)));
  solver.begin_sources();
  for(Mesh::Vertex_index v : sites)
  {
    solver.add_source(v);
  }
  if(method == "distances")
  {
    solver.run(false, go_on);
  }
  else
  {
    No_consumer consumer;
    Removal removal;
    solver.run_with_keeper(
        [&] {
          removal.reset(solver.mesh(), solver.field(), consumer, method == "removal");
          return internal::Diagram_window_keeper<Removal>(removal);
        },
        go_on);
    if(method == "removal")
    {
      removal.finish();
    }
    report.kept = removal.number_of_kept_windows();
    report.at_once = removal.windows().maximum_size();
  }
  report.waiting = solver.statistics().maximum_windows_alive;
}

void compute_diagram(const Mesh& mesh, const std::vector<Mesh::Vertex_index>& sites, Report& report)
{
  Diagram diagram(mesh);
  diagram.add_sites(sites);
  diagram.build();
  report.at_once = diagram.number_of_kept_windows().first;
  report.kept = diagram.number_of_kept_windows().second;
  report.waiting = diagram.statistics().maximum_windows_alive;
  report.arcs = diagram.arcs().size();
  report.vertices = diagram.vertices().size();
}

// Returns the nearest site of each vertex.
std::vector<double> label_naively(const Mesh& mesh, const std::vector<Mesh::Vertex_index>& sites)
{
  using Original = CGAL::Surface_mesh_shortest_path<Traits>;
  std::vector<double> nearest(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  std::vector<double> label(mesh.number_of_vertices(), -1);
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    Original original(mesh);
    original.add_source_point(sites[i]);
    for(Mesh::Vertex_index v : mesh.vertices())
    {
      const double d = original.shortest_distance_to_source_points(v).first;
      if(d >= 0 && d < nearest[v])
      {
        nearest[v] = d;
        label[v] = static_cast<double>(i);
      }
    }
  }
  return label;
}

int measuring_process(const Settings& settings, const Voronoi_settings& voronoi_settings)
{
  Mesh mesh;
  if(const int code = read_wanted_mesh(settings, mesh))
  {
    return code;
  }
  const std::vector<Mesh::Vertex_index> sites =
      random_sites(mesh, voronoi_settings.numbers_of_sites.front(), voronoi_settings.seed);
  Report report;
  report.faces = mesh.number_of_faces();
  const std::uint64_t resident = start_of_memory_measurement();
  const double start = milliseconds_now(settings.clock_id());
  if(settings.method == "naive")
  {
    label_naively(mesh, sites);
  }
  else if(settings.method == "diagram")
  {
    compute_diagram(mesh, sites, report);
  }
  else
  {
    propagate(mesh, sites, settings.method, report);
  }
  report.time = milliseconds_now(settings.clock_id()) - start;
  report.added_mb = static_cast<double>(added_memory(resident)) / 1024;
  send_and_exit(settings, report, {});
}

// ---------------------------------------------------------------------------------------------------------------------
// The process that compares
// ---------------------------------------------------------------------------------------------------------------------

struct Series
{
  std::string method;
  bool is_wanted;
  std::vector<Report> reports;

  std::vector<double> values(double Report::*quantity) const
  {
    std::vector<double> result;
    for(const Report& report : reports)
    {
      result.push_back(report.*quantity);
    }
    return result;
  }

  double time() const { return median(values(&Report::time)); }
  double memory() const { return median(values(&Report::added_mb)); }
  Report last() const { return reports.empty() ? Report() : reports.back(); }
};

double ratio_of_times(const Series& a, const Series& b)
{
  return median_ratio(a.values(&Report::time), b.values(&Report::time));
}

double ratio(std::uint64_t a, std::uint64_t b)
{
  return b == 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(a) / static_cast<double>(b);
}

void print_row(const Settings& settings, std::size_t sites, const std::string& mesh, const std::vector<Series>& all)
{
  const Series &distances = all[0], &kept = all[1], &removal = all[2], &diagram = all[3], &naive = all[4];
  std::cout << file_name(mesh) << ',' << settings.subdivisions << ',' << diagram.last().faces << ',' << sites << ','
            << cell(distances.time(), 2) << ',' << cell(kept.time(), 2) << ',' << cell(removal.time(), 2) << ','
            << cell(diagram.time(), 2) << ',' << cell(ratio_of_times(diagram, distances), 2) << ','
            << cell((diagram.time() - removal.time()) / removal.time(), 3) << ',' << kept.last().kept << ','
            << removal.last().at_once << ',' << cell(ratio(kept.last().at_once, removal.last().at_once), 1) << ','
            << cell(kept.memory(), 2) << ',' << cell(removal.memory(), 2) << ',' << cell(diagram.memory(), 2) << ','
            << cell(kept.memory() / removal.memory(), 1) << ',' << diagram.last().arcs << ',' << diagram.last().vertices
            << ',' << cell(naive.time(), 1) << ',' << cell(ratio_of_times(naive, diagram), 1) << ','
            << cell(median_ratio(naive.values(&Report::added_mb), diagram.values(&Report::added_mb)), 1) << std::endl;
}

bool compare_on(const Settings& settings, const Voronoi_settings& voronoi_settings, std::size_t sites,
                const std::string& mesh)
{
  std::vector<Series> all = {{"distances", true, {}},
                             {"all kept", true, {}},
                             {"removal", true, {}},
                             {"diagram", true, {}},
                             {"naive", sites <= voronoi_settings.naive, {}}};
  const std::vector<std::string> own_options = {"--sites", std::to_string(sites), "--seed",
                                                std::to_string(voronoi_settings.seed)};
  bool good = true;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    for(Series& series : all)
    {
      if(!series.is_wanted || (series.method == "naive" && i > 0))
      {
        continue;
      }
      Report report;
      std::vector<double> answers;
      const int code = run_measurement(settings, mesh, series.method, own_options, report, answers);
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
  print_row(settings, sites, mesh, all);
  return good;
}

int main(int argc, char* argv[])
{
  Settings settings;
  Voronoi_settings voronoi_settings;
  const auto read_option = [&](const std::string& option, const std::string& value)
  { return voronoi_settings.read_option(option, value); };
  if(!read_settings(argc, argv, settings, read_option))
  {
    std::cerr << "usage: benchmark_Voronoi_diagram [options] MESH...\n"
              << "  --sites LIST          numbers of sites (1,10,30,100,1000)\n"
              << "  --naive N             measure the naive way as well for up to N sites (0)\n"
              << "  --seed N              of the random sites (2026)\n";
    print_common_usage();
    return EXIT_FAILURE;
  }
  if(settings.is_measuring())
  {
    try
    {
      return measuring_process(settings, voronoi_settings);
    }
    catch(const std::exception& e)
    {
      std::cerr << e.what() << std::endl;
      return method_failed;
    }
  }
  if(settings.print_header)
  {
    print_machine(settings);
    std::cout << "# " << settings.repetitions << " runs of each method (the naive one once), medians; random sites\n"
              << "mesh,subdivisions,faces,sites,distances_ms,all_kept_ms,removal_ms,diagram_ms,diagram_over_distances,"
                 "arcs_over_removal,windows_kept,windows_at_once,ratio_of_windows,all_kept_mb,removal_mb,diagram_mb,"
                 "ratio_of_memory,arcs,vertices,naive_ms,naive_over_diagram,naive_memory_over_diagram"
              << std::endl;
  }
  bool good = true;
  for(const std::string& mesh : settings.meshes)
  {
    for(std::size_t sites : voronoi_settings.numbers_of_sites)
    {
      good = compare_on(settings, voronoi_settings, sites, mesh) && good;
    }
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
