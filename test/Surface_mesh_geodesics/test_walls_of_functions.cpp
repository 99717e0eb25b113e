// Edges to avoid of labels, samples, isolines, certificates and solvers from lengths: results are those of a mesh that
// has really been cut along these edges.

#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"
#include "walls_and_places.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_isolines.h>

#include <CGAL/Surface_mesh_shortest_path.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;

namespace {

using Distances = std::map<vertex_descriptor, double>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

constexpr double infinity = not_reached;

std::vector<Place> random_places(const Case& c, std::size_t n, test_support::Random& random)
{
  std::vector<Place> places;
  for(std::size_t i = 0; i < n; ++i)
    places.push_back(random_place(c.tm, c.removed, random));
  return places;
}

// A range has one type of sources: a vertex becomes a location, in a face that is there.
Face_location location_of(const Case& c, const Place& p)
{
  if(!p.is_vertex)
    return p.location;
  for(const halfedge_descriptor h : halfedges_around_source(p.vertex, c.tm))
    if(!is_border(h, c.tm) && c.removed.count(face(h, c.tm)) == 0)
    {
      Face_location result(face(h, c.tm), {0, 0, 0});
      std::size_t k = 0;
      for(auto g = halfedge(face(h, c.tm), c.tm); g != h; g = next(g, c.tm))
        ++k;
      result.second[k] = 1;
      return result;
    }
  return p.location;
}

std::vector<Face_location> locations_of(const Case& c, const std::vector<Place>& places)
{
  std::vector<Face_location> result;
  for(const Place& p : places)
    result.push_back(location_of(c, p));
  return result;
}

// --- labels ---

// Each vertex has a site that is nearest in the cut mesh, with weights and without.
void check_labels(const Case& c, test_support::Random& random)
{
  const std::vector<Place> places = random_places(c, 4, random);
  std::vector<Distances> of_site;
  for(const Place& p : places)
    of_site.push_back(c.expected({p}));
  for(const std::vector<double>& weights : {std::vector<double>(), std::vector<double>{.1, -.2, 0., .05}})
  {
    std::map<vertex_descriptor, std::size_t> labels;
    Distances distance;
    SMG::geodesic_Voronoi_labels(c.tm, boost::make_assoc_property_map(labels), locations_of(c, places),
                                 np::edges_to_avoid(c.range).faces_to_avoid(c.avoided).site_weights(weights)
                                   .vertex_distance_map(boost::make_assoc_property_map(distance)));
    for(const vertex_descriptor v : vertices(c.tm))
    {
      const auto of = [&](std::size_t i) { return of_site[i].at(v) - (weights.empty() ? 0. : weights[i]); };
      double least_distance = infinity;
      for(std::size_t i = 0; i < places.size(); ++i)
        least_distance = (std::min)(least_distance, of(i));
      CHECK_EQUAL(labels.at(v) < places.size(), least_distance < infinity);
      if(least_distance < infinity)
        CHECK_NEAR(of(labels.at(v)), least_distance, 1e-12);
      if(least_distance < infinity)
        CHECK_NEAR(distance.at(v), least_distance, 1e-12);
      else
        CHECK_EQUAL(distance.at(v), infinity);
    }
  }
}

// --- samples ---

// Each sample is a vertex that is farthest from those before in the cut mesh, and the radius is that of the last one.
void check_samples(const Case& c, test_support::Random& random)
{
  const auto has_face = [&](vertex_descriptor v)
  {
    const auto range = halfedges_around_target(v, c.tm);
    return std::any_of(range.begin(), range.end(), [&](halfedge_descriptor h)
                       { return !is_border(h, c.tm) && c.removed.count(face(h, c.tm)) == 0; });
  };
  std::vector<vertex_descriptor> samples, first;
  Place p = random_place(c.tm, c.removed, random);
  p.is_vertex = true;
  first.push_back(p.vertex);
  const double radius = SMG::geodesic_farthest_point_sampling(
    c.tm, 6, std::back_inserter(samples),
    np::first_samples(first).faces_to_avoid(c.avoided).edges_to_avoid(std::cref(c.walls)));
  std::vector<Place> places{p};
  const auto farthest = [&](const Distances& distance)
  {
    double result = 0;
    for(const auto& d : distance)
      if(has_face(d.first))
        result = (std::max)(result, d.second);
    return result;
  };
  for(const vertex_descriptor v : samples)
  {
    const Distances distance = c.expected(places);
    CHECK_CLOSE(distance.at(v), farthest(distance), 1e-12);
    places.push_back({v, {}, true});
  }
  CHECK_CLOSE(radius, farthest(c.expected(places)), 1e-12);
  // The number is reached, unless each vertex is a sample.
  CHECK(samples.size() == 5 || radius == 0);
}

// --- isolines ---

// The number of lines and of closed ones, and their length; by level.
struct Lines
{
  std::size_t number = 0, closed = 0;
  double length = 0;
  std::vector<Kernel::Point_3> points;

  template <typename Polyline>
  void add(const Polyline& line)
  {
    ++number;
    points.insert(points.end(), line.begin(), line.end());
    closed += line.front() == line.back() ? 1 : 0;
    for(std::size_t i = 1; i < line.size(); ++i)
      length += std::sqrt(CGAL::squared_distance(line[i - 1], line[i]));
  }
};

// Of the distances of a point in the cut mesh, on all sides of walls, the one that is nearest to a level. The point is
// found in all faces in which it is.
double nearest_to_level(const Case& c, const Paths& in_cut, const Kernel::Point_3& p, double level)
{
  double result = infinity;
  for(const face_descriptor f : faces(c.tm))
  {
    std::array<Kernel::Point_3, 3> q;
    std::size_t k = 0;
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, c.tm), c.tm))
      q[k++] = c.tm.point(source(h, c.tm));
    const auto normal = CGAL::cross_product(q[1] - q[0], q[2] - q[0]);
    const double area = normal.squared_length();
    Face_location at(f, {0, 0, 0});
    for(k = 0; k < 3; ++k)
    {
      const auto part = CGAL::cross_product(q[(k + 1) % 3] - p, q[(k + 2) % 3] - p);
      at.second[k] = CGAL::scalar_product(part, normal) / area;
      if(std::abs(at.second[k]) < 1e-9)
        at.second[k] = 0;
    }
    const double height = CGAL::scalar_product(p - q[0], normal);
    if(c.removed.count(f) != 0 || height * height > 1e-18 * area
       || *std::min_element(at.second.begin(), at.second.end()) < 0)
      continue;
    const auto cut = c.cut.location(f, at.second);
    const double d
      = in_cut.shortest_distance_to_source_points(cut.first, {{cut.second[0], cut.second[1], cut.second[2]}}).first;
    if(std::abs(d - level) < std::abs(result - level))
      result = d;
  }
  return result;
}

template <typename Graph, typename Sources, typename Parameters>
std::vector<Lines> isolines(const Graph& tm, const Sources& sources, const std::vector<double>& levels,
                            const Parameters& parameters)
{
  std::vector<std::pair<std::size_t, std::vector<Kernel::Point_3>>> lines;
  SMG::geodesic_isolines(tm, sources, levels, std::back_inserter(lines), parameters);
  std::vector<Lines> result(levels.size());
  for(const auto& line : lines)
    result[line.first].add(line.second);
  return result;
}

// All points of the lines have their distance in the cut mesh, and there are as many as the class of paths finds.
// Distances and nearest sources come along.
void check_isolines(const Case& c, test_support::Random& random)
{
  const std::vector<Place> places = random_places(c, 2, random);
  Paths in_cut(c.cut.mesh);
  for(const Place& p : places)
    for(const Face_location& s : sides(c.tm, c.cut, c.removed, p))
      in_cut.add_source_point(s.first, {{s.second[0], s.second[1], s.second[2]}});
  const std::vector<double> levels{.137, .331, .729};
  Distances distance;
  std::map<vertex_descriptor, std::size_t> nearest;
  const auto found = isolines(c.tm, locations_of(c, places), levels,
                              np::edges_to_avoid(c.range).faces_to_avoid(c.avoided)
                                .vertex_distance_map(boost::make_assoc_property_map(distance))
                                .nearest_source_map(boost::make_assoc_property_map(nearest)));
  Paths paths(c.tm);
  paths.avoid_faces(c.avoided);
  paths.avoid_edges(c.range);
  for(const Face_location& l : locations_of(c, places))
    paths.add_source_point(l.first, {{l.second[0], l.second[1], l.second[2]}});
  for(std::size_t i = 0; i < levels.size(); ++i)
  {
    Lines of_paths;
    std::vector<std::vector<Kernel::Point_3>> lines;
    paths.isolines(levels[i], std::back_inserter(lines));
    for(const auto& line : lines)
      of_paths.add(line);
    for(const Kernel::Point_3& p : found[i].points)
      CHECK_NEAR(nearest_to_level(c, in_cut, p, levels[i]), levels[i], 1e-9);
    CHECK_EQUAL(found[i].number, of_paths.number);
    CHECK_EQUAL(found[i].closed, of_paths.closed);
    CHECK_NEAR(found[i].length, of_paths.length, 1e-9);
  }
  const Distances of_first = c.expected({places[0]}), of_second = c.expected({places[1]});
  for(const vertex_descriptor v : vertices(c.tm))
  {
    const double least_distance = (std::min)(of_first.at(v), of_second.at(v));
    CHECK_CLOSE(distance.at(v), least_distance, 1e-12);
    CHECK_EQUAL(nearest.at(v) < 2, least_distance < infinity);
    if(least_distance < infinity)
      CHECK_CLOSE((nearest.at(v) == 0 ? of_first : of_second).at(v), least_distance, 1e-12);
  }
}

// --- certificates ---

// Right distances are certified, also within a radius. A vertex that is nearer or farther than it should be is not, be
// it on a wall or not; nor are the distances without walls, where these make a difference.
void check_certificate(const Case& c, test_support::Random& random)
{
  const Face_location source = location_of(c, random_place(c.tm, c.removed, random));
  const auto parameters = np::edges_to_avoid(c.range).faces_to_avoid(c.avoided);
  const auto certificate = [&](const Distances& distance, double radius)
  {
    return SMG::certify_geodesic_distances(
      c.tm, boost::make_function_property_map<vertex_descriptor>([&](vertex_descriptor v) { return distance.at(v); }),
      source, np::edges_to_avoid(c.range).faces_to_avoid(c.avoided).maximum_distance(radius));
  };
  Distances right, straight, within;
  SMG::geodesic_distances(c.tm, boost::make_assoc_property_map(right), source, parameters);
  SMG::geodesic_distances(c.tm, boost::make_assoc_property_map(straight), source, np::faces_to_avoid(c.avoided));
  CHECK(certificate(right, infinity).is_certified());
  SMG::geodesic_distances(c.tm, boost::make_assoc_property_map(within), source,
                          np::edges_to_avoid(c.range).faces_to_avoid(c.avoided).maximum_distance(.5));
  CHECK(certificate(within, .5).is_certified());
  const auto differs = [](double a, double b) { return a != b && !(std::abs(a - b) < 1e-6); };
  if(std::any_of(right.begin(), right.end(), [&](const auto& d) { return differs(d.second, straight[d.first]); }))
    CHECK(!certificate(straight, infinity).is_certified());
  std::size_t number = 0;
  for(const auto& d : right)
    if(d.second > 0 && d.second < infinity && ++number % 9 == 0)
      for(const double factor : {1 - 1e-6, 1 + 1e-6, infinity})
      {
        Distances wrong = right;
        wrong[d.first] *= factor;
        CHECK(!certificate(wrong, infinity).is_certified());
      }
}

// --- all of them, for walls of all shapes ---

// A solver from the lengths of edges has the bits of the function from lengths, and keeps its obstacles from run to
// run.
void check_solver_from_lengths(const Case& c, test_support::Random& random)
{
  const auto length = boost::make_function_property_map<edge_descriptor>(
    [&](edge_descriptor e)
    { return std::sqrt(CGAL::squared_distance(c.tm.point(source(e, c.tm)), c.tm.point(target(e, c.tm)))); });
  const auto parameters = np::faces_to_avoid(c.avoided).edges_to_avoid(c.range);
  auto solver = SMG::Geodesic_distance_solver<Mesh>::from_edge_lengths(c.tm, length, parameters);
  for(int i = 0; i < 2; ++i)
  {
    const std::vector<Place> places = random_places(c, 2, random);
    Distances distance;
    SMG::geodesic_distances_from_edge_lengths(c.tm, length, boost::make_assoc_property_map(distance),
                                              locations_of(c, places), parameters);
    solver.compute_distances(locations_of(c, places));
    const Distances expected = c.expected(places);
    for(const vertex_descriptor v : vertices(c.tm))
    {
      CHECK_EQUAL(solver.distance(v), distance.at(v));
      CHECK_CLOSE(solver.distance(v), expected.at(v), 1e-12);
    }
  }
}

void test_against_cut_mesh()
{
  test_support::Random random(7);
  for_each_case(random, [&](const Case& c, std::size_t)
  {
    check_labels(c, random);
    check_samples(c, random);
    check_isolines(c, random);
    check_certificate(c, random);
    check_solver_from_lengths(c, random);
  });
}

} // namespace

int main()
{
  test_against_cut_mesh();
  return test_result();
}
