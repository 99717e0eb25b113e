// Distances for programs that keep meshes in matrices, as those that use libigl do: in with V and F, out with D.

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;

vertex_descriptor vertex_of_row(int i) { return vertex_descriptor(static_cast<Mesh::size_type>(i)); }

// The vertices of the mesh have the numbers of the rows of V.
Mesh mesh_of_matrices(const Eigen::MatrixXd& V, const Eigen::MatrixXi& F)
{
  Mesh mesh;
  for(const auto& p : V.rowwise())
    mesh.add_vertex(Point(p(0), p(1), p(2)));
  if(F.size() > 0 && (F.minCoeff() < 0 || F.maxCoeff() >= V.rows()))
    throw std::invalid_argument("a face has a vertex that is not there");
  for(const auto& f : F.rowwise())
  {
    if(mesh.add_face(vertex_of_row(f(0)), vertex_of_row(f(1)), vertex_of_row(f(2))) == Mesh::null_face())
      throw std::invalid_argument("the faces are not those of an oriented surface");
  }
  return mesh;
}

// Row i of the result has the distance of the vertex V.row(i) from the nearest of the source vertices.
Eigen::VectorXd exact_distances(const Eigen::MatrixXd& V, const Eigen::MatrixXi& F, const std::vector<int>& sources)
{
  const Mesh mesh = mesh_of_matrices(V, F);
  std::vector<vertex_descriptor> source_vertices;
  for(const int i : sources)
    source_vertices.push_back(vertex_of_row(i));
  Eigen::VectorXd D(V.rows()); // the map lets the distances be written to the vector itself
  const auto distance_map = boost::make_iterator_property_map(D.data(), get(boost::vertex_index, mesh));
  CGAL::Surface_mesh_geodesics::geodesic_distances(mesh, distance_map, source_vertices);
  return D;
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
  const auto is_triangle = [](const std::vector<std::size_t>& face) { return face.size() == 3; };
  if(!CGAL::IO::read_polygon_soup(filename, points, triangles) || triangles.empty()
     || !std::all_of(triangles.begin(), triangles.end(), is_triangle))
  {
    std::cerr << "Cannot read triangles from " << filename << std::endl;
    return EXIT_FAILURE;
  }
  Eigen::MatrixXd V(points.size(), 3);
  Eigen::MatrixXi F(triangles.size(), 3);
  for(std::size_t i = 0; i < points.size(); ++i)
    V.row(static_cast<Eigen::Index>(i)) << points[i].x(), points[i].y(), points[i].z();
  for(std::size_t i = 0; i < triangles.size(); ++i)
    for(std::size_t k = 0; k < 3; ++k)
      F(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = static_cast<int>(triangles[i][k]);

  const Eigen::VectorXd D = exact_distances(V, F, {0, 1});
  Eigen::Index farthest;
  std::cout << D.size() << " distances, the largest is " << D.maxCoeff(&farthest);
  std::cout << ", of vertex " << farthest << std::endl;
  return EXIT_SUCCESS;
}
