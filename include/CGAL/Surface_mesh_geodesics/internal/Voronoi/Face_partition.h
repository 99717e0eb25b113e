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

// Divides a face into cells, given where the cells begin and end along its border (Edge_partition.h).
//
// Sites are vertices, so that each shortest path to a point of the face comes in from the border and stays in one cell.
// So every piece of a cell touches the border, and the curves between the cells are a forest whose leaves are the
// breakpoints of the border. A front (fronts/Cell_front.h) is traced into the face from each breakpoint. Where the
// fronts of three cells meet, the two with nothing between them are joined in a vertex, and one front goes on. Two
// fronts between the same two cells are the two ends of one curve; they are connected, and the parts of the face on
// both sides of it are closed on their own.
//
// Only the sites decide which fronts may meet; distances decide which of them do. So regardless of rounding, the result
// is a forest with these leaves and matches those of the adjacent faces. Where rounding hides how fronts meet (two
// sites tie in a region), segments join them.
//
// Steps: build() starts the fronts, close() reduces a list of them until none is left: connect_touching(), split() and
// split_at() connect two fronts, join_agreeing(), join_nearest() and join() join them. connect() finds the curve
// between two fronts, finish() makes arcs of a front.
//
// Formula: the points of an arc are equally far from its two images, and no other image is nearer.
// Frame: the layout of the face (corners 0, 1 and 2 at (0,0), (length[0],0) and (apex_x,apex_y)).
// Ties: of several pairs of fronts, the two whose ends are closest to each other are joined first, the first pair if
// that ties, too. Error: no bound is known; tests compare distances on arcs with a tolerance of 1e-10.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Cell_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Face_images.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Front_completion.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Front_meeting.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Front_partners.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Front_tracer.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A piece of the curve between two cells of a face, from `first` to `last` with the cell of left_site on the left: part
// of the bisector of two images, or a segment. The nodes are indices in the nodes of the face.
template <typename FT>
struct Face_arc
{
  Vertex_id left_site, right_site;
  Additively_weighted_point<FT> left, right;
  Planar_point<FT> first, last;
  std::size_t first_node, last_node;
  bool is_bisector; // otherwise the arc is straight, whatever the two images are
};

// A point where arcs end. Of a vertex, where three cells meet, the sites are in counterclockwise order; other nodes
// have two sites, and null_id: the cells on the left and on the right of the front that starts at the node or runs
// through it.
template <typename FT>
struct Face_node
{
  Planar_point<FT> p;
  std::array<Vertex_id, 3> sites;
  bool is_vertex;
};

// What a Face_partition finds: a forest. Its first nodes are the breakpoints of the border, in their order.
template <typename FT>
struct Face_division
{
  std::vector<Face_node<FT>> nodes;
  std::vector<Face_arc<FT>> arcs;

  // How often fronts were joined or connected although no traced curve leads from one to the other.
  std::size_t number_of_joints = 0;
};

// Use: start(), add() for images and breakpoints, build(), then the queries. An object serves many faces.
//
// Invariant of a list of fronts, which bounds one part of the face: its fronts are in counterclockwise order, and each
// one has on its right the cell that the next one has on its left, the last one that of the first one. build()
// establishes it from the breakpoints, and split_at() and join() keep it: a connection removes the two ends of one
// curve and leaves two such lists; a joint replaces two adjacent fronts by one. So the last two fronts of a list are
// the ends of one curve, a single front is never left, as its two cells would be the same, and every list becomes empty
// after fewer steps than it has fronts, whatever the distances are.
//
// Cost: at most quadratic in the number of breakpoints, counted in traces (Front_tracer::trace()); a face that one
// curve crosses needs one trace. There are at most as many steps as breakpoints. A step takes time linear in the number
// of fronts; where it searches for many partners, it also sorts the fronts by their sites.
template <typename FT_>
class Face_partition
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Image = Site_image<FT>;
  using Breakpoint = Border_breakpoint<FT>;
  using Arc = Face_arc<FT>;

  using Node = Face_node<FT>;

  // Starts a face, given its corners, and removes the results of the one before. Then images are added, and breakpoints
  // in counterclockwise order; then build() is called.
  void start(const std::array<Point, 3>& corner)
  {
    m_tracer.start(corner);
    m_division.nodes.clear();
    m_division.arcs.clear();
    m_division.number_of_joints = 0;
  }

  void add(const Image& image) { m_tracer.add(image); }
  void add(const Breakpoint& b) { m_tracer.add(b); }

  // Makes the nodes and arcs. Requires: the cell that begins at a breakpoint is the one that ends at the next one; at
  // each breakpoint, the two cells differ. (So there are two breakpoints at least, or none.)
  void build()
  {
    CGAL_assertion(do_breakpoints_match());
    std::vector<Front>& fronts = m_fronts;
    fronts.clear();
    for(std::size_t i = 0; i < m_tracer.breakpoints().size(); ++i)
    {
      const Breakpoint& b = m_tracer.breakpoints()[i];
      m_division.nodes.push_back(Node{b.p, {b.left, b.right, null_id}, false});
      fronts.emplace_back(b.left, b.right, b.p, i);
    }
    m_waiting.clear();
    m_may_touch = true;
    close(fronts);
    while(!m_waiting.empty())
    {
      Part next = std::move(m_waiting.back());
      m_waiting.pop_back();
      m_may_touch = next.may_touch;
      close(next.fronts);
    }
    CGAL_expensive_assertion(is_forest());
  }

  // The result, valid until start().
  const Face_division<FT>& division() const { return m_division; }

  const std::vector<Node>& nodes() const { return m_division.nodes; }
  const std::vector<Arc>& arcs() const { return m_division.arcs; }
  const std::vector<Image>& images() const { return m_tracer.images().all(); }
  std::size_t number_of_joints() const { return m_division.number_of_joints; }

  // Returns how many traces have been made: the cost of the partition.
  std::size_t number_of_traces() const { return m_tracer.number_of_traces(); }

private:
  using Front = Cell_front<FT>;
  using Piece = Front_piece<FT>;
  using Stop = Front_stop;

  // A part of the face that is still to be closed.
  struct Part
  {
    std::vector<Front> fronts;
    bool may_touch; // two of them may start at one point
  };

  static constexpr std::size_t none = Front::none;

  const Face_images<FT>& images_of_face() const { return m_tracer.images(); }
  Front_meeting<FT> meeting() const { return Front_meeting<FT>(images_of_face()); }
  Front_completion<FT> completion() const { return Front_completion<FT>(images_of_face()); }

  // --- contracts ---

  // Returns whether the cells along the border follow each other.
  bool do_breakpoints_match() const
  {
    const std::vector<Breakpoint>& all = m_tracer.breakpoints();
    for(std::size_t i = 0; i < all.size(); ++i)
      if(all[i].right != all[(i + 1) % all.size()].left)
        return false;
    return true;
  }

  // Returns whether one arc ends at each breakpoint, two at each other node of two sites, and three at each vertex.
  bool is_forest() const
  {
    std::vector<std::size_t> degree(m_division.nodes.size(), 0);
    for(const Arc& a : m_division.arcs)
    {
      ++degree[a.first_node];
      ++degree[a.last_node];
    }
    for(std::size_t i = 0; i < m_division.nodes.size(); ++i)
      if(degree[i] != (m_division.nodes[i].is_vertex ? 3u : i < m_tracer.breakpoints().size() ? 1u : 2u))
        return false;
    return true;
  }

  // --- closing a part of the face ---

  // Joins and connects the fronts of a list until none is left. Parts that a connection cuts off go to m_waiting.
  //
  // What is surest comes first: fronts that start at one point, then curves that lead from one front to another, then
  // fronts that meet in one vertex, then the pair with the closest ends.
  void close(std::vector<Front>& fronts)
  {
    while(fronts.size() > 2)
    {
      m_partners.restart();
      if(m_may_touch && connect_touching(fronts))
        continue;
      trace_all(fronts);
      if(!split(fronts) && !join_agreeing(fronts))
        join_nearest(fronts);
    }
    if(fronts.size() == 2)
    {
      find_sites(fronts);
      connect(fronts[0], fronts[1]);
    }
  }

  // Traces the fronts of a list that have no result that counts.
  void trace_all(std::vector<Front>& fronts)
  {
    const auto is_missing = [](const Front& f) { return f.stop == Stop::NOT_TRACED; };
    if(std::none_of(fronts.begin(), fronts.end(), is_missing))
      return;
    find_sites(fronts);
    for(Front& f : fronts)
      if(is_missing(f))
        m_tracer.trace(f, nullptr);
  }

  // Tells the tracer the sites of some fronts: in this part of the face, no trace meets the cell of another site. By
  // the invariant of a list, the sites on the left are all of them. (One that has several pieces in this part occurs
  // several times, which does no harm.)
  void find_sites(const std::vector<Front>& fronts)
  {
    std::vector<Vertex_id>& sites = m_tracer.sites();
    sites.clear();
    for(const Front& f : fronts)
      sites.push_back(f.left);
    std::sort(sites.begin(), sites.end());
  }

  // Connects the first two fronts that start at one point, if there are any: a cell between them has no width, and
  // there is nothing to trace, unless it is a wedge. If there are none, no further step has to look for them until a
  // new front starts in a joint, unless there are wedges: their sides may become ends of one curve.
  bool connect_touching(std::vector<Front>& fronts)
  {
    bool has_wedges = false;
    for(std::size_t i = 0; i < fronts.size(); ++i)
    {
      const std::size_t j = m_partners.first(fronts, i, i + 1, [&](std::size_t k)
      {
        if(!(distance(fronts[i].p, fronts[k].p) <= images_of_face().width()))
          return false;
        const bool is_wedge = is_beside_wedge(fronts, i, k);
        has_wedges = has_wedges || is_wedge;
        return !is_wedge;
      });
      if(j == fronts.size())
        continue;
      split_at(fronts, i, j);
      return true;
    }
    m_may_touch = has_wedges;
    return false;
  }

  // Are two fronts that start at one point the sides of a wedge, and not the ends of one curve? A corner may belong to
  // a site, and both edges there to another one that is as near to the corner: then points to which paths bend at the
  // corner are the cell of the site that has it. Its sides are rays, each of which leads to the start of another front.
  bool is_beside_wedge(std::vector<Front>& fronts, std::size_t i, std::size_t j)
  {
    const Vertex_id between = j == i + 1 ? fronts[i].right : fronts[j].right;
    const auto is_corner = [&](const Image& g)
    {
      return !g.has_cone && g.site == between
          && distance(Point{g.point.x, g.point.y}, fronts[i].p) <= images_of_face().width();
    };
    if((j != i + 1 && i + fronts.size() != j + 1) || std::none_of(images().begin(), images().end(), is_corner))
      return false;
    find_sites(fronts);
    return leads_to_third(fronts, i, j) && leads_to_third(fronts, j, i);
  }

  // Does front i lead to the start of a front that is not front j?
  bool leads_to_third(std::vector<Front>& fronts, std::size_t i, std::size_t j)
  {
    if(fronts[i].stop == Stop::NOT_TRACED)
      m_tracer.trace(fronts[i], nullptr);
    const std::size_t other = other_end(fronts, i);
    return other != none && other != j;
  }

  // Connects the first front that leads to the start of another one with the same sites, if there is one. Returns
  // whether there is.
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

  // Returns the front through whose start front i leads first, otherwise the closest one to where it leaves the face,
  // otherwise `none`.
  std::size_t other_end(const std::vector<Front>& fronts, std::size_t i)
  {
    const Front& f = fronts[i];
    std::size_t first = none, nearest = none;
    FT way = std::numeric_limits<FT>::infinity(), gap = images_of_face().joining_distance();
    m_partners.first(fronts, i, 0, [&](std::size_t j)
    {
      const Front& g = fronts[j];
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
      return false; // look at all of them
    });
    return first != none ? first : nearest;
  }

  // Connects the fronts i and j. Leaves the fronts on one side of that curve, and lets those on the other side wait.
  // Fronts that have met a cell that is not in their part are traced again, and so are those that rounding has stopped:
  // with fewer sites they may find their way. Requires: they are partners (Front_partners.h).
  void split_at(std::vector<Front>& fronts, std::size_t i, std::size_t j)
  {
    connect(fronts[i], fronts[j]);
    const std::size_t first = (std::min)(i, j), last = (std::max)(i, j);
    const auto all = std::make_move_iterator(fronts.begin());
    const auto at = [&](std::size_t k) { return all + static_cast<std::ptrdiff_t>(k); };
    std::vector<Front> inner(at(first + 1), at(last));
    std::vector<Front> outer(at(last + 1), at(fronts.size()));
    outer.insert(outer.end(), all, at(first));
    for(std::vector<Front>* part : {&inner, &outer})
    {
      if(std::any_of(part->begin(), part->end(), [](const Front& f) { return f.stop == Stop::SITE; }))
        find_sites(*part);
      for(Front& f : *part)
        if(f.stop == Stop::LOST || (f.stop == Stop::SITE && !m_tracer.has_site(f.third)))
          f.stop = Stop::NOT_TRACED;
    }
    fronts = std::move(outer);
    if(!inner.empty())
      m_waiting.push_back(Part{std::move(inner), m_may_touch});
  }

  // Joins the two adjacent fronts that agree and whose ends are closest to each other, if any agree. (Adjacent fronts
  // with f.left == g.right are the two ends of one curve, which have no vertex in common.)
  bool join_agreeing(std::vector<Front>& fronts)
  {
    const std::size_t n = fronts.size();
    std::size_t best = none;
    FT gap = std::numeric_limits<FT>::infinity();
    for(std::size_t i = 0; i < n; ++i)
    {
      const Front &f = fronts[i], &g = fronts[(i + 1) % n];
      if(!Front_meeting<FT>::agree(f, g) || f.left == g.right)
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

  // Joins or connects the two adjacent fronts whose ends are closest to each other: the last resort, where two sites
  // tie in a region.
  void join_nearest(std::vector<Front>& fronts)
  {
    ++m_division.number_of_joints;
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

  // Joins the fronts i and i + 1 (cyclically) in a vertex, from which one front goes on. The cell between them is
  // closed; fronts that have met it are traced again. The sites of the vertex are in counterclockwise order because f
  // and g are.
  //
  // If the traces meet up to rounding, both end in the vertex. Otherwise the vertex is chosen among points of both
  // traces, and each front is cut at it or led to it by segments.
  // Requires: f.left != g.right, as the front that goes on separates these two; both fronts have been traced.
  void join(std::vector<Front>& fronts, std::size_t i)
  {
    const std::size_t next = (i + 1) % fronts.size();
    Front& f = fronts[i];
    Front& g = fronts[next];
    const bool do_agree = Front_meeting<FT>::agree(f, g);
    Point v = do_agree ? meeting().common_end(f, g) : f.p;
    const bool do_meet
      = do_agree && (distance(f.end, g.end) <= images_of_face().touching() || meeting().is_vertex(f, g, v));
    if(!do_meet)
      v = meeting().best_vertex(f, g);
    const std::size_t node = m_division.nodes.size();
    m_division.nodes.push_back(Node{v, {f.left, f.right, g.right}, true});
    for(Front* front : {&f, &g})
      if(!completion().cut_at(*front, v) && !do_meet)
        completion().lead_to(*front, v);
    finish(f, v, node);
    finish(g, v, node);
    const Vertex_id closed = f.right;
    const Front joined(f.left, g.right, v, node);
    m_may_touch = true;
    fronts[i] = joined;
    fronts.erase(fronts.begin() + static_cast<std::ptrdiff_t>(next));
    for(Front& h : fronts)
      if(h.stop == Stop::LOST || (h.stop == Stop::SITE && h.third == closed))
        h.stop = Stop::NOT_TRACED;
  }

  // --- one curve from end to end ---

  // Connects two fronts that are the ends of one curve. Traces toward a point of the border if there is one, since the
  // border is a sure end; traces back if the trace misses it. The way back counts only if it arrives, or meets the
  // trace.
  void connect(Front& f, Front& g)
  {
    if(starts_at_border(f) && !starts_at_border(g))
      return connect(g, f);
    if(distance(f.p, g.p) <= images_of_face().width()) // four cells meet in a point: there is nothing to trace
    {
      f.pieces.clear();
      f.stop = Stop::OUTSIDE;
      return finish(f, g.p, g.node);
    }
    if(images_of_face().has_no_height())
      return finish(f, g.p, g.node);
    m_tracer.sites() = {(std::min)(f.left, f.right), (std::max)(f.left, f.right)};
    const FT gap = trace_to(f, g);
    const bool is_touching = gap <= images_of_face().touching();
    if(!is_touching && trace_to(g, f) <= images_of_face().touching()) // the way back is the better one
      return finish(g, f.p, f.node);
    if(!is_touching && meet_on_the_way(f, g))
      return;
    if(f.stop == Stop::LOST || !(gap <= images_of_face().joining_distance()))
      ++m_division.number_of_joints;
    if(!is_touching && !completion().cut_at(f, g.p))
      completion().lead_to(f, g.p);
    finish(f, g.p, g.node);
  }

  // Traces f toward the start of g, which is the other end of its curve, up to the line across the curve there.
  // Returns the distance that remains.
  FT trace_to(Front& f, const Front& g)
  {
    Half_plane<FT> before_end;
    const bool has_direction = !starts_at_border(g) && m_tracer.find_half_plane_ahead(g, before_end);
    m_tracer.trace(f, has_direction ? &before_end : nullptr);
    if(!(distance(f.end, g.p) <= images_of_face().touching()))
      completion().end_at(f, g.p);
    return distance(f.end, g.p);
  }

  // Connects the two ends of a curve where their traces have a point in common, if they have one. Both traces may miss
  // the other end: where four cells meet in a point, a trace may go on between the wrong two, and where a cell ends in
  // a point, none may turn. (Two ends that touch bound a cell without width, whose sides run along each other.)
  // Requires: both have been traced.
  bool meet_on_the_way(Front& f, Front& g)
  {
    const FT tolerance = images_of_face().touching();
    if(distance(f.p, g.p) <= tolerance)
      return false;
    for(const Front* front : {&f, &g})
      for(const Piece& piece : front->pieces)
      {
        const std::size_t i = f.piece_to(piece.end, tolerance), j = g.piece_to(piece.end, tolerance);
        if(i == none || j == none)
          continue;
        const Point p = piece.end; // a copy, as pieces are dropped
        const std::size_t node = m_division.nodes.size();
        m_division.nodes.push_back(Node{p, {f.left, f.right, null_id}, false});
        completion().end_in_piece(f, i, p);
        completion().end_in_piece(g, j, p);
        finish(f, p, node);
        finish(g, p, node);
        return true;
      }
    return false;
  }

  // The border is a sure end: a front that starts there has the node of a breakpoint.
  bool starts_at_border(const Front& f) const { return f.node < m_tracer.breakpoints().size(); }

  // Makes arcs of the pieces of f, the last of which ends at p, and a node between two of them. Pieces that are added
  // here are segments, those that have been traced are bisectors. `node` is the node at p; f is not needed afterwards.
  //
  // The last piece is drawn on to p, if other paths do not become the shortest ones before. Segments follow the last
  // piece where f has lost its way (LOST), and are the whole curve if f has no pieces.
  void finish(Front& f, const Point& p, std::size_t node)
  {
    if(completion().is_taken_over_before(f, p))
      completion().lead_back(f, p);
    const std::size_t number_traced = f.pieces.size();
    if(f.pieces.empty() || f.stop == Stop::LOST)
      completion().add_straight_pieces(f, f.pieces.empty() ? f.p : f.pieces.back().end, p);
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
        to_node = m_division.nodes.size();
        m_division.nodes.push_back(Node{to, {f.left, f.right, null_id}, false});
      }
      const bool is_bisector = i < number_traced;
      m_division.arcs.push_back(Arc{f.left, f.right, piece.left, piece.right, from, to, from_node, to_node,
                                    is_bisector});
      from = to;
      from_node = to_node;
    }
  }

  Front_tracer<FT> m_tracer; // owns the images and breakpoints of the face
  Face_division<FT> m_division;
  std::vector<Front> m_fronts; // the list that build() begins with; a member, so that its memory is kept
  Front_partners<FT> m_partners; // of the list that close() works on; restarted in each step
  bool m_may_touch = true; // two fronts of this list may start at one point
  std::vector<Part> m_waiting;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FACE_PARTITION_H
