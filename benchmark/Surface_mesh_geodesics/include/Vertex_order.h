// The order of VTP and OPVTP: the wavefront is sorted by vertices (thesis, section 4.3.2).
//
// A vertex waits with its latest distance, as in the thesis. (In the package it waits with the least distance of a
// window next to it; see section 5.2.2.) All faces around the vertex that is visited join the traversed area.

#ifndef VERTEX_ORDER_H
#define VERTEX_ORDER_H

#include "Step.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront_queue.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <vector>

namespace schedulers {

// Invariant: a vertex with a finite distance is in the queue, or the faces around it have joined the traversed area.
template <class FT>
class Vertex_order
{
  using Mesh = CGAL::Surface_mesh_geodesics::internal::Intrinsic_mesh<FT>;

public:
  static constexpr bool sorts_faces = false;

  explicit Vertex_order(const Mesh& mesh)
    : m_queue(mesh.number_of_vertices()), m_is_visited(mesh.number_of_vertices(), 0)
  {}

  // The distance of a vertex has become d. A vertex that has been visited needs no second visit, unless it emits.
  void reach(Vertex_id v, const FT& d)
  {
    if(m_is_visited[v] == 0)
    {
      m_queue.push_or_decrease(v, d);
    }
  }

  // A pseudo-source at the distance d must emit windows.
  void let_emit(Vertex_id v, const FT& d) { m_queue.push_or_decrease(v, d); }

  // Removes the next step from the queue. Returns false if there is none.
  bool pop(Step& step)
  {
    if(m_queue.empty())
    {
      return false;
    }
    step = Step();
    step.vertex = m_queue.top();
    m_queue.pop();
    m_is_visited[step.vertex] = 1;
    return true;
  }

private:
  CGAL::Surface_mesh_geodesics::internal::Wavefront_queue<FT> m_queue;
  std::vector<unsigned char> m_is_visited;
};

} // namespace schedulers

#endif // VERTEX_ORDER_H
