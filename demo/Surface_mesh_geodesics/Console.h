#ifndef SURFACE_MESH_GEODESICS_DEMO_CONSOLE_H
#define SURFACE_MESH_GEODESICS_DEMO_CONSOLE_H

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace geodesics_demo {

// Messages for the user on the standard error stream, while the program works.
class Console
{
public:
  explicit Console(bool is_quiet);

  // Prints a remark on the input or the result, unless `--quiet` suppresses it.
  void note(const std::string& text) const;

  // Whether note() prints anything.
  bool shows_notes() const { return !m_is_quiet; }

  // Progress is shown on a terminal only, since it would fill a log file.
  bool shows_progress() const { return m_shows_progress; }

private:
  bool m_is_quiet, m_shows_progress;
};

// A progress bar that appears when the work takes longer than half a second, and disappears when it is done. It tells
// how long the rest takes at the pace so far.
class Progress_bar
{
public:
  // Reads the clock at every `calls_per_look`-th call only: reading it costs more than a visit of a vertex.
  Progress_bar(const Console& console, const std::string& what, unsigned int calls_per_look = 64);
  ~Progress_bar();

  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  // `fraction` is in [0, 1]. Cheap enough to be called for each vertex of a mesh.
  void show(double fraction);

private:
  using Clock = std::chrono::steady_clock;

  std::string m_what;
  bool m_is_on, m_has_drawn = false;
  unsigned int m_calls_per_look, m_number_of_calls = 0;
  Clock::time_point m_start, m_next_drawing;
};

// A sign for work of unknown length: after half a second a terminal shows what is being done and for how long, until
// the object is destroyed.
class Work_sign
{
public:
  Work_sign(const Console& console, const std::string& what);
  ~Work_sign();

  Work_sign(const Work_sign&) = delete;
  Work_sign& operator=(const Work_sign&) = delete;

private:
  void show();

  std::string m_what;
  std::mutex m_mutex;
  std::condition_variable m_end;
  bool m_is_done = false;
  std::thread m_thread;
};

// Shows the progress of a propagation: the fraction of the vertices that have been visited.
class Progress_visitor
  : public CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
public:
  Progress_visitor(const Console& console, const std::string& what) : m_bar(console, what) {}

  void on_propagation_begin(std::size_t number_of_vertices) { m_number_of_vertices = number_of_vertices; }

  void on_progress(std::size_t number_of_visits, double)
  {
    m_bar.show(static_cast<double>(number_of_visits) / static_cast<double>(m_number_of_vertices));
  }

private:
  Progress_bar m_bar;
  std::size_t m_number_of_vertices = 1;
};

// Shows the progress of work with many propagations: the fraction of the propagations that have begun.
class Run_counting_visitor
  : public CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
public:
  Run_counting_visitor(const Console& console, const std::string& what, std::size_t number_of_runs)
    : m_bar(console, what, 1), m_number_of_runs(number_of_runs)
  {}

  void on_propagation_begin(std::size_t)
  {
    m_bar.show(static_cast<double>(m_number_begun++) / static_cast<double>(m_number_of_runs));
  }

private:
  Progress_bar m_bar;
  std::size_t m_number_of_runs, m_number_begun = 0;
};

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_CONSOLE_H
