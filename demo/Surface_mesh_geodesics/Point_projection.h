#ifndef SURFACE_MESH_GEODESICS_DEMO_POINT_PROJECTION_H
#define SURFACE_MESH_GEODESICS_DEMO_POINT_PROJECTION_H

#include "Command_error.h"
#include "Console.h"
#include "Face_tree.h"
#include "Program_mesh.h"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace geodesics_demo {

// Moves points in space to the nearest locations of a surface, and knows how far. Messages begin with `where`, the
// origin of a point. Builds a tree of the faces with the first point.
class Point_projection
{
public:
  // Mesh and console are referred to. `may_snap`: points may be far from the surface (--snap). Points do not move into
  // the faces `avoided`, but to their rim.
  Point_projection(const Mesh& mesh, bool may_snap, const Console& console, const std::vector<Face>& avoided = {})
    : m_mesh(mesh), m_may_snap(may_snap), m_console(console), m_avoided(avoided)
  {}

  // Throws a Command_error with the code for a point that is so far from the surface that it was probably not meant to
  // be on it, and if all faces are to be avoided.
  Face_location nearest_location(const std::array<double, 3>& x, const std::string& where, Exit_code code);

  // Remarks on the point that was farthest from the surface, if that was more than a rounding of its digits.
  void remark_on_snaps() const;

private:
  void build_tree(const std::string& where, Exit_code code);
  const char* goal() const { return m_avoided.empty() ? "the surface" : "the faces that are not avoided"; }
  void check_is_near(const std::array<double, 3>& x, const std::string& where, Exit_code code);
  void check_snap(const Point& p, const Face_location& location, const std::string& where, Exit_code code);

  // Parts of the diagonal of the mesh. Points with five digits are silent.
  static constexpr double largest_silent_snap = 1e-4, largest_snap = 0.01;

  const Mesh& m_mesh;
  bool m_may_snap;
  const Console& m_console;
  std::vector<Face> m_avoided;
  std::size_t m_number_of_snaps = 0;
  double m_farthest_snap = 0, m_diagonal = -1; // negative until it is computed
  std::string m_where_farthest;
  double m_limit = -1; // of the distances of points; negative until it is computed
  std::unique_ptr<Face_tree> m_tree;
};

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_POINT_PROJECTION_H
