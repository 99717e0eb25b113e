#ifndef SURFACE_MESH_GEODESICS_EDGE_SEQUENCE_SEARCH_H
#define SURFACE_MESH_GEODESICS_EDGE_SEQUENCE_SEARCH_H

// A referee for small meshes, written from the definition, with any number of digits. A shortest path is a chain of
// straight pieces between vertices; each piece crosses a sequence of edges. The referee visits the vertices in the
// order of their distances, and unfolds all sequences of faces around each of them into one plane. The part of an edge
// that is visible through all edges before it is a cone of directions; a straight piece reaches the next vertex if that
// lies in the cone.
//
// On a surface with points no shortest path crosses a face twice, because no path is shorter than the segment between
// two points of the face. On a surface given by lengths, a path through other faces may be shorter than that; there
// each face may be crossed `most_faces_crossed` times.
//
// The referee uses no windows, no frames of edges and no tolerances of distances. Paths may bend at every vertex that
// is not clearly convex, and a ray through a vertex counts for that vertex. A sequence ends where its cone is empty,
// where it would enter a face too often, or where it is farther than every distance that is still in question; these
// are bounded by paths along edges.

#include "test_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace test_meshes {

template <class FT>
class Edge_sequence_search
{
public:
  explicit Edge_sequence_search(const Indexed_mesh& mesh)
    : Edge_sequence_search(mesh, [&mesh](std::size_t a, std::size_t b) {
        using std::sqrt;
        FT sum(0);
        for(std::size_t i = 0; i < 3; ++i)
        {
          const FT d = FT(mesh.points[a][i]) - FT(mesh.points[b][i]);
          sum += d * d;
        }
        return FT(sqrt(sum));
      })
  {}

  // `length(a, b)` is the length of the edge between two vertices. The points are ignored.
  template <class Length>
  Edge_sequence_search(const Indexed_mesh& mesh, const Length& length, unsigned int most_faces_crossed = 1)
    : m_mesh(mesh), m_most_faces_crossed(most_faces_crossed), m_lengths(mesh.points.size())
  {
    for(std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t a = mesh.faces[f][k], b = mesh.faces[f][(k + 1) % 3];
        m_face_on_left[{a, b}] = f;
        m_lengths[a][b] = m_lengths[b][a] = length(a, b);
      }
    }
    find_convex_vertices();
  }

  // Returns the distances, infinity for vertices that no path reaches.
  std::vector<FT> from_vertex(std::size_t source)
  {
    const std::size_t n = m_mesh.points.size();
    m_distances.assign(n, infinity());
    m_distances[source] = FT(0);
    walk_along_edges();
    std::vector<bool> is_final(n, false);
    for(std::size_t i = 0; i < n; ++i)
    {
      std::size_t nearest = n;
      m_bound = FT(0);
      for(std::size_t v = 0; v < n; ++v)
      {
        if(is_final[v] || m_distances[v] == infinity())
        {
          continue;
        }
        m_bound = (std::max)(m_bound, m_distances[v]);
        nearest = nearest == n || m_distances[v] < m_distances[nearest] ? v : nearest;
      }
      if(nearest == n)
      {
        break;
      }
      is_final[nearest] = true;
      if(nearest == source || !m_is_convex[nearest])
      {
        look_around(nearest);
      }
    }
    return m_distances;
  }

  std::size_t number_of_sequences() const { return m_number_of_sequences; }

private:
  struct Point
  {
    FT x, y;
  };

  static FT infinity() { return std::numeric_limits<FT>::infinity(); }

  // Positive if b is to the left of a, seen from the origin.
  static FT turn(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

  // Returns whether there is a direction between the two, from the right to the left. At the middle corner of a face of
  // area zero the directions fill a half-plane.
  static bool is_open(const Point& first, const Point& last)
  {
    const FT t = turn(first, last);
    return t > FT(0) || (t == FT(0) && first.x * last.x + first.y * last.y < FT(0));
  }

  static FT norm(const Point& p)
  {
    using std::sqrt;
    return sqrt(p.x * p.x + p.y * p.y);
  }

  // No shortest path bends at a vertex with less than a full angle around it, all of it in faces.
  void find_convex_vertices()
  {
    using std::atan2;
    const double full_angle = 2 * pi - 1e-6;
    std::vector<FT> angle(m_mesh.points.size(), FT(0));
    m_is_convex.assign(m_mesh.points.size(), true);
    for(const auto& side : m_face_on_left)
    {
      const std::size_t a = side.first.first, b = side.first.second;
      const Triangle& t = m_mesh.faces[side.second];
      const std::size_t c = t[0] + t[1] + t[2] - a - b;
      m_is_convex[a] = m_is_convex[a] && m_face_on_left.count({b, a}) != 0 && m_lengths[a][b] > FT(0);
      m_is_convex[b] = m_is_convex[b] && m_face_on_left.count({b, a}) != 0 && m_lengths[a][b] > FT(0);
      if(m_lengths[a][b] > FT(0))
      {
        const Point p = third_point({FT(0), FT(0)}, {m_lengths[a][b], FT(0)}, m_lengths[a][b], m_lengths[a][c],
                                    m_lengths[b][c]);
        angle[a] += atan2(p.y, p.x);
      }
    }
    for(std::size_t v = 0; v < angle.size(); ++v)
    {
      m_is_convex[v] = m_is_convex[v] && angle[v] < FT(full_angle);
    }
  }

  void walk_along_edges()
  {
    for(bool is_done = false; !is_done;)
    {
      is_done = true;
      for(std::size_t a = 0; a < m_lengths.size(); ++a)
      {
        for(const auto& edge : m_lengths[a])
        {
          const FT d = m_distances[a] + edge.second;
          if(d < m_distances[edge.first])
          {
            m_distances[edge.first] = d;
            is_done = false;
          }
        }
      }
    }
  }

  // Follows all straight pieces from v, which lies at the origin.
  void look_around(std::size_t v)
  {
    m_visits.assign(m_mesh.faces.size(), 0);
    m_offset = m_distances[v];
    for(const auto& edge : m_lengths[v])
    {
      m_distances[edge.first] = (std::min)(m_distances[edge.first], FT(m_offset + edge.second));
    }
    for(std::size_t f = 0; f < m_mesh.faces.size(); ++f)
    {
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t right = m_mesh.faces[f][(k + 1) % 3], left = m_mesh.faces[f][(k + 2) % 3];
        if(m_mesh.faces[f][k] != v || !(m_lengths[v][right] > FT(0)))
        {
          continue;
        }
        const Point r = {m_lengths[v][right], FT(0)};
        const Point l = third_point({FT(0), FT(0)}, r, m_lengths[v][right], m_lengths[v][left], m_lengths[right][left]);
        ++m_visits[f];
        look_across(right, left, r, l, r, l);
        --m_visits[f];
      }
    }
  }

  // The point to the left of pq, at the given distances from p and q.
  static Point third_point(const Point& p, const Point& q, const FT& pq, const FT& from_p, const FT& from_q)
  {
    using std::sqrt;
    const FT along = (pq + (from_p - from_q) * (from_p + from_q) / pq) / 2;
    const FT square = (from_p - along) * (from_p + along);
    const FT across = square > FT(0) ? FT(sqrt(square)) : FT(0);
    const Point unit = {(q.x - p.x) / pq, (q.y - p.y) / pq};
    return {p.x + along * unit.x - across * unit.y, p.y + along * unit.y + across * unit.x};
  }

  // Follows the pieces that cross the edge from the vertex `right` at r to `left` at l between the directions `first`
  // and `last`, from the right to the left.
  void look_across(std::size_t right, std::size_t left, const Point& r, const Point& l, const Point& first,
                   const Point& last)
  {
    const auto found = m_face_on_left.find({left, right});
    if(found == m_face_on_left.end() || m_visits[found->second] == m_most_faces_crossed || !is_open(first, last)
       || !(m_offset + nearest_in_cone(r, l, first, last) < m_bound))
    {
      return;
    }
    ++m_number_of_sequences;
    const std::size_t f = found->second;
    const Triangle& corners = m_mesh.faces[f];
    const std::size_t apex = *std::find_if(corners.begin(), corners.end(),
                                           [&](std::size_t v) { return v != left && v != right; });
    const Point a = third_point(l, r, m_lengths[left][right], m_lengths[left][apex], m_lengths[right][apex]);
    const bool is_left_of_first = turn(first, a) >= FT(0), is_right_of_last = turn(a, last) >= FT(0);
    if(is_left_of_first && is_right_of_last)
    {
      m_distances[apex] = (std::min)(m_distances[apex], FT(m_offset + norm(a)));
    }
    ++m_visits[f];
    if(is_left_of_first)
    {
      look_across(right, apex, r, a, first, is_right_of_last ? a : last);
    }
    if(is_right_of_last)
    {
      look_across(apex, left, a, l, is_left_of_first ? a : first, last);
    }
    --m_visits[f];
  }

  // A lower bound of the distance of the visible points: the distance of the segment that the cone cuts out of the
  // edge.
  static FT nearest_in_cone(const Point& r, const Point& l, const Point& first, const Point& last)
  {
    const Point edge = {l.x - r.x, l.y - r.y};
    const Point p = on_ray(r, edge, first), q = on_ray(r, edge, last);
    const Point pq = {q.x - p.x, q.y - p.y};
    const FT square = pq.x * pq.x + pq.y * pq.y, dot = -(p.x * pq.x + p.y * pq.y);
    const FT t = square > FT(0) ? (std::min)((std::max)(FT(dot / square), FT(0)), FT(1)) : FT(0);
    return norm({p.x + t * pq.x, p.y + t * pq.y});
  }

  // The point where the line through r in direction `edge` meets the ray.
  static Point on_ray(const Point& r, const Point& edge, const Point& ray)
  {
    const FT denominator = turn(ray, edge);
    const FT t = denominator == FT(0) ? FT(0) : FT(turn(r, edge) / denominator);
    return {t * ray.x, t * ray.y};
  }

  const Indexed_mesh& m_mesh;
  unsigned int m_most_faces_crossed;
  std::vector<std::map<std::size_t, FT>> m_lengths;                          // by both ends of an edge
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_face_on_left; // of a directed edge
  std::vector<bool> m_is_convex;
  std::vector<FT> m_distances;
  std::vector<unsigned int> m_visits; // of each face, by the sequence
  FT m_offset = FT(0);            // the distance of the vertex at the origin
  FT m_bound = FT(0);
  std::size_t m_number_of_sequences = 0;
};

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_EDGE_SEQUENCE_SEARCH_H
