#include "Distance_levels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace geodesics_demo {

namespace {

double length_between(const Point& a, const Point& b)
{
  const double square = CGAL::squared_distance(a, b);
  // (The square of a very large or small length is not a number to take a root of; std::hypot() takes longer.)
  return square > 1e-280 && square < 1e300 ? std::sqrt(square)
                                           : std::hypot(a.x() - b.x(), a.y() - b.y(), a.z() - b.z());
}

// Dijkstra's algorithm with buckets: a vertex whose distance shrinks goes into the bucket of its new distance, and a
// bucket is done again as long as it gets vertices. Bucket i of a ring is for distances from i times the width on. An
// edge that is longer than the ring leads to the last bucket of the ring, and its vertex waits there once more. Where
// all vertices of the ring wait, the next bucket is that of the nearest one, as edges may be longer by any factor.
class Distances_along_edges
{
public:
  Distances_along_edges(const Mesh& mesh, const std::vector<Face>& avoided)
    : m_mesh(mesh), m_distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity()),
      m_bucket(number_of_buckets)
  {
    if(!avoided.empty())
      m_is_avoided.resize(mesh.number_of_faces(), 0);
    for(const Face f : avoided)
      m_is_avoided[f.idx()] = 1;
    m_width = mean_length();
  }

  // A corner of the face of a source is as near as in space. One that is not on the edge of a source at the rim of what
  // is avoided does not count.
  void add(const Location& source)
  {
    if(source.is_vertex())
      return improve(source.vertex, 0);
    const Point p = point_of(source.face_location, m_mesh);
    Mesh::Halfedge_index h = m_mesh.halfedge(source.face_location.first);
    for(const double b : source.face_location.second)
    {
      if(b > 1e-12)
        improve(m_mesh.source(h), length_between(p, m_mesh.point(m_mesh.source(h))));
      h = m_mesh.next(h);
    }
  }

  double largest()
  {
    std::size_t number_without_vertices = 0; // of the last buckets
    for(std::size_t i = 0; m_number_of_waiting > 0; ++i)
    {
      if(number_without_vertices++ == number_of_buckets)
        i = go_to_nearest_bucket();
      for(std::vector<Vertex>& bucket = m_bucket[i % number_of_buckets]; !bucket.empty();)
      {
        m_reached = i;
        const std::vector<Vertex> vertices = std::exchange(bucket, {});
        m_number_of_waiting -= vertices.size();
        for(const Vertex v : vertices)
          if(leave(v, i))
            number_without_vertices = 0;
      }
    }
    double result = 0;
    for(const double d : m_distance)
      result = std::isfinite(d) ? (std::max)(result, d) : result;
    return result;
  }

private:
  static constexpr std::size_t number_of_buckets = 256;

  // Of some edges; 1 if they have no length.
  double mean_length() const
  {
    double mean = 0, n = 0; // (a sum might be infinite)
    const std::size_t step = m_mesh.number_of_edges() / 1000 + 1;
    for(std::size_t i = 0; i < m_mesh.number_of_edges(); i += step)
    {
      const Mesh::Edge_index e(static_cast<Mesh::size_type>(i));
      mean += (length_between(m_mesh.point(m_mesh.vertex(e, 0)), m_mesh.point(m_mesh.vertex(e, 1))) - mean) / ++n;
    }
    return mean > 0 ? mean : 1;
  }

  bool is_open(Mesh::Halfedge_index h) const
  {
    return m_is_avoided.empty() || (!m_mesh.is_border(h) && m_is_avoided[m_mesh.face(h).idx()] == 0);
  }

  void improve(Vertex v, double d)
  {
    if(!(d < m_distance[v.idx()]))
      return;
    m_distance[v.idx()] = d;
    push(v);
  }

  // The number of the bucket of a vertex. The last bucket is for all distances from its number on, in any order.
  std::size_t bucket_of(Vertex v) const
  {
    return static_cast<std::size_t>((std::min)(m_distance[v.idx()] / m_width, 0x1p52));
  }

  // Into its bucket, or the last one before the ring is closed.
  void push(Vertex v)
  {
    m_bucket[(std::min)(bucket_of(v), m_reached + number_of_buckets - 1) % number_of_buckets].push_back(v);
    ++m_number_of_waiting;
  }

  // Closes the ring at the smallest bucket of the vertices that wait, and returns its number. Requires: there are such
  // vertices, and none has left a bucket since the ring was closed for the last time: all wait for later buckets.
  std::size_t go_to_nearest_bucket()
  {
    std::vector<Vertex> vertices;
    for(std::vector<Vertex>& bucket : m_bucket)
    {
      vertices.insert(vertices.end(), bucket.begin(), bucket.end());
      bucket.clear();
    }
    m_number_of_waiting = 0;
    m_reached = (std::numeric_limits<std::size_t>::max)();
    for(const Vertex v : vertices)
      m_reached = (std::min)(m_reached, bucket_of(v));
    for(const Vertex v : vertices)
      push(v);
    return m_reached;
  }

  // A vertex that came nearer since has left an earlier bucket; one that waits for a later one is put back. Returns
  // whether v leaves bucket i now.
  bool leave(Vertex v, std::size_t i)
  {
    if(bucket_of(v) > i)
      push(v);
    if(bucket_of(v) != i)
      return false;
    const double d = m_distance[v.idx()];
    if(m_mesh.is_isolated(v))
      return true;
    for(const Mesh::Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(is_open(h) || is_open(m_mesh.opposite(h)))
        improve(m_mesh.source(h), d + length_between(m_mesh.point(v), m_mesh.point(m_mesh.source(h))));
    return true;
  }

  const Mesh& m_mesh;
  std::vector<double> m_distance; // by vertex
  std::vector<char> m_is_avoided; // by face, or empty
  double m_width = 1;
  std::vector<std::vector<Vertex>> m_bucket;
  std::size_t m_reached = 0, m_number_of_waiting = 0;
};

} // namespace

double bound_of_distances(const Mesh& mesh, const std::vector<Face>& avoided, const std::vector<Location>& sources)
{
  Distances_along_edges distances(mesh, avoided);
  for(const Location& s : sources)
    distances.add(s);
  return distances.largest();
}

std::vector<double> at_round_distances(std::size_t n, double largest)
{
  std::vector<double> result;
  if(!(largest > 0) || n == 0)
    return result;
  const double wanted = largest / static_cast<double>(n + 1), power = std::pow(10., std::floor(std::log10(wanted)));
  const double digits = wanted / power, step = power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
  for(int i = 1; i * step < largest && i <= 1000; ++i)
    result.push_back(i * step);
  return result;
}

} // namespace geodesics_demo
