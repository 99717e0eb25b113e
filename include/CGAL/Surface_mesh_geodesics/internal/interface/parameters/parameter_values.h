// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_PARAMETER_VALUES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_PARAMETER_VALUES_H

// The values of the named parameters of this package, as the rooms below need them: numbers and vectors of numbers or
// descriptors, whatever types of ranges the user has. Values are not judged here; check_numbers() and the solvers do
// that, and throw Invalid_geodesic_input.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/Parameter_sequence.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The nearest sources are not requested. write_nearest_sources() does nothing for it.
struct No_nearest_source_map
{};

// The parameters of a computation of distances, with the defaults that users know; geodesic_distances() documents them.
// Numbers are in the user's unit. The map is a handle that is copied, and the statistics are not owned.
template <typename TriangleMesh, typename NearestSourceMap = No_nearest_source_map>
struct Distance_options
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  double maximum_distance = std::numeric_limits<double>::infinity();
  std::vector<vertex_descriptor> targets; // empty: all vertices
  std::vector<double> source_offsets; // empty: all are 0
  NearestSourceMap nearest_source_map = NearestSourceMap();
  Propagation_statistics* statistics = nullptr;
};

// The parameters of a farthest point sampling; geodesic_farthest_point_sampling() documents them.
template <typename TriangleMesh>
struct Sampling_options
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  std::vector<vertex_descriptor> first_samples;
  double covering_radius = 0;
  Propagation_statistics* statistics = nullptr;
};

// Each function below returns the value of a parameter, or the default. Takes time linear in the length of a range.

// True if a value of type U means the same as a T. Fractions are no numbers of rows, texts and numbers no switches,
// although they convert.
template <typename U, typename T>
constexpr bool is_value_of
  = std::is_convertible<U, T>::value
    && (!std::is_integral<T>::value
        || (std::is_integral<U>::value && std::is_same<U, bool>::value == std::is_same<T, bool>::value));

// Does a type hold the numbers of all sources, or sites? A floating point type would take them as well, but the number
// for no source would be lost in it. Bytes would hold the numbers of 256 sources, and nobody would notice the others.
template <typename Number>
constexpr bool holds_numbers_of_sources = std::is_integral<Number>::value && sizeof(Number) >= 4;

// The value of a parameter that means a T without a cast, or the default value. Requires: a value for an unsigned type
// is not negative.
template <typename T, typename Tag, typename NamedParameters>
T value_parameter(const NamedParameters& np, Tag tag, const T& default_value)
{
  if constexpr(Has_parameter<NamedParameters, Tag>::value)
  {
    const auto& value = parameters::get_parameter_reference(np, tag);
    using Value = std::remove_const_t<std::remove_reference_t<decltype(value)>>;
    static_assert(is_value_of<Value, T>,
                  "the value of the named parameter 'Tag' does not convert to the documented type");
    if constexpr(std::is_unsigned<T>::value && std::is_signed<Value>::value)
      CGAL_precondition_msg(value >= 0, "the value of a named parameter is negative");
    return static_cast<T>(value);
  }
  else
    return default_value;
}

// Any type of number that converts to double without a cast: float, int, and the numbers of kernels of double.
template <typename Tag, typename NamedParameters>
double number_parameter(const NamedParameters& np, Tag tag, double default_value)
{
  if constexpr(Has_parameter<NamedParameters, Tag>::value)
    static_assert(std::is_convertible<decltype(parameters::get_parameter_reference(np, tag)), double>::value,
                  "the value of the named parameter 'Tag' does not convert to double");
  return value_parameter<double>(np, tag, default_value);
}

// Any range: a container, an array, a pair of iterators of CGAL, also in std::ref() or std::cref(). It is read once.
// The elements are copied, as the rooms below need them one after the other, and vectors of descriptors are short.
template <typename Element, typename Tag, typename NamedParameters>
std::vector<Element> range_parameter(const NamedParameters& np, Tag tag)
{
  std::vector<Element> elements;
  if constexpr(Has_parameter<NamedParameters, Tag>::value)
  {
    const auto& range = parameters::get_parameter_reference(np, tag);
    constexpr bool is_range
      = Is_range_of<std::remove_const_t<std::remove_reference_t<decltype(range)>>, Element>::value;
    static_assert(is_range, "the value of the named parameter 'Tag' is not a range of the documented elements");
    // Without the question, the errors of the loop would follow the message, and a user reads the last error of a long
    // list first.
    if constexpr(is_range)
      for(const auto& element : range)
        elements.push_back(static_cast<Element>(element));
  }
  return elements;
}

// A pointer, as CGAL copies what is passed by value: counts in a copy would be lost. Null means that nobody counts, so
// that a caller can decide at run time.
template <typename NamedParameters>
Propagation_statistics* statistics_parameter(const NamedParameters& np)
{
  if constexpr(Has_parameter<NamedParameters, internal_np::statistics_t>::value)
  {
    const auto& value = parameters::get_parameter_reference(np, internal_np::statistics);
    static_assert(std::is_convertible<decltype(value), Propagation_statistics*>::value,
                  "the named parameter statistics takes a pointer: statistics(&counts)");
    return value;
  }
  else
    return nullptr;
}

// A map to write to, which is copied, or Default. Value is what is written. A map in std::ref() is rejected: put() does
// not look through it.
template <typename Key, typename Value, typename Default, typename Tag, typename NamedParameters>
auto map_parameter(const NamedParameters& np, Tag tag)
{
  if constexpr(Has_parameter<NamedParameters, Tag>::value)
  {
    auto map = parameters::get_parameter(np, tag);
    static_assert(Is_map_for<decltype(map), Key, Value>::value,
                  "the value of the named parameter 'Tag' is not a property map of vertices with the documented "
                  "type of values, passed by value");
    return map;
  }
  else
    return Default();
}

// The parameters of a computation of distances for a mesh. No map of nearest sources is read if there is none.
template <typename TriangleMesh, typename NamedParameters>
auto distance_options(const NamedParameters& np)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  auto map
    = map_parameter<vertex_descriptor, std::size_t, No_nearest_source_map>(np, internal_np::nearest_source_map);
  if constexpr(Has_parameter<NamedParameters, internal_np::nearest_source_map_t>::value)
  {
    using Value = typename boost::property_traits<decltype(map)>::value_type;
    static_assert(holds_numbers_of_sources<Value>,
                  "the values of the named parameter nearest_source_map are not integers of at least 32 bits");
  }
  Distance_options<TriangleMesh, decltype(map)> options{
    number_parameter(np, internal_np::maximum_distance, std::numeric_limits<double>::infinity()),
    range_parameter<vertex_descriptor>(np, internal_np::targets),
    range_parameter<double>(np, internal_np::source_offsets), map, statistics_parameter(np)};
  return options;
}

template <typename TriangleMesh, typename NamedParameters>
Sampling_options<TriangleMesh> sampling_options(const NamedParameters& np)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  return {range_parameter<vertex_descriptor>(np, internal_np::first_samples),
          number_parameter(np, internal_np::covering_radius, 0.), statistics_parameter(np)};
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_PARAMETER_VALUES_H
