// The nearest site of each vertex without a diagram: the same answers as those of a diagram, and as the distances from
// each site alone.

#include "expected_exceptions.h"
#include "several_threads.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace test_meshes;
namespace Geodesics = CGAL::Surface_mesh_geodesics;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
using Location = Voronoi::Face_location;
using Site_map = Mesh::Property_map<vertex_descriptor, std::size_t>;
using Distance_map = Mesh::Property_map<vertex_descriptor, double>;

const double infinity = std::numeric_limits<double>::infinity();

struct Maps
{
  Site_map site;
  Distance_map distance;

  explicit Maps(Mesh& mesh)
    : site(mesh.add_property_map<vertex_descriptor, std::size_t>("v:site", 77).first),
      distance(mesh.add_property_map<vertex_descriptor, double>("v:distance", 77.).first)
  {}
};

std::vector<Location> random_sites(const Mesh& mesh, std::size_t n, test_support::Random& random)
{
  std::vector<Location> result;
  for(std::size_t i = 0; i < n; ++i)
  {
    const face_descriptor f(static_cast<Mesh::size_type>(random.index(num_faces(mesh))));
    const double a = i % 3 == 2 ? 0. : random.uniform(), b = i % 3 != 0 ? 0. : random.uniform();
    result.emplace_back(f, Voronoi::Barycentric_coordinates{a * (1 - b), b, (1 - a) * (1 - b)});
  }
  return result;
}

// Labels and distances are those of the diagram, down to the last bit, and no site alone is nearer.
void check_labels(Mesh& mesh, const std::vector<Location>& sites, const std::vector<double>& weights)
{
  Maps labels(mesh), alone(mesh);
  const auto np = CGAL::parameters::vertex_distance_map(labels.distance).site_weights(weights);
  CHECK(Geodesics::geodesic_Voronoi_labels(mesh, labels.site, sites, np));
  Voronoi voronoi(mesh);
  for(std::size_t i = 0; i < sites.size(); ++i)
    voronoi.add_site(sites[i], weights.empty() ? 0. : weights[i]);
  for(const vertex_descriptor v : vertices(mesh))
  {
    CHECK_EQUAL(labels.site[v], voronoi.nearest_site(v));
    if(labels.site[v] != Voronoi::null_site())
      CHECK_EQUAL(labels.distance[v], voronoi.distance_to_nearest_site(v));
    else
      CHECK_EQUAL(labels.distance[v], infinity);
  }
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    Distance_map distance = mesh.add_property_map<vertex_descriptor, double>("v:alone").first;
    Geodesics::geodesic_distances(mesh, distance, sites[i]);
    const double weight = weights.empty() ? 0. : weights[i];
    for(const vertex_descriptor v : vertices(mesh))
    {
      const double d = distance[v] - weight;
      CHECK(labels.distance[v] <= d + 1e-12 * (1 + distance[v]));
      if(labels.site[v] == i)
        CHECK_NEAR(labels.distance[v], d, 1e-12 * (1 + distance[v]));
    }
  }
}

void labels_are_those_of_diagrams(std::uint64_t seed)
{
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : small_collection(seed))
    for(const std::size_t n : {1u, 2u, 7u, 20u})
      for(const bool has_weights : {false, true})
      {
        const test_support::Scope scope(indexed.name + ", " + std::to_string(n) + " sites");
        Mesh mesh = to_face_graph(indexed);
        std::vector<double> weights;
        for(std::size_t i = 0; has_weights && i < n; ++i)
          weights.push_back(random.uniform(-.3, .3));
        check_labels(mesh, random_sites(mesh, n, random), weights);
      }
}

// Vertices as sites, some of them twice, on symmetric meshes: ties are decided as in the diagram.
void ties_are_those_of_diagrams()
{
  for(const Indexed_mesh& indexed : {flat_patch(4, 4, 0., false, 1), cube_grid(3), icosphere(1), saddle_fan(6),
                                     torus(1., .4, 8, 8)})
    for(std::size_t step = 1; step < 6; ++step)
    {
      const test_support::Scope scope(indexed.name + ", every " + std::to_string(step) + "th vertex");
      Mesh mesh = to_face_graph(indexed);
      const Maps labels(mesh);
      Voronoi voronoi(mesh);
      std::vector<vertex_descriptor> sites;
      for(std::size_t i = 0; i < 2 * num_vertices(mesh); i += step)
        sites.push_back(vertex_descriptor(static_cast<Mesh::size_type>(i % num_vertices(mesh))));
      voronoi.add_sites(sites);
      CHECK(Geodesics::geodesic_Voronoi_labels(mesh, labels.site, sites));
      for(const vertex_descriptor v : vertices(mesh))
        CHECK_EQUAL(labels.site[v], voronoi.nearest_site(v));
    }
}

void unreached_vertices_have_no_site()
{
  Mesh mesh = to_face_graph(two_components_and_an_isolated_vertex());
  const Maps labels(mesh);
  const std::vector<vertex_descriptor> none;
  CHECK(Geodesics::geodesic_Voronoi_labels(mesh, labels.site, none,
                                           CGAL::parameters::vertex_distance_map(labels.distance)));
  for(const vertex_descriptor v : vertices(mesh))
  {
    CHECK_EQUAL(labels.site[v], Voronoi::null_site());
    CHECK_EQUAL(labels.distance[v], infinity);
  }
  CHECK(Geodesics::geodesic_Voronoi_labels(mesh, labels.site, vertex_descriptor(0))); // one site, not a range
  CHECK_EQUAL(labels.site[vertex_descriptor(0)], std::size_t(0));
  CHECK_EQUAL(labels.site[*std::prev(vertices(mesh).end())], Voronoi::null_site());
}

// A heavier site is nearer, the distances are reduced by the weights, and float is a type for distances.
void weights_are_subtracted()
{
  Mesh mesh = to_face_graph(flat_patch(10, 1, 0., false, 1));
  const Maps labels(mesh);
  auto rounded = mesh.add_property_map<vertex_descriptor, float>("v:rounded").first;
  const auto at = [&](double x)
  {
    return *std::find_if(vertices(mesh).begin(), vertices(mesh).end(), [&](vertex_descriptor v)
    { return mesh.point(v).x() == x && mesh.point(v).y() == 0; });
  };
  const double right = mesh.point(*std::prev(vertices(mesh).end())).x();
  const std::vector<vertex_descriptor> sites = {at(0), at(right)};
  const auto weights = CGAL::parameters::site_weights(std::array<double, 2>{{right / 2, 0.}});
  CHECK(Geodesics::geodesic_Voronoi_labels(mesh, labels.site, sites, weights.vertex_distance_map(labels.distance)));
  CHECK(Geodesics::geodesic_Voronoi_labels(mesh, labels.site, sites, weights.vertex_distance_map(rounded)));
  for(const vertex_descriptor v : vertices(mesh))
  {
    const double x = mesh.point(v).x();
    if(mesh.point(v).y() != 0 || std::abs(x - .75 * right) < 1e-9)
      continue;
    CHECK_EQUAL(labels.site[v], x < .75 * right ? std::size_t(0) : std::size_t(1));
    CHECK_NEAR(labels.distance[v], (std::min)(x - right / 2, right - x), 1e-12 * right);
    CHECK_EQUAL(rounded[v], static_cast<float>(labels.distance[v]));
  }
}

void invalid_weights_are_rejected()
{
  Mesh mesh = to_face_graph(icosphere(1));
  const Maps labels(mesh);
  const std::vector<vertex_descriptor> sites = {vertex_descriptor(0), vertex_descriptor(5)};
  const auto rejects = [&](const std::vector<double>& weights)
  {
    const auto np = CGAL::parameters::vertex_distance_map(labels.distance).site_weights(weights);
    return throws<Invalid_input>([&] { Geodesics::geodesic_Voronoi_labels(mesh, labels.site, sites, np); });
  };
  CHECK(rejects({0., infinity}));
  CHECK(rejects({0., std::numeric_limits<double>::quiet_NaN()}));
  CHECK(rejects({1e308, -1e308}));
  CHECK(rejects({1.}));
  CHECK(throws<Invalid_input>([&]
  { Geodesics::geodesic_Voronoi_labels(mesh, labels.site, boost::graph_traits<Mesh>::null_vertex()); }));
  CHECK_EQUAL(labels.site[vertex_descriptor(0)], std::size_t(77));
  CHECK_EQUAL(labels.distance[vertex_descriptor(0)], 77.);
}

struct Canceling_visitor : Geodesics::Geodesic_default_visitor
{
  int number_of_calls = 0;
  bool go_further() { return ++number_of_calls < 10; }
};

void a_visitor_cancels()
{
  Mesh mesh = to_face_graph(icosphere(2));
  const Maps labels(mesh);
  Canceling_visitor visitor;
  Geodesics::Propagation_statistics counts;
  CHECK(!Geodesics::geodesic_Voronoi_labels(mesh, labels.site, vertex_descriptor(3),
                                            CGAL::parameters::statistics(&counts).visitor(std::ref(visitor))));
  CHECK_EQUAL(visitor.number_of_calls, 10);
  CHECK_EQUAL(labels.site[vertex_descriptor(0)], std::size_t(77));
  CHECK(counts.windows_propagated > 0);
}

// The counts are those of the distances, and a second call adds to them.
void statistics_are_added()
{
  Mesh mesh = to_face_graph(noisy_sphere(3, .1, 5));
  const Maps maps(mesh);
  const std::vector<vertex_descriptor> sites = {vertex_descriptor(0), vertex_descriptor(100)};
  Geodesics::Propagation_statistics of_distances, of_labels;
  CHECK(Geodesics::geodesic_distances(mesh, maps.distance, sites, CGAL::parameters::statistics(&of_distances)));
  for(std::size_t calls = 1; calls <= 2; ++calls)
  {
    CHECK(Geodesics::geodesic_Voronoi_labels(mesh, maps.site, sites, CGAL::parameters::statistics(&of_labels)));
    CHECK_EQUAL(of_labels.windows_propagated, calls * of_distances.windows_propagated);
  }
  CHECK(of_distances.windows_propagated > 0);
}

// A mesh of another type, with maps that are not its own.
void a_polyhedron_is_accepted()
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>, CGAL::Polyhedron_items_with_id_3>;
  using Vertex = boost::graph_traits<Polyhedron>::vertex_descriptor;
  Polyhedron polyhedron;
  CGAL::copy_face_graph(to_face_graph(icosphere(2)), polyhedron);
  std::map<Vertex, std::size_t> site;
  std::map<Vertex, double> distance;
  const std::vector<Vertex> sites = {*vertices(polyhedron).begin(), *std::prev(vertices(polyhedron).end())};
  CHECK(Geodesics::geodesic_Voronoi_labels<test_support::Several_threads>(
    polyhedron, boost::make_assoc_property_map(site), sites,
    CGAL::parameters::vertex_distance_map(boost::make_assoc_property_map(distance))));
  CHECK_EQUAL(site.size(), num_vertices(polyhedron));
  CHECK_EQUAL(site[sites[1]], std::size_t(1));
  CHECK_EQUAL(distance[sites[0]], 0.);
}

// The unit of a mesh has no meaning: weights of the size of a large mesh are as good as small ones.
void weights_have_the_unit_of_the_mesh()
{
  for(const double size : {1e-13, 1., 1e13, 1e40})
  {
    Mesh mesh;
    const std::vector<vertex_descriptor> sites{mesh.add_vertex(Kernel::Point_3(0, 0, 0)),
                                               mesh.add_vertex(Kernel::Point_3(size, 0, 0))};
    const vertex_descriptor last = mesh.add_vertex(Kernel::Point_3(0, size, 0));
    mesh.add_face(sites[0], sites[1], last);
    const Maps maps(mesh);
    CHECK(Geodesics::geodesic_Voronoi_labels(
      mesh, maps.site, sites,
      CGAL::parameters::site_weights(std::vector<double>{0., .2 * size}).vertex_distance_map(maps.distance)));
    CHECK_EQUAL(maps.site[last], 0u);
    CHECK_CLOSE(maps.distance[sites[1]], -.2 * size, 1e-14);
  }
}

// Paths along a zigzag bend at every other vertex. All labels together take linear time all the same; with a search
// along each path, this would take minutes.
void labels_behind_many_bends()
{
  const std::size_t n = 200000;
  Mesh mesh;
  std::vector<vertex_descriptor> low, high;
  for(std::size_t i = 0; i <= n; ++i)
  {
    const double x = static_cast<double>(i), y = i % 2 == 0 ? 0. : 3.;
    low.push_back(mesh.add_vertex(Kernel::Point_3(x, y - .3, 0)));
    high.push_back(mesh.add_vertex(Kernel::Point_3(x, y + .3, 0)));
  }
  for(std::size_t i = 0; i < n; ++i)
  {
    mesh.add_face(low[i], low[i + 1], high[i + 1]);
    mesh.add_face(low[i], high[i + 1], high[i]);
  }
  const Maps maps(mesh);
  CHECK(Geodesics::geodesic_Voronoi_labels(mesh, maps.site, std::vector<vertex_descriptor>{low.front(), low.back()},
                                           CGAL::parameters::vertex_distance_map(maps.distance)));
  for(std::size_t i = 0; i <= n; ++i)
    if(2 * i != n)
      CHECK_EQUAL(maps.site[high[i]], std::size_t(2 * i > n));
}

} // namespace

int main()
{
  weights_have_the_unit_of_the_mesh();
  labels_behind_many_bends();
  const std::uint64_t seed = test_support::announce_seed(20261123);
  labels_are_those_of_diagrams(seed);
  ties_are_those_of_diagrams();
  unreached_vertices_have_no_site();
  weights_are_subtracted();
  invalid_weights_are_rejected();
  a_visitor_cancels();
  statistics_are_added();
  a_polyhedron_is_accepted();
  return test_result();
}
