// The pieces of the parallel propagation: units of work are done once each, whatever the threads do; parts of the
// wavefront divide the vertices; the threshold of batches follows the wavefront.

#include "test_support.h"
#include "thread_team.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Batch_threshold.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Wavefront_part.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Work_sharing.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <stdexcept>
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
  sharing.begin();
  Thread_team(number_of_threads).run(number_of_threads, [&](std::size_t thread)
  {
    if(thread > 0)
    {
      sharing.help(work);
      return;
    }
    for(std::size_t phase = 0; phase < 300; ++phase)
    {
      const std::uint32_t n = static_cast<std::uint32_t>(random.index(phase % 3 == 0 ? 3 : done.size()));
      for(std::atomic<int>& count : done)
        count = 0;
      failing = n / 2;
      expected_kind = phase % 2 != 0;
      bool is_caught = false;
      try
      {
        sharing.share(expected_kind, n, [&](std::uint32_t i) { work(expected_kind, i); });
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

// Each vertex has one part and one number there; numbers keep the order of the vertices, and are small.
void parts_divide_the_vertices()
{
  for(const std::size_t wanted : std::vector<std::size_t>{1, 2, 3, 16, 64})
  {
    internal::Part_numbering numbering;
    numbering.set_number(wanted);
    CHECK(numbering.number() >= wanted && numbering.number() < 2 * wanted);
    const std::size_t n = 10000;
    std::vector<std::vector<internal::Vertex_id>> numbers(numbering.number());
    for(internal::Vertex_id v = 0; v < n; ++v)
    {
      const std::size_t part = numbering.part_of(v);
      const internal::Vertex_id number = numbering.number_in_part(v);
      CHECK(part < numbering.number());
      CHECK_EQUAL(numbering.vertex(number, part), v);
      CHECK(number < numbering.largest_part(n));
      CHECK(numbers[part].empty() || numbers[part].back() < number);
      numbers[part].push_back(number);
    }
    for(const auto& part : numbers)
      CHECK(part.size() < n / numbering.number() + 65);
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
      const double farthest = keys[size - 1];
      for(std::size_t i = 0; i < size; ++i)
        keys[i] += random.uniform(0, scale);
      threshold.go_on(size, farthest, front);
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
  parts_divide_the_vertices();
  batches_are_a_small_part_of_the_wavefront(random);
  return test_result();
}
