// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SURFACE_LOCATIONS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SURFACE_LOCATIONS_H

// Points of the surface in the user's terms, and how one form becomes another: vertices, positions on halfedges,
// barycentric coordinates in faces, points of space. All functions are static and have no state, so threads may call
// them at once.
//
// Conventions. A Face_location has the coordinates of source(h), target(h) and target(next(h)) for h = halfedge(f), in
// this order. A position t on a halfedge is 0 at its source and 1 at its target. The null location has the null face.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/cgal_compatibility.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Traits` is a model of SurfaceMeshShortestPathTraits; points and coordinates are made by its function objects.
// Numbers are converted to double where a decision is made. Mesh, maps and traits are parameters of each function, as
// the static members of Surface_mesh_geodesic_paths have no object. Nothing is checked: descriptors have to be those of
// the mesh, and only locate() and what makes a tree for it throw.
template <typename Traits, typename VertexPointMap>
struct Surface_locations
{
  using Triangle_mesh = typename Traits::Triangle_mesh;
  using Graph_traits = boost::graph_traits<Triangle_mesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Ray_3 = typename Traits::Ray_3;
  using Triangle_3 = typename Traits::Triangle_3;
  using Barycentric_coordinates = typename Traits::Barycentric_coordinates;
  using Face_location = std::pair<face_descriptor, Barycentric_coordinates>;
  using Coordinates = std::array<double, 3>;

  // --- coordinates ---

  // Returns the coordinates as numbers, rounded to double (coordinates_in_double()).
  // Law: weights(coordinates(b)) == b if FT holds doubles exactly.
  static Coordinates weights(const Barycentric_coordinates& location, const Traits& traits)
  {
    auto weight = traits.construct_barycentric_coordinates_weight_object();
    return coordinates_in_double(weight(location, 0), weight(location, 1), weight(location, 2));
  }

  // Returns numbers as coordinates of the traits.
  static Barycentric_coordinates coordinates(const Coordinates& b, const Traits& traits)
  {
    return traits.construct_barycentric_coordinates_object()(FT(b[0]), FT(b[1]), FT(b[2]));
  }

  // Returns the location that stands for no point of the surface. A build rejects it as a source.
  static Face_location null_location(const Traits& traits)
  {
    return Face_location(Graph_traits::null_face(), coordinates({0., 0., 0.}, traits));
  }

  // --- points ---

  // Returns the point of a face, constructed by the traits.
  // Requires: f is a triangle.
  static Point_3 point(face_descriptor f, const Barycentric_coordinates& location, const Triangle_mesh& tm,
                       VertexPointMap vertex_point_map, const Traits& traits)
  {
    const Triangle_3 t = triangle(f, tm, vertex_point_map, traits);
    auto weight = traits.construct_barycentric_coordinates_weight_object();
    auto vertex = traits.construct_vertex_3_object();
    return traits.construct_barycenter_3_object()(vertex(t, 0), weight(location, 0), vertex(t, 1), weight(location, 1),
                                                  vertex(t, 2), weight(location, 2));
  }

  // Returns the point at t of a halfedge, constructed by the traits. The barycenter gives the source the weight 1 - t.
  static Point_3 point(halfedge_descriptor he, const FT& t, const Triangle_mesh& tm, VertexPointMap vertex_point_map,
                       const Traits& traits)
  {
    return traits.construct_barycenter_3_object()(get(vertex_point_map, target(he, tm)), t,
                                                  get(vertex_point_map, source(he, tm)));
  }

  // --- locations ---

  // Returns the location of a vertex in one of its faces; the null location if it has none. Its coordinate is an exact
  // 1, so snapping finds the vertex again.
  static Face_location location(vertex_descriptor v, const Triangle_mesh& tm, const Traits& traits)
  {
    const halfedge_descriptor h = internal::halfedge_in_face(v, tm);
    return h == Graph_traits::null_halfedge() ? null_location(traits)
                                              : location_in_face(next(h, tm), FT(0), tm, traits);
  }

  // Returns the location at t of a halfedge, in its face, or in the opposite face if it is a border halfedge; the null
  // location if the edge has no face.
  static Face_location location(halfedge_descriptor he, const FT& t, const Triangle_mesh& tm, const Traits& traits)
  {
    if(!is_border(he, tm))
      return location_in_face(he, t, tm, traits);
    const halfedge_descriptor other = opposite(he, tm);
    return is_border(other, tm) ? null_location(traits) : location_in_face(other, FT(FT(1) - t), tm, traits);
  }

  // --- locations of points of space ---

  // Throws Invalid_geodesic_input if a corner of a face has a coordinate that is infinite or not a number. With
  // assertions, CGAL's trees would stop; without them, their boxes would be wrong. (Only floating point numbers have
  // such values.) `position` is that of the face in its range.
  static void check_corners(face_descriptor f, std::size_t position, const Triangle_mesh& tm,
                            VertexPointMap vertex_point_map)
  {
    if(!std::is_floating_point<FT>::value)
      return;
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, tm), tm))
    {
      const auto& p = get(vertex_point_map, target(h, tm));
      if(!CGAL::is_finite(p.x()) || !CGAL::is_finite(p.y()) || !CGAL::is_finite(p.z()))
        throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::NON_FINITE_POINT,
                                     "face " + std::to_string(position)
                                       + " has a vertex with a coordinate that is not finite", position);
    }
  }

  // Fills a tree with the faces of the mesh, in place of what it has held. Throws as check_corners().
  // Complexity: O(n log n) for n faces.
  template <typename AABBTraits>
  static void build_tree(const Triangle_mesh& tm, AABB_tree<AABBTraits>& tree, VertexPointMap vertex_point_map)
  {
    const auto range = faces(tm);
    std::size_t position = 0;
    for(const face_descriptor f : range)
      check_corners(f, position++, tm, vertex_point_map);
    tree.rebuild(range.begin(), range.end(), tm, vertex_point_map);
    // Otherwise the first query would build it, and queries may come from several threads.
    tree.build();
  }

  // Returns the location nearest to a point. The tree chooses between equally near faces.
  // Requires: the tree holds the faces of tm, at least one. Throws Invalid_geodesic_input if sizes are out of range.
  // Takes logarithmic time in practice.
  template <typename AABBTraits>
  static Face_location locate(const Point_3& p, const AABB_tree<AABBTraits>& tree, const Triangle_mesh& tm,
                              VertexPointMap vertex_point_map, const Traits& traits)
  {
    check_size(tree, p);
    const auto nearest = tree.closest_point_and_primitive(p);
    return location_of_point(nearest.second, nearest.first, tm, vertex_point_map, traits);
  }

  // Returns the location where a ray meets the mesh first; the null location if it meets no face in a point. Of equal
  // distances from the source of the ray the first one that the tree reports counts. A face in a plane with the ray
  // meets it in a segment and does not count; neighbors that meet it in a point do. Takes time for all faces that the
  // ray meets. Throws Invalid_geodesic_input if sizes are out of range.
  template <typename AABBTraits>
  static Face_location locate(const Ray_3& ray, const AABB_tree<AABBTraits>& tree, const Triangle_mesh& tm,
                              VertexPointMap vertex_point_map, const Traits& traits)
  {
    check_size(tree, ray.source());
    check_direction(ray);
    using Intersection = typename AABB_tree<AABBTraits>::template Intersection_and_primitive_id<Ray_3>::Type;
    std::vector<Intersection> intersections;
    tree.all_intersections(ray, std::back_inserter(intersections));

    const Point_3* nearest = nullptr;
    face_descriptor nearest_face = Graph_traits::null_face();
    auto squared_distance = traits.compute_squared_distance_3_object();
    for(const Intersection& i : intersections)
    {
      const Point_3* p = held_value<Point_3>(i.first);
      if(p != nullptr
         && (nearest == nullptr || squared_distance(*p, ray.source()) < squared_distance(*nearest, ray.source())))
      {
        nearest = p;
        nearest_face = i.second;
      }
    }
    return nearest == nullptr ? null_location(traits)
                              : location_of_point(nearest_face, *nearest, tm, vertex_point_map, traits);
  }

private:
  // Throws if the mesh, or the mesh with the point, is too large or too small for CGAL's trees and kernels: the
  // location would be wrong. Number types that are not floating point have no range to leave.
  template <typename AABBTraits>
  static void check_size(const AABB_tree<AABBTraits>& tree, const Point_3& p)
  {
    if(!std::is_floating_point<FT>::value || tree.empty())
      return;
    const Bbox_3 mesh = tree.bbox(), all = mesh + p.bbox();
    const bool is_number = p.x() == p.x() && p.y() == p.y() && p.z() == p.z(); // a box drops NaN
    if(!is_number || !(largest_span(all) <= largest_size)
       || (largest_span(mesh) > 0 && largest_span(mesh) < 1 / largest_size))
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::NON_FINITE_POINT,
                                   "the mesh is too large or too small to locate points, or the point is too far away, "
                                   "or a coordinate is not a number");
  }

  // Throws if the direction of a ray is not a vector of numbers that CGAL's kernels can compute with.
  static void check_direction(const Ray_3& ray)
  {
    if(!std::is_floating_point<FT>::value)
      return;
    const auto v = ray.to_vector();
    for(const double c : {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())})
      if(!(-largest_size <= c && c <= largest_size)) // also if it is NaN
        throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::NON_FINITE_POINT,
                                     "the direction of the ray is too large, or not a number");
  }

  // Returns the longest side of a box.
  static double largest_span(const Bbox_3& box)
  {
    return (std::max)(box.xmax() - box.xmin(), (std::max)(box.ymax() - box.ymin(), box.zmax() - box.zmin()));
  }

  // The trees and kernels multiply four lengths: (1e75)^4 = 1e300 is finite in `double`, and (1e-75)^4 = 1e-300 is
  // normal.
  static constexpr double largest_size = 1e75;

  static Triangle_3 triangle(face_descriptor f, const Triangle_mesh& tm, VertexPointMap vertex_point_map,
                             const Traits& traits)
  {
    const halfedge_descriptor h = halfedge(f, tm);
    return traits.construct_triangle_3_object()(get(vertex_point_map, source(h, tm)),
                                                get(vertex_point_map, target(h, tm)),
                                                get(vertex_point_map, target(next(h, tm), tm)));
  }

  // Returns the location at t of a halfedge in its face; the third coordinate is an exact 0. Requires: `he` has a face.
  // Takes constant time, as it is one of three.
  static Face_location location_in_face(halfedge_descriptor he, const FT& t, const Triangle_mesh& tm,
                                        const Traits& traits)
  {
    const face_descriptor f = face(he, tm);
    std::size_t k = 0;
    for(halfedge_descriptor h = halfedge(f, tm); h != he; h = next(h, tm))
      ++k;
    std::array<FT, 3> c = {FT(0), FT(0), FT(0)};
    c[k] = FT(1) - t;
    c[(k + 1) % 3] = t;
    return Face_location(f, traits.construct_barycentric_coordinates_object()(c[0], c[1], c[2]));
  }

  // Returns the location of a point that lies on face f. In a face with nearly no height the coordinates are lost in
  // rounding; then the point is taken for one of the longest side.
  static Face_location location_of_point(face_descriptor f, const Point_3& p, const Triangle_mesh& tm,
                                         VertexPointMap vertex_point_map, const Traits& traits)
  {
    const Face_location location(f, traits.construct_barycentric_coordinates_in_triangle_3_object()(
                                      triangle(f, tm, vertex_point_map, traits), p));
    return are_valid_coordinates(weights(location.second, traits))
             ? location
             : location_on_longest_side(f, p, tm, vertex_point_map, traits);
  }

  // Returns the location on the longest side, the first of several, that is nearest to p. Its error is the height of
  // the face, and a few epsilon of the side. Computes in double.
  // Formula: t = (p - a)(b - a) / |b - a|^2 for a side from a to b, clamped to [0, 1]; 0 if the face is a single point.
  static Face_location location_on_longest_side(face_descriptor f, const Point_3& p, const Triangle_mesh& tm,
                                                VertexPointMap vertex_point_map, const Traits& traits)
  {
    halfedge_descriptor longest = halfedge(f, tm), h = longest;
    double squared_length = -1., t = 0.;
    for(int k = 0; k < 3; ++k, h = next(h, tm))
    {
      const Point_3 a = get(vertex_point_map, source(h, tm));
      const Coordinates side = difference(get(vertex_point_map, target(h, tm)), a);
      const double l = scalar_product(side, side);
      if(l > squared_length)
      {
        longest = h;
        squared_length = l;
        t = scalar_product(side, difference(p, a));
      }
    }
    t = squared_length > 0 ? (std::min)((std::max)(t / squared_length, 0.), 1.) : 0.;
    return location_in_face(longest, FT(t), tm, traits);
  }

  static Coordinates difference(const Point_3& p, const Point_3& q)
  {
    return {CGAL::to_double(p.x()) - CGAL::to_double(q.x()), CGAL::to_double(p.y()) - CGAL::to_double(q.y()),
            CGAL::to_double(p.z()) - CGAL::to_double(q.z())};
  }

  static double scalar_product(const Coordinates& u, const Coordinates& v)
  {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SURFACE_LOCATIONS_H
