// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_FACE_PARTITION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_FACE_PARTITION_H

// level: 1 (surface)
//
// The cells in a face, given where they begin and end along its border (Edge_partition.h).
//
// Sources are vertices, so each shortest path to a point of the face comes in from the border, and all of
// its points have the same source: each piece of a cell touches the border, and the curves between the cells
// are a forest whose leaves are the breakpoints of the border. The leaves are traced inwards (each is a
// front, between the cells on its left and on its right). Where the fronts of three cells meet, two of them
// with nothing between them become one; where two fronts have the same cells, they are the two ends of one
// curve, and what lies on either side of it goes on by itself.
//
// Only the sources decide which fronts may meet, numbers decide which of them do. So whatever rounding does,
// the result is a forest with these leaves, and fits those of the neighbours. Fronts that numbers tell nothing
// about (two sources that tie in a region) are joined by straight pieces.
//
// Along a front the distance is ruled by the image of one window for each of the two sources. The piece of a
// hyperbola ends where another window takes over: where it is nearer, or where the cone of straight
// paths through the window ends.

#include <CGAL/Surface_mesh_geodesics/internal/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/planar_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A point from which straight paths come into the face: a corner, or the image of a pseudo-source behind
// a window, whose paths are those through the interval from `left_end` to `right_end` as the image sees
// it. Paths to other points bend at the nearer end.
template <typename FT>
struct Face_generator
{
  Weighted_point<FT> image;
  Vertex_id site = null_id;
  bool has_cone = false;
  Half_plane<FT> left, right; // of the cone
  Planar_point<FT> left_end, right_end;

  bool sees(const Planar_point<FT>& p, const FT& tolerance = 0) const
  {
    return !has_cone || (left(p) >= -tolerance && right(p) >= -tolerance);
  }

  // the length of the shortest path through the interval.
  FT distance_to(const Planar_point<FT>& p) const
  {
    if(sees(p))
      return image.distance_to(p);
    const Planar_point<FT>& q = left(p) < 0 ? left_end : right_end;
    return image.distance_to(q) + distance(p, q);
  }
};

// A piece of the curve between two cells, from `first` to `last`; both nodes are numbers of nodes of the
// partition. It is a piece of a hyperbola or of a line.
template <typename FT>
struct Face_arc
{
  Vertex_id left_site, right_site;
  Weighted_point<FT> left, right;
  Planar_point<FT> first, last;
  std::size_t first_node, last_node;
  bool is_bisector; // else it is straight whatever the points are
};

// The sides of the cones of generators, column by column.
template <typename FT>
class Cone_columns
{
public:
  void clear()
  {
    for(std::vector<FT>& c : m_column)
      c.clear();
  }

  void add(const Face_generator<FT>& g)
  {
    const FT far_away = std::numeric_limits<FT>::infinity();
    const Half_plane<FT> everything{FT(0), FT(0), far_away};
    const Half_plane<FT> &l = g.has_cone ? g.left : everything, &r = g.has_cone ? g.right : everything;
    const std::array<FT, 6> row{l.a, l.b, l.c, r.a, r.b, r.c};
    for(std::size_t k = 0; k < 6; ++k)
      m_column[k].push_back(row[k]);
  }

  // How far each cone is from p at least, as a negative number; not negative if p is in it.
  void find_margins(const Planar_point<FT>& p, std::vector<FT>& margins) const
  {
    const std::size_t n = m_column[0].size();
    margins.resize(n);
    const FT *la = m_column[0].data(), *lb = m_column[1].data(), *lc = m_column[2].data();
    const FT *ra = m_column[3].data(), *rb = m_column[4].data(), *rc = m_column[5].data();
    FT* const m = margins.data();
    for(std::size_t i = 0; i < n; ++i)
    {
      const FT l = la[i] * p.x + lb[i] * p.y + lc[i], r = ra[i] * p.x + rb[i] * p.y + rc[i];
      m[i] = l < r ? l : r;
    }
  }

private:
  std::array<std::vector<FT>, 6> m_column;
};

template <typename FT_>
class Face_partition
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Generator = Face_generator<FT>;
  using Arc = Face_arc<FT>;

  // A breakpoint of the border, where the cell of `right` begins and that of `left` ends if the border is
  // followed counterclockwise.
  struct Leaf
  {
    Point p;
    Vertex_id left, right;
  };

  // The nodes: first the leaves, then what has been found inside. A node inside with three sites is a
  // vertex; they are in counterclockwise order.
  struct Node
  {
    Point p;
    std::array<Vertex_id, 3> sites;
    bool is_vertex;
  };

  // Generators and leaves (counterclockwise) are added after a call of start(), then build() is called.
  void start(const std::array<Point, 3>& corner)
  {
    m_corner = corner;
    m_generators.clear();
    m_cones.clear();
    m_leaves.clear();
    m_nodes.clear();
    m_arcs.clear();
    m_number_of_joints = 0;
    m_number_of_traces = 0;
    for(unsigned int k = 0; k < 3; ++k)
      m_side[k] = Half_plane<FT>::left_of(corner[k], corner[(k + 1) % 3]);
    m_size = (std::max)({distance(corner[0], corner[1]), distance(corner[1], corner[2]),
                         distance(corner[2], corner[0])});
    m_has_no_height = is_without_height<FT>(m_side[0](corner[2]) * distance(corner[0], corner[1]), m_size);
  }

  void add(const Generator& g)
  {
    m_generators.push_back(g);
    m_cones.add(g);
  }

  void add(const Leaf& leaf) { m_leaves.push_back(leaf); }

  void build()
  {
    std::vector<Front>& fronts = m_fronts;
    fronts.clear();
    for(std::size_t i = 0; i < m_leaves.size(); ++i)
    {
      const Leaf& l = m_leaves[i];
      m_nodes.push_back(Node{l.p, {l.left, l.right, null_id}, false});
      fronts.push_back(front(l.left, l.right, l.p, i));
    }
    m_waiting.clear();
    close(fronts);
    while(!m_waiting.empty())
    {
      std::vector<Front> next = std::move(m_waiting.back());
      m_waiting.pop_back();
      close(next);
    }
  }

  const std::vector<Node>& nodes() const { return m_nodes; }
  const std::vector<Arc>& arcs() const { return m_arcs; }
  const std::vector<Generator>& generators() const { return m_generators; }

  // how many fronts had to be joined where the numbers did not tell how.
  std::size_t number_of_joints() const { return m_number_of_joints; }

  // how often a front has been traced.
  std::size_t number_of_traces() const { return m_number_of_traces; }

  // the generator of a source that is nearest to p, `none` if there is none. Of several that tie one that sees
  // p is preferred.
  std::size_t nearest_of(Vertex_id site, const Point& p) const
  {
    std::size_t best = none, best_seeing = none;
    FT best_distance = std::numeric_limits<FT>::infinity(), best_seen = best_distance;
    for(std::size_t i = 0; i < m_generators.size(); ++i)
    {
      const Generator& g = m_generators[i];
      if(g.site != site)
        continue;
      const bool sees = g.sees(p, width());
      const FT d = sees ? g.image.distance_to(p) : g.distance_to(p);
      if(d < best_distance)
      {
        best = i;
        best_distance = d;
      }
      if(sees && d < best_seen)
      {
        best_seeing = i;
        best_seen = d;
      }
    }
    const bool is_tie = best_seen <= best_distance + best_distance * Tolerance<FT>::tie();
    return best_seeing != none && is_tie ? best_seeing : best;
  }

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

private:
  // A piece of the way of a front.
  struct Piece
  {
    Weighted_point<FT> left, right;
    Point end;
  };

  enum class Stop { NOT_TRACED, SITE, OUTSIDE, LOST };

  struct Front
  {
    Vertex_id left, right;
    Point p;
    std::size_t node;
    // how it goes on, if it has been traced
    Stop stop = Stop::NOT_TRACED;
    std::vector<Piece> pieces;
    Point end;
    Vertex_id third = null_id;                      // which it meets
    std::size_t last_left = none, last_right = none; // the generators at the end
    std::size_t third_generator = none;
  };

  // Ends of curves that are nearer to each other may be meant to be one.
  FT near() const { return m_size / 1024; }

  FT touching() const { return Tolerance<FT>::touching() * m_size; }

  // Distances in the face that rounding makes.
  FT width() const { return Tolerance<FT>::interval() * m_size; }

  static Front front(Vertex_id left, Vertex_id right, const Point& p, std::size_t node)
  {
    Front f;
    f.left = left;
    f.right = right;
    f.p = p;
    f.node = node;
    return f;
  }

  // joins fronts, which are in counterclockwise order, until none is left.
  void close(std::vector<Front>& fronts)
  {
    while(fronts.size() > 2)
    {
      if(connect_touching(fronts))
        continue;
      find_sites(fronts);
      for(Front& f : fronts)
        if(f.stop == Stop::NOT_TRACED)
          trace(f, nullptr);
      if(!split(fronts) && !join_agreeing(fronts))
        join_nearest(fronts);
    }
    if(fronts.size() == 2)
    {
      find_sites(fronts);
      connect(fronts[0], fronts[1]);
    }
  }

  bool has_front(Vertex_id site) const
  {
    if(m_sites.size() == 2)
      return site == m_sites[0] || site == m_sites[1];
    return std::binary_search(m_sites.begin(), m_sites.end(), site);
  }

  void find_sites(const std::vector<Front>& fronts)
  {
    m_sites.clear();
    for(const Front& f : fronts)
      m_sites.push_back(f.left);
    std::sort(m_sites.begin(), m_sites.end());
  }

  // Where a cell has no width between two fronts, nothing is to be traced.
  bool connect_touching(std::vector<Front>& fronts)
  {
    for(std::size_t i = 0; i < fronts.size(); ++i)
      for(std::size_t j = i + 1; j < fronts.size(); ++j)
        if(fronts[i].left == fronts[j].right && fronts[i].right == fronts[j].left
           && distance(fronts[i].p, fronts[j].p) <= width())
        {
          split_at(fronts, i, j);
          return true;
        }
    return false;
  }

  // a front that leads to the beginning of another one with the same sites is connected with it.
  bool split(std::vector<Front>& fronts)
  {
    for(std::size_t i = 0; i < fronts.size(); ++i)
    {
      const std::size_t j = other_end(fronts, i);
      if(j == none)
        continue;
      split_at(fronts, i, j);
      return true;
    }
    return false;
  }

  // the front through whose beginning the front i goes first; else the one at whose beginning it leaves the face.
  std::size_t other_end(const std::vector<Front>& fronts, std::size_t i) const
  {
    const Front& f = fronts[i];
    std::size_t first = none, nearest = none;
    FT way = std::numeric_limits<FT>::infinity(), gap = near();
    for(std::size_t j = 0; j < fronts.size(); ++j)
    {
      const Front& g = fronts[j];
      if(j == i || g.left != f.right || g.right != f.left)
        continue;
      if(distance(f.p, g.p) < way && piece_through(f, g.p) != none)
      {
        first = j;
        way = distance(f.p, g.p);
      }
      if(f.stop == Stop::OUTSIDE && distance(f.end, g.p) <= gap)
      {
        nearest = j;
        gap = distance(f.end, g.p);
      }
    }
    return first != none ? first : nearest;
  }

  void split_at(std::vector<Front>& fronts, std::size_t i, std::size_t j)
  {
    connect(fronts[i], fronts[j]);
    const std::size_t first = (std::min)(i, j), last = (std::max)(i, j);
    const Front* const all = fronts.data();
    std::vector<Front> inner(all + first + 1, all + last);
    std::vector<Front> outer(all + last + 1, all + fronts.size());
    outer.insert(outer.end(), all, all + first);
    // a front may have met a cell that is not in its part
    for(std::vector<Front>* part : {&inner, &outer})
    {
      find_sites(*part);
      for(Front& f : *part)
        if(f.stop == Stop::LOST || (f.stop == Stop::SITE && !has_front(f.third)))
          f.stop = Stop::NOT_TRACED;
    }
    fronts = std::move(outer);
    if(!inner.empty())
      m_waiting.push_back(std::move(inner));
  }

  // two neighbours that meet each other's other cell meet in a vertex.
  bool join_agreeing(std::vector<Front>& fronts)
  {
    const std::size_t n = fronts.size();
    std::size_t best = none;
    FT gap = std::numeric_limits<FT>::infinity();
    for(std::size_t i = 0; i < n; ++i)
    {
      const Front &f = fronts[i], &g = fronts[(i + 1) % n];
      if(!agree(f, g) || f.left == g.right)
        continue;
      const FT d = distance(f.end, g.end);
      if(d < gap)
      {
        best = i;
        gap = d;
      }
    }
    if(best == none)
      return false;
    join(fronts, best);
    return true;
  }

  // Does each of two neighbours meet the other cell of the other one?
  static bool agree(const Front& f, const Front& g)
  {
    return f.stop == Stop::SITE && g.stop == Stop::SITE && f.third == g.right && g.third == f.left;
  }

  // where two fronts meet that agree.
  Point common_end(const Front& f, const Front& g) const
  {
    const Point middle{FT((f.end.x + g.end.x) / 2), FT((f.end.y + g.end.y) / 2)};
    return vertex_in_face(f, g, equidistant_point(f, middle));
  }

  // do the cells of two neighbours tie at v, and is no other site nearer?
  bool is_vertex(const Front& f, const Front& g, const Point& v) const
  {
    return excess_at(v, {f.left, f.right, g.right}) <= width() + Tolerance<FT>::tie() * distance_from(f.right, v);
  }

  // Of the points on the ways of two neighbours that do not meet, the one that is best for a vertex of their cells: no
  // site is nearer there than the farthest of the three, and the other way leads there, too, or both as nearly as can be.
  Point best_vertex(const Front& f, const Front& g) const
  {
    Point best = f.p;
    FT smallest = std::numeric_limits<FT>::infinity();
    const auto look_at = [&](const Point& p)
    {
      const FT cost = excess_at(p, {f.left, f.right, g.right}) + distance_from_way(f, p) + distance_from_way(g, p);
      if(!(cost < smallest))
        return;
      best = p;
      smallest = cost;
    };
    for(const Front* way : {&f, &g})
    {
      look_at(way->end);
      for(const Piece& piece : way->pieces)
        look_at(piece.end);
      look_at(way->p);
    }
    return best;
  }

  // how far p is from the nearest end of a piece of a front, zero if the front leads through p.
  static FT distance_from_way(const Front& f, const Point& p)
  {
    return piece_through(f, p) != none ? FT(0) : nearest_end(f, p).second;
  }

  // how many pieces lead to the end of a piece that is nearest to p, and how far that is from p.
  static std::pair<std::size_t, FT> nearest_end(const Front& f, const Point& p)
  {
    std::pair<std::size_t, FT> nearest(0, distance(f.p, p));
    for(std::size_t i = 0; i < f.pieces.size(); ++i)
    {
      const FT d = distance(f.pieces[i].end, p);
      if(d < nearest.second)
        nearest = std::make_pair(i + 1, d);
    }
    return nearest;
  }

  // how much farther the farthest of some sources is from p than the nearest one.
  FT excess_at(const Point& p, const std::array<Vertex_id, 3>& sites) const
  {
    FT nearest = std::numeric_limits<FT>::infinity(), farthest = 0;
    for(const Generator& g : m_generators)
      nearest = (std::min)(nearest, g.distance_to(p));
    for(const Vertex_id site : sites)
      farthest = (std::max)(farthest, distance_from(site, p));
    return farthest - nearest;
  }

  FT distance_from(Vertex_id site, const Point& p) const
  {
    const std::size_t i = nearest_of(site, p);
    return i != none ? m_generators[i].distance_to(p) : std::numeric_limits<FT>::infinity();
  }

  // makes a front that has not found its way to v go straight to it from the place where it was nearest.
  void lead_to(Front& f, const Point& v) const
  {
    const std::pair<std::size_t, FT> nearest = nearest_end(f, v);
    f.pieces.resize(nearest.first);
    if(!(nearest.second <= touching()))
      f.stop = Stop::LOST;
  }

  // Where two sources nearly tie, a front may have met a third cell behind the vertex: it ends where it passes that.
  static bool cut_at(Front& f, const Point& v)
  {
    const std::size_t i = piece_through(f, v);
    if(i == none)
      return false;
    f.pieces.resize(i + 1);
    f.stop = Stop::OUTSIDE; // and is not lost
    return true;
  }

  // the piece of the way of a front that leads through v, `none` if there is none.
  static std::size_t piece_through(const Front& f, const Point& v)
  {
    using std::abs;
    Point from = f.p;
    for(std::size_t i = 0; i < f.pieces.size(); ++i)
    {
      const Piece& piece = f.pieces[i];
      const Weighted_bisector<FT> curve(piece.left, piece.right, v);
      const FT at_left = piece.left.distance_to(v), at_right = piece.right.distance_to(v);
      const Point u = curve.tangent();
      const auto along = [&](const Point& p) { return (p.x - v.x) * u.x + (p.y - v.y) * u.y; };
      if(curve.is_valid() && abs(FT(at_left - at_right)) <= Tolerance<FT>::tie() * at_left
         && along(from) <= 0 && along(piece.end) > 0)
        return i;
      from = piece.end;
    }
    return none;
  }

  // Nothing agrees: the neighbours whose ends are nearest to each other are joined.
  void join_nearest(std::vector<Front>& fronts)
  {
    ++m_number_of_joints;
    const std::size_t n = fronts.size();
    std::size_t best = 0;
    FT gap = std::numeric_limits<FT>::infinity();
    for(std::size_t i = 0; i < n; ++i)
    {
      const FT d = distance(fronts[i].end, fronts[(i + 1) % n].end);
      if(d < gap)
      {
        best = i;
        gap = d;
      }
    }
    const std::size_t next = (best + 1) % n;
    if(fronts[best].left == fronts[next].right)
      split_at(fronts, best, next);
    else
      join(fronts, best);
  }

  // joins the fronts i and i + 1 in a vertex, from which one front goes on.
  void join(std::vector<Front>& fronts, std::size_t i)
  {
    const std::size_t next = (i + 1) % fronts.size();
    Front& f = fronts[i];
    Front& g = fronts[next];
    const bool do_agree = agree(f, g);
    Point v = do_agree ? common_end(f, g) : f.p;
    const bool do_meet = do_agree && (distance(f.end, g.end) <= touching() || is_vertex(f, g, v));
    if(!do_meet)
      v = best_vertex(f, g);
    const std::size_t node = m_nodes.size();
    m_nodes.push_back(Node{v, {f.left, f.right, g.right}, true});
    for(Front* way : {&f, &g})
      if(!cut_at(*way, v) && !do_meet)
        lead_to(*way, v);
    finish(f, v, node);
    finish(g, v, node);
    const Vertex_id closed = f.right;
    const Front joined = front(f.left, g.right, v, node);
    fronts[i] = joined;
    fronts.erase(fronts.begin() + static_cast<std::ptrdiff_t>(next));
    for(Front& h : fronts) // the cell between is closed: what met it there has to look again
      if(h.stop == Stop::LOST || (h.stop == Stop::SITE && h.third == closed))
        h.stop = Stop::NOT_TRACED;
  }

  // traces f until it reaches the beginning of g, which has the same cells on the other sides.
  void connect(Front& f, Front& g)
  {
    if(is_leaf(f) && !is_leaf(g)) // the border is a sure end
      return connect(g, f);
    if(distance(f.p, g.p) <= width()) // four cells meet in a point: there is nothing to trace
    {
      f.pieces.clear();
      f.stop = Stop::OUTSIDE;
      finish(f, g.p, g.node);
      return;
    }
    if(m_has_no_height)
    {
      finish(f, g.p, g.node);
      return;
    }
    m_sites = {(std::min)(f.left, f.right), (std::max)(f.left, f.right)};
    Half_plane<FT> before_end;
    const bool has_direction = !is_leaf(g) && line_in_front_of(g, before_end);
    trace(f, has_direction ? &before_end : nullptr);
    if(!(distance(f.end, g.p) <= touching()))
      end_at(f, g.p);
    const FT gap = distance(f.end, g.p);
    if(!(gap <= touching()) && comes_back(g, f))
      return finish(g, f.p, f.node);
    if(f.stop == Stop::LOST || !(gap <= near()))
      ++m_number_of_joints;
    if(!(gap <= touching()) && !cut_at(f, g.p))
      lead_to(f, g.p);
    finish(f, g.p, g.node);
  }

  // Does the way from g lead to the beginning of f?
  bool comes_back(Front& g, const Front& f)
  {
    Half_plane<FT> before_end;
    const bool has_direction = !is_leaf(f) && line_in_front_of(f, before_end);
    trace(g, has_direction ? &before_end : nullptr);
    if(!(distance(g.end, f.p) <= touching()))
      end_at(g, f.p);
    return distance(g.end, f.p) <= touching();
  }

  // A curve along the border may have passed its end.
  void end_at(Front& f, const Point& p) const
  {
    const auto piece = std::find_if(f.pieces.begin(), f.pieces.end(),
                                    [&](const Piece& q) { return distance(q.end, p) <= touching(); });
    if(piece == f.pieces.end())
      return;
    f.pieces.erase(piece + 1, f.pieces.end());
    f.end = piece->end;
    f.stop = Stop::OUTSIDE;
  }

  bool is_leaf(const Front& f) const { return f.node < m_leaves.size(); }

  // the half-plane into which g goes.
  bool line_in_front_of(const Front& g, Half_plane<FT>& h) const
  {
    const std::size_t l = nearest_of(g.left, g.p), r = nearest_of(g.right, g.p);
    if(l == none || r == none)
      return false;
    const Weighted_bisector<FT> curve(image_towards(m_generators[l], g.p), image_towards(m_generators[r], g.p), g.p);
    if(!curve.is_valid() && !curve.is_ray())
      return false;
    const Point t = curve.tangent();
    h = Half_plane<FT>{t.x, t.y, FT(-(t.x * g.p.x + t.y * g.p.y))};
    return true;
  }

  // makes arcs of the pieces of f, the last of which ends at p.
  void finish(Front& f, const Point& p, std::size_t node)
  {
    const bool is_lost = f.pieces.empty() || f.stop == Stop::LOST;
    if(is_lost)
      f.pieces.push_back(straight_piece(f, f.pieces.empty() ? f.p : f.pieces.back().end, p));
    Point from = f.p;
    std::size_t from_node = f.node;
    for(std::size_t i = 0; i < f.pieces.size(); ++i)
    {
      const bool is_last = i + 1 == f.pieces.size();
      const Piece& piece = f.pieces[i];
      const Point to = is_last ? p : piece.end;
      std::size_t to_node = node;
      if(!is_last)
      {
        to_node = m_nodes.size();
        m_nodes.push_back(Node{to, {f.left, f.right, null_id}, false});
      }
      m_arcs.push_back(Arc{f.left, f.right, piece.left, piece.right, from, to, from_node, to_node,
                           !is_lost || !is_last});
      from = to;
      from_node = to_node;
    }
  }

  // The segment pq as a piece of f. Where two cells meet along an edge, paths of one of them may come from the other
  // face only; what is nearest along the segment stands for both then.
  Piece straight_piece(const Front& f, const Point& p, const Point& q) const
  {
    const Point middle{FT((p.x + q.x) / 2), FT((p.y + q.y) / 2)};
    const std::size_t l = nearest_of(f.left, middle), r = nearest_of(f.right, middle);
    Piece piece;
    if(l != none)
      piece.left = image_towards(m_generators[l], middle);
    piece.right = r != none ? image_towards(m_generators[r], middle) : piece.left;
    if(l == none)
      piece.left = piece.right;
    const FT at_left = piece.left.distance_to(middle), at_right = piece.right.distance_to(middle);
    if(is_clearly_less(at_left, at_right))
      piece.right = piece.left;
    else if(is_clearly_less(at_right, at_left))
      piece.left = piece.right;
    return piece;
  }

  // follows f until it meets a third cell, leaves the face, or leaves the half-plane given.
  void trace(Front& f, const Half_plane<FT>* until)
  {
    ++m_number_of_traces;
    f.pieces.clear();
    f.pieces.reserve(32);
    f.end = f.p;
    f.third = null_id;
    f.stop = m_has_no_height ? Stop::OUTSIDE : Stop::LOST;
    if(m_has_no_height) // where curves cross it is known from its border only
      return;
    f.last_left = nearest_of(f.left, f.p);
    f.last_right = nearest_of(f.right, f.p);
    if(f.last_left == none || f.last_right == none)
      return;
    m_bends.clear();
    for(std::size_t* last : {&f.last_left, &f.last_right})
      if(!m_generators[*last].sees(f.p, width()))
        *last = add_bend(*last, f.p);
    m_slack = width();
    m_left_here.clear();
    std::size_t steps = 4 * m_generators.size() + 64, steps_here = 0;
    while(f.stop == Stop::LOST && steps-- > 0)
    {
      const Point from = f.end;
      const std::size_t left_before = m_left_here.size();
      if(!step(f, until))
      {
        if(steps_here > m_generators.size() || !find_way_ahead(f))
          return;
        steps_here = m_generators.size() + 1; // once at a place
        continue;
      }
      m_slack = width();
      if(distance(from, f.end) > 16 * Tolerance<FT>::unit_roundoff() * m_size)
      {
        steps_here = 0;
        m_left_here.erase(m_left_here.begin(), m_left_here.begin() + static_cast<std::ptrdiff_t>(left_before));
      }
      else if(++steps_here > m_generators.size() + 8) // rounding goes round in circles
        return;
      if(f.stop == Stop::OUTSIDE && !ends_at_leaf(f, near()) && find_way_ahead(f)) // the curve touches the border only
        f.stop = Stop::LOST;
      else if(f.stop == Stop::LOST && ends_at_leaf(f, width())) // it runs along the border from here on
        f.stop = Stop::OUTSIDE;
    }
  }

  bool ends_at_leaf(const Front& f, const FT& tolerance) const
  {
    for(const Leaf& l : m_leaves)
      if(l.left == f.right && l.right == f.left && distance(l.p, f.end) <= tolerance)
        return true;
    return false;
  }

  // Where several generators of a source tie, rounding may have led to one that is not the nearest ahead. Is there a
  // pair of them, of both sources, with a curve into the face that does not turn back? The one that leads farthest is
  // taken. It has to lead somewhere else, but where the front begins any way is one.
  bool find_way_ahead(Front& f)
  {
    m_slack = touching();
    const std::vector<std::size_t> left = tied_generators(f.left, f.end), right = tied_generators(f.right, f.end);
    FT farthest = distance(f.p, f.end) <= width() ? width() : near();
    bool is_found = false;
    const std::size_t last_left = f.last_left, last_right = f.last_right;
    for(std::size_t l : left)
      for(std::size_t r : right)
      {
        if(l == last_left && r == last_right)
          continue;
        const FT reach = way_ahead(f.end, l, r, left, right);
        if(!(reach > farthest) || turns_back(f, l, r))
          continue;
        farthest = reach;
        is_found = true;
        f.last_left = l;
        f.last_right = r;
      }
    return is_found;
  }

  // Does the curve of two generators at the end of f lead to where f comes from?
  bool turns_back(const Front& f, std::size_t l, std::size_t r) const
  {
    if(f.pieces.empty())
      return false;
    const Point& from = f.pieces.size() > 1 ? f.pieces[f.pieces.size() - 2].end : f.p;
    const Point u = Weighted_bisector<FT>(m_generators[l].image, m_generators[r].image, f.end).tangent();
    return (f.end.x - from.x) * u.x + (f.end.y - from.y) * u.y < 0;
  }

  // the generators of a source that are as near to p as the nearest one.
  std::vector<std::size_t> tied_generators(Vertex_id site, const Point& p) const
  {
    std::vector<std::size_t> result;
    FT smallest = std::numeric_limits<FT>::infinity();
    for(const Generator& g : m_generators)
      if(g.site == site)
        smallest = (std::min)(smallest, g.distance_to(p));
    for(std::size_t i = 0; i < m_generators.size(); ++i)
      if(m_generators[i].site == site
         && m_generators[i].distance_to(p) <= smallest + Tolerance<FT>::tie() * smallest)
        result.push_back(i);
    return result;
  }

  // How far does the curve of two generators lead from p into the face, as long as none of the others is nearer?
  FT way_ahead(const Point& p, std::size_t l, std::size_t r, const std::vector<std::size_t>& left,
               const std::vector<std::size_t>& right) const
  {
    const Generator &gl = m_generators[l], &gr = m_generators[r];
    const Weighted_bisector<FT> curve(gl.image, gr.image, p);
    if(!leads_on(curve, gl, gr))
      return 0;
    Event event;
    event.t = curve.end();
    for(const Half_plane<FT>& side : m_side)
      leave(curve, side, Event::BORDER, 0, event);
    for(const Generator* g : {&gl, &gr})
      if(g->has_cone)
      {
        leave(curve, g->left, Event::LEFT_CONE, 0, event);
        leave(curve, g->right, Event::RIGHT_CONE, 0, event);
      }
    if(event.kind == Event::NOTHING)
      return 0;
    const Point ahead = curve.point((std::min)(FT(event.t / 2), FT(1) / 1024));
    const auto is_nearest = [&](const Generator& g, const std::vector<std::size_t>& others)
    {
      return std::none_of(others.begin(), others.end(), [&](std::size_t i)
      { return m_generators[i].sees(ahead) && is_nearer(m_generators[i], g, ahead); });
    };
    return is_nearest(gl, left) && is_nearest(gr, right) ? distance(curve.point(event.t), p) : FT(0);
  }

  // What ends a piece.
  struct Event
  {
    enum Kind { NOTHING, BORDER, UNTIL, LEFT_CONE, RIGHT_CONE, NEARER, IMPRECISE } kind = NOTHING;
    FT t = std::numeric_limits<FT>::infinity();
    std::size_t index = 0; // of the side or of the generator
    Half_plane<FT> line{};
    FT extent = std::numeric_limits<FT>::infinity(); // see Weighted_bisector
  };

  // Is there a curve with the cells on the sides where they should be? A ray has the generator that does not bend
  // on the side that it sees; else the front comes towards the vertex where the ray begins.
  bool leads_on(const Weighted_bisector<FT>& curve, const Generator& left, const Generator& right) const
  {
    if(!curve.is_ray())
      return curve.is_valid();
    const Point u = curve.tangent(), &p = curve.start();
    const bool is_on_left = !curve.is_left_focus();
    const FT ahead = touching(), aside = is_on_left ? ahead : FT(-ahead);
    const Point q{FT(p.x + ahead * u.x - aside * u.y), FT(p.y + ahead * u.y + aside * u.x)};
    return (is_on_left ? left : right).sees(q);
  }

  // follows one piece; false if that is impossible.
  bool step(Front& f, const Half_plane<FT>* until)
  {
    const Generator &left = generator(f.last_left), &right = generator(f.last_right);
    const Weighted_bisector<FT> curve(left.image, right.image, f.end);
    if(!leads_on(curve, left, right))
      return false;
    Event event;
    event.t = (std::min)(curve.end(), curve.end_of_precision());
    if(event.t < curve.end())
      event.kind = Event::IMPRECISE;
    for(unsigned int k = 0; k < 3; ++k)
      leave(curve, m_side[k], Event::BORDER, k, event);
    const Event at_border = event;
    if(until != nullptr)
      leave_again(curve, *until, event);
    if(left.has_cone)
    {
      leave(curve, left.left, Event::LEFT_CONE, 0, event);
      leave(curve, left.right, Event::LEFT_CONE, 1, event);
    }
    if(right.has_cone)
    {
      leave(curve, right.left, Event::RIGHT_CONE, 0, event);
      leave(curve, right.right, Event::RIGHT_CONE, 1, event);
    }
    // neighbours of the windows first: what they end need not be looked at any farther
    if(event.t < std::numeric_limits<FT>::infinity())
      event.extent = curve.extent(event.t);
    const std::size_t n = m_generators.size();
    const FT at_start = left.image.distance_to(f.end);
    const std::array<std::size_t, 4> beside{f.last_left - 1, f.last_left + 1, f.last_right - 1, f.last_right + 1};
    for(std::size_t i : beside)
      if(i < n && may_take_over(f, i))
        be_taken_over(curve, left, at_start, m_generators[i], i, event);
    m_cones.find_margins(f.end, m_margins);
    for(std::size_t i = 0; i < n; ++i)
      if(m_margins[i] >= -event.extent && !is_beside(i, f.last_left) && !is_beside(i, f.last_right)
         && may_take_over(f, i))
        be_taken_over(curve, left, at_start, m_generators[i], i, event);
    // the paths around the end of the last cone: what goes on may only seem to tie with them there
    if(!m_bends.empty() && may_take_over(f, n + m_bends.size() - 1))
    {
      const Generator last = m_bends.back();
      be_taken_over(curve, left, at_start, last, n + m_bends.size() - 1, event);
    }
    if(event.kind == Event::NOTHING)
      return false;
    if(at_border.kind == Event::BORDER && distance(curve.point(at_border.t), curve.point(event.t)) <= width())
      event = at_border;
    Point p = curve.point(event.t);
    if(!(event.t > 0))
      p = f.end;
    else if(event.kind == Event::NEARER && is_third_site(f, event.index))
    {
      const Point q = polished_vertex(left.image, right.image, generator(event.index).image, p);
      p = is_in_face(q) ? q : curve.point((std::min)(event.t, at_border.t));
    }
    else if(event.kind == Event::NEARER || event.kind == Event::IMPRECISE)
      // across the curve only: images of one source may be so near that the place is not well known
      p = polished_crossing(left.image, right.image, across(left.image, right.image, p), p);
    else
      p = polished_crossing(left.image, right.image, event.line, p);
    f.pieces.push_back(Piece{left.image, right.image, p});
    f.end = p;
    switch(event.kind)
    {
    case Event::LEFT_CONE:
      f.last_left = successor(f.last_left, f.last_right, p);
      break;
    case Event::RIGHT_CONE:
      f.last_right = successor(f.last_right, f.last_left, p);
      break;
    case Event::NEARER:
      meet(f, event.index);
      break;
    case Event::IMPRECISE:
      break;
    default:
      f.stop = Stop::OUTSIDE;
    }
    return true;
  }

  bool is_third_site(const Front& f, std::size_t index) const
  {
    const Vertex_id site = generator(index).site;
    return site != f.left && site != f.right;
  }

  void meet(Front& f, std::size_t index)
  {
    const Vertex_id site = generator(index).site;
    if(!is_third_site(f, index))
    {
      std::size_t& last = site == f.left ? f.last_left : f.last_right;
      m_left_here.push_back(last);
      last = index;
    }
    else
    {
      f.stop = Stop::SITE;
      f.third = site;
      f.third_generator = index;
    }
  }

  // The curve leaves a half-plane at the first parameter behind which it is outside.
  void leave(const Weighted_bisector<FT>& curve, const Half_plane<FT>& h, typename Event::Kind kind,
             std::size_t index, Event& event) const
  {
    const Quadratic<FT> q = curve.side(h);
    if(event.t < std::numeric_limits<FT>::infinity() && q.is_positive_until(event.t))
      return;
    const std::array<FT, 2> root = q.positive_roots();
    FT from = 0;
    for(unsigned int i = 0; i < 3; ++i)
    {
      const FT to = i < 2 ? (std::min)(root[i], event.t) : event.t;
      if(from < to)
      {
        const FT middle = to < std::numeric_limits<FT>::infinity() ? FT(from + (to - from) / 2)
                                                                    : FT(2 * from + 1);
        // a front that starts on the line may be outside by rounding, and so may one that touches it
        const bool may_be_rounding = !(from > 0) || (i == 1 && to < event.t);
        if(q(middle) < 0 && (!may_be_rounding || h(curve.point(middle)) < -(from > 0 ? width() : m_slack)))
        {
          if(from < event.t)
          {
            event.kind = kind;
            event.t = from;
            event.index = index;
            event.line = h;
          }
          return;
        }
      }
      if(!(to < event.t))
        return;
      from = to;
    }
  }

  static bool is_beside(std::size_t i, std::size_t j) { return i + 1 - j <= 2; } // or the same

  bool may_take_over(const Front& f, std::size_t i) const
  {
    return i != f.last_left && i != f.last_right && has_front(generator(i).site);
  }

  // The same for the half-plane in front of the end: a front that starts outside enters it first.
  void leave_again(const Weighted_bisector<FT>& curve, const Half_plane<FT>& until, Event& event) const
  {
    if(until(curve.start()) >= -width())
      return leave(curve, until, Event::UNTIL, 0, event);
    const FT t = curve.side(until).positive_roots()[1];
    if(!(t < event.t))
      return;
    event.kind = Event::UNTIL;
    event.t = t;
    event.line = until;
  }

  // Is g nearer somewhere ahead, where it sees the curve? `at_start` is the distance by `left` at the start.
  void be_taken_over(const Weighted_bisector<FT>& curve, const Generator& left, const FT& at_start, const Generator& g,
                     std::size_t index, Event& event)
  {
    // first what can be told from the start p of the curve
    const Point& p = curve.start();
    const FT to_g = norm<FT>(p.x - g.image.x, p.y - g.image.y);
    if(g.image.weight + to_g > at_start + 2 * event.extent)
      return;
    Quadratic<FT> in_left{}, in_right{};
    const bool is_bounded = event.t < std::numeric_limits<FT>::infinity();
    if(g.has_cone)
    {
      in_left = curve.side(g.left);
      if(is_bounded && in_left.is_negative_until(event.t))
        return;
      in_right = curve.side(g.right);
      if(is_bounded && in_right.is_negative_until(event.t))
        return;
    }
    const Quadratic<FT> nearer = curve.nearer(g.image, to_g);
    if(is_bounded && nearer.is_negative_until(event.t))
      return;
    m_roots.clear();
    add_roots(nearer, event.t);
    if(m_roots.empty() && !(nearer((std::min)(FT(1), FT(event.t / 2))) > 0))
      return;
    if(g.has_cone)
    {
      add_roots(in_left, event.t);
      add_roots(in_right, event.t);
    }
    std::sort(m_roots.begin(), m_roots.end());
    const FT last = event.t < std::numeric_limits<FT>::infinity()
                      ? event.t
                      : FT(m_roots.empty() ? FT(1) : FT(2 * m_roots.back() + 1));
    m_roots.push_back(last);
    // at the start rounding may lead away from a generator, and once back
    const bool has_been_left = std::count(m_left_here.begin(), m_left_here.end(), index) > 1;
    FT from = 0;
    for(const FT& to : m_roots)
    {
      if(from < to)
      {
        const FT middle = from + (to - from) / 2;
        if((from > 0 || !has_been_left) && nearer(middle) > 0
           && (!g.has_cone || (in_left(middle) > 0 && in_right(middle) > 0))
           && is_nearer(g, left, curve.point(middle)) && distance(curve.point(from), curve.point(to)) > width())
        {
          if(from < event.t)
          {
            event.kind = Event::NEARER;
            event.t = from;
            event.index = index;
            event.extent = curve.extent(from);
          }
          return;
        }
        from = to;
      }
    }
  }

  void add_roots(const Quadratic<FT>& q, const FT& before)
  {
    if(before < std::numeric_limits<FT>::infinity() && q.is_positive_until(before))
      return;
    for(const FT& r : q.positive_roots())
      if(r < before)
        m_roots.push_back(r);
  }

  static bool is_nearer(const Generator& g, const Generator& c, const Point& p)
  {
    return g.image.distance_to(p) < c.image.distance_to(p) * (1 - 4 * Tolerance<FT>::distance());
  }

  bool has_been_left_here(std::size_t i) const
  {
    return std::find(m_left_here.begin(), m_left_here.end(), i) != m_left_here.end();
  }

  // The generator of the same source that goes on where the cone of generator i ends: one that is as near, or,
  // where rounding has left a gap between the cones, the end of the interval.
  std::size_t successor(std::size_t i, std::size_t other, const Point& p)
  {
    m_left_here.push_back(i);
    const Generator g = generator(i);
    const FT at_p = g.image.distance_to(p);
    const FT tolerance = width();
    std::size_t best = none;
    FT best_distance = at_p + at_p * Tolerance<FT>::tie();
    for(std::size_t j = 0; j < m_generators.size(); ++j)
    {
      const Generator& next = m_generators[j];
      if(j == i || j == other || next.site != g.site || !next.sees(p, tolerance))
        continue;
      const FT d = next.image.distance_to(p);
      if(d < best_distance && !has_been_left_here(j))
      {
        best = j;
        best_distance = d;
      }
    }
    const std::size_t at_end = add_bend(i, p);
    return best != none ? best : at_end;
  }

  // Paths from a generator to points beyond its cone bend at the end of the interval that is nearer to p.
  static Generator bend(const Generator& g, const Point& p)
  {
    Generator result;
    const Point& q = g.left(p) < g.right(p) ? g.left_end : g.right_end;
    result.image = Weighted_point<FT>{q.x, q.y, g.image.distance_to(q)};
    result.site = g.site;
    return result;
  }

  std::size_t add_bend(std::size_t i, const Point& p)
  {
    m_bends.push_back(bend(generator(i), p));
    return m_generators.size() + m_bends.size() - 1;
  }

  // the image of the shortest paths from a generator to p.
  Weighted_point<FT> image_towards(const Generator& g, const Point& p) const
  {
    return g.sees(p, width()) ? g.image : bend(g, p).image;
  }

  const Generator& generator(std::size_t i) const
  {
    return i < m_generators.size() ? m_generators[i] : m_bends[i - m_generators.size()];
  }

  Point equidistant_point(const Front& f, const Point& v) const
  {
    if(f.last_left >= m_generators.size() || f.last_right >= m_generators.size())
      return v;
    return polished_vertex(m_generators[f.last_left].image, m_generators[f.last_right].image,
                           m_generators[f.third_generator].image, v);
  }

  // Where curves run along the border of the face or touch it, the point that three generators tie at is not well
  // known, and may be found outside. Then one of the points where the fronts begin or end is the vertex.
  Point vertex_in_face(const Front& f, const Front& g, const Point& v) const
  {
    if(is_in_face(v) || f.last_left >= m_generators.size() || f.last_right >= m_generators.size())
      return v;
    Point best = v;
    FT smallest = std::numeric_limits<FT>::infinity();
    for(const Point* p : {&f.end, &g.end, &f.p, &g.p})
    {
      const FT a = m_generators[f.last_left].image.distance_to(*p);
      const FT b = m_generators[f.last_right].image.distance_to(*p);
      const FT c = m_generators[f.third_generator].image.distance_to(*p);
      const FT difference = (std::max)({a, b, c}) - (std::min)({a, b, c});
      if(is_in_face(*p) && difference < smallest)
      {
        best = *p;
        smallest = difference;
      }
    }
    return best;
  }

  bool is_in_face(const Point& p) const
  {
    return std::all_of(m_side.begin(), m_side.end(), [&](const Half_plane<FT>& h) { return h(p) >= -width(); });
  }

  // Newton's method for f(p) = g(p) = 0, as long as it helps; `size` is that of the distances. f is the difference of
  // the distances from two generators. If they are near to each other, f tells nothing about the place on a line that
  // points away from them, and g decides it alone.
  template <typename Residuals>
  Point polished(Point p, const FT& size, Residuals residuals) const
  {
    using std::abs;
    const FT precision = Tolerance<FT>::unit_roundoff() * (size + m_size);
    std::array<FT, 6> r = residuals(p); // the values, and their gradients
    for(int i = 0; i < 4 && abs(r[0]) + abs(r[1]) > precision; ++i)
    {
      const FT n = norm<FT>(r[2], r[3]);
      if(!(n > 0))
        return p;
      const Point across{FT(r[2] / n), FT(r[3] / n)}, along{FT(-across.y), across.x};
      const FT slope = r[4] * along.x + r[5] * along.y;
      if(!(abs(slope) > Tolerance<FT>::angle()))
        return p;
      const FT x = n > Tolerance<FT>::closeness() ? FT(-r[0] / n) : FT(0);
      const FT y = -(r[1] + x * (r[4] * across.x + r[5] * across.y)) / slope;
      const Point q{FT(p.x + x * across.x + y * along.x), FT(p.y + x * across.y + y * along.y)};
      const std::array<FT, 6> s = residuals(q);
      if(!(abs(s[0]) + abs(s[1]) < abs(r[0]) + abs(r[1])) || distance(p, q) > m_size / (1 << 20))
        return p;
      p = q;
      r = s;
    }
    return p;
  }

  Point polished_vertex(const Weighted_point<FT>& a, const Weighted_point<FT>& b,
                        const Weighted_point<FT>& c, const Point& p) const
  {
    return polished(p, a.distance_to(p), [&](const Point& q)
    {
      const Point ua = direction(a, q), ub = direction(b, q), uc = direction(c, q);
      const FT d = a.distance_to(q);
      return std::array<FT, 6>{FT(d - b.distance_to(q)), FT(d - c.distance_to(q)), FT(ua.x - ub.x),
                               FT(ua.y - ub.y), FT(ua.x - uc.x), FT(ua.y - uc.y)};
    });
  }

  Point polished_crossing(const Weighted_point<FT>& a, const Weighted_point<FT>& b,
                          const Half_plane<FT>& h, const Point& p) const
  {
    return polished(p, a.distance_to(p), [&](const Point& q)
    {
      const Point ua = direction(a, q), ub = direction(b, q);
      return std::array<FT, 6>{FT(a.distance_to(q) - b.distance_to(q)), h(q), FT(ua.x - ub.x),
                               FT(ua.y - ub.y), h.a, h.b};
    });
  }

  // the line through p across the curve of two generators.
  static Half_plane<FT> across(const Weighted_point<FT>& a, const Weighted_point<FT>& b, const Point& p)
  {
    const Point ua = direction(a, p), ub = direction(b, p);
    const FT x = ua.y - ub.y, y = ub.x - ua.x, n = norm(x, y);
    return n > 0 ? Half_plane<FT>{FT(x / n), FT(y / n), FT(-(x * p.x + y * p.y) / n)}
                 : Half_plane<FT>{FT(0), FT(0), FT(0)};
  }

  static Point direction(const Weighted_point<FT>& from, const Point& to)
  {
    const FT dx = to.x - from.x, dy = to.y - from.y, n = norm(dx, dy);
    return n > 0 ? Point{FT(dx / n), FT(dy / n)} : Point();
  }

  std::array<Point, 3> m_corner;
  std::array<Half_plane<FT>, 3> m_side;
  FT m_size = 0;
  bool m_has_no_height = false;
  FT m_slack = 0; // how far a front may start outside the half-planes that it is to leave
  std::vector<Generator> m_generators, m_bends;
  std::vector<Leaf> m_leaves;
  std::vector<Node> m_nodes;
  std::vector<Arc> m_arcs;
  std::vector<Vertex_id> m_sites; // that the fronts have, sorted
  Cone_columns<FT> m_cones;
  std::vector<FT> m_margins; // of the generators at the beginning of a piece
  std::vector<std::size_t> m_left_here; // generators that a front went over from, so that it does not go round
  std::vector<FT> m_roots;
  std::vector<Front> m_fronts;
  std::vector<std::vector<Front>> m_waiting;
  std::size_t m_number_of_joints = 0;
  std::size_t m_number_of_traces = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_FACE_PARTITION_H
