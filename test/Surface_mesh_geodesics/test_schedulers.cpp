// The schedulers of the thesis that the benchmark compares (FTP, OPFTP, VTP, OPVTP) and its variants of pruning give
// the distances of the package: on closed meshes, with borders, pinched vertices and needles, from one source and from
// several.

#include "hostile_meshes.h"
#include "intrinsic_mesh_helpers.h"
#include "schedulers_of_thesis.h"
#include "test_meshes.h"
#include "test_support.h"
#include "window_test_helpers.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using Intrinsic_mesh = internal::Intrinsic_mesh<double>;
using Field = internal::Vertex_distance_field<double>;
using Statistics = CGAL::Surface_mesh_geodesics::Propagation_statistics;
using Sources = std::vector<std::pair<internal::Vertex_id, double>>;

const double tolerance = 1e-12;

// The counts of all runs of a scheduler.
std::map<std::string, Statistics> counts;

std::vector<double> expected_distances(const Intrinsic_mesh& mesh, const Sources& sources)
{
  Field field;
  internal::Distance_propagation<double> propagation(mesh, field);
  for(const auto& source : sources)
  {
    propagation.add_source(source.first, source.second);
  }
  CHECK(propagation.run([](std::size_t, double) { return true; }));
  return field.distance;
}

template <class Propagation>
void distances_are(const std::vector<double>& expected, const std::string& name, const Intrinsic_mesh& mesh,
                   const Sources& sources)
{
  test_support::Scope scope(name);
  Field field;
  Propagation propagation(mesh, field);
  for(const auto& source : sources)
  {
    propagation.add_source(source.first, source.second);
  }
  propagation.run();
  CHECK_FIELDS_CLOSE(field.distance, expected, tolerance);
  const Statistics statistics = propagation.statistics();
  CHECK(statistics.maximum_windows_alive <= statistics.windows_created + statistics.windows_propagated);
  counts[name].add(statistics);
}

// All systems with one policy for pairs of windows.
template <class Pruning>
void distances_of_systems_are(const std::vector<double>& expected, const std::string& pruning,
                              const Intrinsic_mesh& mesh, const Sources& sources)
{
  using namespace schedulers;
  distances_are<Vtp<double, Pruning>>(expected, "VTP, " + pruning, mesh, sources);
  distances_are<Order_preserving_vtp<double, Pruning>>(expected, "OPVTP, " + pruning, mesh, sources);
  distances_are<Ftp<double, Pruning>>(expected, "FTP, " + pruning, mesh, sources);
  distances_are<Order_preserving_ftp<double, Pruning>>(expected, "OPFTP, " + pruning, mesh, sources);
  distances_are<Ftp_by_lists<double, Pruning>>(expected, "FTP-List, " + pruning, mesh, sources);
}

void all_schedulers_agree(const Intrinsic_mesh& mesh, const Sources& sources)
{
  using namespace schedulers;
  const std::vector<double> expected = expected_distances(mesh, sources);
  distances_of_systems_are<Neighbor_pruning>(expected, "neighbors", mesh, sources);
  distances_of_systems_are<Without_pairs>(expected, "no pairs", mesh, sources);
  distances_are<Vtp<double, Exhaustive_pruning>>(expected, "VTP, all pairs", mesh, sources);
  distances_are<Vtp<double, Bisector_trimming>>(expected, "VTP, bisectors", mesh, sources);
  distances_are<Vtp<double, One_split_for_each_angle>>(expected, "VTP, one split", mesh, sources);
}

Sources random_sources(std::size_t n, const Intrinsic_mesh& mesh, test_support::Random& random)
{
  Sources sources;
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t v = random.index(mesh.number_of_vertices());
    sources.emplace_back(static_cast<internal::Vertex_id>(v), i == 0 ? 0. : random.uniform(0., .2));
  }
  return sources;
}

struct Kinds
{
  bool has_pinched_vertex = false, has_border = false, is_closed = false;
};

void find_kinds(const Intrinsic_mesh& mesh, Kinds& kinds)
{
  bool is_closed = true;
  for(internal::Vertex_id v = 0; v < mesh.number_of_vertices(); ++v)
  {
    kinds.has_pinched_vertex = kinds.has_pinched_vertex || mesh.has(v, Intrinsic_mesh::PINCHED);
    const internal::Halfedge_id h = mesh.halfedge(v);
    is_closed = is_closed && h != internal::null_id && mesh.opposite(h) != internal::null_id;
  }
  kinds.has_border = kinds.has_border || !is_closed;
  kinds.is_closed = kinds.is_closed || is_closed;
}

void distances_are_those_of_the_package(std::uint64_t seed)
{
  test_support::Random random(seed);
  Kinds kinds;
  for(const Indexed_mesh& indexed : collection(seed))
  {
    if(indexed.faces.size() > 1300)
    {
      continue;
    }
    test_support::Scope scope(indexed.name);
    const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(indexed));
    find_kinds(mesh, kinds);
    all_schedulers_agree(mesh, Sources{{internal::Vertex_id(0), 0.}});
    all_schedulers_agree(mesh, random_sources(1, mesh, random));
    all_schedulers_agree(mesh, random_sources(4, mesh, random));
  }
  CHECK(kinds.has_pinched_vertex);
  CHECK(kinds.has_border);
  CHECK(kinds.is_closed);
}

// Needles and caps down to the rounding of coordinates, in which distances must not depend on the order either.
void distances_are_those_of_the_package_on_hostile_meshes(std::uint64_t seed)
{
  for(std::size_t i = 0; i < 150; ++i)
  {
    test_support::Random random(seed + i);
    const Indexed_mesh indexed = hostile_meshes::hostile_mesh(random);
    Mesh tm;
    if(indexed.faces.empty() || !hostile_meshes::is_surface(indexed, tm))
    {
      continue;
    }
    test_support::Scope scope("hostile mesh " + std::to_string(i));
    const Intrinsic_mesh mesh = intrinsic_mesh(tm);
    all_schedulers_agree(mesh, random_sources(1, mesh, random));
    all_schedulers_agree(mesh, random_sources(3, mesh, random));
  }
}

// Each choice makes a difference: otherwise two systems would be one. Requires: the same runs with each of them.
void choices_make_a_difference()
{
  const auto windows = [](const std::string& name) { return counts[name].windows_propagated; };
  CHECK(windows("VTP, neighbors") > 0);
  CHECK(windows("VTP, neighbors") != windows("OPVTP, neighbors"));
  CHECK(windows("FTP, neighbors") != windows("OPFTP, neighbors"));
  CHECK(windows("VTP, neighbors") != windows("FTP, neighbors"));
  CHECK(windows("FTP, neighbors") != windows("FTP-List, neighbors"));
  for(const char* system : {"VTP", "OPVTP", "FTP", "OPFTP", "FTP-List"})
  {
    CHECK(windows(std::string(system) + ", neighbors") < windows(std::string(system) + ", no pairs"));
  }
  CHECK(windows("VTP, all pairs") <= windows("VTP, neighbors"));
  CHECK(windows("VTP, bisectors") < windows("VTP, no pairs"));
  CHECK(windows("VTP, no pairs") < windows("VTP, one split"));
}

window_test::List list_of_keys(const std::vector<internal::Window_key>& keys, window_test::Pool& pool)
{
  window_test::List list = pool.allocate(keys.size());
  for(std::size_t i = 0; i < keys.size(); ++i)
  {
    window_test::Window w = window_test::window(.25, .5, .5, 1., 0.);
    w.key = keys[i];
    list.columns.set(i, w);
  }
  pool.add(list, keys.size(), 0);
  return list;
}

// An order-preserving merger makes one sorted list; an order-free merger leaves the lists as they came.
void mergers_keep_or_free_the_order()
{
  window_test::Pool pool;
  schedulers::Waiting_lists<double> waiting(4);
  const internal::Halfedge_id h = internal::halfedge_of(2, 1);
  std::vector<std::vector<internal::Window_key>> taken;
  const auto take = [&](window_test::List list)
  {
    taken.emplace_back(list.columns.key(), list.columns.key() + list.size);
    pool.release(list);
  };
  for(const bool keeps_order : {true, false})
  {
    taken.clear();
    for(const std::vector<internal::Window_key>& keys : {std::vector<internal::Window_key>{4, 8}, {2, 6}, {5}})
    {
      window_test::List list = list_of_keys(keys, pool);
      if(keeps_order)
      {
        waiting.merge(h, list, pool);
      }
      else
      {
        waiting.append(h, list, pool);
      }
    }
    CHECK_EQUAL(waiting.number_of_windows(), std::size_t(5));
    waiting.take(internal::halfedge_of(1, 1), take);
    CHECK(taken.empty());
    waiting.take(h, take);
    CHECK_EQUAL(waiting.number_of_windows(), std::size_t(0));
    CHECK(taken == (keeps_order ? std::vector<std::vector<internal::Window_key>>{{2, 4, 5, 6, 8}}
                                : std::vector<std::vector<internal::Window_key>>{{4, 8}, {2, 6}, {5}}));
    waiting.take(h, take);
    CHECK_EQUAL(taken.size(), keeps_order ? std::size_t(1) : std::size_t(3));
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260111);
  mergers_keep_or_free_the_order();
  distances_are_those_of_the_package(seed);
  distances_are_those_of_the_package_on_hostile_meshes(seed);
  choices_make_a_difference();
  return test_result();
}
