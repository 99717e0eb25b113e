#ifndef SURFACE_MESH_GEODESICS_BRUTE_FORCE_DISTANCES_H
#define SURFACE_MESH_GEODESICS_BRUTE_FORCE_DISTANCES_H

// An independent referee without any pruning rule. From every vertex at which a shortest path may bend, it unfolds
// straight lines through every sequence of faces that is not longer than the largest distance still to be determined.
// Works with any number type.

#include "test_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace test_meshes {

template <class FT = long double>
class Brute_force_distances
{
public:
  explicit Brute_force_distances(const Indexed_mesh& mesh)
    : Brute_force_distances(mesh, [&mesh](std::size_t a, std::size_t b) {
        return distance(mesh.points[a], mesh.points[b]);
      })
  {}

  // `length(a, b)` is the length of the edge between two vertices. The points are ignored.
  template <class Length>
  Brute_force_distances(const Indexed_mesh& mesh, const Length& length) : m_mesh(mesh)
  {
    const std::size_t number_of_faces = mesh.faces.size();
    m_lengths.resize(number_of_faces);
    m_neighbors.assign(number_of_faces, {none(), none(), none()});
    m_corners.resize(mesh.points.size());
    std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t>> side_of;
    std::vector<FT> angles(mesh.points.size(), FT(0));
    std::vector<bool> on_border(mesh.points.size(), false);
    for(std::size_t f = 0; f < number_of_faces; ++f)
    {
      for(std::size_t k = 0; k < 3; ++k)
      {
        side_of[{tail(f, k), head(f, k)}] = {f, k};
        m_lengths[f][k] = length(tail(f, k), head(f, k));
        m_corners[tail(f, k)].push_back({f, k});
      }
    }
    for(std::size_t f = 0; f < number_of_faces; ++f)
    {
      for(std::size_t k = 0; k < 3; ++k)
      {
        const auto found = side_of.find({head(f, k), tail(f, k)});
        if(found == side_of.end())
        {
          on_border[tail(f, k)] = true;
          on_border[head(f, k)] = true;
        }
        else
        {
          m_neighbors[f][k] = found->second.first * 3 + found->second.second;
        }
        const FT x = apex_x(m_lengths[f][k], m_lengths[f][(k + 1) % 3], m_lengths[f][(k + 2) % 3]);
        using std::atan2;
        angles[tail(f, k)] += atan2(apex_y(x, m_lengths[f][(k + 2) % 3]), x);
      }
    }
    m_is_pseudo_source.resize(mesh.points.size());
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      // Includes flat vertices, which is superfluous but never wrong.
      m_is_pseudo_source[v] = on_border[v] || angles[v] > FT(2 * pi) - FT(1e-8);
    }
  }

  std::vector<FT> from_vertex(std::size_t source) { return run({{source, FT(0)}}); }

  // Distances from several vertices with offsets.
  std::vector<FT> run(const std::vector<std::pair<std::size_t, FT>>& sources)
  {
    const std::size_t n = m_mesh.points.size();
    m_distances.assign(n, infinity());
    std::vector<bool> is_source(n, false);
    std::vector<bool> is_final(n, false);
    for(const auto& source : sources)
    {
      m_distances[source.first] = (std::min)(m_distances[source.first], source.second);
      is_source[source.first] = true;
    }
    walk_along_edges();
    for(;;)
    {
      std::size_t v = none();
      m_bound = FT(0);
      for(std::size_t i = 0; i < n; ++i)
      {
        if(is_final[i] || m_distances[i] == infinity())
        {
          continue;
        }
        m_bound = (std::max)(m_bound, m_distances[i]);
        if(v == none() || m_distances[i] < m_distances[v])
        {
          v = i;
        }
      }
      if(v == none())
      {
        return m_distances;
      }
      is_final[v] = true;
      if(m_is_pseudo_source[v] || is_source[v])
      {
        spread_around(v);
      }
    }
  }

private:
  struct Strip
  {
    std::size_t side; // 3 * face + k: the strip enters the face through its side k
    FT x, y;          // image of the pseudo-source; the side runs from (0, 0) to (length, 0), y <= 0
    FT begin, end;    // the lit interval of the side
  };

  static std::size_t none() { return (std::numeric_limits<std::size_t>::max)(); }
  static FT infinity() { return std::numeric_limits<FT>::infinity(); }

  std::size_t tail(std::size_t f, std::size_t k) const { return m_mesh.faces[f][k]; }
  std::size_t head(std::size_t f, std::size_t k) const { return m_mesh.faces[f][(k + 1) % 3]; }

  static FT distance(const Coordinates& a, const Coordinates& b)
  {
    using std::sqrt;
    FT sum(0);
    for(std::size_t i = 0; i < 3; ++i)
    {
      const FT d = FT(a[i]) - FT(b[i]);
      sum += d * d;
    }
    return sqrt(sum);
  }

  // The apex of a triangle whose base runs from (0, 0) to (base, 0).
  static FT apex_x(const FT& base, const FT& right, const FT& left)
  {
    return (base * base + (left - right) * (left + right)) / (2 * base);
  }

  static FT apex_y(const FT& x, const FT& left)
  {
    using std::sqrt;
    const FT square = (left - x) * (left + x);
    return square > FT(0) ? FT(sqrt(square)) : FT(0);
  }

  void relax(std::size_t v, const FT& d)
  {
    if(d < m_distances[v])
    {
      m_distances[v] = d;
    }
  }

  // Upper bounds along edges, by Dijkstra's algorithm.
  void walk_along_edges()
  {
    using Entry = std::pair<FT, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for(std::size_t v = 0; v < m_distances.size(); ++v)
    {
      if(m_distances[v] != infinity())
      {
        queue.push({m_distances[v], v});
      }
    }
    while(!queue.empty())
    {
      const Entry entry = queue.top();
      queue.pop();
      if(m_distances[entry.second] < entry.first)
      {
        continue;
      }
      for(const auto& corner : m_corners[entry.second])
      {
        const std::size_t f = corner.first;
        const std::size_t k = corner.second;
        const std::pair<std::size_t, FT> neighbors[2] = {{head(f, k), m_lengths[f][k]},
                                                         {tail(f, (k + 2) % 3), m_lengths[f][(k + 2) % 3]}};
        for(const auto& neighbor : neighbors)
        {
          const FT d = entry.first + neighbor.second;
          if(d < m_distances[neighbor.first])
          {
            m_distances[neighbor.first] = d;
            queue.push({d, neighbor.first});
          }
        }
      }
    }
  }

  void push(std::vector<Strip>& stack, std::size_t f, std::size_t k, const FT& x, const FT& y, FT begin, FT end) const
  {
    // The strip leaves face f through side k and enters the neighbor.
    const std::size_t neighbor = m_neighbors[f][k];
    const FT base = m_lengths[f][k];
    begin = (std::max)(begin, FT(0));
    end = (std::min)(end, base);
    if(neighbor == none() || !(begin < end))
    {
      return;
    }
    stack.push_back({neighbor, x, y, begin, end});
  }

  // Spreads the distance of a pseudo-source over all straight strips around it.
  void spread_around(std::size_t v)
  {
    const FT offset = m_distances[v];
    std::vector<Strip> stack;
    for(const auto& corner : m_corners[v])
    {
      const std::size_t f = corner.first;
      const std::size_t k = corner.second;
      const std::size_t opposite = (k + 1) % 3;
      relax(head(f, k), offset + m_lengths[f][k]);
      relax(tail(f, (k + 2) % 3), offset + m_lengths[f][(k + 2) % 3]);
      // In the frame of the neighbor the opposite side runs the other way.
      const FT base = m_lengths[f][opposite];
      const FT left = m_lengths[f][k];
      const FT right = m_lengths[f][(k + 2) % 3];
      const FT x = apex_x(base, right, left);
      push(stack, f, opposite, base - x, -apex_y(x, left), FT(0), base);
    }
    while(!stack.empty())
    {
      const Strip strip = stack.back();
      stack.pop_back();
      unfold(strip, offset, stack);
    }
  }

  // Unfolds a strip across the face that it enters: improves the apex if the strip covers it, and pushes the strips
  // that leave through the two other sides. Drops a strip that is farther away than the bound.
  void unfold(const Strip& strip, const FT& offset, std::vector<Strip>& stack)
  {
    using std::sqrt;
    const std::size_t f = strip.side / 3;
    const std::size_t k = strip.side % 3;
    const FT base = m_lengths[f][k];
    const FT right = m_lengths[f][(k + 1) % 3];
    const FT left = m_lengths[f][(k + 2) % 3];
    const FT t = (std::min)((std::max)(strip.x, strip.begin), strip.end);
    const FT nearest = offset + sqrt((t - strip.x) * (t - strip.x) + strip.y * strip.y);
    if(nearest > m_bound)
    {
      return;
    }
    const FT px = apex_x(base, right, left);
    const FT py = apex_y(px, left);
    if(!(py - strip.y > FT(0)))
    {
      return;
    }
    const FT hit = strip.x + (px - strip.x) * (-strip.y) / (py - strip.y);
    const FT slack = base * std::numeric_limits<FT>::epsilon() * 64;
    if(strip.begin - slack <= hit && hit <= strip.end + slack)
    {
      relax(tail(f, (k + 2) % 3), offset + sqrt((px - strip.x) * (px - strip.x) + (py - strip.y) * (py - strip.y)));
    }
    // The left side runs from the apex to (0, 0) in this face, and from (0, 0) to the apex in its neighbor.
    if(strip.begin < hit && left > FT(0))
    {
      const FT ux = px / left;
      const FT uy = py / left;
      push(stack, f, (k + 2) % 3, strip.x * ux + strip.y * uy, (std::min)(strip.y * ux - strip.x * uy, FT(0)),
           share_of_side(strip.x, strip.y, strip.begin, px, py) * left,
           hit <= strip.end ? left : share_of_side(strip.x, strip.y, strip.end, px, py) * left);
    }
    // The right side runs from (base, 0) to the apex in this face, and from the apex to (base, 0) in its neighbor.
    if(hit < strip.end && right > FT(0))
    {
      const FT ux = (base - px) / right;
      const FT uy = -py / right;
      const FT dx = strip.x - px;
      const FT dy = strip.y - py;
      push(stack, f, (k + 1) % 3, dx * ux + dy * uy, (std::min)(dy * ux - dx * uy, FT(0)),
           hit >= strip.begin
             ? FT(0)
             : (1 - share_of_side(strip.x - base, strip.y, strip.begin - base, px - base, py)) * right,
           (1 - share_of_side(strip.x - base, strip.y, strip.end - base, px - base, py)) * right);
    }
  }

  // The parameter in [0, 1] where the ray from (x, y) through (t, 0) meets the segment from the origin to (px, py).
  static FT share_of_side(const FT& x, const FT& y, const FT& t, const FT& px, const FT& py)
  {
    const FT dx = t - x;
    const FT dy = -y;
    const FT denominator = px * dy - py * dx;
    if(denominator == FT(0))
    {
      return FT(0);
    }
    const FT share = (x * dy - y * dx) / denominator;
    return (std::min)((std::max)(share, FT(0)), FT(1));
  }

  const Indexed_mesh& m_mesh;
  std::vector<std::array<FT, 3>> m_lengths;
  std::vector<std::array<std::size_t, 3>> m_neighbors; // 3 * face + side, or none()
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> m_corners;
  std::vector<bool> m_is_pseudo_source;
  std::vector<FT> m_distances;
  FT m_bound = FT(0);
};

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_BRUTE_FORCE_DISTANCES_H
