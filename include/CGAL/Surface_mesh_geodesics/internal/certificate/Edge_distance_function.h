// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_EDGE_DISTANCE_FUNCTION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_EDGE_DISTANCE_FUNCTION_H

// The distance of the points of an edge as a function of the place on the edge: the least of many functions, each
// that of straight paths from the image of a pseudo-source. It is continuous, and wherever it errs, it is too large:
// each of the functions is the length of paths that exist.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The distance on the interval [begin, end] of an edge: that of an image at (x, depth), depth >= 0, in the frame of
// the edge, to which the distance `offset` is added.
template <typename FT>
struct Distance_piece
{
  FT begin, end;
  FT x, depth, offset;

  FT at(const FT& t) const { return offset + norm<FT>(t - x, depth); }
};

// The places where the difference of two pieces may turn from growing to shrinking: at most two of them, and those
// that are not needed are NaN or outside. (The slopes are the cosines of the angles at which the images are seen;
// they are equal on a line through both images.)
template <typename FT>
std::array<FT, 2> turning_places(const FT& x, const FT& depth, const FT& other_x, const FT& other_depth)
{
  if(depth > 0 || other_depth > 0)
  {
    const FT t = (x * other_depth - other_x * depth) / (other_depth - depth);
    return {t, t};
  }
  return {x, other_x};
}

template <typename FT_>
class Edge_distance_function
{
public:
  using FT = FT_;
  using Piece = Distance_piece<FT>;

  // forgets all; nothing reaches the edge so far.
  void restart(const FT& length)
  {
    m_length = length;
    m_pieces.clear();
  }

  // The interval of a piece, between 0 and the length of the edge, is reached straight from its image, and the rest of
  // the edge by going on along it.
  void add(const Piece& piece)
  {
    add(piece, {FT(0), piece.begin, piece.begin, FT(0), piece.at(piece.begin)},
        {piece.end, m_length, piece.end, FT(0), piece.at(piece.end)});
  }

  // The same, where the places before and behind the interval are reached from other images. (Intervals that should
  // meet may be apart by rounding, and a path that is bent somewhere on its way is longer by the square of that only.)
  void add(const Piece& piece, const Piece& before, const Piece& behind)
  {
    if(!(piece.begin < piece.end))
      return;
    if(m_pieces.empty())
    {
      append_part(before, m_pieces);
      append_part(piece, m_pieces);
      append_part(behind, m_pieces);
      return;
    }
    add_part(piece);
    add_part(before);
    add_part(behind);
  }

  // from 0 to the length of the edge without gap; none if nothing reaches it.
  const std::vector<Piece>& pieces() const { return m_pieces; }

private:
  static void append_part(const Piece& part, std::vector<Piece>& pieces)
  {
    if(part.begin < part.end)
      pieces.push_back(part);
  }

  void add_part(const Piece& part)
  {
    if(!(part.begin < part.end))
      return;
    bool is_better = false;
    for(std::size_t i = 0; i < m_pieces.size() && !is_better; ++i)
      is_better = is_clearly_better(part, m_pieces[i]);
    if(!is_better)
      return;
    m_buffer.clear();
    for(const Piece& old : m_pieces)
      merge(part, old);
    m_pieces.swap(m_buffer);
  }

  static bool do_overlap(const Piece& part, const Piece& old)
  {
    return (std::max)(part.begin, old.begin) < (std::min)(part.end, old.end);
  }

  // is the part somewhere on the piece below it, by more than rounding?
  static bool is_clearly_better(const Piece& part, const Piece& old)
  {
    if(!do_overlap(part, old))
      return false;
    for(const FT& t : places(part, old))
      if(is_clearly_less<FT>(part.at(t), old.at(t)))
        return true;
    return false;
  }

  // the ends of the common interval, and between them the places where the difference turns.
  static std::array<FT, 4> places(const Piece& part, const Piece& old)
  {
    const FT begin = (std::max)(part.begin, old.begin), end = (std::min)(part.end, old.end);
    std::array<FT, 2> turn = turning_places(part.x, part.depth, old.x, old.depth);
    for(FT& t : turn)
      t = t > begin && t < end ? t : begin;
    return {begin, (std::min)(turn[0], turn[1]), (std::max)(turn[0], turn[1]), end};
  }

  // appends the lower one of both, over the interval of the old piece.
  void merge(const Piece& part, const Piece& old)
  {
    if(!is_clearly_better(part, old))
    {
      append(old, old.begin, old.end);
      return;
    }
    const std::array<FT, 4> place = places(part, old);
    append(old, old.begin, place[0]);
    for(std::size_t i = 0; i + 1 < place.size(); ++i)
      append_lower(part, old, place[i], place[i + 1]);
    append(old, place[3], old.end);
  }

  // The difference is monotone between the two places.
  void append_lower(const Piece& part, const Piece& old, const FT& first, const FT& last)
  {
    if(!(first < last))
      return;
    const bool is_lower_first = part.at(first) < old.at(first), is_lower_last = part.at(last) < old.at(last);
    if(is_lower_first == is_lower_last)
    {
      append(is_lower_first ? part : old, first, last);
      return;
    }
    FT from = first, to = last;
    for(;;)
    {
      const FT middle = from + (to - from) / 2;
      if(!(middle > from) || !(middle < to))
        break;
      const bool is_lower = part.at(middle) < old.at(middle);
      (is_lower == is_lower_first ? from : to) = middle;
    }
    append(is_lower_first ? part : old, first, to);
    append(is_lower_first ? old : part, to, last);
  }

  void append(const Piece& piece, const FT& begin, const FT& end)
  {
    if(!(begin < end))
      return;
    if(!m_buffer.empty())
    {
      Piece& last = m_buffer.back();
      if(last.x == piece.x && last.depth == piece.depth && last.offset == piece.offset)
      {
        last.end = end;
        return;
      }
    }
    m_buffer.push_back({begin, end, piece.x, piece.depth, piece.offset});
  }

  FT m_length = 0;
  std::vector<Piece> m_pieces, m_buffer;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_EDGE_DISTANCE_FUNCTION_H
