#ifndef SURFACE_MESH_GEODESICS_PATH_TEST_HELPERS_H
#define SURFACE_MESH_GEODESICS_PATH_TEST_HELPERS_H

// Paths of Surface_mesh_geodesic_paths, recorded and checked: length, points, elements, end.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_meshes {

using Paths_traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Geodesic_paths = CGAL::Surface_mesh_geodesic_paths<Paths_traits>;

// A point of a mesh as the tests give it: a vertex, or a location in a face.
template <class Paths>
struct Surface_point_of
{
  typename Paths::vertex_descriptor vertex = Paths::Graph_traits::null_vertex();
  typename Paths::Face_location location{};

  Surface_point_of(typename Paths::vertex_descriptor v) : vertex(v) {}
  Surface_point_of(const typename Paths::Face_location& l) : location(l) {}
  bool is_vertex() const { return vertex != Paths::Graph_traits::null_vertex(); }
};

using Surface_point = Surface_point_of<Geodesic_paths>;

// Names a point in messages.
template <class Any_point>
std::string description(const Any_point& p)
{
  std::ostringstream out;
  out.precision(17);
  if(p.is_vertex())
  {
    out << "vertex " << p.vertex;
  }
  else
  {
    out << "face " << p.location.first << " (" << p.location.second[0] << " " << p.location.second[1] << " "
        << p.location.second[2] << ")";
  }
  return out.str();
}

// One element of a path, as the visitor gets it.
template <class Paths>
struct Path_item
{
  enum Kind
  {
    VERTEX,
    EDGE,
    FACE
  };
  Kind kind = VERTEX;
  typename Paths::vertex_descriptor vertex{};
  typename Paths::halfedge_descriptor halfedge{};
  double t = 0.;
  typename Paths::face_descriptor face{};
  typename Paths::Barycentric_coordinates coordinates{};
};

template <class Paths>
struct Path_recorder
{
  std::vector<Path_item<Paths>> items;

  void operator()(typename Paths::halfedge_descriptor h, const typename Paths::FT& t)
  {
    Path_item<Paths> item;
    item.kind = Path_item<Paths>::EDGE;
    item.halfedge = h;
    item.t = CGAL::to_double(t);
    items.push_back(item);
  }

  void operator()(typename Paths::vertex_descriptor v)
  {
    Path_item<Paths> item;
    item.vertex = v;
    items.push_back(item);
  }

  void operator()(typename Paths::face_descriptor f, const typename Paths::Barycentric_coordinates& b)
  {
    Path_item<Paths> item;
    item.kind = Path_item<Paths>::FACE;
    item.face = f;
    item.coordinates = b;
    items.push_back(item);
  }
};

// The answer to a query: the distance and the number of the source, in the order of the sources.
struct Answer
{
  double distance;
  std::size_t source;
};

template <class Paths>
std::size_t number_of(typename Paths::Source_point_iterator it, const Paths& paths)
{
  std::size_t i = 0;
  for(auto other = paths.source_points_begin(); other != paths.source_points_end(); ++other, ++i)
  {
    if(other == it)
    {
      return i;
    }
  }
  return no_source;
}

// `Paths` may be const.
template <class Paths, class Any_point>
Answer ask(Paths& paths, const Any_point& q)
{
  const auto result = q.is_vertex() ? paths.shortest_distance_to_source_points(q.vertex)
                                    : paths.shortest_distance_to_source_points(q.location.first, q.location.second);
  return {CGAL::to_double(result.first), number_of(result.second, paths)};
}

template <class Paths, class Any_point, class Visitor>
Answer ask_sequence(Paths& paths, const Any_point& q, Visitor& visitor)
{
  const auto result =
    q.is_vertex() ? paths.shortest_path_sequence_to_source_points(q.vertex, visitor)
                  : paths.shortest_path_sequence_to_source_points(q.location.first, q.location.second, visitor);
  return {CGAL::to_double(result.first), number_of(result.second, paths)};
}

template <class Paths, class Any_point, class Output>
Answer ask_points(Paths& paths, const Any_point& q, Output output)
{
  const auto result =
    q.is_vertex() ? paths.shortest_path_points_to_source_points(q.vertex, output)
                  : paths.shortest_path_points_to_source_points(q.location.first, q.location.second, output);
  return {CGAL::to_double(result.first), number_of(result.second, paths)};
}

template <class Paths, class Any_point, class Output>
Answer ask_polyline(Paths& paths, const Any_point& q, Output output)
{
  const auto result =
    q.is_vertex() ? paths.shortest_path_polyline_to_source_points(q.vertex, output)
                  : paths.shortest_path_polyline_to_source_points(q.location.first, q.location.second, output);
  return {CGAL::to_double(result.first), number_of(result.second, paths)};
}

template <class Point>
Coordinates to_coordinates(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

// Returns the faces that contain the point of an item: all faces around an edge or a vertex.
template <class Paths, class TriangleMesh>
std::vector<typename Paths::face_descriptor> faces_of_item(Path_item<Paths> item, const TriangleMesh& tm)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  std::vector<typename Paths::face_descriptor> result;
  if(item.kind == Path_item<Paths>::FACE)
  {
    const auto h = halfedge(item.face, tm);
    const std::array<typename Paths::halfedge_descriptor, 3> sides{h, next(h, tm), next(next(h, tm), tm)};
    std::vector<std::size_t> positive;
    for(std::size_t k = 0; k < 3; ++k)
    {
      if(CGAL::to_double(item.coordinates[k]) > 64 * std::numeric_limits<double>::epsilon())
      {
        positive.push_back(k);
      }
    }
    if(positive.size() == 3)
    {
      result.push_back(item.face);
      return result;
    }
    if(positive.size() == 2)
    {
      item.kind = Path_item<Paths>::EDGE;
      item.halfedge = positive[0] == 0 && positive[1] == 2 ? sides[2] : sides[positive[0]];
    }
    else
    {
      item.kind = Path_item<Paths>::VERTEX;
      item.vertex = source(sides[positive[0]], tm);
    }
  }
  if(item.kind == Path_item<Paths>::EDGE)
  {
    result = {face(item.halfedge, tm), face(opposite(item.halfedge, tm), tm)};
  }
  else if(halfedge(item.vertex, tm) != Traits::null_halfedge())
  {
    // a vertex at which several fans of faces meet has only one of them around halfedge(v, tm)
    for(const auto f : faces(tm))
    {
      for(const auto v : CGAL::vertices_around_face(halfedge(f, tm), tm))
      {
        if(v == item.vertex)
        {
          result.push_back(f);
        }
      }
    }
  }
  result.erase(std::remove(result.begin(), result.end(), Traits::null_face()), result.end());
  return result;
}

template <class Paths>
Coordinates point_of_item(const Path_item<Paths>& item, const Paths& paths)
{
  if(item.kind == Path_item<Paths>::FACE)
  {
    return to_coordinates(paths.point(item.face, item.coordinates));
  }
  if(item.kind == Path_item<Paths>::EDGE)
  {
    return to_coordinates(paths.point(item.halfedge, typename Paths::FT(item.t)));
  }
  return to_coordinates(paths.point(item.vertex));
}

inline double polyline_length(const std::vector<Coordinates>& points)
{
  double sum = 0.;
  for(std::size_t i = 1; i < points.size(); ++i)
  {
    sum += length(points[i] - points[i - 1]);
  }
  return sum;
}

// Checks the polyline of a path against its points and elements: each segment lies in the face that is given with its
// end.
template <class Paths, class Any_point, class TriangleMesh>
void check_polyline(Paths& paths, const Any_point& q, const TriangleMesh& tm, const Answer& answer,
                    const std::vector<Path_item<std::remove_const_t<Paths>>>& items,
                    const std::vector<typename Paths::Point_3>& points)
{
  std::vector<std::pair<typename Paths::Point_3, typename Paths::face_descriptor>> polyline;
  const Answer of_polyline = ask_polyline(paths, q, std::back_inserter(polyline));
  CHECK_EQUAL(of_polyline.distance, answer.distance);
  CHECK_EQUAL(of_polyline.source, answer.source);
  if(!CHECK_EQUAL(polyline.size(), points.size()) || polyline.size() != items.size())
  {
    return;
  }
  for(std::size_t i = 0; i < polyline.size(); ++i)
  {
    CHECK(polyline[i].first == points[i]);
    if(i == 0)
    {
      CHECK(polyline[i].second == boost::graph_traits<TriangleMesh>::null_face());
      continue;
    }
    for(const auto& end : {items[i - 1], items[i]})
    {
      const auto around = faces_of_item(end, tm);
      CHECK(std::find(around.begin(), around.end(), polyline[i].second) != around.end());
    }
  }
}

// Checks that all elements are on the surface, that only the ends are inside faces, and that elements that follow each
// other share a face.
template <class Paths, class TriangleMesh>
void check_items(const std::vector<Path_item<Paths>>& items, const TriangleMesh& tm)
{
  using Item = Path_item<Paths>;
  for(const Item& item : items)
  {
    if(item.kind == Item::EDGE)
    {
      CHECK(item.t >= 0. && item.t <= 1.);
    }
    else if(item.kind == Item::FACE)
    {
      for(std::size_t k = 0; k < 3; ++k)
      {
        const double b = CGAL::to_double(item.coordinates[k]);
        CHECK(b > -1e-12 && b < 1. + 1e-12);
      }
    }
  }
  for(std::size_t i = 1; i + 1 < items.size(); ++i)
  {
    CHECK(items[i].kind != Item::FACE);
  }
  for(std::size_t i = 1; i < items.size(); ++i)
  {
    const auto before = faces_of_item(items[i - 1], tm);
    const auto after = faces_of_item(items[i], tm);
    CHECK(std::find_first_of(before.begin(), before.end(), after.begin(), after.end()) != before.end());
  }
}

// Checks that a path begins at the query and ends at its source.
template <class Paths, class Any_point>
void check_ends(Paths& paths, const Any_point& q, const Answer& answer,
                const std::vector<Path_item<std::remove_const_t<Paths>>>& items,
                const std::vector<Coordinates>& points, double size)
{
  using Item = Path_item<std::remove_const_t<Paths>>;
  if(q.is_vertex())
  {
    CHECK(items.front().kind == Item::VERTEX && items.front().vertex == q.vertex);
  }
  else
  {
    CHECK(items.front().kind == Item::FACE && items.front().face == q.location.first);
    CHECK(items.front().coordinates == q.location.second);
  }
  auto source = paths.source_points_begin();
  std::advance(source, static_cast<std::ptrdiff_t>(answer.source));
  if(source->first == Paths::Graph_traits::null_face()) // an isolated vertex
  {
    CHECK_EQUAL(points.size(), 1u);
    CHECK_EQUAL(answer.distance, 0.);
  }
  else
  {
    CHECK_NEAR(length(points.back() - to_coordinates(paths.point(source->first, source->second))), 0., 1e-13 * size);
  }
}

// Returns the points of the elements, without a point that rounding makes equal to the one before.
template <class Paths>
std::vector<Coordinates> points_of_items(const std::vector<Path_item<std::remove_const_t<Paths>>>& items, Paths& paths)
{
  std::vector<Coordinates> points;
  for(const auto& item : items)
  {
    const Coordinates p = point_of_item(item, paths);
    if(points.empty() || p != points.back())
    {
      points.push_back(p);
    }
  }
  return points;
}

// Queries the path with all members, checks it and returns its points. `size` is the size of the coordinates, for
// distances that are much smaller.
template <class Paths, class Any_point, class TriangleMesh>
std::vector<Coordinates> checked_path(Paths& paths, const Any_point& q, const TriangleMesh& tm, double size,
                                      double tolerance = 1e-10)
{
  using Plain_paths = std::remove_const_t<Paths>;
  const Answer answer = ask(paths, q);
  Path_recorder<Plain_paths> recorder;
  const Answer of_sequence = ask_sequence(paths, q, recorder);
  std::vector<typename Plain_paths::Point_3> raw_points;
  const Answer of_points = ask_points(paths, q, std::back_inserter(raw_points));
  CHECK_EQUAL(of_sequence.distance, answer.distance);
  CHECK_EQUAL(of_sequence.source, answer.source);
  CHECK_EQUAL(of_points.distance, answer.distance);
  CHECK_EQUAL(of_points.source, answer.source);
  std::vector<Coordinates> points;
  for(const auto& p : raw_points)
  {
    points.push_back(to_coordinates(p));
  }
  CHECK(points == points_of_items(recorder.items, paths));
  check_polyline(paths, q, tm, answer, recorder.items, raw_points);
  if(answer.distance < 0.)
  {
    CHECK_EQUAL(answer.distance, -1.);
    CHECK_EQUAL(answer.source, no_source);
    CHECK(points.empty());
    return points;
  }
  if(!CHECK(!points.empty()) || !CHECK(answer.source != no_source))
  {
    return points;
  }
  check_items(recorder.items, tm);
  for(std::size_t i = 1; i < points.size(); ++i)
  {
    CHECK(points[i - 1] != points[i]);
  }
  const double path_length = polyline_length(points);
  if(std::abs(path_length - answer.distance) > 1e-14 * size)
  {
    CHECK_CLOSE(path_length, answer.distance, tolerance);
  }
  check_ends(paths, q, answer, recorder.items, points, size);
  return points;
}

// Checks the distance and the path of each vertex. The mesh has the size `size`.
template <class Paths>
void check_paths_of_vertices(Paths& paths, const Mesh& tm, const std::vector<double>& expected, double size,
                             double tolerance)
{
  CHECK_EQUAL(num_vertices(tm), expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i)
  {
    CHECK_CLOSE(ask(paths, Surface_point(vertex(i))).distance, expected[i], tolerance);
    checked_path(paths, Surface_point(vertex(i)), tm, size);
  }
}

// Returns a random vertex, or a random location in a face.
inline Surface_point random_vertex_or_location(bool is_vertex, const Mesh& tm, test_support::Random& random)
{
  return is_vertex ? Surface_point(random_vertex(tm, random)) : Surface_point(random_location(tm, random));
}

inline double size_of(const Mesh& tm)
{
  double size = 0.;
  for(const vertex_descriptor v : vertices(tm))
  {
    size = (std::max)(size, length(coordinates(v, tm)));
  }
  return size;
}

template <class Paths, class Any_point>
typename Paths::Source_point_iterator add(Paths& paths, const Any_point& s)
{
  return s.is_vertex() ? paths.add_source_point(s.vertex) : paths.add_source_point(s.location.first, s.location.second);
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_PATH_TEST_HELPERS_H
