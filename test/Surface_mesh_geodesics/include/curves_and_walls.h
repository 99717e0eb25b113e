#ifndef SURFACE_MESH_GEODESICS_TEST_CURVES_AND_WALLS_H
#define SURFACE_MESH_GEODESICS_TEST_CURVES_AND_WALLS_H

// Curves beside walls, and what they are in a mesh that has really been cut along the walls.

#include "test_meshes.h"
#include "test_support.h"
#include "walls_and_places.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>
#include <CGAL/Surface_mesh_geodesics/shortest_path_curve.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace test_meshes {

using Curve = CGAL::Surface_mesh_geodesics::Surface_curve<Mesh>;
using Curves = std::vector<Curve>;
using Barycentric = std::array<double, 3>;

// --- curves of the cut mesh ---

inline Place place_at(const Mesh& tm, face_descriptor f, const Barycentric& b)
{
  Place result{vertex_descriptor(), {f, b}, false};
  auto h = halfedge(f, tm);
  for(std::size_t k = 0; k < 3; ++k, h = next(h, tm))
    if(b[k] == 1)
      result = {source(h, tm), {f, b}, true};
  return result;
}

// Appends a segment in a face, divided where it comes from one of its four parts to another.
inline void append_segment(const Case& c, face_descriptor f, const Barycentric& a, const Barycentric& b,
                           Curves& curves)
{
  std::vector<std::pair<double, Barycentric>> points{{0, a}, {1, b}};
  for(std::size_t k = 0; k < 3; ++k)
    if((a[k] < .5) != (b[k] < .5) && a[k] != .5 && b[k] != .5)
    {
      const double t = (.5 - a[k]) / (b[k] - a[k]);
      Barycentric p;
      for(std::size_t i = 0; i < 3; ++i)
        p[i] = i == k ? .5 : a[i] + t * (b[i] - a[i]);
      points.emplace_back(t, p);
    }
  std::sort(points.begin(), points.end());
  std::vector<Face_location> locations;
  for(std::size_t i = 1; i < points.size(); ++i)
  {
    const Barycentric &p = points[i - 1].second, &q = points[i].second;
    const Barycentric middle{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
    if(i == 1)
      locations.push_back(c.cut.location(f, p, middle));
    locations.push_back(c.cut.location(f, q, middle));
  }
  curves.emplace_back(c.cut.mesh, locations); // one curve, as rounding would leave a gap between two
}

// The parts of a curve in the cut mesh, on all sides of walls: segments along walls in both faces, and all points.
inline void append_parts(const Case& c, const Curve& curve, Curves& curves)
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
      Barycentric a{}, b{};
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
    for(const Barycentric& b : {s.source, s.target})
      for(const Face_location& l : sides(c.tm, c.cut, c.removed, place_at(c.tm, s.face, b)))
        curves.emplace_back(c.cut.mesh, l);
  }
}

inline Curves parts_of(const Case& c, const Curves& curves)
{
  Curves result;
  for(const Curve& curve : curves)
    append_parts(c, curve, result);
  return result;
}

// --- curves: across faces and walls, closed, along edges, along walls, and points ---

inline std::vector<Curves> all_curves(const Case& c, test_support::Random& random)
{
  const auto location = [&]() { return random_place(c.tm, c.removed, random).location; };
  const auto around = CGAL::parameters::faces_to_avoid(c.avoided);
  const auto joined = [&](std::size_t n, bool is_closed)
  {
    std::vector<Face_location> places(1, location());
    while(places.size() < n)
    {
      const Face_location l = location();
      if(CGAL::Surface_mesh_geodesics::geodesic_distance(c.tm, places.back(), l, around) < not_reached)
        places.push_back(l);
    }
    return CGAL::Surface_mesh_geodesics::shortest_path_curve(c.tm, places, is_closed, around);
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

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_TEST_CURVES_AND_WALLS_H
