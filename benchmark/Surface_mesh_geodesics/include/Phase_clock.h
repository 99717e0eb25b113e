// The clock of a parallel propagation that one thread runs. It measures each part and each visit, and predicts the time
// with more threads.
//
// The prediction takes the rounds as they are, since they do not depend on the number of threads. What is outside the
// phases, and phases too small to share, takes the same time with any number of threads. The visits of a batch are
// dealt out in units, and the next unit goes to the thread that is free first, so that the longest thread counts.
// (In the propagation, a thread begins with the units of its own part of the wavefront.) A phase of the parts is
// divided evenly. Each phase that is shared adds the time that sharing costs (sharing_cost_ns()). The prediction does
// not know how caches and memory behave with more threads.

#ifndef PHASE_CLOCK_H
#define PHASE_CLOCK_H

#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Parallel_distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Work_sharing.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <thread>
#include <vector>

class Phase_clock
{
public:
  static constexpr std::array<std::size_t, 5> threads = {2, 4, 8, 16, 64};

  // Forgets all, and measures from now on. `sharing_cost` is in nanoseconds.
  void start(double sharing_cost)
  {
    m_sharing_cost = sharing_cost;
    m_outside = m_parts = m_visits = m_alone = 0;
    m_number_of_phases = 0;
    m_predicted.fill(0);
    m_last = now();
  }

  void stop()
  {
    m_outside += lap();
    for(double& time : m_predicted)
      time += m_outside;
  }

  void begin_phase(bool of_visits, bool is_worth_sharing)
  {
    m_outside += lap();
    m_is_of_visits = of_visits;
    m_is_worth_sharing = is_worth_sharing;
    m_units.clear();
  }

  void end_unit() { m_units.push_back(lap()); }

  void end_phase()
  {
    double sum = lap();
    for(const double time : m_units)
      sum += time;
    (m_is_of_visits ? m_visits : m_parts) += sum;
    if(!m_is_worth_sharing)
      m_alone += sum;
    else
      ++m_number_of_phases;
    for(std::size_t i = 0; i < threads.size(); ++i)
      m_predicted[i] += !m_is_worth_sharing ? sum
                        : m_sharing_cost + (m_is_of_visits ? longest_thread(threads[i]) : sum / double(threads[i]));
    m_last = now(); // the prediction is no work of the propagation
  }

  // Nanoseconds between start() and stop(), and how they are divided.
  double total() const { return m_outside + m_parts + m_visits; }
  double outside() const { return m_outside; } // of all phases: the conductor alone
  double alone() const { return m_alone; }     // in phases that are too small to share
  double parts() const { return m_parts; }     // in all phases of this kind
  double visits() const { return m_visits; }
  std::size_t number_of_shared_phases() const { return m_number_of_phases; }

  // The share of the time that more threads cannot shorten.
  double serial_share() const { return (m_outside + m_alone) / total(); }

  // The predicted speedup over one thread, for threads[i] threads.
  double predicted_speedup(std::size_t i) const { return total() / m_predicted[i]; }

private:
  static double now()
  {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }

  double lap()
  {
    const double before = m_last;
    m_last = now();
    return m_last - before;
  }

  // The time until all units of a batch are done, if n threads take them in their order.
  double longest_thread(std::size_t n) const
  {
    const std::size_t size_of_unit = CGAL::Surface_mesh_geodesics::internal::visits_per_unit(m_units.size(), n);
    std::priority_queue<double, std::vector<double>, std::greater<double>> free_at(
      std::greater<double>(), std::vector<double>(n, 0.));
    double longest = 0;
    for(std::size_t first = 0; first < m_units.size(); first += size_of_unit)
    {
      double end = free_at.top();
      free_at.pop();
      for(std::size_t i = first; i < (std::min)(first + size_of_unit, m_units.size()); ++i)
        end += m_units[i];
      free_at.push(end);
      longest = (std::max)(longest, end);
    }
    return longest;
  }

  double m_sharing_cost = 0, m_last = 0, m_outside = 0, m_parts = 0, m_visits = 0, m_alone = 0;
  bool m_is_of_visits = false, m_is_worth_sharing = false;
  std::size_t m_number_of_phases = 0;
  std::vector<double> m_units; // the times of the parts or visits of the phase
  std::array<double, threads.size()> m_predicted{};
};

// The nanoseconds that sharing adds to a phase: the time of a phase of two units without work, each of which another
// thread takes. Needs two idle processors.
inline double sharing_cost_ns()
{
  constexpr std::uint32_t number_of_phases = 20000;
  CGAL::Surface_mesh_geodesics::internal::Work_sharing sharing;
  std::atomic<std::uint32_t> number_begun{0};
  // A unit ends when both have begun.
  const auto work = [&](std::uint32_t phase)
  {
    number_begun.fetch_add(1);
    CGAL::Surface_mesh_geodesics::internal::Spin_wait spin;
    while(number_begun.load() < 2 * (phase + 1))
      spin.wait();
  };
  std::atomic<std::uint32_t> phase{0};
  sharing.begin(2);
  std::thread other([&]() { sharing.help(1, [&](bool, std::uint32_t) { work(phase.load()); }); });
  const auto start = std::chrono::steady_clock::now();
  for(std::uint32_t i = 0; i < number_of_phases; ++i)
  {
    phase.store(i);
    sharing.share(false, {1, 2}, [&](std::uint32_t) { work(i); });
  }
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  sharing.end();
  other.join();
  return time.count() / number_of_phases;
}

#endif // PHASE_CLOCK_H
