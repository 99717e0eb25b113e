// A smaller version of a mesh, for programs that measure how something grows with the mesh.

#ifndef DECIMATED_MESH_H
#define DECIMATED_MESH_H

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstddef>

// Stops when only a part of the edges is left. (CGAL 5.6 has renamed its own predicates.)
struct Stop_at_part_of_edges
{
  double part;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t initial_edges, std::size_t edges) const
  {
    return static_cast<double>(edges) < part * static_cast<double>(initial_edges);
  }
};

// Collapses edges of a Surface_mesh in the order of Lindstrom and Turk until a part of them is left. Vertices and faces
// are numbered anew, in their old order.
template <class Mesh>
void decimate(Mesh& mesh, double part)
{
  if(part < 1)
  {
    CGAL::Surface_mesh_simplification::edge_collapse(mesh, Stop_at_part_of_edges{part});
    mesh.collect_garbage();
  }
}

#endif // DECIMATED_MESH_H
