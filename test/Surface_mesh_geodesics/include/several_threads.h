#ifndef TEST_SEVERAL_THREADS_H
#define TEST_SEVERAL_THREADS_H

// Tags for tests. Several_threads is Parallel_tag, but several threads compute distances on small meshes, too; without
// TBB, it is Sequential_tag. Visits_in_batches is the same by one thread, and needs no library. So does
// Propagation_of_size, which chooses as Parallel_tag does (Propagation_by_size.h).

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Available_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Propagation_for_tag.h>

#include <CGAL/tags.h>

namespace test_support {

struct Visits_in_batches : CGAL::Sequential_tag {};
struct Propagation_of_size : CGAL::Sequential_tag {};

} // namespace test_support

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <>
struct Available_tag<test_support::Visits_in_batches>
{
  using type = test_support::Visits_in_batches;
};

template <typename FT, typename Rules, typename Keeper>
struct Propagation_for_tag<test_support::Visits_in_batches, FT, Rules, Keeper>
{
  using type = Parallel_distance_propagation<FT, Rules, Calling_thread, Keeper>;
};

template <>
struct Available_tag<test_support::Propagation_of_size>
{
  using type = test_support::Propagation_of_size;
};

template <typename FT, typename Rules>
struct Propagation_for_tag<test_support::Propagation_of_size, FT, Rules, No_window_keeper>
{
  using type = Propagation_by_size<FT, Rules, Calling_thread>;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#ifdef CGAL_LINKED_WITH_TBB

namespace test_support {

struct Several_threads : CGAL::Parallel_tag {};

} // namespace test_support

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <>
struct Available_tag<test_support::Several_threads>
{
  using type = test_support::Several_threads;
};

template <>
struct Blocks_for_tag<test_support::Several_threads> : Blocks_for_tag<Parallel_tag> {};

template <typename FT, typename Rules, typename Keeper>
struct Propagation_for_tag<test_support::Several_threads, FT, Rules, Keeper>
{
  using type = Parallel_distance_propagation<FT, Rules, Tbb_team, Keeper>;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#else

namespace test_support {

using Several_threads = CGAL::Sequential_tag;

} // namespace test_support

#endif // CGAL_LINKED_WITH_TBB

#endif // TEST_SEVERAL_THREADS_H
