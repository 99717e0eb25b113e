// Distances with signs: on the sides of polygons in the plane, of loops around a torus, and across a vertex at which
// the surface is pinched; curves that do not separate the surface; curves that run along edges several times, beside
// walls and without any.

#include "curves_in_plane.h"
#include "expected_exceptions.h"
#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Curve_sides.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
using SMG::Invalid_geodesic_input;

namespace {

using edge_descriptor = boost::graph_traits<Mesh>::edge_descriptor;
using halfedge_descriptor = boost::graph_traits<Mesh>::halfedge_descriptor;
using Walls = std::vector<edge_descriptor>;

Distances signed_distances(const Mesh& tm, const std::vector<Curve>& curves, const Walls& walls = {})
{
  Distances d;
  CHECK(SMG::signed_geodesic_distances(tm, boost::make_assoc_property_map(d), curves,
                                       CGAL::parameters::edges_to_avoid(walls)));
  return d;
}

bool separates(const Mesh& tm, const std::vector<Curve>& curves, const Walls& walls = {})
{
  return !throws_reason(Invalid_geodesic_input::Reason::INVALID_CURVE, [&] { signed_distances(tm, curves, walls); });
}

// Triangles in the plane, one inside the other, counterclockwise: the ring between them is positive, the rest negative.
void test_signs_in_plane()
{
  const double size = 9;
  const Mesh tm = to_face_graph(flat_patch(9, 9, .3, true, 12));
  const std::vector<Point_2> outer{{.71, .83}, {8.13, 1.17}, {4.21, 8.09}}, inner{{3.3, 2.2}, {5.7, 2.4}, {4.1, 4.6}};
  const auto polygon = [&](const std::vector<Point_2>& p)
  {
    std::vector<Location> locations;
    for(std::size_t i = 0; i < 3; ++i)
      append_crossings(tm, p[i], p[(i + 1) % 3], locations);
    return Curve(tm, locations, true);
  };
  const auto is_inside = [](const std::vector<Point_2>& t, const Point_2& p)
  {
    bool result = true;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Point_2 &a = t[i], &b = t[(i + 1) % 3];
      result = result && (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0;
    }
    return result;
  };
  const std::vector<Curve> curves{polygon(outer), polygon(inner)};
  const Distances d = signed_distances(tm, curves), plain = distances(tm, curves);
  const Distances one = signed_distances(tm, {curves[0]});
  std::size_t negative = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    const Point_2 p = in_plane(tm, v);
    const bool is_negative = is_inside(outer, p) && !is_inside(inner, p);
    CHECK_EQUAL(d.at(v), is_negative ? -plain.at(v) : plain.at(v));
    CHECK_EQUAL(one.at(v) < 0, is_inside(outer, p));
    negative += is_negative ? 1 : 0;
  }
  CHECK(negative > 20);
  // From border to border, a line of two points; an open curve inside does not separate, but there and back is nothing.
  std::vector<Location> across;
  append_crossings(tm, {0., 4.3}, {size, 4.7}, across);
  across.push_back(location_in_plane(size, 4.7, tm));
  for(const auto& entry : signed_distances(tm, {Curve(tm, across)}))
    CHECK_EQUAL(entry.second > 0, tm.point(entry.first).y() < 4.3 + .4 / size * tm.point(entry.first).x());
  std::vector<Location> open(across.begin() + 1, across.end() - 2);
  CHECK(!separates(tm, {Curve(tm, open)}));
  CHECK(separates(tm, {Curve(tm, across)}));
  open.insert(open.end(), open.rbegin() + 1, open.rend());
  CHECK(separates(tm, {Curve(tm, open)}));
  for(const auto& entry : signed_distances(tm, {Curve(tm, location_in_plane(4.3, 5.1, tm))}))
    CHECK(entry.second > 0);
  for(const auto& entry : signed_distances(tm, SMG::border_curves(tm)))
    CHECK(entry.second >= 0);
}

void test_signs_on_torus()
{
  const Mesh tm = to_face_graph(torus(2., 1., 8, 6));
  // The rings of a torus: one does not separate, two do.
  const auto ring = [&](std::size_t i)
  {
    std::vector<vertex_descriptor> result;
    for(std::size_t j = 0; j < 6; ++j)
      result.push_back(vertex_descriptor(static_cast<Mesh::size_type>(i * 6 + j)));
    return Curve(tm, result, true);
  };
  CHECK(!separates(tm, {ring(0)}));
  CHECK(separates(tm, {ring(0), ring(4)}));
  CHECK(!separates(tm, {ring(0), ring(2), ring(4)}));
  std::size_t negative = 0, positive = 0;
  for(const auto& entry : signed_distances(tm, {ring(0), ring(4)}))
  {
    negative += entry.second < 0 ? 1 : 0;
    positive += entry.second > 0 ? 1 : 0;
  }
  CHECK_EQUAL(negative, std::size_t(18));
  CHECK_EQUAL(positive, std::size_t(18));
}

// Two fans of n faces share their apex, vertex 0. The rim of the first one is a curve: all faces are on its left. A
// bridge of two faces between the fans is divided by an edge, which has both fans on one side through the apex.
void test_signs_across_pinch()
{
  for(const std::size_t n : {std::size_t(5), std::size_t(20), std::size_t(80)})
  {
    Indexed_mesh fans{"fans", {{0, 0, 0}}, {}};
    for(std::size_t i = 0; i < 2 * n + 2; ++i)
    {
      const double t = (i <= n ? 0. : .4) + 2.5 * static_cast<double>(i) / static_cast<double>(n);
      fans.points.push_back({std::cos(t), std::sin(t), i <= n ? 0. : 1.});
      if(i != n && i != 2 * n + 1)
        fans.faces.push_back({0, i + 1, i + 2});
    }
    const Mesh tm = to_face_graph(fans);
    std::vector<vertex_descriptor> rim;
    for(std::size_t i = 1; i <= n + 1; ++i)
      rim.push_back(vertex_descriptor(static_cast<Mesh::size_type>(i)));
    const Distances plain = distances(tm, {Curve(tm, rim)});
    for(const auto& entry : signed_distances(tm, {Curve(tm, rim)}))
      CHECK_EQUAL(entry.second, -plain.at(entry.first));
    // All faces around the apex are visited once: no face that gets its color visits them again.
    const Counting_intrinsic_mesh mesh(intrinsic_mesh(tm));
    SMG::internal::Source_curves<double> curves;
    const SMG::internal::Halfedge_id h = SMG::internal::halfedge_of(0, 0); // the shortest edge, which is on a rim
    CHECK_EQUAL(mesh.opposite(h), SMG::internal::null_id);
    curves.edges.push_back({h, SMG::internal::null_id, mesh.source(h), mesh.target(h), 1, 0, 0, 0, 0, 1});
    const SMG::internal::Curve_sides<double, Counting_intrinsic_mesh> sides(mesh, curves);
    for(SMG::internal::Face_id f = 0; f < mesh.number_of_faces(); ++f)
      CHECK_EQUAL(sides.sign_of_face(f), -1);
    CHECK_EQUAL(mesh.visits, 2 * n);
    fans.faces.push_back({n + 1, n, n + 3});
    fans.faces.push_back({n + 3, n + 2, n + 1});
    const Mesh ring = to_face_graph(fans);
    const vertex_descriptor a(static_cast<Mesh::size_type>(n + 1)), b(static_cast<Mesh::size_type>(n + 3));
    const Curve across(ring, std::vector<vertex_descriptor>{a, b}), apex(ring, vertex_descriptor(0));
    CHECK(!separates(ring, {across}));
    CHECK(separates(ring, {across, apex}));
  }
}

// --- curves that run along edges several times ---

// From p to q, around a large square, back to p and once more to q, and around a small square to p. A wall crosses the
// large one: its segments behind the wall, which lead back to p, do not decide.
void test_first_run_decides()
{
  const Square s(8);
  const std::vector<Point_2> points{{2, 3}, {3, 3}, {4, 3}, {5, 3}, {5, 4}, {5, 5}, {4, 5}, {3, 5}, {3, 4}, {3, 3},
                                    {2, 3}, {3, 3}, {3, 2}, {2, 2}};
  std::vector<vertex_descriptor> around;
  for(const Point_2& p : points)
    around.push_back(s.at(p[0], p[1]));
  Walls walls;
  for(const double x : {4., 5.})
    walls.push_back(edge(s.at(x, 4), s.at(x + 1, 4), s.tm).first);
  const Curve curve(s.tm, around, true);
  const Distances without = signed_distances(s.tm, {curve}), with = signed_distances(s.tm, {curve}, walls);
  for(const vertex_descriptor v : vertices(s.tm))
  {
    const bool is_positive = v == s.at(4, 4), is_on_curve = std::count(around.begin(), around.end(), v) != 0;
    CHECK_EQUAL(without.at(v) < 0, !is_positive && !is_on_curve);
    CHECK_EQUAL(with.at(v) < 0, !is_positive && !is_on_curve);
  }
}

// A walk along edges back to its first vertex. It often runs along its first edge again.
std::vector<vertex_descriptor> random_walk(const Mesh& tm, test_support::Random& random)
{
  const auto neighbors = [&](vertex_descriptor v)
  {
    std::vector<vertex_descriptor> result;
    for(const halfedge_descriptor h : halfedges_around_target(halfedge(v, tm), tm))
      result.push_back(source(h, tm));
    random.shuffle(result);
    return result;
  };
  std::vector<vertex_descriptor> walk{
    vertex_descriptor(static_cast<Mesh::size_type>(random.index(num_vertices(tm))))};
  for(std::size_t n = 4 + random.index(14); walk.size() < n;)
  {
    const bool is_at_first_edge = walk.size() > 1 && (walk.back() == walk[0] || walk.back() == walk[1]);
    walk.push_back(is_at_first_edge && random.uniform() < .5 ? (walk.back() == walk[0] ? walk[1] : walk[0])
                                                             : neighbors(walk.back())[0]);
  }
  // Back by a search in breadth, from the first vertex.
  std::map<vertex_descriptor, vertex_descriptor> toward{{walk[0], walk[0]}};
  std::vector<vertex_descriptor> found{walk[0]};
  for(std::size_t i = 0; i < found.size(); ++i)
    for(const vertex_descriptor v : neighbors(found[i]))
      if(toward.emplace(v, found[i]).second)
        found.push_back(v);
  while(walk.back() != walk[0])
    walk.push_back(toward.at(walk.back()));
  walk.pop_back();
  return walk;
}

// The colors of all faces by the definition. The face on the left of each run, in the order of the curves, is negative,
// and that on its right is positive, unless another run has decided that already.
struct Colors_by_definition
{
  using Walk = std::vector<vertex_descriptor>;

  Colors_by_definition(const Mesh& mesh, const std::vector<Walk>& walks, const Walls& walls)
    : tm(mesh), is_wall(walls.begin(), walls.end())
  {
    std::vector<halfedge_descriptor> all;
    for(const Walk& w : walks)
      for(std::size_t i = 0; i < w.size(); ++i)
        all.push_back(halfedge(w[i], w[(i + 1) % w.size()], tm).first);
    for(const halfedge_descriptor h : all)
      ++runs[edge(h, tm)];
    for(const halfedge_descriptor h : all)
      if(runs.at(edge(h, tm)) % 2 == 1)
      {
        color_from(h, -1);
        color_from(opposite(h, tm), 1);
        if(first_part.empty())
          for(const auto& c : color)
            first_part.insert(c.first);
      }
  }

  void color_from(halfedge_descriptor h, int c)
  {
    if(is_border(h, tm) || !color.emplace(face(h, tm), c).second)
      return;
    std::vector<face_descriptor> waiting{face(h, tm)};
    while(!waiting.empty())
    {
      const face_descriptor f = waiting.back();
      waiting.pop_back();
      for(const halfedge_descriptor g : halfedges_around_face(halfedge(f, tm), tm))
      {
        const halfedge_descriptor o = opposite(g, tm);
        if(is_border(o, tm) || is_wall.count(edge(g, tm)) != 0)
          continue;
        const auto run = runs.find(edge(g, tm));
        const int expected = run != runs.end() && run->second % 2 == 1 ? -color.at(f) : color.at(f);
        if(color.emplace(face(o, tm), expected).second)
          waiting.push_back(face(o, tm));
        else
          separates = separates && color.at(face(o, tm)) == expected;
      }
    }
  }

  int at(face_descriptor f) const { return color.count(f) != 0 ? color.at(f) : 1; }

  const Mesh& tm;
  std::set<edge_descriptor> is_wall;
  std::map<edge_descriptor, std::size_t> runs;
  std::map<face_descriptor, int> color;
  std::set<face_descriptor> first_part; // faces that walls do not part from the first run
  bool separates = true;
};

// Signs with walls are those by the definition, and, in the part of the first run, those without walls. (A vertex of a
// wall has the sign of a face there.) Returns how many vertices have been compared with those without walls.
std::size_t check_signs_beside_walls(const Mesh& tm, const std::vector<std::vector<vertex_descriptor>>& walks,
                                     const Walls& walls)
{
  std::vector<Curve> curves;
  std::set<vertex_descriptor> on_curves;
  for(const auto& w : walks)
  {
    curves.emplace_back(tm, w, true);
    on_curves.insert(w.begin(), w.end());
  }
  const Colors_by_definition colors(tm, walks, walls);
  CHECK_EQUAL(separates(tm, curves, walls), colors.separates);
  if(!colors.separates)
    return 0;
  std::size_t result = 0;
  const Distances found = signed_distances(tm, curves, walls);
  const Distances without = separates(tm, curves) ? signed_distances(tm, curves) : Distances();
  for(const vertex_descriptor v : vertices(tm))
  {
    std::set<int> signs;
    bool is_in_first_part = true;
    for(const halfedge_descriptor h : halfedges_around_target(halfedge(v, tm), tm))
      if(!is_border(h, tm))
      {
        signs.insert(colors.at(face(h, tm)));
        is_in_first_part = is_in_first_part && colors.first_part.count(face(h, tm)) != 0;
      }
    CHECK(on_curves.count(v) != 0 ? found.at(v) == 0 : signs.count(found.at(v) < 0 ? -1 : 1) != 0);
    if(without.empty() || !is_in_first_part || signs.size() > 1)
      continue;
    CHECK_EQUAL(found.at(v) < 0, without.at(v) < 0);
    ++result;
  }
  return result;
}

// Two curves, and walls that touch them, cross them and run along them.
void test_signs_beside_walls()
{
  test_support::Random random(1);
  std::size_t compared = 0;
  const std::vector<Mesh> meshes{to_face_graph(flat_patch(4, 4, .2, true, 3)), to_face_graph(icosphere(1)),
                                 to_face_graph(torus(2., 1., 5, 4))};
  for(std::size_t i = 0; i < 600; ++i)
  {
    const Mesh& tm = meshes[i % meshes.size()];
    const test_support::Scope scope("walls and runs " + std::to_string(i));
    std::vector<std::vector<vertex_descriptor>> walks;
    while(walks.size() < 1 + i % 2)
      walks.push_back(random_walk(tm, random));
    Walls walls;
    const double part = i % 5 == 0 ? .3 : .08;
    for(const edge_descriptor e : edges(tm))
      if(random.uniform() < part)
        walls.push_back(e);
    compared += check_signs_beside_walls(tm, walks, walls);
  }
  CHECK(compared > 5000);
}

} // namespace

int main()
{
  test_signs_in_plane();
  test_signs_on_torus();
  test_signs_across_pinch();
  test_first_run_decides();
  test_signs_beside_walls();
  return test_result();
}
