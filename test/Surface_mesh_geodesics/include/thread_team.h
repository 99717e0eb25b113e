#ifndef SURFACE_MESH_GEODESICS_THREAD_TEAM_H
#define SURFACE_MESH_GEODESICS_THREAD_TEAM_H

// A team of threads (internal/propagation/Worker_team.h) made of std::thread. It needs no library and works
// with the thread sanitizer.

#include <cstddef>
#include <thread>
#include <vector>

class Thread_team
{
public:
  explicit Thread_team(std::size_t size = 1) : m_size(size) {}

  std::size_t size() const { return m_size; }

  template <typename Work>
  void run(std::size_t n, Work work) const
  {
    std::vector<std::thread> others;
    for(std::size_t i = 1; i < n; ++i)
    {
      others.emplace_back([&work, i]() { work(i); });
    }
    work(0);
    for(std::thread& thread : others)
    {
      thread.join();
    }
  }

  template <typename Function>
  static auto isolate(Function function)
  {
    return function();
  }

private:
  std::size_t m_size;
};

#endif // SURFACE_MESH_GEODESICS_THREAD_TEAM_H
