// Edges to avoid of matrices of distances: rows are those of geodesic_distances(), the folder of a stored matrix knows
// the edges, and its check finds them there.

#include "expected_exceptions.h"
#include "matrix_store_helpers.h"
#include "test_meshes.h"
#include "test_support.h"
#include "walls_and_places.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace matrix_store;
namespace np = CGAL::parameters;
using SMG::Invalid_geodesic_input;

namespace {

using Distances = std::map<vertex_descriptor, double>;
using Solver = SMG::Geodesic_distance_solver<Mesh>;
using Edges = std::vector<edge_descriptor>;

// --- rows ---

// Dense and sparse rows from places on walls and beside them, to all vertices and to some of them twice.
template <typename ConcurrencyTag>
void check_rows(const Case& c, test_support::Random& random)
{
  std::vector<Face_location> sources;
  std::vector<Distances> expected;
  for(std::size_t i = 0; i < 5; ++i)
  {
    const Place p = random_place(c.tm, c.removed, random);
    sources.push_back(p.location);
    expected.push_back(c.expected({{p.vertex, p.location, false}}));
  }
  std::vector<vertex_descriptor> targets(vertices(c.tm).begin(), vertices(c.tm).end());
  targets.insert(targets.end(), targets.begin(), targets.begin() + 5);
  const auto parameters = np::edges_to_avoid(c.range).faces_to_avoid(c.avoided);
  Rows rows;
  SMG::geodesic_distance_matrix<ConcurrencyTag>(
    c.tm, sources, targets, [&](std::size_t, const std::vector<double>& row) { rows.push_back(row); }, parameters);
  CHECK_EQUAL(rows.size(), sources.size());
  for(std::size_t i = 0; i < rows.size(); ++i)
    for(std::size_t j = 0; j < targets.size(); ++j)
      CHECK_CLOSE(rows[i][j], expected[i].at(targets[j]), 1e-12);
  // The solver that has read the mesh gives the same bits.
  Rows of_solver;
  SMG::geodesic_distance_matrix<ConcurrencyTag>(
    Solver::avoiding_edges(c.tm, c.range, c.avoided), sources, targets,
    [&](std::size_t, const std::vector<double>& row) { of_solver.push_back(row); });
  CHECK(of_solver == rows);
  const double radius = .8;
  SMG::sparse_geodesic_distance_matrix<ConcurrencyTag>(
    c.tm, sources, targets, radius,
    [&](std::size_t i, const std::vector<std::pair<std::size_t, double>>& row)
    {
      std::vector<std::pair<std::size_t, double>> within;
      for(std::size_t j = 0; j < targets.size(); ++j)
        if(rows[i][j] <= radius)
          within.emplace_back(j, rows[i][j]);
      CHECK(row == within);
    },
    parameters);
}

// The distances of all pairs, in the order of peeling; also of a solver.
void check_pairs(const Case& c)
{
  const auto parameters = np::edges_to_avoid(c.range).faces_to_avoid(c.avoided);
  // A vertex inside of the faces to avoid is no source.
  std::vector<vertex_descriptor> sources;
  for(const vertex_descriptor v : vertices(c.tm))
    if(c.tm.is_isolated(v) || std::any_of(halfedges_around_target(v, c.tm).begin(),
                                           halfedges_around_target(v, c.tm).end(), [&](halfedge_descriptor h)
                                           { return !is_border(h, c.tm) && c.removed.count(face(h, c.tm)) == 0; }))
      sources.push_back(v);
  const auto order = SMG::geodesic_peeling_order(c.tm, sources, parameters);
  CHECK_EQUAL(std::set<vertex_descriptor>(order.begin(), order.end()).size(), sources.size());
  Rows rows, of_solver;
  SMG::symmetric_geodesic_distance_matrix(
    c.tm, order, [&](std::size_t, const std::vector<double>& row) { rows.push_back(row); }, parameters);
  if(num_faces(c.tm) < 1000)
  {
    SMG::symmetric_geodesic_distance_matrix(
      Solver::avoiding_edges(c.tm, c.range, c.avoided), order,
      [&](std::size_t, const std::vector<double>& row) { of_solver.push_back(row); });
    CHECK(of_solver == rows);
  }
  CHECK_EQUAL(rows.size(), order.size());
  for(std::size_t i = 0; i < rows.size(); i += 23)
  {
    Distances distance;
    SMG::geodesic_distances(c.tm, boost::make_assoc_property_map(distance), order[i], parameters);
    CHECK_EQUAL(rows[i].size(), order.size() - i);
    for(std::size_t k = 0; k < rows[i].size(); ++k)
      CHECK_EQUAL(rows[i][k], distance.at(order[i + k]));
  }
}

void test_rows()
{
  test_support::Random random(3);
  for_each_case(random, [&](const Case& c, std::size_t i)
  {
    check_rows<CGAL::Sequential_tag>(c, random);
    check_rows<CGAL::Parallel_if_available_tag>(c, random);
    if(i % 3 != 2)
      check_pairs(c);
  });
}

// So many sources that landmarks would be used without walls: they rest on the triangle inequality.
void test_many_sources()
{
  const test_support::Scope scope("many sources");
  test_support::Random random(9);
  const Mesh tm = to_face_graph(icosphere(3));
  CHECK(num_vertices(tm) > 600);
  const Walls walls = random_walls(tm, .2, random);
  check_pairs(Case{tm, walls, {}});
}

// --- stored matrices ---

Options options_of_shards()
{
  Options options;
  options.rows_per_shard = 20;
  return options;
}

// All kinds of matrices, with locations as sources: rows are those of the other functions, and the folder goes on with
// the edges in another order, as a map, and with others that cut nothing.
void test_stored_rows()
{
  const test_support::Scope scope("stored rows");
  test_support::Random random(5);
  Mesh tm = to_face_graph(flat_patch(6, 6, .15, true, 2));
  const Walls walls = random_walls(tm, .2, random);
  Edges range;
  for(const edge_descriptor e : walls)
    if(!is_border(e, tm))
      range.push_back(e);
  Rows expected;
  SMG::geodesic_distance_matrix(tm, vertices(tm), vertices(tm),
                                [&](std::size_t, const std::vector<double>& row) { expected.push_back(row); },
                                np::edges_to_avoid(range));
  for(const bool is_symmetric : {false, true})
  {
    Options options = options_of_shards();
    options.use_symmetry = is_symmetric;
    const Test_folder folder("walls");
    const auto store_in = [&](const auto& parameters)
    { return SMG::store_geodesic_distance_matrix(tm, vertices(tm), vertices(tm), folder.name(), parameters); };
    CHECK(store_in(named(options).edges_to_avoid(range).end_row(20)).rows_done == 20);
    const auto is_wall = boost::make_function_property_map<edge_descriptor>([&](edge_descriptor e)
                                                                             { return walls.count(e) != 0; });
    CHECK(store_in(named(options).edges_to_avoid(is_wall)).is_complete());
    CHECK(store_in(named(options).edges_to_avoid(Edges(range.rbegin(), range.rend()))).is_complete());
    const Store store(folder.name());
    CHECK_EQUAL(store.edges_to_avoid().size(), range.size());
    CHECK(std::is_sorted(store.edges_to_avoid().begin(), store.edges_to_avoid().end()));
    for(const std::array<std::size_t, 2>& e : store.edges_to_avoid())
    {
      auto h = halfedge(face_descriptor(static_cast<Mesh::size_type>(e[0])), tm);
      for(std::size_t k = 0; k < e[1]; ++k)
        h = next(h, tm);
      CHECK(walls.count(edge(h, tm)) == 1);
    }
    for(std::size_t i = 0; i < expected.size(); ++i)
      CHECK(store.row(i) == (is_symmetric ? std::vector<double>(expected[i].begin() + std::ptrdiff_t(i) + 1,
                                                                expected[i].end()) : expected[i]));
    // The folder tells the edges to the check. Triangles over vertices that are divided are no triangles.
    const auto check = SMG::check_geodesic_distance_matrix(tm, folder.name(), 30);
    CHECK_EQUAL(check.rows_compared, 30u);
    CHECK_EQUAL(check.rows_different, 0u);
    CHECK(check.worst_asymmetry < 1e-14 && check.worst_triangle_violation < 1e-14 && check.triangles_checked > 0);
  }
  const Test_folder sparse("sparse_walls");
  std::vector<Face_location> sources;
  for(std::size_t i = 0; i < 30; ++i)
    sources.push_back(random_place(tm, {}, random).location);
  Options options = options_of_shards();
  options.maximum_distance = .6;
  CHECK(SMG::store_geodesic_distance_matrix(tm, sources, vertices(tm), sparse.name(),
                                            named(options).edges_to_avoid(range)).is_complete());
  const Store store(sparse.name());
  CHECK_EQUAL(store.number_of_rows(), sources.size());
  SMG::sparse_geodesic_distance_matrix(tm, sources, vertices(tm), .6,
                                       [&](std::size_t i, const Store::Sparse_row& row)
                                       { CHECK(store.sparse_row(i) == row); },
                                       np::edges_to_avoid(range));
  CHECK_EQUAL(SMG::check_geodesic_distance_matrix(tm, sparse.name(), 10).rows_different, 0u);
}

std::string message_of(Store_error::Reason reason, const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch(const Store_error& error)
  {
    CHECK(error.reason() == reason);
    return error.what();
  }
  CHECK(false);
  return "";
}

// A folder belongs to its walls, and a manifest that has lost them, or names edges that are not there, is rejected.
void test_stores_with_other_walls()
{
  const test_support::Scope scope("other walls");
  test_support::Random random(6);
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  const Walls walls = random_walls(tm, .1, random);
  const Edges range(walls.begin(), walls.end());
  const Test_folder folder("walls"), whole("whole"), none("none");
  const auto store_in = [&](const Test_folder& f, const Edges& edges)
  {
    return SMG::store_geodesic_distance_matrix(tm, vertices(tm), vertices(tm), f.name(),
                                               named(options_of_shards()).edges_to_avoid(edges));
  };
  CHECK(store_in(folder, range).is_complete() && store_in(whole, {}).is_complete());
  CHECK(bytes_of(whole.path() / "manifest.json").find("avoid") == std::string::npos);
  CHECK(Store(whole.name()).edges_to_avoid().empty());
  const auto before = contents(folder.path());
  message_of(Store_error::Reason::DIFFERENT_MATRIX, [&] { store_in(folder, {}); });
  message_of(Store_error::Reason::DIFFERENT_MATRIX, [&] { store_in(whole, range); });
  message_of(Store_error::Reason::DIFFERENT_MATRIX, [&] { store_in(folder, Edges(range.begin() + 1, range.end())); });
  CHECK(contents(folder.path()) == before);
  CHECK(throws<Invalid_geodesic_input>([&] { store_in(none, Edges{edge_descriptor(50000)}); }));
  CHECK(!fs::exists(none.path()));
  remove_from_manifest(folder.path(), "edges_to_avoid");
  message_of(Store_error::Reason::NOT_A_STORE, [&] { Store damaged(folder.name()); });
  const auto fim = get(boost::face_index, tm);
  const std::vector<face_descriptor> of_index(faces(tm).begin(), faces(tm).end());
  for(const std::array<std::size_t, 2>& bad : {std::array<std::size_t, 2>{0, 3}, {num_faces(tm), 0}})
    message_of(Store_error::Reason::NOT_A_STORE, [&] { SMG::internal::named_walls(tm, fim, of_index, {bad}); });
}

} // namespace

int main()
{
  test_rows();
  test_many_sources();
  test_stored_rows();
  test_stores_with_other_walls();
  return test_result();
}
