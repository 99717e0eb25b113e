// What a C++ program needs for the calls that benchmark_python.py makes from Python. Prints one line, clock times in
// ms: for building a mesh from arrays of points and triangles and reading it into a solver; for the distances from
// vertex 0; for paths to random vertices, as points. One thread.
//
// usage: benchmark_python MESH TARGETS, where TARGETS is a file of numbers of vertices

#include "benchmark_support.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Solver = CGAL::Surface_mesh_geodesics::Geodesic_distance_solver<Mesh>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

// Paths are kept for this many targets at a time, as in benchmark_python.py.
constexpr std::size_t targets_at_a_time = 10000;

// The time of distances is the least of so many runs: other programs only add to it.
constexpr unsigned int number_of_propagations = 15;

struct Soup
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// Calls work() and returns the time that it took.
template <typename Work>
double time_of(const Work& work)
{
  const double begin = milliseconds_now(CLOCK_MONOTONIC);
  work();
  return milliseconds_now(CLOCK_MONOTONIC) - begin;
}

void add_soup(const Soup& soup, Mesh& mesh)
{
  mesh.reserve(Mesh::size_type(soup.points.size()), Mesh::size_type(3 * soup.triangles.size() / 2),
               Mesh::size_type(soup.triangles.size()));
  for(const Point& p : soup.points)
    mesh.add_vertex(p);
  for(const std::array<std::size_t, 3>& t : soup.triangles)
    if(mesh.add_face(Vertex(Mesh::size_type(t[0])), Vertex(Mesh::size_type(t[1])), Vertex(Mesh::size_type(t[2])))
       == Mesh::null_face())
      throw std::runtime_error("the triangles are not a surface");
}

double time_of_paths(const Mesh& mesh, const std::vector<std::size_t>& targets)
{
  Paths paths(mesh);
  paths.add_source_point(Vertex(0));
  paths.build_sequence_tree();
  return time_of([&]()
  {
    for(std::size_t begin = 0; begin < targets.size(); begin += targets_at_a_time)
    {
      std::vector<std::vector<Point>> lines((std::min)(targets_at_a_time, targets.size() - begin));
      for(std::size_t i = 0; i < lines.size(); ++i)
        paths.shortest_path_points_to_source_points(Vertex(Mesh::size_type(targets[begin + i])),
                                                    std::back_inserter(lines[i]));
    }
  });
}

void measure(const Soup& soup, const std::vector<std::size_t>& targets)
{
  Mesh mesh;
  std::unique_ptr<Solver> solver;
  std::vector<double> distances(soup.points.size());
  const auto compute = [&]()
  {
    solver->compute_distances(Vertex(0));
    for(const Vertex v : mesh.vertices())
      distances[v] = solver->distance(v);
  };
  const double first = time_of([&]()
  {
    add_soup(soup, mesh);
    solver = std::make_unique<Solver>(mesh);
    compute(); // this run also allocates the wavefront
  });
  std::vector<double> propagations;
  for(unsigned int i = 0; i < number_of_propagations; ++i)
    propagations.push_back(time_of(compute));
  const double least = *std::min_element(propagations.begin(), propagations.end());
  std::cout.precision(9);
  std::cout << first - least << ',' << least << ',' << time_of_paths(mesh, targets) << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  if(argc != 3)
  {
    std::cerr << "usage: " << argv[0] << " MESH TARGETS\n";
    return EXIT_FAILURE;
  }
  Soup soup;
  std::ifstream targets(argv[2]);
  if(!CGAL::IO::read_polygon_soup(argv[1], soup.points, soup.triangles) || !targets)
  {
    std::cerr << "cannot read " << argv[1] << " or " << argv[2] << '\n';
    return EXIT_FAILURE;
  }
  measure(soup, {std::istream_iterator<std::size_t>(targets), std::istream_iterator<std::size_t>()});
  return EXIT_SUCCESS;
}
