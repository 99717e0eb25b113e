// Several threads query many paths of one object.

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;

// Counts the points of the paths from the vertices first, first + step, first + 2 step, ... Queries are const: any
// number of threads may query the same object.
void count_points(const Paths& paths, std::size_t first, std::size_t step, std::vector<std::size_t>& numbers)
{
  std::vector<Kernel::Point_3> points;
  for(std::size_t i = first; i < numbers.size(); i += step)
  {
    points.clear();
    paths.shortest_path_points_to_source_points(vertex_descriptor(static_cast<Mesh::size_type>(i)),
                                                std::back_inserter(points));
    numbers[i] = points.size();
  }
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || faces(mesh).empty() || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Cannot read a triangle mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // The first query builds, while the other threads wait. Call build_sequence_tree() to build earlier.
  Paths paths(mesh);
  paths.add_source_point(*vertices(mesh).begin());

  std::vector<std::size_t> numbers(mesh.number_of_vertices());
  const std::size_t number_of_threads = (std::max)(2u, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for(std::size_t i = 0; i < number_of_threads; ++i)
  {
    threads.emplace_back([&, i] { count_points(paths, i, number_of_threads, numbers); });
  }
  for(std::thread& thread : threads)
  {
    thread.join();
  }

  const auto longest = std::max_element(numbers.begin(), numbers.end());
  std::cout << numbers.size() << " paths; the one with most points has " << *longest << ", to vertex "
            << longest - numbers.begin() << std::endl;
  return EXIT_SUCCESS;
}
