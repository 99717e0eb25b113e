// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_NEAREST_PLACES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_NEAREST_PLACES_H

// The nearest points of a surface, as locations. (Classes of the package take the tree of faces from the user;
// functions make one.)
//
// Rounding. A point of a polyline that lies on an edge is beside it by the rounding of its coordinates. Far away from
// the origin, or with fine faces, that is more than Tolerance::barycentric(), and two neighbors of the polyline would
// have no face in common. So a point that is as near to a side of its face as its coordinates are rounded is moved
// there.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Surface_locations.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/curves/curve_segments.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/cgal_compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include CGAL_SURFACE_MESH_GEODESICS_TREE_TRAITS_HEADER
#include <CGAL/AABB_tree.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Refers to the mesh; the map is copied. The tree is made once, for all points. Several threads may call location().
//
// Error. A point that is moved to a side moves by place_in_space() of the coordinates. The tree adds its own error: it
// projects points to planes, which costs more digits the farther the faces are from the origin.
template <typename TriangleMesh, typename VertexPointMap>
class Nearest_places
{
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Kernel = typename Kernel_traits<Point>::Kernel;
  using Traits = Surface_mesh_shortest_path_traits<Kernel, TriangleMesh>;
  using Locations = Surface_locations<Traits, VertexPointMap>;
  using Primitive = AABB_face_graph_triangle_primitive<TriangleMesh, VertexPointMap>;
  using Tree = AABB_tree<CGAL_SURFACE_MESH_GEODESICS_TREE_TRAITS<Kernel, Primitive>>;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

public:
  using Location = std::pair<face_descriptor, std::array<double, 3>>;

  // Faces to avoid are left out: their corners may be anywhere, as no point is located in them. Throws
  // Invalid_geodesic_input, with the position of the face: NOT_A_TRIANGLE for any face, as the tree would take its
  // first three corners, NON_FINITE_POINT for a corner of a face that is not avoided, and INVALID_CURVE if no face is
  // left. O(n log n) for n faces.
  template <typename FaceIndexMap>
  Nearest_places(const TriangleMesh& tm, VertexPointMap vpm, const Obstacles& obstacles, FaceIndexMap fim)
    : m_tm(tm), m_vpm(vpm)
  {
    using Reason = Invalid_geodesic_input::Reason;
    std::vector<face_descriptor> wanted;
    std::size_t position = 0;
    for(const face_descriptor f : faces(tm))
    {
      if(!is_triangle(halfedge(f, tm), tm))
        throw Invalid_geodesic_input(Reason::NOT_A_TRIANGLE, "face " + std::to_string(position)
                                                               + " of the mesh does not have three edges", position);
      if(!obstacles.avoids(static_cast<std::size_t>(get(fim, f))))
      {
        Locations::check_corners(f, position, tm, vpm);
        wanted.push_back(f);
      }
      ++position;
    }
    // (The tree of no faces has no nearest point.)
    if(wanted.empty())
      reject_curve(0, "is not on the mesh, which has no face for it");
    // It is built now, so that queries may come from several threads.
    m_tree.rebuild(wanted.begin(), wanted.end(), tm, vpm);
    m_tree.build();
  }

  // Returns the location nearest to a point. Logarithmic in practice. Throws Invalid_geodesic_input.
  Location location(const Point& p) const
  {
    const auto found = Locations::locate(p, m_tree, m_tm, m_vpm, Traits());
    Location place(found.first, {});
    for(std::size_t k = 0; k < 3; ++k)
      place.second[k] = CGAL::to_double(found.second[k]);
    move_to_sides(place);
    return place;
  }

private:
  // Sets those coordinates to zero that are smaller than rounding may have made them: the height of the point above a
  // side is the coordinate times the height of the face. The largest coordinate takes up what is missing. (A face
  // without height keeps its coordinates.)
  void move_to_sides(Location& place) const
  {
    const auto h = halfedge(place.first, m_tm);
    const std::array<Point, 3> corner{get(m_vpm, source(h, m_tm)), get(m_vpm, target(h, m_tm)),
                                      get(m_vpm, target(next(h, m_tm), m_tm))};
    double largest = 0;
    for(const Point& q : corner)
      for(int i = 0; i < 3; ++i)
        largest = (std::max)(largest, std::abs(CGAL::to_double(q[i])));
    const double beside = Tolerance<double>::place_in_space() * largest;
    // The length of the cross product of two sides is the height above a side times that side.
    const double heights = length_of(cross_product(corner[1] - corner[0], corner[2] - corner[0]));
    std::array<double, 3>& b = place.second;
    for(std::size_t k = 0; k < 3; ++k)
      if(std::abs(b[k]) * heights <= beside * length_of(corner[(k + 1) % 3] - corner[(k + 2) % 3]))
        b[k] = 0;
    const std::size_t most = static_cast<std::size_t>(std::max_element(b.begin(), b.end()) - b.begin());
    if(b[most] > 0)
      b[most] = 1 - (b[(most + 1) % 3] + b[(most + 2) % 3]);
  }

  static double length_of(const typename Kernel::Vector_3& v)
  {
    return std::sqrt(CGAL::to_double(v.squared_length()));
  }

  const TriangleMesh& m_tm;
  VertexPointMap m_vpm;
  Tree m_tree;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_NEAREST_PLACES_H
