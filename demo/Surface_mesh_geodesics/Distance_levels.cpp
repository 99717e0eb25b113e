#include "Distance_levels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace geodesics_demo {

namespace {

double length_between(const Point& a, const Point& b) { return std::sqrt(CGAL::squared_distance(a, b)); }

// Dijkstra's algorithm with buckets: a vertex whose distance shrinks goes into the bucket of its new distance, and a
// bucket is done again as long as it gets vertices. Bucket i of a ring is for distances from i times the width on. An
// edge that is longer than the ring leads to the last bucket of the ring, and its vertex waits there once more.
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
    for(std::size_t i = 0; m_number_of_waiting > 0; ++i)
      for(std::vector<Vertex>& bucket = m_bucket[i % number_of_buckets]; !bucket.empty();)
      {
        m_reached = i;
        const std::vector<Vertex> vertices = std::exchange(bucket, {});
        m_number_of_waiting -= vertices.size();
        for(const Vertex v : vertices)
          leave(v, i);
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
    double sum = 0, n = 0;
    const std::size_t step = m_mesh.number_of_edges() / 1000 + 1;
    for(std::size_t i = 0; i < m_mesh.number_of_edges(); i += step, ++n)
    {
      const Mesh::Edge_index e(static_cast<Mesh::size_type>(i));
      sum += length_between(m_mesh.point(m_mesh.vertex(e, 0)), m_mesh.point(m_mesh.vertex(e, 1)));
    }
    return sum > 0 && std::isfinite(sum) ? sum / n : 1;
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

  // Into the bucket of its distance, or the last one before the ring is closed.
  void push(Vertex v)
  {
    const double last = static_cast<double>(m_reached + number_of_buckets - 1), i = m_distance[v.idx()] / m_width;
    m_bucket[static_cast<std::size_t>((std::min)(i, last)) % number_of_buckets].push_back(v);
    ++m_number_of_waiting;
  }

  // A vertex that came nearer since has left an earlier bucket; one that waits for a later one is put back.
  void leave(Vertex v, std::size_t i)
  {
    const double d = m_distance[v.idx()];
    if(d / m_width >= static_cast<double>(i + 1))
      return push(v);
    if(d / m_width < static_cast<double>(i) || m_mesh.is_isolated(v))
      return;
    for(const Mesh::Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(is_open(h) || is_open(m_mesh.opposite(h)))
        improve(m_mesh.source(h), d + length_between(m_mesh.point(v), m_mesh.point(m_mesh.source(h))));
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
