// Borders as curves: those of a mesh without some of its faces, against the mesh from which these faces were removed,
// and against a filtered graph. Edges without faces, wrong input.

#include "curve_cases.h"
#include "expected_exceptions.h"
#include "faces_to_avoid.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;

namespace {

using Faces = std::vector<face_descriptor>;
using Filtered = CGAL::Face_filtered_graph<Mesh>;

template <typename A, typename B>
bool are_equal(const std::vector<A>& a, const std::vector<B>& b)
{
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const A& c, const B& d)
  {
    return c.is_closed() && d.is_closed() && c.segments().size() == d.segments().size()
        && std::equal(c.segments().begin(), c.segments().end(), d.segments().begin(), [](const auto& s, const auto& t)
                      { return s.face == t.face && s.source == t.source && s.target == t.target; });
  });
}

// The vertex at which a segment along an edge begins or ends.
vertex_descriptor end_of_segment(const Mesh& tm, face_descriptor f, const std::array<double, 3>& b)
{
  auto h = halfedge(f, tm);
  for(std::size_t k = 0; k < 3 && b[k] != 1; ++k)
    h = next(h, tm);
  return source(h, tm);
}

// The same segments as on the mesh without the faces, in the faces that are left; the same distances, by vertex, and
// signs. Descriptors stay those of the mesh.
void check_rest(const Mesh& tm, const Faces& avoided)
{
  const auto parameters = np::faces_to_avoid(avoided);
  const std::vector<Curve> curves = SMG::border_curves(tm, parameters);
  std::map<face_descriptor, bool> is_avoided;
  for(const face_descriptor f : faces(tm))
    is_avoided[f] = std::count(avoided.begin(), avoided.end(), f) > 0;
  CHECK(are_equal(SMG::border_curves(tm, np::faces_to_avoid(boost::make_assoc_property_map(is_avoided))), curves));
  Mesh removed = tm;
  for(const face_descriptor f : avoided)
    CGAL::Euler::remove_face(halfedge(f, removed), removed);
  CHECK(are_equal(SMG::border_curves(removed), curves));
  for(const Curve& c : curves)
    for(std::size_t i = 0; i < c.segments().size(); ++i)
    {
      const auto &s = c.segments()[i], &t = c.segments()[(i + 1) % c.segments().size()];
      CHECK(!is_avoided[s.face]);
      CHECK_EQUAL(end_of_segment(tm, s.face, s.target), end_of_segment(tm, t.face, t.source));
    }

  Faces rest;
  for(const auto& entry : is_avoided)
    if(!entry.second)
      rest.push_back(entry.first);
  if(rest.empty() || avoided.empty())
    return;
  const Filtered filtered(tm, rest);
  const auto expected_curves = SMG::border_curves(filtered);
  CHECK(are_equal(expected_curves, curves));
  Distances expected, d, with_sign;
  for(const vertex_descriptor v : vertices(tm))
    expected[v] = infinity;
  SMG::geodesic_distances(filtered, boost::make_assoc_property_map(expected), expected_curves);
  SMG::geodesic_distances(tm, boost::make_assoc_property_map(d), curves, parameters);
  SMG::signed_geodesic_distances(tm, boost::make_assoc_property_map(with_sign), curves, parameters);
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(d[v], expected[v]);
    CHECK_EQUAL(with_sign[v], d[v]); // the surface is on the right of its borders
  }
}

void borders_of_the_rest(test_support::Random& random)
{
  for(const Indexed_mesh& indexed : small_collection(5))
  {
    const test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    CHECK(are_equal(SMG::border_curves(tm), SMG::border_curves(tm, np::faces_to_avoid(Faces()))));
    for(const double part : {0., .1, .4, .7, 1.1})
      check_rest(tm, random_faces(tm, part, random));
  }
}

// Strips along the sides of a square: distances from the rim and from the border that is left. Without the parameter,
// the curve has edges without an open face.
void strips_of_a_square()
{
  const double n = 6;
  const Mesh tm = to_face_graph(flat_patch(6, 6, 0., true, 3));
  Faces avoided;
  for(const face_descriptor f : faces(tm))
  {
    double most = 0;
    for(const vertex_descriptor v : vertices_around_face(halfedge(f, tm), tm))
      most = (std::max)(most, (std::max)(tm.point(v).x() - 1, tm.point(v).y()));
    if(most > n - 2)
      avoided.push_back(f);
  }
  const auto parameters = np::faces_to_avoid(std::cref(avoided));
  Distances d;
  const auto map = boost::make_assoc_property_map(d);
  CHECK(throws_reason(Reason::INVALID_LOCATION,
                      [&] { SMG::geodesic_distances(tm, map, SMG::border_curves(tm), parameters); }));
  const std::vector<Curve> curves = SMG::border_curves(tm, parameters);
  CHECK_EQUAL(curves.size(), std::size_t(1));
  CHECK_CLOSE(curves[0].length(tm), 2 * (n - 1 + n - 2), 1e-14);
  SMG::geodesic_distances(tm, map, curves, parameters);
  for(const vertex_descriptor v : vertices(tm))
  {
    const double x = tm.point(v).x(), y = tm.point(v).y();
    const bool is_left = x <= n - 1 && y <= n - 2;
    CHECK_NEAR(is_left ? d[v] : 0, is_left ? (std::min)({x, n - 1 - x, y, n - 2 - y}) : 0, 1e-14);
    CHECK_EQUAL(d[v] < infinity, is_left);
  }
}

// An edge without faces is in no curve: one between vertices without faces, which has no next halfedge, and one that
// ends at the border.
void edges_without_faces()
{
  Mesh tm = to_face_graph(flat_patch(3, 3, .2, true, 2));
  const std::vector<Curve> curves = SMG::border_curves(tm);
  const auto new_vertex = [&] { return tm.add_vertex(Kernel::Point_3(-1, -1, 0)); };
  const auto loose = tm.add_edge(new_vertex(), new_vertex());
  CHECK(is_border(loose, tm) && is_border(opposite(loose, tm), tm));
  CHECK(are_equal(SMG::border_curves(tm), curves));
  auto into = *std::find_if(halfedges(tm).begin(), halfedges(tm).end(),
                            [&](const auto h) { return is_border(h, tm) && !is_border(opposite(h, tm), tm); });
  const auto out = next(into, tm);
  const auto dangling = tm.add_edge(target(into, tm), new_vertex());
  set_next(into, dangling, tm);
  set_next(dangling, opposite(dangling, tm), tm);
  set_next(opposite(dangling, tm), out, tm);
  set_halfedge(target(dangling, tm), dangling, tm);
  CHECK(are_equal(SMG::border_curves(tm), curves));
}

void wrong_input_is_rejected()
{
  const Mesh tm = to_face_graph(flat_patch(3, 3, 0., true, 2));
  const Faces beyond{face_descriptor(2), face_descriptor(12345)};
  try
  {
    SMG::border_curves(tm, np::faces_to_avoid(beyond));
    CHECK(false);
  }
  catch(const Invalid_input& e)
  {
    CHECK(e.reason() == Reason::INVALID_DESCRIPTOR);
    CHECK_EQUAL(e.element(), std::size_t(1));
  }
  Mesh quadrangle;
  const auto v = [&](double x, double y) { return quadrangle.add_vertex(Kernel::Point_3(x, y, 0)); };
  quadrangle.add_face(v(0, 0), v(1, 0), v(1, 1), v(0, 1));
  CHECK(throws_reason(Reason::NOT_A_TRIANGLE, [&] { SMG::border_curves(quadrangle); }));
  for(const Mesh::Halfedge_index h : halfedges(quadrangle))
    CHECK(throws_reason(Reason::NOT_A_TRIANGLE,
                        [&] { Curve::along_halfedges(quadrangle, std::vector<Mesh::Halfedge_index>{h}); }));
}

} // namespace

int main()
{
  test_support::Random random(12);
  borders_of_the_rest(random);
  strips_of_a_square();
  edges_without_faces();
  wrong_input_is_rejected();
  return test_result();
}
