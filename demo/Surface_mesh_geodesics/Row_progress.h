#ifndef SURFACE_MESH_GEODESICS_DEMO_ROW_PROGRESS_H
#define SURFACE_MESH_GEODESICS_DEMO_ROW_PROGRESS_H

#include "Console.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>

#include <chrono>
#include <cstddef>

namespace geodesics_demo {

// Shows how many rows of a stored matrix are done, how many are computed per second, and how long the rest will take:
// on a terminal in one line, elsewhere, such as in the log of a job, in a line for each minute.
class Row_progress
  : public CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
public:
  explicit Row_progress(const Console& console);
  ~Row_progress();

  Row_progress(const Row_progress&) = delete;
  Row_progress& operator=(const Row_progress&) = delete;

  // Rows that were found cost nearly nothing, so they do not count for the rate.
  void on_rows(std::size_t computed, std::size_t found, std::size_t rows);

private:
  using Clock = std::chrono::steady_clock;

  bool m_is_on, m_is_on_terminal, m_has_drawn = false;
  Clock::time_point m_start, m_next_drawing;
};

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_ROW_PROGRESS_H
