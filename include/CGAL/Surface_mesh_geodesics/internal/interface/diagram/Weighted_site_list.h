// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_WEIGHTED_SITE_LIST_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_WEIGHTED_SITE_LIST_H

// The sites of a geodesic Voronoi diagram as the user gave them: vertices or locations, with weights in the user's
// unit. A propagation knows offsets instead of weights: it starts from each site with the difference from the largest
// weight, so the heaviest site starts at 0 and no offset is negative.
//
// Formula: offset = W - w for a site with the weight w, where W is the largest weight. So d + offset - W, for the
// geodesic distance d from the site, is the distance d - w that users get.
//
// Weights are checked here, not where offsets are: add() reports an invalid weight at once, and the messages speak of
// the weight that the user gave. All offsets that leave are valid.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Sites have the numbers 0, 1, ... in the order in which they are added. Invariant: all weights are finite; add()
// rejects others. Whether vertices and locations are on the mesh is checked by the solver, which gets them later. The
// three types are those of the public diagram; CGAL::to_double() takes FT. Not safe for threads by itself:
// Lazy_Voronoi_diagram changes the list only while it is not shared.
//
// A curve may be a site, too; its location is that of its first point. The list keeps the curve for the user, and a
// function that hands it to the solver with its offset.
template <typename vertex_descriptor, typename Face_location, typename FT, typename Curve = void>
class Weighted_site_list
{
public:
  struct Site
  {
    bool is_vertex;
    vertex_descriptor vertex; // if is_vertex
    Face_location location;   // otherwise
    FT weight;
    std::shared_ptr<const Curve> curve = nullptr; // null for a point
    // Hands the curve to the solver with an offset in the user's unit; null for a point. (The list does not know the
    // class of curves: programs without curves do not compile it.)
    std::function<void(double)> give_curve = nullptr;
  };

  std::size_t size() const { return m_sites.size(); }
  bool empty() const { return m_sites.empty(); }
  void clear() { m_sites.clear(); }
  auto begin() const { return m_sites.begin(); }
  auto end() const { return m_sites.end(); }

  const Site& operator[](std::size_t i) const
  {
    CGAL_precondition_msg(i < m_sites.size(), "there is no site with this number");
    return m_sites[i];
  }

  // Appends a site and returns its number. Throws Invalid_geodesic_input if the weight is not finite. The list has not
  // changed then.
  std::size_t add(const Site& site)
  {
    if(!std::isfinite(CGAL::to_double(site.weight)))
      reject_weight("is not finite", m_sites.size());
    m_sites.push_back(site);
    return m_sites.size() - 1;
  }

  // Returns 0 if there are no sites. Takes linear time.
  double largest_weight() const
  {
    double largest = m_sites.empty() ? 0. : CGAL::to_double(m_sites.front().weight);
    for(const Site& s : m_sites)
      largest = (std::max)(largest, CGAL::to_double(s.weight));
    return largest;
  }

  // Calls add(site, offset) for each site. Throws Invalid_geodesic_input if an offset is not finite, or too large as a
  // multiple of `unit`, the unit of the intrinsic mesh. (With an infinite unit, no finite offset is too large.) The
  // sites before that one have been passed on then, so what add() has filled must not be used. Takes linear time.
  // Requires: unit > 0. The offset that add() gets is in the user's unit.
  template <typename Add>
  void for_each_offset(double unit, Add add) const
  {
    const double largest = largest_weight();
    for(std::size_t i = 0; i < m_sites.size(); ++i)
    {
      const double offset = largest - CGAL::to_double(m_sites[i].weight);
      if(!(offset / unit <= Tolerance<double>::largest_offset()))
        reject_weight("differs too much from the largest weight", i);
      add(m_sites[i], offset);
    }
  }

private:
  [[noreturn]] static void reject_weight(const char* reason, std::size_t i)
  {
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_OFFSET,
                                 "the weight of site " + std::to_string(i) + ' ' + reason, i);
  }

  std::vector<Site> m_sites;
};

// Hands the sites over to a solver as its sources, in their order. `weights(b)` converts barycentric coordinates.
// Throws Invalid_geodesic_input for an invalid site. Requires: the solver has a mesh. Takes linear time.
template <typename Sites, typename Solver, typename Weights>
void give_sites(const Sites& sites, Solver& solver, Weights weights)
{
  solver.begin_sources();
  sites.for_each_offset(solver.unit(), [&](const typename Sites::Site& s, double offset)
  {
    if(s.give_curve != nullptr)
      s.give_curve(offset);
    else if(s.is_vertex)
      solver.add_source(s.vertex, offset, "site");
    else
      solver.add_source_location(std::make_pair(s.location.first, weights(s.location.second)), offset, "site");
  });
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_WEIGHTED_SITE_LIST_H
