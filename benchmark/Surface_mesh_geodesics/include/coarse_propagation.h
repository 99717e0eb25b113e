// For benchmark_flat_vertices: the propagation on a mesh without its flat vertices, which measures the removed vertices
// as points of faces. Each list of windows that enters a face is measured at the points of the face; no window is kept.

#ifndef COARSE_PROPAGATION_H
#define COARSE_PROPAGATION_H

#include "flat_vertex_removal.h"

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace Flat_vertices {

using namespace CGAL::Surface_mesh_geodesics::internal;

// Why this is exact. The shortest path to a point of a face comes straight from a corner of the face, or it enters the
// face across an edge through a window of a list that is propagated across that edge: pruning removes a window only
// where another path is not longer, for all points behind its edge. A list that enters after its pseudo-source has
// become nearer gives the length of a path that is longer; the pseudo-source emits windows again, and they give the
// final distance. complete() adds the paths from corners, when distances of vertices are final.
template <typename FT>
class Distances_of_points
{
public:
  using List = Window_list<FT>;

  // Mesh and points must outlive this object.
  Distances_of_points(const Intrinsic_mesh<FT>& mesh, const Fine_vertices<FT>& fine)
    : m_mesh(mesh), m_fine(fine), m_distance(fine.point.size(), Vertex_distance_field<FT>::infinity())
  {}

  // Improves the distances of the points in the face of h by the windows of a list that enters it across h.
  void keep(Halfedge_id h, const List& list)
  {
    const Face_id f = face_of(h);
    const std::size_t first = m_fine.first_point[f], last = m_fine.first_point[f + std::size_t(1)];
    if(first == last)
      return;
    const std::array<Planar_point<FT>, 3> corner = layout_of_face(m_mesh.face(f));
    const unsigned int k = index_in_face(h);
    const Plane_frame<FT> frame = Plane_frame<FT>::from(corner[k], corner[next_corner(k)]);
    for(std::size_t i = first; i < last; ++i)
    {
      Planar_point<FT> p = frame.coordinates(m_fine.point[i]);
      p.y = (std::max)(FT(0), p.y);
      improve(i, p, list);
    }
  }

  // Improves the distances of all points by the straight paths from the corners of their faces.
  void complete(const std::vector<FT>& distance)
  {
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      const std::array<Planar_point<FT>, 3> corner = layout_of_face(m_mesh.face(f));
      for(std::size_t i = m_fine.first_point[f]; i < m_fine.first_point[f + std::size_t(1)]; ++i)
        for(unsigned int k = 0; k < 3; ++k)
        {
          const FT x = m_fine.point[i].x - corner[k].x, y = m_fine.point[i].y - corner[k].y;
          m_distance[i] = (std::min)(m_distance[i], FT(distance[m_mesh.face(f).vertex[k]] + norm(x, y)));
        }
    }
  }

  const FT& distance(std::size_t i) const { return m_distance[i]; }

private:
  // Improves point i, at p in the frame of the windows. Most windows are farther away than the best one so far even if
  // their rays reached the point; this is seen from squares.
  void improve(std::size_t i, const Planar_point<FT>& p, const List& list)
  {
    const Window_columns<FT>& w = list.columns;
    for(std::size_t j = 0; j < list.size; ++j)
    {
      const FT x = p.x - w.image_x()[j], y = p.y + w.image_depth()[j], room = m_distance[i] - w.root_distance()[j];
      if(!(room > 0 && x * x + y * y < room * room))
        continue;
      m_distance[i] = (std::min)(m_distance[i], distance_through(w.get(j), p));
    }
  }

  // Returns the length of the path to p through a window: straight from the image or, if the straight line passes
  // beside the window, bent at the nearer end of it. See improve_arrival() in paths/distance_at_location.h.
  static FT distance_through(const Window<FT>& w, const Planar_point<FT>& p)
  {
    const FT height = p.y + w.image_depth;
    const FT t = height > 0 ? FT((w.image_x * p.y + p.x * w.image_depth) / height) : p.x;
    if(w.begin <= t && t <= w.end)
      return w.root_distance + norm(FT(p.x - w.image_x), height);
    const FT bend = t < w.begin ? w.begin : w.end;
    return w.root_distance + norm(FT(bend - w.image_x), w.image_depth) + norm(FT(p.x - bend), p.y);
  }

  const Intrinsic_mesh<FT>& m_mesh;
  const Fine_vertices<FT>& m_fine;
  std::vector<FT> m_distance; // by point
};

// The keeper of a propagation that measures points (see Star_propagation).
template <typename FT>
class Point_keeper
{
public:
  explicit Point_keeper(Distances_of_points<FT>& points) : m_points(&points) {}

  void keep(Halfedge_id h, const Window_list<FT>& list) { m_points->keep(h, list); }
  void advance(const FT&) const {}

private:
  Distances_of_points<FT>* m_points;
};

// A run on a mesh whose flat vertices have been removed. Vertices are those of the fine mesh.
template <typename FT, typename Rules>
class Coarse_propagation
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // On the mesh from which the vertices have been removed. Requires: the sources are vertices of the fine mesh that
  // have been kept.
  Coarse_propagation(const Mesh& mesh, Fine_vertices<FT> fine, const Source_set<FT>& sources)
    : m_fine(std::move(fine)), m_points(mesh, m_fine), m_propagation(mesh, m_field, Point_keeper<FT>(m_points))
  {
    for(std::size_t i = 0; i < sources.size(); ++i)
      m_propagation.add_source(m_fine.entry[sources.vertices[i]], sources.offset(i));
  }

  Coarse_propagation(const Coarse_propagation&) = delete;
  Coarse_propagation& operator=(const Coarse_propagation&) = delete;

  template <typename GoOn>
  bool run(GoOn go_on)
  {
    if(!m_propagation.run(go_on))
      return false;
    m_points.complete(m_field.distance);
    return true;
  }

  FT distance(Vertex_id v) const
  {
    const std::uint32_t entry = m_fine.entry[v];
    const bool is_point = entry >= m_fine.number_of_coarse;
    return is_point ? m_points.distance(entry - m_fine.number_of_coarse) : m_field.distance[entry];
  }

  CGAL::Surface_mesh_geodesics::Propagation_statistics statistics() const { return m_propagation.statistics(); }

private:
  Fine_vertices<FT> m_fine;
  Field m_field;
  Distances_of_points<FT> m_points;
  Distance_propagation<FT, Rules, Point_keeper<FT>> m_propagation;
};

} // namespace Flat_vertices

#endif // COARSE_PROPAGATION_H
