// Distances for programs that store meshes in matrices, such as programs that use libigl: input V and F, output D.

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <Eigen/Core>

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using face_descriptor = boost::graph_traits<Mesh>::face_descriptor;

int row_of_vertex(vertex_descriptor v) { return static_cast<int>(v.idx()); }
vertex_descriptor vertex_of_row(int i) { return vertex_descriptor(static_cast<Mesh::size_type>(i)); }

// Vertex i of the mesh is row i of V.
Mesh mesh_of_matrices(const Eigen::MatrixXd& V, const Eigen::MatrixXi& F)
{
  Mesh mesh;
  for(const auto& p : V.rowwise())
    mesh.add_vertex(Point(p(0), p(1), p(2)));
  if(F.size() > 0 && (F.minCoeff() < 0 || F.maxCoeff() >= V.rows()))
    throw std::invalid_argument("a face has a vertex that is not there");
  for(const auto& f : F.rowwise())
    if(mesh.add_face(vertex_of_row(f(0)), vertex_of_row(f(1)), vertex_of_row(f(2))) == Mesh::null_face())
      throw std::invalid_argument("the faces are not those of an oriented surface");
  return mesh;
}

// Row i of the result is the distance of the vertex V.row(i) from the nearest source vertex.
Eigen::VectorXd exact_distances(const Eigen::MatrixXd& V, const Eigen::MatrixXi& F, const std::vector<int>& sources)
{
  const Mesh mesh = mesh_of_matrices(V, F);
  std::vector<vertex_descriptor> source_vertices;
  for(const int i : sources)
    source_vertices.push_back(vertex_of_row(i));
  Eigen::VectorXd D(V.rows()); // the map writes the distances directly into the vector
  const auto distance_map = boost::make_iterator_property_map(D.data(), get(boost::vertex_index, mesh));
  CGAL::Surface_mesh_geodesics::geodesic_distances(mesh, distance_map, source_vertices);
  return D;
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

  // The matrices in the form of igl::read_triangle_mesh().
  Eigen::MatrixXd V(mesh.number_of_vertices(), 3);
  Eigen::MatrixXi F(mesh.number_of_faces(), 3);
  for(vertex_descriptor v : vertices(mesh))
    V.row(v.idx()) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
  for(face_descriptor f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    F.row(f.idx()) << row_of_vertex(source(h, mesh)), row_of_vertex(target(h, mesh)),
        row_of_vertex(target(next(h, mesh), mesh));
  }

  const Eigen::VectorXd D = exact_distances(V, F, {0, 1});
  Eigen::Index farthest;
  std::cout << D.size() << " distances, the largest is " << D.maxCoeff(&farthest);
  std::cout << ", of vertex " << farthest << std::endl;
  return EXIT_SUCCESS;
}
