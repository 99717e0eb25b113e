#ifndef SURFACE_MESH_GEODESICS_WITH_THREADS_H
#define SURFACE_MESH_GEODESICS_WITH_THREADS_H

// A number of threads for what has the tag Parallel_if_available_tag.

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>

// Calls a function with this number of threads, if the tag has threads at all.
template <class Call>
void with_threads(std::size_t number_of_threads, const Call& call)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
  tbb::task_arena arena(static_cast<int>(number_of_threads));
  arena.execute(call);
#else
  static_cast<void>(number_of_threads);
  call();
#endif
}

#endif // SURFACE_MESH_GEODESICS_WITH_THREADS_H
