// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_FARTHEST_POINT_SAMPLING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_FARTHEST_POINT_SAMPLING_H

// Farthest point sampling: takes, again and again, the vertex that is farthest from all samples so far. (The
// thesis, section 6.2, proposes it for remeshing.)
//
// Distances are propagated once. A new sample is a further source of the same propagation, whose windows cover its
// Voronoi cell and little more (Distance_propagation::add_source() says why that is right). Curves from which samples
// keep away are sources from the beginning.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Strip_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Farthest_vertex_queue.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Curve_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Ties: of vertices that are equally far, the one that comes first in vertices(tm). Time: each sample costs the windows
// of its cell and a little more; Farthest_vertex_queue finds the next one.
//
// The mesh is referred to, the index maps are copied. Samples are vertices, and curves are inserted before the first
// one, so tables of vertices never grow: the queue may refer to the distances in m_field. Vertices of curves that the
// user does not know have the last numbers, behind all candidates.
//
// Walls divide a vertex into copies. All of them are candidates with the same distance, the least one, and the same
// rank: whichever comes first, the vertex becomes a sample, on all of its sides.
//
// An object is used by one thread. run() may be called again, which reads the mesh anew.
template <typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Farthest_point_sampling
{
  using Surface = Intrinsic_surface<double, TriangleMesh, VertexIndexMap, FaceIndexMap>;
  using vertex_descriptor = typename Surface::vertex_descriptor;

public:
  Farthest_point_sampling(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim)
    : m_tm(tm), m_surface(tm, vim, fim)
  {}

  // Avoids faces and edges when run() reads the mesh.
  void avoid(Obstacles obstacles) { m_surface.avoid(std::move(obstacles)); }

  // Writes samples until there are n, with those in the options, or the covering radius of the options is reached.
  // Returns the covering radius in the user's unit: the distance of the farthest vertex from its nearest sample. It is
  // infinity if no sample reaches some vertex that has a face, or if the visitor cancels the first propagation; if the
  // visitor cancels a later one, it is that of the samples before. Options is Sampling_options. Shape is
  // described in Face_shapes.h. Throws Invalid_geodesic_input, before anything is written.
  //
  // Each pass of the loop asks for the farthest vertex first: its distance is the covering radius of the samples so
  // far, which decides whether it becomes a sample. A sample is written when its propagation is complete.
  template <typename Shape, typename OutputIterator, typename Options, typename Visitor>
  double run(Shape shape, std::size_t n, OutputIterator output, const Options& options, Visitor& visitor)
  {
    check_radius(options);
    m_surface.read(std::move(shape));
    Distance_propagation<double> propagation(m_surface.mesh(), m_field);
    return sample(propagation, n, output, options, visitor);
  }

  // The same beside curves: a curve, or a range of curves. They become edges of the mesh, from which strips start;
  // samples are sources that are added when all strips have ended. Throws for a curve that is not on the mesh, too.
  template <typename Shape, typename Curves, typename OutputIterator, typename Options, typename Visitor>
  double run_beside_curves(Shape shape, const Curves& curves, std::size_t n, OutputIterator output,
                           const Options& options, Visitor& visitor)
  {
    check_radius(options);
    m_surface.read(std::move(shape));
    Source_insertion<double> insertion(m_surface.mesh());
    const Source_curves<double> inserted
      = Curve_insertion<double>(m_surface.mesh(), insertion).insert(m_surface.located_curves(curves, {}));
    Distance_propagation<double, All_pruning_rules, No_window_keeper, Strip_front<double>> propagation(
      m_surface.mesh(), m_field);
    propagation.add_curves(inserted);
    return sample(propagation, n, output, options, visitor, !inserted.vertices.empty());
  }

private:
  template <typename Options>
  static void check_radius(const Options& options)
  {
    if(!(options.covering_radius >= 0))
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_RADIUS,
                                   "the covering radius is negative or not a number");
  }

  // Adds samples to a propagation, in which nothing has run. `has_sources` tells whether it has any sources, as curves
  // are: then distances from these decide about the first sample. See run().
  //
  // A run that has ended may go on with new sources, also one with strips: none of them waits any more, and windows of
  // a new sample are compared with the distances of vertices, which strips and windows have found alike.
  template <typename Propagation, typename OutputIterator, typename Options, typename Visitor>
  double sample(Propagation& propagation, std::size_t n, OutputIterator output, const Options& options,
                Visitor& visitor, bool has_sources = false)
  {
    std::size_t number = options.first_samples.size();
    bool is_complete = add_first_samples(propagation, options.first_samples, visitor, has_sources);
    // From here on distances only shrink, as the queue requires.
    const auto distance_of = [this](Vertex_id v) { return least_distance(v); };
    Farthest_vertex_queue<decltype(distance_of)> queue(distance_of, ranks(), number_of_candidates());
    const double unit = m_surface.unit();
    double radius = std::numeric_limits<double>::infinity();
    while(is_complete)
    {
      const Vertex_id v = queue.farthest();
      radius = v == null_id ? 0. : unit * least_distance(v);
      if(number >= n || v == null_id || radius <= options.covering_radius)
        break;
      m_surface.for_each_copy(v, [&](Vertex_id c) { propagation.add_source(c, 0); });
      is_complete = propagate(propagation, visitor);
      if(is_complete)
        if constexpr(Is_output_iterator<OutputIterator, vertex_descriptor>::value)
          *output++ = m_surface.descriptor(v);
      ++number;
    }
    if(options.statistics != nullptr)
    {
      Propagation_statistics statistics = propagation.statistics();
      statistics.intrinsic_mesh_bytes += m_surface.memory() + m_field.memory();
      options.statistics->add(statistics);
    }
    return radius;
  }

  // A sample on a wall is on all of its sides, and each of them is as far as the nearest one. When a sample comes near
  // to one side, the distance of the others shrinks, too: the queue sees that when it asks for them. Without walls
  // there is one copy, and nothing to compare.
  //
  // The distance of the vertex of the user of which v is a copy, in the unit of the mesh.
  double least_distance(Vertex_id v) const
  {
    const auto distance_of = [this](Vertex_id c) { return m_field.distance[c]; };
    return distance_of(m_surface.copies().nearest(v, distance_of));
  }

  // Makes sources of the samples that the user gives, and propagates from all sources at once. Returns false if the
  // visitor cancels. A vertex that is named twice counts twice among the n samples.
  template <typename Propagation, typename Visitor>
  bool add_first_samples(Propagation& propagation, const std::vector<vertex_descriptor>& samples, Visitor& visitor,
                         bool has_sources)
  {
    for(const Vertex_id v : m_surface.source_set_of_vertices(samples, "sample").vertices)
      propagation.add_source(v, 0);
    return (samples.empty() && !has_sources) || propagate(propagation, visitor);
  }

  // Continues the propagation with the sources that are new. Returns false if the visitor cancels. The distances that
  // the visitor gets begin at 0 each time.
  template <typename Propagation, typename Visitor>
  bool propagate(Propagation& propagation, Visitor& visitor) const
  {
    return run_with_visitor(visitor, m_surface.number_of_vertices(), [&](auto go_on)
    {
      return propagation.run([&](std::size_t number_of_visits, double distance)
      { return go_on(number_of_visits, m_surface.unit() * distance); });
    });
  }

  // Returns the positions of the vertices in the range of the user: of vertices that are equally far, the first one in
  // that range becomes a sample.
  const std::vector<Vertex_id>& ranks()
  {
    m_rank.resize(m_surface.number_of_vertices());
    Vertex_id position = 0;
    for(const vertex_descriptor v : vertices(m_tm))
    {
      m_surface.for_each_copy(m_surface.id(v), [&](Vertex_id c) { m_rank[c] = position; });
      ++position;
    }
    return m_rank;
  }

  // Vertices without faces are not candidates; they have the last numbers.
  std::size_t number_of_candidates() const
  {
    std::size_t n = m_surface.number_of_vertices();
    while(n > 0 && m_surface.mesh().halfedge(static_cast<Vertex_id>(n - 1)) == null_id)
      --n;
    return n;
  }

  const TriangleMesh& m_tm;
  Surface m_surface;
  Vertex_distance_field<double> m_field;
  std::vector<Vertex_id> m_rank;
};

// Samples a mesh with the maps and the visitor among the named parameters. See run() above. The types of the parameters
// tell whether there are curves: programs without them do not compile what strips need.
template <typename TriangleMesh, typename OutputIterator, typename Options, typename NamedParameters>
double sample_farthest_points(const TriangleMesh& tm, std::size_t n, OutputIterator output, const Options& options,
                              const NamedParameters& np)
{
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  Visitor_parameter<NamedParameters> visitor_parameter(np);
  auto& visitor = visitor_parameter.visitor();
  Farthest_point_sampling<TriangleMesh, decltype(vim), decltype(fim)> sampling(tm, vim, fim);
  sampling.avoid(obstacles(tm, fim, np));
  if constexpr(Has_parameter<NamedParameters, internal_np::first_curves_t>::value)
    return sampling.run_beside_curves(shape_from_points<double>(tm, np), curves_parameter(np), n, output, options,
                                      visitor);
  else
    return sampling.run(shape_from_points<double>(tm, np), n, output, options, visitor);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_FARTHEST_POINT_SAMPLING_H
