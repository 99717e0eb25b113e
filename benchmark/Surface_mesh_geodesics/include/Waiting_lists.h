// The window lists on the edges of the wavefront, and the two ways to merge a list with one that waits already (thesis,
// sections 4.2.3.3 and 4.3.1).
//
// Order-preserving merger: merge(). All windows of an edge become one list, sorted by key. This is the merger of the
// package itself (Window_pool::add()). The thesis inserts each window by a binary search among the left ends of the
// intervals (OPSecondMerge, proposition 4.9). Here the order is that of the keys, which is the order of the edge
// sequences on the surface, and whole runs are merged in linear time. As in the thesis, no window is pruned until the
// list is propagated.
//
// Order-free merger: append(). The thesis puts one list behind the other in constant time (SecondMerge) and propagates
// both together, although the left ends of the intervals are not in order then. The rules for pairs of this package
// must not see such a list: where the order of two windows is wrong, they could remove one that is needed. So the late
// list waits behind the first one as a list of its own, and each of them is pruned and split alone. That takes constant
// time as well. The difference ends after one face: the children of both lists come to new edges of the wavefront in
// the same iteration, where a prime merger sorts them.

#ifndef WAITING_LISTS_H
#define WAITING_LISTS_H

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace schedulers {

// Invariant: a halfedge with late lists has a first list in m_first.
template <class FT>
class Waiting_lists
{
  using Halfedge_id = CGAL::Surface_mesh_geodesics::internal::Halfedge_id;
  using Pool = CGAL::Surface_mesh_geodesics::internal::Window_pool<FT>;

public:
  using List = CGAL::Surface_mesh_geodesics::internal::Window_list<FT>;

  explicit Waiting_lists(std::size_t number_of_faces) : m_first(number_of_faces) {}

  // Moves a list to h: the order-preserving merger. Requires: the list is not empty.
  void merge(Halfedge_id h, List& list, Pool& pool) { m_first.put(h, list, pool, m_slots); }

  // Moves a list to h: the order-free merger. Requires: the list is not empty.
  void append(Halfedge_id h, List& list, Pool& pool)
  {
    if(!m_first.has(h))
    {
      merge(h, list, pool);
      return;
    }
    m_number_of_late_windows += list.size;
    m_late[h].push_back(list);
    list = List();
  }

  // Calls visit(list) for each list that waits on h, in the order of their arrival. They do not wait any more.
  template <class Visit>
  void take(Halfedge_id h, const Visit& visit)
  {
    if(!m_first.has(h))
    {
      return;
    }
    List list;
    m_first.take(h, list, m_slots);
    visit(list);
    const auto late = m_late.find(h);
    if(late == m_late.end())
    {
      return;
    }
    for(List& l : late->second)
    {
      m_number_of_late_windows -= l.size;
      visit(l);
    }
    m_late.erase(late);
  }

  std::size_t number_of_windows() const
  {
    return static_cast<std::size_t>(m_slots.number_of_windows) + m_number_of_late_windows;
  }

private:
  CGAL::Surface_mesh_geodesics::internal::Window_lists<FT> m_first;
  CGAL::Surface_mesh_geodesics::internal::Window_list_slots m_slots;
  std::unordered_map<Halfedge_id, std::vector<List>> m_late;
  std::size_t m_number_of_late_windows = 0;
};

} // namespace schedulers

#endif // WAITING_LISTS_H
