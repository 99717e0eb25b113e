#ifndef SURFACE_MESH_GEODESICS_TEST_MATRIX_STORE_HELPERS_H
#define SURFACE_MESH_GEODESICS_TEST_MATRIX_STORE_HELPERS_H

// Folders for tests of stored matrices, and a reader of .npy files that shares no line with the package.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace matrix_store {

namespace fs = std::filesystem;
using namespace test_meshes;

using Options = SMG::internal::Store_options;
using Status = SMG::Geodesic_matrix_store_status;
using Store = SMG::Geodesic_distance_matrix_store;
using Store_error = SMG::Geodesic_matrix_store_error;
using Rows = std::vector<std::vector<double>>;

// The named parameters with these values.
inline auto named(const Options& options)
{
  return CGAL::parameters::use_float32(options.use_float32)
    .use_symmetry(options.use_symmetry)
    .maximum_distance(options.maximum_distance)
    .rows_per_shard(options.rows_per_shard)
    .first_row(options.first_row)
    .end_row(options.end_row)
    .memory_limit(options.memory_limit)
    .mesh_name(options.mesh_name)
    .compare_checksums(options.compare_checksums);
}

// Where temporary files are; in memory if the system has a place for that, as syncing a disk takes most of the time.
inline fs::path folder_of_temporary_files()
{
  std::error_code error;
  return fs::is_directory("/dev/shm", error) ? fs::path("/dev/shm") : fs::temp_directory_path();
}

// A new folder among the temporary files, which is removed at the end.
class Test_folder
{
public:
  explicit Test_folder(const std::string& name)
    : m_path(folder_of_temporary_files()
             / ("surface_mesh_geodesics_" + name + '_' + std::to_string(std::random_device()())))
  {
    fs::remove_all(m_path);
  }
  ~Test_folder()
  {
    std::error_code error;
    fs::remove_all(m_path, error);
  }
  Test_folder(const Test_folder&) = delete;
  Test_folder& operator=(const Test_folder&) = delete;

  const fs::path& path() const { return m_path; }
  std::string name() const { return m_path.string(); }

private:
  fs::path m_path;
};

inline std::string bytes_of(const fs::path& path)
{
  std::ifstream is(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>());
}

inline void write_bytes(const fs::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

// Removes an entry from the manifest of a store, with what follows up to the hash.
inline void remove_from_manifest(const fs::path& folder, const std::string& name)
{
  const fs::path manifest = folder / "manifest.json";
  std::string text = bytes_of(manifest);
  const std::size_t begin = text.find('"' + name + '"');
  text.erase(begin, text.find("\"hash\"", begin) - begin);
  write_bytes(manifest, text);
}

// The files of a folder with one ending, sorted by name.
inline std::vector<fs::path> files_with(const fs::path& folder, const std::string& ending)
{
  std::vector<fs::path> result;
  for(const auto& each : fs::directory_iterator(folder))
  {
    const std::string name = each.path().filename().string();
    if(name.size() >= ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
    {
      result.push_back(each.path());
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

// All files of a folder, with their bytes.
inline std::vector<std::pair<std::string, std::string>> contents(const fs::path& folder)
{
  std::vector<std::pair<std::string, std::string>> result;
  for(const fs::path& path : files_with(folder, ""))
  {
    result.emplace_back(path.filename().string(), bytes_of(path));
  }
  return result;
}

// An array of a file of NumPy: the text of its header, and its elements.
struct Npy
{
  std::string text;
  std::vector<double> elements;
};

template <typename Number>
std::vector<double> decoded(const std::string& bytes, std::size_t begin)
{
  std::vector<double> result;
  for(std::size_t i = begin; i + sizeof(Number) <= bytes.size(); i += sizeof(Number))
  {
    Number x;
    std::memcpy(&x, bytes.data() + i, sizeof x); // the tests run on little endian machines
    result.push_back(static_cast<double>(x));
  }
  return result;
}

inline Npy read_npy(const fs::path& path)
{
  const std::string bytes = bytes_of(path);
  Npy array;
  CHECK(bytes.size() >= 10 && bytes.compare(0, 8, std::string("\x93NUMPY\x01\x00", 8)) == 0);
  const std::size_t length = static_cast<unsigned char>(bytes.at(8)) + 256u * static_cast<unsigned char>(bytes.at(9));
  CHECK_EQUAL((10 + length) % 64, 0u);
  CHECK_EQUAL(bytes.at(9 + length), '\n');
  array.text = bytes.substr(10, bytes.find('}', 10) - 9);
  if(array.text.find("'<f4'") != std::string::npos)
  {
    array.elements = decoded<float>(bytes, 10 + length);
  }
  else if(array.text.find("'<f8'") != std::string::npos)
  {
    array.elements = decoded<double>(bytes, 10 + length);
  }
  else
  {
    CHECK(array.text.find("'<i4'") != std::string::npos);
    array.elements = decoded<int>(bytes, 10 + length);
  }
  return array;
}

inline Rows expected_matrix(const Mesh& tm)
{
  Rows rows;
  SMG::geodesic_distance_matrix(tm, vertices(tm), vertices(tm),
                                [&](std::size_t, const std::vector<double>& row) { rows.push_back(row); });
  return rows;
}

// All numbers of a folder with a whole matrix, read without the package.
inline std::vector<double> stored_numbers(const fs::path& folder)
{
  std::vector<double> result;
  for(const fs::path& path : files_with(folder, ".npy"))
  {
    const std::vector<double> part = read_npy(path).elements;
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

inline std::vector<double> flat(const Rows& rows)
{
  std::vector<double> result;
  for(const std::vector<double>& row : rows)
  {
    result.insert(result.end(), row.begin(), row.end());
  }
  return result;
}

// Nothing is left but the manifest and arrays.
inline void check_is_tidy(const fs::path& folder)
{
  CHECK_EQUAL(files_with(folder, ".npy").size() + 1, files_with(folder, "").size());
  CHECK(fs::exists(folder / "manifest.json"));
}

// --- calls ---

// Counts rows, and cancels after a number of computed ones.
struct Row_visitor
  : SMG::Geodesic_default_visitor
{
  void on_rows(std::size_t c, std::size_t f, std::size_t n)
  {
    CHECK(c + f > computed + found && c + f <= n);
    computed = c;
    found = f;
  }
  void on_progress(std::size_t number, double) { CHECK_EQUAL(number, computed + found); }
  bool go_further() { return computed < most; }

  std::size_t computed = 0, found = 0, most = std::size_t(-1);
};

inline Status store_all(const Mesh& tm, const Test_folder& folder, const Options& options, Row_visitor& visitor)
{
  return SMG::store_geodesic_distance_matrix(tm, vertices(tm), vertices(tm), folder.name(),
                                             named(options).visitor(std::ref(visitor)));
}

inline Status store_all(const Mesh& tm, const Test_folder& folder, const Options& options)
{
  Row_visitor visitor;
  return store_all(tm, folder, options, visitor);
}

inline Options shards_of_five_rows()
{
  Options options;
  options.rows_per_shard = 5;
  return options;
}

template <typename Function>
std::string message_of(Store_error::Reason reason, Function function)
{
  std::string message;
  try
  {
    function();
  }
  catch(const Store_error& error)
  {
    CHECK(error.reason() == reason);
    message = error.what();
  }
  CHECK(!message.empty()); // otherwise nothing was thrown
  return message;
}

} // namespace matrix_store

#endif // SURFACE_MESH_GEODESICS_TEST_MATRIX_STORE_HELPERS_H
