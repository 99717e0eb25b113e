// Visitors of the functions that propagate more than once, and of the geodesic Voronoi diagram. At any time when a
// visitor cancels, the function returns exactly the results that were finished before.

#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

namespace {

namespace Geodesics = CGAL::Surface_mesh_geodesics;
using namespace test_meshes;
using Voronoi
  = CGAL::Surface_mesh_geodesic_Voronoi_diagram<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;
using Vertices = std::vector<vertex_descriptor>;

const std::size_t never = (std::numeric_limits<std::size_t>::max)();

// Has exactly the members that the concept requires, and cannot be copied.
class Counting_visitor
{
public:
  explicit Counting_visitor(std::size_t questions_until_stop) : m_questions_until_stop(questions_until_stop) {}
  Counting_visitor(const Counting_visitor&) = delete;
  Counting_visitor& operator=(const Counting_visitor&) = delete;

  void on_propagation_begin(std::size_t n)
  {
    CHECK_EQUAL(begins, ends);
    ++begins;
    number_of_vertices = n;
    m_reached = -std::numeric_limits<double>::infinity();
  }

  void on_progress(std::size_t, double reached)
  {
    CHECK(reached >= m_reached);
    m_reached = reached;
  }

  bool go_further()
  {
    CHECK(!has_stopped);
    has_stopped = ++questions > m_questions_until_stop;
    return !has_stopped;
  }

  void on_propagation_end()
  {
    ++ends;
    CHECK_EQUAL(begins, ends);
  }

  std::size_t begins = 0, ends = 0, questions = 0, number_of_vertices = 0;
  bool has_stopped = false;

private:
  std::size_t m_questions_until_stop;
  double m_reached = 0.;
};

Mesh bumpy_mesh()
{
  Indexed_mesh mesh = icosphere(3);
  for(Coordinates& p : mesh.points)
  {
    p = (1. + .2 * p[0] * p[1]) * p;
  }
  return to_face_graph(mesh);
}

// Returns the numbers of calls of go_further() after which a visitor cancels a run that would make `number` calls.
std::vector<std::size_t> stops(std::size_t number)
{
  std::vector<std::size_t> result;
  for(std::size_t n = 0; n < number; n += 1 + n / 3)
  {
    result.push_back(n);
  }
  result.push_back(number - 1);
  return result;
}

void sampling_is_canceled(const Mesh& mesh)
{
  test_support::Scope scope("sampling");
  const std::size_t n = 12;
  Vertices all;
  Counting_visitor whole(never);
  const auto np = CGAL::parameters::visitor(std::ref(whole));
  const double smallest = Geodesics::geodesic_farthest_point_sampling(mesh, n, std::back_inserter(all), np);
  CHECK_EQUAL(all.size(), n);
  CHECK_EQUAL(whole.begins, n);
  CHECK_EQUAL(whole.number_of_vertices, std::size_t(num_vertices(mesh)));
  Vertices without_visitor;
  CHECK_EQUAL(Geodesics::geodesic_farthest_point_sampling(mesh, n, std::back_inserter(without_visitor)), smallest);
  CHECK(all == without_visitor);

  std::vector<double> radius{std::numeric_limits<double>::infinity()}; // radius[i] belongs to the first i samples
  for(std::size_t i = 1; i <= n; ++i)
  {
    Vertices samples;
    radius.push_back(Geodesics::geodesic_farthest_point_sampling(mesh, i, std::back_inserter(samples)));
  }
  for(const std::size_t stop : stops(whole.questions))
  {
    Counting_visitor visitor(stop);
    Vertices samples;
    const double r = Geodesics::geodesic_farthest_point_sampling(mesh, n, std::back_inserter(samples),
                                                                 CGAL::parameters::visitor(std::ref(visitor)));
    CHECK(visitor.has_stopped);
    CHECK_EQUAL(visitor.begins, samples.size() + 1);
    CHECK(std::equal(samples.begin(), samples.end(), all.begin()));
    CHECK_EQUAL(r, radius[samples.size()]);
  }
}

void diagram_is_canceled(const Mesh& mesh, const Vertices& sites)
{
  test_support::Scope scope("diagram");
  Voronoi right(mesh);
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    right.add_site(sites[i], .01 * static_cast<double>(i));
  }
  Counting_visitor whole(never);
  CHECK(right.build(whole));
  CHECK_EQUAL(whole.begins, 1u);
  const std::size_t questions = whole.questions;
  CHECK(right.build(whole)); // the diagram is already built
  CHECK_EQUAL(whole.questions, questions);

  Voronoi voronoi(mesh);
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    voronoi.add_site(sites[i], .01 * static_cast<double>(i));
  }
  for(const std::size_t stop : stops(questions))
  {
    Counting_visitor visitor(stop);
    CHECK(!voronoi.build(visitor));
    CHECK(visitor.has_stopped);
    CHECK(!voronoi.is_built());
  }
  CHECK_EQUAL(voronoi.arcs().size(), right.arcs().size());
  for(std::size_t i = 0; i < right.arcs().size(); ++i)
  {
    CHECK(voronoi.arcs()[i].sites() == right.arcs()[i].sites());
    CHECK_EQUAL(voronoi.arcs()[i].length(), right.arcs()[i].length());
  }
}

// After an exception of a visitor the diagram can still be built.
struct Throwing_visitor : Geodesics::Geodesic_default_visitor
{
  void on_progress(std::size_t number_of_visits, double)
  {
    if(number_of_visits > 20)
    {
      throw std::runtime_error("enough");
    }
  }
};

void diagram_survives_exceptions(const Mesh& mesh, const Vertices& sites)
{
  test_support::Scope scope("exception");
  Voronoi voronoi(mesh), right(mesh);
  voronoi.add_sites(sites);
  right.add_sites(sites);
  Throwing_visitor visitor;
  for(int i = 0; i < 2; ++i)
  {
    CHECK(throws<std::runtime_error>([&] { voronoi.build(visitor); }));
    CHECK(!voronoi.is_built());
  }
  CHECK_EQUAL(voronoi.arcs().size(), right.arcs().size());
  CHECK_EQUAL(voronoi.area(0), right.area(0));
}

void relaxation_is_canceled(const Mesh& mesh, const Vertices& sites)
{
  test_support::Scope scope("relaxation");
  const std::size_t n = 3;
  std::vector<Vertices> after(n + 1); // after[i] belongs to i iterations
  for(std::size_t i = 0; i <= n; ++i)
  {
    CHECK_EQUAL(Geodesics::geodesic_Lloyd_relaxation(mesh, sites, std::back_inserter(after[i]),
                                                     CGAL::parameters::number_of_iterations(i)),
                i);
  }
  Counting_visitor whole(never);
  Vertices moved;
  const auto np = CGAL::parameters::number_of_iterations(n);
  CHECK_EQUAL(Geodesics::geodesic_Lloyd_relaxation(mesh, sites, std::back_inserter(moved),
                                                   np.visitor(std::ref(whole))),
              n);
  CHECK(moved == after[n]);
  CHECK_EQUAL(whole.begins, n);
  for(const std::size_t stop : stops(whole.questions))
  {
    Counting_visitor visitor(stop);
    moved.clear();
    const std::size_t i = Geodesics::geodesic_Lloyd_relaxation(mesh, sites, std::back_inserter(moved),
                                                               np.visitor(std::ref(visitor)));
    CHECK_EQUAL(visitor.begins, i + 1);
    CHECK(moved == after[i]);
  }
}

void remeshing_is_canceled(const Mesh& mesh)
{
  test_support::Scope scope("remeshing");
  const std::size_t n = 20;
  Counting_visitor whole(never);
  Mesh output;
  const auto np = CGAL::parameters::visitor(std::ref(whole)).number_of_iterations(2);
  CHECK(Geodesics::geodesic_remeshing(mesh, n, output, np).is_manifold());
  CHECK_EQUAL(num_vertices(output), n);
  CHECK_EQUAL(whole.begins, n + 2 + 1); // samples, iterations, the last diagram
  for(const std::size_t stop : stops(whole.questions))
  {
    Counting_visitor visitor(stop);
    Mesh nothing;
    const auto np_canceled = CGAL::parameters::visitor(std::ref(visitor)).number_of_iterations(2);
    CHECK(!Geodesics::geodesic_remeshing(mesh, n, nothing, np_canceled).is_manifold());
    CHECK(visitor.has_stopped); // go_further() checks that it is not called again
    CHECK_EQUAL(num_vertices(nothing), 0u);
  }
}

} // namespace

int main()
{
  const Mesh mesh = bumpy_mesh();
  Vertices sites;
  for(int i = 0; i < 10; ++i)
  {
    sites.push_back(*std::next(vertices(mesh).begin(), 3 * i));
  }
  sampling_is_canceled(mesh);
  diagram_is_canceled(mesh, sites);
  diagram_survives_exceptions(mesh, sites);
  relaxation_is_canceled(mesh, sites);
  remeshing_is_canceled(mesh);
  return test_result();
}
