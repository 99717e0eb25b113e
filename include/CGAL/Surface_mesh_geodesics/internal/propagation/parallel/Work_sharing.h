// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WORK_SHARING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WORK_SHARING_H

// Units of work that any thread of a team may do, phase by phase. One thread, the conductor, publishes the units of a
// phase, does units itself, and goes on as soon as all are done. The other threads do units as they find them.
//
// There is no barrier: the conductor waits for units that another thread has begun, never for a thread that is late or
// asleep. So a team may have more threads than the machine, and a phase of a few microseconds is worth sharing.

#include <CGAL/assertions.h>

#include <atomic>
#include <cstdint>
#include <exception>
#include <thread>

#if defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
#include <intrin.h>
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Waits for another thread: spins at first, then gives the processor away. The pause tells the processor that this is a
// loop of waiting, so that it leaves its units to the other thread of its core.
class Spin_wait
{
public:
  void wait()
  {
    if(++m_count < 1024)
    {
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
      __builtin_ia32_pause();
#elif defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
      _mm_pause();
#endif
    }
    else
      std::this_thread::yield();
  }

  void reset() { m_count = 0; }

private:
  unsigned int m_count = 0;
};

// Invariants: m_done <= number of units claimed <= number of units of the phase; they are equal between phases. What
// the conductor writes before share() is seen by all units, and what the units write is seen by the conductor after it.
//
// Why that holds. The conductor publishes a phase by storing the ticket (release), and a thread claims a unit by
// exchanging the ticket (acquire): it sees all that was written before, also that m_done is zero. It counts its unit in
// m_done (release), and the conductor goes on when it has read the full number (acquire).
class Work_sharing
{
public:
  static constexpr std::uint32_t maximum_number_of_units = 0xffff;

  // In the conductor's thread: calls work(i) for all i < n, some of them in other threads, and returns when all are
  // done. Rethrows the first exception of any; the other units are done nevertheless. Requires: n <=
  // maximum_number_of_units; the other threads are in help(), or come there later, with the same work for this kind.
  template <typename Work>
  void share(bool kind, std::uint32_t n, Work work)
  {
    CGAL_assertion(n <= maximum_number_of_units && m_done.load() == number_of_units(m_ticket.load()));
    m_done.store(0, std::memory_order_relaxed);
    m_ticket.store(ticket_after(m_ticket.load(std::memory_order_relaxed), kind, n), std::memory_order_release);
    while(do_one([&](bool, std::uint32_t i) { work(i); }))
    {}
    Spin_wait spin;
    while(m_done.load(std::memory_order_acquire) != n)
      spin.wait();
    rethrow();
  }

  // In another thread: does units until the conductor calls end(). work(kind, i) is unit i of a phase of that kind. A
  // thread may come late, even after end(). An exception of a unit is kept for the conductor.
  template <typename Work>
  void help(Work work)
  {
    Spin_wait spin;
    while(!m_is_over.load(std::memory_order_acquire))
      if(do_one(work))
        spin.reset();
      else
        spin.wait();
  }

  // In the conductor's thread: between these two calls, help() waits for units. Requires of begin(): no thread is in
  // help() yet. Requires of end(): no phase is under way.
  void begin() { m_is_over.store(false); }
  void end() { m_is_over.store(true, std::memory_order_release); }

private:
  // A ticket has the number of the phase (31 bits), its kind (1 bit), the number of units, and the next unit (16 bits
  // each). A thread claims a unit by exchanging the ticket, so it cannot claim one of a phase that is over. The next
  // unit does not run over into the number of units, as it never exceeds it.
  using Ticket = std::uint64_t;

  // The ticket of the next phase, of which no unit is claimed yet.
  static Ticket ticket_after(Ticket t, bool kind, std::uint32_t n)
  {
    return (((t >> 33) + 1) << 33) | (static_cast<Ticket>(kind) << 32) | (static_cast<Ticket>(n) << 16);
  }

  static std::uint32_t number_of_units(Ticket t) { return (t >> 16) & 0xffff; }
  static std::uint32_t next_unit(Ticket t) { return t & 0xffff; }
  static bool kind_of(Ticket t) { return ((t >> 32) & 1) != 0; }

  // Claims and does one unit. Returns false if all are claimed. A unit that throws counts as done, else the conductor
  // would wait forever. The first one to throw keeps its exception before it counts; nobody else writes there.
  template <typename Work>
  bool do_one(Work work)
  {
    Ticket t = m_ticket.load(std::memory_order_acquire);
    do
    {
      if(next_unit(t) >= number_of_units(t))
        return false;
    } while(!m_ticket.compare_exchange_weak(t, t + 1, std::memory_order_acquire, std::memory_order_acquire));
    try
    {
      work(kind_of(t), next_unit(t));
    }
    catch(...)
    {
      if(!m_has_failed.exchange(true))
        m_failure = std::current_exception();
    }
    m_done.fetch_add(1, std::memory_order_release);
    return true;
  }

  // Requires: all units are done.
  void rethrow()
  {
    if(!m_has_failed.load(std::memory_order_acquire))
      return;
    const std::exception_ptr failure = m_failure;
    m_failure = nullptr;
    m_has_failed.store(false);
    std::rethrow_exception(failure);
  }

  // On cache lines of their own: threads poll them.
  alignas(64) std::atomic<Ticket> m_ticket{0};
  alignas(64) std::atomic<std::uint32_t> m_done{0};
  alignas(64) std::atomic<bool> m_is_over{false};
  std::atomic<bool> m_has_failed{false};
  std::exception_ptr m_failure;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WORK_SHARING_H
