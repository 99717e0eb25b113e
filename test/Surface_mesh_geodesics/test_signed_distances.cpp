// Distances with signs: on the sides of polygons in the plane, of loops around a torus, and across a vertex at which
// the surface is pinched; curves that do not separate the surface.

#include "curves_in_plane.h"
#include "expected_exceptions.h"
#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Curve_sides.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
using SMG::Invalid_geodesic_input;

namespace {

Distances signed_distances(const Mesh& tm, const std::vector<Curve>& curves)
{
  Distances d;
  CHECK(SMG::signed_geodesic_distances(tm, boost::make_assoc_property_map(d), curves));
  return d;
}

bool separates(const Mesh& tm, const std::vector<Curve>& curves)
{
  return !throws_reason(Invalid_geodesic_input::Reason::INVALID_CURVE, [&] { signed_distances(tm, curves); });
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

} // namespace

int main()
{
  test_signs_in_plane();
  test_signs_on_torus();
  test_signs_across_pinch();
  return test_result();
}
