#ifndef SURFACE_MESH_GEODESICS_DEMO_BYTE_SCANNER_H
#define SURFACE_MESH_GEODESICS_DEMO_BYTE_SCANNER_H

#include "Command_error.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace geodesics_demo {

enum class Byte_order { LOWEST_FIRST, HIGHEST_FIRST };

// Reads binary numbers from bytes in memory. Throws a Command_error at the end of the bytes.
class Byte_scanner
{
public:
  Byte_scanner(const std::string& file_name, std::string_view bytes, Byte_order order)
    : m_file_name(file_name), m_bytes(bytes), m_order(order)
  {}

  template <typename Number>
  Number next()
  {
    unsigned char bytes[sizeof(Number)];
    require(sizeof(Number));
    std::memcpy(bytes, m_bytes.data() + m_position, sizeof(Number));
    m_position += sizeof(Number);
    return number_of<Number>(bytes);
  }

  void skip(std::size_t n)
  {
    require(n);
    m_position += n;
  }

  std::size_t rest() const { return m_bytes.size() - m_position; }

private:
  void require(std::size_t n) const
  {
    if(rest() < n)
      reject_file(m_file_name, "the file ends too early, after " + std::to_string(m_bytes.size()) + " bytes of data");
  }

  // The loop is one instruction, or two, on machines with either order.
  template <typename Number>
  Number number_of(const unsigned char* bytes) const
  {
    std::uint64_t bits = 0;
    for(std::size_t k = 0; k < sizeof(Number); ++k)
      bits |= std::uint64_t(bytes[m_order == Byte_order::LOWEST_FIRST ? k : sizeof(Number) - 1 - k]) << (8 * k);
    Number result;
    if constexpr(sizeof(Number) == 8)
      std::memcpy(&result, &bits, sizeof(Number));
    else if constexpr(sizeof(Number) == 4)
    {
      const std::uint32_t narrow = static_cast<std::uint32_t>(bits);
      std::memcpy(&result, &narrow, sizeof(Number));
    }
    else
      result = static_cast<Number>(bits);
    return result;
  }

  std::string m_file_name;
  std::string_view m_bytes;
  std::size_t m_position = 0;
  Byte_order m_order;
};

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_BYTE_SCANNER_H
