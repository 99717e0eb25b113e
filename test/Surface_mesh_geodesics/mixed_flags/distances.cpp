// One of several files of a program, each of which is compiled with other flags (check_mixed_flags.sh). FUNCTION is its
// name of the function below. With MAIN, the file also has the program, which compares the results of all of them.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// The distances of all vertices, with the text that this file or another one of the program has compiled.
std::vector<double> FUNCTION(const Mesh& mesh, std::size_t source)
{
  std::vector<double> distances(mesh.number_of_vertices());
  CGAL::Surface_mesh_geodesics::geodesic_distances(
    mesh, boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh)),
    Mesh::Vertex_index(static_cast<Mesh::size_type>(source)));
  return distances;
}

#ifdef MAIN

std::vector<double> distances_without_flags(const Mesh& mesh, std::size_t source);
std::vector<double> distances_with_avx2(const Mesh& mesh, std::size_t source);
std::vector<double> distances_with_avx512(const Mesh& mesh, std::size_t source);

int main(int argc, char* argv[])
{
  using Function = std::vector<double> (*)(const Mesh&, std::size_t);
  const Function functions[] = {distances_with_avx2, distances_with_avx512, distances_without_flags};
  for(int i = 1; i < argc; ++i)
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(argv[i], mesh))
    {
      std::cerr << "cannot read " << argv[i] << std::endl;
      return EXIT_FAILURE;
    }
    for(std::size_t source = 0; source < mesh.number_of_vertices(); source += 1 + mesh.number_of_vertices() / 8)
    {
      const std::vector<double> expected = distances_without_flags(mesh, source);
      for(const Function& function : functions)
      {
        if(function(mesh, source) != expected)
        {
          std::cerr << argv[i] << ", source " << source << ": the files have different distances" << std::endl;
          return EXIT_FAILURE;
        }
      }
      // For comparison with a program whose files have the same flags.
      std::cout << argv[i] << ' ' << source << std::hexfloat;
      for(const double d : expected)
      {
        std::cout << ' ' << d;
      }
      std::cout << '\n';
    }
  }
  return EXIT_SUCCESS;
}

#endif
