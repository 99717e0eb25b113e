// Runs with 1, 2, ... threads, in turn, and their speedup over sequential runs.

#ifndef THREAD_COUNTS_H
#define THREAD_COUNTS_H

#include "runs_in_process.h"

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <string>
#include <thread>
#include <vector>

using Parallel = CGAL::Parallel_if_available_tag;

class Scaling
{
public:
  struct Entry
  {
    std::string name; // the number of threads, or "sequential"
    Spread time;
    double speedup;
  };

  // Calls run(n) for n threads and run(0) for the sequential code, and measures the elapsed time.
  template <class Run>
  Scaling(const Settings& settings, const Run& run)
  {
    const std::vector<std::size_t> counts = thread_counts();
    std::vector<std::vector<double>> times(counts.size());
    for(std::size_t i = 0; i < settings.repetitions; ++i)
    {
      for(std::size_t k = 0; k < counts.size(); ++k)
      {
        times[k].push_back(milliseconds_with(counts[k], run));
      }
    }
    for(std::size_t k = 0; k < counts.size(); ++k)
    {
      m_entries.push_back(Entry{counts[k] == 0 ? "sequential" : std::to_string(counts[k]), Spread(times[k]),
                                median_ratio(times[0], times[k])});
    }
  }

  const std::vector<Entry>& entries() const { return m_entries; }

private:
  // Returns 0 (sequential), the powers of two below the number of hardware threads, and this number.
  static std::vector<std::size_t> thread_counts()
  {
    std::vector<std::size_t> counts{0};
#ifdef CGAL_LINKED_WITH_TBB
    const std::size_t all = (std::max)(1u, std::thread::hardware_concurrency());
    for(std::size_t n = 1; n < all; n *= 2)
    {
      counts.push_back(n);
    }
    counts.push_back(all);
#endif
    return counts;
  }

  template <class Run>
  static double milliseconds_with(std::size_t threads, const Run& run)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(threads > 0)
    {
      tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      tbb::task_arena arena(static_cast<int>(threads));
      return arena.execute([&]() { return milliseconds_of(CLOCK_MONOTONIC, [&]() { run(threads); }); });
    }
#endif
    return milliseconds_of(CLOCK_MONOTONIC, [&]() { run(threads); });
  }

  std::vector<Entry> m_entries;
};

#endif // THREAD_COUNTS_H
