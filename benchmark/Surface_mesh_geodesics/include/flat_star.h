// For benchmark_flat_vertices: the faces around a vertex, laid out in one plane. If their angles add up to 2 pi, or to
// pi on the border, the star is a plane polygon, and the vertex can be removed without changing the surface. The
// polygon is then divided into triangles without it.

#ifndef FLAT_STAR_H
#define FLAT_STAR_H

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace Flat_vertices {

using namespace CGAL::Surface_mesh_geodesics::internal;

// The vertex is at the origin, and the first corner on the positive x axis. Corner i is the target of spoke i; corners
// are numbered counterclockwise. The star of a vertex on the border has one corner more than faces.
//
// Error: each position errs by a few epsilon of the longest spoke for each face before it, as lay_out() turns and
// scales by a quotient of rounded numbers.
template <typename FT>
struct Flat_star
{
  static constexpr std::size_t most_faces = 8;
  static constexpr std::size_t most_corners = most_faces + 1;

  // How much the angles around a flat vertex may miss 2 pi, or pi on the border. Relative to 1, and, multiplied by the
  // longest spoke, relative to the extent of the mesh.
  //
  // Removing a vertex with the excess d, none of whose spokes is longer than r, moves the curvature d by at most r.
  // That changes the length of a path through the star by about d r at most. With the second tolerance, this is less
  // than what crossing one face adds to the error of an image (Tolerance::distance()); with the first one, it is also
  // small beside the length of a path that crosses the star from side to side, which matters near a source.
  static FT angle_tolerance() { return 64 * Tolerance<FT>::epsilon(); }
  static FT shift_tolerance() { return 2 * Tolerance<FT>::epsilon(); }

  std::size_t number_of_faces = 0, number_of_corners = 0;
  bool has_border = false;
  std::array<Halfedge_id, most_faces> spoke;         // the halfedge of face i that leaves the vertex
  std::array<Vertex_id, most_corners> vertex;        // at the corners
  std::array<Planar_point<FT>, most_corners> corner;
  FT shortest_spoke = 0, longest_spoke = 0;
  FT excess = 0; // absolute difference of the total angle and 2 pi, or pi on the border, if it is small

  // Finds the spokes of a vertex. Returns whether there are at most most_faces of them.
  // Requires: v has exactly one umbrella.
  bool surround(const Intrinsic_mesh<FT>& mesh, Vertex_id v)
  {
    const Halfedge_id first = mesh.halfedge(v);
    CGAL_assertion(first != null_id);
    Halfedge_id h = first;
    number_of_faces = 0;
    do
    {
      if(number_of_faces == most_faces)
        return false;
      spoke[number_of_faces++] = h;
      h = mesh.next_around_source(h);
    } while(h != first && h != null_id);
    has_border = h == null_id;
    number_of_corners = number_of_faces + (has_border ? 1 : 0);
    return true;
  }

  // Lays out the faces. Returns whether the vertex is flat (is_excess_negligible()). Requires: surround() has returned
  // true; the total angle is not greater than 2 pi, or pi on the border, by more than rounding; the spokes have
  // lengths.
  bool lay_out(const Intrinsic_mesh<FT>& mesh)
  {
    using std::abs;
    Planar_point<FT> p{mesh.length(spoke[0]), FT(0)};
    shortest_spoke = longest_spoke = p.x;
    for(std::size_t i = 0; i < number_of_faces; ++i)
    {
      const Intrinsic_face<FT>& face = mesh.face(face_of(spoke[i]));
      const unsigned int k = index_in_face(spoke[i]);
      corner[i] = p;
      vertex[i] = face.vertex[next_corner(k)];
      add_length(face.length[previous_corner(k)]);
      p = turned(p, face, k);
    }
    if(has_border)
    {
      corner[number_of_faces] = p;
      vertex[number_of_faces] = mesh.source(previous_halfedge(spoke[number_of_faces - 1]));
    }
    const FT along = has_border ? FT(-p.x) : p.x;
    excess = along > 0 ? FT(abs(p.y) / along) : FT(1);
    return is_excess_negligible(mesh.extent_around(face_of(spoke[0])));
  }

  // Are the vertices at the corners different from each other, and do they satisfy a condition?
  template <typename Condition>
  bool has_different_corners(Condition condition) const
  {
    for(std::size_t i = 0; i < number_of_corners; ++i)
      if(!condition(vertex[i]) || std::find(vertex.begin(), vertex.begin() + i, vertex[i]) != vertex.begin() + i)
        return false;
    return true;
  }

private:
  bool is_excess_negligible(const FT& extent) const
  {
    return excess <= angle_tolerance() && excess * longest_spoke <= shift_tolerance() * extent;
  }

  void add_length(const FT& length)
  {
    shortest_spoke = (std::min)(shortest_spoke, length);
    longest_spoke = (std::max)(longest_spoke, length);
  }

  // Returns the end of the next spoke: p turned by the angle at corner k of a face, and scaled to the length of that
  // spoke.
  static Planar_point<FT> turned(const Planar_point<FT>& p, const Intrinsic_face<FT>& face, unsigned int k)
  {
    const std::pair<FT, FT> w = angle_direction(face, k);
    const FT scale = 1 / (face.length[k] * face.length[k]);
    const FT c = w.first * scale, s = w.second * scale;
    return Planar_point<FT>{FT(p.x * c - p.y * s), FT(p.x * s + p.y * c)};
  }
};

// Twice the signed area of a triangle, positive if it is counterclockwise.
template <typename FT>
FT twice_signed_area(const Planar_point<FT>& a, const Planar_point<FT>& b, const Planar_point<FT>& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

template <typename FT>
FT squared_distance_in_plane(const Planar_point<FT>& a, const Planar_point<FT>& b)
{
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

// The quality of a triangle: twice the area relative to the sum of the squares of the sides. At most
// 1 / (2 sqrt(3)) = 0.289, for an equilateral triangle; negative if the triangle is clockwise.
template <typename FT>
struct Triangle_quality
{
  FT area, squares; // twice the area, and the sum

  Triangle_quality() {}
  Triangle_quality(const Planar_point<FT>& a, const Planar_point<FT>& b, const Planar_point<FT>& c)
    : area(twice_signed_area(a, b, c)),
      squares(squared_distance_in_plane(a, b) + squared_distance_in_plane(b, c) + squared_distance_in_plane(c, a))
  {}

  bool is_less(const Triangle_quality& other) const { return area * other.squares < other.area * squares; }
  bool is_less(const FT& quality) const { return !(area >= quality * squares); }
};

// Cuts ears off a polygon with at most `most_corners` corners, given counterclockwise. An ear is a triangle of three
// consecutive corners that contains no other corner; the one with the best quality is cut first.
template <typename FT, std::size_t most_corners>
class Ear_clipping
{
public:
  // The corner that is cut off, and its neighbors at that moment. The last triangle is what is left.
  struct Ear
  {
    unsigned char previous, corner, next;
  };

  using Corners = std::array<Planar_point<FT>, most_corners>;

  // Divides the polygon of the first n corners into the n - 2 triangles ear(0), ear(1), ...; returns false if some of
  // them would have a quality below `least_quality`, or if rounding hides all ears.
  // Requires: 3 <= n <= most_corners. Takes O(n^2) time, unless corners obstruct ears.
  bool divide(const Corners& p, std::size_t n, const FT& least_quality)
  {
    CGAL_assertion(3 <= n && n <= most_corners);
    for(std::size_t i = 0; i < n; ++i)
    {
      m_next[i] = static_cast<unsigned char>(i + 1 < n ? i + 1 : 0);
      m_previous[i] = static_cast<unsigned char>(i > 0 ? i - 1 : n - 1);
      m_is_cut[i] = false;
    }
    for(std::size_t i = 0; i < n; ++i)
      measure(p, i);
    m_number_of_ears = 0;
    while(m_number_of_ears + 2 < n)
    {
      const std::size_t i = best_ear(p, n, least_quality);
      if(i == n)
        return false;
      m_ears[m_number_of_ears++] = Ear{m_previous[i], static_cast<unsigned char>(i), m_next[i]};
      cut(p, i);
    }
    return true;
  }

  std::size_t number_of_ears() const { return m_number_of_ears; }
  const Ear& ear(std::size_t i) const { return m_ears[i]; }

private:
  void measure(const Corners& p, std::size_t i)
  {
    m_quality[i] = Triangle_quality<FT>(p[m_previous[i]], p[i], p[m_next[i]]);
  }

  // Returns the corner of the best ear; n if there is none.
  std::size_t best_ear(const Corners& p, std::size_t n, const FT& least_quality)
  {
    for(;;)
    {
      std::size_t best = n;
      for(std::size_t i = 0; i < n; ++i)
        if(!m_is_cut[i] && !m_quality[i].is_less(least_quality)
           && (best == n || m_quality[best].is_less(m_quality[i])))
          best = i;
      if(best == n || is_empty(p, best))
        return best;
      m_quality[best].area = -1; // until a neighbor is cut off
    }
  }

  // Does the triangle at corner i contain no other corner?
  bool is_empty(const Corners& p, std::size_t i) const
  {
    const std::size_t a = m_previous[i], c = m_next[i];
    for(std::size_t j = m_next[c]; j != a; j = m_next[j])
      if(twice_signed_area(p[a], p[i], p[j]) >= 0 && twice_signed_area(p[i], p[c], p[j]) >= 0
         && twice_signed_area(p[c], p[a], p[j]) >= 0)
        return false;
    return true;
  }

  void cut(const Corners& p, std::size_t i)
  {
    m_is_cut[i] = true;
    m_next[m_previous[i]] = m_next[i];
    m_previous[m_next[i]] = m_previous[i];
    measure(p, m_previous[i]);
    measure(p, m_next[i]);
  }

  std::array<unsigned char, most_corners> m_next, m_previous;
  std::array<bool, most_corners> m_is_cut;
  std::array<Triangle_quality<FT>, most_corners> m_quality;
  std::array<Ear, most_corners> m_ears;
  std::size_t m_number_of_ears = 0;
};

} // namespace Flat_vertices

#endif // FLAT_STAR_H
