#ifndef SURFACE_MESH_GEODESICS_TEST_FACES_TO_AVOID_H
#define SURFACE_MESH_GEODESICS_TEST_FACES_TO_AVOID_H

// Faces to avoid at random, and the faces that are left.

#include "test_meshes.h"
#include "test_support.h"

#include <set>
#include <vector>

namespace test_meshes {

inline std::vector<face_descriptor> random_faces(const Mesh& tm, double part, test_support::Random& random)
{
  std::vector<face_descriptor> result;
  for(const face_descriptor f : faces(tm))
    if(random.uniform() < part)
      result.push_back(f);
  return result;
}

inline std::vector<face_descriptor> other_faces(const Mesh& tm, const std::vector<face_descriptor>& avoided)
{
  const std::set<face_descriptor> set(avoided.begin(), avoided.end());
  std::vector<face_descriptor> rest;
  for(const face_descriptor f : faces(tm))
    if(set.count(f) == 0)
      rest.push_back(f);
  return rest;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_TEST_FACES_TO_AVOID_H
