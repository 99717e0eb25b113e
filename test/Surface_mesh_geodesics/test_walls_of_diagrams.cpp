// Walls of diagrams: cells are those of a mesh that has really been cut along the walls, where a site on a wall is a
// site on each side.

#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"
#include "walls_and_places.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace PMP = CGAL::Polygon_mesh_processing;
using SMG::Invalid_geodesic_input;

namespace {

using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
using Parallel_diagram
  = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default,
                                                CGAL::Parallel_if_available_tag>;
using Point = Kernel::Point_3;

Diagram::Face_location location(const Face_location& l)
{
  return {l.first, {{l.second[0], l.second[1], l.second[2]}}};
}

std::array<double, 3> coordinates(const Diagram::Face_location& l)
{
  return {l.second[0], l.second[1], l.second[2]};
}

template <typename AnyDiagram>
void add_sites(AnyDiagram& diagram, const std::vector<Place>& sites, const std::vector<double>& weights)
{
  for(std::size_t i = 0; i < sites.size(); ++i)
    if(sites[i].is_vertex)
      diagram.add_site(sites[i].vertex, weights[i]);
    else
      diagram.add_site(location(sites[i].location), weights[i]);
}

// The diagram of the cut mesh. Several of its sites are one site.
struct Diagram_of_cut
{
  Diagram diagram;
  std::vector<std::size_t> site; // by site of the cut mesh

  Diagram_of_cut(const Case& c, const std::vector<Place>& sites, const std::vector<double>& weights)
    : diagram(c.cut.mesh)
  {
    for(std::size_t i = 0; i < sites.size(); ++i)
      for(const Face_location& s : sides(c.tm, c.cut, c.removed, sites[i]))
      {
        diagram.add_site(location(s), weights[i]);
        site.push_back(i);
      }
  }

  // Is a site as near to one of the places, which are the sides of a point? (Some meshes are symmetric.)
  bool ties(std::size_t i, const std::vector<Face_location>& places, double distance) const
  {
    for(std::size_t k = 0; k < site.size(); ++k)
      for(const Face_location& p : places)
        if(site[k] == i
           && std::abs(SMG::geodesic_distance(diagram.triangle_mesh(), diagram.site(k), location(p))
                       - diagram.weight(k) - distance) < 1e-12)
          return true;
    return false;
  }

  std::size_t site_at(const Face_location& l) const
  {
    const std::size_t i = diagram.nearest_site(location(l));
    return i == Diagram::null_site() ? i : site[i];
  }
};

// --- numbers of cells ---

void check_measures(const Diagram& found, const Diagram_of_cut& expected)
{
  const std::size_t n = found.number_of_sites();
  std::vector<double> area(n, 0.);
  std::vector<CGAL::Vector_3<Kernel>> moment(n, {0, 0, 0});
  std::vector<bool> is_empty(n, true);
  for(std::size_t i = 0; i < expected.site.size(); ++i)
  {
    const std::size_t s = expected.site[i];
    area[s] += expected.diagram.area(i);
    moment[s] = moment[s] + expected.diagram.area(i) * (expected.diagram.centroid(i) - CGAL::ORIGIN);
    is_empty[s] = is_empty[s] && expected.diagram.is_empty(i);
  }
  for(std::size_t i = 0; i < n; ++i)
  {
    CHECK_NEAR(found.area(i), area[i], 1e-12);
    CHECK_EQUAL(found.is_empty(i), bool(is_empty[i]));
    if(area[i] > 1e-6)
      for(int k = 0; k < 3; ++k)
        CHECK_NEAR(found.centroid(i)[k], moment[i][k] / area[i], 1e-11);
  }
  CHECK_CLOSE(found.energy(), expected.diagram.energy(), 1e-11);
}

// --- elements ---

using Pair = std::pair<std::size_t, std::size_t>;

Pair sorted(Pair p) { return {(std::min)(p.first, p.second), (std::max)(p.first, p.second)}; }

// The lengths of the curves between two sites, by these.
template <typename Name>
std::map<Pair, double> lengths(const Diagram& diagram, const Name& name)
{
  std::map<Pair, double> result;
  for(const Diagram::Edge& e : diagram.edges())
  {
    const Pair p = sorted({name(e.sites().first), name(e.sites().second)});
    if(p.first != p.second)
      result[p] += e.length();
  }
  return result;
}

// The vertices where three sites meet, in no order.
template <typename Name>
std::vector<std::pair<std::vector<std::size_t>, Point>> vertices_of(const Diagram& diagram, const Name& name)
{
  std::vector<std::pair<std::vector<std::size_t>, Point>> result;
  for(const Diagram::Vertex& v : diagram.vertices())
  {
    std::vector<std::size_t> sites;
    for(const std::size_t s : v.sites())
      sites.push_back(name(s));
    std::sort(sites.begin(), sites.end());
    sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    if(sites.size() > 2)
      result.emplace_back(sites, v.point());
  }
  return result;
}

void check_elements(const Case& c, const Diagram& found, const Diagram_of_cut& expected)
{
  const auto itself = [](std::size_t i) { return i; };
  const auto site_of = [&](std::size_t i) { return expected.site[i]; };
  auto lengths_found = lengths(found, itself), lengths_expected = lengths(expected.diagram, site_of);
  for(auto* some : {&lengths_found, &lengths_expected})
    for(const auto& l : *some)
      CHECK_NEAR(lengths_found[l.first], lengths_expected[l.first], 1e-10);
  const auto vertices_found = vertices_of(found, itself), vertices_expected = vertices_of(expected.diagram, site_of);
  CHECK_EQUAL(vertices_found.size(), vertices_expected.size());
  for(const auto& v : vertices_found)
    CHECK(std::any_of(vertices_expected.begin(), vertices_expected.end(), [&](const auto& w)
                      { return v.first == w.first && CGAL::squared_distance(v.second, w.second) < 1e-22; }));
  // The points of arcs have their distance in the cut mesh.
  for(const Diagram::Arc& a : found.arcs())
    for(const double t : {.1, .5, .8})
    {
      const auto l = c.cut.location(a.face(), coordinates(a.point(t)));
      CHECK_NEAR(a.distance(t), expected.diagram.distance_to_nearest_site(location(l)), 1e-11);
    }
  // Edges end at vertices of the diagram, at the border, or at walls.
  for(const Diagram::Edge& e : found.edges())
    CHECK(e.sites().first != e.sites().second);
}

// --- queries ---

// A place is in the cell whose site is nearest on one of its sides. Returns whether its sides have different sites.
bool check_query(const Case& c, const Diagram& found, const Diagram_of_cut& expected, const Place& p)
{
  double least_distance = not_reached;
  std::vector<std::pair<double, std::size_t>> of_sides;
  for(const Face_location& s : sides(c.tm, c.cut, c.removed, p))
  {
    const std::size_t site = expected.site_at(s);
    if(site == Diagram::null_site())
      continue;
    of_sides.emplace_back(expected.diagram.distance_to_nearest_site(location(s)), site);
    least_distance = (std::min)(least_distance, of_sides.back().first);
  }
  const std::size_t site = p.is_vertex ? found.nearest_site(p.vertex) : found.nearest_site(location(p.location));
  const double distance = p.is_vertex ? found.distance_to_nearest_site(p.vertex)
                                      : found.distance_to_nearest_site(location(p.location));
  if(of_sides.empty())
  {
    CHECK_EQUAL(site, Diagram::null_site());
    CHECK_EQUAL(distance, -1.);
    return false;
  }
  CHECK_NEAR(distance, least_distance, 1e-12);
  CHECK(std::any_of(of_sides.begin(), of_sides.end(), [&](const auto& side)
                    { return side.second == site && side.first <= least_distance + 1e-12; })
        || expected.ties(site, sides(c.tm, c.cut, c.removed, p), least_distance));
  return std::any_of(of_sides.begin(), of_sides.end(), [&](const auto& side)
                     { return side.second != of_sides.front().second; });
}

std::size_t check_queries(const Case& c, const Diagram& found, const Diagram_of_cut& expected,
                          test_support::Random& random)
{
  std::size_t differing = 0;
  for(std::size_t i = 0; i < 40; ++i)
    differing += check_query(c, found, expected, random_place(c.tm, c.removed, random)) ? 1 : 0;
  for(const vertex_descriptor v : c.tm.vertices())
    if(!c.tm.is_isolated(v) && !sides(c.tm, c.cut, c.removed, {v, {}, true}).empty())
      check_query(c, found, expected, {v, {}, true});
  return differing;
}

// --- what is made of the diagram ---

double length_of_border(const Mesh& mesh)
{
  double sum = 0;
  for(const edge_descriptor e : edges(mesh))
    if(is_border(e, mesh))
      sum += std::sqrt(CGAL::squared_distance(mesh.point(source(e, mesh)), mesh.point(target(e, mesh))));
  return sum;
}

bool is_disk(Mesh& mesh)
{
  auto component = mesh.add_property_map<face_descriptor, std::size_t>("f:component").first;
  std::vector<halfedge_descriptor> pinched;
  PMP::non_manifold_vertices(mesh, std::back_inserter(pinched));
  return num_faces(mesh) > 0 && PMP::connected_components(mesh, component) == 1 && pinched.empty()
      && num_vertices(mesh) + num_faces(mesh) == num_edges(mesh) + 1;
}

// The cut along the arcs has the border of the mesh that is cut along the walls, and cells with the right areas, whose
// meshes have the same topology.
void check_meshes(const Case& c, const Diagram& found)
{
  Mesh cut;
  auto site = cut.add_property_map<face_descriptor, std::size_t>("f:site").first;
  const double tolerance = 1e-5;
  found.cut(cut, site, tolerance);
  PMP::remove_isolated_vertices(cut); // those that the mesh has, and those inside of what is avoided
  CHECK(CGAL::is_valid_polygon_mesh(cut));
  CHECK_CLOSE(length_of_border(cut), length_of_border(c.cut.mesh), 1e-9);
  CHECK_CLOSE(PMP::area(cut), PMP::area(c.cut.mesh), 1e-9);
  double length = 0;
  for(const Diagram::Arc& a : found.arcs())
    length += a.length();
  std::vector<double> area(found.number_of_sites(), 0.);
  for(const face_descriptor f : cut.faces())
    if(site[f] != Diagram::null_site())
      area[site[f]] += PMP::face_area(f, cut);
  for(std::size_t i = 0; i < found.number_of_sites(); ++i)
  {
    Mesh cell;
    found.cell_mesh(i, cell, cell.add_property_map<face_descriptor, face_descriptor>("f:face").first, tolerance);
    CHECK(CGAL::is_valid_polygon_mesh(cell));
    CHECK_NEAR(PMP::area(cell), area[i], 1e-9);
    CHECK_NEAR(found.area(i), area[i], 2 * tolerance * length + 1e-9);
    CHECK_EQUAL(is_disk(cell), found.is_disk(i));
    const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(num_vertices(cell) + num_faces(cell))
                           - static_cast<std::ptrdiff_t>(num_edges(cell));
    CHECK_EQUAL(n, std::ptrdiff_t(found.Euler_characteristic(i)));
  }
}

bool is_flat(const Mesh& mesh)
{
  return std::all_of(mesh.vertices().begin(), mesh.vertices().end(),
                     [&](vertex_descriptor v) { return mesh.point(v).z() == 0; });
}

// The loops around a cell go along the walls: in the plane, their areas add up to that of the cell.
void check_loops(const Diagram& found)
{
  for(std::size_t i = 0; i < found.number_of_sites(); ++i)
  {
    double area = 0, length = 0;
    for(const auto& line : found.boundary_polylines(i, 1e-6, true))
    {
      CHECK(line.is_closed);
      for(std::size_t k = 1; k < line.locations.size(); ++k)
      {
        const Point p = found.point(line.locations[k - 1]), q = found.point(line.locations[k]);
        area += (p.x() * q.y() - p.y() * q.x()) / 2;
        length += std::sqrt(CGAL::squared_distance(p, q));
      }
    }
    CHECK_NEAR(area, found.area(i), 1e-6 * length + 1e-9);
  }
}

// --- against the cut mesh ---

std::vector<Place> random_sites(const Case& c, std::size_t number, test_support::Random& random)
{
  std::vector<Place> result;
  std::vector<Point> points;
  for(std::size_t i = 0; result.size() < number && i < 100; ++i)
  {
    const Place p = random_place(c.tm, c.removed, random);
    if(sides(c.tm, c.cut, c.removed, p).empty())
      continue;
    Diagram diagram(c.tm);
    const Point at = p.is_vertex ? c.tm.point(p.vertex) : diagram.point(location(p.location));
    if(std::count(points.begin(), points.end(), at) != 0)
      continue;
    points.push_back(at);
    result.push_back(p);
  }
  return result;
}

void test_against_cut_mesh()
{
  test_support::Random random(2);
  std::size_t differing = 0, number_on_walls = 0;
  for_each_case(random, [&](const Case& c, std::size_t i)
  {
    const std::vector<Place> sites = random_sites(c, 6, random);
    std::vector<double> weights;
    for(std::size_t k = 0; k < sites.size(); ++k)
      weights.push_back(i % 3 == 2 ? random.uniform(0, .1) : 0.);
    Diagram found(c.tm);
    if(i % 2 == 0)
      found.avoid_edges(c.range);
    found.avoid_faces(c.avoided);
    if(i % 2 == 1)
      found.avoid_edges(boost::make_function_property_map<edge_descriptor>([&](edge_descriptor e)
                                                                           { return c.walls.count(e) != 0; }));
    for(const edge_descriptor e : edges(c.tm))
      CHECK_EQUAL(found.avoids_edge(e), c.walls.count(e) != 0);
    add_sites(found, sites, weights);
    const Diagram_of_cut expected(c, sites, weights);
    check_measures(found, expected);
    check_elements(c, found, expected);
    differing += check_queries(c, found, expected, random);
    check_meshes(c, found);
    if(is_flat(c.tm))
      check_loops(found);
    for(const Place& p : sites)
      number_on_walls += sides(c.tm, c.cut, c.removed, p).size() > 1 ? 1 : 0;
    Parallel_diagram parallel(c.tm);
    parallel.avoid_faces(c.avoided);
    parallel.avoid_edges(c.range);
    add_sites(parallel, sites, weights);
    for(std::size_t k = 0; k < sites.size(); ++k)
      CHECK_NEAR(parallel.area(k), found.area(k), 1e-12);
  });
  CHECK(differing > 20);
  CHECK(number_on_walls > 50);
}

// --- by hand: a rectangle [0, 8] x [0, 4], with edges along x = 4 ---

struct Rectangle
{
  Mesh mesh = to_face_graph(flat_patch(8, 4, 0, true, 1));

  vertex_descriptor at(std::size_t x, std::size_t y) const
  {
    return vertex_descriptor(static_cast<Mesh::size_type>(5 * x + y));
  }

  // The edges from (4, first) to (4, last).
  Walls wall(std::size_t first, std::size_t last) const
  {
    Walls result;
    for(std::size_t y = first; y < last; ++y)
      result.insert(mesh.edge(mesh.halfedge(at(4, y), at(4, y + 1))));
    return result;
  }

  // The point (4, y + t), 0 < t < 1, as a location of the face on the left or on the right of it.
  Diagram::Face_location on_wall(std::size_t y, double t, bool is_left) const
  {
    const auto up = mesh.halfedge(at(4, y), at(4, y + 1)), h = is_left ? up : mesh.opposite(up);
    Diagram::Face_location result(mesh.face(h), {{0, 0, 0}});
    std::size_t k = 0;
    for(auto g = mesh.halfedge(mesh.face(h)); g != h; g = mesh.next(g))
      ++k;
    result.second[k] = is_left ? 1 - t : t;
    result.second[(k + 1) % 3] = is_left ? t : 1 - t;
    return result;
  }
};

void check_areas(const Diagram& diagram, const std::vector<double>& areas)
{
  for(std::size_t i = 0; i < areas.size(); ++i)
  {
    CHECK_NEAR(diagram.area(i), areas[i], 1e-12);
    CHECK_EQUAL(diagram.is_empty(i), areas[i] == 0);
  }
}

// A point of a wall has the same nearest site in the faces on both sides. `t` is its place on edge `y` of the wall.
void check_both_sides(const Diagram& diagram, const Rectangle& r, std::size_t y, double t, std::size_t site,
                      double distance)
{
  for(const bool is_left : {true, false})
  {
    CHECK_EQUAL(diagram.nearest_site(r.on_wall(y, t, is_left)), site);
    CHECK_CLOSE(diagram.distance_to_nearest_site(r.on_wall(y, t, is_left)), distance, 1e-12);
  }
}

// A wall from border to border, with a site on it.
void test_site_on_wall()
{
  const test_support::Scope scope("a site on a wall");
  const Rectangle r;
  Diagram diagram(r.mesh);
  diagram.avoid_edges(r.wall(0, 4));
  diagram.add_site(r.at(4, 2));
  diagram.add_site(r.at(7, 2));
  check_areas(diagram, {22, 10});
  CHECK_EQUAL(diagram.edges().size(), std::size_t(1));
  CHECK_EQUAL(diagram.edges()[0].source_vertex(), Diagram::null_site());
  CHECK_CLOSE(diagram.edges()[0].length(), 4., 1e-12);
  CHECK(diagram.vertices().empty());
  CHECK(diagram.adjacent_sites(0) == std::vector<std::size_t>{1});
  CHECK_EQUAL(diagram.Euler_characteristic(0), 2);
  CHECK(!diagram.is_disk(0) && diagram.is_disk(1));
  CHECK_EQUAL(diagram.boundary(0).size(), std::size_t(1));
  CHECK_EQUAL(diagram.boundary_polylines(0, .1, true).size(), std::size_t(2));
  check_loops(diagram);
  check_both_sides(diagram, r, 0, .25, 0, 1.75);
  // With a hole in the part on the other side, the characteristic is that of a disk.
  Walls with_hole = r.wall(0, 4);
  with_hole.insert(r.mesh.edge(r.mesh.halfedge(r.at(2, 2), r.at(2, 3))));
  diagram.avoid_edges(with_hole);
  CHECK_EQUAL(diagram.Euler_characteristic(0), 1);
  CHECK(!diagram.is_disk(0));
}

// Sites on both sides of a wall: the nearer one has the wall.
void test_sites_beside_wall()
{
  const test_support::Scope scope("sites beside a wall");
  const Rectangle r;
  Diagram diagram(r.mesh);
  diagram.avoid_edges(r.wall(0, 4));
  diagram.add_site(r.at(6, 2));
  diagram.add_site(r.at(3, 2));
  check_areas(diagram, {16, 16});
  CHECK(diagram.edges().empty() && diagram.is_disk(0) && diagram.is_disk(1));
  CHECK_EQUAL(diagram.boundary_polylines(0, .1, true).size(), std::size_t(1));
  check_both_sides(diagram, r, 1, .5, 1, std::sqrt(1.25));
  for(std::size_t y = 0; y <= 4; ++y)
    CHECK_EQUAL(diagram.nearest_site(r.at(4, y)), std::size_t(1));
  CHECK_EQUAL(diagram.nearest_site(r.at(5, 2)), std::size_t(0));
  // Faces to avoid are left out on one side, and the walls stay.
  diagram.avoid_faces(std::vector<face_descriptor>{r.mesh.face(r.mesh.halfedge(r.at(0, 0), r.at(1, 0)))});
  check_areas(diagram, {16, 15.5});
  diagram.avoid_edges(Walls());
  diagram.avoid_faces(std::vector<face_descriptor>());
  check_areas(diagram, {14, 18});
}

// A site on a wall that another one hides, or ties with, on one side.
void test_one_side_lost()
{
  const test_support::Scope scope("one side lost");
  const Rectangle r;
  for(const double weight : {1.5, 1.})
    for(const bool is_first : {true, false})
    {
      Diagram diagram(r.mesh);
      diagram.avoid_edges(r.wall(0, 4));
      if(is_first)
        diagram.add_site(r.at(4, 2));
      diagram.add_site(r.at(5, 2), weight);
      if(!is_first)
        diagram.add_site(r.at(4, 2));
      check_areas(diagram, {16, 16});
      CHECK(diagram.is_disk(0) && diagram.is_disk(1));
    }
  for(const double weight : {2.5, 1.})
  {
    Diagram diagram(r.mesh);
    diagram.avoid_edges(r.wall(0, 4));
    diagram.add_site(r.at(5, 2));
    diagram.add_site(r.at(4, 2), weight);
    check_areas(diagram, {0, 32});
  }
  // Two sites at one point of a wall, from both sides.
  for(const bool is_left : {true, false})
  {
    Diagram diagram(r.mesh);
    diagram.avoid_edges(r.wall(0, 4));
    diagram.add_site(r.on_wall(1, .25, is_left));
    diagram.add_site(r.on_wall(1, .25, !is_left));
    check_areas(diagram, {32, 0});
    CHECK(diagram.edges().empty());
  }
}

// A wall with free ends is a slit, which a cell surrounds. Its two sides are at least three edges of a mesh.
void test_slits()
{
  const test_support::Scope scope("slits");
  const Rectangle r;
  for(std::size_t last = 2; last <= 4; ++last)
  {
    Diagram diagram(r.mesh);
    diagram.avoid_edges(r.wall(1, last));
    diagram.add_site(r.at(4, 1));
    CHECK_NEAR(diagram.area(0), 32., 1e-12);
    CHECK_EQUAL(diagram.Euler_characteristic(0), last == 4 ? 1 : 0); // (4, 4) is at the border
    CHECK_EQUAL(diagram.is_disk(0), last == 4);
    CHECK_EQUAL(diagram.boundary_polylines(0, .1, true).size(), std::size_t(last == 4 ? 1 : 2));
    Mesh cut;
    diagram.cut(cut, cut.add_property_map<face_descriptor, std::size_t>("f:site").first);
    CHECK(CGAL::is_valid_polygon_mesh(cut));
    CHECK_CLOSE(length_of_border(cut), 24. + 2 * static_cast<double>(last - 1), 1e-12);
    CHECK_EQUAL(num_vertices(cut), num_vertices(r.mesh) + (last == 3 ? 1 : last == 2 ? 2 : 3));
  }
}

// --- walls that change, and wrong ones ---

void test_changes()
{
  const test_support::Scope scope("changes");
  const Mesh tm = to_face_graph(noisy_sphere(1, .2, 3));
  test_support::Random random(3);
  const Walls walls = random_walls(tm, .3, random);
  const auto lengths_of = [](const Diagram& d)
  {
    std::vector<double> result;
    for(const Diagram::Arc& a : d.arcs())
      result.push_back(a.length());
    return result;
  };
  Diagram diagram(tm);
  diagram.add_site(vertex_descriptor(1));
  diagram.add_site(vertex_descriptor(20));
  const auto free = lengths_of(diagram);
  diagram.avoid_edges(walls);
  const auto between_walls = lengths_of(diagram);
  CHECK(free != between_walls);
  const std::vector<edge_descriptor> wrong{*walls.begin(), Mesh::null_edge()};
  CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&] { diagram.avoid_edges(wrong); }));
  CHECK(diagram.is_built() && lengths_of(diagram) == between_walls);
  diagram.use_edge_lengths(boost::make_function_property_map<edge_descriptor>([&](edge_descriptor e)
  { return std::sqrt(CGAL::squared_distance(tm.point(source(e, tm)), tm.point(target(e, tm)))); }));
  const double area = diagram.area(0);
  diagram.use_points();
  CHECK_CLOSE(diagram.area(0), area, 1e-12);
  diagram.clear();
  CHECK(diagram.avoids_edge(*walls.begin()));
  diagram.add_site(vertex_descriptor(1));
  diagram.add_site(vertex_descriptor(20));
  CHECK(lengths_of(diagram) == between_walls);
  diagram.avoid_edges(std::vector<edge_descriptor>());
  CHECK(!diagram.avoids_edge(*walls.begin()));
  CHECK(lengths_of(diagram) == free);
  Diagram empty(tm);
  empty.avoid_edges(walls);
  CHECK_EQUAL(empty.nearest_site(source(*walls.begin(), tm)), Diagram::null_site());
  CHECK(empty.edges().empty());
}

} // namespace

int main()
{
  test_against_cut_mesh();
  test_site_on_wall();
  test_sites_beside_wall();
  test_one_side_lost();
  test_slits();
  test_changes();
  return test_result();
}
