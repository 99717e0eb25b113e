// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_CHECKSUM_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_CHECKSUM_H

// The checksum of the store: CRC-64 with the polynomial of ECMA-182, reflected ("CRC-64/XZ"), from Boost.CRC. It finds
// damaged files and other meshes; it does not protect against a person who forges them.
//
// Why this one: a 64-bit sum of accidental changes misses one in 2^64, Boost.CRC is there with CGAL, other programs
// know the algorithm (xz has it), and a row takes a hundred times longer to compute than to sum up.

#include <boost/crc.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Appends an unsigned integer, lowest byte first on every machine. `Bytes` has push_back().
// (Compilers make one store of the loop where the machine is little endian.)
template <typename Bytes, typename Unsigned>
void append_little_endian(Bytes& bytes, Unsigned value)
{
  for(std::size_t k = 0; k < sizeof(Unsigned); ++k)
  {
    bytes.push_back(static_cast<typename Bytes::value_type>(value & 0xff));
    value = static_cast<Unsigned>(sizeof(Unsigned) > 1 ? value >> 8 : 0);
  }
}

// The bits of a floating point number. Requires: the machine has numbers of IEEE 754, as CGAL does.
inline std::uint32_t bits_of(float x)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

inline std::uint64_t bits_of(double x)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

// A number in 16 hexadecimal digits: JSON has no integers of 64 bits that every reader keeps.
inline std::string hexadecimal(std::uint64_t value)
{
  std::string text(16, '0');
  for(std::size_t k = text.size(); k-- > 0; value >>= 4)
    text[k] = "0123456789abcdef"[value & 15];
  return text;
}

// The checksum of the bytes that have been added so far.
class Checksum
{
public:
  // Takes linear time. The sum of two calls is that of one call with both pieces behind each other, so it does not
  // depend on the sizes of buffers.
  void add(const void* data, std::size_t size) { m_crc.process_bytes(data, size); }

  // Numbers count with their bits, lowest byte first.
  void add(std::uint64_t value)
  {
    std::string bytes;
    append_little_endian(bytes, value);
    add(bytes.data(), bytes.size());
  }
  // A zero and a negative zero are different here, as they are in a file.
  void add(double value) { add(bits_of(value)); }

  // Adds a text with its length, so that neighboring texts cannot be confused.
  void add(const std::string& text)
  {
    add(static_cast<std::uint64_t>(text.size()));
    add(text.data(), text.size());
  }

  // Constant time, and the object can go on adding.
  std::uint64_t value() const { return m_crc.checksum(); }
  std::string text() const { return hexadecimal(value()); }

private:
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693ULL, 0xFFFFFFFFFFFFFFFFULL, 0xFFFFFFFFFFFFFFFFULL, true, true> m_crc;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_CHECKSUM_H
