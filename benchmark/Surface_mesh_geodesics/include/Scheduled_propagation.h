// The propagation of the thesis with its own schedules (section 4.3): FTP, OPFTP, VTP and OPVTP. They exist to be
// compared with each other and with the propagation of the package (Distance_propagation), as in tables 4.4 and 4.5.
//
// Only the order of the work is written here. Windows, lists, the pool, the crossing of a face with all pruning rules
// (Window_list_crossing), the emission of windows (Star_propagation, Emission_sector), the queue (Wavefront_queue), the
// improvement of vertices (Wavefront) and the mesh (Intrinsic_mesh) are those of the package.
//
// The four systems are two choices:
//
//   system | order (section)         | secondary merger (4.3.1)
//   -------|-------------------------|-------------------------
//   FTP    | Face_order (4.3.1)      | order-free
//   OPFTP  | Face_order              | order-preserving
//   VTP    | Vertex_order (4.3.2)    | order-free
//   OPVTP  | Vertex_order            | order-preserving
//
// FTP-List is FTP with faces sorted by the least distance of a window (List_order), which the thesis does not have.
//
// In each iteration, faces join the traversed area R: the nearest face, or the faces around the nearest vertex. The
// lists that wait to enter these faces are propagated at once, in the order of a FIFO queue W, through all faces of R
// until they come to the wavefront (procedure GeodesicUpdate). A list that comes to an edge of a face that has just
// joined is merged with the one that waits there (prime merger), and so is a window that a pseudo-source emits. A list
// that comes to an older edge of the wavefront is merged by the secondary merger of the system. Waiting_lists.h
// describes the mergers. Inside R, lists are not merged.
//
// How the systems differ from the thesis:
// - Lists are sorted by key, not by the left ends of their intervals, and an order-free merger leaves two lists
//   (Waiting_lists.h).
// - Rules 2 and 3 are applied when a list is propagated, on every fourth edge, not by each merger and on each edge.
// - A pseudo-source emits when it is the nearest element of the queue (Face_order.h), also if it is improved later
//   inside R, where the thesis emits at once (4.3.2, "Saddle Vertices"). It emits only into the faces that a shortest
//   path may enter (Emission_sector.h).
// - Several sources, borders, pinched vertices and faces without area are allowed.
//
// How the package differs from the VTP that is written here: lists that turn back into R wait like all others and are
// merged there; a vertex waits with the least distance of a window next to it; and all mergers preserve the order.
//
// Distances are the same as those of the package up to rounding, whatever the order is: each distance is the length of
// a path, each rule removes only windows that are farther than such a path, and a pseudo-source that is improved emits
// again.

#ifndef SCHEDULED_PROPAGATION_H
#define SCHEDULED_PROPAGATION_H

#include "Face_order.h"
#include "Pair_pruning.h"
#include "Step.h"
#include "Traversed_area.h"
#include "Vertex_order.h"
#include "Waiting_lists.h"

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Vertex_rival.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_crossing.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>

namespace schedulers {

enum class Secondary_merger { ORDER_FREE, ORDER_PRESERVING };

// Use: add_source() for each source, then run() once. The result is in the field.
//
// Invariants between iterations: W is empty; no list waits to enter a face of R; the queues of Order satisfy their
// invariants, so that nothing waits when they are empty. The Wavefront holds no lists: only its distances and its flags
// of pseudo-sources are in use.
template <class FT, template <class> class Order, Secondary_merger merger, class Pruning = Neighbor_pruning>
class Scheduled_propagation
{
  using Rules = typename Pruning::Rules;
  using Mesh = geodesics::Intrinsic_mesh<FT>;
  using Field = geodesics::Vertex_distance_field<FT>;
  using List = geodesics::Window_list<FT>;
  using Crossing = geodesics::Window_list_crossing<FT, Rules>;
  using Halfedge_id = geodesics::Halfedge_id;
  static constexpr std::uint32_t null_id = geodesics::null_id;

public:
  // Resets the field. Mesh and field must outlive this object.
  Scheduled_propagation(const Mesh& mesh, Field& field)
    : m_mesh(mesh), m_field(field), m_wavefront(mesh, field), m_order(mesh), m_area(mesh.number_of_faces()),
      m_waiting(mesh.number_of_faces()), m_stars(mesh, field.distance),
      m_crossing(mesh, field.distance, m_statistics)
  {}

  Scheduled_propagation(const Scheduled_propagation&) = delete;
  Scheduled_propagation& operator=(const Scheduled_propagation&) = delete;

  // Requires: v is a vertex of the mesh; offset >= 0 and finite.
  void add_source(Vertex_id v, const FT& offset) { m_wavefront.add_source(v, offset, emission()); }

  // Computes all distances. Quadratic in the number of vertices at worst, times a logarithm if the merger preserves the
  // order (thesis, section 4.4).
  void run()
  {
    do
    {
      Step step;
      while(m_order.pop(step))
      {
        m_area.begin_iteration();
        if(step.is_face())
        {
          join(step.face);
        }
        else
        {
          visit(step.vertex);
        }
        update();
        m_statistics.maximum_windows_alive =
          (std::max)(m_statistics.maximum_windows_alive, m_waiting.number_of_windows());
      }
      CGAL_assertion(m_waiting.number_of_windows() == 0);
    } while(m_wavefront.start_beside_unreached_vertices(emission()));
  }

  // windows_propagated counts each window at each face that it crosses, as the thesis does; maximum_windows_alive the
  // windows that wait on the wavefront between two iterations.
  CGAL::Surface_mesh_geodesics::Propagation_statistics statistics() const
  {
    CGAL::Surface_mesh_geodesics::Propagation_statistics s = m_statistics;
    s.add(m_stars.statistics());
    s.maximum_window_bytes = m_stars.memory();
    return s;
  }

private:
  // A list in front of a face of R.
  struct Moving_list
  {
    Halfedge_id halfedge;
    List list;
  };

  auto emission()
  {
    return [this](Vertex_id v, const FT& d) { m_order.let_emit(v, d); };
  }

  // Adds a face to R, and the lists that wait to enter it to W.
  void join(Face_id f)
  {
    if(!m_area.add(f))
    {
      return;
    }
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = geodesics::halfedge_of(f, k);
      m_waiting.take(h, [&](const List& list) { m_moving.push(Moving_list{h, list}); });
    }
  }

  // Visits a vertex: the faces around it join R if vertices are sorted, or if it is a source (4.3.1, "Initialization"),
  // and it emits windows if it has to.
  void visit(Vertex_id v)
  {
    m_star.surround(m_mesh, v);
    geodesics::Window_list_slots no_slots;
    m_wavefront.take(m_star, FT(0), no_slots);
    if(!Order<FT>::sorts_faces || m_field.is_source(v))
    {
      for(const geodesics::Star_face<FT>& f : m_star.faces)
      {
        join(geodesics::face_of(f.halfedge));
      }
    }
    if(m_star.emits)
    {
      emit();
    }
  }

  // Lets the vertex of m_star emit windows and improve its neighbors along its edges. No list waits in the star.
  void emit()
  {
    m_stars.propagate(m_star);
    geodesics::Wavefront<FT>::for_each_improved_link(
      m_star, [&](const geodesics::Link_vertex<FT>& link)
      { improve(link.vertex, link.distance, link.arrival, link.image); });
    for(geodesics::Star_face<FT>& f : m_star.faces)
    {
      if(f.outward.size > 0)
      {
        deliver(m_mesh.opposite(geodesics::next_halfedge(f.halfedge)), f.outward, f.outward_distance, true);
      }
    }
  }

  // Procedure GeodesicUpdate: propagates the lists of W until all of them wait on the wavefront or are gone.
  void update()
  {
    while(!m_moving.empty())
    {
      Moving_list moving = m_moving.front();
      m_moving.pop();
      cross(moving.halfedge, moving.list);
    }
  }

  // Propagates a list across the face of h, to the two other edges.
  void cross(Halfedge_id h, List& list)
  {
    const geodesics::Face_frame<FT> c = m_mesh.face_frame(h);
    geodesics::Corner_rivals<FT> corners{rival(c.origin), rival(c.target), rival(c.apex)};
    ++m_statistics.window_lists;
    m_crossing.prune(list, c, corners);
    m_pruning.prune(list, c.length);
    if(list.size > 0)
    {
      m_statistics.windows_propagated += list.size;
      const typename Crossing::Apex_path path = m_crossing.find_apex_path(list, c);
      if(!comes_from_corner(path, c) && improve_apex(c.apex, h, path))
      {
        corners.apex = rival(c.apex);
      }
      m_pruning.separate(list, c, path.index);
      List left = make_room(c.left, list.size, c.left_length);
      List right = make_room(c.right, list.size, c.right_length);
      m_crossing.split(list, c, corners, path, left, right);
      fill(left, m_crossing.left());
      fill(right, m_crossing.right());
      const bool is_prime = m_area.is_new(geodesics::face_of(h));
      const FT left_distance = m_crossing.left().minimum_distance, right_distance = m_crossing.right().minimum_distance;
      deliver(c.left, left, left_distance, is_prime);
      deliver(c.right, right, right_distance, is_prime);
    }
    m_stars.pool().release(list);
  }

  // Makes an empty list for n windows in front of the halfedge h; without a block if nothing can enter there.
  List make_room(Halfedge_id h, std::size_t n, const FT& length)
  {
    return h == null_id || !(length > 0) ? List() : m_stars.pool().allocate(n);
  }

  // Makes the windows in the block of a list its elements.
  void fill(List& list, const geodesics::Window_batch<FT>& batch)
  {
    if(batch.has_block())
    {
      m_stars.pool().add(list, batch.size, batch.steps);
      m_statistics.windows_created += batch.size;
    }
  }

  // Moves a list, which may be empty, to a halfedge: to W if its face is in R, else to the wavefront. The distance is
  // the least one of its windows.
  void deliver(Halfedge_id h, List& list, const FT& distance, bool is_prime)
  {
    if(list.size == 0)
    {
      return;
    }
    const Face_id f = geodesics::face_of(h);
    if(m_area.contains(f))
    {
      m_moving.push(Moving_list{h, list});
      list = List();
      return;
    }
    if constexpr(Order<FT>::sorts_faces)
    {
      m_order.let_enter(f, Order<FT>::key == Face_key::DISTANCE_OF_LIST
                             ? distance
                             : m_crossing.find_apex_path(list, m_mesh.face_frame(h)).distance);
    }
    if(is_prime || merger == Secondary_merger::ORDER_PRESERVING)
    {
      m_waiting.merge(h, list, m_stars.pool());
    }
    else
    {
      m_waiting.append(h, list, m_stars.pool());
    }
  }

  bool improve_apex(Vertex_id v, Halfedge_id h, const typename Crossing::Apex_path& path)
  {
    geodesics::Vertex_arrival<FT> arrival;
    arrival.abscissa = path.separating_point;
    arrival.halfedge = h;
    arrival.root = path.root;
    return improve(v, path.distance, arrival, geodesics::Arrival_image<FT>{path.image_x, path.image_depth});
  }

  // Improves a vertex if d is shorter. Returns whether it did.
  bool improve(Vertex_id v, const FT& d, const geodesics::Vertex_arrival<FT>& arrival,
               const geodesics::Arrival_image<FT>& image)
  {
    const FT before = m_wavefront.distance(v);
    if(m_wavefront.improve(v, d, arrival, image, m_wavefront.reached(), emission()))
    {
      m_crossing.expect_stale_windows(true);
    }
    if(!(m_wavefront.distance(v) < before))
    {
      return false;
    }
    m_order.reach(v, d);
    return true;
  }

  // Does the path to the apex run through a corner that emits the same path? (See Star_propagation.)
  bool comes_from_corner(const typename Crossing::Apex_path& path, const geodesics::Face_frame<FT>& c) const
  {
    const auto emits = [&](Vertex_id corner, const FT& length)
    {
      return m_mesh.has(corner, Mesh::PSEUDO_SOURCE) &&
             !geodesics::is_clearly_less(path.distance, FT(m_wavefront.distance(corner) + length));
    };
    return path.separating_point <= 0 ? emits(c.origin, c.left_length)
                                      : path.separating_point >= c.length && emits(c.target, c.right_length);
  }

  geodesics::Vertex_rival<FT> rival(Vertex_id v) const
  {
    return geodesics::Vertex_rival<FT>(m_wavefront.distance(v), m_mesh.has(v, Mesh::DEGENERATE));
  }

  const Mesh& m_mesh;
  const Field& m_field;
  geodesics::Wavefront<FT> m_wavefront; // distances, and which pseudo-sources emit; its lists are not used
  Order<FT> m_order;
  Traversed_area m_area; // R
  Waiting_lists<FT> m_waiting;
  std::queue<Moving_list> m_moving; // W
  geodesics::Star_propagation<FT, Rules> m_stars; // emits windows, and owns the pool of all lists
  CGAL::Surface_mesh_geodesics::Propagation_statistics m_statistics;
  Crossing m_crossing;
  Pruning m_pruning;
  geodesics::Vertex_star<FT> m_star; // of the vertex that is visited; a buffer between visits
};

// The four systems, and FTP-List.
template <class FT, class Pruning = Neighbor_pruning>
using Ftp = Scheduled_propagation<FT, Face_order, Secondary_merger::ORDER_FREE, Pruning>;

template <class FT, class Pruning = Neighbor_pruning>
using Ftp_by_lists = Scheduled_propagation<FT, List_order, Secondary_merger::ORDER_FREE, Pruning>;

template <class FT, class Pruning = Neighbor_pruning>
using Order_preserving_ftp = Scheduled_propagation<FT, Face_order, Secondary_merger::ORDER_PRESERVING, Pruning>;

template <class FT, class Pruning = Neighbor_pruning>
using Vtp = Scheduled_propagation<FT, Vertex_order, Secondary_merger::ORDER_FREE, Pruning>;

template <class FT, class Pruning = Neighbor_pruning>
using Order_preserving_vtp = Scheduled_propagation<FT, Vertex_order, Secondary_merger::ORDER_PRESERVING, Pruning>;

} // namespace schedulers

#endif // SCHEDULED_PROPAGATION_H
