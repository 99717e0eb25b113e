#ifndef SURFACE_MESH_GEODESICS_INDEXED_MESH_H
#define SURFACE_MESH_GEODESICS_INDEXED_MESH_H

// Meshes as indexed triangles, a little vector arithmetic, and the conversion to and from face graphs.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using face_descriptor = boost::graph_traits<Mesh>::face_descriptor;
using Face_location = std::pair<face_descriptor, std::array<double, 3>>;

using Coordinates = std::array<double, 3>;
using Triangle = std::array<std::size_t, 3>;

const double pi = 3.14159265358979323846;

// Triangles as indices of points, counterclockwise as seen from outside.
struct Indexed_mesh
{
  std::string name;
  std::vector<Coordinates> points;
  std::vector<Triangle> faces;
};

// Adds the quadrilateral abcd as two triangles, divided along the diagonal ac or along bd.
inline void add_quadrilateral(Indexed_mesh& mesh, std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                              bool is_divided_along_ac = true)
{
  if(is_divided_along_ac)
  {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a, c, d});
  }
  else
  {
    mesh.faces.push_back({a, b, d});
    mesh.faces.push_back({b, c, d});
  }
}

inline Coordinates operator+(const Coordinates& a, const Coordinates& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Coordinates operator-(const Coordinates& a, const Coordinates& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Coordinates operator*(double s, const Coordinates& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

inline double length(const Coordinates& a)
{
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

inline Coordinates cross(const Coordinates& a, const Coordinates& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Adds the vertices and faces of `indexed` to `tm`. Returns the vertex descriptors in the order of the points; appends
// the faces to `faces_of_triangles`, unless it is null. Throws if the result is not a 2-manifold.
template <class FaceGraph>
std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>
add_to_face_graph(const Indexed_mesh& indexed, FaceGraph& tm,
                  std::vector<typename boost::graph_traits<FaceGraph>::face_descriptor>* faces_of_triangles = nullptr)
{
  using Point = typename boost::property_traits<
    typename boost::property_map<FaceGraph, CGAL::vertex_point_t>::type>::value_type;
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;

  auto vertex_point_map = get(CGAL::vertex_point, tm);
  std::vector<Vertex> vertices_of_points;
  vertices_of_points.reserve(indexed.points.size());
  for(const Coordinates& p : indexed.points)
  {
    const Vertex v = add_vertex(tm);
    put(vertex_point_map, v, Point(p[0], p[1], p[2]));
    vertices_of_points.push_back(v);
  }
  for(const Triangle& triangle : indexed.faces)
  {
    const std::array<Vertex, 3> corners{vertices_of_points[triangle[0]], vertices_of_points[triangle[1]],
                                        vertices_of_points[triangle[2]]};
    const auto f = CGAL::Euler::add_face(corners, tm);
    if(f == boost::graph_traits<FaceGraph>::null_face())
    {
      throw std::logic_error("test mesh " + indexed.name + " is not a 2-manifold");
    }
    if(faces_of_triangles != nullptr)
    {
      faces_of_triangles->push_back(f);
    }
  }
  return vertices_of_points;
}

template <class FaceGraph = Mesh>
FaceGraph to_face_graph(const Indexed_mesh& indexed)
{
  FaceGraph tm;
  add_to_face_graph(indexed, tm);
  return tm;
}

inline Indexed_mesh to_indexed_mesh(const Mesh& tm, const std::string& name)
{
  Indexed_mesh indexed;
  indexed.name = name;
  std::map<vertex_descriptor, std::size_t> index_of;
  for(const vertex_descriptor v : vertices(tm))
  {
    index_of[v] = indexed.points.size();
    const auto& p = tm.point(v);
    indexed.points.push_back({p.x(), p.y(), p.z()});
  }
  for(const face_descriptor f : faces(tm))
  {
    const auto h = halfedge(f, tm);
    indexed.faces.push_back(
      {index_of[source(h, tm)], index_of[target(h, tm)], index_of[target(next(h, tm), tm)]});
  }
  return indexed;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_INDEXED_MESH_H
