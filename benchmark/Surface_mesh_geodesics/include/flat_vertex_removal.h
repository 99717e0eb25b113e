// For benchmark_flat_vertices: removes flat vertices from an intrinsic mesh. The surface stays the same, up to
// rounding; the mesh has fewer and larger faces, and each removed vertex becomes a point of a face.
//
// A vertex is removed together with the faces around it. They are laid out in the plane and the polygon that they fill
// is divided into triangles without the vertex (flat_star.h). The points of the old faces are found in the new ones.
//
// Rounding. Lengths of new edges and positions of points come from layouts, so each removal adds a few epsilon of the
// size of the star to the errors of the removals before. Vertices are removed in rounds, and two vertices of one round
// are not neighbors; so a face is made of faces of earlier rounds, and within a part of the mesh their number grows
// like the logarithm of the number of vertices. No edge of a face is longer than most_coarsening times an edge that has
// been removed in it, so that distances near a source keep most of their relative precision.

#ifndef FLAT_VERTEX_REMOVAL_H
#define FLAT_VERTEX_REMOVAL_H

#include "flat_star.h"

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/mesh_invariants.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace Flat_vertices {

using namespace CGAL::Surface_mesh_geodesics::internal;

// A frame of the plane: its origin and the unit vector of its x axis, in the coordinates of another frame.
template <typename FT>
struct Plane_frame
{
  Planar_point<FT> origin, axis;

  // The frame with origin a whose x axis leads to b. The axis is (1,0) if the points are equal.
  static Plane_frame from(const Planar_point<FT>& a, const Planar_point<FT>& b)
  {
    const Planar_point<FT> d{FT(b.x - a.x), FT(b.y - a.y)};
    const FT length = norm(d.x, d.y);
    return length > 0 ? Plane_frame{a, Planar_point<FT>{FT(d.x / length), FT(d.y / length)}}
                      : Plane_frame{a, Planar_point<FT>{FT(1), FT(0)}};
  }

  // A point of the other frame in this one, and the reverse.
  Planar_point<FT> coordinates(const Planar_point<FT>& p) const
  {
    const FT x = p.x - origin.x, y = p.y - origin.y;
    return Planar_point<FT>{FT(x * axis.x + y * axis.y), FT(y * axis.x - x * axis.y)};
  }
  Planar_point<FT> position(const Planar_point<FT>& q) const
  {
    return Planar_point<FT>{FT(origin.x + q.x * axis.x - q.y * axis.y), FT(origin.y + q.x * axis.y + q.y * axis.x)};
  }
};

// A triangle in the plane that becomes a face, and the frame of its layout.
template <typename FT>
struct Placed_face
{
  Face_id face;
  std::array<Planar_point<FT>, 3> corner;
  Plane_frame<FT> frame;

  // The least of the three distances from the sides, each times the length of the side: negative outside.
  FT depth(const Planar_point<FT>& p) const
  {
    return (std::min)({twice_signed_area(corner[0], corner[1], p), twice_signed_area(corner[1], corner[2], p),
                       twice_signed_area(corner[2], corner[0], p)});
  }
};

// Points are numbered in the order in which they are added. Invariant: each point is in the list of one face, or it has
// been taken out and not been placed yet.
template <typename FT>
class Points_in_faces
{
public:
  explicit Points_in_faces(std::size_t number_of_faces) : m_first(number_of_faces, null_id) {}

  bool has(Face_id f) const { return m_first[f] != null_id; }

  // Adds a point that is in no face yet.
  void add(const Planar_point<FT>& p)
  {
    m_taken.push_back(static_cast<std::uint32_t>(m_points.size()));
    m_points.push_back(Point{p, null_id});
  }

  // Takes all points of a face out, and turns their coordinates into positions: layout.position() of them.
  void take(Face_id f, const Plane_frame<FT>& layout)
  {
    for(std::uint32_t i = m_first[f]; i != null_id; i = m_points[i].next)
    {
      m_points[i].position = layout.position(m_points[i].position);
      m_taken.push_back(i);
    }
    m_first[f] = null_id;
  }

  // Places each point that has been taken out or added in the face that contains it; up to rounding, in the one that it
  // is deepest in. The range of faces is not empty.
  void place(const Placed_face<FT>* first, const Placed_face<FT>* last)
  {
    for(const std::uint32_t i : m_taken)
    {
      Point& point = m_points[i];
      const Placed_face<FT>& f = face_with(point.position, first, last);
      point.position = f.frame.coordinates(point.position);
      point.position.y = (std::max)(FT(0), point.position.y);
      point.next = m_first[f.face];
      m_first[f.face] = i;
    }
    m_taken.clear();
  }

  // Calls visit(number, position) for each point of a face.
  template <typename Visit>
  void for_each(Face_id f, Visit visit) const
  {
    for(std::uint32_t i = m_first[f]; i != null_id; i = m_points[i].next)
      visit(i, m_points[i].position);
  }

private:
  struct Point
  {
    Planar_point<FT> position; // in the layout of its face
    std::uint32_t next;        // in the list of its face
  };

  static const Placed_face<FT>& face_with(const Planar_point<FT>& p, const Placed_face<FT>* first,
                                          const Placed_face<FT>* last)
  {
    CGAL_assertion(first != last);
    const Placed_face<FT>* best = first;
    FT best_depth = -std::numeric_limits<FT>::infinity();
    for(; first != last; ++first)
    {
      const FT depth = first->depth(p);
      if(depth > best_depth)
      {
        best = first;
        best_depth = depth;
        if(depth >= 0)
          break;
      }
    }
    return *best;
  }

  std::vector<Point> m_points;
  std::vector<std::uint32_t> m_first; // by face
  std::vector<std::uint32_t> m_taken;
};

// After remove(), faces that have been removed have null_id as their first vertex, and the stars
// that the mesh stores are out of date; all other queries are valid.
template <typename FT_>
class Flat_vertex_removal
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Face = Intrinsic_face<FT>;

  explicit Flat_vertex_removal(Mesh& mesh)
    : m_mesh(mesh), m_points(mesh.number_of_faces()),
      m_finest(mesh.number_of_faces(), std::numeric_limits<float>::infinity()),
      m_last_round(mesh.number_of_vertices(), 0)
  {}

  // Keeps a vertex. Requires: remove() has not been called.
  void keep(Vertex_id v) { m_last_round[v] = never; }

  // Removes flat vertices, except pseudo-sources and those that are kept, until few are left that can be removed. Goes
  // through the mesh in parts of neighboring vertices whose faces fit into a cache, several rounds for each.
  // Takes time linear in the number of vertices, for each round.
  void remove()
  {
    const std::size_t n = m_mesh.number_of_vertices();
    for(std::size_t first = 0; first < n; first += vertices_in_part)
      remove_part(static_cast<Vertex_id>(first), static_cast<Vertex_id>((std::min)(n, first + vertices_in_part)));
  }

  // The removed vertices, by the number of their points, and the points.
  const std::vector<Vertex_id>& removed() const { return m_removed; }
  const Points_in_faces<FT>& points() const { return m_points; }

private:
  enum Result { DONE, LATER };

  static constexpr std::uint32_t never = null_id;
  static constexpr std::size_t vertices_in_part = 16384;
  static constexpr std::size_t least_part_of_round = 64;
  static constexpr float most_coarsening = 64;

  // Removes flat vertices among those from `first` on and before `last`.
  void remove_part(Vertex_id first, Vertex_id last)
  {
    m_candidates.clear();
    for(Vertex_id v = first; v < last; ++v)
      if(m_mesh.halfedge(v) != null_id && m_mesh.kind(v) == 0 && m_last_round[v] != never)
        m_candidates.push_back(v);
    for(std::size_t number = m_candidates.size(), removed = number; removed > number / least_part_of_round;)
    {
      ++m_round;
      const std::size_t before = m_removed.size();
      number = m_candidates.size();
      m_candidates.erase(std::remove_if(m_candidates.begin(), m_candidates.end(),
                                        [this](Vertex_id v)
                                        { return m_last_round[v] != m_round && try_to_remove(v) == DONE; }),
                         m_candidates.end());
      removed = m_removed.size() - before;
    }
  }

  // Removes v if it is flat and its star can be divided well. Returns LATER if that may become possible in another
  // round.
  Result try_to_remove(Vertex_id v)
  {
    if(!m_star.surround(m_mesh, v))
      return LATER;
    if(!m_star.lay_out(m_mesh))
      return DONE;
    if(m_star.number_of_corners < 3 || !m_star.has_different_corners([&](Vertex_id w)
                                                                     { return !m_mesh.has(w, Mesh::PINCHED); }))
      return DONE;
    if(!m_ears.divide(m_star.corner, m_star.number_of_corners, FT(1) / 32) || !is_fine_enough())
      return LATER;
    for(std::size_t i = 0; i < m_star.number_of_corners; ++i)
      if(m_last_round[m_star.vertex[i]] != never)
        m_last_round[m_star.vertex[i]] = m_round;
    m_removed.push_back(v);
    replace_faces();
    m_mesh.set_halfedge(v, null_id);
    return DONE;
  }

  // Is no new edge too long beside the edges that were removed in the faces around?
  bool is_fine_enough()
  {
    m_finest_of_star = static_cast<float>(m_star.shortest_spoke);
    for(std::size_t i = 0; i < m_star.number_of_faces; ++i)
      m_finest_of_star = (std::min)(m_finest_of_star, m_finest[face_of(m_star.spoke[i])]);
    const FT longest = most_coarsening * m_finest_of_star;
    for(std::size_t i = 0; i < m_ears.number_of_ears(); ++i)
    {
      const auto& e = m_ears.ear(i);
      const auto& p = m_star.corner;
      if(squared_distance_in_plane(p[e.previous], p[e.corner]) > longest * longest
         || squared_distance_in_plane(p[e.corner], p[e.next]) > longest * longest)
        return false;
    }
    return true;
  }

  // A side of the polygon that is not divided yet, from a corner to the next one.
  struct Side
  {
    FT length;
    Halfedge_id outer; // on the other side, or null_id
  };

  // Replaces the faces of m_star by m_ears.
  void replace_faces()
  {
    take_sides();
    take_points();
    std::array<Placed_face<FT>, Flat_star<FT>::most_corners> placed;
    const std::size_t n = m_ears.number_of_ears();
    for(std::size_t i = 0; i < n; ++i)
      make_face(m_ears.ear(i), face_of(m_star.spoke[i]), i + 1 == n, placed[i]);
    for(std::size_t i = n; i < m_star.number_of_faces; ++i)
      m_mesh.face(face_of(m_star.spoke[i])).vertex[0] = null_id;
    m_points.place(placed.data(), placed.data() + n);
  }

  void take_sides()
  {
    const std::size_t n = m_star.number_of_faces;
    for(std::size_t i = 0; i < n; ++i)
    {
      const Halfedge_id h = next_halfedge(m_star.spoke[i]);
      m_sides[i] = Side{m_mesh.length(h), m_mesh.opposite(h)};
    }
    if(m_star.has_border)
      m_sides[n] = Side{FT(m_mesh.length(m_star.spoke[0]) + m_mesh.length(previous_halfedge(m_star.spoke[n - 1]))),
                        null_id};
    for(std::size_t i = 0; i < m_star.number_of_corners; ++i)
      m_is_on_border[i] = m_mesh.opposite(m_mesh.halfedge(m_star.vertex[i])) == null_id;
  }

  // Takes the points out of the faces of the star, with their positions in its plane.
  void take_points()
  {
    m_points.add(Planar_point<FT>());
    for(std::size_t i = 0; i < m_star.number_of_faces; ++i)
      if(m_points.has(face_of(m_star.spoke[i])))
        m_points.take(face_of(m_star.spoke[i]), frame_of_face(i));
  }

  // Returns the layout of face i of the star, in the plane of the star.
  Plane_frame<FT> frame_of_face(std::size_t i) const
  {
    const unsigned int k = index_in_face(m_star.spoke[i]);
    const std::array<Planar_point<FT>, 3> p = layout_of_face(m_mesh.face(face_of(m_star.spoke[i])));
    const Planar_point<FT>&a = p[k], &b = p[next_corner(k)], &q = m_star.corner[i];
    const FT scale = 1 / ((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    Plane_frame<FT> frame;
    frame.axis.x = ((b.x - a.x) * q.x + (b.y - a.y) * q.y) * scale;
    frame.axis.y = ((b.x - a.x) * q.y - (b.y - a.y) * q.x) * scale;
    frame.origin.x = a.y * frame.axis.y - a.x * frame.axis.x;
    frame.origin.y = -a.x * frame.axis.y - a.y * frame.axis.x;
    return frame;
  }

  // Makes face f of an ear. Its side from `next` to `previous` becomes a side of the rest of the polygon, unless it is
  // the last one.
  void make_face(const typename Ear_clipping<FT, Flat_star<FT>::most_corners>::Ear& ear, Face_id f, bool is_last,
                 Placed_face<FT>& placed)
  {
    const std::array<std::size_t, 3> corner{ear.previous, ear.corner, ear.next};
    const Planar_point<FT>&a = m_star.corner[corner[0]], &c = m_star.corner[corner[2]];
    const std::array<Side, 3> side{
      m_sides[corner[0]], m_sides[corner[1]],
      is_last ? m_sides[corner[2]] : Side{norm(FT(a.x - c.x), FT(a.y - c.y)), null_id}};
    unsigned int shift = side[1].length < side[0].length ? 1 : 0;
    shift = side[2].length < side[shift].length ? 2 : shift;
    Face& face = m_mesh.face(f);
    placed.face = f;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const unsigned int j = corner_after(k, shift);
      placed.corner[k] = m_star.corner[corner[j]];
      face.vertex[k] = m_star.vertex[corner[j]];
      face.length[k] = side[j].length;
      link(halfedge_of(f, k), side[j].outer);
      const bool is_border = side[j].outer == null_id && (is_last || j != 2);
      if(is_border || !m_is_on_border[corner[j]])
        m_mesh.set_halfedge(face.vertex[k], halfedge_of(f, k));
    }
    placed.frame = Plane_frame<FT>::from(placed.corner[0], placed.corner[1]);
    const Planar_point<FT> apex = placed.frame.coordinates(placed.corner[2]);
    face.apex_x = apex.x;
    face.apex_y = (std::max)(FT(0), apex.y);
    m_finest[f] = m_finest_of_star;
    if(!is_last)
      m_sides[corner[0]] = Side{side[2].length, halfedge_of(f, corner_after(2, corners_to_first(shift)))};
  }

  void link(Halfedge_id h, Halfedge_id outer)
  {
    m_mesh.face(face_of(h)).opposite[index_in_face(h)] = outer;
    if(outer != null_id)
      m_mesh.face(face_of(outer)).opposite[index_in_face(outer)] = h;
  }

  Mesh& m_mesh;
  Points_in_faces<FT> m_points;
  std::vector<Vertex_id> m_removed;
  std::vector<float> m_finest;             // by face: the shortest edge at a vertex that was removed there
  std::vector<std::uint32_t> m_last_round; // by vertex: the last round that removed a neighbor, or `never`
  std::uint32_t m_round = 0;
  std::vector<Vertex_id> m_candidates; // of the part
  Flat_star<FT> m_star;                // of the vertex that is removed
  Ear_clipping<FT, Flat_star<FT>::most_corners> m_ears;
  std::array<Side, Flat_star<FT>::most_corners> m_sides;
  std::array<bool, Flat_star<FT>::most_corners> m_is_on_border;
  float m_finest_of_star = 0;
};

// Where the vertices of the former, fine mesh are: each is a vertex of the coarse mesh or a point of one of its faces.
template <typename FT>
struct Fine_vertices
{
  std::uint32_t number_of_coarse = 0; // vertices
  // By fine vertex: the coarse vertex, or the number of coarse vertices plus the number of the point.
  std::vector<std::uint32_t> entry;
  // The points of a coarse face f are those from first_point[f] on and before first_point[f + 1], in its layout.
  std::vector<std::uint32_t> first_point;
  std::vector<Planar_point<FT>> point;
};

// Removes the flat vertices of a mesh, except those in `kept`. The mesh keeps its unit and the order of its vertices;
// vertices that are pseudo-sources stay pseudo-sources. Takes linear time for each round of the removal. (The sizes of
// edge components are forgotten: tolerances are then relative to the whole mesh.)
template <typename FT>
class Flat_vertex_compaction
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Face = Intrinsic_face<FT>;

  static Fine_vertices<FT> run(Mesh& mesh, const std::vector<Vertex_id>& kept)
  {
    Flat_vertex_removal<FT> removal(mesh);
    for(const Vertex_id v : kept)
      removal.keep(v);
    removal.remove();
    Flat_vertex_compaction compaction(mesh);
    compaction.number_vertices(removal.removed());
    compaction.number_faces();
    compaction.locate(removal);
    compaction.move_faces();
    return std::move(compaction.m_fine);
  }

private:
  explicit Flat_vertex_compaction(Mesh& mesh) : m_mesh(mesh) {}

  void number_vertices(const std::vector<Vertex_id>& removed)
  {
    m_fine.entry.assign(m_mesh.number_of_vertices(), 0);
    for(const Vertex_id v : removed)
      m_fine.entry[v] = null_id;
    for(Vertex_id v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_fine.entry[v] != null_id)
      {
        m_fine.entry[v] = m_fine.number_of_coarse++;
        m_kinds.push_back(static_cast<unsigned char>(m_mesh.kind(v) & (Mesh::PSEUDO_SOURCE | Mesh::DEGENERATE)));
      }
  }

  void number_faces()
  {
    m_new_face.assign(m_mesh.number_of_faces(), null_id);
    for(Face_id f = 0; f < m_new_face.size(); ++f)
      if(m_mesh.face(f).vertex[0] != null_id)
        m_new_face[f] = m_number_of_faces++;
  }

  // Sorts the points by face.
  void locate(const Flat_vertex_removal<FT>& removal)
  {
    m_fine.first_point.reserve(m_number_of_faces + std::size_t(1));
    m_fine.point.reserve(removal.removed().size());
    for(Face_id f = 0; f < m_new_face.size(); ++f)
      if(m_new_face[f] != null_id)
      {
        std::uint32_t n = static_cast<std::uint32_t>(m_fine.point.size());
        m_fine.first_point.push_back(n);
        removal.points().for_each(f, [&](std::size_t i, const Planar_point<FT>& p)
        {
          m_fine.entry[removal.removed()[i]] = m_fine.number_of_coarse + n++;
          m_fine.point.push_back(p);
        });
      }
    m_fine.first_point.push_back(static_cast<std::uint32_t>(m_fine.point.size()));
    CGAL_assertion(m_fine.point.size() == removal.removed().size());
  }

  // Moves the faces that are left to the front, and completes the mesh. No face moves backward, so none is overwritten
  // before it has moved.
  void move_faces()
  {
    for(Face_id f = 0; f < m_new_face.size(); ++f)
      if(m_new_face[f] != null_id)
        move_face(f);
    m_mesh.reset(m_number_of_faces);
    m_mesh.finish(m_fine.number_of_coarse);
    for(Vertex_id v = 0; v < m_kinds.size(); ++v)
      m_mesh.set_kind(v, static_cast<unsigned char>(m_mesh.kind(v) | m_kinds[v]));
    // A coarse face may be bent in space. So a shortest path may cross it more than once, as if lengths were given.
    m_mesh.bound_faces_crossed_by_lengths();
    CGAL_expensive_assertion(are_invariants_kept(m_mesh));
  }

  void move_face(Face_id f)
  {
    Face face = m_mesh.face(f);
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id o = face.opposite[k];
      face.vertex[k] = m_fine.entry[face.vertex[k]];
      face.opposite[k] = o == null_id ? null_id : halfedge_of(m_new_face[face_of(o)], index_in_face(o));
    }
    m_mesh.face(m_new_face[f]) = face;
  }

  Mesh& m_mesh;
  Fine_vertices<FT> m_fine;
  std::vector<Face_id> m_new_face;
  std::vector<unsigned char> m_kinds; // by coarse vertex
  Face_id m_number_of_faces = 0;
};

// Counts the vertices that are flat and no pseudo-sources. Takes linear time.
template <typename FT>
std::size_t number_of_flat_vertices(const Intrinsic_mesh<FT>& mesh)
{
  std::size_t result = 0;
  Flat_star<FT> star;
  for(Vertex_id v = 0; v < mesh.number_of_vertices(); ++v)
    if(mesh.halfedge(v) != null_id && mesh.kind(v) == 0 && star.surround(mesh, v) && star.lay_out(mesh))
      ++result;
  return result;
}

} // namespace Flat_vertices

#endif // FLAT_VERTEX_REMOVAL_H
