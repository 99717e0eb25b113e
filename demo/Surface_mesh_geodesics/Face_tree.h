#ifndef SURFACE_MESH_GEODESICS_DEMO_FACE_TREE_H
#define SURFACE_MESH_GEODESICS_DEMO_FACE_TREE_H

#include "Program_mesh.h"

#include <memory>
#include <vector>

namespace geodesics_demo {

// Finds the location on a mesh that is nearest to a point in space.
class Face_tree
{
public:
  // Locations are in none of the faces `without`; others must be left.
  explicit Face_tree(const Mesh& mesh, const std::vector<Face>& without = {});
  ~Face_tree();

  Face_location nearest_location(const Point& p) const;

private:
  struct Tree; // hides the headers of CGAL's tree from the files that use this class
  const Mesh& m_mesh;
  std::unique_ptr<Tree> m_tree;
};

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_FACE_TREE_H
