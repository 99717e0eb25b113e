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

// A set of rules: the times of its runs, and the counts and distances of the last one.
struct Row
{
  std::string name;
  void (*run)(const Benchmark_mesh&, Benchmark_distance_map, Geodesics::Propagation_statistics&);
  std::vector<double> times, distances;
  Geodesics::Propagation_statistics statistics;
};

template <class Rules>
void run_with(const Benchmark_mesh& mesh, Benchmark_distance_map map, Geodesics::Propagation_statistics& statistics)
{
  Geodesics::internal::Distance_options<Benchmark_mesh> options;
  options.statistics = &statistics;
  const auto np = CGAL::parameters::default_values();
  Geodesics::Geodesic_default_visitor visitor;
  Geodesics::internal::compute_geodesic_distances<CGAL::Sequential_tag, Rules, double>(
    mesh, map, *mesh.vertices().begin(), options, Geodesics::internal::shape_from_points<double>(mesh, np), visitor,
    np);
}

// Runs all sets in turn, so that a change of the machine's speed does not favor one of them.
void run_in_turn(const Settings& settings, Benchmark_mesh& mesh, std::vector<Row>& rows)
{
  const Benchmark_distance_map map = mesh.add_property_map<Benchmark_vertex, double>("v:distance", 0).first;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    for(Row& row : rows)
    {
      row.statistics = Geodesics::Propagation_statistics();
      row.times.push_back(milliseconds_of(settings.clock_id(), [&]() { row.run(mesh, map, row.statistics); }));
      row.distances = values_of(map, mesh);
    }
  }
}

void print_row(const std::string& file, const Benchmark_mesh& mesh, const Row& row, const std::vector<double>& expected)
{
  const Spread run(row.times);
  const double windows = static_cast<double>(row.statistics.windows_propagated);
  std::cout << file_name(file) << ',' << mesh.number_of_faces() << ',' << row.name << ',' << run << ','
            << row.statistics.windows_propagated << ',' << row.statistics.windows_created << ','
            << cell(windows / static_cast<double>(mesh.number_of_faces()), 2) << ','
            << row.statistics.maximum_windows_alive << ',' << cell(1e6 * run.middle / windows, 2) << ','
            << largest_relative_difference(row.distances, expected) << std::endl;
}

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], " mesh...   (--subdivide K: midpoint subdivisions first)");
  }
  print_head(settings, "rules left out, processor times with reading the mesh, in turn",
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
    std::vector<Row> rows{{"all", run_with<All_rules>, {}, {}, {}},
                          {"without vertices", run_with<Without_vertex_rule>, {}, {}, {}},
                          {"without rules 2 and 3", run_with<Without_pair_rules>, {}, {}, {}},
                          {"without rule 1", run_with<Without_rule_1>, {}, {}, {}},
                          {"rule 1 only", run_with<Rule_1_only>, {}, {}, {}},
                          {"vertices only", run_with<Vertex_rule_only>, {}, {}, {}}};
    run_in_turn(settings, mesh, rows);
    for(const Row& row : rows)
    {
      print_row(file, mesh, row, rows.front().distances);
    }
  }
  return EXIT_SUCCESS;
}
