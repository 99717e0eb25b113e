#ifndef SURFACE_MESH_GEODESICS_TEST_WRONG_VORONOI_DIAGRAM_H
#define SURFACE_MESH_GEODESICS_TEST_WRONG_VORONOI_DIAGRAM_H

// Diagrams that give wrong answers, and their certificates.

#include "Voronoi_test_helpers.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_certifier.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace test_meshes {

namespace SMG = CGAL::Surface_mesh_geodesics;
using Certificate = SMG::Geodesic_Voronoi_certificate;

// An arc with changed answers.
struct Moved_arc
{
  Voronoi::Arc arc;
  double shift_of_points, shift_of_distance, factor_of_distance;
  bool is_straight;
  std::size_t other_site; // in place of the second one

  std::pair<std::size_t, std::size_t> sites() const
  {
    return {arc.sites().first, other_site != Voronoi::null_site() ? other_site : arc.sites().second};
  }
  bool is_segment() const { return is_straight || arc.is_segment(); }
  double distance(double t) const { return arc.distance(t) * factor_of_distance + shift_of_distance; }

  Face_location point(double t) const
  {
    Face_location l = arc.point(t);
    std::array<double, 3> b = {l.second[0], l.second[1], l.second[2]};
    const std::size_t k = static_cast<std::size_t>(std::max_element(b.begin(), b.end()) - b.begin());
    b[k] -= shift_of_points;
    b[(k + 1) % 3] += shift_of_points;
    return {l.first, {b[0], b[1], b[2]}};
  }
};

// A vertex of the diagram with changed answers.
struct Moved_vertex
{
  Voronoi::Vertex vertex;
  double shift_of_distance, factor_of_distance;
  std::size_t number_of_sites; // of those that it names

  std::vector<std::size_t> sites() const
  {
    std::vector<std::size_t> result = vertex.sites();
    result.resize((std::min)(result.size(), number_of_sites));
    return result;
  }
  double distance() const { return vertex.distance() * factor_of_distance + shift_of_distance; }
  Face_location location() const { return vertex.location(); }
};

// A diagram with wrong answers. An answer that concerns a single site is wrong for the site `culprit`.
struct Wrong_diagram : Voronoi
{
  using Voronoi::Voronoi;

  std::size_t culprit = 0;
  double shift_of_weight = 0., shift_of_points = 0., shift_of_distance = 0., factor_of_area = 1.;
  double factor_of_distance = 1., shift_of_vertices = 0.; // of all distances, and of vertices of the diagram
  std::size_t site_of_arcs = null_site(), missing_arc = null_site();
  bool are_arcs_straight = false;
  bool is_tie_lost = false; // site 1 gets the cell of site 0
  vertex_descriptor vertex_of_culprit = boost::graph_traits<Mesh>::null_vertex();
  std::function<void(std::vector<Boundary>&)> spoil_boundary;
  // A site that the diagram has overlooked. It is the last one.
  bool has_hidden_site = false;
  Face_location hidden_site;
  const SMG::Surface_curve<Mesh>* hidden_curve = nullptr; // null if it is a point
  double hidden_weight = 0.;

  bool is_hidden(std::size_t i) const { return i == Voronoi::number_of_sites(); }
  std::size_t number_of_sites() const { return Voronoi::number_of_sites() + (has_hidden_site ? 1 : 0); }
  Face_location site(std::size_t i) const { return is_hidden(i) ? hidden_site : Voronoi::site(i); }
  auto site_curve(std::size_t i) const { return is_hidden(i) ? hidden_curve : Voronoi::site_curve(i); }
  double weight(std::size_t i) const
  {
    return is_hidden(i) ? hidden_weight : Voronoi::weight(i) + (i == culprit ? shift_of_weight : 0.);
  }
  double area(std::size_t i) const
  {
    return is_hidden(i) ? 0. : Voronoi::area(i) * (i == culprit ? factor_of_area : 1.);
  }

  std::size_t nearest_site(vertex_descriptor v) const
  {
    return v == vertex_of_culprit ? culprit : after_tie(Voronoi::nearest_site(v));
  }
  std::size_t nearest_site(const Face_location& l) const { return after_tie(Voronoi::nearest_site(l)); }
  std::size_t after_tie(std::size_t i) const { return is_tie_lost && i == 0 ? 1 : i; }

  double distance_to_nearest_site(vertex_descriptor v) const
  {
    return Voronoi::distance_to_nearest_site(v) * factor_of_distance;
  }
  double distance_to_nearest_site(const Face_location& l) const
  {
    return Voronoi::distance_to_nearest_site(l) * factor_of_distance;
  }

  std::vector<Arc> arcs(face_descriptor f) const { return Voronoi::arcs(f); }
  std::vector<Moved_arc> arcs() const
  {
    std::vector<Moved_arc> result;
    for(const Arc& a : Voronoi::arcs())
    {
      const bool is_moved = a.sites().first == culprit || a.sites().second == culprit;
      if(a.index() != missing_arc)
      {
        result.push_back({a, is_moved ? shift_of_points : 0., is_moved ? shift_of_distance : 0., factor_of_distance,
                          are_arcs_straight, is_moved ? site_of_arcs : null_site()});
      }
    }
    return result;
  }

  std::vector<Moved_vertex> vertices() const
  {
    std::vector<Moved_vertex> result;
    for(const Vertex& v : Voronoi::vertices())
    {
      result.push_back({v, shift_of_vertices, factor_of_distance, v.sites().size()});
    }
    return result;
  }

  std::vector<Boundary> boundary(std::size_t i) const
  {
    if(is_hidden(i))
    {
      return {};
    }
    std::vector<Boundary> result = Voronoi::boundary(i);
    if(i == culprit && spoil_boundary)
    {
      spoil_boundary(result);
    }
    return result;
  }
};

template <typename Diagram>
Certificate certificate_of(const Diagram& diagram)
{
  return SMG::internal::Private_access::make<Certificate>(
    SMG::internal::certify_diagram_with_points<CGAL::Surface_mesh_geodesic_paths, Paths_traits, CGAL::Sequential_tag>(
      diagram, CGAL::parameters::all_default()));
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_TEST_WRONG_VORONOI_DIAGRAM_H
