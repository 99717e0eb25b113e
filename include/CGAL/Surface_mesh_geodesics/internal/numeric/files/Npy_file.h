// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_NPY_FILE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_NPY_FILE_H

// Files of NumPy (.npy, format version 1.0): one array of numbers, little endian, in C order. The header is always 128
// bytes long, a multiple of 64 as the format asks for, so that it can be written again when the size of the array is
// known.
//
// The format: the bytes 93 'NUMPY' 1 0, the length of the rest of the header in two bytes, a dictionary of Python with
// the type, the order and the shape, blanks, and the end of a line; then the elements. NumPy, Julia, R and MATLAB have
// readers, and the elements can be mapped into memory, as they begin at a multiple of 64.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Checksum.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/System_files.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

// Visual C++ warns of functions of the C library, such as std::fopen(), for which it has others of its own.
#ifdef _MSC_VER
#pragma warning(push)
#pragma warning(disable : 4996)
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

constexpr std::size_t npy_header_size = 128;

// The first bytes of a file, for elements such as "<f8" and one or two extents.
// Two extents are those of a matrix. The dictionary is written exactly as NumPy does, blanks and commas included.
inline std::string npy_header(const std::string& element, const std::vector<std::size_t>& extents)
{
  std::string shape;
  for(const std::size_t extent : extents)
    shape += (shape.empty() ? "" : ", ") + std::to_string(extent);
  shape = '(' + shape + (extents.size() == 1 ? ",)" : ")");
  const std::string text = "{'descr': '" + element + "', 'fortran_order': False, 'shape': " + shape + ", }";
  std::string header("\x93NUMPY\x01\x00", 8);
  append_little_endian(header, static_cast<std::uint16_t>(npy_header_size - 10));
  header += text;
  CGAL_assertion(header.size() < npy_header_size);
  header.resize(npy_header_size - 1, ' ');
  return header + '\n';
}

// Writes an array under a temporary name, piece by piece; rename() gives it its name. The buffer grows up to a number
// of bytes before it is written. An object that is destroyed before removes the file.
class Npy_writer
{
public:
  // Opens the file, and writes a header to be replaced. Throws if that fails.
  Npy_writer(const std::filesystem::path& path, const std::string& element, std::size_t buffer_size)
    : m_path(path), m_temporary(temporary_name(path)), m_element(element),
      m_buffer_size((std::max)(buffer_size, std::size_t(4096)))
  {
    m_file = std::fopen(m_temporary.string().c_str(), "wb");
    if(m_file == nullptr)
      complain();
    std::setvbuf(m_file, nullptr, _IONBF, 0); // the bytes have been collected here
    try
    {
      put_bytes(npy_header(m_element, {0}));
    }
    catch(...) // no destructor runs
    {
      remove_incomplete_file();
      throw;
    }
  }

  // If the process dies before, a later one removes an incomplete file (Store_folder::remove_stale_files()).
  ~Npy_writer() { remove_incomplete_file(); }

  Npy_writer(const Npy_writer&) = delete;
  Npy_writer& operator=(const Npy_writer&) = delete;

  // Appends the bits of an element.
  template <typename Unsigned>
  void put(Unsigned bits)
  {
    append_little_endian(m_buffer, bits);
    ++m_number;
    if(m_buffer.size() + sizeof(Unsigned) > m_buffer_size)
      flush();
  }

  // With those in the buffer.
  std::size_t number_of_elements() const { return m_number; }

  // Completes the file, and returns when it is on the disk. Requires: the product of the extents is the number of
  // elements.
  void finish(const std::vector<std::size_t>& extents)
  {
    // The header comes last: a file that is cut off does not look like a complete one even under its final name.
    flush();
    if(std::fseek(m_file, 0, SEEK_SET) != 0)
      complain();
    put_bytes(npy_header(m_element, extents));
    if(!sync_stream(m_file))
      complain();
    std::FILE* const file = m_file;
    m_file = nullptr;
    if(std::fclose(file) != 0)
      complain();
  }

  // Requires: finish() has been called.
  void rename()
  {
    rename_file(m_temporary, m_path);
    m_is_renamed = true;
  }

  // The checksum of the elements; the header follows from the manifest.
  std::string checksum() const { return m_checksum.text(); }

private:
  void remove_incomplete_file() noexcept
  {
    if(m_file != nullptr)
      std::fclose(m_file);
    std::error_code error;
    if(!m_is_renamed)
      std::filesystem::remove(m_temporary, error);
  }

  // The final name is the one that the user knows.
  [[noreturn]] void complain() const { complain_of_file(m_path, "cannot be written: " + system_message()); }

  // A disk that is full shows here, or when the file is synced.
  template <typename Bytes>
  void put_bytes(const Bytes& bytes)
  {
    errno = 0;
    if(std::fwrite(bytes.data(), 1, bytes.size(), m_file) != bytes.size())
      complain();
  }

  // The sum is computed from the buffer, while its bytes are in the cache.
  void flush()
  {
    m_checksum.add(m_buffer.data(), m_buffer.size());
    put_bytes(m_buffer);
    m_buffer.clear();
  }

  // m_file is null when the file is complete; m_is_renamed tells whether the temporary name is gone.
  std::filesystem::path m_path, m_temporary;
  std::string m_element;
  std::size_t m_buffer_size;
  std::FILE* m_file = nullptr;
  std::vector<unsigned char> m_buffer;
  std::size_t m_number = 0;
  Checksum m_checksum;
  bool m_is_renamed = false;
};

// Does a file consist of this header and of elements with this checksum? False also if it cannot be read. Reads the
// whole file in pieces, which takes about as long as copying it. The size is compared first, so a file that is cut off
// costs nothing.
inline bool is_intact(const std::filesystem::path& path, const std::string& header, std::size_t bytes,
                      const std::string& checksum)
{
  std::error_code error;
  if(std::filesystem::file_size(path, error) != npy_header_size + bytes || error)
    return false;
  std::ifstream is(path, std::ios::binary);
  std::vector<char> buffer(std::size_t(1) << 18);
  is.read(buffer.data(), static_cast<std::streamsize>(npy_header_size));
  if(!is || header.compare(0, header.size(), buffer.data(), npy_header_size) != 0)
    return false;
  Checksum sum;
  while(bytes > 0)
  {
    const std::size_t size = (std::min)(bytes, buffer.size());
    if(!is.read(buffer.data(), static_cast<std::streamsize>(size)))
      return false;
    sum.add(buffer.data(), size);
    bytes -= size;
  }
  return sum.text() == checksum;
}

// Reads `number` unsigned integers of a file, which are the bits of its elements, from element `first` on.
// Opens the file for each call: for samples and single rows. Whole shards are better mapped by the reader's own means.
template <typename Unsigned>
std::vector<Unsigned> read_npy_elements(const std::filesystem::path& path, std::size_t first, std::size_t number)
{
  std::vector<unsigned char> bytes(number * sizeof(Unsigned));
  std::ifstream is(path, std::ios::binary);
  is.seekg(static_cast<std::streamoff>(npy_header_size + first * sizeof(Unsigned)));
  if(!is.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
    complain_of_file(path, "cannot be read");
  std::vector<Unsigned> result(number);
  for(std::size_t i = 0; i < number; ++i)
    for(std::size_t k = 0; k < sizeof(Unsigned); ++k)
      result[i] = static_cast<Unsigned>(result[i] | Unsigned(bytes[i * sizeof(Unsigned) + k]) << (8 * k));
  return result;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#ifdef _MSC_VER
#pragma warning(pop)
#endif

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_NPY_FILE_H
