// Faces to avoid: distances and paths are those of the mesh without these faces, bit by bit, and in the plane those of
// a visibility graph. Sources and queries at the rim, invalid input.

#include "expected_exceptions.h"
#include "faces_to_avoid.h"
#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>

#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;
using CGAL::Surface_mesh_geodesics::Invalid_geodesic_input;
using CGAL::Surface_mesh_geodesics::geodesic_distances;

namespace {

using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
using Filtered = CGAL::Face_filtered_graph<Mesh>;

// The distances of a filtered graph, infinity for vertices that it does not have.
std::map<vertex_descriptor, double> distances_in_filtered_graph(const Mesh& tm,
                                                                const std::vector<face_descriptor>& rest,
                                                                const Face_location& source)
{
  const Filtered filtered(tm, rest);
  std::map<vertex_descriptor, double> distance;
  for(const vertex_descriptor v : vertices(tm))
    distance[v] = std::numeric_limits<double>::infinity();
  geodesic_distances(filtered, boost::make_assoc_property_map(distance), source);
  return distance;
}

double distance_of(const Paths& paths, vertex_descriptor v)
{
  const double d = paths.shortest_distance_to_source_points(v).first;
  return d < 0 ? std::numeric_limits<double>::infinity() : d;
}

// --- the same bits as without the faces ---

void check_against_filtered_graph(const Mesh& tm, double part, test_support::Random& random)
{
  const std::vector<face_descriptor> avoided = random_faces(tm, part, random), rest = other_faces(tm, avoided);
  if(avoided.empty() || rest.empty())
    return;
  Face_location source(rest[random.index(rest.size())], {.2, .3, .5});
  if(random.index(3) == 0)
    source.second = {0, .25, .75};
  if(random.index(3) == 0)
    source.second = {0, 0, 1};
  const auto expected = distances_in_filtered_graph(tm, rest, source);
  Paths paths(tm);
  paths.avoid_faces(avoided);
  paths.add_source_point(source.first, {{source.second[0], source.second[1], source.second[2]}});
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(distance_of(paths, v), expected.at(v));
    // No path crosses a face to avoid.
    std::vector<std::pair<Kernel::Point_3, face_descriptor>> polyline;
    paths.shortest_path_polyline_to_source_points(v, std::back_inserter(polyline));
    for(std::size_t i = 1; i < polyline.size(); ++i)
      CHECK(std::count(avoided.begin(), avoided.end(), polyline[i].second) == 0);
  }
  // The same by a property map; and everything as before without faces to avoid.
  std::map<face_descriptor, bool> is_avoided;
  for(const face_descriptor f : faces(tm))
    is_avoided[f] = std::count(avoided.begin(), avoided.end(), f) > 0;
  paths.avoid_faces(boost::make_assoc_property_map(is_avoided));
  for(const vertex_descriptor v : vertices(tm))
    CHECK_EQUAL(distance_of(paths, v), expected.at(v));
  Paths whole(tm);
  whole.add_source_point(source.first, {{source.second[0], source.second[1], source.second[2]}});
  paths.avoid_faces(std::vector<face_descriptor>());
  for(const vertex_descriptor v : vertices(tm))
    CHECK_EQUAL(distance_of(paths, v), distance_of(whole, v));
}

// Samples and relaxed sites are those of the mesh without the faces. The vertices of a filtered graph have another
// order, which decides ties; so the meshes have none.
void samples_and_sites()
{
  const test_support::Scope scope("samples and sites");
  for(std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    test_support::Random random(seed);
    const Mesh tm = to_face_graph(noisy_sphere(3, .1, seed));
    const std::vector<face_descriptor> avoided = random_faces(tm, .15, random), rest = other_faces(tm, avoided);
    const Filtered filtered(tm, rest);
    const std::vector<vertex_descriptor> first{target(halfedge(rest[0], tm), tm)};
    std::vector<vertex_descriptor> expected, samples, by_map;
    const auto np = CGAL::parameters::first_samples(first);
    const double radius = CGAL::Surface_mesh_geodesics::geodesic_farthest_point_sampling(
      filtered, 30, std::back_inserter(expected), np);
    const double found = CGAL::Surface_mesh_geodesics::geodesic_farthest_point_sampling(
      tm, 30, std::back_inserter(samples), np.faces_to_avoid(avoided));
    const auto is_avoided = boost::make_function_property_map<face_descriptor>(
      [&](face_descriptor f) { return std::count(avoided.begin(), avoided.end(), f) > 0; });
    CGAL::Surface_mesh_geodesics::geodesic_farthest_point_sampling(tm, 30, std::back_inserter(by_map),
                                                                   np.faces_to_avoid(is_avoided));
    CHECK(!samples.empty() && samples == expected && samples == by_map);
    CHECK_EQUAL(found, radius);
    samples.push_back(first[0]);
    std::vector<vertex_descriptor> relaxed, expected_sites, free;
    const std::size_t n = CGAL::Surface_mesh_geodesics::geodesic_Lloyd_relaxation(
      tm, samples, std::back_inserter(relaxed), CGAL::parameters::faces_to_avoid(avoided).number_of_iterations(4));
    CHECK_EQUAL(n, CGAL::Surface_mesh_geodesics::geodesic_Lloyd_relaxation(
                     filtered, samples, std::back_inserter(expected_sites),
                     CGAL::parameters::number_of_iterations(4)));
    CHECK(relaxed == expected_sites);
    CGAL::Surface_mesh_geodesics::geodesic_Lloyd_relaxation(tm, samples, std::back_inserter(free),
                                                            CGAL::parameters::number_of_iterations(4));
    CHECK(relaxed != free);
  }
}

void test_against_filtered_graph()
{
  test_support::Random random(1);
  for(const Indexed_mesh& indexed : small_collection(3))
  {
    const test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    for(const double part : {.02, .1, .3, .6})
      check_against_filtered_graph(tm, part, random);
  }
  for(std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const test_support::Scope scope("hostile " + std::to_string(seed));
    test_support::Random random_of_mesh(seed);
    Mesh tm;
    if(hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random_of_mesh), tm))
      check_against_filtered_graph(tm, .2, random);
  }
}

// --- the other functions and classes: against the mesh without the faces ---

// The diagram of two sites: cells have the areas of those on the mesh without the faces, and labels agree.
void check_diagram(const Mesh& tm, const Mesh& without, const std::vector<face_descriptor>& avoided,
                   vertex_descriptor v, vertex_descriptor w)
{
  namespace SMG = CGAL::Surface_mesh_geodesics;
  const std::vector<vertex_descriptor> ends{v, w};
  using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
  Diagram a(tm), b(without);
  a.avoid_faces(avoided);
  for(Diagram* d : {&a, &b})
  {
    d->add_site(v);
    d->add_site(w);
    d->build();
  }
  const double size = CGAL::Polygon_mesh_processing::area(tm);
  for(std::size_t i = 0; i < 2; ++i)
    CHECK_NEAR(a.area(i), b.area(i), 1e-9 * size);
  CHECK_EQUAL(a.arcs().size(), b.arcs().size());
  Mesh cut_a, cut_b;
  std::map<face_descriptor, std::size_t> site_a, site_b;
  a.cut(cut_a, boost::make_assoc_property_map(site_a), 1e-3 * std::sqrt(size));
  b.cut(cut_b, boost::make_assoc_property_map(site_b), 1e-3 * std::sqrt(size));
  CHECK_EQUAL(num_faces(cut_a), num_faces(cut_b));
  for(const vertex_descriptor u : vertices(tm))
    if(!without.is_removed(u)) // Euler::remove_face() removes vertices without faces
      CHECK_EQUAL(a.distance_to_nearest_site(u), b.distance_to_nearest_site(u));
  CHECK(SMG::certify_geodesic_Voronoi_diagram(a).is_certified());
  std::map<vertex_descriptor, std::size_t> labels;
  SMG::geodesic_Voronoi_labels(tm, boost::make_assoc_property_map(labels), ends,
                               CGAL::parameters::faces_to_avoid(avoided));
  for(const vertex_descriptor u : vertices(tm))
    CHECK_EQUAL(labels[u], a.nearest_site(u));
}

void test_all_functions()
{
  namespace np = CGAL::parameters;
  namespace SMG = CGAL::Surface_mesh_geodesics;
  test_support::Random random(8);
  for(const Indexed_mesh& indexed : small_collection(5))
  {
    const test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    const std::vector<face_descriptor> avoided = random_faces(tm, .15, random), rest = other_faces(tm, avoided);
    if(avoided.empty() || rest.size() < 2)
      continue;
    // The same vertices, without the faces.
    Mesh without = tm;
    for(const face_descriptor f : avoided)
      CGAL::Euler::remove_face(halfedge(f, without), without);
    const Face_location source(rest[0], {.2, .3, .5});
    const vertex_descriptor v = target(halfedge(rest[0], tm), tm), w = target(halfedge(rest.back(), tm), tm);
    const auto expected = distances_in_filtered_graph(tm, rest, source);
    std::map<vertex_descriptor, double> distance;
    CHECK(geodesic_distances(tm, boost::make_assoc_property_map(distance), source, np::faces_to_avoid(avoided)));
    CHECK(distance == expected);
    std::map<face_descriptor, bool> flags;
    for(const face_descriptor f : avoided)
      flags[f] = true;
    distance.clear();
    CHECK(geodesic_distances(tm, boost::make_assoc_property_map(distance), source,
                             np::faces_to_avoid(boost::make_assoc_property_map(flags)).maximum_distance(1e9)));
    CHECK(distance == expected);
    distance.clear();
    CHECK(geodesic_distances(tm, boost::make_assoc_property_map(distance), source,
                             np::faces_to_avoid(std::cref(avoided))));
    CHECK(distance == expected);
    const auto lengths = boost::make_function_property_map<boost::graph_traits<Mesh>::edge_descriptor>(
      [&](boost::graph_traits<Mesh>::edge_descriptor e)
      { return std::sqrt(CGAL::squared_distance(tm.point(CGAL::source(e, tm)), tm.point(target(e, tm)))); });
    distance.clear();
    SMG::geodesic_distances_from_edge_lengths(tm, lengths, boost::make_assoc_property_map(distance), source,
                                              np::faces_to_avoid(avoided));
    for(const auto& d : distance)
      CHECK_CLOSE(d.second, expected.at(d.first), 1e-12);
    auto solver = SMG::Geodesic_distance_solver<Mesh>::avoiding_faces(tm, avoided);
    solver.compute_distances(source);
    for(const auto& d : expected)
      CHECK_EQUAL(solver.distance(d.first), d.second);
    const std::vector<vertex_descriptor> ends{v, w};
    std::vector<double> row;
    SMG::geodesic_distance_matrix(
      tm, ends, ends,
      [&](std::size_t, const std::vector<double>& r) { row.insert(row.end(), r.begin(), r.end()); return true; },
      np::faces_to_avoid(avoided));
    Paths paths(tm);
    paths.avoid_faces(avoided);
    paths.add_source_point(v);
    CHECK_EQUAL(row.size(), 4u);
    CHECK_CLOSE(row[1], distance_of(paths, w), 1e-14);
    check_diagram(tm, without, avoided, v, w);
  }
}

// --- the plane: the shortest way in a visibility graph ---

struct Point
{
  double x, y;
};

double cross(const Point& a, const Point& b, const Point& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Does the segment pass through the inside of a triangle, farther in than rounding?
bool crosses(const Point& p, const Point& q, const std::array<Point, 3>& t)
{
  double from = 0, to = 1;
  for(std::size_t k = 0; k < 3; ++k)
  {
    const double at_p = cross(t[k], t[(k + 1) % 3], p) - 1e-12, at_q = cross(t[k], t[(k + 1) % 3], q) - 1e-12;
    if(at_p <= 0 && at_q <= 0)
      return false;
    if(at_p < 0)
      from = (std::max)(from, at_p / (at_p - at_q));
    if(at_q < 0)
      to = (std::min)(to, at_p / (at_p - at_q));
  }
  return to > from + 1e-9;
}

// A square without some triangles: which vertices see each other.
class Visibility
{
public:
  Visibility(const Mesh& tm, const std::vector<face_descriptor>& avoided)
  {
    const std::set<face_descriptor> set(avoided.begin(), avoided.end());
    is_open.resize(num_vertices(tm), false);
    for(const vertex_descriptor v : vertices(tm))
    {
      p.push_back({tm.point(v).x(), tm.point(v).y()});
      m_is_at_border.push_back(static_cast<bool>(CGAL::is_border(v, tm)));
      m_low = {(std::min)(m_low.x, p.back().x), (std::min)(m_low.y, p.back().y)};
      m_high = {(std::max)(m_high.x, p.back().x), (std::max)(m_high.y, p.back().y)};
    }
    for(const face_descriptor f : faces(tm))
    {
      std::vector<std::size_t> corner;
      for(const vertex_descriptor v : vertices_around_face(halfedge(f, tm), tm))
        corner.push_back(v);
      if(set.count(f) != 0)
        m_triangles.push_back({p[corner[0]], p[corner[1]], p[corner[2]]});
      for(std::size_t k = 0; k < 3; ++k)
      {
        const auto e = std::minmax(corner[k], corner[(k + 1) % 3]);
        m_edges.insert(e);
        if(set.count(f) == 0)
        {
          is_open[corner[k]] = true;
          m_open_edges.insert(e);
        }
      }
    }
  }

  bool is_visible(std::size_t i, std::size_t j) const
  {
    const std::pair<std::size_t, std::size_t> e = std::minmax(i, j);
    if(m_edges.count(e) != 0)
      return m_open_edges.count(e) != 0;
    // Along the border of the square, the way is from vertex to vertex.
    const bool is_along_x = p[i].y == p[j].y && (p[i].y == m_low.y || p[i].y == m_high.y);
    const bool is_along_y = p[i].x == p[j].x && (p[i].x == m_low.x || p[i].x == m_high.x);
    if(m_is_at_border[i] && m_is_at_border[j] && (is_along_x || is_along_y))
      return false;
    return std::none_of(m_triangles.begin(), m_triangles.end(),
                        [&](const std::array<Point, 3>& t) { return crosses(p[i], p[j], t); });
  }

  // The lengths of the shortest ways from a vertex, by Dijkstra's method on the complete graph.
  std::vector<double> distances(std::size_t source) const
  {
    const std::size_t n = p.size();
    std::vector<double> d(n, std::numeric_limits<double>::infinity());
    std::vector<bool> is_done(n, false);
    d[source] = 0;
    for(std::size_t round = 0; round < n; ++round)
    {
      std::size_t i = n;
      for(std::size_t k = 0; k < n; ++k)
        if(!is_done[k] && std::isfinite(d[k]) && (i == n || d[k] < d[i]))
          i = k;
      if(i == n)
        break;
      is_done[i] = true;
      for(std::size_t j = 0; j < n; ++j)
      {
        const double l = std::hypot(p[i].x - p[j].x, p[i].y - p[j].y);
        if(!is_done[j] && is_open[j] && d[i] + l < d[j] && is_visible(i, j))
          d[j] = d[i] + l;
      }
    }
    return d;
  }

  std::vector<Point> p;
  std::vector<bool> is_open; // is the vertex in a face that is left?

private:
  Point m_low{1e9, 1e9}, m_high{-1e9, -1e9};
  std::vector<bool> m_is_at_border;
  std::set<std::pair<std::size_t, std::size_t>> m_open_edges, m_edges;
  std::vector<std::array<Point, 3>> m_triangles;
};

void test_visibility_graph()
{
  std::size_t blocked = 0, unreached = 0;
  double worst = 0;
  for(std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    const test_support::Scope scope("polygon " + std::to_string(seed));
    test_support::Random random(seed);
    const Mesh tm = to_face_graph(flat_patch(6, 6, .15, true, seed));
    const std::vector<face_descriptor> avoided = random_faces(tm, random.uniform(.05, .5), random);
    const Visibility graph(tm, avoided);
    const std::vector<Point>& p = graph.p;
    const std::size_t n = p.size();
    std::size_t source = random.index(n);
    while(!graph.is_open[source])
      source = (source + 1) % n;
    const std::vector<double> d = graph.distances(source);
    Paths paths(tm);
    paths.avoid_faces(avoided);
    paths.add_source_point(vertex_descriptor(static_cast<Mesh::size_type>(source)));
    for(std::size_t j = 0; j < n; ++j)
    {
      const double found = distance_of(paths, vertex_descriptor(static_cast<Mesh::size_type>(j)));
      CHECK_CLOSE(found, d[j], 1e-12);
      if(!(std::isfinite(d[j])))
        ++unreached;
      else if(d[j] > std::hypot(p[source].x - p[j].x, p[source].y - p[j].y) + 1e-6)
        ++blocked;
      if(std::isfinite(d[j]) && d[j] > 0)
        worst = (std::max)(worst, std::abs(found - d[j]) / d[j]);
    }
  }
  std::cout << "visibility graphs: " << blocked << " ways around obstacles, " << unreached << " vertices not reached, "
            << "worst relative difference " << worst << "\n";
  CHECK(blocked > 2000 && unreached > 100);
}

// --- the rim ---

void test_rim()
{
  const test_support::Scope scope("rim");
  const Mesh tm = to_face_graph(flat_patch(6, 6, 0., false, 1));
  for(const face_descriptor f : faces(tm))
  {
    const std::vector<face_descriptor> avoided{f};
    const auto h = halfedge(f, tm);
    auto g = h;
    for(std::size_t k = 0; k < 3; ++k, g = next(g, tm))
    {
      // The middle of a side, in the face to avoid and in its neighbor.
      const bool is_border = CGAL::is_border(opposite(g, tm), tm);
      Face_location inside(f, {0, 0, 0});
      inside.second[k] = .25;
      inside.second[(k + 1) % 3] = .75;
      Paths a(tm), b(tm);
      a.avoid_faces(avoided);
      b.avoid_faces(avoided);
      a.add_source_point(inside.first, {{inside.second[0], inside.second[1], inside.second[2]}});
      if(is_border)
      {
        CHECK(throws<Invalid_geodesic_input>([&] { a.build_sequence_tree(); }));
        continue;
      }
      const face_descriptor other = face(opposite(g, tm), tm);
      Face_location outside(other, {0, 0, 0});
      auto o = halfedge(other, tm);
      for(std::size_t i = 0; i < 3; ++i, o = next(o, tm))
        outside.second[i] = source(o, tm) == source(g, tm) ? .25 : source(o, tm) == target(g, tm) ? .75 : 0;
      b.add_source_point(outside.first, {{outside.second[0], outside.second[1], outside.second[2]}});
      for(const vertex_descriptor v : vertices(tm))
        CHECK_EQUAL(distance_of(a, v), distance_of(b, v));
      // Queries at the rim, too.
      CHECK(a.shortest_distance_to_source_points(inside.first, {{inside.second[0], inside.second[1], inside.second[2]}})
              .first < 1e-14);
      CHECK(throws<Invalid_geodesic_input>(
        [&] { a.shortest_distance_to_source_points(f, {{.25, .25, .5}}); }));
      // A corner in the face to avoid.
      Face_location corner(f, {0, 0, 0});
      corner.second[k] = 1;
      Paths c(tm), d(tm);
      c.avoid_faces(avoided);
      d.avoid_faces(avoided);
      c.add_source_point(corner.first, {{corner.second[0], corner.second[1], corner.second[2]}});
      d.add_source_point(source(g, tm));
      for(const vertex_descriptor v : vertices(tm))
        CHECK_EQUAL(distance_of(c, v), distance_of(d, v));
    }
  }
}

// An object without sources knows what is avoided, whether it had sources before or not.
void test_without_sources()
{
  const test_support::Scope scope("without sources");
  const Mesh tm = to_face_graph(flat_patch(6, 6, 0., false, 1));
  const face_descriptor f(30);
  const auto is_rejected = [&](const Paths& paths, const Paths::Barycentric_coordinates& b)
  { return throws<Invalid_geodesic_input>([&] { paths.shortest_distance_to_source_points(f, b); }); };
  Paths fresh(tm), used(tm);
  used.add_source_point(*vertices(tm).first);
  used.remove_all_source_points();
  CHECK_EQUAL(used.shortest_distance_to_source_points(*vertices(tm).first).first, -1.);
  for(Paths* paths : {&fresh, &used})
  {
    paths->avoid_faces(std::vector<face_descriptor>{f});
    CHECK(is_rejected(*paths, {{.25, .25, .5}}));
    CHECK_EQUAL(paths->shortest_distance_to_source_points(f, {{.25, .75, 0}}).first, -1.);
    CHECK_EQUAL(paths->shortest_distance_to_source_points(f, {{1, 0, 0}}).first, -1.);
    paths->avoid_faces(std::vector<face_descriptor>());
    CHECK_EQUAL(paths->shortest_distance_to_source_points(f, {{.25, .25, .5}}).first, -1.);
  }
}

void test_invalid_input()
{
  const test_support::Scope scope("invalid input");
  const Mesh tm = to_face_graph(icosphere(1));
  std::vector<face_descriptor> star;
  for(const face_descriptor f : faces_around_target(halfedge(vertex_descriptor(0), tm), tm))
    star.push_back(f);
  Paths paths(tm);
  paths.avoid_faces(star);
  paths.add_source_point(vertex_descriptor(0));
  const auto reason_of = [](auto call)
  {
    try
    {
      call();
    }
    catch(const Invalid_geodesic_input& error)
    {
      return error.reason();
    }
    return Invalid_geodesic_input::Reason::TOO_LARGE;
  };
  using Reason = Invalid_geodesic_input::Reason;
  CHECK(reason_of([&] { paths.build_sequence_tree(); }) == Reason::INVALID_LOCATION);
  paths.clear();
  paths.add_source_point(vertex_descriptor(0)); // clear() has forgotten the faces to avoid
  paths.build_sequence_tree();
  paths.clear();
  paths.avoid_faces(star);
  paths.add_source_point(star[0], {{.2, .3, .5}});
  CHECK(reason_of([&] { paths.build_sequence_tree(); }) == Reason::INVALID_LOCATION);
  CHECK(reason_of([&] { paths.avoid_faces(std::vector<face_descriptor>{face_descriptor(12345)}); })
        == Reason::INVALID_DESCRIPTOR);
  CHECK(reason_of([&] { paths.avoid_faces(std::vector<face_descriptor>{Mesh::null_face()}); })
        == Reason::INVALID_DESCRIPTOR);
  // All faces: nothing is left to reach.
  paths.clear();
  const auto all = faces(tm);
  paths.avoid_faces(std::vector<face_descriptor>(all.begin(), all.end()));
  paths.add_source_point(vertex_descriptor(0));
  CHECK(reason_of([&] { paths.build_sequence_tree(); }) == Reason::INVALID_LOCATION);
}

// All functions for vertices reject one inside, at either end of a path.
void test_vertices_inside()
{
  const test_support::Scope scope("vertices inside");
  const Mesh tm = to_face_graph(icosphere(1));
  std::vector<face_descriptor> star;
  for(const face_descriptor f : faces_around_target(halfedge(vertex_descriptor(0), tm), tm))
    star.push_back(f);
  const auto is_inside = [](auto call)
  { return throws_reason(Invalid_geodesic_input::Reason::INVALID_LOCATION, call); };
  namespace np = CGAL::parameters;
  using namespace CGAL::Surface_mesh_geodesics;
  const std::vector<vertex_descriptor> both{vertex_descriptor(20), vertex_descriptor(0)};
  const auto ignore = [](auto&&...) {};
  CHECK(is_inside([&] { symmetric_geodesic_distance_matrix(tm, both, ignore, np::faces_to_avoid(star)); }));
  std::vector<vertex_descriptor> samples;
  CHECK(is_inside([&]
  {
    geodesic_farthest_point_sampling(tm, 3, std::back_inserter(samples),
                                     np::faces_to_avoid(star).first_samples(both));
  }));
  std::vector<Kernel::Point_3> points;
  for(const auto& [a, b] : {std::make_pair(both[0], both[1]), std::make_pair(both[1], both[0])})
  {
    const vertex_descriptor from = a, to = b;
    CHECK(is_inside([&] { geodesic_distance(tm, from, to, np::faces_to_avoid(star)); }));
    CHECK(is_inside([&] { geodesic_path(tm, from, to, std::back_inserter(points), np::faces_to_avoid(star)); }));
  }
  CHECK(samples.empty() && points.empty());
  // A vertex of another component is not inside; nothing leads there.
  const Mesh parts = to_face_graph(two_components_and_an_isolated_vertex());
  const std::vector<face_descriptor> one(1, *faces(parts).begin());
  const double infinity = std::numeric_limits<double>::infinity();
  std::size_t unreached = 0;
  for(const vertex_descriptor v : vertices(parts))
    if(parts.is_isolated(v) || !(geodesic_distance(parts, vertex_descriptor(2), v) < infinity))
    {
      CHECK_EQUAL(geodesic_distance(parts, vertex_descriptor(2), v, np::faces_to_avoid(one)), infinity);
      ++unreached;
    }
  CHECK(unreached > 1);
}

} // namespace

int main()
{
  test_against_filtered_graph();
  samples_and_sites();
  test_all_functions();
  test_visibility_graph();
  test_rim();
  test_without_sources();
  test_invalid_input();
  test_vertices_inside();
  return test_result();
}
