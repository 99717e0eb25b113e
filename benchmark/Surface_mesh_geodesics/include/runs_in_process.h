// For the benchmark programs that measure this package only: repeated runs in one process, rows of comma separated
// values, meshes.

#ifndef RUNS_IN_PROCESS_H
#define RUNS_IN_PROCESS_H

#include "benchmark_support.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using Benchmark_kernel = CGAL::Simple_cartesian<double>;
using Benchmark_mesh = CGAL::Surface_mesh<Benchmark_kernel::Point_3>;
using Benchmark_vertex = Benchmark_mesh::Vertex_index;

// Median and extremes of repeated measurements.
struct Spread
{
  double middle = 0, low = 0, high = 0;

  Spread() = default;

  explicit Spread(std::vector<double> values)
    : middle(median(values)), low(*std::min_element(values.begin(), values.end())),
      high(*std::max_element(values.begin(), values.end()))
  {}
};

inline std::ostream& operator<<(std::ostream& out, const Spread& s)
{
  return out << cell(s.middle, 3) << ',' << cell(s.low, 3) << ',' << cell(s.high, 3);
}

inline std::string spread_columns(const std::string& name)
{
  return name + ',' + name + "_min," + name + "_max";
}

// Returns the milliseconds that a function takes.
template <class Function>
double milliseconds_of(clockid_t clock, const Function& function)
{
  const double start = milliseconds_now(clock);
  function();
  return milliseconds_now(clock) - start;
}

template <class Function>
Spread repeated(const Settings& settings, clockid_t clock, const Function& function)
{
  std::vector<double> times;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    times.push_back(milliseconds_of(clock, function));
  }
  return Spread(times);
}

inline bool read_mesh(const std::string& file, std::size_t subdivisions, Benchmark_mesh& mesh)
{
  mesh.clear();
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.number_of_faces() == 0 || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "cannot read a triangle mesh from " << file << std::endl;
    return false;
  }
  for(std::size_t i = 0; i < subdivisions; ++i)
  {
    mesh = midpoint_subdivision(mesh);
  }
  return true;
}

// Calls print_row(file, level, mesh) for each mesh of the settings on each level of subdivision. Returns the exit
// status of the program, which a file that cannot be read ends.
template <typename Print_row>
int print_rows_by_level(const Settings& settings, Print_row print_row)
{
  for(const std::string& file : settings.meshes)
    for(std::size_t level = 0; level <= settings.subdivisions; ++level)
    {
      Benchmark_mesh mesh;
      if(!read_mesh(file, level, mesh))
        return EXIT_FAILURE;
      print_row(file, level, mesh);
    }
  return EXIT_SUCCESS;
}

using Benchmark_distance_map = Benchmark_mesh::Property_map<Benchmark_vertex, double>;

// Returns the distances in a map, in the order of the vertices.
inline std::vector<double> values_of(const Benchmark_distance_map& map, const Benchmark_mesh& mesh)
{
  std::vector<double> result;
  for(const Benchmark_vertex v : mesh.vertices())
  {
    result.push_back(map[v]);
  }
  return result;
}

// Returns random vertices, the same ones in every run.
inline std::vector<Benchmark_vertex> random_vertices(const Benchmark_mesh& mesh, std::size_t n)
{
  std::mt19937_64 random(20260601);
  std::vector<Benchmark_vertex> result;
  while(result.size() < n)
  {
    const Benchmark_vertex v(static_cast<Benchmark_mesh::size_type>(random() % mesh.number_of_vertices()));
    if(!mesh.is_isolated(v))
    {
      result.push_back(v);
    }
  }
  return result;
}

inline void print_head(const Settings& settings, const std::string& text, const std::string& columns)
{
  if(settings.print_header)
  {
    print_machine(settings);
    std::cout << "# " << text << "; times in ms: median, least and greatest of " << settings.repetitions << " runs\n"
              << columns << std::endl;
  }
}

inline int usage(const char* program, const char* what)
{
  std::cerr << "usage: " << program << " [options]" << what << "\n"
            << "  --repetitions N       runs (5)\n"
            << "  --flags TEXT          compiler flags, for the first lines of the output\n"
            << "  --no-header           rows only\n";
  return EXIT_FAILURE;
}

#endif // RUNS_IN_PROCESS_H
