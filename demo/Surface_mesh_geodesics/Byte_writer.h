#ifndef SURFACE_MESH_GEODESICS_DEMO_BYTE_WRITER_H
#define SURFACE_MESH_GEODESICS_DEMO_BYTE_WRITER_H

#include "Byte_scanner.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <type_traits>

namespace geodesics_demo {

// Writes binary numbers to a stream, with the given order of bytes on any machine. Collects bytes before it writes
// them: a call of a stream for each number takes longer than anything else.
class Byte_writer
{
public:
  Byte_writer(std::ostream& os, Byte_order order) : m_os(os), m_order(order)
  {
    m_bytes.reserve(size_of_buffer + 8);
  }
  ~Byte_writer() { flush(); }

  Byte_writer(const Byte_writer&) = delete;
  Byte_writer& operator=(const Byte_writer&) = delete;

  template <typename Number>
  void add(Number x)
  {
    using Bits = std::conditional_t<
      sizeof(Number) == 8, std::uint64_t,
      std::conditional_t<sizeof(Number) == 4, std::uint32_t,
                         std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint8_t>>>;
    Bits bits;
    std::memcpy(&bits, &x, sizeof(x));
    for(std::size_t k = 0; k < sizeof(x); ++k)
    {
      const std::size_t place = m_order == Byte_order::LOWEST_FIRST ? k : sizeof(x) - 1 - k;
      m_bytes += static_cast<char>(static_cast<unsigned char>(bits >> (8 * place)));
    }
    if(m_bytes.size() >= size_of_buffer)
      flush();
  }

  void flush()
  {
    m_os.write(m_bytes.data(), static_cast<std::streamsize>(m_bytes.size()));
    m_bytes.clear();
  }

private:
  static constexpr std::size_t size_of_buffer = std::size_t(1) << 16;

  std::ostream& m_os;
  Byte_order m_order;
  std::string m_bytes;
};

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_BYTE_WRITER_H
