// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_RUN_WITH_VISITOR_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_RUN_WITH_VISITOR_H

// The order in which the functions of a visitor are called (concept GeodesicPropagationVisitor), and how an object
// notices that a visitor calls it back.

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <atomic>
#include <cstddef>
#include <thread>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// True for a model of GeodesicPropagationVisitor. Only the calls that run_with_visitor() makes are looked at: functions
// with default arguments, or templates, will do.
template <typename Visitor, typename = void>
struct Is_visitor
  : std::false_type
{};

template <typename Visitor>
struct Is_visitor<Visitor, std::void_t<decltype(std::declval<Visitor&>().on_propagation_begin(std::size_t())),
                                       decltype(std::declval<Visitor&>().on_progress(std::size_t(), 0.)),
                                       decltype(bool(std::declval<Visitor&>().go_further())),
                                       decltype(std::declval<Visitor&>().on_propagation_end())>>
  : std::true_type
{};

// The visitor among named parameters: the object of the user if it was passed with std::ref(), a copy of it if not, and
// one that does nothing if there is none.
//
// CGAL returns a reference to what was passed with std::ref(), and a value or a reference to a constant object for
// anything else. (choose_parameter() would return a reference to that value, which ends with the expression.)
template <typename NamedParameters>
class Visitor_parameter
{
  static decltype(auto) found(const NamedParameters& np)
  {
    return parameters::get_parameter_reference(np, internal_np::visitor);
  }

  using Found = decltype(found(std::declval<const NamedParameters&>()));
  using Value = std::remove_cv_t<std::remove_reference_t<Found>>;
  static constexpr bool is_default = std::is_same<Value, CGAL::internal_np::Param_not_found>::value;
  static constexpr bool is_referred_to
    = std::is_lvalue_reference<Found>::value && !std::is_const<std::remove_reference_t<Found>>::value;
  // The first message of the compiler says what is wrong; those about members follow. (CGAL's own parameter `visitor`
  // takes anything, so nothing has checked it before.)
  static_assert(is_default || Is_visitor<Value>::value,
                "the value of the named parameter visitor is not a model of GeodesicPropagationVisitor");
  static_assert(is_default || is_referred_to || std::is_copy_constructible<Value>::value,
                "a visitor that cannot be copied is passed with std::ref()");
  using Copy_or_reference = std::conditional_t<is_referred_to, Found, Value>;
  using Visitor = std::conditional_t<is_default, Geodesic_default_visitor, Copy_or_reference>;

  // A default visitor is made of nothing.
  static Visitor chosen(const NamedParameters& np)
  {
    if constexpr(is_default)
    {
      static_cast<void>(np);
      return Visitor();
    }
    else
      return found(np);
  }

public:
  explicit Visitor_parameter(const NamedParameters& np) : m_visitor(chosen(np)) {}

  Visitor_parameter(const Visitor_parameter&) = delete;
  Visitor_parameter& operator=(const Visitor_parameter&) = delete;

  auto& visitor() { return m_visitor; }

private:
  Visitor m_visitor;
};

// Calls run(go_on), a propagation, between the first and the last function of the visitor, and returns its result. The
// propagation calls go_on(number of visits, distance in the user's unit) at each visit of a vertex, and ends with false
// as soon as that returns false. With several threads it calls go_on less often, always in this thread.
//
// The last function is also called after a cancellation, but not if an exception of the visitor or of the propagation
// passes through. The visitor is referred to, since not every visitor can be copied.
template <typename Visitor, typename Run>
bool run_with_visitor(Visitor& visitor, std::size_t number_of_vertices, Run run)
{
  // A visitor among the named parameters has been checked before; those of classes are arguments, and come here first.
  // One message is enough, so the calls are left out then.
  static_assert(Is_visitor<Visitor>::value, "the visitor is not a model of GeodesicPropagationVisitor");
  if constexpr(!Is_visitor<Visitor>::value)
    return false;
  else
  {
    visitor.on_propagation_begin(number_of_vertices);
    const bool is_complete = run([&visitor](std::size_t number_of_visits, double distance)
    {
      visitor.on_progress(number_of_visits, distance);
      return visitor.go_further();
    });
    visitor.on_propagation_end();
    return is_complete;
  }
}

// A go_on() of any type, as above: one type for all visitors, so that the text of the propagation is compiled once for
// all of them. The indirect call costs nothing beside the visit of a vertex.
// The propagation tells distances in the unit of its mesh; they are multiplied by `factor` for the visitor.
// Copies refer to the same object, which must outlive them. What its call throws passes through.
class Go_on_reference
{
public:
  template <typename GoOn>
  Go_on_reference(GoOn& go_on, double factor) : m_go_on(&go_on), m_call(call<GoOn>), m_factor(factor)
  {}

  bool operator()(std::size_t number_of_visits, double distance) const
  {
    return m_call(m_go_on, number_of_visits, m_factor * distance);
  }

private:
  template <typename GoOn>
  static bool call(void* go_on, std::size_t number_of_visits, double distance)
  {
    return (*static_cast<GoOn*>(go_on))(number_of_visits, distance);
  }

  void* m_go_on;
  bool (*m_call)(void*, std::size_t, double);
  double m_factor;
};

// True for a visitor that follows the iterations of a relaxation (concept GeodesicRelaxationVisitor). The default
// visitor does not, and a user's visitor that derives from it need not: the energies, which take time, are computed
// only for a visitor that has the function.
template <typename Visitor, typename = void>
struct Follows_iterations
  : std::false_type
{};

template <typename Visitor>
struct Follows_iterations<Visitor, std::void_t<decltype(std::declval<Visitor&>().on_iteration(std::size_t(), 0., 0.))>>
  : std::true_type
{};

// The visitor of a function that propagates several times. Once the user's visitor has canceled, go_further() returns
// false without asking it again. A run that starts nevertheless ends at its first visit.
template <typename Visitor>
class Visitor_of_several_runs
{
public:
  explicit Visitor_of_several_runs(Visitor& visitor) : m_visitor(visitor) {}

  void on_propagation_begin(std::size_t number_of_vertices) { m_visitor.on_propagation_begin(number_of_vertices); }
  void on_progress(std::size_t number_of_visits, double distance) { m_visitor.on_progress(number_of_visits, distance); }
  void on_propagation_end() { m_visitor.on_propagation_end(); }

  // It has this function if the visitor of the user has it.
  template <typename V = Visitor>
  std::enable_if_t<Follows_iterations<V>::value> on_iteration(std::size_t i, double largest_move, double energy)
  {
    m_visitor.on_iteration(i, largest_move, energy);
  }

  bool go_further()
  {
    m_is_canceled = m_is_canceled || !m_visitor.go_further();
    return !m_is_canceled;
  }

  bool is_canceled() const { return m_is_canceled; }

private:
  Visitor& m_visitor;
  bool m_is_canceled = false;
};

// The thread that computes the results of an object. Its visitor must not call the object: a second computation would
// run inside the first one, or wait for it forever. Other threads may call it, and wait.
// The owner has to make sure that only one thread at a time has a Scope: by a mutex, or because the object is not
// shared. is_this() may be called by any thread at any time, hence the atomic number. It is true only inside a Scope of
// the same thread, so a thread that gets another answer may safely wait for the mutex.
class Computing_thread
{
public:
  // While it lives, the thread that made it is the one that computes.
  class Scope
  {
  public:
    explicit Scope(Computing_thread& thread) : m_thread(thread) { m_thread.m_id = std::this_thread::get_id(); }
    ~Scope() { m_thread.m_id = std::thread::id(); }

    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    Computing_thread& m_thread;
  };

  bool is_this() const { return m_id.load() == std::this_thread::get_id(); }

private:
  std::atomic<std::thread::id> m_id{std::thread::id()};
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_RUN_WITH_VISITOR_H
