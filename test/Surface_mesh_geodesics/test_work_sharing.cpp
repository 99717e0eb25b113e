// The pieces of the parallel propagation: units of work are done once each, whatever the threads do; vertices belong to
// one part each; the division of the wavefront loses no vertex; the threshold of batches follows the wavefront.

#include "test_support.h"
#include "thread_team.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Batch_threshold.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Vertex_records.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Wavefront_division.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Work_sharing.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;

// Runs phases with random numbers of units. One unit of each phase throws, if units fail.
void each_unit_is_done_once(std::size_t number_of_threads, bool units_fail, test_support::Random& random)
{
  test_support::Scope scope(std::to_string(number_of_threads) + " threads");
  internal::Work_sharing sharing;
  std::vector<std::atomic<int>> done(500);
  std::uint32_t failing = 0;
  bool expected_kind = false;
  std::atomic<bool> is_kind_right{true};
  const auto work = [&](bool kind, std::uint32_t i)
  {
    ++done[i];
    if(kind != expected_kind)
      is_kind_right = false;
    if(units_fail && i == failing)
      throw std::range_error("thrown by a unit");
  };
  sharing.begin(number_of_threads);
  Thread_team(number_of_threads).run(number_of_threads, [&](std::size_t thread)
  {
    if(thread > 0)
    {
      sharing.help(thread, work);
      return;
    }
    for(std::size_t phase = 0; phase < 300; ++phase)
    {
      const std::uint32_t n = static_cast<std::uint32_t>(random.index(phase % 3 == 0 ? 3 : done.size()));
      std::vector<std::uint32_t> ends(number_of_threads); // some threads have no units of their own
      for(std::uint32_t& end : ends)
        end = static_cast<std::uint32_t>(random.index(n + 1));
      std::sort(ends.begin(), ends.end());
      ends.back() = n;
      for(std::atomic<int>& count : done)
        count = 0;
      failing = n / 2;
      expected_kind = phase % 2 != 0;
      bool is_caught = false;
      try
      {
        sharing.share(expected_kind, ends, [&](std::uint32_t i) { work(expected_kind, i); });
      }
      catch(const std::range_error&)
      {
        is_caught = true;
      }
      CHECK_EQUAL(is_caught, units_fail && n > 0);
      for(std::size_t i = 0; i < done.size(); ++i)
        CHECK_EQUAL(done[i].load(), i < n ? 1 : 0);
    }
    sharing.end();
  });
  CHECK(is_kind_right.load());
}

// Several threads ask for the parts of the same vertices, each for a part of its own: all get the same answers. In the
// next run no vertex belongs to a part.
void vertices_belong_to_one_part(std::size_t number_of_threads)
{
  const std::size_t n = 3000;
  internal::Vertex_records<double> records;
  for(std::size_t run = 0; run < 3; ++run)
  {
    records.restart(n + run * 500); // more vertices need a new table, as many keep it
    records.restart(n);
    std::vector<std::vector<std::size_t>> answers(number_of_threads, std::vector<std::size_t>(n));
    // All threads come to each vertex at about the same time.
    std::atomic<std::size_t> arrivals(0);
    Thread_team(number_of_threads).run(number_of_threads, [&](std::size_t thread)
    {
      for(internal::Vertex_id v = 0; v < n; ++v)
      {
        ++arrivals;
        while(arrivals.load() < (v + std::size_t(1)) * number_of_threads)
          std::this_thread::yield();
        answers[thread][v] = records.part_of(v, thread);
      }
    });
    for(internal::Vertex_id v = 0; v < n; ++v)
    {
      CHECK(answers[0][v] < number_of_threads);
      for(const std::vector<std::size_t>& answer : answers)
        CHECK_EQUAL(answer[v], answers[0][v]);
      records.set_part(v, 7);
      CHECK_EQUAL(records.part_of(v, 3), 7u);
    }
  }
}

// Batches that are uneven become even; sorted batches ascend from part to part. In both cases no vertex is lost, and
// vertices that are given back are in the queue of their part.
void division_keeps_all_vertices(std::size_t number_of_parts, test_support::Random& random)
{
  using internal::Vertex_id;
  test_support::Scope scope(std::to_string(number_of_parts) + " parts");
  const std::size_t n = 500;
  internal::Wavefront_division<double> division;
  for(std::size_t run = 0; run < 40; ++run)
  {
    division.restart(number_of_parts, n);
    const double skew = 1 + 5 * random.uniform(0, 1);
    for(Vertex_id v = 0; v < n; ++v)
    {
      const double x = std::pow(random.uniform(0, 1), skew);
      division.push(v, random.uniform(0, 1), static_cast<std::size_t>(x * double(number_of_parts)));
    }
    const double limit = random.uniform(0, 1);
    for(std::size_t i = 0; i < number_of_parts; ++i)
      division.part(i).fill_batch(limit);
    const std::size_t size = division.size_of_batch();
    CHECK_EQUAL(division.size(), n);
    CHECK(division.nearest_key() <= division.farthest_key() || size == 0);
    if(run % 2 == 0)
      division.balance();
    else
      division.sort_batches();
    CHECK_EQUAL(division.size_of_batch(), size);
    internal::Queued_vertex<double> last{-1, 0};
    for(std::size_t i = 0; i < number_of_parts; ++i)
    {
      CHECK(4 * division.part(i).batch().size() * number_of_parts <= 5 * size + 8 * number_of_parts);
      for(const internal::Queued_vertex<double>& q : division.part(i).batch())
      {
        CHECK(q.key <= limit);
        if(run % 2 == 0)
          CHECK_EQUAL(division.part_of(q.vertex, 0), i);
        else
          CHECK(last < q);
        last = q;
      }
    }
    division.give_back_batches();
    CHECK_EQUAL(division.size_of_batch(), 0u);
    std::vector<int> seen(n, 0);
    for(std::size_t i = 0; i < number_of_parts; ++i)
    {
      division.part(i).fill_batch(2);
      for(const internal::Queued_vertex<double>& q : division.part(i).batch())
      {
        ++seen[q.vertex];
        CHECK_EQUAL(division.part_of(q.vertex, 0), i);
      }
    }
    CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<std::ptrdiff_t>(n));
  }
}

// The batches of a wavefront whose keys are random follow the aim, and never get stuck.
void batches_are_a_small_part_of_the_wavefront(test_support::Random& random)
{
  const std::size_t front = 4000;
  for(const double scale : {1e-5, 1e-2, 3.})
  {
    test_support::Scope scope("keys of the size " + std::to_string(scale));
    internal::Batch_threshold<double> threshold(16);
    threshold.start();
    std::vector<double> keys(front);
    for(double& key : keys)
      key = random.uniform(0, scale);
    std::size_t small = 0, large = 0;
    for(std::size_t round = 0; round < 400; ++round)
    {
      std::sort(keys.begin(), keys.end());
      const std::size_t size =
        static_cast<std::size_t>(std::upper_bound(keys.begin(), keys.end(), threshold.limit()) - keys.begin());
      if(size == 0)
      {
        threshold.go_on_from(keys.front());
        continue;
      }
      const double nearest = keys.front(), farthest = keys[size - 1];
      for(std::size_t i = 0; i < size; ++i)
        keys[i] += random.uniform(0, scale);
      threshold.go_on({size, nearest, farthest, std::numeric_limits<double>::infinity(), front});
      if(round >= 100)
      {
        small += size < front / 50;
        large += size > front / 2;
      }
    }
    CHECK(small < 30);
    CHECK_EQUAL(large, 0u);
  }
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20261123));
  for(const std::size_t number_of_threads : std::vector<std::size_t>{1, 2, 5, 64})
  {
    each_unit_is_done_once(number_of_threads, false, random);
    each_unit_is_done_once(number_of_threads, true, random);
  }
  for(const std::size_t number : std::vector<std::size_t>{1, 2, 3, 16, 64})
  {
    vertices_belong_to_one_part((std::min)(number, std::size_t(8)));
    division_keeps_all_vertices(number, random);
  }
  batches_are_a_small_part_of_the_wavefront(random);
  return test_result();
}
