// What each pruning rule saves, as in figures 4.12 and 4.15 of the thesis: distances of all vertices from vertex 0 with
// all rules, and without some of them. Prints one line of comma separated values per mesh and set of rules: windows and
// processor times. Each set has at least one rule: without any, the number of windows can grow exponentially (thesis,
// 2.1.1.1).

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <limits>

namespace Geodesics = CGAL::Surface_mesh_geodesics;
using All_rules = Geodesics::internal::All_pruning_rules;
using No_rules = Geodesics::internal::No_pruning_rules;

struct Without_rule_1 : All_rules
{
  static constexpr bool rule_1 = false;
};

struct Without_pair_rules : All_rules
{
  static constexpr bool pair_rules = false;
};

struct Without_vertex_rule : All_rules
{
  static constexpr bool vertex_rule = false;
};

struct Rule_1_only : No_rules
{
  static constexpr bool rule_1 = true;
};

struct Vertex_rule_only : No_rules
{
  static constexpr bool vertex_rule = true;
};

// Prints a row. The distances with the first set of rules are those expected.
template <class Rules>
void print_row(const Settings& settings, const std::string& file, Benchmark_mesh& mesh, const std::string& name,
               std::vector<double>& expected)
{
  auto map = mesh.add_property_map<Benchmark_vertex, double>("v:distance", 0).first;
  Geodesics::Propagation_statistics statistics;
  const Spread run = repeated(settings, settings.clock_id(), [&]() {
    statistics = Geodesics::Propagation_statistics();
    Geodesics::internal::Distance_options<Benchmark_mesh> options;
    options.statistics = &statistics;
    const auto np = CGAL::parameters::default_values();
    Geodesics::Geodesic_default_visitor visitor;
    Geodesics::internal::compute_geodesic_distances<CGAL::Sequential_tag, Rules, double>(
      mesh, map, *mesh.vertices().begin(), options, Geodesics::internal::shape_from_points<double>(mesh, np), visitor,
      np);
  });
  std::vector<double> distances;
  for(const Benchmark_vertex v : mesh.vertices())
  {
    distances.push_back(get(map, v));
  }
  if(expected.empty())
  {
    expected = distances;
  }
  const double windows = static_cast<double>(statistics.windows_propagated);
  std::cout << file_name(file) << ',' << mesh.number_of_faces() << ',' << name << ',' << run << ','
            << statistics.windows_propagated << ',' << statistics.windows_created << ','
            << cell(windows / static_cast<double>(mesh.number_of_faces()), 2) << ','
            << statistics.maximum_windows_alive << ',' << cell(1e6 * run.middle / windows, 2) << ','
            << largest_relative_difference(distances, expected) << std::endl;
}

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], " mesh...   (--subdivide K: midpoint subdivisions first)");
  }
  print_head(settings, "rules left out, processor times with reading the mesh",
             "mesh,faces,rules," + spread_columns("run_ms")
               + ",windows_propagated,windows_created,windows_per_face,windows_alive,ns_per_window,"
                 "largest_relative_difference");
  for(const std::string& file : settings.meshes)
  {
    Benchmark_mesh mesh;
    if(!read_mesh(file, settings.subdivisions, mesh))
    {
      return EXIT_FAILURE;
    }
    std::vector<double> expected;
    print_row<All_rules>(settings, file, mesh, "all", expected);
    print_row<Without_vertex_rule>(settings, file, mesh, "without vertices", expected);
    print_row<Without_pair_rules>(settings, file, mesh, "without rules 2 and 3", expected);
    print_row<Without_rule_1>(settings, file, mesh, "without rule 1", expected);
    print_row<Rule_1_only>(settings, file, mesh, "rule 1 only", expected);
    print_row<Vertex_rule_only>(settings, file, mesh, "vertices only", expected);
  }
  return EXIT_SUCCESS;
}
