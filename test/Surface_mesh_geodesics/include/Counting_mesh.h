#ifndef SURFACE_MESH_GEODESICS_COUNTING_MESH_H
#define SURFACE_MESH_GEODESICS_COUNTING_MESH_H

// A mesh that knows how often the number of its elements was asked for. CGAL::Face_filtered_graph counts its elements
// in each such call, so no function may ask once for each element.

#include "Indexed_mesh.h"

#include <cstddef>

namespace test_meshes {

struct Counting_mesh : Mesh
{
  Counting_mesh() = default;
  explicit Counting_mesh(const Mesh& tm) : Mesh(tm) {}

  mutable std::size_t counts = 0;
};

// Found before the functions of the class below it: no conversion is needed.
inline Mesh::size_type num_vertices(const Counting_mesh& tm)
{
  ++tm.counts;
  return num_vertices(static_cast<const Mesh&>(tm));
}

inline Mesh::size_type num_faces(const Counting_mesh& tm)
{
  ++tm.counts;
  return num_faces(static_cast<const Mesh&>(tm));
}

} // namespace test_meshes

#define CGAL_GRAPH_TRAITS_INHERITANCE_CLASS_NAME test_meshes::Counting_mesh
#define CGAL_GRAPH_TRAITS_INHERITANCE_BASE_CLASS_NAME test_meshes::Mesh
#include <CGAL/boost/graph/graph_traits_inheritance_macros.h>

#endif // SURFACE_MESH_GEODESICS_COUNTING_MESH_H
