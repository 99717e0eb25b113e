#include "Face_tree.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>

namespace geodesics_demo {

namespace {

using Paths = CGAL::Surface_mesh_geodesic_paths<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
using AABB_traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
using AABB_traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

} // namespace

struct Face_tree::Tree
{
  CGAL::AABB_tree<AABB_traits> faces;
};

Face_tree::Face_tree(const Mesh& mesh, const std::vector<Face>& without) : m_mesh(mesh), m_tree(new Tree)
{
  std::vector<char> is_left_out(mesh.number_of_faces(), 0);
  for(const Face f : without)
    is_left_out[f] = 1;
  std::vector<Face> faces;
  for(const Face f : mesh.faces())
    if(is_left_out[f] == 0)
      faces.push_back(f);
  m_tree->faces.rebuild(faces.begin(), faces.end(), m_mesh);
}

Face_tree::~Face_tree() = default;

Face_location Face_tree::nearest_location(const Point& p) const
{
  Face_location location = Paths::locate(p, m_tree->faces, m_mesh, get(CGAL::vertex_point, m_mesh));
  // Beside an edge, a coordinate may be below zero by rounding. Tables are read back, and no reader takes such numbers.
  for(double& coordinate : location.second)
    coordinate = (std::max)(coordinate, 0.);
  return location;
}

} // namespace geodesics_demo
