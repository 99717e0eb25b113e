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

// An upper bound of the distance on an edge, as a function of the abscissa. It is the minimum over families of paths;
// the paths of a family lead straight from one image of a pseudo-source to an interval of the edge, or along parallel
// rays from a curve. The function is continuous up to rounding, and never less than the distance because all these
// paths exist.
//
// Use: restart() for an edge, add() for each family of paths, pieces() for the result. add() takes the minimum with
// three parts: the family over its interval, and on either side of it paths that go on from there. add_part() finds out
// whether a part is better anywhere, merge() and append_lower() put it into the sequence.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The distance on the interval [begin, end] of an edge: the distance from an image at (x, -depth) in the frame of the
// edge, plus `offset`, the length of the path up to the image. The depth is not negative, up to rounding. The image may
// be on either side of the edge: distances on the edge are the same. x need not be in the interval.
//
// The image of a curve is infinitely far away (`is_linear`): rays come from it in the direction (x, depth), a unit
// vector, and the distance is a linear function, which has the value `offset` at the abscissa 0.
template <typename FT>
struct Distance_piece
{
  FT begin, end;
  FT x, depth, offset;
  bool is_linear = false;

  // The value at the abscissa t.
  FT at(const FT& t) const { return is_linear ? FT(offset + x * t) : FT(offset + norm<FT>(t - x, depth)); }

  // The abscissa of the interval at which the value is least.
  FT nearest() const
  {
    return is_linear ? (x > 0 ? begin : end) : (std::min)((std::max)(x, begin), end);
  }

  // The same piece as seen from the other end of an edge of this length.
  Distance_piece backward(const FT& length) const
  {
    if(is_linear)
      return {length - end, length - begin, -x, depth, offset + x * length, true};
    return {length - end, length - begin, length - x, depth, offset, false};
  }
};

// Does one look at the middle of an interval show that a piece is greater there everywhere than another one? Each of
// both functions changes by at most the length of the way. A margin covers rounding. Most comparisons end here.
template <typename FT>
bool is_greater_everywhere(const Distance_piece<FT>& piece, const Distance_piece<FT>& other, const FT& begin,
                           const FT& end)
{
  const FT middle = begin + (end - begin) / 2, value = other.at(middle);
  return piece.at(middle) - value > (end - begin) + Tolerance<FT>::gap() * value;
}

// Returns the abscissas where the difference of the distances from two images may turn from growing to shrinking. There
// are at most two; those that do not exist are NaN or lie outside.
//
// The slope of a distance is the cosine of the angle between the edge and the line to the image. Two slopes are equal
// where the edge meets the line through both images, at the abscissa t with
// (t - x) / depth = (t - other_x) / other_depth. It does not exist if the depths are equal. An image on the edge has
// the slopes -1 and 1 on its two sides, so that the difference turns at the image itself; if only one of both is there,
// the formula gives its abscissa.
template <typename FT>
std::array<FT, 2> turning_points(const FT& x, const FT& depth, const FT& other_x, const FT& other_depth)
{
  if(depth > 0 || other_depth > 0)
  {
    const FT t = (x * other_depth - other_x * depth) / (other_depth - depth);
    return {t, t};
  }
  return {x, other_x};
}

// The same for two pieces, whatever their images are. A linear function has the slope x. The other slope, the cosine of
// the angle between the edge and the line to the image, equals it where this line has the direction of the rays. Two
// linear functions differ by a linear one.
template <typename FT>
std::array<FT, 2> turning_points(const Distance_piece<FT>& p, const Distance_piece<FT>& q)
{
  if(!p.is_linear && !q.is_linear)
    return turning_points(p.x, p.depth, q.x, q.depth);
  if(p.is_linear && q.is_linear)
    return {p.begin, p.begin};
  const Distance_piece<FT>&rays = p.is_linear ? p : q, &other = p.is_linear ? q : p;
  const FT t = other.depth > 0 ? FT(other.x + other.depth * (rays.x / rays.depth)) : other.x;
  return {t, t};
}

// The function on one edge, as a sequence of pieces.
//
// Invariant between calls: there are no pieces, or they cover [0, length] without gaps and overlaps, each with a length
// (do_pieces_cover_edge()). add() keeps it: the first three parts cover the edge, and merge() replaces a piece by
// pieces over the same interval. So the function never grows, up to rounding.
// Ties: the piece that came first stays; a new one has to be clearly less somewhere (is_clearly_less()). That makes the
// bound larger by rounding at most, and keeps the number of pieces small.
template <typename FT_>
class Edge_distance_function
{
public:
  using FT = FT_;
  using Piece = Distance_piece<FT>;

  // Begins an edge of this length that nothing reaches.
  void restart(const FT& length)
  {
    m_length = length;
    m_pieces.clear();
  }

  // Adds the paths of a piece, and those that go on from the ends of its interval along the edge: distances from an
  // image at the end itself, at depth 0.
  // Requires: 0 <= piece.begin and piece.end <= length, unless the interval is empty. Takes time linear in the number
  // of pieces at worst; logarithmic, plus linear in that of pieces in the interval, if the piece is nowhere better.
  //
  // The function grows by no more than the length of the way. So where it is not greater than the piece at its begin,
  // the paths that go on from there are not less anywhere; the same holds at the end.
  void add(const Piece& piece)
  {
    if(!(piece.begin < piece.end))
      return;
    CGAL_assertion(piece.begin >= 0 && piece.end <= m_length);
    const auto is_better = [&](const FT& value, const FT& t)
    { return m_pieces.empty() || is_clearly_less<FT>(value, piece_at(t)->at(t)); };
    const FT at_begin = piece.at(piece.begin), at_end = piece.at(piece.end);
    // (A part without length adds nothing.)
    add(piece, {FT(0), is_better(at_begin, piece.begin) ? piece.begin : FT(0), piece.begin, FT(0), at_begin},
        {is_better(at_end, piece.end) ? piece.end : m_length, m_length, piece.end, FT(0), at_end});
  }

  // Adds the paths of a piece, and other paths to the points before and behind its interval: [0, before.end] and
  // [behind.begin, length], which meet the interval. Intervals of neighboring windows may leave a gap by rounding;
  // paths that bend at an end of a window close it, as they are longer by no more than the square of the gap. Adds
  // nothing if the interval of the piece is empty, not even the other paths.
  void add(const Piece& piece, const Piece& before, const Piece& behind)
  {
    if(!(piece.begin < piece.end))
      return;
    CGAL_expensive_assertion(piece.depth >= 0);
    if(m_pieces.empty())
    {
      append_part(before, m_pieces);
      append_part(piece, m_pieces);
      append_part(behind, m_pieces);
    }
    else
    {
      add_part(piece);
      add_part(before);
      add_part(behind);
    }
    CGAL_expensive_assertion(do_pieces_cover_edge());
  }

  // The pieces cover the edge from 0 to its length without gaps. There are no pieces if nothing reaches the edge.
  const std::vector<Piece>& pieces() const { return m_pieces; }

private:
  bool do_pieces_cover_edge() const
  {
    FT end = 0;
    for(const Piece& p : m_pieces)
    {
      if(p.begin != end || !(p.begin < p.end))
        return false;
      end = p.end;
    }
    return end == m_length;
  }

  // Appends a part unless its interval is empty.
  static void append_part(const Piece& part, std::vector<Piece>& pieces)
  {
    if(part.begin < part.end)
      pieces.push_back(part);
  }

  // Returns an iterator to the piece with an abscissa of the edge; of two pieces that meet there, the first one.
  typename std::vector<Piece>::iterator piece_at(const FT& t)
  {
    return std::lower_bound(m_pieces.begin(), m_pieces.end(), t,
                            [](const Piece& p, const FT& abscissa) { return p.end < abscissa; });
  }

  // Takes the minimum with a part of the function. Does nothing if the part is not clearly better anywhere.
  void add_part(const Piece& part)
  {
    if(!(part.begin < part.end))
      return;
    const auto begins_before = [](const Piece& p, const FT& abscissa) { return p.begin < abscissa; };
    const auto first = piece_at(part.begin), last = std::lower_bound(first, m_pieces.end(), part.end, begins_before);
    if(std::none_of(first, last, [&](const Piece& old) { return is_clearly_better(part, old); }))
      return;
    // The neighbors join pieces of their image, as append() does.
    m_buffer.clear();
    const auto from = first == m_pieces.begin() ? first : first - 1, to = last == m_pieces.end() ? last : last + 1;
    for(auto old = from; old != to; ++old)
      merge(part, *old);
    const auto rest = m_pieces.erase(from, to);
    m_pieces.insert(rest, m_buffer.begin(), m_buffer.end());
  }

  // Is the part less than the old piece somewhere in their common interval, by more than rounding? The difference is
  // monotone between breakpoints, so that it is enough to look at these.
  static bool is_clearly_better(const Piece& part, const Piece& old)
  {
    const FT begin = (std::max)(part.begin, old.begin), end = (std::min)(part.end, old.end);
    if(!(begin < end) || is_greater_everywhere(part, old, begin, end))
      return false;
    for(const FT& t : breakpoints(part, old))
      if(is_clearly_less<FT>(part.at(t), old.at(t)))
        return true;
    return false;
  }

  // Returns the ends of the common interval, and in order between them the turning points of the difference. Between
  // two neighbors the difference is monotone. A turning point outside is replaced by the first end.
  static std::array<FT, 4> breakpoints(const Piece& part, const Piece& old)
  {
    const FT begin = (std::max)(part.begin, old.begin), end = (std::min)(part.end, old.end);
    std::array<FT, 2> turn = turning_points(part, old);
    for(FT& t : turn)
      t = t > begin && t < end ? t : begin;
    return {begin, (std::min)(turn[0], turn[1]), (std::max)(turn[0], turn[1]), end};
  }

  // Appends the lower one of both to the buffer, over the interval of the old piece.
  void merge(const Piece& part, const Piece& old)
  {
    if(!is_clearly_better(part, old))
    {
      append(old, old.begin, old.end);
      return;
    }
    const std::array<FT, 4> t = breakpoints(part, old);
    append(old, old.begin, t[0]);
    for(std::size_t i = 0; i + 1 < t.size(); ++i)
      append_lower(part, old, t[i], t[i + 1]);
    append(old, t[3], old.end);
  }

  // Does the same between two breakpoints. The difference is monotone there: if one of both is lower at both ends, it
  // is so in between; the old piece counts as lower in a tie. Otherwise the functions cross once. Where both are equal
  // is found by bisection down to neighboring numbers: both are evaluated as they will be later, so that rounding does
  // not separate the test from the result.
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

  // Appends an interval of a piece to the buffer; joins it with the last interval if that is of the same image.
  // Requires: the interval begins where the last one ends, unless it is empty.
  void append(const Piece& piece, const FT& begin, const FT& end)
  {
    if(!(begin < end))
      return;
    if(!m_buffer.empty())
    {
      Piece& last = m_buffer.back();
      if(last.x == piece.x && last.depth == piece.depth && last.offset == piece.offset
         && last.is_linear == piece.is_linear)
      {
        last.end = end;
        return;
      }
    }
    m_buffer.push_back({begin, end, piece.x, piece.depth, piece.offset, piece.is_linear});
  }

  FT m_length = 0;
  // The buffer takes the pieces that change while add_part() reads the old ones; otherwise its content means nothing.
  std::vector<Piece> m_pieces, m_buffer;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_EDGE_DISTANCE_FUNCTION_H
