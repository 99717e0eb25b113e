// Diagrams whose cells are known without computing: polyhedra, a flat torus given by lengths, coincident and hidden
// sites, closed edges, cells that are not disks, several components.

#include "Voronoi_test_helpers.h"

using namespace test_meshes;

namespace {

struct Case
{
  Mesh tm;
  Weighted_sites sites;
  Voronoi diagram;

  Case(const Indexed_mesh& indexed, const Weighted_sites& s) : tm(to_face_graph(indexed)), sites(s), diagram(tm)
  {
    add_sites(diagram, sites);
  }

  void check_all()
  {
    test_support::Random random(1);
    Voronoi_validator(tm, diagram, sites).check_all(random, 100);
  }
};

Weighted_sites all_vertices(std::size_t n)
{
  Weighted_sites sites;
  for(std::size_t v = 0; v < n; ++v)
  {
    sites.emplace_back(vertex(v));
  }
  return sites;
}

void test_polyhedra()
{
  test_support::Scope scope("polyhedra");
  const std::vector<std::pair<Indexed_mesh, double>> solids
    = {{cube(), 6.}, {regular_tetrahedron(), 0.}, {octahedron(), 0.}, {icosahedron(), 0.}};
  for(const auto& solid : solids)
  {
    test_support::Scope scope_of_solid(solid.first.name);
    const std::size_t n = solid.first.points.size();
    Case c(solid.first, all_vertices(n));
    c.check_all();
    for(std::size_t i = 0; i < n; ++i) // all cells are alike
    {
      CHECK_CLOSE(c.diagram.area(i), c.diagram.area(0), 1e-12);
      CHECK(c.diagram.is_disk(i));
    }
    if(solid.second > 0.)
    {
      CHECK_CLOSE(c.diagram.area(0), solid.second / static_cast<double>(n), 1e-12);
    }
  }
  // one site: its cell is the whole octahedron
  Case c(octahedron(), {vertex(0)});
  CHECK(c.diagram.arcs().empty() && c.diagram.edges().empty());
  CHECK_EQUAL(c.diagram.Euler_characteristic(0), 2);
  c.check_all();
}

void test_one_site_and_none()
{
  test_support::Scope scope("one site");
  Case sphere(noisy_sphere(2, .1, 1), {vertex(3)}), ring(torus(1., .4, 10, 6), {vertex(3)}),
    genus_2(genus_2_polycube(), {vertex(3)}), hole(square_with_holes(1), {vertex(0)});
  for(Case* c : {&sphere, &ring, &genus_2, &hole})
  {
    c->check_all();
    CHECK(c->diagram.edges().empty() && c->diagram.boundary(0).empty());
  }
  CHECK_EQUAL(sphere.diagram.Euler_characteristic(0), 2);
  CHECK_EQUAL(ring.diagram.Euler_characteristic(0), 0);
  CHECK_EQUAL(genus_2.diagram.Euler_characteristic(0), -2);
  CHECK(!ring.diagram.is_disk(0));
}

void test_coincident_and_hidden_sites()
{
  test_support::Scope scope("coincident and hidden sites");
  const Indexed_mesh mesh = noisy_sphere(2, .1, 2);
  const Mesh tm = to_face_graph(mesh);
  const Face_location inner(face(5), {.25, .25, .5});
  const Face_location at_vertex = location_of_vertex(vertex(30), faces_around(vertex(30), tm)[0], tm);
  Case c(mesh, {inner, vertex(30), inner, vertex(30), at_vertex});
  CHECK(!c.diagram.is_empty(0) && !c.diagram.is_empty(1));
  CHECK(c.diagram.is_empty(2) && c.diagram.is_empty(3) && c.diagram.is_empty(4));
  c.check_all();
  // one that all others are behind
  Case hidden(mesh, {vertex(1), vertex(20), Weighted_site(vertex(50), 100.)});
  CHECK(hidden.diagram.is_empty(0) && hidden.diagram.is_empty(1));
  CHECK_EQUAL(hidden.diagram.Euler_characteristic(2), 2);
  CHECK_EQUAL(hidden.diagram.nearest_site(vertex(1)), 2u);
  hidden.check_all();
}

// Two sites around a tube: a closed edge without vertices; the cells are rings.
void test_tube()
{
  test_support::Scope scope("tube");
  const std::size_t m = 12, n = 8;
  const Indexed_mesh tube = jittered(prism_tube(m, n, .2, 8.), .01, 3);
  Case c(tube, {vertex(2), vertex(tube.points.size() - 3)});
  c.check_all();
  std::size_t closed = 0;
  for(const Voronoi::Edge& e : c.diagram.edges())
  {
    closed += e.is_closed() ? 1 : 0;
  }
  CHECK_EQUAL(c.diagram.edges().size(), 1u);
  CHECK_EQUAL(closed, 1u);
  CHECK(c.diagram.vertices().empty());
  CHECK_EQUAL(c.diagram.Euler_characteristic(0), 0);
  CHECK_EQUAL(c.diagram.Euler_characteristic(1), 0);
}

void test_components()
{
  test_support::Scope scope("components");
  const Indexed_mesh two = two_components_and_an_isolated_vertex();
  const Mesh tm = to_face_graph(two);
  Case c(two, {vertex(0)});
  c.check_all();
  std::size_t unreached = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    if(c.diagram.nearest_site(v) == null_site)
    {
      ++unreached;
      CHECK_EQUAL(c.diagram.distance_to_nearest_site(v), -1.);
    }
  }
  CHECK(unreached > 1);
}

// n x n squares, glued into a torus; the embedding is that of a torus of revolution, the lengths are flat.
void test_flat_torus()
{
  test_support::Scope scope("flat torus");
  const std::size_t n = 6;
  Mesh tm = to_face_graph(torus(1., .4, n, n));
  Edge_lengths lengths = tm.add_property_map<Mesh::Edge_index, double>("e:flat", 0.).first;
  for(const face_descriptor f : faces(tm))
  {
    // the diagonal of a square is the side of a face that joins different columns and rows
    for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, tm), tm))
    {
      const std::size_t a = std::size_t(source(h, tm)), b = std::size_t(target(h, tm));
      lengths[tm.edge(h)] = a / n != b / n && a % n != b % n ? std::sqrt(2.) : 1.;
    }
  }
  // the sites are at even columns and rows of 3: cells are rectangles of 3 x 3
  const Weighted_sites sites = {vertex(0), vertex(3), vertex(3 * n), vertex(3 * n + 3)};
  Voronoi diagram(tm);
  diagram.use_edge_lengths(lengths);
  add_sites(diagram, sites);
  test_support::Random random(1);
  Voronoi_validator(tm, diagram, sites, &lengths).check_all(random, 200);
  double sum = 0.;
  for(const Voronoi::Edge& e : diagram.edges())
  {
    sum += e.length();
  }
  CHECK_CLOSE(sum, 24., 1e-12);
  for(std::size_t i = 0; i < 4; ++i)
  {
    CHECK_CLOSE(diagram.area(i), 9., 1e-12);
    CHECK(diagram.is_disk(i));
    CHECK_EQUAL(diagram.adjacent_sites(i).size() >= 2, true);
  }
  CHECK_CLOSE(diagram.distance_to_nearest_site(vertex(n + 1)), std::sqrt(2.), 1e-14);
}

// Arcs along edges of the mesh and through its vertices.
void test_grid()
{
  test_support::Scope scope("grid");
  const std::size_t n = 4;
  for(const bool random_diagonals : {false, true})
  {
    const Indexed_mesh grid = flat_patch(n, n, 0., random_diagonals, 5);
    const std::size_t last = grid.points.size() - 1;
    Case corners(grid, {vertex(0), vertex(n), vertex(last - n), vertex(last)});
    corners.check_all();
    for(std::size_t i = 0; i < 4; ++i)
    {
      CHECK_CLOSE(corners.diagram.area(i), 4., 1e-12);
    }
    Case all(grid, all_vertices(last + 1));
    all.check_all();
    CHECK_CLOSE(all.diagram.area(0), .25, 1e-12);
    CHECK_CLOSE(all.diagram.area(n + 2), 1., 1e-12);
    Case two(grid, {vertex(0), vertex(last)});
    two.check_all();
    CHECK_CLOSE(two.diagram.area(0), 8., 1e-12);
    CHECK_EQUAL(two.diagram.edges().size(), 1u);
    CHECK_CLOSE(two.diagram.edges()[0].length(), 4. * std::sqrt(2.), 1e-12);
  }
}

} // namespace

int main()
{
  test_polyhedra();
  test_one_site_and_none();
  test_coincident_and_hidden_sites();
  test_tube();
  test_components();
  test_flat_torus();
  test_grid();
  return test_result();
}
