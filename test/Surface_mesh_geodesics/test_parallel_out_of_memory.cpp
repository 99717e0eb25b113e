// The parallel propagation runs out of memory, at one allocation after the other, in any of its threads: it throws
// std::bad_alloc, and the next run of the same object has the same bits as a run of a new one. So do runs that keep
// windows, and those that make a diagram.

// A program that defines a macro is compiled alone; this one replaces operator new.
#define SURFACE_MESH_GEODESICS_TEST_IS_COMPILED_ALONE

#include "intrinsic_mesh_helpers.h"
#include "several_threads.h"
#include "test_meshes.h"
#include "test_support.h"
#include "thread_team.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Redundant_window_removal.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Diagram_window_keeper.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_table.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Parallel_distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <new>
#include <utility>
#include <vector>

namespace {

std::atomic<bool> is_memory_limited{false};
std::atomic<long> allocations_left{0};

// Allocates, unless no allocation is left; then memory is unlimited again.
void* allocate(std::size_t n)
{
  if(is_memory_limited && allocations_left.fetch_sub(1) == 0)
  {
    is_memory_limited = false;
    throw std::bad_alloc();
  }
  void* const p = std::malloc(n);
  if(p == nullptr)
  {
    throw std::bad_alloc();
  }
  return p;
}

} // namespace

void* operator new(std::size_t n)
{
  return allocate(n);
}

void operator delete(void* p) noexcept
{
  std::free(p);
}

void operator delete(void* p, std::size_t) noexcept
{
  std::free(p);
}

namespace {

namespace SMG = CGAL::Surface_mesh_geodesics;
namespace internal = SMG::internal;
using Propagation =
  internal::Parallel_distance_propagation<double, internal::All_pruning_rules, Thread_team>;

// Runs. The allocations are counted from the first batch on, when all threads have started.
template <class Any_propagation>
void run_with_limit(Any_propagation& propagation, long limit)
{
  allocations_left = limit;
  CHECK(propagation.run([&](std::size_t visits, double)
  {
    is_memory_limited = is_memory_limited || (visits == 0 && limit >= 0);
    return true;
  }));
}

// Runs from a source.
template <class Any_propagation>
void run(Any_propagation& propagation, internal::Vertex_id source, double maximum_distance, long limit)
{
  propagation.restart();
  propagation.add_source(source, 0.);
  propagation.set_maximum_distance(maximum_distance);
  run_with_limit(propagation, limit);
}

void runs_out_of_memory_leave_no_trace(std::size_t number_of_threads, const internal::Intrinsic_mesh<double>& mesh)
{
  test_support::Scope scope(std::to_string(number_of_threads) + " threads");
  const double unlimited = internal::Vertex_distance_field<double>::infinity();
  std::vector<double> expected;
  std::size_t number_of_failures = 0;
  for(long limit = -1; limit < 160; ++limit)
  {
    internal::Vertex_distance_field<double> field;
    Propagation propagation(mesh, field, 16, Thread_team(number_of_threads));
    try
    {
      run(propagation, 5, unlimited, limit);
      is_memory_limited = false;
    }
    catch(const std::bad_alloc&)
    {
      ++number_of_failures;
      run(propagation, 17, .3, -1);
      run(propagation, 5, unlimited, -1);
    }
    if(expected.empty())
    {
      expected = field.distance;
    }
    CHECK(field.distance == expected);
  }
  std::cout << number_of_failures << " runs out of memory with " << number_of_threads << " threads" << std::endl;
  CHECK(number_of_failures > 50);
}

// A run that keeps its windows by edge, and returns the number of windows and the sum of their numbers.
double run_with_windows_of_edges(std::size_t number_of_threads, const internal::Intrinsic_mesh<double>& mesh,
                                 internal::Edge_window_field<double>& windows, long limit)
{
  using Keeper = internal::Window_keeper<double>;
  internal::Vertex_distance_field<double> field;
  windows.reset(mesh.number_of_faces());
  internal::Parallel_distance_propagation<double, internal::All_pruning_rules, Thread_team, Keeper> propagation(
    mesh, field, 16, Thread_team(number_of_threads), Keeper(windows));
  run(propagation, 5, internal::Vertex_distance_field<double>::infinity(), limit);
  double sum = 0;
  for(internal::Face_id f = 0; f < mesh.number_of_faces(); ++f)
  {
    for(unsigned int k = 0; k < 3; ++k)
    {
      windows.for_each_window(internal::halfedge_of(f, k), [&](const internal::Kept_window<double>& w)
      { sum = sum / 2 + w.begin + w.end + w.image_x + w.image_depth + 1; });
    }
  }
  return sum;
}

// Adds up the numbers of the faces that it is given.
struct Summing_consumer
{
  double sum = 0;

  void add(const internal::Divided_face<double>& face)
  {
    sum = sum / 2 + face.face;
    for(const auto& image : face.images)
    {
      sum += image.point.x + image.point.y + image.point.weight;
    }
  }
};

// A run whose redundant windows are removed, and the sum of its faces.
double run_with_windows_of_faces(std::size_t number_of_threads, const internal::Intrinsic_mesh<double>& mesh,
                                 long limit)
{
  using Removal = internal::Redundant_window_removal<double, Summing_consumer>;
  using Keeper = internal::Diagram_window_keeper<Removal>;
  internal::Vertex_distance_field<double> field;
  Summing_consumer consumer;
  Removal removal;
  removal.reset(mesh, field, consumer);
  internal::Parallel_distance_propagation<double, internal::All_pruning_rules, Thread_team, Keeper> propagation(
    mesh, field, 16, Thread_team(number_of_threads), Keeper(removal));
  propagation.add_source(17, 0.);
  propagation.add_source(5, 0.);
  run_with_limit(propagation, limit);
  removal.finish();
  is_memory_limited = false;
  return consumer.sum;
}

void keepers_out_of_memory_leave_no_trace(std::size_t number_of_threads, const internal::Intrinsic_mesh<double>& mesh)
{
  test_support::Scope scope("keepers, " + std::to_string(number_of_threads) + " threads");
  internal::Edge_window_field<double> windows;
  const double expected_by_edge = run_with_windows_of_edges(number_of_threads, mesh, windows, -1);
  const double expected_by_face = run_with_windows_of_faces(number_of_threads, mesh, -1);
  CHECK(expected_by_edge > 0 && expected_by_face > 0);
  std::size_t number_of_failures = 0;
  for(long limit = 0; limit < 160; ++limit)
  {
    double by_edge = expected_by_edge, by_face = expected_by_face;
    try
    {
      by_edge = run_with_windows_of_edges(number_of_threads, mesh, windows, limit);
      is_memory_limited = false;
    }
    catch(const std::bad_alloc&)
    {
      ++number_of_failures;
      by_edge = run_with_windows_of_edges(number_of_threads, mesh, windows, -1);
    }
    CHECK_EQUAL(by_edge, expected_by_edge);
    try
    {
      by_face = run_with_windows_of_faces(number_of_threads, mesh, limit);
    }
    catch(const std::bad_alloc&)
    {
      ++number_of_failures;
    }
    CHECK_EQUAL(by_face, expected_by_face);
  }
  std::cout << number_of_failures << " runs with keepers out of memory with " << number_of_threads << " threads"
            << std::endl;
  CHECK(number_of_failures > 100);
}

// Makes the diagram of three sites in a complex that may have been used before, and returns the sum of its arcs.
double make_diagram(internal::Voronoi_complex<double>& complex, std::size_t number_of_threads,
                    const internal::Intrinsic_mesh<double>& mesh, long limit)
{
  using Building = internal::Diagram_propagation<double, true>;
  internal::Vertex_distance_field<double> field;
  Building building(complex);
  building.start(mesh, field);
  internal::Parallel_distance_propagation<double, internal::All_pruning_rules, Thread_team, Building::Keeper>
    propagation(mesh, field, 16, Thread_team(number_of_threads), building.keeper());
  for(const internal::Vertex_id site : {5u, 17u, 300u})
    propagation.add_source(site, 0.);
  run_with_limit(propagation, limit);
  building.finish();
  is_memory_limited = false;
  double sum = 0;
  for(const auto& arc : complex.arcs())
    sum = sum / 2 + arc.first.x + arc.first.y + arc.last.x + arc.last.y;
  return sum;
}

void diagrams_out_of_memory_leave_no_trace(std::size_t number_of_threads, const internal::Intrinsic_mesh<double>& mesh)
{
  test_support::Scope scope("diagrams, " + std::to_string(number_of_threads) + " threads");
  internal::Voronoi_complex<double> first;
  const double expected = make_diagram(first, number_of_threads, mesh, -1);
  std::size_t number_of_failures = 0;
  for(long limit = 0; limit < 1000; limit += 3)
  {
    internal::Voronoi_complex<double> complex;
    double sum = expected;
    try
    {
      sum = make_diagram(complex, number_of_threads, mesh, limit);
    }
    catch(const std::bad_alloc&)
    {
      ++number_of_failures;
      complex.clear();
      sum = make_diagram(complex, number_of_threads, mesh, -1);
    }
    CHECK_EQUAL(sum, expected);
  }
  std::cout << number_of_failures << " diagrams out of memory with " << number_of_threads << " threads" << std::endl;
  CHECK(number_of_failures > 100);
}

// A table that has no memory to grow keeps its entries, and takes others later.
void tables_out_of_memory_keep_their_entries()
{
  const std::uint32_t n = 1000;
  for(long limit = 0; limit < 14; ++limit) // two arrays each time that it grows, seven times
  {
    internal::Index_table<std::uint32_t> table;
    allocations_left = limit;
    is_memory_limited = true;
    std::size_t number_of_failures = 0;
    for(std::uint32_t i = 0; i < n; ++i)
      try
      {
        table.insert(i, i + n);
      }
      catch(const std::bad_alloc&)
      {
        ++number_of_failures;
        table.insert(i, i + n);
      }
    is_memory_limited = false;
    CHECK_EQUAL(number_of_failures, std::size_t(1));
    for(std::uint32_t i = 0; i < n; ++i)
    {
      const std::uint32_t* const value = table.find(i);
      CHECK(value != nullptr && *value == i + n);
    }
  }
}

// Calls a function whose n-th allocation fails. Returns whether it has made fewer.
template <class Function>
bool has_memory(long n, const Function& function)
{
  allocations_left = n;
  is_memory_limited = true;
  bool result = true;
  try
  {
    function();
  }
  catch(const std::bad_alloc&)
  {
    result = false;
  }
  is_memory_limited = false;
  return result;
}

// Wherever memory ends while sources are inserted, undo() restores the mesh to the same bits, and they can be inserted
// afterwards.
template <typename InsertAll>
void insertions_out_of_memory_change_nothing(const InsertAll& insert_all)
{
  using namespace test_meshes;
  const auto first = intrinsic_mesh(to_face_graph(flat_patch(6, 6, .3, true, 5)));
  auto complete = first;
  internal::Source_insertion<double> undisturbed(complete);
  insert_all(undisturbed);
  long number_of_failures = 0;
  for(bool is_complete = false; !is_complete;)
  {
    auto mesh = first;
    internal::Source_insertion<double> insertion(mesh);
    is_complete = has_memory(number_of_failures, [&] { insert_all(insertion); });
    number_of_failures += is_complete ? 0 : 1;
    insertion.undo();
    CHECK(is_same_mesh(mesh, first));
    insert_all(insertion);
    CHECK(is_same_mesh(mesh, complete));
  }
  std::cout << number_of_failures << " insertions out of memory" << std::endl;
  CHECK(number_of_failures > 100);
}

// Sources in faces make a mesh large enough for batches (Propagation_by_size.h). Wherever memory ends meanwhile, the
// next runs are the same as those of another solver, visit by visit: on the small mesh, and from the same sources in
// another order, whose faces get other numbers. (Each failure has a solver of its own, as a solver keeps its memory.)
void meshes_that_grow_out_of_memory_leave_no_trace()
{
  using namespace test_meshes;
  using Face = boost::graph_traits<Mesh>::face_descriptor;
  using Location = std::pair<Face, std::array<double, 3>>;
  Indexed_mesh patch = flat_patch(90, 91, .3, true, 5);
  test_support::Random random(3);
  for(auto& p : patch.points)
    p[2] = random.uniform(-.3, .3);
  const Mesh tm = to_face_graph(patch);
  std::vector<Location> sources, reversed;
  for(unsigned int f = 4000; f < 4900; f += 100)
    sources.emplace_back(Face(f), std::array<double, 3>{.2, .3, .5});
  reversed.assign(sources.rbegin(), sources.rend());
  using Solver = SMG::Geodesic_distance_solver<Mesh, test_support::Propagation_of_size>;
  const auto run = [&](Solver& solver, const auto& from, double radius)
  {
    SMG::Propagation_statistics statistics;
    solver.compute_distances(from, CGAL::parameters::maximum_distance(radius).statistics(&statistics));
    double sum = 0;
    for(const Mesh::Vertex_index v : vertices(tm))
      sum += (std::min)(solver.distance(v), 100.);
    return std::make_pair(statistics.vertices_visited, sum);
  };
  const Mesh::Vertex_index source(2100);
  Solver another(tm);
  const auto from_vertex = run(another, source, 5), from_reversed = run(another, reversed, 3);
  long number_of_failures = 0;
  for(bool is_complete = false; !is_complete;)
  {
    Solver solver(tm);
    CHECK(run(solver, source, 5) == from_vertex);
    is_complete = has_memory(number_of_failures, [&]
    { solver.compute_distances(sources, CGAL::parameters::maximum_distance(1.)); });
    number_of_failures += is_complete ? 0 : 1;
    CHECK(run(solver, source, 5) == from_vertex);
    CHECK(run(solver, reversed, 3) == from_reversed);
  }
  std::cout << number_of_failures << " runs out of memory while the mesh grows" << std::endl;
  CHECK(number_of_failures > 50);
}

} // namespace

int main()
{
  // in faces and on edges
  insertions_out_of_memory_change_nothing([](internal::Source_insertion<double>& insertion)
  {
    for(internal::Face_id f = 10; f < 30; ++f)
      insertion.insert(f, f % 3 == 0 ? internal::Barycentric<double>{.25, .75, 0}
                                     : internal::Barycentric<double>{.2, .3, .5});
  });
  // so many in one face that edges are flipped
  insertions_out_of_memory_change_nothing([](internal::Source_insertion<double>& insertion)
  {
    for(int i = 1; i < 40; ++i)
    {
      const double x = .02 * i, y = (1 - x) * (i * 7 % 11 + 1) / 13;
      insertion.flip_around(insertion.insert(10, internal::Barycentric<double>{1 - x - y, x, y}));
    }
  });
  meshes_that_grow_out_of_memory_leave_no_trace();
  tables_out_of_memory_keep_their_entries();
  const auto mesh = test_meshes::intrinsic_mesh(
    test_meshes::to_face_graph(test_meshes::noisy_sphere(3, .1, test_support::announce_seed(7))));
  for(const std::size_t number_of_threads : std::vector<std::size_t>{1, 2, 5})
  {
    runs_out_of_memory_leave_no_trace(number_of_threads, mesh);
    keepers_out_of_memory_leave_no_trace(number_of_threads, mesh);
    diagrams_out_of_memory_leave_no_trace(number_of_threads, mesh);
  }
  return test_result();
}
