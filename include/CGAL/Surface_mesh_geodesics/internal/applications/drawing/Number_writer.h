// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_NUMBER_WRITER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_NUMBER_WRITER_H

// Writes the numbers of a file as text or as bytes. Headers of files are text in both cases.
//
// Why both: bytes are half as many, are written faster, and are the same numbers. Text can be read by people and
// compared by programs that know nothing of the format.
//
// How a caller uses it: it writes a header to the stream, makes a Number_writer for the block that follows, writes the
// numbers of each record, and ends the record. The code is the same for both kinds of files.

#include <CGAL/IO/io.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The mode of the stream decides (CGAL::IO::set_mode()): text unless it is BINARY. In text, the numbers of a record are
// separated by blanks, and a record is a line. In binary, the order of the bytes is that of the format, whatever the
// machine has: PLY has the lowest byte first, legacy VTK the highest.
//
// Bytes are collected, as a call of a stream for each number takes longer than all else. A call of flush() or
// end_block() hands the last ones on; nothing else may be written to the stream before. There is no destructor that
// would do it, as streams may throw. The stream is referred to.
class Number_writer
{
public:
  enum class Byte_order { LOWEST_FIRST, HIGHEST_FIRST };

  Number_writer(std::ostream& os, Byte_order order) : m_os(os), m_order(order), m_is_binary(IO::is_binary(os)) {}

  Number_writer(const Number_writer&) = delete;
  Number_writer& operator=(const Number_writer&) = delete;

  // The type tells how many bytes a number takes: std::uint8_t, std::int32_t or double.
  template <typename Number>
  void write(const Number& x)
  {
    if(m_is_binary)
      write_bytes(x);
    else
      write_text(x);
  }

  // Ends a line of text. Bytes have no ends of records.
  void end_record()
  {
    if(!m_is_binary)
      m_os << '\n';
    m_is_first = true;
  }

  // Ends a block of bytes by a line break, where a format wants one. Lines of text have theirs.
  void end_block()
  {
    flush();
    if(m_is_binary)
      m_os << '\n';
  }

  // Hands the collected bytes to the stream.
  void flush()
  {
    m_os.write(m_bytes.data(), static_cast<std::streamsize>(m_bytes.size()));
    m_bytes.clear();
  }

private:
  // A multiple of what streams hold back themselves. Larger ones are not faster.
  static constexpr std::size_t size_of_buffer = std::size_t(1) << 16;

  // A byte is written as a number, not as a character.
  template <typename Number>
  void write_text(const Number& x)
  {
    if(!m_is_first)
      m_os << ' ';
    m_is_first = false;
    m_os << +x;
  }

  // The shifts give the bytes of the number in either order, on machines of both.
  template <typename Number>
  void write_bytes(const Number& x)
  {
    constexpr std::size_t n = sizeof(Number);
    static_assert(n == 1 || n == 4 || n == 8, "a number of 1, 4 or 8 bytes");
    using Bits = std::conditional_t<n == 8, std::uint64_t, std::conditional_t<n == 4, std::uint32_t, std::uint8_t>>;
    Bits bits;
    std::memcpy(&bits, &x, n);
    for(std::size_t k = 0; k < n; ++k)
    {
      const std::size_t place = m_order == Byte_order::LOWEST_FIRST ? k : n - 1 - k;
      m_bytes += static_cast<char>(static_cast<unsigned char>(bits >> (8 * place)));
    }
    if(m_bytes.size() >= size_of_buffer)
      flush();
  }

  std::ostream& m_os;
  Byte_order m_order;   // of the format
  bool m_is_binary;
  bool m_is_first = true; // in its line of text
  std::string m_bytes;    // not written yet; empty in text
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_NUMBER_WRITER_H
