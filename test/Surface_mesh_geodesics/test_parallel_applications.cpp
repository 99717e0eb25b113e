// Certificates of distances, relaxation and remeshing with Parallel_tag: the results do not depend on the number of
// threads, those of certificates are those of Sequential_tag, and visitors hear of everything in their own thread.

#include "distance_test_helpers.h"
#include "mesh_operations.h"
#include "test_meshes.h"
#include "test_support.h"
#include "thread_team.h"
#include "with_threads.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Chunk_team.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace test_meshes;

namespace {

using Tag = CGAL::Parallel_if_available_tag;
using Certificate = SMG::Geodesic_distance_certificate<Mesh>;

const std::vector<std::size_t> numbers_of_threads{1, 2, 3, 5};

// --- loops in chunks -------------------------------------------------------------------------------------------------

using Chunks = SMG::internal::Chunk_team<Thread_team>;

void each_number_belongs_to_one_chunk()
{
  test_support::Scope scope("numbers");
  for(const std::size_t n : {0u, 1u, 63u, 64u, 65u, 10007u})
  {
    for(const std::size_t threads : numbers_of_threads)
    {
      const Chunks chunks{Thread_team(threads)};
      std::vector<int> count(n, 0);
      std::vector<std::size_t> chunk_of(n);
      CHECK(chunks(n, [] { return true; },
                   [&](std::size_t c, std::size_t first, std::size_t last, const auto& ask)
                   {
                     for(std::size_t i = first; i < last && ask(); ++i)
                     {
                       ++count[i];
                       chunk_of[i] = c;
                     }
                   }));
      CHECK(count == std::vector<int>(n, 1));
      for(std::size_t i = 0; i < n; ++i)
      {
        CHECK_EQUAL(chunk_of[i], i / Chunks::chunk_size);
      }
      CHECK(n == 0 || chunk_of[n - 1] + 1 == Chunks::number_of_chunks(n));
    }
  }
}

void loops_end_when_they_are_told_to()
{
  test_support::Scope scope("end");
  constexpr std::size_t n = 100000;
  for(const std::size_t threads : numbers_of_threads)
  {
    const Chunks chunks{Thread_team(threads)};
    std::size_t number_of_questions = 0;
    const std::thread::id caller = std::this_thread::get_id();
    CHECK(!chunks(n,
                  [&]
                  {
                    CHECK(std::this_thread::get_id() == caller);
                    return ++number_of_questions < 5;
                  },
                  // Each thread waits in its first chunk for the end, so that the calling thread has one, too.
                  [&](std::size_t, std::size_t, std::size_t, const auto& ask)
                  {
                    while(ask())
                    {
                    }
                  }));
    CHECK_EQUAL(number_of_questions, 5u);
    std::string found = "none";
    try
    {
      chunks(n, [] { return true; },
             [&](std::size_t c, std::size_t, std::size_t, const auto&)
             {
               if(c == 7)
               {
                 throw std::runtime_error("7");
               }
             });
    }
    catch(const std::runtime_error& error)
    {
      found = error.what();
    }
    CHECK_EQUAL(found, "7");
  }
}

// --- certificates ----------------------------------------------------------------------------------------------------

// Counts what it is told, checks that its thread is that in which it was made, and ends at a given call.
struct Visitor : SMG::Geodesic_default_visitor
{
  explicit Visitor(std::size_t last_call = (std::numeric_limits<std::size_t>::max)(), bool throws_at_last = false)
    : last(last_call), will_throw(throws_at_last)
  {}

  void on_progress(std::size_t, double) { CHECK(std::this_thread::get_id() == thread); }

  bool go_further()
  {
    CHECK(std::this_thread::get_id() == thread);
    if(++number < last)
    {
      return true;
    }
    if(will_throw)
    {
      throw std::runtime_error("visitor");
    }
    return false;
  }

  std::size_t last, number = 0;
  bool will_throw;
  std::thread::id thread = std::this_thread::get_id();
};

void check_same(const Certificate& found, const Certificate& expected)
{
  for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
  {
    const auto c = static_cast<Certificate::Condition>(i);
    CHECK(found.worst_violation(c) == expected.worst_violation(c));
    CHECK(found.worst_vertex(c) == expected.worst_vertex(c));
    CHECK_EQUAL(found.number_of_checks(c), expected.number_of_checks(c));
  }
}

template <class CertificateTag, class Sources, class NamedParameters>
Certificate certificate(const Mesh& tm, const std::vector<double>& d, const Sources& sources, const NamedParameters& np)
{
  const auto map = boost::make_function_property_map<Mesh::Vertex_index>([&](Mesh::Vertex_index v) { return d[v]; });
  return SMG::certify_geodesic_distances<CertificateTag>(tm, map, sources, np);
}

std::vector<double> distances(const Mesh& tm, const std::vector<Mesh::Vertex_index>& sources)
{
  std::vector<double> d(num_vertices(tm));
  SMG::geodesic_distances(tm, boost::make_iterator_property_map(d.begin(), get(CGAL::vertex_index, tm)), sources);
  return d;
}

// Right distances, and some that are wrong in one place.
void threads_do_not_change_certificates(const Mesh& tm, test_support::Random& random)
{
  const std::vector<Mesh::Vertex_index> sources{vertex(0), vertex(num_vertices(tm) / 2)};
  std::vector<double> d = distances(tm, sources);
  const auto defaults = CGAL::parameters::default_values();
  CHECK((certificate<CGAL::Sequential_tag>(tm, d, sources, defaults).is_certified()));
  for(std::size_t repetition = 0; repetition < 4; ++repetition)
  {
    const Certificate expected = certificate<CGAL::Sequential_tag>(tm, d, sources, defaults);
    for(const std::size_t threads : numbers_of_threads)
    {
      with_threads(threads, [&] { check_same(certificate<Tag>(tm, d, sources, defaults), expected); });
    }
    d[random.index(d.size())] *= 1 + 1e-6;
  }
}

// A visitor that ends the work leaves a certificate that proves nothing; its exceptions are passed on.
void visitors_end_certificates(const Mesh& tm)
{
  test_support::Scope scope("visitors");
  const std::vector<Mesh::Vertex_index> sources{vertex(0)};
  const std::vector<double> d = distances(tm, sources);
  Visitor counter;
  CHECK((certificate<Tag>(tm, d, sources, CGAL::parameters::visitor(std::ref(counter))).is_certified()));
  CHECK(counter.number > num_vertices(tm));
  for(const std::size_t last : std::vector<std::size_t>{1, num_vertices(tm) + 10, num_vertices(tm) + num_faces(tm)})
  {
    for(const std::size_t threads : numbers_of_threads)
    {
      with_threads(threads, [&]
      {
        Visitor visitor(last);
        const Certificate found
          = certificate<Tag>(tm, d, sources, CGAL::parameters::visitor(std::ref(visitor)));
        // With several threads the work may be over before the visitor has been asked so often.
        CHECK(found.is_certified() == (visitor.number < last));
        CHECK(visitor.number <= last);
        Visitor thrower(last, true);
        std::string message = "none";
        try
        {
          certificate<Tag>(tm, d, sources, CGAL::parameters::visitor(std::ref(thrower)));
        }
        catch(const std::runtime_error& error)
        {
          message = error.what();
        }
        CHECK((message == "visitor") == (thrower.number >= last));
      });
    }
  }
}

// --- relaxation and remeshing ----------------------------------------------------------------------------------------

void threads_do_not_change_the_relaxation(const Mesh& tm)
{
  std::vector<Mesh::Vertex_index> sites;
  for(std::size_t i = 0; i < 12; ++i)
  {
    sites.push_back(vertex(i * (num_vertices(tm) - 1) / 11));
  }
  std::vector<std::vector<Mesh::Vertex_index>> results;
  for(const std::size_t threads : numbers_of_threads)
  {
    with_threads(threads, [&]
    {
      Visitor visitor;
      results.emplace_back();
      SMG::geodesic_Lloyd_relaxation<Tag>(
        tm, sites, std::back_inserter(results.back()),
        CGAL::parameters::visitor(std::ref(visitor)).number_of_iterations(3u));
      CHECK(visitor.number > 0);
    });
    CHECK_EQUAL(results.back().size(), sites.size());
    CHECK(results.back() == results.front());
  }
  CHECK(results.front() != sites);
}

// The corners of the faces, one after the other.
std::vector<Mesh::Point> corners(const Mesh& tm)
{
  std::vector<Mesh::Point> points;
  for(const auto f : faces(tm))
  {
    for(const auto v : vertices_around_face(halfedge(f, tm), tm))
    {
      points.push_back(tm.point(v));
    }
  }
  return points;
}

std::ptrdiff_t euler_characteristic(const Mesh& tm)
{
  return static_cast<std::ptrdiff_t>(num_vertices(tm) + num_faces(tm)) - static_cast<std::ptrdiff_t>(num_edges(tm));
}

void threads_do_not_change_the_new_mesh(const Mesh& tm)
{
  std::vector<Mesh> results;
  for(const std::size_t threads : numbers_of_threads)
  {
    with_threads(threads, [&]
    {
      Mesh coarse;
      const auto report
        = SMG::geodesic_remeshing<Tag>(tm, 40, coarse, CGAL::parameters::number_of_iterations(2u));
      CHECK(report.is_manifold());
      CHECK(CGAL::is_valid_polygon_mesh(coarse));
      results.push_back(coarse);
    });
    CHECK(num_faces(results.back()) > 0);
    CHECK(corners(results.back()) == corners(results.front()));
  }
  Mesh sequential;
  CHECK(SMG::geodesic_remeshing(tm, 40, sequential, CGAL::parameters::number_of_iterations(2u)).is_manifold());
  CHECK_EQUAL(euler_characteristic(sequential), euler_characteristic(results.front()));
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261124);
  test_support::Random random(seed);
  each_number_belongs_to_one_chunk();
  loops_end_when_they_are_told_to();
  for(const Indexed_mesh& indexed :
      {noisy_sphere(3, .1, seed), rough_terrain(12, 2., seed), midpoint_subdivision(genus_2_polycube(), 1),
       random_cuts(noisy_sphere(2, .1, seed + 2), .15, seed + 3)})
  {
    test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    threads_do_not_change_certificates(tm, random);
    threads_do_not_change_the_relaxation(tm);
    threads_do_not_change_the_new_mesh(tm);
  }
  visitors_end_certificates(to_face_graph(noisy_sphere(3, .1, seed)));
  return test_result();
}
