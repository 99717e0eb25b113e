#ifndef SURFACE_MESH_GEODESICS_TEST_SUPPORT_H
#define SURFACE_MESH_GEODESICS_TEST_SUPPORT_H

// Checks that always run, with NDEBUG too. A failed check prints its location and the values. The program goes on and
// ends with test_result().

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_support {

struct Test_state
{
  std::size_t number_of_checks = 0;
  std::size_t number_of_failures = 0;
  std::vector<std::string> context;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

inline Test_state& state()
{
  static Test_state the_state;
  return the_state;
}

// Names what is being tested. Each failure inside the scope prints the name first.
class Scope
{
public:
  explicit Scope(const std::string& name) { state().context.push_back(name); }
  ~Scope() { state().context.pop_back(); }
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;
};

inline void report_failure(const char* file, int line, const std::string& text)
{
  Test_state& s = state();
  ++s.number_of_failures;
  const std::size_t maximum_printed = 40;
  if(s.number_of_failures > maximum_printed)
  {
    return;
  }
  std::cout << file << ":" << line << ": FAILED";
  for(const std::string& name : s.context)
  {
    std::cout << " [" << name << "]";
  }
  std::cout << " " << text << std::endl;
  if(s.number_of_failures == maximum_printed)
  {
    std::cout << "(further failures are counted but not printed)" << std::endl;
  }
}

inline bool check(bool condition, const char* text, const char* file, int line)
{
  ++state().number_of_checks;
  if(!condition)
  {
    report_failure(file, line, text);
  }
  return condition;
}

template <class A, class B>
bool check_equal(const A& a, const B& b, const char* text, const char* file, int line)
{
  ++state().number_of_checks;
  if(a == b)
  {
    return true;
  }
  std::ostringstream message;
  message.precision(17);
  message << text << ": " << a << " against " << b;
  report_failure(file, line, message.str());
  return false;
}

// Returns true for equal infinities, and false if one of the numbers is NaN.
inline bool is_close(double a, double b, double relative)
{
  if(a == b)
  {
    return true;
  }
  if(!std::isfinite(a) || !std::isfinite(b))
  {
    return false;
  }
  return std::abs(a - b) <= relative * (std::max)(std::abs(a), std::abs(b));
}

inline bool check_close(double a, double b, double relative, const char* text, const char* file, int line)
{
  ++state().number_of_checks;
  if(is_close(a, b, relative))
  {
    return true;
  }
  std::ostringstream message;
  message.precision(17);
  message << text << ": " << a << " against " << b << ", relative difference "
          << std::abs(a - b) / (std::max)(std::abs(a), std::abs(b)) << " > " << relative;
  report_failure(file, line, message.str());
  return false;
}

inline bool check_near(double a, double b, double absolute, const char* text, const char* file, int line)
{
  ++state().number_of_checks;
  if(a == b || std::abs(a - b) <= absolute)
  {
    return true;
  }
  std::ostringstream message;
  message.precision(17);
  message << text << ": " << a << " against " << b << ", difference " << std::abs(a - b) << " > " << absolute;
  report_failure(file, line, message.str());
  return false;
}

// Compares two fields entry by entry. Reports only the worst entry.
inline bool check_fields_close(const std::vector<double>& a, const std::vector<double>& b, double relative,
                               const char* text, const char* file, int line)
{
  ++state().number_of_checks;
  std::ostringstream message;
  message.precision(17);
  if(a.size() != b.size())
  {
    message << text << ": sizes " << a.size() << " against " << b.size();
    report_failure(file, line, message.str());
    return false;
  }
  std::size_t number_of_bad_entries = 0;
  std::size_t worst = 0;
  double worst_difference = -1;
  for(std::size_t i = 0; i < a.size(); ++i)
  {
    if(is_close(a[i], b[i], relative))
    {
      continue;
    }
    ++number_of_bad_entries;
    double difference = std::abs(a[i] - b[i]) / (std::max)(std::abs(a[i]), std::abs(b[i]));
    if(!std::isfinite(difference))
    {
      difference = std::numeric_limits<double>::infinity();
    }
    if(difference > worst_difference)
    {
      worst_difference = difference;
      worst = i;
    }
  }
  if(number_of_bad_entries == 0)
  {
    return true;
  }
  message << text << ": " << number_of_bad_entries << " of " << a.size() << " entries differ by more than "
          << relative << ", worst entry " << worst << ": " << a[worst] << " against " << b[worst]
          << ", relative difference " << worst_difference;
  report_failure(file, line, message.str());
  return false;
}

inline int test_result()
{
  const Test_state& s = state();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - s.start;
  std::cout << s.number_of_checks << " checks, " << s.number_of_failures << " failures, " << time.count()
            << " s" << std::endl;
  return s.number_of_failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

// Random numbers that are the same on every platform. The distributions of the standard library are not.
class Random
{
public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}

  // Returns a number in [0, 1).
  double uniform() { return static_cast<double>(m_engine() >> 11) * 0x1p-53; }
  double uniform(double a, double b) { return a + (b - a) * uniform(); }
  std::size_t index(std::size_t n) { return static_cast<std::size_t>(m_engine() % n); }

  template <class T>
  void shuffle(std::vector<T>& range)
  {
    for(std::size_t i = range.size(); i > 1; --i)
    {
      using std::swap;
      swap(range[i - 1], range[index(i)]);
    }
  }

private:
  std::mt19937_64 m_engine;
};

// Prints the seed of a test program and returns it.
inline std::uint64_t announce_seed(std::uint64_t seed)
{
  std::cout << "seed " << seed << std::endl;
  return seed;
}

} // namespace test_support

using test_support::test_result;

#define CHECK(condition) test_support::check(static_cast<bool>(condition), #condition, __FILE__, __LINE__)
#define CHECK_EQUAL(a, b) test_support::check_equal((a), (b), #a " == " #b, __FILE__, __LINE__)
#define CHECK_CLOSE(a, b, relative) \
  test_support::check_close((a), (b), (relative), #a " ~ " #b, __FILE__, __LINE__)
#define CHECK_NEAR(a, b, absolute) \
  test_support::check_near((a), (b), (absolute), #a " ~ " #b, __FILE__, __LINE__)
#define CHECK_FIELDS_CLOSE(a, b, relative) \
  test_support::check_fields_close((a), (b), (relative), #a " ~ " #b, __FILE__, __LINE__)

#endif // SURFACE_MESH_GEODESICS_TEST_SUPPORT_H
