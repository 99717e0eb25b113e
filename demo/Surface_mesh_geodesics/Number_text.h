#ifndef SURFACE_MESH_GEODESICS_DEMO_NUMBER_TEXT_H
#define SURFACE_MESH_GEODESICS_DEMO_NUMBER_TEXT_H

#include <array>
#include <charconv>
#include <ostream>

namespace geodesics_demo {

// The shortest text of a number that gives the same number when it is read: `os << Number_text(0.1)` writes 0.1, where
// seventeen digits would be 0.10000000000000001. It takes a fraction of the time, too. Infinity is "inf".
class Number_text
{
public:
  explicit Number_text(double x)
    : m_end(std::to_chars(m_letters.data(), m_letters.data() + m_letters.size(), x).ptr)
  {}

  friend std::ostream& operator<<(std::ostream& os, const Number_text& number)
  {
    return os.write(number.m_letters.data(), number.m_end - number.m_letters.data());
  }

private:
  std::array<char, 32> m_letters; // -1.7976931348623157e+308 is the longest number
  char* m_end;
};

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_NUMBER_TEXT_H
