// A matrix of distances: from each of some random vertices to all of them, row by row, with 1, 2, ... threads. Prints
// one line of comma separated values per mesh, kind of matrix and number of threads. Times are elapsed times: the
// machine must be idle. Runs with different numbers of threads alternate, and the speedup is the median of the ratios
// of adjacent runs. Without TBB (CGAL_LINKED_WITH_TBB), only sequential runs are measured.

#include "runs_in_process.h"
#include "thread_counts.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

int main(int argc, char* argv[])
{
  Settings settings;
  std::size_t rows = 256; // so many that the last one, which one thread computes alone, weighs little
  if(!read_settings(argc, argv, settings, [&](const std::string& option, const std::string& value) {
       return read_number_option(option, value, "--rows", rows);
     }))
  {
    return usage(argv[0], " mesh...   (--rows N: sources, default 256)");
  }
  print_head(settings, "matrices of distances between " + std::to_string(rows) + " random vertices, clock times",
             "mesh,faces,matrix,rows,threads," + spread_columns("run_ms") + ",ms_per_row,speedup");
  for(const std::string& file : settings.meshes)
  {
    Benchmark_mesh mesh;
    if(!read_mesh(file, settings.subdivisions, mesh))
    {
      return EXIT_FAILURE;
    }
    const std::vector<Benchmark_vertex> sources = random_vertices(mesh, rows);
    const Geodesics::Geodesic_distance_solver<Benchmark_mesh> solver(mesh);
    double sum = 0;
    const auto add_row = [&](std::size_t, const std::vector<double>& row) { sum += row.back(); };
    for(const bool is_symmetric : {false, true})
    {
      const Scaling scaling(settings, [&](std::size_t threads) {
        if(threads == 0 && is_symmetric)
          Geodesics::symmetric_geodesic_distance_matrix(solver, sources, add_row);
        else if(threads == 0)
          Geodesics::geodesic_distance_matrix(solver, sources, sources, add_row);
        else if(is_symmetric)
          Geodesics::symmetric_geodesic_distance_matrix<Parallel>(solver, sources, add_row);
        else
          Geodesics::geodesic_distance_matrix<Parallel>(solver, sources, sources, add_row);
      });
      for(const auto& entry : scaling.entries())
      {
        std::cout << file_name(file) << ',' << mesh.number_of_faces() << ','
                  << (is_symmetric ? "symmetric" : "full") << ',' << rows << ',' << entry.name << ','
                  << entry.time << ','
                  << cell(entry.time.middle / static_cast<double>(rows), 3) << ',' << cell(entry.speedup, 3)
                  << std::endl;
      }
    }
    if(!(sum > 0))
    {
      return EXIT_FAILURE; // (the rows have been used)
    }
  }
  return EXIT_SUCCESS;
}
