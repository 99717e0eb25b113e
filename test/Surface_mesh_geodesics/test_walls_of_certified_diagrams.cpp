// Walls of diagrams of curves, of certificates of diagrams, and of relaxation. Cells of curves are those of a mesh that
// has really been cut along the walls, where the parts of a curve on all sides are one site.

#include "curves_and_walls.h"
#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"
#include "walls_and_places.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;

namespace {

using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
using Certificate = SMG::Geodesic_Voronoi_certificate;

double length_of_edge(const Mesh& tm, edge_descriptor e)
{
  return std::sqrt(CGAL::squared_distance(tm.point(source(e, tm)), tm.point(target(e, tm))));
}

Certificate certificate_from_lengths(Diagram& diagram, const Mesh& tm)
{
  const auto lengths
    = boost::make_function_property_map<edge_descriptor>([&](edge_descriptor e) { return length_of_edge(tm, e); });
  diagram.use_edge_lengths(lengths);
  const auto result = SMG::certify_geodesic_Voronoi_diagram_from_edge_lengths(diagram, lengths);
  diagram.use_points();
  return result;
}

// --- certificates ---

// A diagram that does not tell one of its walls.
struct Lying_diagram
  : Diagram
{
  using Diagram::Diagram;
  bool avoids_edge(edge_descriptor e) const { return e != denied && Diagram::avoids_edge(e); }
  edge_descriptor denied = Mesh::null_edge();
};

bool is_certified(const Lying_diagram& diagram)
{
  const auto violations
    = SMG::internal::certify_diagram_with_points<CGAL::Surface_mesh_geodesic_paths, Traits, CGAL::Sequential_tag>(
      diagram, np::default_values());
  return std::all_of(violations.begin(), violations.end(), [](const auto& v) { return v.size < 1e-9; });
}

void test_certificates()
{
  test_support::Random random(5);
  std::size_t number_of_lies = 0, number_found = 0;
  for_each_case(random, [&](const Case& c, std::size_t)
  {
    Lying_diagram diagram(c.tm);
    diagram.avoid_faces(c.avoided);
    diagram.avoid_edges(c.range);
    for(std::size_t i = 0; i < 4; ++i)
    {
      const Place p = random_place(c.tm, c.removed, random);
      if(p.is_vertex && !sides(c.tm, c.cut, c.removed, p).empty())
        diagram.add_site(p.vertex, .02 * double(i));
      else
        diagram.add_site({p.location.first, {{p.location.second[0], p.location.second[1], p.location.second[2]}}});
    }
    const Diagram& honest = diagram;
    const auto certificate = SMG::certify_geodesic_Voronoi_diagram(honest);
    CHECK(certificate.is_certified());
    CHECK(certificate_from_lengths(diagram, c.tm).is_certified());
    CHECK(is_certified(diagram));
    for(std::size_t i = 0; i < c.range.size(); i += 1 + c.range.size() / 4)
    {
      diagram.denied = c.range[i];
      ++number_of_lies;
      number_found += is_certified(diagram) ? 0 : 1;
    }
  });
  // A wall need not change a distance or end an edge of the diagram.
  CHECK(number_found > number_of_lies / 2);
}

// Needles, caps, and vertices of all scales, with sites on walls.
void test_hostile_meshes()
{
  test_support::Random random(21);
  std::size_t number = 0;
  for(std::size_t i = 0; i < 200; ++i)
  {
    const Indexed_mesh mesh = hostile_meshes::hostile_mesh(random);
    Mesh tm;
    if(!hostile_meshes::is_surface(mesh, tm))
      continue;
    const test_support::Scope scope(mesh.name + ", number " + std::to_string(i));
    const Walls walls = random_walls(tm, random.uniform(.05, .6), random);
    Diagram diagram(tm);
    diagram.avoid_edges(walls);
    for(std::size_t k = 0; k < 2; ++k)
      diagram.add_site(random_place(tm, {}, random).vertex, random.uniform(0, .2));
    for(const edge_descriptor e : walls)
      if(diagram.number_of_sites() < 5 && random.index(4) == 0)
        diagram.add_site(source(e, tm), random.uniform(0, .2));
    ++number;
    const auto certificate = SMG::certify_geodesic_Voronoi_diagram(diagram);
    for(std::size_t k = 0; k < Certificate::number_of_conditions; ++k)
    {
      // Areas of faces without height, up to rounding, are known up to the square root of rounding.
      const auto condition = static_cast<Certificate::Condition>(k);
      CHECK(certificate.worst_violation(condition)
            <= (condition == Certificate::Condition::AREAS ? 0x1p-26 : Certificate::default_tolerance));
    }
    for(std::size_t k = 0; k < diagram.number_of_sites(); ++k)
    {
      Mesh cell;
      diagram.cell_mesh(k, cell, cell.add_property_map<face_descriptor, face_descriptor>("f:face").first);
      CHECK(CGAL::is_valid_polygon_mesh(cell));
    }
  }
  CHECK(number > 100);
}

// --- curves ---

void check_curves(const Case& c, const Curves& curves, test_support::Random& random)
{
  Diagram found(c.tm), expected(c.cut.mesh);
  found.avoid_faces(c.avoided);
  found.avoid_edges(c.range);
  const Place p = random_place(c.tm, c.removed, random);
  Curves all = curves;
  all.emplace_back(c.tm, p.location);
  std::vector<std::size_t> site;
  for(std::size_t i = 0; i < all.size(); ++i)
  {
    found.add_site(all[i]);
    for(const Curve& part : parts_of(c, {all[i]}))
      expected.add_site(part);
    site.resize(expected.number_of_sites(), i);
  }
  std::vector<double> area(all.size(), 0.);
  for(std::size_t i = 0; i < site.size(); ++i)
    area[site[i]] += expected.area(i);
  for(std::size_t i = 0; i < all.size(); ++i)
  {
    // Points of curves are rounded when faces are divided. Where a bisector touches a curve, that moves it by the
    // square root: without walls, areas of the divided mesh differ by as much.
    CHECK_NEAR(found.area(i), area[i], 1e-8);
    Mesh cell;
    found.cell_mesh(i, cell, cell.add_property_map<face_descriptor, face_descriptor>("f:face").first, 1e-5);
    double sum = 0;
    for(const face_descriptor f : cell.faces())
    {
      const auto h = cell.halfedge(f);
      sum += std::sqrt(CGAL::squared_area(cell.point(cell.source(h)), cell.point(cell.target(h)),
                                          cell.point(cell.target(cell.next(h)))));
    }
    CHECK_NEAR(sum, found.area(i), 1e-3);
    if(found.is_disk(i))
      CHECK_EQUAL(num_vertices(cell) + num_faces(cell), num_edges(cell) + 1);
  }
  CHECK(SMG::certify_geodesic_Voronoi_diagram(found).is_certified());
}

void test_curves()
{
  test_support::Random random(6);
  std::size_t number = 0;
  for_each_case(random, [&](const Case& c, std::size_t i)
  {
    const std::vector<Curves> all = all_curves(c, random);
    check_curves(c, all[i % all.size()], random);
    ++number;
  });
  CHECK(number > 30);
}

// Two components, each the cell of a curve, which has no boundary.
void test_cells_without_boundary()
{
  const test_support::Scope scope("cells without a boundary");
  const Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  Diagram diagram(tm);
  for(const std::size_t f : {std::size_t(num_faces(tm) - 1), std::size_t(0)})
  {
    const auto h = halfedge(face_descriptor(static_cast<Mesh::size_type>(f)), tm);
    diagram.add_site(Curve(tm, std::vector<vertex_descriptor>{source(h, tm), target(h, tm)}));
  }
  std::size_t faces_of_cells = 0;
  for(std::size_t i = 0; i < 2; ++i)
  {
    Mesh cell;
    diagram.cell_mesh(i, cell, cell.add_property_map<face_descriptor, face_descriptor>("f:face").first);
    CHECK(num_faces(cell) > 0);
    faces_of_cells += num_faces(cell);
  }
  CHECK(faces_of_cells >= num_faces(tm));
}

// --- relaxation ---

void test_relaxation()
{
  test_support::Random random(7);
  std::size_t number_that_differ = 0;
  for_each_case(random, [&](const Case& c, std::size_t i)
  {
    std::vector<vertex_descriptor> sites, found, free;
    while(sites.size() < 3)
    {
      const Place p = random_place(c.tm, c.removed, random);
      if(!sides(c.tm, c.cut, c.removed, {p.vertex, {}, true}).empty())
        sites.push_back(p.vertex);
    }
    const auto relax = [&](const auto& parameters, std::vector<vertex_descriptor>& output)
    { SMG::geodesic_Lloyd_relaxation(c.tm, sites, std::back_inserter(output), parameters.number_of_iterations(3)); };
    relax(np::faces_to_avoid(c.avoided), free);
    if(i % 2 == 0)
      relax(np::faces_to_avoid(c.avoided).edges_to_avoid(c.range), found);
    else
      relax(np::faces_to_avoid(c.avoided).edges_to_avoid(std::cref(c.walls)), found);
    number_that_differ += found != free ? 1 : 0;
    Diagram diagram(c.tm);
    diagram.avoid_faces(c.avoided);
    diagram.avoid_edges(c.range);
    for(int k = 0; k < 3; ++k)
    {
      diagram.remove_all_sites();
      diagram.add_sites(sites);
      for(std::size_t s = 0; s < sites.size(); ++s)
        if(diagram.central_vertex(s) != Mesh::null_vertex())
          sites[s] = diagram.central_vertex(s);
    }
    CHECK(found == sites);
  });
  CHECK(number_that_differ > 10);
  // Each side of a rectangle has its own center.
  const Mesh tm = to_face_graph(flat_patch(8, 4, 0, true, 1));
  const auto at = [](std::size_t x, std::size_t y)
  { return vertex_descriptor(static_cast<Mesh::size_type>(5 * x + y)); };
  std::vector<edge_descriptor> wall;
  for(std::size_t y = 0; y < 4; ++y)
    wall.push_back(tm.edge(tm.halfedge(at(4, y), at(4, y + 1))));
  std::vector<vertex_descriptor> found;
  SMG::geodesic_Lloyd_relaxation(tm, std::vector<vertex_descriptor>{at(0, 0), at(5, 4)}, std::back_inserter(found),
                                 np::edges_to_avoid(wall));
  CHECK((found == std::vector<vertex_descriptor>{at(2, 2), at(6, 2)}));
}

// An edge at the border is no wall: all conditions are checked as without it.
void test_walls_at_the_border()
{
  const test_support::Scope scope("walls at the border");
  const Mesh tm = to_face_graph(flat_patch(3, 3, 0., true, 1));
  std::vector<edge_descriptor> border;
  for(const edge_descriptor e : edges(tm))
    if(is_border(e, tm))
      border.push_back(e);
  Diagram diagram(tm);
  diagram.add_site(vertex_descriptor(0));
  diagram.add_site(vertex_descriptor(num_vertices(tm) - 1));
  diagram.avoid_edges(border);
  const auto certificate = SMG::certify_geodesic_Voronoi_diagram(diagram);
  CHECK(certificate.is_certified());
  CHECK(certificate.number_of_checks(Certificate::Condition::CURVES) > 0);
  CHECK(certificate.number_of_checks(Certificate::Condition::DISTANCES) > 0);
}

// Faces that a mesh has got after its walls have none, and are not avoided.
void test_meshes_that_grow()
{
  const test_support::Scope scope("meshes that grow");
  Mesh tm = to_face_graph(flat_patch(2, 2, 0., true, 1));
  Diagram diagram(tm);
  diagram.avoid_edges(std::vector<edge_descriptor>{*edges(tm).begin()});
  diagram.avoid_faces(std::vector<face_descriptor>{*faces(tm).begin()});
  const std::size_t number = num_faces(tm);
  tm += to_face_graph(icosphere(1));
  diagram.clear();
  diagram.add_site(vertex_descriptor(num_vertices(tm) - 1));
  const std::vector<face_descriptor> all(faces(tm).begin(), faces(tm).end());
  for(std::size_t i = number; i < all.size(); ++i)
  {
    CHECK(!diagram.avoids_face(all[i]) && !diagram.avoids_edge(edge(halfedge(all[i], tm), tm)));
    const Diagram::Face_location middle_of_edge(all[i], {.5, .5, 0.});
    CHECK_EQUAL(diagram.nearest_site(middle_of_edge), 0u);
    CHECK(diagram.distance_to_nearest_site(middle_of_edge) > 0);
  }
}

} // namespace

int main()
{
  test_certificates();
  test_hostile_meshes();
  test_curves();
  test_cells_without_boundary();
  test_relaxation();
  test_walls_at_the_border();
  test_meshes_that_grow();
  return test_result();
}
