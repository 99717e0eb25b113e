// The mesh cut along the arcs of the Voronoi diagram: as a mesh (valid, closed where the input is, of the same
// topology and area), and as a map of cells.

#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_face_cut.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Lazy_Voronoi_diagram.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace test_meshes;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
using Site_map = Mesh::Property_map<face_descriptor, std::size_t>;

struct Cut
{
  Mesh mesh;
  Site_map site;
};

Cut cut_of(const Voronoi& voronoi, double tolerance)
{
  Cut cut;
  cut.site = cut.mesh.add_property_map<face_descriptor, std::size_t>("f:site").first;
  voronoi.cut(cut.mesh, cut.site, tolerance);
  return cut;
}

int Euler_characteristic(const Mesh& mesh)
{
  return static_cast<int>(num_vertices(mesh)) - static_cast<int>(num_edges(mesh)) + static_cast<int>(num_faces(mesh));
}

double length_of_border(const Mesh& mesh)
{
  double sum = 0;
  for(const auto e : edges(mesh))
    if(is_border(e, mesh))
      sum += CGAL::to_double(CGAL::Polygon_mesh_processing::edge_length(halfedge(e, mesh), mesh));
  return sum;
}

double area_of(const Mesh& mesh, face_descriptor f)
{
  const auto h = halfedge(f, mesh);
  const auto at = [&](vertex_descriptor v)
  { return Coordinates{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}; };
  const Coordinates p[3] = {at(source(h, mesh)), at(target(h, mesh)), at(target(next(h, mesh), mesh))};
  return length(cross(p[1] - p[0], p[2] - p[0])) / 2;
}

double area_of(const Mesh& mesh)
{
  double sum = 0;
  for(const face_descriptor f : faces(mesh))
    sum += area_of(mesh, f);
  return sum;
}

double extent(const Mesh& mesh)
{
  double result = 0;
  const auto& first = mesh.point(*vertices(mesh).begin());
  for(const vertex_descriptor v : vertices(mesh))
    result = (std::max)(result, std::sqrt(CGAL::squared_distance(first, mesh.point(v))));
  return result;
}

std::size_t number_of_degenerate_faces(const Mesh& mesh)
{
  std::size_t n = 0;
  for(const face_descriptor f : faces(mesh))
  {
    double longest = 0;
    for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      longest = (std::max)(longest, CGAL::to_double(CGAL::Polygon_mesh_processing::edge_length(h, mesh)));
    n += area_of(mesh, f) <= 1e-13 * longest * longest ? 1 : 0;
  }
  return n;
}

// Faces of different cells share an edge if and only if the diagram has edges.
void check_edges_between_cells(const Voronoi& voronoi, const Cut& cut)
{
  std::size_t number_of_edges = 0;
  for(const auto e : edges(cut.mesh))
  {
    const auto h = halfedge(e, cut.mesh);
    if(is_border(e, cut.mesh))
      continue;
    number_of_edges += cut.site[face(h, cut.mesh)] != cut.site[face(opposite(h, cut.mesh), cut.mesh)] ? 1 : 0;
  }
  CHECK_EQUAL(number_of_edges == 0, voronoi.edges().empty());
}

// The areas of the faces of each site add up to the area of its cell, and the areas of all cells to that of the mesh.
void check_sites_of_faces(const Mesh& mesh, const Voronoi& voronoi, const Cut& cut, double tolerance)
{
  std::vector<double> area(voronoi.number_of_sites(), 0.);
  double unreached = 0;
  for(const face_descriptor f : faces(cut.mesh))
    (cut.site[f] == Voronoi::null_site() ? unreached : area[cut.site[f]]) += area_of(cut.mesh, f);
  double boundary = 0;
  for(const auto& arc : voronoi.arcs())
    boundary += CGAL::to_double(arc.length());
  const double whole = area_of(mesh);
  for(std::size_t i = 0; i < area.size(); ++i)
  {
    CHECK_NEAR(area[i], CGAL::to_double(voronoi.area(i)), 2 * tolerance * boundary + 1e-12 * whole);
    unreached += CGAL::to_double(voronoi.area(i));
  }
  CHECK_NEAR(unreached, whole, 1e-12 * whole);
}

// The middle of each face of the input lies in a face of the cut. The site of that face is a nearest site of the
// middle, within the tolerance.
void check_middles(const Mesh& mesh, const Voronoi& voronoi, const Cut& cut, double tolerance)
{
  std::vector<std::unique_ptr<Voronoi>> alone;
  for(std::size_t i = 0; i < voronoi.number_of_sites(); ++i)
  {
    alone.emplace_back(new Voronoi(mesh));
    alone.back()->add_site(voronoi.site(i), voronoi.weight(i));
  }
  for(const face_descriptor f : faces(mesh))
  {
    const Voronoi::Face_location middle(f, Voronoi::Barycentric_coordinates{1. / 3, 1. / 3, 1. / 3});
    const auto p = voronoi.point(middle);
    std::size_t site = Voronoi::null_site();
    double smallest = std::numeric_limits<double>::infinity();
    for(const face_descriptor g : faces(cut.mesh))
    {
      const auto h = halfedge(g, cut.mesh);
      const Kernel::Triangle_3 t(cut.mesh.point(source(h, cut.mesh)), cut.mesh.point(target(h, cut.mesh)),
                                 cut.mesh.point(target(next(h, cut.mesh), cut.mesh)));
      const double d = t.is_degenerate() ? smallest : CGAL::squared_distance(p, t);
      if(d < smallest)
      {
        smallest = d;
        site = cut.site[g];
      }
    }
    const double nearest = voronoi.distance_to_nearest_site(middle);
    if(site == Voronoi::null_site())
      CHECK_EQUAL(voronoi.nearest_site(middle), Voronoi::null_site());
    else
      CHECK_NEAR(alone[site]->distance_to_nearest_site(middle), nearest, 2 * tolerance);
  }
}

// returns how many degenerate faces the cut has made. Areas and sites of faces are checked if the mesh is small: it
// takes time.
std::size_t check_cut(const Mesh& mesh, const Voronoi& voronoi, double relative_tolerance, bool is_small)
{
  const double tolerance = relative_tolerance * extent(mesh);
  const Cut cut = cut_of(voronoi, tolerance);
  CHECK(CGAL::is_triangle_mesh(cut.mesh));
  CHECK_EQUAL(CGAL::is_valid_polygon_mesh(cut.mesh), CGAL::is_valid_polygon_mesh(mesh)); // isolated vertices
  CHECK_EQUAL(CGAL::is_closed(cut.mesh), CGAL::is_closed(mesh));
  CHECK_EQUAL(Euler_characteristic(cut.mesh), Euler_characteristic(mesh));
  CHECK_CLOSE(area_of(cut.mesh), area_of(mesh), 1e-12);
  CHECK_CLOSE(length_of_border(cut.mesh), length_of_border(mesh), 1e-12);
  check_edges_between_cells(voronoi, cut);
  if(!is_small)
    return number_of_degenerate_faces(cut.mesh) - number_of_degenerate_faces(mesh);
  check_sites_of_faces(mesh, voronoi, cut, tolerance);
  check_middles(mesh, voronoi, cut, tolerance);
  return number_of_degenerate_faces(cut.mesh) - number_of_degenerate_faces(mesh);
}

void cuts_of_random_diagrams_are_right(std::uint64_t seed)
{
  test_support::Random random(seed);
  std::size_t number_of_fine_cuts = 0;
  for(const Indexed_mesh& indexed : small_collection(seed))
  {
    const Mesh mesh = to_face_graph(indexed);
    for(const std::size_t n : {std::size_t(1), std::size_t(2), std::size_t(5), std::size_t(30)})
      for(const bool has_weights : {false, true})
      {
        const test_support::Scope scope(indexed.name + ", " + std::to_string(n) + " sites"
                                        + (has_weights ? ", weights" : ""));
        Voronoi voronoi(mesh);
        const double size = extent(mesh);
        for(std::size_t i = 0; i < n; ++i)
        {
          const face_descriptor f(static_cast<Mesh::size_type>(random.index(num_faces(mesh))));
          double a = random.uniform(), b = random.uniform();
          if(i % 3 == 1) // on an edge
            a = 0;
          if(i % 3 == 2) // at a vertex
            a = b = 0;
          const double weight = has_weights ? random.uniform(0., .05) * size : 0.;
          voronoi.add_site(Voronoi::Face_location(f, {a * (1 - b), b, (1 - a) * (1 - b)}), weight);
        }
        CHECK_EQUAL(check_cut(mesh, voronoi, n == 5 ? .1 : 1e-3, false), std::size_t(0));
        // Areas and sites are meaningful only if the tolerance is small.
        if(n > 1 && num_faces(mesh) < 120)
        {
          CHECK_EQUAL(check_cut(mesh, voronoi, 1e-5, true), std::size_t(0));
          ++number_of_fine_cuts;
        }
      }
  }
  CHECK(number_of_fine_cuts >= 50);
}

// Sites at symmetric positions: arcs run along edges and through vertices.
void cuts_at_symmetric_sites_are_right()
{
  std::vector<Indexed_mesh> meshes{flat_patch(4, 4, 0., false, 1), flat_patch(5, 5, 0., false, 1), cube(), cube_grid(2),
                                   cube_grid(3), octahedron(), icosahedron(), regular_tetrahedron(), icosphere(1),
                                   cone_fan(8), saddle_fan(4), torus(1., .4, 8, 8), genus_2_polycube()};
  // A whole edge may be equally far from two sites, and a third cell may meet it in the middle: the part of the cell
  // that owns the edge is then a triangle without area.
  std::size_t number_of_degenerate_faces = 0;
  for(const Indexed_mesh& indexed : meshes)
  {
    const Mesh mesh = to_face_graph(indexed);
    for(std::size_t step = 1; step <= 5; ++step)
    {
      const test_support::Scope scope(indexed.name + ", every " + std::to_string(step) + "th vertex");
      Voronoi voronoi(mesh);
      std::size_t i = 0;
      for(const vertex_descriptor v : vertices(mesh))
        if(i++ % step == 0)
          voronoi.add_site(v);
      number_of_degenerate_faces += check_cut(mesh, voronoi, 1e-4, num_faces(mesh) < 60);
    }
  }
  CHECK(number_of_degenerate_faces < 5);
}

// Two sites at opposite corners of a square: the boundary is the diagonal, an edge of the mesh, and nothing is cut.
void an_arc_along_an_edge_cuts_nothing()
{
  Mesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}), c = mesh.add_vertex({1, 1, 0}),
             d = mesh.add_vertex({0, 1, 0});
  mesh.add_face(a, b, d);
  mesh.add_face(b, c, d);
  Voronoi voronoi(mesh);
  voronoi.add_site(a);
  voronoi.add_site(c);
  const Cut cut = cut_of(voronoi, 1e-3);
  CHECK_EQUAL(num_faces(cut.mesh), std::size_t(2));
  CHECK_EQUAL(num_vertices(cut.mesh), std::size_t(4));
  std::vector<std::size_t> sites;
  for(const face_descriptor f : faces(cut.mesh))
    sites.push_back(cut.site[f]);
  std::sort(sites.begin(), sites.end());
  CHECK(sites == (std::vector<std::size_t>{0, 1}));
}

// With a smaller tolerance there are more faces, and their areas are nearer to the exact ones.
void smaller_tolerances_give_better_areas()
{
  const Mesh mesh = to_face_graph(flat_patch(3, 3, .2, false, 3));
  Voronoi voronoi(mesh);
  voronoi.add_site(*vertices(mesh).begin(), .3);
  voronoi.add_site(*std::prev(vertices(mesh).end()));
  std::size_t number_of_faces = 0;
  double error = 1e300;
  for(const double tolerance : {.1, 1e-3, 1e-5})
  {
    const Cut cut = cut_of(voronoi, tolerance);
    CHECK(num_faces(cut.mesh) > number_of_faces);
    number_of_faces = num_faces(cut.mesh);
    double area = 0;
    Coordinates sum{};
    for(const face_descriptor f : faces(cut.mesh))
      if(cut.site[f] == 0)
      {
        const double a = area_of(cut.mesh, f);
        area += a;
        for(const vertex_descriptor v : vertices_around_face(halfedge(f, cut.mesh), cut.mesh))
          sum = sum + a / 3 * Coordinates{cut.mesh.point(v).x(), cut.mesh.point(v).y(), cut.mesh.point(v).z()};
      }
    const auto c = voronoi.centroid(0);
    CHECK_NEAR(length(1 / area * sum - Coordinates{c.x(), c.y(), c.z()}), 0., 10 * tolerance);
    const double e = std::abs(area - CGAL::to_double(voronoi.area(0)));
    CHECK(e < error);
    error = e;
  }
  CHECK(error < 1e-4);
}

// Three sites tie at the middle of an edge of a hole: a triangle there has no area for any tolerance, and the
// number of vertices is not much larger than the tolerance requires.
void a_tie_at_a_hole_needs_few_vertices()
{
  const Mesh mesh = to_face_graph(square_with_holes(1));
  for(const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5})
  {
    Voronoi voronoi(mesh);
    for(const Mesh::size_type v : {43u, 0u, 41u})
      voronoi.add_site(vertex_descriptor(v));
    const Cut cut = cut_of(voronoi, tolerance);
    CHECK(CGAL::is_valid_polygon_mesh(cut.mesh));
    CHECK_CLOSE(area_of(cut.mesh), area_of(mesh), 1e-12);
    CHECK(num_faces(cut.mesh) < 5000);
  }
}

// The boundary between a point and a closed curve touches an edge of an octahedron: the triangle there has no area,
// however fine the curves are. Further attempts have few vertices, so they take little time beside the attempt that the
// tolerance asks for. (The time is cubic in the number of vertices, which counts here instead of a clock.)
void a_boundary_that_touches_an_edge_takes_little_time()
{
  namespace internal = CGAL::Surface_mesh_geodesics::internal;
  using Location = Voronoi::Face_location;
  using Elements = internal::Voronoi_handles<Voronoi>;
  using Cut_of_face = internal::Voronoi_face_cut;
  const Mesh mesh = to_face_graph(Indexed_mesh{
    "octahedron", {{0, 0, 2}, {2, 0, 0}, {0, 2, 0}, {-2, 0, 0}, {0, -2, 0}, {0, 0, -2}},
    {{1, 0, 4}, {4, 0, 3}, {3, 0, 2}, {2, 0, 1}, {1, 5, 2}, {2, 5, 3}, {3, 5, 4}, {4, 5, 1}}});
  const Location middle(face_descriptor(0), {1. / 3, 1. / 3, 1. / 3});
  const CGAL::Surface_mesh_geodesics::Surface_curve<Mesh> closed(
    mesh, std::vector<Location>{Location(face_descriptor(3), {.04, .96, 0}),
                                Location(face_descriptor(3), {0, .5, .5}), Location(face_descriptor(3), {1, 0, 0})},
    true);
  Voronoi voronoi(mesh);
  voronoi.add_site(middle);
  voronoi.add_site(closed);
  for(const double tolerance : {.1, .03, .01, 1e-3})
    CHECK(check_cut(mesh, voronoi, tolerance, false) <= 1);

  const auto fim = get(boost::face_index, mesh);
  const auto vim = get(boost::vertex_index, mesh);
  const auto vpm = get(CGAL::vertex_point, mesh);
  internal::Lazy_Voronoi_diagram<Traits, std::decay_t<decltype(vim)>, std::decay_t<decltype(fim)>,
                                 std::decay_t<decltype(vpm)>, Elements>
    diagram(mesh, vim, fim, vpm, Traits(), Elements(voronoi));
  diagram.add_site(middle, 0.);
  diagram.add_site(closed, 0.);
  diagram.build();
  Cut_of_face cut(diagram.refined_mesh(), diagram.complex());
  std::size_t number_of_bad_faces = 0;
  for(double tolerance = 1; tolerance > 1e-5; tolerance /= 2)
    for(internal::Face_id f = 0; f < diagram.refined_mesh().number_of_faces(); ++f)
    {
      cut.cut(f, tolerance);
      number_of_bad_faces += cut.badness() > 0 ? 1 : 0;
      const std::size_t limit = Cut_of_face::limit_of_further_attempts(cut.badness());
      CHECK(cut.largest_number_of_vertices() <= (std::max)(cut.points().size(), limit));
    }
  CHECK(number_of_bad_faces > 0);
}

// Special input: parts that no site reaches, no sites at all, a point map, a Polyhedron_3.
void special_input_is_cut()
{
  const Mesh mesh = to_face_graph(two_components_and_an_isolated_vertex());
  Voronoi voronoi(mesh);
  CHECK_EQUAL(num_faces(cut_of(voronoi, 1.).mesh), num_faces(mesh));
  voronoi.add_site(target(halfedge(*faces(mesh).begin(), mesh), mesh));
  const Cut cut = cut_of(voronoi, 1e-3);
  CHECK_EQUAL(num_faces(cut.mesh), num_faces(mesh));
  CHECK_EQUAL(num_vertices(cut.mesh), num_vertices(mesh));
  std::size_t number_of_unreached = 0;
  for(const face_descriptor f : faces(cut.mesh))
    number_of_unreached += cut.site[f] == Voronoi::null_site() ? 1 : 0;
  CHECK(number_of_unreached > 0 && number_of_unreached < num_faces(mesh));

  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>, CGAL::Polyhedron_items_with_id_3>;
  const Mesh sphere = to_face_graph(icosphere(1));
  Voronoi on_sphere(sphere);
  for(std::size_t i = 0; i < 6; ++i)
    on_sphere.add_site(Voronoi::Face_location(face_descriptor(static_cast<Mesh::size_type>(i)), {.2, .3, .5}));
  Polyhedron polyhedron;
  std::map<boost::graph_traits<Polyhedron>::face_descriptor, std::size_t> sites;
  on_sphere.cut(polyhedron, boost::make_assoc_property_map(sites), 1e-3,
                CGAL::parameters::vertex_point_map(get(CGAL::vertex_point, polyhedron)));
  CHECK(polyhedron.is_valid());
  CHECK(polyhedron.is_closed());
  CHECK_EQUAL(sites.size(), polyhedron.size_of_facets());
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260331);
  an_arc_along_an_edge_cuts_nothing();
  smaller_tolerances_give_better_areas();
  a_tie_at_a_hole_needs_few_vertices();
  a_boundary_that_touches_an_edge_takes_little_time();
  special_input_is_cut();
  cuts_at_symmetric_sites_are_right();
  cuts_of_random_diagrams_are_right(seed);
  return test_result();
}
