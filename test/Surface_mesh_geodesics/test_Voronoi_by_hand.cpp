// Diagrams whose cells are known in advance: polyhedra, a flat torus given by lengths, coincident and hidden
// sites, closed edges, cells that are not disks, several components, regions where sites tie.

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

void all_corners_of_polyhedra_have_cells()
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
    for(std::size_t i = 0; i < n; ++i) // all cells are congruent
    {
      CHECK_CLOSE(c.diagram.area(i), c.diagram.area(0), 1e-12);
      CHECK(c.diagram.is_disk(i));
    }
    if(solid.second > 0.)
    {
      CHECK_CLOSE(c.diagram.area(0), solid.second / static_cast<double>(n), 1e-12);
    }
  }
  // The cell of a single site is the whole octahedron.
  Case c(octahedron(), {vertex(0)});
  CHECK(c.diagram.arcs().empty() && c.diagram.edges().empty());
  CHECK_EQUAL(c.diagram.Euler_characteristic(0), 2);
  c.check_all();
}

// Returns the middles of the faces of a polyhedron.
std::vector<Coordinates> middles_of_faces(const Indexed_mesh& mesh)
{
  std::vector<Coordinates> middles;
  for(const Triangle& t : mesh.faces)
  {
    middles.push_back(1. / 3. * (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]));
  }
  return middles;
}

// Checks that the vertices of the diagram are the expected points, in any order.
void check_positions_of_vertices(const Voronoi& diagram, std::vector<Coordinates> expected)
{
  CHECK_EQUAL(diagram.vertices().size(), expected.size());
  for(const Voronoi::Vertex& v : diagram.vertices())
  {
    const Coordinates p = to_coordinates(v.point());
    const auto found = std::find_if(expected.begin(), expected.end(),
                                    [&](const Coordinates& q) { return length(p - q) <= 1e-14; });
    if(CHECK(found != expected.end()))
    {
      expected.erase(found); // no two vertices have the same position
    }
  }
}

// Checks that each vertex has `degree` sites, as many edges, and is `distance` away from its sites.
void check_degrees(const Voronoi& diagram, std::size_t degree, double distance)
{
  std::vector<std::size_t> ends(diagram.vertices().size(), 0);
  for(const Voronoi::Edge& e : diagram.edges())
  {
    if(CHECK(e.source_vertex() != null_site && e.target_vertex() != null_site))
    {
      ++ends[e.source_vertex()];
      ++ends[e.target_vertex()];
    }
  }
  for(const Voronoi::Vertex& v : diagram.vertices())
  {
    CHECK_EQUAL(v.sites().size(), degree);
    CHECK_EQUAL(ends[v.index()], degree);
    CHECK_CLOSE(v.distance(), distance, 1e-14);
  }
}

// Each edge of the diagram joins the middles of two sides and halves the edge of the cube between them.
void corners_of_a_cube_have_congruent_cells()
{
  test_support::Scope scope("corners of a cube");
  Case c(cube(), all_vertices(8));
  check_positions_of_vertices(c.diagram, {{.5, .5, 0.}, {.5, .5, 1.}, {.5, 0., .5}, {.5, 1., .5}, {0., .5, .5},
                                       {1., .5, .5}});
  check_degrees(c.diagram, 4, std::sqrt(.5));
  CHECK_EQUAL(c.diagram.edges().size(), 12u);
  for(const Voronoi::Edge& e : c.diagram.edges())
  {
    CHECK_CLOSE(e.length(), 1., 1e-14);
  }
  for(std::size_t i = 0; i < 8; ++i)
  {
    CHECK_EQUAL(c.diagram.adjacent_sites(i).size(), 3u);
    CHECK_CLOSE(c.diagram.area(i), .75, 1e-14);
  }
}

// The edges of the tetrahedron have length sqrt(8), the middle of a side is sqrt(8 / 3) away from its corners.
void corners_of_a_tetrahedron_have_congruent_cells()
{
  test_support::Scope scope("corners of a regular tetrahedron");
  Case c(regular_tetrahedron(), all_vertices(4));
  check_positions_of_vertices(c.diagram, middles_of_faces(regular_tetrahedron()));
  check_degrees(c.diagram, 3, std::sqrt(8. / 3.));
  CHECK_EQUAL(c.diagram.edges().size(), 6u);
  for(const Voronoi::Edge& e : c.diagram.edges())
  {
    CHECK_CLOSE(e.length(), std::sqrt(8. / 3.), 1e-14); // twice the inradius of a side
  }
  for(std::size_t i = 0; i < 4; ++i)
  {
    CHECK_EQUAL(c.diagram.adjacent_sites(i).size(), 3u);
    CHECK_CLOSE(c.diagram.area(i), 2. * std::sqrt(3.), 1e-14); // the area of one side
  }
}

void one_site_owns_the_surface()
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

void coincident_and_hidden_sites_own_nothing()
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
  // The weight of the third site hides both others.
  Case hidden(mesh, {vertex(1), vertex(20), Weighted_site(vertex(50), 100.)});
  CHECK(hidden.diagram.is_empty(0) && hidden.diagram.is_empty(1));
  CHECK_EQUAL(hidden.diagram.Euler_characteristic(2), 2);
  CHECK_EQUAL(hidden.diagram.nearest_site(vertex(1)), 2u);
  hidden.check_all();
}

// Two sites of a tube have a closed edge without vertices; their cells are rings.
void two_cells_of_a_tube_are_rings()
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

void components_without_sites_have_no_owner()
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

// Both components have sites. Each site owns a part of its own component only, even if its weight makes it nearer than
// all others.
void sites_own_parts_of_their_components()
{
  test_support::Scope scope("sites in both components");
  const std::size_t size_of_sphere = icosphere(1).points.size();
  for(const double weight : {0., .1, 50.})
  {
    test_support::Scope scope_of_weight("weight " + std::to_string(weight));
    Case c(two_components_and_an_isolated_vertex(),
           {vertex(0), vertex(size_of_sphere), Weighted_site(vertex(9), weight), vertex(size_of_sphere + 13),
            vertex(30), vertex(size_of_sphere + 21)}); // alternating
    c.check_all();
    double sums[2] = {0., 0.};
    test_support::Random random(2);
    for(const face_descriptor f : faces(c.tm))
    {
      const std::size_t component = std::size_t(corners_of_face(f, c.tm)[0]) < size_of_sphere ? 0 : 1;
      sums[component] += area_of_face(c.tm, f);
      for(const Voronoi::Arc& a : c.diagram.arcs(f))
      {
        CHECK(a.sites().first % 2 == component && a.sites().second % 2 == component);
      }
      Face_location l = random_location(c.tm, random);
      l.first = f;
      CHECK_EQUAL(c.diagram.nearest_site(l) % 2, component);
    }
    for(std::size_t component = 0; component < 2; ++component)
    {
      const double sum = c.diagram.area(component) + c.diagram.area(component + 2) + c.diagram.area(component + 4);
      CHECK_CLOSE(sum, sums[component], 1e-12);
    }
    for(std::size_t i = 0; i < 6; ++i)
    {
      CHECK_EQUAL(c.diagram.is_empty(i), weight == 50. && (i == 0 || i == 4));
    }
    CHECK(weight == 50. || !c.diagram.vertices().empty());
  }
}

// Six right angles around vertex 0 in six consecutive octants. All coordinates are exact.
Indexed_mesh saddle_of_six_right_angles()
{
  return {"saddle of six right angles",
          {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}}};
}

// Returns whether a point is in the octant between the negative x and y axes: behind the saddle vertex, as seen from
// the ends of the positive axes.
bool is_behind_saddle(const Coordinates& p)
{
  return p[0] <= 0. && p[1] <= 0. && p[2] == 0.;
}

// Two sites tie at a saddle vertex, and so in the whole triangle behind it, which belongs to the owner of the saddle
// vertex. The rest of the surface is divided into two congruent halves.
void a_tie_behind_a_saddle_vertex_has_one_owner()
{
  test_support::Scope scope("tie behind a saddle vertex");
  for(std::size_t times = 0; times < 4; ++times)
  {
    for(const bool is_swapped : {false, true})
    {
      test_support::Scope scope_of_case(std::to_string(times) + " subdivisions" + (is_swapped ? ", swapped" : ""));
      const std::size_t first = is_swapped ? 2 : 1;
      Case c(midpoint_subdivision(saddle_of_six_right_angles(), times), {vertex(first), vertex(3 - first)});
      const std::size_t owner = c.diagram.nearest_site(vertex(0));
      if(!CHECK(owner < 2))
      {
        continue;
      }
      test_support::Random random(3);
      std::size_t number_of_faces = 0;
      for(const face_descriptor f : faces(c.tm))
      {
        Face_location l = random_location(c.tm, random);
        l.first = f;
        if(is_behind_saddle(coordinates(l, c.tm)))
        {
          CHECK_EQUAL(c.diagram.nearest_site(l), owner);
          ++number_of_faces;
        }
      }
      CHECK_EQUAL(number_of_faces, std::size_t(1) << (2 * times));
      // The side of the triangle may move by the square root of the rounding of distances. On one side of it the paths
      // of the other site bend at the saddle vertex, on the other side they are straight, but their length has no kink.
      CHECK_NEAR(c.diagram.area(owner), 1.75, 1e-7);
      CHECK_NEAR(c.diagram.area(0) + c.diagram.area(1), 3., 1e-14);
      double sum = 0.;
      for(const Voronoi::Edge& e : c.diagram.edges())
      {
        sum += e.length();
      }
      CHECK_NEAR(sum, std::sqrt(.5) + 1., 1e-7); // to the saddle vertex, and along one side of the triangle
      CHECK(c.diagram.vertices().empty());
      c.check_all();
    }
  }
}

// Returns the middles, in space, of the diagonals of the squares (i, j) of a torus with n vertices in each column.
std::vector<Coordinates> middles_of_diagonals(const Mesh& tm, const std::vector<std::array<std::size_t, 2>>& squares,
                                              std::size_t n)
{
  std::vector<Coordinates> middles;
  for(const std::array<std::size_t, 2>& s : squares)
  {
    middles.push_back(.5 * (coordinates(vertex(s[0] * n + s[1]), tm)
                            + coordinates(vertex((s[0] + 1) * n + s[1] + 1), tm)));
  }
  return middles;
}

// A torus of n x n squares. The points are those of a torus of revolution, the edge lengths those of a flat torus.
void cells_of_a_flat_torus_are_exact()
{
  test_support::Scope scope("flat torus");
  const std::size_t n = 6;
  Mesh tm = to_face_graph(torus(1., .4, n, n));
  Edge_lengths lengths = tm.add_property_map<Mesh::Edge_index, double>("e:flat", 0.).first;
  for(const face_descriptor f : faces(tm))
  {
    // An edge between different columns and rows is the diagonal of a square.
    for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, tm), tm))
    {
      const std::size_t a = std::size_t(source(h, tm)), b = std::size_t(target(h, tm));
      lengths[tm.edge(h)] = a / n != b / n && a % n != b % n ? std::sqrt(2.) : 1.;
    }
  }
  // The sites are at every third column and row, so the cells are squares of 3 x 3.
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
    // The cell is adjacent to those of the next sites in its row and column. It meets the fourth cell only at corners.
    CHECK(diagram.adjacent_sites(i) == (std::vector<std::size_t>{(std::min)(i ^ 1, i ^ 2), (std::max)(i ^ 1, i ^ 2)}));
  }
  // All cells meet at four corners, each of which has two sides of length 3.
  CHECK_EQUAL(diagram.vertices().size(), 4u);
  check_degrees(diagram, 4, 1.5 * std::sqrt(2.));
  CHECK_EQUAL(diagram.edges().size(), 8u);
  for(const Voronoi::Edge& e : diagram.edges())
  {
    CHECK_CLOSE(e.length(), 3., 1e-13);
  }
  check_positions_of_vertices(diagram, middles_of_diagonals(tm, {{1, 1}, {1, 4}, {4, 1}, {4, 4}}, n));
  CHECK_CLOSE(diagram.distance_to_nearest_site(vertex(n + 1)), std::sqrt(2.), 1e-14);
}

// Arcs run along edges of the mesh and through its vertices.
void arcs_run_along_edges_and_through_vertices()
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
  all_corners_of_polyhedra_have_cells();
  corners_of_a_cube_have_congruent_cells();
  corners_of_a_tetrahedron_have_congruent_cells();
  one_site_owns_the_surface();
  coincident_and_hidden_sites_own_nothing();
  two_cells_of_a_tube_are_rings();
  components_without_sites_have_no_owner();
  sites_own_parts_of_their_components();
  a_tie_behind_a_saddle_vertex_has_one_owner();
  cells_of_a_flat_torus_are_exact();
  arcs_run_along_edges_and_through_vertices();
  return test_result();
}
