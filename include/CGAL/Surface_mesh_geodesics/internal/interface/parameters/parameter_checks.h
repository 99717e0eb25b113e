// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_PARAMETER_CHECKS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_PARAMETER_CHECKS_H

// What a public function rejects at compile time: a named parameter that it does not take, which would have no effect,
// and a map of other elements. Other arguments are checked in argument_checks.h. Nothing here remains at run time.

#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/Parameter_sequence.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// --- which parameters a function takes: the tags tell, whatever the values are ---

// The tags of the parameters that a function takes.
template <typename... Tags>
struct Parameter_set
{};

// Fails to compile if Tag is not in the set. The compiler prints the name of the tag, which is that of the parameter.
template <typename Tag, typename Set>
struct Named_parameter;

template <typename Tag, typename... Tags>
constexpr bool is_one_of = (std::is_same<Tag, Tags>::value || ...);

template <typename Tag, typename... Tags>
struct Named_parameter<Tag, Parameter_set<Tags...>>
{
  static_assert(is_one_of<Tag, Tags..., Sequence_end_tag, CGAL::internal_np::all_default_t>,
                "this function does not take the named parameter 'Tag'; its reference page lists those it takes");
  static constexpr bool value = true;
};

// Visits all parameters of a sequence: this is the data class of CGAL, in which each link is nested in the next one.
template <typename Impl, typename Set>
struct Named_parameters;

template <typename T, typename Tag, typename Set>
struct Named_parameters<CGAL::internal_np::Named_params_impl<T, Tag, CGAL::internal_np::No_property>, Set>
  : std::integral_constant<bool, Named_parameter<Tag, Set>::value>
{};

template <typename T, typename Tag, typename Base, typename Set>
struct Named_parameters<CGAL::internal_np::Named_params_impl<T, Tag, Base>, Set>
  : std::integral_constant<bool, Named_parameter<Tag, Set>::value
                                   && Named_parameters<typename Base::base, Set>::value>
{};

// Does not compile if a parameter among `np` is not in the set. Public functions call it first, before something else
// in them fails to compile. Functions that call each other inside the package pass what they like. (The type `auto` is
// not idle: the compiler has to read the body at once, before the rest of the caller.)
template <typename Set, typename NamedParameters>
auto check_parameters(const NamedParameters&)
{
  static_assert(Named_parameters<typename NamedParameters::base, Set>::value, "always true, if it compiles");
}

// One call for both kinds of checks, so that no function forgets one of them.
//
// The same for a function that reads a mesh: the mesh is checked, and its maps among `np`, too. Functions that write a
// mesh, and solvers, which got their maps from a constructor, call the other overload.
template <typename Set, typename TriangleMesh, typename NamedParameters>
auto check_parameters(const TriangleMesh&, const NamedParameters& np)
{
  static_assert(Checked_mesh<TriangleMesh>::value, "always true, if it compiles");
  check_parameters<Set>(np);
  check_maps<TriangleMesh>(np);
}

// The same for a function that reads single faces only, of a model of FaceGraph: it may not know its number of faces.
template <typename Set, typename TriangleMesh, typename NamedParameters>
auto check_parameters_of_face_graph(const TriangleMesh&, const NamedParameters& np)
{
  check_parameters<Set>(np);
  check_maps<TriangleMesh>(np);
}

// Two sets in one. The sets below say once what the reference pages of the functions list; a test compiles a call with
// each parameter, and calls with some that are not taken.
template <typename Set, typename... Tags>
struct Extended_set;

template <typename... First, typename... Tags>
struct Extended_set<Parameter_set<First...>, Tags...>
{
  using type = Parameter_set<First..., Tags...>;
};

// Callers may pass what they pass to other functions of CGAL for the same mesh: few functions read an index map of
// halfedges, and none reads a kernel.
//
// CGAL itself ignores parameters that a function does not know. Here they are faults: most of them are mistakes of the
// caller, such as a radius for a function that has none, whose results would be wrong without a word.
using Index_map_parameters = Parameter_set<internal_np::vertex_index_t, internal_np::halfedge_index_t,
                                           internal_np::face_index_t, internal_np::geom_traits_t>;
using Mesh_parameters = Extended_set<Index_map_parameters, internal_np::vertex_point_t>::type;
// What a surface consists of: its maps and its obstacles.
using Edge_length_surface_parameters = Extended_set<Index_map_parameters, internal_np::faces_to_avoid_t,
                                                    internal_np::edges_to_avoid_t>::type;
using Surface_parameters = Extended_set<Edge_length_surface_parameters, internal_np::vertex_point_t>::type;
using Output_mesh_parameters = Parameter_set<internal_np::vertex_point_t>;
using Mesh_and_visitor_parameters = Extended_set<Mesh_parameters, internal_np::visitor_t>::type;

// The parameters of a computation of distances, whatever the shape of the surface comes from. A solver has its maps
// from its constructor, and finds nearest sources by itself.
using Solver_parameters
  = Parameter_set<internal_np::visitor_t, internal_np::maximum_distance_t, internal_np::targets_t,
                  internal_np::source_offsets_t, internal_np::statistics_t>;
using Edge_length_distance_parameters
  = Extended_set<Index_map_parameters, internal_np::visitor_t, internal_np::maximum_distance_t, internal_np::targets_t,
                 internal_np::source_offsets_t, internal_np::statistics_t, internal_np::nearest_source_map_t,
                 internal_np::faces_to_avoid_t, internal_np::edges_to_avoid_t>::type;
using Signed_distance_parameters
  = Extended_set<Mesh_and_visitor_parameters, internal_np::maximum_distance_t, internal_np::statistics_t,
                 internal_np::faces_to_avoid_t, internal_np::edges_to_avoid_t>::type;
using Isoline_parameters
  = Extended_set<Signed_distance_parameters, internal_np::source_offsets_t, internal_np::vertex_distance_map_t,
                 internal_np::nearest_source_map_t>::type;
using Border_parameters = Extended_set<Mesh_parameters, internal_np::faces_to_avoid_t>::type;
using Matrix_parameters = Surface_parameters;
using Edge_length_tracing_parameters = Edge_length_surface_parameters;
using Tracing_parameters = Surface_parameters;
using Peeling_parameters = Extended_set<Matrix_parameters, internal_np::visitor_t>::type;
using Pair_parameters = Extended_set<Matrix_parameters, internal_np::statistics_t>::type;
using Store_parameters
  = Extended_set<Mesh_and_visitor_parameters, internal_np::maximum_distance_t, internal_np::use_float32_t,
                 internal_np::use_symmetry_t, internal_np::rows_per_shard_t, internal_np::first_row_t,
                 internal_np::end_row_t, internal_np::memory_limit_t, internal_np::mesh_name_t,
                 internal_np::compare_checksums_t, internal_np::faces_to_avoid_t,
                 internal_np::edges_to_avoid_t>::type;
using Distance_parameters = Extended_set<Edge_length_distance_parameters, internal_np::vertex_point_t>::type;

using Edge_length_certificate_parameters
  = Extended_set<Index_map_parameters, internal_np::visitor_t, internal_np::number_of_iterations_t,
                 internal_np::maximum_distance_t, internal_np::source_offsets_t, internal_np::faces_to_avoid_t,
                 internal_np::edges_to_avoid_t>::type;
using Distance_certificate_parameters
  = Extended_set<Edge_length_certificate_parameters, internal_np::vertex_point_t>::type;

using Label_parameters = Extended_set<Mesh_and_visitor_parameters, internal_np::vertex_distance_map_t,
                                      internal_np::site_weights_t, internal_np::statistics_t,
                                      internal_np::faces_to_avoid_t, internal_np::edges_to_avoid_t>::type;
using Sampling_parameters = Extended_set<Mesh_and_visitor_parameters, internal_np::first_samples_t,
                                         internal_np::covering_radius_t, internal_np::statistics_t,
                                         internal_np::faces_to_avoid_t, internal_np::edges_to_avoid_t,
                                         internal_np::first_curves_t>::type;
using Relaxation_parameters = Extended_set<Mesh_and_visitor_parameters, internal_np::threshold_distance_t,
                                           internal_np::number_of_iterations_t, internal_np::faces_to_avoid_t,
                                           internal_np::edges_to_avoid_t, internal_np::first_curves_t>::type;
using Remeshing_parameters = Extended_set<Mesh_and_visitor_parameters, internal_np::threshold_distance_t,
                                          internal_np::number_of_iterations_t, internal_np::faces_to_avoid_t>::type;

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_PARAMETER_CHECKS_H
