// Windows that several threads keep, for queries by edge and for diagrams by face. Their bits and their order depend
// neither on the number of threads nor on timing.

#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"
#include "thread_team.h"

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Redundant_window_removal.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Diagram_window_keeper.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Parallel_distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/Work_in_batches.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using Intrinsic_mesh = internal::Intrinsic_mesh<double>;
using Field = internal::Vertex_distance_field<double>;
using Window_field = internal::Edge_window_field<double>;
using Rules = internal::All_pruning_rules;

template <class Keeper>
using Parallel = internal::Parallel_distance_propagation<double, Rules, Thread_team, Keeper>;
template <class Keeper>
using Sequential = internal::Distance_propagation<double, Rules, Keeper>;

const std::vector<std::size_t> numbers_of_threads{1, 2, 3, 5, 64};

// Sources with their offsets.
using Sources = std::vector<std::pair<internal::Vertex_id, double>>;

Sources random_sources(const Intrinsic_mesh& mesh, std::size_t number, test_support::Random& random)
{
  Sources sources;
  for(std::size_t i = 0; i < number; ++i)
  {
    sources.emplace_back(static_cast<internal::Vertex_id>(random.index(mesh.number_of_vertices())),
                         random.uniform(0., .05));
  }
  return sources;
}

template <class Propagation>
void add(const Sources& sources, Propagation& propagation)
{
  for(const auto& s : sources)
  {
    propagation.add_source(s.first, s.second);
  }
}

template <class Propagation>
void run(Propagation& propagation, const Sources& sources)
{
  add(sources, propagation);
  CHECK(propagation.run([](std::size_t, double) { return true; }));
}

// All numbers of a field.
void append(const Field& field, std::vector<double>& numbers)
{
  for(std::size_t v = 0; v < field.distance.size(); ++v)
  {
    const auto& arrival = field.arrival[v];
    const bool is_reached = arrival.root != internal::null_id;
    numbers.insert(numbers.end(), {field.distance[v], is_reached ? arrival.abscissa : -1.,
                                   static_cast<double>(arrival.halfedge), static_cast<double>(arrival.root),
                                   field.image[v].x, field.image[v].depth});
  }
}

// --- windows by edge ---

template <class Visit>
void for_each_halfedge(const Intrinsic_mesh& mesh, Visit visit)
{
  for(internal::Face_id f = 0; f < mesh.number_of_faces(); ++f)
  {
    for(unsigned int k = 0; k < 3; ++k)
    {
      visit(internal::halfedge_of(f, k));
    }
  }
}

// All numbers of a field and of all windows, halfedge by halfedge.
std::vector<double> numbers_of(const Intrinsic_mesh& mesh, const Field& field, const Window_field& windows)
{
  std::vector<double> numbers;
  append(field, numbers);
  for_each_halfedge(mesh, [&](internal::Halfedge_id h)
  {
    numbers.push_back(-2.);
    windows.for_each_window(h, [&](const internal::Kept_window<double>& w)
    { numbers.insert(numbers.end(), {w.begin, w.end, w.image_x, w.image_depth, static_cast<double>(w.root)}); });
  });
  return numbers;
}

std::array<double, 3> random_weights(test_support::Random& random)
{
  const double a = random.uniform(.05, .9), b = random.uniform(.05, .95 - a);
  return {a, b, 1. - a - b};
}

// A propagation that keeps its windows by edge.
template <class Propagation>
struct Kept_by_edge
{
  Field field;
  Window_field windows;

  template <class... Arguments>
  Kept_by_edge(const Intrinsic_mesh& mesh, const Sources& sources, const Arguments&... arguments)
  {
    field.keeps_images = true;
    windows.reset(mesh.number_of_faces());
    Propagation propagation(mesh, field, arguments..., internal::Window_keeper<double>(windows));
    run(propagation, sources);
  }
};

void threads_do_not_change_the_windows_of_edges(const Intrinsic_mesh& mesh, const Sources& sources,
                                                test_support::Random& random)
{
  test_support::Scope scope("windows of edges");
  using Keeper = internal::Window_keeper<double>;
  const Kept_by_edge<Sequential<Keeper>> expected(mesh, sources);
  std::vector<double> first;
  for(const std::size_t number : numbers_of_threads)
  {
    test_support::Scope scope_of_threads(std::to_string(number) + " threads");
    const Kept_by_edge<Parallel<Keeper>> kept(mesh, sources, std::size_t(16), Thread_team(number));
    const std::vector<double> numbers = numbers_of(mesh, kept.field, kept.windows);
    first = first.empty() ? numbers : first;
    CHECK(numbers == first);
    if(number > 1)
    {
      continue;
    }
    CHECK_FIELDS_CLOSE(kept.field.distance, expected.field.distance, 1e-13);
    for(internal::Face_id f = 0; f < mesh.number_of_faces(); ++f)
    {
      const std::array<double, 3> b = random_weights(random);
      const auto a = internal::arrival_at_location(mesh, kept.field, kept.windows, f, b);
      const auto e = internal::arrival_at_location(mesh, expected.field, expected.windows, f, b);
      CHECK_EQUAL(a.root == internal::null_id, e.root == internal::null_id);
      if(a.root != internal::null_id)
      {
        CHECK_CLOSE(a.distance, e.distance, 1e-12);
      }
    }
  }
}

// A copy of a keeper uses other memory: what one keeps does not overwrite what the other one has kept.
void copies_of_keepers_share_no_memory()
{
  test_support::Scope scope("copies of keepers");
  internal::Window_pool<double> pool;
  internal::Window_list<double> list = pool.allocate(3);
  list.size = 3;
  Window_field windows;
  windows.reset(2000);
  internal::Window_keeper<double> one(windows);
  one.keep(0, list);
  internal::Window_keeper<double> other(one);
  for(internal::Face_id f = 0; f < 2000; ++f)
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      list.columns.image_x()[i] = 3. * f + static_cast<double>(i);
    }
    (f % 3 == 0 ? other : one).keep(internal::halfedge_of(f, 1), list);
  }
  for(internal::Face_id f = 0; f < 2000; ++f)
  {
    double x = 3. * f;
    windows.for_each_window(internal::halfedge_of(f, 1),
                            [&](const internal::Kept_window<double>& w) { CHECK_EQUAL(w.image_x, x++); });
    CHECK_EQUAL(x, 3. * f + 3.);
  }
  CHECK(windows.memory() > 6000 * sizeof(internal::Kept_window<double>));
  windows.clear();
  CHECK_EQUAL(windows.memory(), 0u);
  pool.release(list);
}

// --- windows by face ---

// Records the faces that it is given.
struct Recorder
{
  std::vector<double> numbers;

  void add(const internal::Divided_face<double>& face)
  {
    numbers.push_back(static_cast<double>(face.face));
    for(const auto& side : face.breakpoints)
    {
      for(const auto& b : side)
      {
        numbers.insert(numbers.end(), {b.x, static_cast<double>(b.before), static_cast<double>(b.after)});
      }
    }
    for(const auto& image : face.images)
    {
      numbers.insert(numbers.end(), {image.point.x, image.point.y, image.point.weight,
                                     static_cast<double>(image.site)});
    }
  }
};

using Removal = internal::Redundant_window_removal<double, Recorder>;
using Diagram_keeper = internal::Diagram_window_keeper<Removal>;

// A propagation whose redundant windows are removed.
template <class Propagation>
struct Kept_by_face
{
  Field field;
  Recorder recorder;
  Removal removal;
  std::vector<internal::Vertex_id> owners;

  template <class... Arguments>
  Kept_by_face(const Intrinsic_mesh& mesh, const Sources& sources, const Arguments&... arguments)
  {
    field.keeps_images = true;
    removal.reset(mesh, field, recorder);
    Propagation propagation(mesh, field, arguments..., Diagram_keeper(removal));
    run(propagation, sources);
    removal.finish();
    owners = removal.owners();
  }

  std::vector<double> numbers() const
  {
    std::vector<double> result = recorder.numbers;
    append(field, result);
    result.insert(result.end(), owners.begin(), owners.end());
    result.push_back(static_cast<double>(removal.number_of_kept_windows()));
    result.push_back(static_cast<double>(removal.windows().maximum_size()));
    return result;
  }
};

void threads_do_not_change_the_divided_faces(const Intrinsic_mesh& mesh, const Sources& sources)
{
  test_support::Scope scope("windows of faces");
  const Kept_by_face<Sequential<Diagram_keeper>> expected(mesh, sources);
  std::vector<double> first;
  for(const std::size_t number : numbers_of_threads)
  {
    test_support::Scope scope_of_threads(std::to_string(number) + " threads");
    const Kept_by_face<Parallel<Diagram_keeper>> kept(mesh, sources, std::size_t(16), Thread_team(number));
    const std::vector<double> numbers = kept.numbers();
    first = first.empty() ? numbers : first;
    CHECK(numbers == first);
    CHECK(kept.owners == expected.owners);
  }
}

// If no window is removed before the end, the keeper has got all windows that were propagated, those of the last batch
// included.
void all_windows_are_kept(const Intrinsic_mesh& mesh, const Sources& sources)
{
  test_support::Scope scope("all windows are kept");
  for(const std::size_t number : numbers_of_threads)
  {
    Field field;
    Recorder recorder;
    Removal removal;
    removal.reset(mesh, field, recorder, false);
    Parallel<Diagram_keeper> propagation(mesh, field, 16, Thread_team(number), Diagram_keeper(removal));
    run(propagation, sources);
    CHECK_EQUAL(removal.number_of_kept_windows(), propagation.statistics().windows_propagated);
  }
}

// --- faces that the threads divide ---

using Complex = internal::Voronoi_complex<double>;

std::vector<double> numbers_of(const Complex& complex)
{
  std::vector<double> numbers;
  for(const auto& a : complex.arcs())
  {
    numbers.insert(numbers.end(), {static_cast<double>(a.face), a.first.x, a.first.y, a.last.x, a.last.y,
                                   a.left.weight, a.right.weight, static_cast<double>(a.left_site),
                                   static_cast<double>(a.right_site), static_cast<double>(a.first_node),
                                   static_cast<double>(a.last_node)});
  }
  for(const auto& n : complex.nodes())
  {
    numbers.insert(numbers.end(), {n.point.x, n.point.y, n.abscissa, n.distance});
  }
  numbers.push_back(static_cast<double>(complex.chains().size()));
  numbers.push_back(static_cast<double>(complex.number_of_joints()));
  return numbers;
}

// The same arcs and nodes in an order that does not depend on that of the faces. (The distance of a node on an edge is
// measured in the face that comes last, so it is left out.)
std::vector<std::vector<double>> sorted_numbers_of(const Complex& complex)
{
  std::vector<std::vector<double>> numbers;
  for(const auto& a : complex.arcs())
  {
    numbers.push_back({static_cast<double>(a.face), a.first.x, a.first.y, a.last.x, a.last.y, a.left.weight,
                       a.right.weight, static_cast<double>(a.left_site), static_cast<double>(a.right_site)});
  }
  for(const auto& n : complex.nodes())
  {
    numbers.push_back({static_cast<double>(n.face), n.point.x, n.point.y, n.abscissa, static_cast<double>(n.sites[0]),
                       static_cast<double>(n.sites[1]), static_cast<double>(n.sites[2])});
  }
  numbers.push_back({static_cast<double>(complex.chains().size()), static_cast<double>(complex.number_of_joints())});
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

// A consumer that remembers the faces, and divides them when all are there.
struct Face_list
{
  std::vector<internal::Divided_face<double>> faces;

  void add(const internal::Divided_face<double>& face) { faces.push_back(face); }
};

// The complex whose edges and faces one thread divides as soon as they are closed.
void divide_in_one_thread(const Intrinsic_mesh& mesh, const Sources& sources, Complex& complex)
{
  using List_removal = internal::Redundant_window_removal<double, Face_list>;
  using List_keeper = internal::Diagram_window_keeper<List_removal>;
  Field field;
  field.keeps_images = true;
  Face_list list;
  List_removal removal;
  removal.reset(mesh, field, list);
  Parallel<List_keeper> propagation(mesh, field, 16, Thread_team(1), List_keeper(removal));
  run(propagation, sources);
  removal.finish();
  complex.start(mesh);
  for(const auto& face : list.faces)
  {
    complex.add(face);
  }
  complex.finish(removal.owners());
  CHECK(list.faces.empty() || !complex.arcs().empty());
}

// Edges and faces wait for the threads to divide them. That changes the order of the faces only, and no number of
// threads changes anything.
void threads_do_not_change_the_complex(const Intrinsic_mesh& mesh, const Sources& sources)
{
  test_support::Scope scope("complex");
  Complex expected;
  divide_in_one_thread(mesh, sources, expected);
  std::vector<double> first;
  using Diagram = internal::Diagram_propagation<double, true>;
  for(const std::size_t number : numbers_of_threads)
  {
    test_support::Scope scope_of_threads(std::to_string(number) + " threads");
    Field found_field;
    found_field.keeps_images = true;
    Complex found;
    Diagram diagram(found);
    diagram.start(mesh, found_field);
    const auto keeper = diagram.keeper();
    Parallel<std::decay_t<decltype(keeper)>> run_of_diagram(mesh, found_field, std::size_t(16), Thread_team(number),
                                                            keeper);
    run(run_of_diagram, sources);
    diagram.finish();
    CHECK(keeper.memory() > 0 || expected.arcs().empty());
    CHECK(sorted_numbers_of(found) == sorted_numbers_of(expected));
    first = first.empty() ? numbers_of(found) : first;
    CHECK(numbers_of(found) == first);
  }
}

// --- work that waits ---

// Items are done in the batch after the one that has added them, and come back in the next one, in their order.
void work_passes_through_three_batches()
{
  test_support::Scope scope("work in batches");
  internal::Work_in_batches<int> work;
  std::vector<int> back;
  const auto add = [&](int first, int last)
  {
    for(int i = first; i < last; ++i)
    {
      work.add() = i;
    }
  };
  const auto negate = [](int& i) { i = -i; };
  const auto take = [&](int i) { back.push_back(i); };
  const auto do_all = [&](std::size_t number_of_units)
  {
    CHECK(number_of_units <= work.maximum_number_of_units);
    for(std::size_t unit = number_of_units; unit-- > 0;)
    {
      work.do_unit(unit, negate);
    }
  };
  CHECK_EQUAL(work.begin_batch(), std::size_t(0));
  add(1, 2003); // more than units, and no multiple of their size
  const std::size_t number_of_units = work.begin_batch();
  CHECK(number_of_units > 1 && 2002 % (number_of_units - 1) != 0 && !work.has_done());
  add(2003, 2006);
  do_all(number_of_units);
  do_all(work.begin_batch());
  CHECK(work.has_done());
  work.take_back(take);
  CHECK(back.size() == 2002 && back.front() == -1 && back.back() == -2002 && !work.has_done());
  add(2006, 2008);
  work.begin_batch(); // nobody does its units
  add(2008, 2010);
  work.finish(negate, take);
  CHECK_EQUAL(back.size(), std::size_t(2009));
  for(std::size_t i = 0; i < back.size(); ++i)
  {
    CHECK_EQUAL(back[i], -static_cast<int>(i) - 1);
  }
  add(1, 10);
  work.begin_batch();
  add(1, 10);
  work.clear();
  back.clear();
  work.finish(negate, take);
  CHECK(back.empty());
}

// --- runs that end early ---

// Runs of one object: some are canceled or end by an exception, and those after them are like the first.
void broken_off_runs_leave_no_trace(const Intrinsic_mesh& mesh, const Sources& sources)
{
  test_support::Scope scope("broken off");
  for(const std::size_t number : numbers_of_threads)
  {
    Field field;
    field.keeps_images = true;
    Recorder recorder;
    Removal removal;
    removal.reset(mesh, field, recorder);
    Parallel<Diagram_keeper> propagation(mesh, field, 16, Thread_team(number), Diagram_keeper(removal));
    std::vector<double> first;
    for(std::size_t last = 0; last < 40; last += 8)
    {
      propagation.restart();
      recorder.numbers.clear();
      removal.reset(mesh, field, recorder);
      run(propagation, sources);
      removal.finish();
      first = first.empty() ? recorder.numbers : first;
      CHECK(recorder.numbers == first);

      for(const bool throws : {false, true})
      {
        propagation.restart();
        removal.reset(mesh, field, recorder);
        add(sources, propagation);
        std::size_t calls = 0;
        bool is_caught = false;
        try
        {
          CHECK(!propagation.run([&](std::size_t, double)
          {
            if(throws && calls == last)
            {
              throw std::range_error("thrown by the visitor");
            }
            return calls++ < last;
          }));
        }
        catch(const std::range_error&)
        {
          is_caught = true;
        }
        CHECK_EQUAL(is_caught, throws);
      }
    }
    CHECK(!first.empty());
  }
}

// The same for a diagram, whose edges and faces may wait when the run ends.
void broken_off_diagrams_leave_no_trace(const Intrinsic_mesh& mesh, const Sources& sources)
{
  test_support::Scope scope("broken off diagrams");
  using Diagram = internal::Diagram_propagation<double, true>;
  for(const std::size_t number : numbers_of_threads)
  {
    Field field;
    field.keeps_images = true;
    Complex complex;
    Diagram diagram(complex);
    diagram.start(mesh, field);
    Parallel<Diagram::Keeper> propagation(mesh, field, 16, Thread_team(number), diagram.keeper());
    std::vector<double> first;
    for(std::size_t last = 0; last < 60; last += 6)
    {
      diagram.start(mesh, field);
      propagation.restart();
      run(propagation, sources);
      diagram.finish();
      const std::vector<double> numbers = numbers_of(complex);
      first = first.empty() ? numbers : first;
      CHECK(numbers == first);

      diagram.start(mesh, field);
      propagation.restart();
      add(sources, propagation);
      std::size_t calls = 0;
      CHECK(!propagation.run([&](std::size_t, double) { return calls++ < last; }));
    }
    CHECK(first.size() > 100);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260611);
  test_support::Random random(seed);
  work_passes_through_three_batches();
  copies_of_keepers_share_no_memory();
  for(const Indexed_mesh& indexed :
      {noisy_sphere(3, .1, seed), rough_terrain(16, 2., seed), wavy_tube(20, 24),
       midpoint_subdivision(jittered(genus_2_polycube(), .15, seed), 2), tetrahedral_ogre(60, seed),
       random_cuts(noisy_sphere(2, .1, seed + 2), .15, seed + 3), two_components_and_an_isolated_vertex(),
       irregular_tetrahedron(), needle_sphere(12, 16)})
  {
    test_support::Scope scope(indexed.name);
    const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(indexed));
    for(const std::size_t number : {std::size_t(1), std::size_t(2), std::size_t(12)})
    {
      const Sources sources = random_sources(mesh, number, random);
      threads_do_not_change_the_windows_of_edges(mesh, sources, random);
      threads_do_not_change_the_divided_faces(mesh, sources);
      threads_do_not_change_the_complex(mesh, sources);
      all_windows_are_kept(mesh, sources);
    }
  }
  const Intrinsic_mesh terrain = intrinsic_mesh(to_face_graph(rough_terrain(24, 1., seed)));
  broken_off_runs_leave_no_trace(terrain, random_sources(terrain, 5, random));
  broken_off_diagrams_leave_no_trace(terrain, random_sources(terrain, 12, random));
  return test_result();
}
