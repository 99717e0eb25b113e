// What a diagram costs beside the distances, and what costs as much as some diagrams: labels, a diagram by two threads,
// ten iterations of the relaxation, a certificate. Prints one line of comma separated values per mesh and number of
// sites. Times are elapsed times of the whole calls, with reading the mesh: the machine must be idle. The calls of one
// row alternate, and ratios are medians of the ratios of adjacent calls. The sites are random vertices. The certificate
// is left out with more than 100 sites. Without TBB (CGAL_LINKED_WITH_TBB), the columns of two threads are empty.

#include "runs_in_process.h"
#include "thread_counts.h"

#include <CGAL/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>

#include <array>
#include <iterator>
#include <limits>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

namespace {

using Traits = CGAL::Surface_mesh_shortest_path_traits<Benchmark_kernel, Benchmark_mesh>;
using CGAL::Default;
template <typename Tag>
using Tagged_diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits, Default, Default, Default, Default, Tag>;
using Diagram = Tagged_diagram<CGAL::Sequential_tag>;

constexpr std::size_t iterations = 10;
constexpr std::size_t most_certified_sites = 100; // the certificate takes seconds

enum Call { DISTANCES, LABELS, DIAGRAM, TWO_THREADS, RELAXATION, CERTIFICATE, number_of_calls };

class Calls
{
public:
  Calls(Benchmark_mesh& mesh, std::size_t number_of_sites)
    : m_mesh(mesh), m_sites(random_vertices(mesh, number_of_sites)),
      m_distances(mesh.add_property_map<Benchmark_vertex, double>("v:distance", 0.).first),
      m_labels(mesh.add_property_map<Benchmark_vertex, std::size_t>("v:label", 0).first)
  {}

  // Returns the elapsed time in milliseconds, NaN if the call cannot be made.
  double time(Call call)
  {
    switch(call)
    {
    case DISTANCES:
      return measured([&] { Geodesics::geodesic_distances(m_mesh, m_distances, m_sites); });
    case LABELS:
      return measured([&] { Geodesics::geodesic_Voronoi_labels(m_mesh, m_labels, m_sites); });
    case DIAGRAM:
      return measured([&] { build<CGAL::Sequential_tag>(); });
    case TWO_THREADS:
      return time_of_two_threads();
    case RELAXATION:
      return measured([&] {
        std::vector<Benchmark_vertex> moved;
        Geodesics::geodesic_Lloyd_relaxation(m_mesh, m_sites, std::back_inserter(moved),
                                             CGAL::parameters::number_of_iterations(iterations));
      });
    default:
      return time_of_certificate();
    }
  }

private:
  template <typename Function>
  static double measured(const Function& function)
  {
    return milliseconds_of(CLOCK_MONOTONIC, function);
  }

  template <typename Tag>
  void build() const
  {
    Tagged_diagram<Tag> diagram(m_mesh);
    diagram.add_sites(m_sites);
    diagram.build();
  }

  double time_of_two_threads() const
  {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::task_arena arena(2);
    return measured([&] { arena.execute([&] { build<Parallel>(); }); });
#else
    return std::numeric_limits<double>::quiet_NaN();
#endif
  }

  double time_of_certificate() const
  {
    Diagram diagram(m_mesh);
    diagram.add_sites(m_sites);
    diagram.build();
    return measured([&] { Geodesics::certify_geodesic_Voronoi_diagram(diagram); });
  }

  Benchmark_mesh& m_mesh;
  std::vector<Benchmark_vertex> m_sites;
  Benchmark_mesh::Property_map<Benchmark_vertex, double> m_distances;
  Benchmark_mesh::Property_map<Benchmark_vertex, std::size_t> m_labels;
};

void print_row(const Settings& settings, const std::string& file, Benchmark_mesh& mesh, std::size_t sites)
{
  Calls calls(mesh, sites);
  std::array<std::vector<double>, number_of_calls> times;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    for(std::size_t c = 0; c < number_of_calls; ++c)
    {
      const bool is_left_out = c == CERTIFICATE && sites > most_certified_sites;
      times[c].push_back(is_left_out ? std::numeric_limits<double>::quiet_NaN() : calls.time(static_cast<Call>(c)));
    }
  }
  const auto ratio = [&](Call a, Call b) { return cell(median_ratio(times[a], times[b]), 2); };
  std::cout << file_name(file) << ',' << settings.subdivisions << ',' << mesh.number_of_faces() << ',' << sites;
  for(const std::vector<double>& t : times)
  {
    std::cout << ',' << cell(median(t), 1);
  }
  std::cout << ',' << ratio(LABELS, DISTANCES) << ',' << ratio(DIAGRAM, DISTANCES) << ','
            << ratio(DIAGRAM, TWO_THREADS) << ',' << ratio(RELAXATION, DIAGRAM) << ',' << ratio(CERTIFICATE, DIAGRAM)
            << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  std::vector<std::size_t> numbers_of_sites{30, 1000, 2000};
  const auto read_option = [&](const std::string& option, const std::string& value) {
    if(option != "--sites")
    {
      return false;
    }
    numbers_of_sites = {std::strtoul(value.c_str(), nullptr, 10)};
    return numbers_of_sites.front() > 0;
  };
  if(!read_settings(argc, argv, settings, read_option))
  {
    return usage(argv[0], " mesh...   (--sites N: 30, 1000 and 2000 if not given; --subdivide K)");
  }
  print_head(settings, "diagrams and what uses them, elapsed times of whole calls",
             "mesh,subdivisions,faces,sites,distances_ms,labels_ms,diagram_ms,two_threads_ms,relaxation_ms,"
             "certificate_ms,labels_over_distances,diagram_over_distances,speedup,relaxation_over_diagram,"
             "certificate_over_diagram");
  for(const std::string& file : settings.meshes)
  {
    Benchmark_mesh mesh;
    if(!read_mesh(file, settings.subdivisions, mesh))
    {
      return EXIT_FAILURE;
    }
    for(const std::size_t sites : numbers_of_sites)
    {
      print_row(settings, file, mesh, sites);
    }
  }
  return EXIT_SUCCESS;
}
