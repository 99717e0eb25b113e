#ifndef SURFACE_MESH_GEODESICS_APP_CONSOLE_H
#define SURFACE_MESH_GEODESICS_APP_CONSOLE_H

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>

#include <chrono>
#include <cstddef>
#include <string>

namespace geodesics_app {

// What the user is told while the program works, on the standard error stream.
class Console
{
public:
  explicit Console(bool is_quiet);

  // a remark on the input or the result, which `--quiet` suppresses.
  void note(const std::string& text) const;

  // Progress is shown on a terminal only: a file would be full of it.
  bool shows_progress() const { return m_shows_progress; }

private:
  bool m_is_quiet, m_shows_progress;
};

// A bar that appears when the work takes longer than half a second, and disappears when it is done.
class Progress_bar
{
public:
  Progress_bar(const Console& console, const std::string& what);
  ~Progress_bar();

  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  // `fraction` is from 0 to 1. Cheap enough to be called for each vertex of a mesh.
  void show(double fraction);

private:
  using Clock = std::chrono::steady_clock;

  std::string m_what;
  bool m_is_on, m_has_drawn = false;
  unsigned int m_number_of_calls = 0;
  Clock::time_point m_next_drawing;
};

// Shows the progress of a propagation: the part of the vertices that the wavefront has visited.
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

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_CONSOLE_H
