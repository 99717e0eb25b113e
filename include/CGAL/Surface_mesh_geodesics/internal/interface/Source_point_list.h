// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SOURCE_POINT_LIST_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SOURCE_POINT_LIST_H

// The source points of `Surface_mesh_geodesic_paths`, in the order in which they were added, and the iterators to them.
//
// Queries answer with the source points of the last build. So the list keeps a source point that has been removed until
// the next build: until then its iterator may be dereferenced. Iterators to other source points stay valid.
// Two lists hold the source points, those that count and those that have been removed since the last build. A std::list
// moves an element from one to the other without touching iterators, also those that users hold.
//
// Neither type is checked: FaceLocation and VertexDescriptor are only copied.

#include <CGAL/assertions.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <list>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A source point as the user gave it. A vertex may be invalid, even null; so a flag says that it was given as one. A
// curve counts as a source point, too: its location is the first one of the curve. The list does not know the class of
// curves, nor the solver, so a function object has both.
template <typename FaceLocation, typename VertexDescriptor>
struct Source_point
{
  FaceLocation location;   // of a vertex: a corner of a face around it
  bool is_vertex;
  VertexDescriptor vertex; // if is_vertex
  std::function<void()> add_curve = nullptr; // hands the curve to the solver; null for a point
  bool is_removed = false; // the list keeps it until the next build
};

template <typename FaceLocation, typename VertexDescriptor>
class Source_point_list;

// The iterator that users get. It shows the location only. After its source point has been removed, it may be
// dereferenced and compared until the next build, but neither ++ nor -- leads back to the list.
template <typename FaceLocation, typename VertexDescriptor>
class Source_point_iterator
{
  using Underlying = typename std::list<Source_point<FaceLocation, VertexDescriptor>>::const_iterator;

public:
  using iterator_category = std::bidirectional_iterator_tag;
  using value_type = FaceLocation;
  using difference_type = std::ptrdiff_t;
  using pointer = const FaceLocation*;
  using reference = const FaceLocation&;

  Source_point_iterator() = default;

  reference operator*() const { return m_iterator->location; }
  pointer operator->() const { return &m_iterator->location; }

  Source_point_iterator& operator++()
  {
    ++m_iterator;
    return *this;
  }

  Source_point_iterator operator++(int) { return Source_point_iterator(m_iterator++); }

  Source_point_iterator& operator--()
  {
    --m_iterator;
    return *this;
  }

  Source_point_iterator operator--(int) { return Source_point_iterator(m_iterator--); }

  bool operator==(const Source_point_iterator& other) const { return m_iterator == other.m_iterator; }
  bool operator!=(const Source_point_iterator& other) const { return m_iterator != other.m_iterator; }

private:
  friend class Source_point_list<FaceLocation, VertexDescriptor>;

  explicit Source_point_iterator(Underlying iterator) : m_iterator(iterator) {}

  Underlying m_iterator{};
};

// Takes constant time for all functions but clear() and set_built(), which are linear in the number of source
// points. Not safe for threads by itself; Lazy_path_structure.h says who calls what when.
//
// The number of a source point is its position in the list at the last build, at which the solver has got the source
// points in the same order.
template <typename FaceLocation, typename VertexDescriptor>
class Source_point_list
{
public:
  using Source = Source_point<FaceLocation, VertexDescriptor>;
  using Iterator = Source_point_iterator<FaceLocation, VertexDescriptor>;

  // The source points that have not been removed, in the order of addition.
  Iterator begin() const { return Iterator(m_sources.begin()); }
  Iterator end() const { return Iterator(m_sources.end()); }
  std::size_t size() const { return m_sources.size(); }
  const std::list<Source>& sources() const { return m_sources; }

  // Appends a source point. Takes constant time.
  Iterator add(const Source& source) { return Iterator(m_sources.insert(m_sources.end(), source)); }

  // Removes a source point, in constant time. Returns false if it has been removed already.
  // Requires: `it` is an iterator to a source point that has not been removed. (The test stays where preconditions are
  // off: a second removal would splice from the wrong list.)
  bool remove(Iterator it)
  {
    CGAL_precondition_msg(!it.m_iterator->is_removed, "the source point has been removed already");
    if(it.m_iterator->is_removed)
      return false;
    m_removed.splice(m_removed.begin(), m_sources, it.m_iterator);
    m_removed.front().is_removed = true;
    return true;
  }

  // Frees all source points, those that have been removed as well. All iterators but end() become invalid.
  void clear()
  {
    m_sources.clear();
    m_removed.clear();
    m_by_number.clear();
  }

  // Ends a build: numbers the source points, and frees those that have been removed. Leaves begin(), end() and size()
  // alone, so other threads may read them meanwhile. If it throws std::bad_alloc, numbers are missing, so the caller
  // must not count the build.
  void set_built()
  {
    m_by_number.clear();
    for(auto it = m_sources.cbegin(); it != m_sources.cend(); ++it)
      m_by_number.push_back(Iterator(it));
    m_removed.clear();
  }

  // Returns the source point with a number that the last build has given.
  // Requires: number < size() at that build.
  Iterator by_number(std::size_t number) const
  {
    CGAL_assertion(number < m_by_number.size());
    return m_by_number[number];
  }

private:
  std::list<Source> m_sources;
  std::list<Source> m_removed;       // since the last build
  std::vector<Iterator> m_by_number; // in the last build
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SOURCE_POINT_LIST_H
