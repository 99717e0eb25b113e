#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using face_descriptor = boost::graph_traits<Mesh>::face_descriptor;

// A point of the surface: a face and barycentric coordinates in it, as in Surface_mesh_shortest_path.
using Face_location = std::pair<face_descriptor, std::array<double, 3>>;

namespace Geodesics = CGAL::Surface_mesh_geodesics;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || faces(mesh).empty() || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Cannot read a triangle mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Four points: inside a face, on an edge, at a vertex, and inside another face.
  const Mesh::size_type n = mesh.number_of_faces();
  std::vector<Face_location> sources;
  sources.push_back({face_descriptor(0), {0.2, 0.3, 0.5}});
  sources.push_back({face_descriptor(n / 4), {0.75, 0.25, 0.}});
  sources.push_back({face_descriptor(n / 2), {0., 1., 0.}});
  sources.push_back({face_descriptor(n - 1), {0.4, 0.4, 0.2}});

  // The map of nearest sources receives, for each vertex, an index into the vector of sources.
  auto distance = mesh.add_property_map<vertex_descriptor, double>("v:distance").first;
  auto nearest = mesh.add_property_map<vertex_descriptor, std::size_t>("v:nearest_source").first;

  // An offset is added to all distances from its source, as if every path began with an extra piece of that length. The
  // offset of the last source is so large that no vertex is nearest to it.
  const std::vector<double> offsets = {0., 0.1, 0., 100.};

  Geodesics::geodesic_distances(mesh, distance, sources,
                                CGAL::parameters::nearest_source_map(nearest).source_offsets(offsets));

  std::vector<std::size_t> number_of_vertices(sources.size(), 0);
  std::vector<double> farthest(sources.size(), 0.);
  for(vertex_descriptor v : vertices(mesh))
  {
    const std::size_t i = nearest[v];
    if(i < sources.size()) // false for a vertex that no path reaches
    {
      ++number_of_vertices[i];
      farthest[i] = (std::max)(farthest[i], distance[v]);
    }
  }
  for(std::size_t i = 0; i < sources.size(); ++i)
  {
    std::cout << "source " << i << " is the nearest one of " << number_of_vertices[i]
              << " vertices, the largest distance is " << farthest[i] << std::endl;
  }
  return EXIT_SUCCESS;
}
