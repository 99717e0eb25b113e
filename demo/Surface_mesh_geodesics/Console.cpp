#include "Console.h"

#include "System.h"

#include <algorithm>
#include <iostream>

namespace geodesics_demo {

Console::Console(bool is_quiet) : m_is_quiet(is_quiet), m_shows_progress(!is_quiet && is_error_stream_terminal()) {}

void Console::note(const std::string& text) const
{
  if(!m_is_quiet)
    std::cerr << "surface_mesh_geodesics: " << text << std::endl;
}

Progress_bar::Progress_bar(const Console& console, const std::string& what, unsigned int calls_per_look)
  : m_what(what), m_is_on(console.shows_progress()), m_calls_per_look(calls_per_look),
    m_start(Clock::now()), m_next_drawing(m_start + std::chrono::milliseconds(500))
{}

Progress_bar::~Progress_bar()
{
  if(m_has_drawn)
    std::cerr << "\r\033[K" << std::flush; // erases the bar
}

void Progress_bar::show(double fraction)
{
  if(!m_is_on || ++m_number_of_calls % m_calls_per_look != 0)
    return;
  const Clock::time_point now = Clock::now();
  if(now < m_next_drawing)
    return;
  m_next_drawing = now + std::chrono::milliseconds(100);
  m_has_drawn = true;
  const double seconds = std::chrono::duration<double>(now - m_start).count();
  const double rest = fraction > .02 ? seconds * (1 - fraction) / fraction : -1;
  const int width = 40, percent = static_cast<int>(100 * (std::min)((std::max)(fraction, 0.), 1.));
  const std::string done(static_cast<std::size_t>(percent * width / 100), '#');
  std::cerr << '\r' << m_what << " [" << done << std::string(static_cast<std::size_t>(width) - done.size(), '.')
            << "] " << percent << " %"
            << (rest >= 0 ? ", about " + std::to_string(static_cast<long>(rest) + 1) + " s left" : std::string())
            << "\033[K" << std::flush;
}

Work_sign::Work_sign(const Console& console, const std::string& what) : m_what(what)
{
  if(console.shows_progress())
    m_thread = std::thread([this] { show(); });
}

Work_sign::~Work_sign()
{
  if(!m_thread.joinable())
    return;
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_is_done = true;
  }
  m_end.notify_all();
  m_thread.join();
}

void Work_sign::show()
{
  using Milliseconds = std::chrono::milliseconds;
  const auto start = std::chrono::steady_clock::now();
  Milliseconds pause(500);
  std::unique_lock<std::mutex> lock(m_mutex);
  while(!m_end.wait_for(lock, pause, [this] { return m_is_done; }))
  {
    pause = Milliseconds(200);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::cerr << ("\r" + m_what + " ... " + std::to_string(static_cast<long>(time.count())) + " s") << std::flush;
  }
  if(pause == Milliseconds(200))
    std::cerr << "\r\033[K" << std::flush; // erases the sign
}

} // namespace geodesics_demo
