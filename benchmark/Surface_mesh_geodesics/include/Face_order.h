// The order of FTP and OPFTP: the wavefront is sorted by faces (thesis, section 4.3.1).
//
// A face outside the traversed area waits with a distance of the lists that wait to enter it, and joins the area alone.
// In the thesis this is the least distance of its apex through such a list (wl.dis in section 4.2.3.1). It costs a pass
// over each list that comes to the wavefront, and makes faces join later, when more lists have come. The other choice
// is the least distance of a window of these lists, which is known already.
//
// Difference from the thesis. There, a saddle emits windows when the last face around it joins. That need not happen:
// behind a saddle no window arrives if those that pass it are pruned on the way, so the faces there would wait for the
// saddle and the saddle for them. Here a pseudo-source waits in a queue with its distance, and emits when it is nearer
// than all faces that wait.

#ifndef FACE_ORDER_H
#define FACE_ORDER_H

#include "Step.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront_queue.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

namespace schedulers {

enum class Face_key { DISTANCE_OF_APEX, DISTANCE_OF_LIST };

// Invariant: each face that a list waits to enter is in the queue of faces, and each pseudo-source that must emit
// windows is in the queue of vertices.
template <class FT, Face_key key_>
class Order_of_faces
{
  using Mesh = CGAL::Surface_mesh_geodesics::internal::Intrinsic_mesh<FT>;
  using Queue = CGAL::Surface_mesh_geodesics::internal::Wavefront_queue<FT>;

public:
  static constexpr bool sorts_faces = true;
  static constexpr Face_key key = key_;

  explicit Order_of_faces(const Mesh& mesh) : m_faces(mesh.number_of_faces()), m_vertices(mesh.number_of_vertices()) {}

  // The distance of a vertex has become d: no face waits for that.
  void reach(Vertex_id, const FT&) {}

  // A pseudo-source at the distance d must emit windows.
  void let_emit(Vertex_id v, const FT& d) { m_vertices.push_or_decrease(v, d); }

  // A list waits to enter a face; d is the distance that the key tells.
  void let_enter(Face_id f, const FT& d) { m_faces.push_or_decrease(f, d); }

  // Removes the next step from the queues. Returns false if there is none. Of equal distances, the vertex is first.
  bool pop(Step& step)
  {
    step = Step();
    if(!m_vertices.empty() && (m_faces.empty() || !(m_faces.top_key() < m_vertices.top_key())))
    {
      step.vertex = m_vertices.top();
      m_vertices.pop();
      return true;
    }
    if(m_faces.empty())
    {
      return false;
    }
    step.face = m_faces.top();
    m_faces.pop();
    return true;
  }

private:
  Queue m_faces, m_vertices;
};

// That of the thesis, and the other choice.
template <class FT>
using Face_order = Order_of_faces<FT, Face_key::DISTANCE_OF_APEX>;

template <class FT>
using List_order = Order_of_faces<FT, Face_key::DISTANCE_OF_LIST>;

} // namespace schedulers

#endif // FACE_ORDER_H
