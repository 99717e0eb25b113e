// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_PARAMETER_SEQUENCE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_PARAMETER_SEQUENCE_H

// Sequences of named parameters that mix those of this package with those of CGAL:
// parameters::maximum_distance(r).vertex_point_map(m).targets(range).
//
// Each link of a sequence is a call of a member function, and nobody can add a member to CGAL's class from outside. So
// a sequence has to start with a parameter of this package, which makes a specialization of CGAL's class that has
// members for all parameters of the package and of CGAL. The specialization is for a tag of this package. (One for
// CGAL's tags would serve sequences that start with a parameter of CGAL, too. But two units of a program, one with this
// header and one without, would then define one class in two ways.)
//
// The example above has this type, from the last link to the first one:
//
//   Named_function_parameters<Sequence_end, Sequence_end_tag,   the specialization below, with the member functions
//     Parameter_link<Range, targets_t,                          the data of CGAL, nested as CGAL nests them
//       Parameter_link<Map, vertex_point_t,
//         Parameter_link<double, maximum_distance_t>>>>
//
// CGAL's functions deduce the three arguments of Named_function_parameters and read the data, whatever the members are.
// A new link goes behind the others, and the end moves behind it. Sequences of CGAL repeat the class in each link.
//
// When the list is a part of CGAL's, this file is not needed any more.

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {

// The tags of the package, and through the directive those of CGAL: internal_np::targets and internal_np::vertex_point
// are both found here. A tag that is declared here hides one of the same name in CGAL.
namespace internal_np {

using namespace CGAL::internal_np;

#define CGAL_add_named_parameter(X, Y, Z) enum X { Y };
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/geodesic_parameters_interface.h>
#undef CGAL_add_named_parameter

// The tag of maximum_distance is that of CGAL if CGAL's sequences have this parameter, and otherwise one of the
// package. Asking the class instead of the version needs no list of versions.
enum own_maximum_distance_t { own_maximum_distance };

// The tag of the parameter that was added last to a sequence of CGAL.
template <typename NamedParameters>
struct Tag_of_parameters;

template <typename T, typename Tag, typename Base>
struct Tag_of_parameters<Named_function_parameters<T, Tag, Base>>
{
  using type = Tag;
};

// The class is a template parameter so that asking for a member that is not there is no error.
template <typename NamedParameters, typename = void>
struct Maximum_distance_tag
{
  using type = own_maximum_distance_t;
};

template <typename NamedParameters>
struct Maximum_distance_tag<NamedParameters,
                            std::void_t<decltype(std::declval<const NamedParameters&>().maximum_distance(0.))>>
  : Tag_of_parameters<decltype(std::declval<const NamedParameters&>().maximum_distance(0.))>
{};

using maximum_distance_t = Maximum_distance_tag<CGAL::parameters::Default_named_parameters>::type;
constexpr maximum_distance_t maximum_distance = static_cast<maximum_distance_t>(0);

} // namespace internal_np

namespace internal {

// A parameter of a sequence, and those before it: CGAL's data without CGAL's member functions.
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Parameter_link
  : CGAL::internal_np::Named_params_impl<T, Tag, Base>
{
  using base = CGAL::internal_np::Named_params_impl<T, Tag, Base>;

  explicit Parameter_link(const T& value) : base(value) {}
  Parameter_link(const T& value, const Base& before) : base(value, before) {}
};

// The last parameter of each sequence. It has no value, and no function asks for it: it selects the specialization.
struct Sequence_end
{};
enum Sequence_end_tag { sequence_end };

template <typename Link>
using Sequence_data = CGAL::internal_np::Named_params_impl<Sequence_end, Sequence_end_tag, Link>;

template <typename Link>
using Parameter_sequence = Named_function_parameters<Sequence_end, Sequence_end_tag, Link>;

// The members of CGAL's sequences: a sequence that starts with a parameter of this package goes on with any of CGAL,
// also for functions of CGAL. `Self` is the class that has them; its own members come first where a name is in both
// lists.
template <typename Self>
struct Members_of_CGAL
{
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  auto Z(const K& value) const                                                                                         \
  {                                                                                                                    \
    return static_cast<const Self&>(*this).template append<CGAL::internal_np::X>(value);                               \
  }
// Newer versions have packages whose parameters are objects, not functions; a sequence for them starts with one of
// those.
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z)
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
#undef CGAL_add_extra_named_parameter_with_compatibility
};

} // namespace internal
} // namespace Surface_mesh_geodesics

// A sequence with the parameters in Link, to which functions of CGAL can be applied as well. Values are copied, as CGAL
// copies them; values that cannot be copied, and those in std::ref() or std::cref(), are referred to.
template <typename Link>
struct Named_function_parameters<Surface_mesh_geodesics::internal::Sequence_end,
                                 Surface_mesh_geodesics::internal::Sequence_end_tag, Link>
  : Surface_mesh_geodesics::internal::Sequence_data<Link>,
    Surface_mesh_geodesics::internal::Members_of_CGAL<
      Named_function_parameters<Surface_mesh_geodesics::internal::Sequence_end,
                                Surface_mesh_geodesics::internal::Sequence_end_tag, Link>>
{
  // The names that CGAL's functions expect.
  using base = Surface_mesh_geodesics::internal::Sequence_data<Link>;
  using self = Named_function_parameters;
  using CGAL_Named_function_parameters_class = int;

  explicit Named_function_parameters(const Link& link) : base(Surface_mesh_geodesics::internal::Sequence_end(), link) {}

#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  auto Z(const K& value) const                                                                                         \
  {                                                                                                                    \
    return append<Surface_mesh_geodesics::internal_np::X>(value);                                                      \
  }
#define CGAL_add_named_parameter_of_newer_CGAL CGAL_add_named_parameter
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/geodesic_parameters_interface.h>
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_of_newer_CGAL

  // Appends other sequences, which may come from CGAL: this is how a function that receives parameters of CGAL adds
  // some of this package. CGAL 6 has the same member for sequences of one parameter.
  template <typename T, typename Tag, typename Base, typename... Others>
  auto combine(const Named_function_parameters<T, Tag, Base>& other, const Others&... others) const
  {
    const auto combined = append_all(static_cast<const internal_np::Named_params_impl<T, Tag, Base>&>(other));
    if constexpr(sizeof...(others) == 0)
      return combined;
    else
      return combined.combine(others...);
  }

private:
  template <typename, typename, typename>
  friend struct Named_function_parameters;
  friend struct Surface_mesh_geodesics::internal::Members_of_CGAL<Named_function_parameters>;

  // Appends one parameter: a link behind the last one, and the end behind that. Copies the values that are there; the
  // compiler removes the copies of small ones, and users pass large ranges with std::cref().
  template <typename Tag, typename K>
  auto append(const K& value) const
  {
    using Longer = Surface_mesh_geodesics::internal::Parameter_link<K, Tag, Link>;
    return Surface_mesh_geodesics::internal::Parameter_sequence<Longer>(Longer(value, *this));
  }

  // Appends the parameters of a sequence, the first one first. The end of the other sequence, and the parameter that
  // stands for default values, are left out. If a parameter is there already, the value that comes later is found first
  // and counts, as in sequences of CGAL.
  template <typename T, typename Tag, typename Base>
  auto append_all(const internal_np::Named_params_impl<T, Tag, Base>& other) const
  {
    if constexpr(std::is_same<Tag, internal_np::all_default_t>::value)
      return *this;
    else if constexpr(std::is_same<Base, internal_np::No_property>::value)
      return append<Tag>(other.v);
    else if constexpr(std::is_same<Tag, Surface_mesh_geodesics::internal::Sequence_end_tag>::value)
      return append_all(static_cast<const typename Base::base&>(other));
    else
      return append_all(static_cast<const typename Base::base&>(other)).template append<Tag>(other.v);
  }
};

namespace Surface_mesh_geodesics {
namespace internal {

template <typename Tag, typename K>
Parameter_sequence<Parameter_link<K, Tag>> new_sequence(const K& value)
{
  return Parameter_sequence<Parameter_link<K, Tag>>(Parameter_link<K, Tag>(value));
}

} // namespace internal
} // namespace Surface_mesh_geodesics

namespace parameters {

// The functions with which a sequence starts.
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  auto Z(const K& value)                                                                                               \
  {                                                                                                                    \
    return Surface_mesh_geodesics::internal::new_sequence<Surface_mesh_geodesics::internal_np::X>(value);              \
  }
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/geodesic_parameters_interface.h>
#undef CGAL_add_named_parameter

// A radius is an arithmetic number; others are converted by the caller.
//
// These are functions, not templates: where CGAL has a template of the same name, overload resolution prefers them for
// each of these types. The tag is that of CGAL then, so the functions of CGAL take the result as well, and so they do
// with further parameters behind it.
#define CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(Number)                                                           \
  inline auto maximum_distance(const Number& value)                                                                    \
  {                                                                                                                    \
    using Tag = Surface_mesh_geodesics::internal_np::maximum_distance_t;                                               \
    return Surface_mesh_geodesics::internal::new_sequence<Tag>(value);                                                 \
  }
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(double)
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(float)
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(long double)
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(short)
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(unsigned short)
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(int)
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(unsigned int)
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(long)
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(unsigned long)
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(long long)
CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE(unsigned long long)
#undef CGAL_SURFACE_MESH_GEODESICS_MAXIMUM_DISTANCE

// A number in std::ref() or std::cref(). The overload is more special than a template of CGAL.
template <typename Number>
auto maximum_distance(const std::reference_wrapper<Number>& value)
{
  using Tag = Surface_mesh_geodesics::internal_np::maximum_distance_t;
  return Surface_mesh_geodesics::internal::new_sequence<Tag>(value);
}

} // namespace parameters
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_PARAMETER_SEQUENCE_H
