// Curves as sources beside edges to avoid: distances, feet, paths, signs and samples are those of a mesh that has
// really been cut along these edges. Curves cross walls, touch them and run along them.

#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"
#include "walls_and_places.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>
#include <CGAL/Surface_mesh_geodesics/shortest_path_curve.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>

#include <CGAL/Surface_mesh_shortest_path.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

using Curve = SMG::Surface_curve<Mesh>;
using Curves = std::vector<Curve>;
using Distances = std::map<vertex_descriptor, double>;
using Coordinates = std::array<double, 3>;
using Solver = SMG::Geodesic_distance_solver<Mesh>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

// --- curves of the cut mesh ---

Place place_at(const Mesh& tm, face_descriptor f, const Coordinates& b)
{
  Place result{vertex_descriptor(), {f, b}, false};
  auto h = halfedge(f, tm);
  for(std::size_t k = 0; k < 3; ++k, h = next(h, tm))
    if(b[k] == 1)
      result = {source(h, tm), {f, b}, true};
  return result;
}

// Appends a segment in a face, divided where it comes from one of its four parts to another.
void append_segment(const Case& c, face_descriptor f, const Coordinates& a, const Coordinates& b, Curves& curves)
{
  std::vector<std::pair<double, Coordinates>> points{{0, a}, {1, b}};
  for(std::size_t k = 0; k < 3; ++k)
    if((a[k] < .5) != (b[k] < .5) && a[k] != .5 && b[k] != .5)
    {
      const double t = (.5 - a[k]) / (b[k] - a[k]);
      Coordinates p;
      for(std::size_t i = 0; i < 3; ++i)
        p[i] = i == k ? .5 : a[i] + t * (b[i] - a[i]);
      points.emplace_back(t, p);
    }
  std::sort(points.begin(), points.end());
  std::vector<Face_location> locations;
  for(std::size_t i = 1; i < points.size(); ++i)
  {
    const Coordinates &p = points[i - 1].second, &q = points[i].second;
    const Coordinates middle{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
    if(i == 1)
      locations.push_back(c.cut.location(f, p, middle));
    locations.push_back(c.cut.location(f, q, middle));
  }
  curves.emplace_back(c.cut.mesh, locations); // one curve, as rounding would leave a gap between two
}

// The parts of a curve in the cut mesh, on all sides of walls: segments along walls in both faces, and all points.
void append_parts(const Case& c, const Curve& curve, Curves& curves)
{
  if(curve.segments().empty())
    for(const Face_location& l : sides(c.tm, c.cut, c.removed, {curve.vertex(), {}, true}))
      curves.emplace_back(c.cut.mesh, l);
  for(const auto& s : curve.segments())
  {
    const std::size_t first = curves.size();
    append_segment(c, s.face, s.source, s.target, curves);
    const std::size_t behind = curves.size();
    auto h = halfedge(s.face, c.tm);
    for(std::size_t k = 0; k < 3; ++k, h = next(h, c.tm))
    {
      const auto o = opposite(h, c.tm);
      if(s.source[(k + 2) % 3] != 0 || s.target[(k + 2) % 3] != 0 || is_border(o, c.tm)
         || c.removed.count(face(o, c.tm)) != 0 || c.walls.count(edge(h, c.tm)) == 0)
        continue;
      std::size_t i = 0;
      for(auto g = halfedge(face(o, c.tm), c.tm); g != o; g = next(g, c.tm))
        ++i;
      Coordinates a{}, b{};
      a[i] = s.source[(k + 1) % 3];
      a[(i + 1) % 3] = s.source[k];
      b[i] = s.target[(k + 1) % 3];
      b[(i + 1) % 3] = s.target[k];
      append_segment(c, face(o, c.tm), a, b, curves);
      // The side on the left comes first: it decides about the signs.
      if(s.source[k] < s.target[k])
        std::rotate(curves.begin() + static_cast<std::ptrdiff_t>(first),
                    curves.begin() + static_cast<std::ptrdiff_t>(behind), curves.end());
    }
    for(const Coordinates& b : {s.source, s.target})
      for(const Face_location& l : sides(c.tm, c.cut, c.removed, place_at(c.tm, s.face, b)))
        curves.emplace_back(c.cut.mesh, l);
  }
}

Curves parts_of(const Case& c, const Curves& curves)
{
  Curves result;
  for(const Curve& curve : curves)
    append_parts(c, curve, result);
  return result;
}

Distances least_of_copies(const Case& c, const Distances& in_cut)
{
  Distances result;
  for(const vertex_descriptor v : vertices(c.tm))
    result[v] = least(in_cut, c.cut.copies[v]);
  return result;
}

Distances expected_distances(const Case& c, const Curves& curves)
{
  Distances in_cut;
  SMG::geodesic_distances(c.cut.mesh, boost::make_assoc_property_map(in_cut), parts_of(c, curves));
  return least_of_copies(c, in_cut);
}

// --- curves: across faces and walls, closed, along edges, along walls, and points ---

std::vector<Curves> all_curves(const Case& c, test_support::Random& random)
{
  const auto location = [&]() { return random_place(c.tm, c.removed, random).location; };
  const auto joined = [&](std::size_t n, bool is_closed)
  {
    std::vector<Face_location> places(1, location());
    while(places.size() < n)
    {
      const Face_location l = location();
      if(SMG::geodesic_distance(c.tm, places.back(), l, np::faces_to_avoid(c.avoided)) < not_reached)
        places.push_back(l);
    }
    return SMG::shortest_path_curve(c.tm, places, is_closed, np::faces_to_avoid(c.avoided));
  };
  std::vector<Curves> result{{joined(2, false)}, {joined(3, true)}, {joined(2, false), Curve(c.tm, location())}};
  // Some walls, and an edge beside each, as one curve.
  Curves along;
  for(const edge_descriptor e : c.walls)
  {
    const auto h = is_border(halfedge(e, c.tm), c.tm) ? opposite(halfedge(e, c.tm), c.tm) : halfedge(e, c.tm);
    if(random.uniform() < .2 && c.removed.count(face(h, c.tm)) == 0)
      along.emplace_back(c.tm, std::vector<vertex_descriptor>{source(h, c.tm), target(h, c.tm),
                                                              target(next(h, c.tm), c.tm)});
    // (A segment along an edge is in one of its faces, which may be avoided.)
    if(!along.empty() && std::any_of(along.back().segments().begin(), along.back().segments().end(),
                                     [&](const auto& s) { return c.removed.count(s.face) != 0; }))
      along.pop_back();
  }
  if(!along.empty())
    result.push_back(along);
  if(c.removed.empty())
    result.push_back({Curve(c.tm, *std::next(vertices(c.tm).begin(), 2))});
  return result;
}

// --- checks ---

// Distances, their feet on the curve, and the number of the curve; from a solver, and from paths, at any point.
void check_distances(const Case& c, const Curves& curves, test_support::Random& random)
{
  const Distances expected = expected_distances(c, curves);
  Distances found;
  SMG::geodesic_distances(c.tm, boost::make_assoc_property_map(found), curves,
                          np::edges_to_avoid(c.range).faces_to_avoid(c.avoided));
  auto solver = Solver::avoiding_edges(c.tm, c.range, c.avoided);
  solver.compute_distances(curves);
  Paths paths(c.tm), in_cut(c.cut.mesh);
  paths.avoid_faces(c.avoided);
  paths.avoid_edges(c.range);
  for(const Curve& curve : curves)
    paths.add_source_curve(curve);
  for(const Curve& curve : parts_of(c, curves))
    in_cut.add_source_curve(curve);
  const auto or_infinity = [](double d) { return d < 0 ? not_reached : d; };
  std::size_t number = 0;
  for(const auto& d : expected)
  {
    CHECK_NEAR(found.at(d.first) < not_reached ? found.at(d.first) : -1, d.second < not_reached ? d.second : -1, 1e-12);
    CHECK_EQUAL(solver.distance(d.first), found.at(d.first));
    CHECK_NEAR(paths.shortest_distance_to_source_points(d.first).first, d.second < not_reached ? d.second : -1, 1e-12);
    const auto foot = solver.nearest_curve_point(d.first);
    CHECK_EQUAL(foot.curve < curves.size(), d.second < not_reached);
    if(!(foot.curve < curves.size()) || ++number % 8 != 0 || c.tm.is_isolated(d.first))
      continue;
    const Curve& curve = curves[foot.curve];
    const auto way = [&](const auto& place)
    { return SMG::geodesic_distance(c.tm, d.first, place, np::edges_to_avoid(c.range).faces_to_avoid(c.avoided)); };
    CHECK_NEAR(curve.segments().empty() ? way(curve.vertex()) : way(curve.location(foot.segment, foot.parameter)),
               d.second, 1e-10);
    std::vector<Kernel::Point_3> line;
    paths.shortest_path_points_to_source_points(d.first, std::back_inserter(line));
    double length = 0;
    for(std::size_t i = 1; i < line.size(); ++i)
      length += std::sqrt(CGAL::squared_distance(line[i - 1], line[i]));
    CHECK_NEAR(length, d.second, 1e-10);
  }
  for(std::size_t i = 0; i < 6; ++i)
  {
    const Place p = random_place(c.tm, c.removed, random);
    double least_distance = not_reached;
    for(const Face_location& l : sides(c.tm, c.cut, c.removed, {p.vertex, p.location, false}))
      least_distance = (std::min)(least_distance, or_infinity(in_cut.shortest_distance_to_source_points(
        l.first, {{l.second[0], l.second[1], l.second[2]}}).first));
    const Coordinates& b = p.location.second;
    const double d = paths.shortest_distance_to_source_points(p.location.first, {{b[0], b[1], b[2]}}).first;
    CHECK_NEAR(d, least_distance < not_reached ? least_distance : -1, 1e-12);
  }
}

// The sign is that of the nearest copy; where two copies tie, it may be that of either. The curves separate the surface
// if their parts separate the cut mesh.
bool check_signs(const Case& c, const Curves& curves)
{
  Distances in_cut, found;
  const bool separates = !throws<SMG::Invalid_geodesic_input>([&]
  { SMG::signed_geodesic_distances(c.cut.mesh, boost::make_assoc_property_map(in_cut), parts_of(c, curves)); });
  const auto call = [&]
  {
    SMG::signed_geodesic_distances(c.tm, boost::make_assoc_property_map(found), curves,
                                   np::edges_to_avoid(c.range).faces_to_avoid(c.avoided));
  };
  CHECK_EQUAL(throws<SMG::Invalid_geodesic_input>(call), !separates);
  for(const vertex_descriptor v : vertices(c.tm))
  {
    if(!separates)
      continue;
    double least_distance = not_reached;
    std::set<double> signed_ones;
    for(const vertex_descriptor w : c.cut.copies[v])
      least_distance = (std::min)(least_distance, std::abs(in_cut.at(w)));
    CHECK_CLOSE(std::abs(found.at(v)), least_distance, 1e-12);
    bool is_right = found.at(v) == 0;
    for(const vertex_descriptor w : c.cut.copies[v])
      is_right = is_right || std::abs(in_cut.at(w) - found.at(v)) < 1e-12 || in_cut.at(w) == found.at(v);
    CHECK(is_right);
  }
  return separates;
}

// Samples keep away from the curve, on all sides.
void check_samples(const Case& c, const Curves& curves)
{
  std::vector<vertex_descriptor> samples;
  const double radius = SMG::geodesic_farthest_point_sampling(
    c.tm, 4, std::back_inserter(samples), np::first_curves(curves).edges_to_avoid(c.range).faces_to_avoid(c.avoided));
  Distances distance = expected_distances(c, curves);
  const auto farthest = [&]()
  {
    double result = 0;
    for(const auto& d : distance)
    {
      const auto range = halfedges_around_target(d.first, c.tm);
      if(std::any_of(range.begin(), range.end(), [&](halfedge_descriptor h)
                     { return !is_border(h, c.tm) && c.removed.count(face(h, c.tm)) == 0; }))
        result = (std::max)(result, d.second);
    }
    return result;
  };
  for(const vertex_descriptor v : samples)
  {
    CHECK_CLOSE(distance.at(v), farthest(), 1e-12);
    for(const auto& d : c.expected({{v, {}, true}}))
      distance.at(d.first) = (std::min)(distance.at(d.first), d.second);
  }
  CHECK_CLOSE(radius, farthest(), 1e-12);
}

// The curve that joins places: as long as the ways between walls, and each of its segments goes on where the one before
// ends, on the same side of the walls unless a place is there.
void check_joined_curve(const Case& c, test_support::Random& random)
{
  const auto parameters = np::edges_to_avoid(c.range).faces_to_avoid(c.avoided);
  const Face_location a = random_place(c.tm, c.removed, random).location;
  const Face_location b = random_place(c.tm, c.removed, random).location;
  const double way = SMG::geodesic_distance(c.tm, a, b, parameters);
  const std::vector<Face_location> places{a, b};
  if(!(way < not_reached))
  {
    CHECK(throws<SMG::Invalid_geodesic_input>([&] { SMG::shortest_path_curve(c.tm, places, false, parameters); }));
    return;
  }
  double length = 0;
  const Curve curve = SMG::shortest_path_curve(c.tm, places, false, parameters);
  const auto point = [&](face_descriptor f, const Coordinates& x)
  {
    Kernel::Vector_3 sum(0, 0, 0);
    std::size_t k = 0;
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, c.tm), c.tm))
      sum = sum + x[k++] * (c.tm.point(source(h, c.tm)) - CGAL::ORIGIN);
    return sum;
  };
  for(std::size_t i = 0; i < curve.segments().size(); ++i)
  {
    const auto& s = curve.segments()[i];
    length += std::sqrt((point(s.face, s.target) - point(s.face, s.source)).squared_length());
    if(i == 0)
      continue;
    // The two ends are one point of the cut mesh.
    const Face_location end = c.cut.location(curve.segments()[i - 1].face, curve.segments()[i - 1].target);
    const Face_location begin = c.cut.location(s.face, s.source);
    CHECK_NEAR(SMG::geodesic_distance(c.cut.mesh, end, begin), 0, 1e-12);
  }
  CHECK_NEAR(length, way, 1e-11);
}

void test_against_cut_mesh()
{
  test_support::Random random(11);
  std::size_t separating = 0;
  for_each_case(random, [&](const Case& c, std::size_t)
  {
    std::size_t number_of_curves = 0;
    check_joined_curve(c, random);
    for(const Curves& curves : all_curves(c, random))
    {
      const test_support::Scope scope("curves " + std::to_string(number_of_curves++));
      check_distances(c, curves, random);
      separating += check_signs(c, curves) ? 1 : 0;
      check_samples(c, curves);
    }
  });
  CHECK(separating > 20);
}

} // namespace

int main()
{
  test_against_cut_mesh();
  return test_result();
}
