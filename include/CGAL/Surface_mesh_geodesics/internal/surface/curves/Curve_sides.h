// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_CURVE_SIDES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_CURVE_SIDES_H

// On which side of the curves each vertex and each face is. Faces of the refined mesh get two colors: they change where
// an edge is crossed along which curves run an odd number of times, and nowhere else. So a curve that crosses itself
// separates a checkerboard, and a part that is run along there and back separates nothing.
//
// Proof that the color of a vertex beside the curves is well defined: no edge of a curve ends there, so that all faces
// around it are connected without crossing one.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariant: all faces that are connected across edges with a face that has a color have one. (`Mesh` may be a class of
// tests that counts visits.)
template <typename FT, typename Mesh = Intrinsic_mesh<FT>>
class Curve_sides
{
public:
  // Colors all faces that are connected with a curve. The face on the left of the first edge of the first curve is
  // negative; if there are several components, so is that of the first edge in each. Edges along which curves run an
  // even number of times do not count. Along the others, the first time decides (Source_edge), so walls reverse no sign
  // in the component of the first edge. Throws Invalid_geodesic_input if two colors do not suffice: then some way from
  // one side of a curve to the other crosses no curve. Linear in the size of the mesh, plus the time of sorting the
  // edges.
  Curve_sides(const Mesh& mesh, const Source_curves<FT>& curves)
    : m_mesh(mesh), m_face_sign(mesh.number_of_faces(), 0), m_is_crossed(4 * mesh.number_of_faces(), null_id)
  {
    std::vector<Source_edge<FT>> edges;
    for(const Source_edge<FT>& e : curves.edges)
      if(e.copies % 2 == 1)
        edges.push_back(e);
    std::sort(edges.begin(), edges.end(), [](const Source_edge<FT>& a, const Source_edge<FT>& b)
    {
      return std::tie(a.curve, a.segment, a.first_parameter, a.left)
           < std::tie(b.curve, b.segment, b.first_parameter, b.left);
    });
    for(const Source_edge<FT>& e : edges)
      for(const Halfedge_id h : {e.left, e.right})
        if(h != null_id)
          m_is_crossed[h] = e.curve;
    for(const Source_vertex<FT>& v : curves.vertices)
      m_on_curve.push_back(v.vertex);
    std::vector<char> is_passed(mesh.number_of_vertices(), 0);
    for(const Source_edge<FT>& e : edges)
    {
      color_from(e.left, -1, is_passed);
      color_from(e.right, 1, is_passed);
    }
  }

  // Returns -1 or 1: the side of a vertex. A vertex that is connected with no curve is on the positive side; that of a
  // vertex on a curve means nothing. Constant time. Requires: the mesh is still the refined one.
  int sign(Vertex_id v) const
  {
    const Halfedge_id h = m_mesh.halfedge(v);
    return h == null_id ? 1 : sign_of_face(face_of(h));
  }

  // The same for a face of the refined mesh, all inner points of which are on one side.
  int sign_of_face(Face_id f) const { return m_face_sign[f] == 0 ? 1 : m_face_sign[f]; }

private:
  // Colors the face of h, and all that are connected with it, unless it has a color. A stack takes the place of
  // recursion, which would be as deep as the mesh is large. Each face is visited once, and each of its edges compared
  // with the color across: so every contradiction is found, wherever the walk begins. A pinched vertex is passed once:
  // all faces around it have one color then, so a second visit would neither color one nor find a contradiction.
  void color_from(Halfedge_id h, int sign, std::vector<char>& is_passed)
  {
    if(h == null_id || m_face_sign[face_of(h)] != 0)
      return;
    std::vector<Face_id> waiting;
    const auto color = [&](Face_id f, int s, std::uint32_t curve)
    {
      if(m_face_sign[f] == 0)
      {
        m_face_sign[f] = static_cast<signed char>(s);
        waiting.push_back(f);
      }
      else if(m_face_sign[f] != s)
        reject(curve);
    };
    color(face_of(h), sign, null_id);
    while(!waiting.empty())
    {
      const Face_id f = waiting.back();
      waiting.pop_back();
      const int s = m_face_sign[f];
      for(unsigned int k = 0; k < 3; ++k)
      {
        const Halfedge_id g = halfedge_of(f, k), o = m_mesh.opposite(g);
        if(o != null_id)
          color(face_of(o), m_is_crossed[g] == null_id ? s : -s, m_is_crossed[g]);
        // Across a pinched vertex, if no curve runs through it: paths lead across vertices as well, so distances behind
        // a pinch have the sign of the pinch.
        const Vertex_id v = m_mesh.source(g);
        if(is_passed[v] != 0 || !m_mesh.has(v, Mesh::PINCHED))
          continue;
        is_passed[v] = 1;
        if(!std::binary_search(m_on_curve.begin(), m_on_curve.end(), v))
          m_mesh.for_each_halfedge_around(v, [&](Halfedge_id around) { color(face_of(around), s, null_id); });
      }
    }
  }

  // The contradiction shows where two fronts of color meet. If they meet at a curve, its number helps the user; else no
  // curve is to blame more than others.
  [[noreturn]] static void reject(std::uint32_t curve)
  {
    const std::size_t element = curve == null_id ? Invalid_geodesic_input::no_element : std::size_t(curve);
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_CURVE,
                                 "the curves do not separate the surface: their two sides are connected "
                                 "(is one open that should be closed?)", element);
  }

  // All tables have the size of the refined mesh, and live as long as the curves are inserted.
  const Mesh& m_mesh;
  std::vector<signed char> m_face_sign; // 0: no color
  std::vector<std::uint32_t> m_is_crossed; // by halfedge: the curve that runs along it, or null_id
  std::vector<Vertex_id> m_on_curve;       // sorted
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_CURVE_SIDES_H
