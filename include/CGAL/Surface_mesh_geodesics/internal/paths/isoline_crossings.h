// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_CROSSINGS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_CROSSINGS_H

// Where an isoline crosses an edge. Along an edge the distance is known at every point, and it is 1-Lipschitz: it
// changes by no more than the length walked. So a part of an edge between two points with known distances is either
// discarded, because it cannot hold a point of the line, or halved. Where this bound does not suffice, the convexity of
// the distances that make up the minimum is looked at (Face_distances.h). A crossing that separates nearer points from
// farther ones is found down to the resolution, whatever the number of windows is. Pairs of crossings are searched for
// only down to a coarser width, because an edge that the line touches would be halved without end. In a part of that
// width, chords find the crossing in a few steps.
//
// Rounding. Whether an edge is crossed is decided by comparing the distances of its ends with the value, never by a
// bound: an edge has an odd number of crossings if and only if its ends are on different sides. A vertex at the value,
// up to rounding, counts as farther: the crossings of its edges to nearer neighbors are the vertex itself. So what
// decides about sides is a value that is a little smaller, dividing_value(). Otherwise rounding would divide an edge
// along the line into thousands of parts on both sides of it.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The value that divides nearer points from farther ones, for the line of points at the given value.
template <typename FT>
FT dividing_value(const FT& value)
{
  return value * (1 - Tolerance<FT>::isoline_value());
}

// Returns whether a part of an edge may hold a point of the line. The part has this length, its ends the distances d
// and e. By the Lipschitz bound the distances on the part are between (d + e - length) / 2 and (d + e + length) / 2.
// Error: three epsilon of the sum. So of two crossings within that error of each other both may be missed, but none
// that separates the ends.
template <typename FT>
bool may_hold_isoline(const FT& length, const FT& d, const FT& e, const FT& value)
{
  if((d < value) != (e < value))
    return true;
  const FT nearest = (d + e - length) / 2, farthest = (d + e + length) / 2;
  return nearest < value && value <= farthest;
}

// Finds the crossings of an edge. `Distance` is a policy: distance.at(t, width) is the distance at the fraction t of
// the edge, between 0 and 1. Afterwards only points within `width` of t are asked for, until distance.go_back(mark) is
// called with the mark that distance.mark() returned before. distance.may_cross(s, t, are_nearer, value) tells whether
// a line at the value may come between two points on the same side of it.
template <typename FT, typename Distance>
class Isoline_crossings
{
public:
  // `value` is the dividing_value() of the line. Refers to the distances. The error of a crossing is at most
  // `resolution`, beyond that of the distances. Requires: resolution > 0.
  Isoline_crossings(const FT& length, const FT& value, const FT& resolution, Distance& distance)
    : m_length(length), m_value(value), m_last_at_value(value * (1 + 3 * Tolerance<FT>::isoline_value())),
      m_resolution(resolution), m_distance(distance)
  {
    CGAL_assertion(resolution > 0);
  }

  // Calls add(t) for the crossings between the positions s < t, in order. Their distances are ds and dt.
  // The recursion halves t - s, so it ends after -log2(isoline_touching()) steps.
  template <typename Add>
  void find(const FT& s, const FT& ds, const FT& t, const FT& dt, Add& add) const
  {
    CGAL_expensive_assertion(s < t);
    if(!may_hold_isoline(FT((t - s) * m_length), ds, dt, m_value))
      return;
    const bool are_nearer = ds < m_value;
    if(are_nearer == (dt < m_value) && !m_distance.may_cross(s, t, are_nearer, m_value))
      return;
    const auto mark = m_distance.mark();
    if(t - s > Tolerance<FT>::isoline_touching())
    {
      const FT middle = (s + t) / 2, dm = m_distance.at(middle, FT((t - s) / 2));
      find(s, ds, middle, dm, add);
      find(middle, dm, t, dt, add);
    }
    else if(are_nearer != (dt < m_value))
      add(crossing(s, ds, t, dt));
    m_distance.go_back(mark);
  }

private:
  // Returns a crossing between two positions on different sides of the value, in an interval that is no longer than the
  // resolution and whose ends are on different sides, too; or the farther one of the two, if it is at the value: a
  // vertex is then the same point on all of its edges.
  //
  // The chord between the ends meets the value near the crossing, as the distance is nearly linear in a short part. The
  // next position is there, or less than half of the resolution farther from the end that is nearer to it: so that end
  // and the next position will soon be on different sides of the crossing, and close to each other. Where chords do not
  // halve the interval three times, because of a bend or of rounding, it is halved from then on.
  FT crossing(FT s, FT ds, FT t, FT dt) const
  {
    if((std::max)(ds, dt) <= m_last_at_value)
      return ds < dt ? t : s;
    for(int number_of_slow_steps = 0; t - s > m_resolution;)
    {
      const FT width = t - s, overshoot = m_resolution * 7 / 16;
      FT middle = (s + t) / 2;
      if(number_of_slow_steps < 3)
      {
        const FT chord = s + (m_value - ds) / (dt - ds) * width;
        const FT next = chord - s < t - chord ? FT(chord + overshoot) : FT(chord - overshoot);
        if(s + overshoot <= next && next <= t - overshoot)
          middle = next;
      }
      const FT dm = m_distance.at(middle, width);
      const bool is_beyond = (dm < m_value) == (ds < m_value);
      (is_beyond ? s : t) = middle;
      (is_beyond ? ds : dt) = dm;
      number_of_slow_steps += t - s > width / 2 ? 1 : 0;
    }
    return ds == m_value ? s : dt == m_value ? t : FT((s + t) / 2);
  }

  FT m_length, m_value;
  FT m_last_at_value; // the largest distance that counts as at the value
  FT m_resolution;
  Distance& m_distance;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_CROSSINGS_H
