// Rows of the matrix of all distances of a mesh and its subdivisions: what a row costs, and what storing it in 32 bits
// adds. Prints one line of comma separated values per mesh. Times are processor times, of computing the rows of random
// sources, and of computing them into a folder in the working directory; both alternate, and the part of storing is the
// median of the differences of adjacent runs. The elapsed time, in which storing also waits for the disk, is beside it.
// Memory is the peak of the process with the mesh, in MB of 2^20 bytes, above its size at the beginning.

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>

#include <sys/resource.h>

#include <filesystem>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

namespace {

double peak_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

// The times of one kind of run.
struct Measurement
{
  std::vector<double> processor, elapsed;

  template <typename Function>
  void add(const Function& function)
  {
    processor.push_back(milliseconds_of(CLOCK_PROCESS_CPUTIME_ID, [&] {
      elapsed.push_back(milliseconds_of(CLOCK_MONOTONIC, function));
    }));
  }
};

// The median of the relative differences of neighbors.
double added_percent(const std::vector<double>& without, const std::vector<double>& with)
{
  std::vector<double> parts;
  for(std::size_t i = 0; i < with.size(); ++i)
  {
    parts.push_back(100 * (with[i] - without[i]) / without[i]);
  }
  return median(parts);
}

bool measure(const Settings& settings, const std::string& file, std::size_t subdivisions, std::size_t rows,
             const std::string& folder)
{
  const double before = peak_memory();
  Benchmark_mesh mesh;
  if(!read_mesh(file, subdivisions, mesh))
  {
    return false;
  }
  const std::vector<Benchmark_vertex> sources = random_vertices(mesh, rows);
  Measurement computing, storing;
  double sum = 0;
  for(std::size_t k = 0; k < settings.repetitions; ++k)
  {
    computing.add([&] {
      Geodesics::geodesic_distance_matrix(mesh, sources, vertices(mesh),
                                          [&](std::size_t, const std::vector<double>& row) { sum += row.back(); });
    });
    std::filesystem::remove_all(folder);
    storing.add([&] {
      sum += static_cast<double>(
        Geodesics::store_geodesic_distance_matrix(mesh, sources, vertices(mesh), folder,
                                                  CGAL::parameters::use_float32(true)).rows_done);
    });
  }
  std::filesystem::remove_all(folder);
  std::cout << file_name(file) << ',' << subdivisions << ',' << mesh.number_of_faces() << ','
            << mesh.number_of_vertices() << ',' << rows << ','
            << cell(median(computing.processor) / static_cast<double>(rows), 3) << ','
            << cell(added_percent(computing.processor, storing.processor), 2) << ','
            << cell(added_percent(computing.elapsed, storing.elapsed), 2) << ',' << cell(peak_memory() - before, 1)
            << std::endl;
  return sum > 0;
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  std::size_t rows = 16;
  std::string folder = "benchmark_matrix_store_folder";
  if(!read_settings(argc, argv, settings, [&](const std::string& option, const std::string& value) {
       if(option == "--folder")
         folder = value;
       return option == "--folder" || read_number_option(option, value, "--rows", rows);
     }))
  {
    return usage(argv[0], " mesh...   (--rows N: sources, default 16; --folder F: where rows are stored)");
  }
  print_head(settings, "rows of all distances, stored in 32 bits, processor times",
             "mesh,subdivisions,faces,vertices,rows,ms_per_row,storing_percent,storing_elapsed_percent,memory_mb");
  for(const std::string& file : settings.meshes)
  {
    for(std::size_t k = 0; k <= settings.subdivisions; ++k)
    {
      if(!measure(settings, file, k, rows, folder))
      {
        return EXIT_FAILURE;
      }
    }
  }
  return EXIT_SUCCESS;
}
