// What it would give to remove flat vertices, whose angles add up to 2 pi, or pi on the border, before distances are
// computed, and to measure them as points of larger faces. The package does not do that; the headers
// coarse_propagation.h, flat_vertex_removal.h, flat_star.h and straight_line_removal.h have the experiments.
//
// Distances of all vertices from vertex 0, as geodesic_distances() computes them, and with the flat vertices removed,
// in turn: removed one by one ("coarse") and, for subdivided meshes only, along straight lines ("lines"). Prints one
// line of comma separated values per mesh. If fewer vertices than a tenth are flat, only their share is printed.
//
// All times contain the reading of the mesh. `least_ms` is the time that remains if the removal one by one takes none.

#include "benchmark_surface.h"
#include "coarse_propagation.h"
#include "runs_in_process.h"
#include "straight_line_removal.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Repeated_propagation.h>

namespace internal = CGAL::Surface_mesh_geodesics::internal;

using Rules = internal::All_pruning_rules;

const double least_share = 0.1;

struct Result
{
  double total = 0, removal = 0; // milliseconds
  std::size_t windows = 0, coarse_faces = 0;
  std::vector<double> distances;
};

template <class Propagation>
void read_distances(const Benchmark_mesh& mesh, const Benchmark_surface& surface, const Propagation& propagation,
                    Result& result)
{
  result.windows = propagation.statistics().windows_propagated;
  result.distances.reserve(mesh.number_of_vertices());
  for(const Benchmark_vertex v : mesh.vertices())
  {
    result.distances.push_back(propagation.distance(surface.id(v)) * surface.unit());
  }
}

const auto go_on = [](std::size_t, double) { return true; };

Result run_plainly(const Settings& settings, const Benchmark_mesh& mesh)
{
  Result result;
  result.total = milliseconds_of(settings.clock_id(), [&]() {
    Benchmark_surface surface = surface_of(mesh);
    internal::Source_insertion<double> insertion(surface.mesh());
    internal::Repeated_propagation<internal::Distance_propagation<double, Rules>> run(surface.mesh(), insertion);
    internal::Source_set<double> sources;
    sources.vertices.push_back(surface.id(*mesh.vertices().begin()));
    run.run(sources, internal::Run_limits<double>(), go_on);
    read_distances(mesh, surface, run, result);
  });
  return result;
}

// `remove(mesh, kept vertices, fine vertices)` removes flat vertices; if it returns false, the result has no distances.
template <class Removal>
Result run_on_coarse_mesh(const Settings& settings, const Benchmark_mesh& mesh, const Removal& remove)
{
  Result result;
  result.total = milliseconds_of(settings.clock_id(), [&]() {
    Benchmark_surface surface = surface_of(mesh);
    internal::Source_set<double> sources;
    sources.vertices.push_back(surface.id(*mesh.vertices().begin()));
    const double start = milliseconds_now(settings.clock_id());
    Flat_vertices::Fine_vertices<double> fine;
    if(!remove(surface.mesh(), sources.vertices, fine))
    {
      return;
    }
    result.removal = milliseconds_now(settings.clock_id()) - start;
    Flat_vertices::Coarse_propagation<double, Rules> run(surface.mesh(), std::move(fine), sources);
    result.coarse_faces = surface.mesh().number_of_faces();
    run.run(go_on);
    read_distances(mesh, surface, run, result);
  });
  return result;
}

bool remove_one_by_one(internal::Intrinsic_mesh<double>& mesh, const std::vector<internal::Vertex_id>& kept,
                       Flat_vertices::Fine_vertices<double>& fine)
{
  fine = Flat_vertices::Flat_vertex_compaction<double>::run(mesh, kept);
  return true;
}

// Prints the cells of the removal along lines; empty ones if the lines do not divide the mesh into triangles.
void print_lines(const std::vector<double>& times, const std::vector<double>& ratios, const Result& lines,
                 const Result& plain)
{
  if(lines.distances.empty())
  {
    std::cout << ",,,,";
    return;
  }
  std::cout << Spread(times) << ',' << cell(median(ratios), 3) << ','
            << largest_relative_difference(lines.distances, plain.distances);
}

void print_runs(const Settings& settings, const Benchmark_mesh& mesh)
{
  std::vector<double> plain_times, coarse_times, least_times, ratios, largest_ratios, lines_times, lines_ratios;
  Result plain, coarse, lines;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    plain = run_plainly(settings, mesh);
    coarse = run_on_coarse_mesh(settings, mesh, remove_one_by_one);
    lines = run_on_coarse_mesh(settings, mesh, Flat_vertices::Straight_line_removal<double>::run);
    plain_times.push_back(plain.total);
    coarse_times.push_back(coarse.total);
    least_times.push_back(coarse.total - coarse.removal);
    ratios.push_back(plain.total / coarse.total);
    largest_ratios.push_back(plain.total / least_times.back());
    lines_times.push_back(lines.total);
    lines_ratios.push_back(plain.total / lines.total);
  }
  std::cout << coarse.coarse_faces << ',' << Spread(plain_times) << ',' << Spread(coarse_times) << ','
            << cell(median(least_times), 3) << ',' << cell(median(ratios), 3) << ',' << cell(median(largest_ratios), 3)
            << ',' << plain.windows << ',' << coarse.windows << ','
            << largest_relative_difference(coarse.distances, plain.distances) << ',';
  print_lines(lines_times, lines_ratios, lines, plain);
}

void print_row(const Settings& settings, const std::string& file, const Benchmark_mesh& mesh)
{
  const std::size_t flat = Flat_vertices::number_of_flat_vertices(surface_of(mesh).mesh());
  const double share = static_cast<double>(flat) / static_cast<double>(mesh.number_of_vertices());
  std::cout << file_name(file) << ',' << settings.subdivisions << ',' << mesh.number_of_faces() << ','
            << mesh.number_of_vertices() << ',' << cell(100 * share, 1) << ',';
  if(share < least_share)
  {
    std::cout << std::string(17, ',');
  }
  else
  {
    print_runs(settings, mesh);
  }
  std::cout << std::endl;
}

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], " mesh...   (--subdivide K: midpoint subdivisions first; --minimum-faces N; --list FILE)");
  }
  print_head(settings, "flat vertices removed, processor times with reading the mesh",
             "mesh,subdivisions,faces,vertices,flat_percent,coarse_faces," + spread_columns("run_ms") + ','
               + spread_columns("coarse_ms")
               + ",least_ms,time_ratio,largest_time_ratio,windows,coarse_windows,largest_relative_difference,"
               + spread_columns("lines_ms") + ",lines_ratio,lines_difference");
  for(const std::string& file : settings.meshes)
  {
    Benchmark_mesh mesh;
    if(read_mesh(file, settings.subdivisions, mesh) && mesh.number_of_faces() >= settings.minimum_faces)
    {
      print_row(settings, file, mesh);
    }
  }
  return EXIT_SUCCESS;
}
