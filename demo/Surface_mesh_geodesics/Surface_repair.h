#ifndef SURFACE_MESH_GEODESICS_DEMO_SURFACE_REPAIR_H
#define SURFACE_MESH_GEODESICS_DEMO_SURFACE_REPAIR_H

#include "Polygon_soup.h"

#include <cstddef>
#include <string>

namespace geodesics_demo {

// What a repair has changed.
struct Repair_report
{
  std::size_t merged_vertices = 0;   // at the place of another vertex
  std::size_t degenerate_faces = 0;  // left out: fewer than three different vertices
  std::size_t repeated_faces = 0;    // left out: another face has the same vertices
  std::size_t reversed_faces = 0;
  std::size_t split_edges = 0;       // had more than two faces
  std::size_t new_vertices = 0;      // copies, where several parts of the surface met

  // "2 vertices merged, 1 face reversed"; empty if nothing was changed.
  std::string text() const;
};

// Makes the faces fit each other, so that they form a surface: merges vertices with equal coordinates, leaves out faces
// that are degenerate or repeated, gives neighbors the same orientation, and cuts the surface where an edge has more
// than two faces or where several parts meet at a vertex. Vertices and faces may get other indices.
//
// Marks follow their faces, unless repeated faces have been left out: then they mean nothing.
//
// A face without area is not degenerate if its vertices differ: leaving it out would open the surface.
Repair_report repair(Polygon_soup& soup);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_SURFACE_REPAIR_H
