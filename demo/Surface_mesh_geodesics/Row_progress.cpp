#include "Row_progress.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>

namespace geodesics_demo {

namespace {

// "3 h 20 min", "5 min 10 s" or "12 s".
std::string duration(double seconds)
{
  const long s = static_cast<long>((std::min)(seconds, 1e9) + .5);
  if(s >= 3600)
    return std::to_string(s / 3600) + " h " + std::to_string(s % 3600 / 60) + " min";
  return s >= 60 ? std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s" : std::to_string(s) + " s";
}

} // namespace

Row_progress::Row_progress(const Console& console)
  : m_is_on(console.shows_notes()), m_is_on_terminal(console.shows_progress()), m_start(Clock::now()),
    m_next_drawing(m_start + (m_is_on_terminal ? std::chrono::milliseconds(500) : std::chrono::minutes(1)))
{}

Row_progress::~Row_progress()
{
  if(m_has_drawn)
    std::cerr << "\r\033[K" << std::flush; // erases the line
}

void Row_progress::on_rows(std::size_t computed, std::size_t found, std::size_t rows)
{
  const Clock::time_point now = Clock::now();
  if(!m_is_on || now < m_next_drawing || computed == 0)
    return;
  m_next_drawing = now + (m_is_on_terminal ? std::chrono::milliseconds(200) : std::chrono::minutes(1));
  m_has_drawn = m_is_on_terminal;
  const double rate = static_cast<double>(computed) / std::chrono::duration<double>(now - m_start).count();
  char rate_text[40];
  std::snprintf(rate_text, sizeof rate_text, "%.3g", rate);
  std::cerr << (m_is_on_terminal ? "\r\033[K" : "") << "row " << computed + found << " of " << rows << ", " << rate_text
            << " rows per second, " << duration(static_cast<double>(rows - computed - found) / rate) << " left"
            << (m_is_on_terminal ? "" : "\n") << std::flush;
}

} // namespace geodesics_demo
