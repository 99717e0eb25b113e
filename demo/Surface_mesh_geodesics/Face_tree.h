#ifndef SURFACE_MESH_GEODESICS_APP_FACE_TREE_H
#define SURFACE_MESH_GEODESICS_APP_FACE_TREE_H

#include "Program_mesh.h"

#include <memory>

namespace geodesics_app {

// Finds the place of a mesh that is nearest to a point in space.
class Face_tree
{
public:
  explicit Face_tree(const Mesh& mesh);
  ~Face_tree();

  Face_location nearest_place(const Point& p) const;

private:
  struct Tree; // keeps the headers of CGAL's tree out of all files that look for places
  const Mesh& m_mesh;
  std::unique_ptr<Tree> m_tree;
};

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_FACE_TREE_H
