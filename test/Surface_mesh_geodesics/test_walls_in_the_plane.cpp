// Walls in a plane domain: distances are the lengths of shortest ways in a visibility graph. Its nodes are the
// vertices, once for each sector between walls.

#include "cut_mesh.h"
#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Positive if c is on the left of the line from a to b.
double cross(const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Requires: the mesh is in the plane z = 0, and no vertex is on the straight way between two others, but along the
// border of the square.
class Visibility_graph
{
public:
  Visibility_graph(const Mesh& tm, const Walls& walls) : m_tm(tm), m_walls(walls), m_cut(tm, walls)
  {
    for(const vertex_descriptor v : vertices(tm))
      for(const vertex_descriptor w : vertices(tm))
        if(v < w)
          connect(v, w);
  }

  // The distances of the vertices from one of them, by Dijkstra's method.
  std::vector<double> distances(vertex_descriptor source) const
  {
    std::map<Node, double> length;
    std::set<std::pair<double, Node>> queue;
    for(const auto& neighbors : m_neighbors)
      if(neighbors.first.first == source)
        queue.emplace(0., neighbors.first);
    std::vector<double> result(num_vertices(m_tm), infinity);
    result[source] = 0;
    while(!queue.empty())
    {
      const auto [d, node] = *queue.begin();
      queue.erase(queue.begin());
      if(!length.emplace(node, d).second)
        continue;
      result[node.first] = (std::min)(result[node.first], d);
      for(const Node& next : m_neighbors.at(node))
        queue.emplace(d + std::sqrt(CGAL::squared_distance(m_tm.point(node.first), m_tm.point(next.first))), next);
    }
    return result;
  }

private:
  using Node = std::pair<vertex_descriptor, std::size_t>; // a vertex and a sector

  void add(const Node& a, const Node& b)
  {
    m_neighbors[a].push_back(b);
    m_neighbors[b].push_back(a);
  }

  // Vertices of an edge see each other on both sides of it.
  void connect(vertex_descriptor v, vertex_descriptor w)
  {
    const halfedge_descriptor h = m_tm.halfedge(v, w);
    if(h == Mesh::null_halfedge())
    {
      const face_descriptor f = face_towards(v, w), g = face_towards(w, v);
      if(f != Mesh::null_face() && g != Mesh::null_face() && is_visible(v, w))
        add({v, m_cut.sector(f, v)}, {w, m_cut.sector(g, w)});
      return;
    }
    for(const halfedge_descriptor side : {h, opposite(h, m_tm)})
      if(!is_border(side, m_tm))
        add({v, m_cut.sector(face(side, m_tm), v)}, {w, m_cut.sector(face(side, m_tm), w)});
  }

  // The face at v in which the straight way to w begins; none along the border.
  face_descriptor face_towards(vertex_descriptor v, vertex_descriptor w) const
  {
    const Kernel::Point_3 &p = m_tm.point(v), &q = m_tm.point(w);
    for(const halfedge_descriptor h : halfedges_around_source(v, m_tm))
      if(!is_border(h, m_tm) && cross(p, m_tm.point(target(h, m_tm)), q) > 1e-12
         && cross(p, m_tm.point(target(next(h, m_tm), m_tm)), q) < -1e-12)
        return face(h, m_tm);
    return Mesh::null_face();
  }

  bool is_visible(vertex_descriptor v, vertex_descriptor w) const
  {
    const Kernel::Point_3 &p = m_tm.point(v), &q = m_tm.point(w);
    return std::none_of(m_walls.begin(), m_walls.end(), [&](edge_descriptor e)
    {
      const vertex_descriptor s = source(e, m_tm), t = target(e, m_tm);
      if(s == v || s == w || t == v || t == w)
        return false;
      const Kernel::Point_3 &a = m_tm.point(s), &b = m_tm.point(t);
      return (cross(p, q, a) > 0) != (cross(p, q, b) > 0) && (cross(a, b, p) > 0) != (cross(a, b, q) > 0);
    });
  }

  const Mesh& m_tm;
  const Walls& m_walls;
  const Cut_mesh m_cut;
  std::map<Node, std::vector<Node>> m_neighbors;
};

void test_visibility_graphs()
{
  std::size_t number_around = 0, number_unreached = 0;
  for(std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    const test_support::Scope scope("walls " + std::to_string(seed));
    test_support::Random random(seed);
    const Mesh tm = to_face_graph(flat_patch(6, 6, .15, true, seed));
    Walls walls;
    const double part = random.uniform(.05, .35);
    for(const edge_descriptor e : edges(tm))
      if(random.uniform() < part)
        walls.insert(e);
    const vertex_descriptor source = random_vertex(tm, random);
    const std::vector<double> expected = Visibility_graph(tm, walls).distances(source);
    auto solver = CGAL::Surface_mesh_geodesics::Geodesic_distance_solver<Mesh>::avoiding_edges(tm, walls);
    solver.compute_distances(source);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_CLOSE(solver.distance(v), expected[v], 1e-12);
      if(expected[v] == infinity)
        ++number_unreached;
      else if(expected[v] > std::sqrt(CGAL::squared_distance(tm.point(source), tm.point(v))) + 1e-6)
        ++number_around;
    }
  }
  std::cout << number_around << " ways around walls, " << number_unreached << " vertices not reached\n";
  CHECK(number_around > 1000 && number_unreached > 200);
}

} // namespace

int main()
{
  test_visibility_graphs();
  return test_result();
}
