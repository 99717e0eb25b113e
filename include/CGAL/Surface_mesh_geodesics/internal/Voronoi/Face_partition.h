// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FACE_PARTITION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FACE_PARTITION_H

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
// the result is a forest with these breakpoints, and fits those of the neighbours. Fronts that numbers tell nothing
// about (two sources that tie in a region) are joined by straight pieces.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Cell_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Site_image.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Front_tracer.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Newton_refinement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A piece of the curve between two cells, from `first` to `last`; both nodes are numbers of nodes of the
// partition. It is a piece of a hyperbola or of a line.
template <typename FT>
struct Face_arc
{
  Vertex_id left_site, right_site;
  Additively_weighted_point<FT> left, right;
  Planar_point<FT> first, last;
  std::size_t first_node, last_node;
  bool is_bisector; // else it is straight whatever the points are
};

template <typename FT_>
class Face_partition
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Image = Site_image<FT>;
  using Breakpoint = Border_breakpoint<FT>;
  using Arc = Face_arc<FT>;

  // The nodes: first the breakpoints, then what has been found inside. A node inside with three sites is a
  // vertex; they are in counterclockwise order.
  struct Node
  {
    Point p;
    std::array<Vertex_id, 3> sites;
    bool is_vertex;
  };

  // Images and breakpoints (counterclockwise) are added after a call of start(), then build() is called.
  void start(const std::array<Point, 3>& corner)
  {
    m_tracer.start(corner);
    m_nodes.clear();
    m_arcs.clear();
    m_number_of_joints = 0;
  }

  void add(const Image& g) { m_tracer.add(g); }
  void add(const Breakpoint& b) { m_tracer.add(b); }

  void build()
  {
    std::vector<Front>& fronts = m_fronts;
    fronts.clear();
    for(std::size_t i = 0; i < m_tracer.breakpoints().size(); ++i)
    {
      const Breakpoint& l = m_tracer.breakpoints()[i];
      m_nodes.push_back(Node{l.p, {l.left, l.right, null_id}, false});
      fronts.emplace_back(l.left, l.right, l.p, i);
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
  const std::vector<Image>& images() const { return m_tracer.images(); }

  // how many fronts had to be joined where the numbers did not tell how.
  std::size_t number_of_joints() const { return m_number_of_joints; }

  // how often a front was followed: the cost of all this.
  std::size_t number_of_traces() const { return m_tracer.number_of_traces(); }

private:
  using Front = Cell_front<FT>;
  using Piece = Front_piece<FT>;
  using Stop = Front_stop;
  static constexpr std::size_t none = Front::none;

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
          m_tracer.trace(f, nullptr);
      if(!split(fronts) && !join_agreeing(fronts))
        join_nearest(fronts);
    }
    if(fronts.size() == 2)
    {
      find_sites(fronts);
      connect(fronts[0], fronts[1]);
    }
  }

  void find_sites(const std::vector<Front>& fronts)
  {
    std::vector<Vertex_id>& sites = m_tracer.sites();
    sites.clear();
    for(const Front& f : fronts)
      sites.push_back(f.left);
    std::sort(sites.begin(), sites.end());
  }

  // Where a cell has no width between two fronts, nothing is to be traced.
  bool connect_touching(std::vector<Front>& fronts)
  {
    for(std::size_t i = 0; i < fronts.size(); ++i)
      for(std::size_t j = i + 1; j < fronts.size(); ++j)
        if(fronts[i].left == fronts[j].right && fronts[i].right == fronts[j].left
           && distance(fronts[i].p, fronts[j].p) <= m_tracer.width())
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
    FT way = std::numeric_limits<FT>::infinity(), gap = m_tracer.joining_distance();
    for(std::size_t j = 0; j < fronts.size(); ++j)
    {
      const Front& g = fronts[j];
      if(j == i || g.left != f.right || g.right != f.left)
        continue;
      if(distance(f.p, g.p) < way && f.piece_through(g.p) != none)
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
        if(f.stop == Stop::LOST || (f.stop == Stop::SITE && !m_tracer.has_front(f.third)))
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
    return vertex_in_face(f, g, midpoint(f.end, g.end));
  }

  // do the cells of two neighbours tie at v, and is no other site nearer?
  bool is_vertex(const Front& f, const Front& g, const Point& v) const
  {
    const FT rounding = m_tracer.width() + Tolerance<FT>::tie() * distance_from(f.right, v);
    return excess_at(v, {f.left, f.right, g.right}) <= rounding;
  }

  // Of the points on the ways of two neighbours that do not meet, the one that is best for a vertex of their cells: no
  // site is nearer there than the farthest of the three, and the other way leads there, too; or nearly.
  Point best_vertex(const Front& f, const Front& g) const
  {
    Point best = f.p;
    FT smallest = std::numeric_limits<FT>::infinity();
    const auto look_at = [&](const Point& p)
    {
      const FT cost = excess_at(p, {f.left, f.right, g.right}) + f.distance_from(p) + g.distance_from(p);
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

  // how much farther the farthest of some sources is from p than the nearest one.
  FT excess_at(const Point& p, const std::array<Vertex_id, 3>& sites) const
  {
    FT nearest = std::numeric_limits<FT>::infinity(), farthest = 0;
    for(const Image& g : m_tracer.images())
      nearest = (std::min)(nearest, g.distance_to(p));
    for(const Vertex_id site : sites)
      farthest = (std::max)(farthest, distance_from(site, p));
    return farthest - nearest;
  }

  FT distance_from(Vertex_id site, const Point& p) const
  {
    const std::size_t i = m_tracer.nearest_of(site, p);
    return i != none ? m_tracer.images()[i].distance_to(p) : std::numeric_limits<FT>::infinity();
  }

  // makes a front that has not found its way to v go straight to it from the place where it was nearest.
  void lead_to(Front& f, const Point& v) const
  {
    const std::pair<std::size_t, FT> nearest = f.nearest_end(v);
    f.pieces.resize(nearest.first);
    if(!(nearest.second <= m_tracer.touching()))
      f.stop = Stop::LOST;
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
    const bool do_meet = do_agree && (distance(f.end, g.end) <= m_tracer.touching() || is_vertex(f, g, v));
    if(!do_meet)
      v = best_vertex(f, g);
    const std::size_t node = m_nodes.size();
    m_nodes.push_back(Node{v, {f.left, f.right, g.right}, true});
    for(Front* way : {&f, &g})
      if(!way->cut_at(v) && !do_meet)
        lead_to(*way, v);
    finish(f, v, node);
    finish(g, v, node);
    const Vertex_id closed = f.right;
    const Front joined(f.left, g.right, v, node);
    fronts[i] = joined;
    fronts.erase(fronts.begin() + static_cast<std::ptrdiff_t>(next));
    for(Front& h : fronts) // the cell between is closed: what met it there has to look again
      if(h.stop == Stop::LOST || (h.stop == Stop::SITE && h.third == closed))
        h.stop = Stop::NOT_TRACED;
  }

  // traces f until it reaches the beginning of g, which has the same cells on the other sides.
  void connect(Front& f, Front& g)
  {
    if(starts_at_border(f) && !starts_at_border(g)) // the border is a sure end
      return connect(g, f);
    if(distance(f.p, g.p) <= m_tracer.width()) // four cells meet in a point: there is nothing to trace
    {
      f.pieces.clear();
      f.stop = Stop::OUTSIDE;
      finish(f, g.p, g.node);
      return;
    }
    if(m_tracer.has_no_height())
    {
      finish(f, g.p, g.node);
      return;
    }
    m_tracer.sites() = {(std::min)(f.left, f.right), (std::max)(f.left, f.right)};
    Half_plane<FT> before_end;
    const bool has_direction = !starts_at_border(g) && m_tracer.line_in_front_of(g, before_end);
    m_tracer.trace(f, has_direction ? &before_end : nullptr);
    if(!(distance(f.end, g.p) <= m_tracer.touching()))
      end_at(f, g.p);
    const FT gap = distance(f.end, g.p);
    if(!(gap <= m_tracer.touching()) && comes_back(g, f))
      return finish(g, f.p, f.node);
    if(f.stop == Stop::LOST || !(gap <= m_tracer.joining_distance()))
      ++m_number_of_joints;
    if(!(gap <= m_tracer.touching()) && !f.cut_at(g.p))
      lead_to(f, g.p);
    finish(f, g.p, g.node);
  }

  // Does the way from g lead to the beginning of f?
  bool comes_back(Front& g, const Front& f)
  {
    Half_plane<FT> before_end;
    const bool has_direction = !starts_at_border(f) && m_tracer.line_in_front_of(f, before_end);
    m_tracer.trace(g, has_direction ? &before_end : nullptr);
    if(!(distance(g.end, f.p) <= m_tracer.touching()))
      end_at(g, f.p);
    return distance(g.end, f.p) <= m_tracer.touching();
  }

  // A curve along the border may have passed its end.
  void end_at(Front& f, const Point& p) const
  {
    const auto piece = std::find_if(f.pieces.begin(), f.pieces.end(),
                                    [&](const Piece& q) { return distance(q.end, p) <= m_tracer.touching(); });
    if(piece == f.pieces.end())
      return;
    f.pieces.erase(piece + 1, f.pieces.end());
    f.end = piece->end;
    f.stop = Stop::OUTSIDE;
  }

  bool starts_at_border(const Front& f) const { return f.node < m_tracer.breakpoints().size(); }

  // makes arcs of the pieces of f, the last of which ends at p.
  void finish(Front& f, const Point& p, std::size_t node)
  {
    if(is_taken_over_before(f, p))
      lead_back(f, p);
    const std::size_t number_traced = f.pieces.size();
    if(f.pieces.empty() || f.stop == Stop::LOST)
      add_straight_pieces(f, f.pieces.empty() ? f.p : f.pieces.back().end, p);
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
                           i < number_traced});
      from = to;
      from_node = to_node;
    }
  }

  // The last piece is drawn on to p, though it may have ended at some distance: places are known to the square root of
  // rounding only. Do other paths become the shortest ones in between, or where it touches the border and turns?
  bool is_taken_over_before(const Front& f, const Point& p) const
  {
    if(f.pieces.empty())
      return false;
    const Piece& last = f.pieces.back();
    return distance(last.end, p) > m_tracer.width()
        && !(is_nearest_at(f, last.left, p) && is_nearest_at(f, last.right, p));
  }

  // makes a front that ends near p, but not with the shortest paths to it, go straight from there.
  void lead_back(Front& f, const Point& p) const
  {
    const std::pair<std::size_t, FT> nearest = f.nearest_end(p);
    if(!(nearest.second <= m_tracer.touching()))
      return;
    f.pieces.resize(nearest.first);
    f.stop = Stop::LOST;
  }

  // appends the segment pq to f, divided where other paths become the shortest ones: it is halved until its pieces are
  // right at both ends, and those of the same paths are joined again.
  void add_straight_pieces(Front& f, const Point& p, const Point& q) const
  {
    std::size_t halvings = 8 * m_tracer.images().size() + 64; // rounding must not let it halve for ever
    std::vector<Point> ends{q};
    const std::size_t number_traced = f.pieces.size();
    for(Point from = p; !ends.empty();)
    {
      const Point to = ends.back();
      const Piece piece = straight_piece(f, from, to);
      if(halvings > 0 && distance(from, to) > m_tracer.width()
         && !(is_nearest_at(f, piece.left, from) && is_nearest_at(f, piece.left, to)))
      {
        --halvings;
        ends.push_back(midpoint(from, to));
        continue;
      }
      ends.pop_back();
      from = to;
      if(f.pieces.size() > number_traced && are_same(f.pieces.back(), piece))
        f.pieces.back().end = to;
      else
        f.pieces.push_back(piece);
    }
  }

  // Does an image tell the length of the shortest path of the two cells to x? (Behind the end of a cone it is less.)
  bool is_nearest_at(const Front& f, const Additively_weighted_point<FT>& image, const Point& x) const
  {
    using std::abs;
    const FT nearest = (std::min)(distance_from(f.left, x), distance_from(f.right, x));
    return abs(FT(image.distance_to(x) - nearest)) <= Tolerance<FT>::tie() * nearest + m_tracer.width();
  }

  static bool are_same(const Piece& a, const Piece& b)
  {
    const auto same = [](const Additively_weighted_point<FT>& v, const Additively_weighted_point<FT>& w)
    { return v.x == w.x && v.y == w.y && v.weight == w.weight; };
    return same(a.left, b.left) && same(a.right, b.right);
  }

  // The segment pq as a piece of f. Where two cells meet along an edge, paths of one of them may come from the other
  // face only; what is nearest along the segment stands for both then.
  Piece straight_piece(const Front& f, const Point& p, const Point& q) const
  {
    const Point middle = midpoint(p, q);
    const std::size_t l = m_tracer.nearest_of(f.left, middle), r = m_tracer.nearest_of(f.right, middle);
    Piece piece;
    piece.end = q;
    if(l != none)
      piece.left = m_tracer.image_towards(m_tracer.images()[l], middle);
    piece.right = r != none ? m_tracer.image_towards(m_tracer.images()[r], middle) : piece.left;
    if(l == none)
      piece.left = piece.right;
    const FT at_left = piece.left.distance_to(middle), at_right = piece.right.distance_to(middle);
    if(is_clearly_less(at_left, at_right))
      piece.right = piece.left;
    else if(is_clearly_less(at_right, at_left))
      piece.left = piece.right;
    return piece;
  }

  // the images of the three sites at the end of a front that meets a third one; false if the last trace has not them,
  // as a path bends there.
  bool find_images_at_end(const Front& f, std::array<Additively_weighted_point<FT>, 3>& image) const
  {
    const std::array<std::size_t, 3> number{f.left_image, f.right_image, f.third_image};
    for(std::size_t i = 0; i < 3; ++i)
    {
      if(number[i] >= m_tracer.images().size())
        return false;
      image[i] = m_tracer.images()[number[i]].point;
    }
    return true;
  }

  // Where curves run along the border of the face or touch it, the point that three images tie at is not well
  // known, and may be found outside. Then one of the points where the fronts begin or end is the vertex.
  Point vertex_in_face(const Front& f, const Front& g, const Point& near_to) const
  {
    std::array<Additively_weighted_point<FT>, 3> image;
    if(!find_images_at_end(f, image))
      return near_to;
    Point best = polished_vertex(image[0], image[1], image[2], near_to, m_tracer.size());
    if(m_tracer.is_in_face(best))
      return best;
    FT smallest = std::numeric_limits<FT>::infinity();
    for(const Point* p : {&f.end, &g.end, &f.p, &g.p})
    {
      const FT a = image[0].distance_to(*p), b = image[1].distance_to(*p), c = image[2].distance_to(*p);
      const FT difference = (std::max)({a, b, c}) - (std::min)({a, b, c});
      if(m_tracer.is_in_face(*p) && difference < smallest)
      {
        best = *p;
        smallest = difference;
      }
    }
    return best;
  }

  Front_tracer<FT> m_tracer;
  std::vector<Node> m_nodes;
  std::vector<Arc> m_arcs;
  std::vector<Front> m_fronts;
  std::vector<std::vector<Front>> m_waiting;
  std::size_t m_number_of_joints = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FACE_PARTITION_H
