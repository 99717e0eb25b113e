// What wider instruction sets gain for a program that is compiled without flags for them: distances of all vertices
// from vertex 0 with one lane, with the two lanes that every processor has, with four lanes at most (AVX2), and with
// what the processor has (AVX-512). Prints one line of comma separated values per mesh and set. The sets run in turn,
// so that what slows the machine down for a while slows all of them down; ratios are medians of the ratios of adjacent
// runs. Times are those of the propagation alone, without reading the mesh. The program fails if a distance of any set
// has other bits than those of one lane.
//
// --set NAME runs one set only, to count its instructions: perf stat -e instructions, or valgrind --tool=callgrind.

#include "benchmark_surface.h"
#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>

namespace {

namespace geodesics = CGAL::Surface_mesh_geodesics::internal;
using geodesics::Lane_choice;
using Propagation = geodesics::Distance_propagation<double, geodesics::All_pruning_rules>;

struct Instruction_set
{
  const char* name;
  Lane_choice choice;
};

const Instruction_set instruction_sets[] = {{"one number at a time", Lane_choice::ONE},
                                            {"two lanes", Lane_choice::TWO},
                                            {"at most four lanes", Lane_choice::FOUR},
                                            {"all lanes of the processor", Lane_choice::BEST}};

std::vector<double> distances(const Benchmark_surface& surface, geodesics::Vertex_id source, Lane_choice choice)
{
  geodesics::Vertex_distance_field<double> field;
  Propagation propagation(surface.mesh(), field, geodesics::No_window_keeper(), choice);
  propagation.add_source(source, 0.);
  propagation.run([](std::size_t, double) { return true; });
  return field.distance;
}

// Prints the rows of a mesh; false if the sets disagree.
bool measure(const Settings& settings, const std::string& file, const Benchmark_mesh& mesh, const std::string& only)
{
  const Benchmark_surface surface = surface_of(mesh);
  const geodesics::Vertex_id source = surface.id(*mesh.vertices().begin());
  const std::size_t n = sizeof instruction_sets / sizeof instruction_sets[0];
  std::vector<std::vector<double>> times(n), results(n);
  for(std::size_t repetition = 0; repetition < settings.repetitions; ++repetition)
  {
    for(std::size_t i = 0; i < n; ++i)
    {
      if(only.empty() || only == instruction_sets[i].name)
      {
        times[i].push_back(milliseconds_of(settings.clock_id(), [&]()
                                           { results[i] = distances(surface, source, instruction_sets[i].choice); }));
      }
    }
  }
  bool are_same = true;
  for(std::size_t i = 0; i < n && only.empty(); ++i)
  {
    are_same = are_same && results[i] == results[0];
    std::cout << file_name(file) << ',' << settings.subdivisions << ',' << mesh.number_of_faces() << ','
              << instruction_sets[i].name << ',' << number_of_lanes(instruction_sets[i].choice) << ','
              << Spread(times[i]) << ',' << cell(median_ratio(times[0], times[i]), 3) << ','
              << cell(median_ratio(times[1], times[i]), 3) << std::endl;
  }
  return are_same;
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  std::string only;
  const auto read_option = [&](const std::string& option, const std::string& value)
  {
    only = option == "--set" ? value : only;
    return option == "--set";
  };
  if(!read_settings(argc, argv, settings, read_option))
  {
    return usage(argv[0], " mesh...   (--subdivide K: midpoint subdivisions first; --set NAME: one set, no output)");
  }
  print_head(settings, "lanes chosen at run time, times of the propagation",
             "mesh,subdivisions,faces,instruction_set,lanes," + spread_columns("run_ms")
               + ",one_lane_over_this,two_lanes_over_this");
  bool are_same = true;
  for(const std::string& file : settings.meshes)
  {
    Benchmark_mesh mesh;
    if(!read_mesh(file, settings.subdivisions, mesh))
    {
      return EXIT_FAILURE;
    }
    are_same = measure(settings, file, mesh, only) && are_same;
  }
  if(!are_same)
  {
    std::cerr << "the distances depend on the number of lanes" << std::endl;
  }
  return are_same ? EXIT_SUCCESS : EXIT_FAILURE;
}
