// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_PASSED_FACES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_PASSED_FACES_H

// Tells when the wavefront has passed a face, so that no later window can change anything in it: the inactive faces of
// proposition 5.1 of the thesis. Diagrams divide such faces, isolines are traced in them, and their windows are not
// needed any more.
//
// A face is passed when the wavefront has passed the distances of all points of its border. Two upper bounds of these
// distances are used. The first is the smallest distance of the windows that enter first, plus the longest side. The
// second is often smaller. It is found for each side: a point of an edge AB of length l has at most the distance
// (d(A) + d(B) + l) / 2, and where a window crosses the edge, at most the distance through this window. A face waits in
// a queue until a first guess is reached, and then until its bound at that time is reached (5.2.2).

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Radix_heap.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/single_precision.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/entering_windows.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// What is known of the distances on each side of a face, by the windows that have crossed it in either direction: an
// upper bound, rounded up; infinity if none has.
struct Side_bounds
{
  std::array<float, 3> bound{{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::infinity()}};
};

// Has a record for each face: `Record` is what its owner wants to know of a face. It may derive from Side_bounds, which
// lie beside that then. Without them, which saves memory, faces wait a little longer: the bounds by the ends of the
// sides count alone. One thread at a time may call an object. It refers to the mesh and the field.
//
// Invariant: both faces at an edge have the same bound for it (bound_by_windows()).
template <typename FT, typename Record>
class Passed_faces
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // Starts anew, with a copy of a record for each face. Takes time linear in the size of the mesh.
  void reset(const Mesh& mesh, const Field& field, const Record& record)
  {
    m_mesh = &mesh;
    m_field = &field;
    m_records.assign(mesh.number_of_faces(), record);
    m_queue.clear();
  }

  Record& operator[](Face_id f) { return m_records[f]; }
  const Record& operator[](Face_id f) const { return m_records[f]; }
  std::size_t size() const { return m_records.size(); }

  // Notes that no distance on the edge of h exceeds `bound`. Requires: records have Side_bounds.
  void set_bound(Halfedge_id h, const FT& bound)
  {
    float& known = m_records[face_of(h)].bound[index_in_face(h)];
    known = (std::min)(known, Single_precision::not_less(bound));
    const Halfedge_id o = m_mesh->opposite(h);
    if(o != null_id)
      m_records[face_of(o)].bound[index_in_face(o)] = known;
  }

  // Puts a face into the queue when the first list enters it: until the bound of proposition 5.1, with a first look
  // half a side earlier, since bound() is often smaller. A path through the nearest window, at the distance `nearest`,
  // and straight on to any point of the face is at most that long.
  void wait(Face_id f, const FT& nearest)
  {
    const FT longest = longest_side(m_mesh->face(f));
    m_queue.push(f, FT(nearest + longest / 2), FT(nearest + longest));
  }

  // Calls pass(f) for each face in the queue that the wavefront has passed, as it has reached a distance; the face
  // leaves the queue. A face with a large bound is looked at again half-way, as bounds shrink. The margin below
  // `reached` covers the error of images. `limit` is the bound of the face when it was put into the queue; the smaller
  // one of both bounds counts.
  // Requires: distances below `reached` are final.
  template <typename Pass>
  void advance(const FT& reached, Pass pass)
  {
    const FT below = reached * (1 - Tolerance<FT>::succession());
    m_queue.advance(below, [&](Face_id f, std::size_t round) { prefetch_bound(f, round); },
                    [&](Face_id f, const FT& limit)
    {
      const FT last = (std::min)(limit, bound(f));
      if(last < below)
        pass(f);
      else
        m_queue.push(f, last - below < longest_side(m_mesh->face(f)) / 4 ? last : FT(below + (last - below) / 2), last);
    });
  }

  // Frees the memory, for an owner that needs no face any more.
  void clear()
  {
    m_records = std::vector<Record>();
    m_queue = Radix_heap();
  }

  // Lets no face wait any more.
  void forget_waiting() { m_queue.clear(); }

  // Asks the processor to fetch the record of a face.
  void prefetch(Face_id f) const { internal::prefetch(&m_records[f]); }

  // The memory of the queue and of the records, in bytes.
  std::size_t memory() const { return m_queue.memory() + m_records.capacity() * sizeof(Record); }

private:
  // Fetches what bound(f) reads: first the face, then the distances of its corners. None of it is in a cache, as the
  // wavefront has gone on since f was put into the queue.
  void prefetch_bound(Face_id f, std::size_t round) const
  {
    if(round == 0)
    {
      internal::prefetch(&m_mesh->face(f));
      prefetch(f);
      return;
    }
    for(const Vertex_id corner : m_mesh->face(f).vertex)
      internal::prefetch(&m_field->distance[corner]);
  }

  // Returns a distance that no point of the border of a face exceeds, as known so far: the largest one of its sides,
  // each of which has the smaller one of two bounds. Later windows and smaller distances of the corners may only reduce
  // it. It is infinite as long as both bounds of some side are.
  FT bound(Face_id f) const
  {
    const typename Mesh::Face& face = m_mesh->face(f);
    FT largest = 0;
    for(unsigned int k = 0; k < 3; ++k)
    {
      FT side = bound_between(m_field->distance[face.vertex[k]], m_field->distance[face.vertex[next_corner(k)]],
                              face.length[k]);
      if constexpr(std::is_base_of<Side_bounds, Record>::value)
        side = (std::min)(side, FT(m_records[f].bound[k]));
      largest = (std::max)(largest, side);
    }
    return largest;
  }

  const Mesh* m_mesh = nullptr;
  const Field* m_field = nullptr;
  std::vector<Record> m_records; // by face
  Radix_heap m_queue;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_PASSED_FACES_H
