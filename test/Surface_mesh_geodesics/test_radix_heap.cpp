// An entry of the heap leaves when its distance is reached, never earlier and not much later. This holds for distances
// of any size.

#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Radix_heap.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using internal::Face_id;

// Pushes entries at any time. Pushes each entry that leaves once more.
void entries_leave_when_their_distance_is_reached(test_support::Random& random, double scale)
{
  const double never = std::numeric_limits<double>::infinity();
  internal::Radix_heap queue;
  std::vector<double> waits_for;
  std::vector<char> was_put_off;
  double reached = 0;
  for(int round = 0; round < 500; ++round)
  {
    for(std::size_t n = random.index(4); n-- > 0;)
    {
      const double distance = reached + scale * random.uniform(0., 1.);
      queue.push(static_cast<Face_id>(waits_for.size()), distance, 2 * distance);
      waits_for.push_back(distance);
      was_put_off.push_back(0);
    }
    reached += scale * random.uniform(0., .01) * static_cast<double>(random.index(3));
    std::vector<char> rounds(waits_for.size(), 0);
    const auto approach = [&](Face_id f, std::size_t round_of_face)
    { rounds[f] = static_cast<char>(10 * rounds[f] + static_cast<char>(round_of_face) + 1); };
    queue.advance(reached, approach, [&](Face_id f, double limit)
    {
      CHECK(waits_for[f] < reached);
      CHECK_EQUAL(int(rounds[f]), 12); // each face that leaves is approached twice before, in this order
      rounds[f] = 0;
      if(was_put_off[f] != 0)
      {
        waits_for[f] = never;
        return;
      }
      CHECK(limit >= 2 * waits_for[f]);
      was_put_off[f] = 1;
      waits_for[f] = reached + scale * random.uniform(0., .1);
      queue.push(f, waits_for[f], waits_for[f]);
    });
    for(const double distance : waits_for)
      CHECK(reached <= distance * (1 + 1e-6) + 1e-37);
  }
}

void reached_infinite_and_cleared_entries_are_handled()
{
  const auto nothing = [](Face_id, std::size_t) {};
  internal::Radix_heap queue;
  queue.push(7, 1., 1.);
  queue.clear();
  queue.advance(2., nothing, [](Face_id, double) { CHECK(false); });
  // An entry for a distance that has already been reached leaves as soon as the reached distance grows.
  queue.push(8, 1., 1.);
  std::size_t called = 0;
  queue.advance(1.5, nothing, [&](Face_id, double) { ++called; });
  CHECK_EQUAL(called, std::size_t(0));
  queue.advance(2.5, nothing, [&](Face_id, double) { ++called; });
  CHECK_EQUAL(called, std::size_t(1));
  // Distances beyond single precision never leave.
  const double infinity = std::numeric_limits<double>::infinity();
  queue.push(9, 1e200, infinity);
  queue.advance(1e100, nothing, [&](Face_id, double) { CHECK(false); });
  queue.advance(infinity, nothing, [&](Face_id, double) { CHECK(false); });
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20261122));
  for(const double scale : {1., 1e-3, 1e6, 1e-30, 1e-60})
  {
    const test_support::Scope scope("distances of " + std::to_string(scale));
    entries_leave_when_their_distance_is_reached(random, scale);
  }
  reached_infinite_and_cleared_entries_are_handled();
  return test_support::test_result();
}
