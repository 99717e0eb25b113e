// Lloyd relaxation, remeshing by the dual, and the report of what prevents a manifold dual.

#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace test_meshes;
namespace Geodesics = CGAL::Surface_mesh_geodesics;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// At most n iterations. Returns how many moved a site.
std::size_t relax(const Mesh& mesh, const std::vector<vertex_descriptor>& sites, std::size_t n,
                  std::vector<vertex_descriptor>& moved)
{
  return Geodesics::geodesic_Lloyd_relaxation(mesh, sites, std::back_inserter(moved),
                                              CGAL::parameters::number_of_iterations(n));
}

int Euler_characteristic(const Mesh& mesh)
{
  return static_cast<int>(num_vertices(mesh)) - static_cast<int>(num_edges(mesh)) + static_cast<int>(num_faces(mesh));
}

// Returns the largest area of a cell, divided by the mean area.
double unevenness(const Mesh& mesh, const std::vector<vertex_descriptor>& sites)
{
  Voronoi voronoi(mesh);
  voronoi.add_sites(sites);
  double largest = 0, sum = 0;
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    largest = (std::max)(largest, voronoi.area(i));
    sum += voronoi.area(i);
  }
  return largest * static_cast<double>(sites.size()) / sum;
}

void relaxation_makes_cells_even(std::uint64_t seed)
{
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : {noisy_sphere(3, .02, seed), torus(1., .4, 40, 20), rough_terrain(20, .5, seed)})
  {
    const test_support::Scope scope(indexed.name);
    const Mesh mesh = to_face_graph(indexed);
    std::vector<vertex_descriptor> sites, moved, same;
    for(int i = 0; i < 20; ++i)
      sites.push_back(vertex_descriptor(static_cast<Mesh::size_type>(random.index(num_vertices(mesh)))));
    CHECK_EQUAL(relax(mesh, sites, 0, same), 0u);
    CHECK(same == sites);
    const std::size_t n = relax(mesh, sites, 50, moved);
    CHECK_EQUAL(moved.size(), sites.size());
    CHECK(n > 1);
    CHECK(unevenness(mesh, moved) < unevenness(mesh, sites));
    // a relaxation that has converged does not move its sites
    if(n < 50)
    {
      same.clear();
      CHECK_EQUAL(Geodesics::geodesic_Lloyd_relaxation(mesh, moved, std::back_inserter(same)), 0u);
      CHECK(same == moved);
    }
  }
}

void remeshing_keeps_topology_and_volume(std::uint64_t seed)
{
  for(const Indexed_mesh& indexed : {noisy_sphere(4, .01, seed), torus(1., .4, 48, 24),
                                     midpoint_subdivision(jittered(genus_2_polycube(), .1, seed), 3)})
  {
    const test_support::Scope scope(indexed.name);
    const Mesh mesh = to_face_graph(indexed);
    Mesh output;
    const Geodesics::Geodesic_remeshing_report report = Geodesics::geodesic_remeshing(mesh, 150, output);
    CHECK(report.is_manifold());
    CHECK_EQUAL(report.number_of_added_samples, std::size_t(0));
    CHECK_EQUAL(num_vertices(output), std::size_t(150));
    CHECK(CGAL::is_triangle_mesh(output));
    CHECK(CGAL::is_valid_polygon_mesh(output));
    CHECK(CGAL::is_closed(output));
    CHECK_EQUAL(Euler_characteristic(output), Euler_characteristic(mesh));
    const double before = CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh));
    const double after = CGAL::to_double(CGAL::Polygon_mesh_processing::volume(output));
    CHECK(after > .8 * before && after < 1.05 * before); // the volume is negative if the orientation is wrong
  }
  const Mesh patch = to_face_graph(rough_terrain(24, .3, seed));
  CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> polyhedron;
  const Geodesics::Geodesic_remeshing_report report
    = Geodesics::geodesic_remeshing(patch, 60, polyhedron, CGAL::parameters::number_of_iterations(2u));
  CHECK(report.is_manifold());
  CHECK(polyhedron.is_valid() && !polyhedron.is_closed());
  CHECK_EQUAL(polyhedron.size_of_vertices(), 60 + report.number_of_added_samples);
}

// One cell that is the whole sphere; two cells with a closed edge.
void one_or_two_cells_have_no_dual()
{
  const Mesh sphere = to_face_graph(icosphere(2));
  Mesh output;
  Voronoi voronoi(sphere);
  voronoi.add_site(vertex_descriptor(0));
  Geodesics::Geodesic_dual_report r = Geodesics::geodesic_dual_mesh(voronoi, output);
  CHECK(!r.is_manifold());
  CHECK(r.cells_that_are_not_disks == std::vector<std::size_t>{0});
  voronoi.add_site(vertex_descriptor(3));
  r = Geodesics::geodesic_dual_mesh(voronoi, output);
  CHECK(!r.is_manifold());
  CHECK(r.cells_that_are_not_disks.empty());
  CHECK((r.pairs_without_triangle == Pairs{{0, 1}}));
  CHECK_EQUAL(r.cells_without_triangle.size(), std::size_t(2));
  CHECK_EQUAL(num_vertices(output), std::size_t(0));
}

// Three cells on a thin torus are rings.
void ring_cells_are_reported()
{
  const Mesh ring = to_face_graph(torus(1., .2, 36, 9));
  Voronoi voronoi(ring);
  for(std::size_t i = 0; i < 3; ++i)
    voronoi.add_site(vertex_descriptor(static_cast<Mesh::size_type>(num_vertices(ring) / 3 * i)));
  const Geodesics::Geodesic_dual_report r = Geodesics::check_geodesic_dual(voronoi);
  CHECK(!r.is_manifold());
  CHECK_EQUAL(r.cells_that_are_not_disks.size(), std::size_t(3));
}

vertex_descriptor nearest_vertex(const Mesh& mesh, const Kernel::Point_3& p)
{
  return *std::min_element(vertices(mesh).begin(), vertices(mesh).end(), [&](auto a, auto b)
  { return CGAL::squared_distance(mesh.point(a), p) < CGAL::squared_distance(mesh.point(b), p); });
}

// Three sites on the equator of a sphere: all cells meet at two vertices. With one more site at a pole, the dual is a
// tetrahedron.
void cells_with_two_common_vertices_are_reported()
{
  const Mesh sphere = to_face_graph(noisy_sphere(3, .01, 7));
  Voronoi voronoi(sphere);
  for(std::size_t i = 0; i < 3; ++i)
  {
    const double angle = 2 * pi * static_cast<double>(i) / 3;
    voronoi.add_site(nearest_vertex(sphere, Kernel::Point_3(std::cos(angle), std::sin(angle), 0)));
  }
  const Geodesics::Geodesic_dual_report r = Geodesics::check_geodesic_dual(voronoi);
  CHECK(!r.is_manifold());
  CHECK_EQUAL(r.triples_with_several_vertices.size(), std::size_t(1));
  CHECK(r.cells_that_are_not_disks.empty());
  voronoi.add_site(nearest_vertex(sphere, Kernel::Point_3(0, 0, 1)));
  Mesh output;
  CHECK(Geodesics::geodesic_dual_mesh(voronoi, output).is_manifold());
  CHECK_EQUAL(num_faces(output), std::size_t(4));
}

// Sites along a strip: edges run from border to border, and the cell in the middle has two parts of boundary.
void edges_from_border_to_border_are_reported()
{
  const Mesh mesh = to_face_graph(flat_patch(30, 2, 0., false, 1));
  Voronoi voronoi(mesh);
  for(const double x : {.1, .5, .9})
    voronoi.add_site(*std::min_element(vertices(mesh).begin(), vertices(mesh).end(), [&](auto a, auto b)
    {
      const double width = 30;
      return std::abs(mesh.point(a).x() - width * x) + mesh.point(a).y()
           < std::abs(mesh.point(b).x() - width * x) + mesh.point(b).y();
    }));
  const Geodesics::Geodesic_dual_report r = Geodesics::check_geodesic_dual(voronoi);
  CHECK(!r.is_manifold());
  CHECK((r.pairs_without_triangle == Pairs{{0, 1}, {1, 2}}));
  CHECK(r.cells_with_several_boundaries == std::vector<std::size_t>{1});
}

// Cells on a thin tube are rings; the two at its ends have one boundary curve inside, the others two.
void rings_of_a_tube_are_reported()
{
  const Mesh tube = to_face_graph(prism_tube(6, 12, .2, 10.));
  Voronoi voronoi(tube);
  for(const std::size_t i : {std::size_t(0), std::size_t(num_vertices(tube) / 2), std::size_t(num_vertices(tube) - 1)})
    voronoi.add_site(vertex_descriptor(static_cast<Mesh::size_type>(i)));
  const Geodesics::Geodesic_dual_report r = Geodesics::check_geodesic_dual(voronoi);
  CHECK(!r.is_triangulation());
  CHECK((r.cells_that_are_not_disks == std::vector<std::size_t>{0, 1, 2}));
  CHECK((r.pairs_without_triangle == Pairs{{0, 1}, {1, 2}}));
}

// Four sites at the corners of a square: four cells meet in the middle, and the two triangles are one choice of two.
// If a site moves, three cells meet at each vertex.
void vertices_of_four_cells_are_reported()
{
  const Mesh mesh = to_face_graph(flat_patch(4, 4, 0., false, 1));
  for(const bool is_moved : {false, true})
  {
    const auto& last = mesh.point(*std::prev(vertices(mesh).end()));
    Voronoi voronoi(mesh);
    voronoi.add_site(nearest_vertex(mesh, is_moved ? Kernel::Point_3(last.x() / 4, last.y() / 4, 0)
                                                   : Kernel::Point_3(0, 0, 0)));
    voronoi.add_site(nearest_vertex(mesh, Kernel::Point_3(last.x(), 0, 0)));
    voronoi.add_site(nearest_vertex(mesh, Kernel::Point_3(last.x(), last.y(), 0)));
    voronoi.add_site(nearest_vertex(mesh, Kernel::Point_3(0, last.y(), 0)));
    const Geodesics::Geodesic_dual_report r = Geodesics::check_geodesic_dual(voronoi);
    CHECK(r.is_manifold());
    CHECK_EQUAL(r.is_triangulation(), is_moved);
    const std::vector<std::vector<std::size_t>> all{{0, 1, 2, 3}};
    CHECK(is_moved ? r.vertices_of_many_cells.empty() : r.vertices_of_many_cells == all);
  }
}

// Without an iteration, the sites are neither moved nor checked.
void no_iteration_moves_no_site()
{
  test_support::Scope scope("no iterations");
  const Mesh mesh = to_face_graph(icosphere(1));
  const std::vector<vertex_descriptor> sites = {vertex_descriptor(3), boost::graph_traits<Mesh>::null_vertex()};
  std::vector<vertex_descriptor> moved;
  CHECK_EQUAL(relax(mesh, sites, 0, moved), 0u);
  CHECK(moved == sites);
  moved.clear();
  CHECK(throws<Invalid_input>([&] { relax(mesh, sites, 1, moved); }));
  CHECK(moved.empty());
}

// A site that is an isolated vertex stays there, and the scale of the mesh does not matter.
void an_isolated_site_stays()
{
  const Indexed_mesh indexed = two_components_and_an_isolated_vertex();
  const vertex_descriptor isolated(static_cast<unsigned int>(indexed.points.size() - 1));
  const std::vector<vertex_descriptor> sites = {vertex_descriptor(0), isolated, vertex_descriptor(50)};
  std::vector<vertex_descriptor> expected;
  for(const int exponent : {0, 600, -600})
  {
    test_support::Scope scope("isolated site, scale 2^" + std::to_string(exponent));
    const Mesh mesh = to_face_graph(scaled(indexed, std::ldexp(1., exponent)));
    std::vector<vertex_descriptor> moved;
    relax(mesh, sites, 3, moved);
    CHECK(moved.size() == 3 && moved[1] == isolated);
    if(exponent == 0)
      expected = moved;
    CHECK(moved == expected);
  }
}

// The energy by its definition: the exact integral of |p - s|^2 over each triangle of the cut mesh.
double energy_of_cut(const Voronoi& voronoi, double tolerance)
{
  Mesh cut;
  auto site = cut.add_property_map<face_descriptor, std::size_t>("f:site").first;
  voronoi.cut(cut, site, tolerance);
  double sum = 0;
  for(const face_descriptor f : faces(cut))
  {
    const auto s = voronoi.point(voronoi.site(site[f]));
    const auto h = halfedge(f, cut);
    const auto a = cut.point(source(h, cut)) - s, b = cut.point(target(h, cut)) - s,
               c = cut.point(target(next(h, cut), cut)) - s;
    const double area = CGAL::to_double(CGAL::Polygon_mesh_processing::face_area(f, cut));
    sum += area / 12 * (a * a + b * b + c * c + (a + b + c) * (a + b + c));
  }
  return sum;
}

void energies_are_those_of_the_cut_mesh(std::uint64_t seed)
{
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : {noisy_sphere(2, .1, seed), rough_terrain(8, 1., seed), torus(1., .4, 12, 8)})
    for(const double scale : {1., 1e50, 1e-50})
      for(const double weight : {0., .3})
      {
        const test_support::Scope scope(indexed.name);
        const Mesh mesh = to_face_graph(scaled(indexed, scale));
        Voronoi voronoi(mesh);
        for(int i = 0; i < 8; ++i)
          voronoi.add_site(vertex_descriptor(static_cast<Mesh::size_type>(random.index(num_vertices(mesh)))),
                           random.uniform(0., weight) * scale);
        CHECK_CLOSE(voronoi.energy(), energy_of_cut(voronoi, 1e-5 * scale), weight == 0. ? 1e-5 : 1e-4);
      }
  // One site in the middle of a square of side 2: the integral of x^2 + y^2.
  Mesh square;
  const auto a = square.add_vertex({-1, -1, 0}), b = square.add_vertex({1, -1, 0}), c = square.add_vertex({1, 1, 0}),
             d = square.add_vertex({-1, 1, 0}), m = square.add_vertex({0, 0, 0});
  square.add_face(a, b, m);
  square.add_face(b, c, m);
  square.add_face(c, d, m);
  square.add_face(d, a, m);
  Voronoi voronoi(square);
  CHECK_EQUAL(voronoi.energy(), 0.);
  voronoi.add_site(m);
  CHECK_CLOSE(voronoi.energy(), 8. / 3, 1e-14);
  voronoi.add_site(a); // the cells are a triangle at the corner and the rest
  CHECK_CLOSE(voronoi.energy(), energy_of_cut(voronoi, 1e-9), 1e-12);
}

struct Iterations : Geodesics::Geodesic_default_visitor
{
  std::vector<double> moves, energies;

  void on_iteration(std::size_t iteration, double largest_move, double energy)
  {
    CHECK_EQUAL(iteration, moves.size() + 1);
    moves.push_back(largest_move);
    energies.push_back(energy);
  }
};

void visitors_see_the_energy_fall(std::uint64_t seed)
{
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : {noisy_sphere(3, .02, seed), torus(1., .4, 40, 20), rough_terrain(20, .5, seed)})
  {
    const test_support::Scope scope(indexed.name);
    const Mesh mesh = to_face_graph(indexed);
    std::vector<vertex_descriptor> sites, moved, stopped, expected;
    for(int i = 0; i < 20; ++i)
      sites.push_back(vertex_descriptor(static_cast<Mesh::size_type>(random.index(num_vertices(mesh)))));
    Iterations all;
    const auto np = CGAL::parameters::number_of_iterations(50);
    const std::size_t n = Geodesics::geodesic_Lloyd_relaxation(mesh, sites, std::back_inserter(moved),
                                                               np.visitor(std::ref(all)));
    CHECK_EQUAL(all.moves.size(), n + (n < 50 ? 1 : 0));
    if(n < 50)
      CHECK_EQUAL(all.moves.back(), 0.);
    CHECK(all.energies.back() < .8 * all.energies.front());
    for(std::size_t i = 1; i < all.energies.size(); ++i)
      CHECK(all.energies[i] < 1.02 * all.energies[i - 1]);

    // The sites of the first iteration that moves them by at most a threshold.
    const double threshold = 1.0001 * *std::min_element(all.moves.begin(), all.moves.begin() + 4);
    Iterations some;
    const std::size_t k = Geodesics::geodesic_Lloyd_relaxation(
      mesh, sites, std::back_inserter(stopped), np.visitor(std::ref(some)).threshold_distance(threshold));
    CHECK(k >= 1 && k <= 4 && some.moves.back() <= threshold);
    CHECK(std::equal(some.energies.begin(), some.energies.end(), all.energies.begin()));
    CHECK_EQUAL(relax(mesh, sites, k, expected), k);
    CHECK(stopped == expected);

    Iterations of_remeshing;
    Mesh output;
    Geodesics::geodesic_remeshing(mesh, 60, output,
                                  CGAL::parameters::visitor(std::ref(of_remeshing)).number_of_iterations(3u));
    CHECK(!of_remeshing.moves.empty() && of_remeshing.moves.size() <= 3);
  }
}

struct Cancels_after : Geodesics::Geodesic_default_visitor
{
  explicit Cancels_after(std::size_t n) : left(n) {}

  bool go_further() { return !(has_canceled = has_canceled || left-- == 0); }

  std::size_t left;
  bool has_canceled = false;
};

// Also where all vertices are samples, so that no round follows.
void a_canceled_remeshing_writes_nothing()
{
  const Mesh mesh = to_face_graph(icosphere(1));
  for(const std::size_t n : {std::size_t(20), std::size_t(num_vertices(mesh))})
  {
    bool has_canceled = true;
    for(std::size_t questions = 0; has_canceled; ++questions)
    {
      Cancels_after visitor(questions);
      Mesh output;
      const auto report
        = Geodesics::geodesic_remeshing(mesh, n, output, CGAL::parameters::visitor(std::ref(visitor)));
      has_canceled = visitor.has_canceled;
      CHECK_EQUAL(report.is_complete, !has_canceled);
      CHECK_EQUAL(num_vertices(output) == 0, has_canceled);
    }
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260402);
  one_or_two_cells_have_no_dual();
  ring_cells_are_reported();
  cells_with_two_common_vertices_are_reported();
  edges_from_border_to_border_are_reported();
  rings_of_a_tube_are_reported();
  vertices_of_four_cells_are_reported();
  no_iteration_moves_no_site();
  an_isolated_site_stays();
  a_canceled_remeshing_writes_nothing();
  energies_are_those_of_the_cut_mesh(seed);
  visitors_see_the_energy_fall(seed);
  relaxation_makes_cells_even(seed);
  remeshing_keeps_topology_and_volume(seed);
  return test_result();
}
