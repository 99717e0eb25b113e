// Farthest point sampling, and the propagation that continues with one more source.

#include "expected_exceptions.h"
#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace test_meshes;
namespace Geodesics = CGAL::Surface_mesh_geodesics;

std::vector<double> distances_from(const Mesh& mesh, const std::vector<vertex_descriptor>& sources)
{
  std::vector<double> result(num_vertices(mesh));
  Geodesics::geodesic_distances(
    mesh, CGAL::make_property_map(result), sources);
  return result;
}

// After each step the distances are those of a run with all samples, so the next sample is the farthest vertex.
void each_sample_is_the_farthest_vertex(std::uint64_t seed)
{
  for(const Indexed_mesh& indexed : small_collection(seed))
  {
    const test_support::Scope scope(indexed.name);
    const Mesh mesh = to_face_graph(indexed);
    std::vector<vertex_descriptor> samples;
    std::size_t number_of_candidates = 0;
    for(const vertex_descriptor v : vertices(mesh))
      number_of_candidates += halfedge(v, mesh) != Mesh::null_halfedge() ? 1 : 0;
    const double radius = Geodesics::geodesic_farthest_point_sampling(mesh, 12, std::back_inserter(samples));
    CHECK_EQUAL(samples.size(), (std::min)(std::size_t(12), number_of_candidates));
    for(std::size_t i = 1; i <= samples.size(); ++i)
    {
      const std::vector<double> d
        = distances_from(mesh, std::vector<vertex_descriptor>(samples.begin(), samples.begin() + std::ptrdiff_t(i)));
      double farthest = 0;
      for(const vertex_descriptor v : vertices(mesh))
        if(halfedge(v, mesh) != Mesh::null_halfedge())
          farthest = (std::max)(farthest, d[v]);
      if(i == samples.size())
        CHECK_CLOSE(radius, farthest, 1e-12);
      else
        CHECK_CLOSE(d[samples[i]], farthest, 1e-12);
    }
  }
}

// A continued propagation has the result of a new one, for sources at any vertices and in any order.
void continued_propagations_equal_new_ones(std::uint64_t seed)
{
  using namespace Geodesics::internal;
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : small_collection(seed + 1))
  {
    const test_support::Scope scope(indexed.name);
    const Intrinsic_mesh<double> mesh = intrinsic_mesh(to_face_graph(indexed));
    const auto go_on = [](std::size_t, double) { return true; };
    Vertex_distance_field<double> field;
    Distance_propagation<double> continued(mesh, field);
    std::vector<std::pair<Vertex_id, double>> sources;
    for(int step = 0; step < 8; ++step)
    {
      sources.emplace_back(static_cast<Vertex_id>(random.index(mesh.number_of_vertices())),
                           step % 2 == 0 ? 0. : random.uniform(0., .1));
      continued.add_source(sources.back().first, sources.back().second);
      CHECK(continued.run(go_on));
      Vertex_distance_field<double> fresh_field;
      Distance_propagation<double> fresh(mesh, fresh_field);
      for(const auto& s : sources)
        fresh.add_source(s.first, s.second);
      CHECK(fresh.run(go_on));
      CHECK_FIELDS_CLOSE(field.distance, fresh_field.distance, 1e-12);
      CHECK_EQUAL(continued.reached_distance(), fresh.reached_distance());
    }
  }
}

// Fifty samples take about as many windows as one run from the first sample, and some more around each cell.
void many_samples_cost_few_windows()
{
  const Mesh mesh = to_face_graph(noisy_sphere(4, .02, 5));
  Geodesics::Propagation_statistics one, many;
  std::vector<vertex_descriptor> samples;
  Geodesics::geodesic_farthest_point_sampling(mesh, 1, std::back_inserter(samples), CGAL::parameters::statistics(&one));
  // The statistics are added.
  Geodesics::Propagation_statistics two = one;
  Geodesics::geodesic_farthest_point_sampling(mesh, 1, std::back_inserter(samples), CGAL::parameters::statistics(&two));
  CHECK(one.windows_propagated > 0 && two.windows_propagated == 2 * one.windows_propagated);
  samples.clear();
  Geodesics::geodesic_farthest_point_sampling(mesh, 50, std::back_inserter(samples),
                                              CGAL::parameters::statistics(&many));
  std::cout << "windows propagated: " << one.windows_propagated << " for one sample, " << many.windows_propagated
            << " for 50" << std::endl;
  CHECK(many.windows_propagated < 5 * one.windows_propagated);
}

void parameters_are_obeyed()
{
  const Mesh mesh = to_face_graph(icosphere(3));
  std::vector<vertex_descriptor> samples;
  const std::vector<vertex_descriptor> first = {vertex_descriptor(7), vertex_descriptor(11)};
  const auto np = CGAL::parameters::first_samples(first).covering_radius(.5);
  const double radius = Geodesics::geodesic_farthest_point_sampling(mesh, 1000, std::back_inserter(samples), np);
  CHECK(radius <= .5);
  CHECK(samples.size() > 10 && samples.size() < 100);
  std::vector<vertex_descriptor> all = first;
  all.insert(all.end(), samples.begin(), samples.end());
  const std::vector<double> d = distances_from(mesh, all);
  CHECK_CLOSE(*std::max_element(d.begin(), d.end()), radius, 1e-12);
  // With one sample less, the mesh is not covered.
  all.pop_back();
  const std::vector<double> without = distances_from(mesh, all);
  CHECK(*std::max_element(without.begin(), without.end()) > .5);

  samples.clear();
  const std::vector<double> from_first = distances_from(mesh, first);
  CHECK_EQUAL(Geodesics::geodesic_farthest_point_sampling(mesh, 2, std::back_inserter(samples), np),
              *std::max_element(from_first.begin(), from_first.end()));
  CHECK(samples.empty());

  for(const double bad : {-1., std::numeric_limits<double>::quiet_NaN()})
  {
    CHECK(throws_reason(Reason::INVALID_RADIUS, [&] {
      Geodesics::geodesic_farthest_point_sampling(mesh, 2, std::back_inserter(samples),
                                                  CGAL::parameters::covering_radius(bad));
    }));
    CHECK(samples.empty());
  }
}

// Each component gets a sample, isolated vertices get none. The numbers of samples range from none to all vertices.
void each_component_gets_a_sample()
{
  const Mesh mesh = to_face_graph(two_components_and_an_isolated_vertex());
  std::vector<vertex_descriptor> samples;
  CHECK_EQUAL(Geodesics::geodesic_farthest_point_sampling(mesh, 0, std::back_inserter(samples)),
              std::numeric_limits<double>::infinity());
  CHECK(samples.empty());
  CHECK_EQUAL(Geodesics::geodesic_farthest_point_sampling(mesh, 1, std::back_inserter(samples)),
              std::numeric_limits<double>::infinity());
  samples.clear();
  CHECK(Geodesics::geodesic_farthest_point_sampling(mesh, 2, std::back_inserter(samples)) < 100.);
  samples.clear();
  CHECK_EQUAL(Geodesics::geodesic_farthest_point_sampling(mesh, 1000, std::back_inserter(samples)), 0.);
  CHECK_EQUAL(samples.size(), num_vertices(mesh) - 1);
  CHECK_EQUAL(Geodesics::geodesic_farthest_point_sampling(Mesh(), 10, std::back_inserter(samples)), 0.);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260401);
  each_component_gets_a_sample();
  parameters_are_obeyed();
  many_samples_cost_few_windows();
  continued_propagations_equal_new_ones(seed);
  each_sample_is_the_farthest_vertex(seed);
  return test_result();
}
