// Stored matrices: the bits of the files, going on with what is missing, damaged files, and what does not fit a folder.

#include "expected_exceptions.h"
#include "matrix_store_helpers.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <thread>

using namespace matrix_store;
using CGAL::Surface_mesh_geodesics::internal::Json_reader;

namespace {

// --- what the files contain ---

void whole_rows()
{
  test_support::Scope scope("whole rows");
  const Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  const Rows expected = expected_matrix(tm);
  const std::size_t n = expected.size();
  Test_folder folder("rows");
  const Options options = shards_of_five_rows();
  const Status status = store_all(tm, folder, options);
  CHECK(status.is_complete());
  CHECK_EQUAL(status.rows, n);
  CHECK_EQUAL(status.shards, (n + 4) / 5);
  CHECK(stored_numbers(folder.path()) == flat(expected)); // infinite ones, too
  check_is_tidy(folder.path());
  const fs::path first = folder.path() / "rows_000000_000005.npy";
  CHECK_EQUAL(read_npy(first).text,
              "{'descr': '<f8', 'fortran_order': False, 'shape': (5, " + std::to_string(n) + "), }");
  CHECK_EQUAL(fs::file_size(first), 128 + 5 * n * 8);
  const Store store(folder.name());
  for(std::size_t i = 0; i < n; ++i)
  {
    CHECK(store.row(i) == expected[i]);
  }
  const auto check = SMG::check_geodesic_distance_matrix(tm, folder.name(), 20);
  CHECK_EQUAL(check.rows_compared, (std::min)(n, std::size_t(20)));
  CHECK_EQUAL(check.rows_different, 0u);
  CHECK(check.pairs_compared > 0 && check.triangles_checked > 0);
  CHECK(check.worst_asymmetry < 1e-14 && check.worst_triangle_violation < 1e-14);
}

void single_precision()
{
  test_support::Scope scope("float");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 5));
  Rows expected = expected_matrix(tm);
  for(std::vector<double>& row : expected)
  {
    for(double& x : row)
    {
      x = static_cast<float>(x);
    }
  }
  Test_folder folder("float");
  Options options;
  options.use_float32 = true;
  CHECK(store_all(tm, folder, options).is_complete());
  CHECK(stored_numbers(folder.path()) == flat(expected));
  CHECK_EQUAL(SMG::check_geodesic_distance_matrix(tm, folder.name()).rows_different, 0u);

  Mesh large = tm;
  for(const vertex_descriptor v : vertices(large))
  {
    large.point(v) = Kernel::Point_3(1e39 * tm.point(v).x(), 1e39 * tm.point(v).y(), 1e39 * tm.point(v).z());
  }
  Test_folder other("large");
  message_of(Store_error::Reason::NOT_REPRESENTABLE, [&] { store_all(large, other, options); });
  CHECK(files_with(other.path(), ".npy").empty() && files_with(other.path(), ".tmp").empty());
  for(const vertex_descriptor v : vertices(large))
  {
    large.point(v) = Kernel::Point_3(1e-60 * tm.point(v).x(), 1e-60 * tm.point(v).y(), 1e-60 * tm.point(v).z());
  }
  Test_folder small("small");
  message_of(Store_error::Reason::NOT_REPRESENTABLE, [&] { store_all(large, small, options); });
}

void upper_triangle()
{
  test_support::Scope scope("upper triangle");
  const Mesh tm = to_face_graph(icosphere(1));
  const Rows expected = expected_matrix(tm);
  std::vector<double> numbers;
  Test_folder folder("triangle");
  Options options;
  options.use_symmetry = true;
  options.rows_per_shard = 4;
  CHECK(store_all(tm, folder, options).is_complete());
  const Store store(folder.name());
  for(std::size_t i = 0; i < expected.size(); ++i)
  {
    const std::vector<double> row(expected[i].begin() + static_cast<std::ptrdiff_t>(i) + 1, expected[i].end());
    numbers.insert(numbers.end(), row.begin(), row.end());
    CHECK(store.row(i) == row);
  }
  CHECK(stored_numbers(folder.path()) == numbers);
  const auto check = SMG::check_geodesic_distance_matrix(tm, folder.name());
  CHECK_EQUAL(check.rows_different, 0u);
  CHECK_EQUAL(check.pairs_compared, 45u); // the runs from both ends of each pair of ten samples
  CHECK(check.worst_asymmetry < 1e-14 && check.worst_triangle_violation < 1e-14);
  const std::vector<vertex_descriptor> some{vertex(1)};
  message_of(Store_error::Reason::INVALID_OPTION, [&]
             { SMG::store_geodesic_distance_matrix(tm, some, vertices(tm), folder.name(), named(options)); });
  options.maximum_distance = 1;
  message_of(Store_error::Reason::INVALID_OPTION, [&] { store_all(tm, folder, options); });
  // An array job may have more tasks than there are rows: the last ones compute nothing, and say so.
  options = Options();
  Test_folder other("behind the end");
  options.first_row = num_vertices(tm);
  const auto none = store_all(tm, other, options);
  CHECK_EQUAL(none.rows, 0u);
  CHECK_EQUAL(none.rows_done, 0u);
}

// A row that is longer than any row is damaged; no memory is asked for it.
void a_damaged_row_is_not_read(const Test_folder& folder, const fs::path& pointers)
{
  std::string bytes = bytes_of(pointers);
  bytes.replace(bytes.size() - 4, 4, "\xff\xff\xff\x7f");
  write_bytes(pointers, bytes);
  try
  {
    Store(folder.name()).sparse_row(9);
    CHECK(false);
  }
  catch(const Store_error& e)
  {
    CHECK(e.reason() == Store_error::Reason::DAMAGED);
  }
}

void within_radius()
{
  test_support::Scope scope("within a radius");
  const Mesh tm = to_face_graph(icosphere(1));
  const Rows expected = expected_matrix(tm);
  Test_folder folder("radius");
  Options options;
  options.maximum_distance = .8;
  options.rows_per_shard = 10;
  CHECK(store_all(tm, folder, options).is_complete());
  const Store store(folder.name());
  const std::vector<fs::path> pointers = files_with(folder.path(), ".indptr.npy"),
                              columns = files_with(folder.path(), ".indices.npy"),
                              data = files_with(folder.path(), ".data.npy");
  CHECK_EQUAL(pointers.size(), 5u);
  std::size_t i = 0;
  for(std::size_t s = 0; s < pointers.size(); ++s)
  {
    const Npy begin = read_npy(pointers[s]), column = read_npy(columns[s]), distance = read_npy(data[s]);
    CHECK_EQUAL(begin.elements.front(), 0.);
    CHECK_EQUAL(begin.elements.back(), static_cast<double>(distance.elements.size()));
    for(std::size_t r = 0; r + 1 < begin.elements.size(); ++r, ++i)
    {
      Store::Sparse_row row, expected_row;
      const auto end = static_cast<std::size_t>(begin.elements[r + 1]);
      for(auto k = static_cast<std::size_t>(begin.elements[r]); k < end; ++k)
      {
        row.emplace_back(static_cast<std::size_t>(column.elements[k]), distance.elements[k]);
      }
      for(std::size_t j = 0; j < expected.size(); ++j)
      {
        if(expected[i][j] <= .8)
        {
          expected_row.emplace_back(j, expected[i][j]);
        }
      }
      CHECK(row == expected_row);
      CHECK(store.sparse_row(i) == expected_row);
    }
  }
  CHECK_EQUAL(i, expected.size());
  const auto check = SMG::check_geodesic_distance_matrix(tm, folder.name(), 1000);
  CHECK_EQUAL(check.rows_compared, expected.size());
  CHECK_EQUAL(check.rows_different, 0u);
  CHECK(check.pairs_compared > 0 && check.worst_asymmetry < 1e-14 && check.worst_triangle_violation < 1e-14);
  a_damaged_row_is_not_read(folder, pointers[0]);
  // Samples are near each other, however small the radius is.
  const Mesh fine = to_face_graph(icosphere(3));
  Test_folder small("small_radius");
  options.maximum_distance = .2;
  CHECK(store_all(fine, small, options).is_complete());
  const auto near = SMG::check_geodesic_distance_matrix(fine, small.name());
  CHECK(near.rows_compared == 10 && near.rows_different == 0);
  CHECK(near.pairs_compared >= 3 && near.triangles_checked > 20);
}

// Faces are named by their indices, so another map is another mesh.
void other_indices_of_faces_are_rejected()
{
  test_support::Scope scope("indices of faces");
  const Mesh tm = to_face_graph(icosphere(1));
  const std::size_t n = num_faces(tm);
  const std::vector<Face_location> sources{{face(10), {.2, .3, .5}}};
  Test_folder folder("faces");
  const auto store = [&](bool is_reversed)
  {
    const auto map = boost::make_function_property_map<Mesh::Face_index>(
      [=](Mesh::Face_index f) { return is_reversed ? n - 1 - std::size_t(f) : std::size_t(f); });
    SMG::store_geodesic_distance_matrix(tm, sources, vertices(tm), folder.name(),
                                        CGAL::parameters::face_index_map(map));
  };
  store(false);
  message_of(Store_error::Reason::DIFFERENT_MESH, [&] { store(true); });
}

void locations_and_targets()
{
  test_support::Scope scope("locations");
  const Mesh tm = to_face_graph(icosphere(1));
  const std::vector<Face_location> sources{{face(3), {.2, .3, .5}}, {face(7), {0, .5, .5}}, {face(9), {1, 0, 0}}};
  const std::vector<vertex_descriptor> targets{vertex(5), vertex(1), vertex(5)};
  Rows expected;
  SMG::geodesic_distance_matrix(tm, sources, targets, [&](std::size_t, const auto& row) { expected.push_back(row); });
  Test_folder folder("locations");
  CHECK(SMG::store_geodesic_distance_matrix<CGAL::Parallel_if_available_tag>(tm, sources, targets, folder.name())
          .is_complete());
  CHECK(stored_numbers(folder.path()) == flat(expected));
  CHECK_EQUAL(SMG::check_geodesic_distance_matrix(tm, folder.name()).rows_different, 0u);
  // Coordinates of float are those of the nearest valid point.
  using Coarse = std::pair<face_descriptor, std::array<float, 3>>;
  Test_folder coarse("coarse");
  CHECK(SMG::store_geodesic_distance_matrix(tm, std::vector<Coarse>{{face(3), {{.1f, .2f, .7f}}}}, targets,
                                            coarse.name())
          .is_complete());
  CHECK_EQUAL(SMG::check_geodesic_distance_matrix(tm, coarse.name()).rows_different, 0u);
  Test_folder empty("empty");
  CHECK(SMG::store_geodesic_distance_matrix(tm, std::vector<vertex_descriptor>(), targets, empty.name()).is_complete());
  CHECK_EQUAL(Store(empty.name()).status().shards, 0u);
}

// Distances between the vertices of a short edge are rounded in parts of the long edges.
void needles_pass_the_check()
{
  test_support::Scope scope("needles");
  Indexed_mesh fan;
  test_support::Random random(1);
  const int n = 40;
  fan.points.push_back({{0, 0, 0}});
  for(int k = 0; k <= n; ++k)
  {
    const double angle = 1e-9 * k;
    const double radius = random.uniform(1, 1 + 5e-9);
    fan.points.push_back({{radius * std::cos(angle), radius * std::sin(angle), 0}});
  }
  for(std::size_t k = 1; k <= n; ++k)
  {
    fan.faces.push_back({0, k, k + 1});
  }
  const Mesh tm = to_face_graph(fan);
  for(const bool use_float32 : {false, true})
  {
    Test_folder folder("needles");
    Options options;
    options.use_float32 = use_float32;
    CHECK(store_all(tm, folder, options).is_complete());
    const auto check = SMG::check_geodesic_distance_matrix(tm, folder.name(), 1000);
    CHECK_EQUAL(check.rows_different, 0u);
    CHECK(check.worst_asymmetry < (use_float32 ? 1e-7 : 1e-14));
    CHECK(check.worst_triangle_violation < (use_float32 ? 2e-7 : 1e-14));
  }
}

// --- several calls ---

void later_calls_compute_what_is_missing()
{
  test_support::Scope scope("later calls");
  const Mesh tm = to_face_graph(icosphere(2));
  const std::size_t n = num_vertices(tm);
  const std::vector<double> expected = flat(expected_matrix(tm));
  Test_folder folder("later");
  Options options;
  options.rows_per_shard = 8;
  Row_visitor first;
  first.most = 20; // two shards and a half
  CHECK_EQUAL(store_all(tm, folder, options, first).rows_done, 16u);
  check_is_tidy(folder.path());
  CHECK_EQUAL(files_with(folder.path(), ".npy").size(), 2u);
  message_of(Store_error::Reason::NOT_STORED, [&] { Store(folder.name()).row(16); });

  Options range = options;
  range.first_row = 30; // shards begin at 32, ..., 56
  range.end_row = 60;
  range.rows_per_shard = 3; // the folder has another number
  Row_visitor second;
  const Status status = store_all(tm, folder, range, second);
  CHECK(status.is_complete());
  CHECK_EQUAL(status.rows, 32u);
  CHECK_EQUAL(second.computed, 32u);

  Row_visitor third;
  CHECK(store_all(tm, folder, options, third).is_complete());
  CHECK_EQUAL(third.found, 48u);
  CHECK_EQUAL(third.computed, n - 48);
  CHECK(stored_numbers(folder.path()) == expected);

  // Files that are damaged, cut off or gone are computed again, and nothing else.
  const std::vector<fs::path> files = files_with(folder.path(), ".npy");
  std::string bytes = bytes_of(files[1]);
  bytes[500] = static_cast<char>(bytes[500] ^ 1);
  write_bytes(files[1], bytes);
  write_bytes(files[3], bytes_of(files[3]).substr(0, 1000));
  fs::remove(files[4]);
  bytes = bytes_of(files[6]);
  bytes[20] = 'x'; // in the header
  write_bytes(files[6], bytes);
  CHECK_EQUAL(Store(folder.name()).damaged_shards().size(), 4u);
  CHECK(Store(folder.name()).damaged_shards()[0] == std::make_pair(std::size_t(8), std::size_t(16)));
  Row_visitor fourth;
  CHECK(store_all(tm, folder, options, fourth).is_complete());
  CHECK_EQUAL(fourth.computed, 32u);
  CHECK(Store(folder.name()).damaged_shards().empty());
  CHECK(stored_numbers(folder.path()) == expected);
  check_is_tidy(folder.path());
}

void other_matrices_are_rejected()
{
  test_support::Scope scope("other matrices");
  const Mesh tm = to_face_graph(icosphere(1));
  Test_folder folder("other");
  CHECK(store_all(tm, folder, Options()).is_complete());
  const auto before = contents(folder.path());
  Mesh moved = tm;
  moved.point(vertex(3)) = Kernel::Point_3(1.001 * tm.point(vertex(3)).x(), tm.point(vertex(3)).y(),
                                           tm.point(vertex(3)).z());
  const std::string text
    = message_of(Store_error::Reason::DIFFERENT_MESH, [&] { store_all(moved, folder, Options()); });
  CHECK(text.find(Store(folder.name()).mesh_hash()) != std::string::npos);
  message_of(Store_error::Reason::DIFFERENT_MESH, [&] { SMG::check_geodesic_distance_matrix(moved, folder.name()); });
  Options options;
  options.use_float32 = true;
  message_of(Store_error::Reason::DIFFERENT_MATRIX, [&] { store_all(tm, folder, options); });
  options = Options();
  options.maximum_distance = .5;
  message_of(Store_error::Reason::DIFFERENT_MATRIX, [&] { store_all(tm, folder, options); });
  const std::vector<vertex_descriptor> some{vertex(1), vertex(0)};
  message_of(Store_error::Reason::DIFFERENT_MATRIX, [&]
             { SMG::store_geodesic_distance_matrix(tm, some, vertices(tm), folder.name()); });
  message_of(Store_error::Reason::DIFFERENT_MATRIX, [&]
             { SMG::store_geodesic_distance_matrix(tm, vertices(tm), some, folder.name()); });
  CHECK(contents(folder.path()) == before);
  options.maximum_distance = -1;
  CHECK(throws_reason(Reason::INVALID_RADIUS, [&] { store_all(tm, folder, options); }));
  message_of(Store_error::Reason::NOT_A_STORE, [&] { Store store(folder.name() + "/none"); });
  message_of(Store_error::Reason::INVALID_OPTION, [&] { Store store(std::string(folder.name()) + '\0' + "more"); });
  write_bytes(folder.path() / "manifest.json", before[0].second.substr(0, 300));
  const std::string message = message_of(Store_error::Reason::NOT_A_STORE, [&] { Store store(folder.name()); });
  CHECK_EQUAL(message.find((folder.path() / "manifest.json").string()), 0u);
  std::string bytes = before[0].second;
  bytes.replace(bytes.find("\"float64\""), 9, "\"float32\"");
  write_bytes(folder.path() / "manifest.json", bytes);
  message_of(Store_error::Reason::NOT_A_STORE, [&] { Store store(folder.name()); });
}

// Any number of threads, with little memory and with much: the same files.
void threads()
{
  test_support::Scope scope("threads");
  const Mesh tm = to_face_graph(icosphere(2));
  Options options;
  options.rows_per_shard = 7;
  Test_folder sequential("sequential");
  CHECK(store_all(tm, sequential, options).is_complete());
#ifdef CGAL_LINKED_WITH_TBB
  for(const int n : {1, 2, 5})
  {
    options.memory_limit = n == 5 ? 10000 : 1 << 20;
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(n));
    tbb::task_arena arena(n);
    Test_folder folder("threads");
    Row_visitor visitor;
    arena.execute([&] {
      CHECK(SMG::store_geodesic_distance_matrix<CGAL::Parallel_tag>(
              tm, vertices(tm), vertices(tm), folder.name(), named(options).visitor(std::ref(visitor)))
              .is_complete());
    });
    CHECK_EQUAL(visitor.computed, num_vertices(tm));
    CHECK(contents(folder.path()) == contents(sequential.path()));
  }
#endif
  // Two calls at once for one folder: together they compute each shard once.
  Test_folder folder("two_calls");
  Row_visitor visitors[2];
  std::thread other([&] { store_all(tm, folder, options, visitors[0]); });
  store_all(tm, folder, options, visitors[1]);
  other.join();
  CHECK_EQUAL(visitors[0].computed + visitors[1].computed, num_vertices(tm));
  CHECK(contents(folder.path()) == contents(sequential.path()));
}

// --- JSON ---

void texts_of_json()
{
  test_support::Scope scope("JSON");
  for(const char* good : {"{}", "[]", "\"a\"", " [1, -2.5e-3, 0] ", "{\"a\": {\"b\": [\"x\", []]}}", "0.1", "-0",
                          "1e300", "\"\\u0007\\n\\\\\\\"/\"", "\"\xc3\xa4\"", "true", "[false, null]"})
  {
    const auto value = Json_reader(good).read();
    CHECK_EQUAL(Json_reader(value.written()).read().written(), value.written());
  }
  for(const char* bad : {"", "{", "[1,]", "[1 2]", "{\"a\":1,}", "{a:1}", "{\"a\":1,\"a\":2}", "01", "+1", ".5",
                         "1.", "1e", "nan", "inf", "1e999", "tru", "True", "nul", "truefalse",
                         "\"a", "\"\n\"", "\"\\x\"", "\"\\u12\"", "\"\\ud83d\"", "\"\\ud83d\\u0041\"", "\"\\ude00\"",
                         "[1] 2", "-", "--1", "0x10"})
  {
    CHECK(throws<Store_error>([&] { Json_reader(bad).read(); }));
  }
  CHECK(throws<Store_error>([] { Json_reader(std::string(1000, '[')).read(); }));
  // As Python's json module writes it: characters of one to four bytes in UTF-8.
  const std::string escaped = "\"\\u0041\\u00e4\\u20ac\\ud83d\\ude00\"";
  CHECK_EQUAL(Json_reader(escaped).read().text(), "A\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80");
  // Names of files may be no UTF-8: single bytes, more bytes than needed, halves of characters, codes beyond the last.
  const std::string bytes
    = "\xff/\xc3\xa4\xc3/\xc0\xaf\xe0\x80\x80\xed\xa0\x80\xf4\x90\x80\x80\xf0\x9f\x98\x80\xe2\x82";
  const std::string written = CGAL::Surface_mesh_geodesics::internal::Json_value(bytes).written();
  CHECK_EQUAL(Json_reader(written).read().text(), bytes);
  CHECK_EQUAL(written.substr(1, 13), "\\udcff/\xc3\xa4\\udc");
  CHECK_EQUAL(written.substr(written.size() - 17), "\xf0\x9f\x98\x80\\udce2\\udc82\"");
  test_support::Random random(1);
  for(int k = 0; k < 1000; ++k)
  {
    const double x = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.index(2000)) - 1000);
    CHECK_EQUAL(Json_reader(CGAL::Surface_mesh_geodesics::internal::Json_value(x).written()).read().number(), x);
  }
  CHECK(std::signbit(Json_reader(CGAL::Surface_mesh_geodesics::internal::Json_value(-0.).written()).read().number()));
}

} // namespace

int main()
{
  whole_rows();
  single_precision();
  upper_triangle();
  within_radius();
  other_indices_of_faces_are_rejected();
  locations_and_targets();
  needles_pass_the_check();
  later_calls_compute_what_is_missing();
  other_matrices_are_rejected();
  threads();
  texts_of_json();
  return test_result();
}
