// Curves as sources beside edges to avoid: distances, feet, paths, signs and samples are those of a mesh that has
// really been cut along these edges. Curves cross walls, touch them and run along them.

#include "curves_and_walls.h"
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

using Distances = std::map<vertex_descriptor, double>;
using Coordinates = std::array<double, 3>;
using Solver = SMG::Geodesic_distance_solver<Mesh>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

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
