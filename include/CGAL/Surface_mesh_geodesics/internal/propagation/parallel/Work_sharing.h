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
// phase, does units itself, and goes on as soon as all are done.
//
// Each thread has units of its own: those whose data its cache probably holds. It does them in ascending order. Then it
// takes over units of other threads, their last one first. So threads seldom touch the same line of memory before
// the end of a phase, which matters: on some machines it takes half a microsecond until one thread sees what another
// one has written, half as long as the visit of a vertex.
//
// There is no barrier: the conductor waits for units that another thread has begun, never for a thread that is late or
// asleep. So a team may have more threads than the machine, and a phase of a few microseconds is worth sharing.

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <thread>
#include <vector>

#if defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
#include <intrin.h>
#endif

// Visual C++ warns of classes that are padded to cache lines. They are, on purpose: several threads change them at the
// same time, and two on one line would wait for each other.
#ifdef _MSC_VER
#pragma warning(push)
#pragma warning(disable : 4324)
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// How many visits of a batch a thread does at a time: few enough that all threads end at about the same time.
inline std::size_t visits_per_unit(std::size_t number_of_visits, std::size_t number_of_threads)
{
  return (std::max)(number_of_visits / (8 * number_of_threads), std::size_t(1));
}

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

// Invariant, between phases: all units of all threads are claimed and counted.
//
// What the conductor writes before share() is seen by all units, and what the units write is seen by the conductor
// after it. Why that holds: the conductor publishes a phase by storing a ticket for each thread (release), and a unit
// is claimed by exchanging its ticket (acquire). A thread counts its units in m_done (release) when it finds no more of
// them, and the conductor goes on when it has read the full number (acquire). So no phase begins before all claims of
// the last one are counted.
class Work_sharing
{
public:
  static constexpr std::uint32_t maximum_number_of_units = 0xffff;

  // In the conductor's thread: calls work(i) for all i < ends.back(), some of them in other threads, and returns when
  // all are done. The units of thread t end before ends[t], and begin where those of the thread before it end. Rethrows
  // the first exception of any; the other units are done nevertheless. Requires: `ends` has one number for each
  // thread, ascending, none greater than maximum_number_of_units; the other threads are in help(), or come there
  // later, with the same work for this kind.
  template <typename Work>
  void share(bool kind, const std::vector<std::uint32_t>& ends, Work work)
  {
    CGAL_assertion(ends.size() == m_number_of_threads && ends.back() <= maximum_number_of_units);
    m_done.store(0, std::memory_order_relaxed);
    ++m_phase;
    for(std::size_t t = m_number_of_threads; t-- > 0;) // that of the conductor comes last: it is at work already
      m_tickets[t].ticket.store(ticket(m_phase, kind, ends[t], t == 0 ? 0 : ends[t - 1]), std::memory_order_release);
    const std::uint32_t n = do_units(0, [&](bool, std::uint32_t i) { work(i); });
    Spin_wait spin;
    while(n + m_done.load(std::memory_order_acquire) != ends.back())
      spin.wait();
    rethrow();
  }

  // In another thread, number `thread`: does units until the conductor calls end(). work(kind, i) is unit i of a phase
  // of that kind. A thread may come late, even after end(). An exception of a unit is kept for the conductor. Once no
  // unit of a phase is left, the thread waits at its own ticket, where it disturbs nobody.
  template <typename Work>
  void help(std::size_t thread, Work work)
  {
    CGAL_assertion(thread > 0 && thread < m_number_of_threads);
    Spin_wait spin;
    std::uint32_t last_phase = 0; // none
    while(!m_is_over.load(std::memory_order_acquire))
    {
      const std::uint32_t phase = phase_of(m_tickets[thread].ticket.load(std::memory_order_acquire));
      if(phase == last_phase)
      {
        spin.wait();
        continue;
      }
      last_phase = phase;
      const std::uint32_t n = do_units(thread, work);
      if(n > 0)
        m_done.fetch_add(n, std::memory_order_release);
      spin.reset();
    }
  }

  // In the conductor's thread: between these two calls, help() waits for units; `number_of_threads` counts the
  // conductor, which is thread 0. Requires of begin(): no thread is in help() yet. Requires of end(): no phase is under
  // way.
  void begin(std::size_t number_of_threads)
  {
    if(m_number_of_threads < number_of_threads || m_tickets == nullptr)
      m_tickets.reset(new Published_ticket[number_of_threads]);
    m_number_of_threads = number_of_threads;
    m_is_over.store(false);
  }
  void end() { m_is_over.store(true, std::memory_order_release); }

private:
  // The units that a thread has left: the number of the phase (31 bits), its kind (1 bit), the end of the units, and
  // the next unit (16 bits each). A claim exchanges the ticket, so no thread can claim a unit of a phase that is over.
  using Ticket = std::uint64_t;

  // On a cache line of its own: the thread polls it.
  struct alignas(64) Published_ticket
  {
    std::atomic<Ticket> ticket{0};
  };

  static Ticket ticket(std::uint32_t phase, bool kind, std::uint32_t end, std::uint32_t next)
  {
    return (Ticket(phase) << 33) | (Ticket(kind) << 32) | (Ticket(end) << 16) | next;
  }

  static std::uint32_t phase_of(Ticket t) { return static_cast<std::uint32_t>(t >> 33); }
  static bool kind_of(Ticket t) { return ((t >> 32) & 1) != 0; }
  static std::uint32_t end_of(Ticket t) { return (t >> 16) & 0xffff; }
  static std::uint32_t next_of(Ticket t) { return t & 0xffff; }

  // Does the units of a thread, then those that other threads have left. Returns their number.
  template <typename Work>
  std::uint32_t do_units(std::size_t thread, Work work)
  {
    std::uint32_t n = 0;
    while(do_one(m_tickets[thread].ticket, true, work))
      ++n;
    for(std::size_t k = 1; k < m_number_of_threads; ++k)
      while(do_one(m_tickets[(thread + k) % m_number_of_threads].ticket, false, work))
        ++n;
    return n;
  }

  // Claims and does the first or the last unit of a ticket. Returns false if none is left. A unit that throws counts as
  // done, else the conductor would wait forever. The first one to throw keeps its exception before it counts; nobody
  // else writes there.
  template <typename Work>
  bool do_one(std::atomic<Ticket>& ticket, bool is_first, Work& work)
  {
    constexpr Ticket one_from_end = Ticket(1) << 16;
    Ticket t = ticket.load(std::memory_order_acquire);
    do
    {
      if(next_of(t) >= end_of(t))
        return false;
    } while(!ticket.compare_exchange_weak(t, is_first ? t + 1 : t - one_from_end, std::memory_order_acquire,
                                          std::memory_order_acquire));
    try
    {
      work(kind_of(t), is_first ? next_of(t) : end_of(t) - 1);
    }
    catch(...)
    {
      if(!m_has_failed.exchange(true))
        m_failure = std::current_exception();
    }
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

  std::unique_ptr<Published_ticket[]> m_tickets; // by thread
  std::size_t m_number_of_threads = 0;
  std::uint32_t m_phase = 0;
  alignas(64) std::atomic<std::uint32_t> m_done{0}; // units of the phase that other threads have done
  alignas(64) std::atomic<bool> m_is_over{false};
  std::atomic<bool> m_has_failed{false};
  std::exception_ptr m_failure;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#ifdef _MSC_VER
#pragma warning(pop)
#endif

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WORK_SHARING_H
