#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
using Polyline = std::vector<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || faces(mesh).empty() || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Cannot read a triangle mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Four sources inside faces, given by barycentric coordinates.
  Paths paths(mesh);
  const Mesh::size_type n = mesh.number_of_faces();
  for(Mesh::size_type i = 0; i < 4; ++i)
    paths.add_source_point(Mesh::Face_index(i * (n / 4)), {0.2, 0.3, 0.5});
  paths.build_sequence_tree_for_faces(); // optional: builds now instead of in the first query

  // Paths from the centers of about a hundred faces, in CGAL's format for polylines: the number of points of each path,
  // then the points.
  const std::string output = "paths.polylines.txt";
  std::ofstream os(output);
  os.precision(17);
  const Traits::Barycentric_coordinates center = {1. / 3, 1. / 3, 1. / 3};
  const Mesh::size_type step = n / 100 + 1;
  for(Mesh::size_type i = 0; i < n; i += step)
  {
    const Mesh::Face_index face(i);
    Polyline polyline;
    const auto [distance, source] =
        paths.shortest_path_points_to_source_points(face, center, std::back_inserter(polyline));
    if(source == paths.source_points_end())
    {
      std::cout << "face " << i << " is reached by no source" << std::endl;
      continue;
    }
    std::cout << "face " << i << ": source " << paths.nearest_source_point(face, center) << ", distance " << distance
              << ", " << polyline.size() << " points" << std::endl;
    os << polyline.size();
    for(const Kernel::Point_3& p : polyline)
      os << ' ' << p;
    os << '\n';
  }

  if(!os.flush())
  {
    std::cerr << "Cannot write " << output << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "written: " << output << std::endl;
  return EXIT_SUCCESS;
}
