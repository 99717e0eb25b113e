#include "Surface_builder.h"

#include "Command_error.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace geodesics_demo {

namespace {

using Index = Polygon_soup::Index;
using Halfedge = Mesh::Halfedge_index;

constexpr Index none = (std::numeric_limits<Index>::max)();

// Corner c of the soup stands for the halfedge from its vertex to the next corner of its face.
class Surface_builder
{
public:
  Surface_builder(const std::string& file_name, const Polygon_soup& soup) : m_file_name(file_name), m_soup(soup)
  {
    if(soup.corners.size() > static_cast<std::size_t>(most_points))
      reject_file(file_name, "there are too many faces");
    check_faces();
    find_targets();
    sort_by_source();
    pair_halfedges();
    check_vertices();
  }

  // Is there a vertex at which several parts of the surface meet, each of them with a border?
  bool has_pinched_vertices() const { return m_has_pinched_vertices; }

  Mesh mesh() const
  {
    Mesh mesh;
    mesh.resize(static_cast<Mesh::size_type>(m_soup.points.size()), m_number_of_edges,
                static_cast<Mesh::size_type>(m_soup.number_of_faces()));
    for(std::size_t v = 0; v < m_soup.points.size(); ++v)
      mesh.point(Vertex(static_cast<Mesh::size_type>(v))) = m_soup.points[v];
    connect_faces(mesh);
    connect_borders(mesh);
    return mesh;
  }

private:
  void check_faces() const
  {
    std::vector<Index> polygon;
    for(std::size_t f = 0; f < m_soup.number_of_faces(); ++f)
    {
      const std::size_t begin = m_soup.begin_of(f), end = m_soup.ends[f];
      if(end < begin + 3)
        reject_file(m_file_name, m_soup.name_of_face(f) + " has fewer than three vertices" + advice());
      const Index* const t = &m_soup.corners[begin];
      if(end == begin + 3 && t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        continue;
      polygon.assign(m_soup.corners.begin() + static_cast<std::ptrdiff_t>(begin),
                     m_soup.corners.begin() + static_cast<std::ptrdiff_t>(end));
      std::sort(polygon.begin(), polygon.end());
      const auto twice = std::adjacent_find(polygon.begin(), polygon.end());
      if(twice != polygon.end())
        reject_file(m_file_name, m_soup.name_of_face(f) + " has the vertex " + std::to_string(*twice) + " twice"
                                   + advice());
    }
  }

  void find_targets()
  {
    m_target.resize(m_soup.corners.size());
    m_face.resize(m_soup.corners.size());
    for(std::size_t f = 0; f < m_soup.number_of_faces(); ++f)
    {
      const std::size_t begin = m_soup.begin_of(f), end = m_soup.ends[f];
      for(std::size_t c = begin; c < end; ++c)
      {
        m_target[c] = m_soup.corners[c + 1 < end ? c + 1 : begin];
        m_face[c] = static_cast<Index>(f);
      }
    }
  }

  // Counting sort: the corners of vertex v are m_corners[m_first[v]], ..., in the order of their targets, then in that
  // of the file.
  void sort_by_source()
  {
    m_first.assign(m_soup.points.size() + 1, 0);
    for(const Index v : m_soup.corners)
      ++m_first[v + 1];
    for(std::size_t v = 0; v < m_soup.points.size(); ++v)
      m_first[v + 1] += m_first[v];
    m_corners.resize(m_soup.corners.size());
    std::vector<Index> next(m_first.begin(), m_first.end() - 1);
    for(std::size_t c = 0; c < m_soup.corners.size(); ++c)
      m_corners[next[m_soup.corners[c]]++] = static_cast<Index>(c);
    for(std::size_t v = 0; v < m_soup.points.size(); ++v)
      std::sort(m_corners.begin() + m_first[v], m_corners.begin() + m_first[v + 1], [&](Index a, Index b)
      { return m_target[a] != m_target[b] ? m_target[a] < m_target[b] : a < b; });
  }

  // The first of m_corners that leads from u to v or to a vertex behind it. Binary search, since u may be the tip of a
  // fan with thousands of faces.
  Index first_between(Index u, Index v) const
  {
    const auto begin = m_corners.begin();
    return static_cast<Index>(std::lower_bound(begin + m_first[u], begin + m_first[u + 1], v, [&](Index c, Index target)
                                               { return m_target[c] < target; }) - begin);
  }

  bool is_between(Index i, Index u, Index v) const { return i < m_first[u + 1] && m_target[m_corners[i]] == v; }

  // The corners that lead from u to v.
  std::vector<Index> corners_between(Index u, Index v) const
  {
    std::vector<Index> result;
    for(Index i = first_between(u, v); is_between(i, u, v); ++i)
      result.push_back(m_corners[i]);
    return result;
  }

  // Numbers the edges in the order in which the faces first have them. An edge has one corner for each direction.
  void pair_halfedges()
  {
    m_halfedge.assign(m_soup.corners.size(), none);
    for(std::size_t c = 0; c < m_soup.corners.size(); ++c)
    {
      const Index u = m_soup.corners[c], v = m_target[c];
      if(is_between(first_between(u, v) + 1, u, v))
        reject_edge(u, v);
      if(m_halfedge[c] != none)
        continue;
      m_halfedge[c] = 2 * m_number_of_edges;
      for(Index i = first_between(v, u); is_between(i, v, u); ++i)
        m_halfedge[m_corners[i]] = 2 * m_number_of_edges + 1;
      ++m_number_of_edges;
    }
  }

  bool have_same_corners(std::size_t f, std::size_t g) const
  {
    const auto first = m_soup.corners.begin();
    const auto at = [&](std::size_t c) { return first + static_cast<std::ptrdiff_t>(c); };
    return m_soup.size_of(f) == m_soup.size_of(g)
        && std::is_permutation(at(m_soup.begin_of(f)), at(m_soup.ends[f]), at(m_soup.begin_of(g)));
  }

  [[noreturn]] void reject_edge(Index u, Index v) const
  {
    const std::vector<Index> there = corners_between(u, v), back = corners_between(v, u);
    const std::string edge = "the edge of the vertices " + std::to_string(u) + " and " + std::to_string(v);
    if(there.size() == 2 && have_same_corners(m_face[there[0]], m_face[there[1]]))
      reject_file(m_file_name, m_soup.name_of_face(m_face[there[1]]) + " repeats "
                                 + m_soup.name_of_face(m_face[there[0]]) + advice());
    if(there.size() == 2 && back.empty())
      reject_file(m_file_name, "the orientations of " + m_soup.name_of_face(m_face[there[0]]) + " and "
                                 + m_soup.name_of_face(m_face[there[1]]) + " differ: both lead from vertex "
                                 + std::to_string(u) + " to vertex " + std::to_string(v) + advice());
    std::string faces;
    for(const std::vector<Index>& corners : {there, back})
      for(const Index c : corners)
        faces += (faces.empty() ? "" : ", ") + m_soup.name_of_face(m_face[c]);
    reject_file(m_file_name, edge + " has " + std::to_string(there.size() + back.size()) + " faces: " + faces
                               + advice());
  }

  // The faces around a vertex form one part without a border, or parts with two border edges each.
  void check_vertices()
  {
    std::vector<Index> corner_of(2 * std::size_t(m_number_of_edges), none); // halfedges along the border have none
    for(std::size_t c = 0; c < m_halfedge.size(); ++c)
      corner_of[m_halfedge[c]] = static_cast<Index>(c);
    for(std::size_t v = 0; v + 1 < m_first.size(); ++v)
      check_vertex(static_cast<Index>(v), corner_of);
  }

  void check_vertex(Index v, const std::vector<Index>& corner_of)
  {
    const Index degree = m_first[v + 1] - m_first[v];
    Index number_of_borders = 0; // border edges that lead away from v in a face
    for(Index i = m_first[v]; i < m_first[v + 1]; ++i)
      number_of_borders += corner_of[m_halfedge[m_corners[i]] ^ 1u] == none ? 1 : 0;
    m_has_pinched_vertices = m_has_pinched_vertices || number_of_borders > 1;
    // walk through each part, from its border edge if it has one
    Index reached = 0;
    for(Index i = m_first[v]; i < m_first[v + 1]; ++i)
    {
      const Index first = m_corners[i];
      if(number_of_borders > 0 && corner_of[m_halfedge[first] ^ 1u] != none)
        continue;
      Index c = first;
      do
      {
        ++reached;
        c = corner_of[m_halfedge[corner_before(c)] ^ 1u];
      } while(c != none && c != first);
      if(number_of_borders == 0)
        break;
    }
    if(reached != degree)
      reject_file(m_file_name, "several parts of the surface meet at vertex " + std::to_string(v) + advice());
  }

  Index corner_before(Index c) const
  {
    const std::size_t f = m_face[c];
    return c == m_soup.begin_of(f) ? static_cast<Index>(m_soup.ends[f] - 1) : c - 1;
  }

  void connect_faces(Mesh& mesh) const
  {
    for(std::size_t f = 0; f < m_soup.number_of_faces(); ++f)
    {
      const std::size_t begin = m_soup.begin_of(f), end = m_soup.ends[f];
      const Face face(static_cast<Mesh::size_type>(f));
      mesh.set_halfedge(face, Halfedge(m_halfedge[begin]));
      for(std::size_t c = begin; c < end; ++c)
      {
        const Halfedge h(m_halfedge[c]);
        mesh.set_face(h, face);
        mesh.set_target(h, Vertex(m_target[c]));
        mesh.set_target(mesh.opposite(h), Vertex(m_soup.corners[c]));
        mesh.set_next(h, Halfedge(m_halfedge[c + 1 < end ? c + 1 : begin]));
        mesh.set_halfedge(Vertex(m_target[c]), h);
      }
    }
  }

  // Without pinched vertices, each border vertex has one halfedge along the border that leaves it.
  void connect_borders(Mesh& mesh) const
  {
    std::vector<Index> leaving(m_soup.points.size(), none);
    for(Index h = 0; h < 2 * m_number_of_edges; ++h)
      if(mesh.is_border(Halfedge(h)))
        leaving[mesh.source(Halfedge(h)).idx()] = h;
    for(Index h = 0; h < 2 * m_number_of_edges; ++h)
      if(mesh.is_border(Halfedge(h)))
      {
        const Vertex v = mesh.target(Halfedge(h));
        mesh.set_next(Halfedge(h), Halfedge(leaving[v.idx()]));
        mesh.set_halfedge(v, Halfedge(h)); // as Surface_mesh expects of a vertex on the border
      }
  }

  static std::string advice() { return "; --repair may mend it"; }

  std::string m_file_name;
  const Polygon_soup& m_soup;
  std::vector<Index> m_target, m_face, m_first, m_corners, m_halfedge;
  Mesh::size_type m_number_of_edges = 0;
  bool m_has_pinched_vertices = false;
};

// Where several parts of the surface meet at a vertex, the order of the borders around it follows from the order of the
// faces. Surface_mesh::add_face() knows how.
Mesh connected_by_faces(const std::string& file_name, const Polygon_soup& soup)
{
  Mesh mesh;
  for(const Point& p : soup.points)
    mesh.add_vertex(p);
  std::vector<Vertex> corners;
  for(std::size_t f = 0; f < soup.number_of_faces(); ++f)
  {
    corners.clear();
    for(std::size_t c = soup.begin_of(f); c < soup.ends[f]; ++c)
      corners.push_back(Vertex(soup.corners[c]));
    const Face face = mesh.add_face(corners);
    if(face == Mesh::null_face())
      reject_file(file_name, soup.name_of_face(f) + " does not fit the faces before it: too many parts of the surface "
                                                    "meet at a vertex; --repair may mend it");
    while(mesh.source(mesh.halfedge(face)) != corners[0])
      mesh.set_halfedge(face, mesh.next(mesh.halfedge(face)));
  }
  return mesh;
}

} // namespace

Mesh connected(const std::string& file_name, const Polygon_soup& soup)
{
  const Surface_builder builder(file_name, soup);
  return builder.has_pinched_vertices() ? connected_by_faces(file_name, soup) : builder.mesh();
}

} // namespace geodesics_demo
