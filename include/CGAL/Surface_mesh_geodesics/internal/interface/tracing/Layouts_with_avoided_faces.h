// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_LAYOUTS_WITH_AVOIDED_FACES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_LAYOUTS_WITH_AVOIDED_FACES_H

// Faces to avoid, for a walk: it ends at their rim, as at the border of the mesh without them. They are known by
// descriptors, as walls are: a walk has no index maps, and making one would take linear time.
//
// Why the results are those of the mesh without these faces, bit by bit: a walk reads a face, its neighbors, and the
// fan of a vertex. The faces that are left have the same first halfedges in both meshes, hence the same layouts and
// frames. A fan begins at the border or at the rim if there is one, in either mesh at the same halfedge.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Face_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A walk asks for few faces, but in no order. Descriptors have an order in every model of FaceGraph.
//
// A range of faces, sorted for questions. Takes the time of sorting. Throws Invalid_geodesic_input for a face that is
// not one of the mesh, as far as the mesh can tell.
template <typename TriangleMesh>
class Face_set
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

public:
  template <typename Faces>
  Face_set(const TriangleMesh& tm, const Faces& faces)
  {
    for(const face_descriptor f : faces)
    {
      if(f == boost::graph_traits<TriangleMesh>::null_face() || Removed_elements<TriangleMesh>::contain(f, tm))
        reject_face("the face to avoid", m_faces.size());
      m_faces.push_back(f); // NOLINT(performance-inefficient-vector-operation): a range need not know its size
    }
    std::sort(m_faces.begin(), m_faces.end());
  }

  bool contains(face_descriptor f) const { return std::binary_search(m_faces.begin(), m_faces.end(), f); }

private:
  std::vector<face_descriptor> m_faces; // sorted
};

// The faces for which a map of the user is true. The map is asked where the walk is, so its size does not matter.
template <typename FaceMap>
class Face_map_set
{
public:
  template <typename TriangleMesh>
  Face_map_set(const TriangleMesh&, const FaceMap& map) : m_map(map)
  {}

  template <typename Face>
  bool contains(Face f) const
  {
    return get(m_map, f);
  }

private:
  FaceMap m_map;
};

// `Layouts` are those by points or by lengths, which avoid nothing; `Avoided` is one of the classes above.
//
// Layouts of faces that know faces to avoid besides.
template <typename TriangleMesh, typename Layouts, typename Avoided>
class Layouts_with_avoided_faces : public Layouts
{
public:
  template <typename Faces>
  Layouts_with_avoided_faces(const TriangleMesh& tm, Layouts layouts, const Faces& faces)
    : Layouts(std::move(layouts)), m_avoided(tm, faces)
  {}

  // Requires: f is a face of the mesh.
  bool is_avoided(typename boost::graph_traits<TriangleMesh>::face_descriptor f) const
  {
    return m_avoided.contains(f);
  }

private:
  Avoided m_avoided;
};

// Returns the location b of a face to avoid as one of a face that is not avoided: a face and coordinates in the user's
// order. Throws Invalid_geodesic_input for a location inside of what is avoided; see place_at_rim(). Requires: b is
// snapped.
template <typename TriangleMesh, typename Layouts>
std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, Barycentric<double>>
location_beside_avoided_faces(typename boost::graph_traits<TriangleMesh>::face_descriptor f,
                              const Barycentric<double>& b, const TriangleMesh& tm, const Layouts& layouts)
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  // Walls do not matter here: a point on a wall may be given on either side of it.
  const auto is_open = [&](halfedge_descriptor g) { return !is_border(g, tm) && !layouts.is_avoided(face(g, tm)); };
  check_triangle(halfedge(f, tm), tm); // otherwise the corners of another polygon would count as those of a triangle
  const auto place = place_at_rim(f, b, tm, is_open, "the location", Invalid_geodesic_input::no_element);
  const halfedge_descriptor h = place.first;
  check_triangle(h, tm);
  Barycentric<double> c{0, 0, 0};
  unsigned int k = 0;
  for(halfedge_descriptor g = halfedge(face(h, tm), tm); g != h; g = next(g, tm))
    ++k;
  c[k] = place.second[0];
  c[next_corner(k)] = place.second[1];
  return {face(h, tm), c};
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_LAYOUTS_WITH_AVOIDED_FACES_H
