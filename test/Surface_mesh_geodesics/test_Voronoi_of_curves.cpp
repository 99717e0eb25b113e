// Diagrams with curves among their sites. In the plane, arcs and areas are known in closed form: segments between
// parallel sides, a parabola between a point and a side, the diagonals of a square. On bumpy and on hostile meshes,
// distances from one site at a time tell what is right.

#include "Voronoi_test_helpers.h"
#include "curve_cases.h"
#include "curves_in_plane.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace curve_cases;

namespace {

using Certificate = CGAL::Surface_mesh_geodesics::Geodesic_Voronoi_certificate;
using Weights = std::vector<double>;

void add_sites(Voronoi& diagram, const std::vector<Curve>& curves, const Weights& weights = {})
{
  for(std::size_t i = 0; i < curves.size(); ++i)
    CHECK_EQUAL(diagram.add_site(curves[i], weights.empty() ? 0. : weights[i]), i);
}

// --- the plane ---

// Checks that f vanishes on all arcs, and that the cells have the given areas. Both are relative to the size.
void check_plane(const std::string& name, const Square& square, const std::vector<Curve>& curves,
                 const std::function<double(double, double)>& f, const std::vector<double>& areas,
                 const Weights& weights = {}, double precision = 1e-11)
{
  test_support::Scope scope(name + ", size " + std::to_string(square.size));
  Voronoi diagram(square.tm);
  add_sites(diagram, curves, weights);
  CHECK(areas.size() < 2 || !diagram.arcs().empty());
  for(const Voronoi::Arc& a : diagram.arcs())
    for(const double t : {0., .25, .5, 1.})
    {
      const Voronoi::Point_3 p = diagram.point(a.point(t));
      CHECK_NEAR(f(p.x(), p.y()), 0., precision * square.size);
    }
  for(std::size_t i = 0; i < areas.size(); ++i)
    CHECK_NEAR(diagram.area(i), areas[i], precision * square.size * square.size);
}

void closed_forms_in_the_plane(std::size_t n)
{
  const Square s(n);
  const double a = s.size, area = a * a;
  check_plane("parallel sides", s, {s.bottom(), s.top()}, [&](double, double y) { return y - a / 2; },
              {area / 2, area / 2});
  check_plane("adjacent sides", s, {s.bottom(), s.left()}, [](double x, double y) { return x - y; },
              {area / 2, area / 2});
  // y^2 = (x - a)^2 + (y - a)^2: the focus is a corner, the directrix a side
  check_plane("a point and a side", s, {s.bottom(), Curve(s.tm, s.at(a, a))},
              [&](double x, double y) { return ((x - a) * (x - a) + a * a - 2 * a * y) / a; },
              {2 * area / 3, area / 3});
  check_plane("four sides", s, {s.bottom(), s.right(), s.top(), s.left()},
              [&](double x, double y) { return (x - y) * (x + y - a) / a; }, {area / 4, area / 4, area / 4, area / 4});
  check_plane("parallel sides with weights", s, {s.left(), s.right()}, [&](double x, double) { return x - .7 * a; },
              {.7 * area, .3 * area}, {.4 * a, 0.});
}

// Curves that touch: what is nearest to a common vertex belongs to the first of them. Beside the boundary of such a
// region distances differ by the square of the distance from it, so it is known up to the square root of rounding.
void touching_curves()
{
  const Square s(5);
  check_plane("on one line", s, {s.line(1, 2, 2, 2), s.line(2, 2, 3, 2)}, [](double x, double) { return x - 2; },
              {10, 15}, {}, 1e-7);
  // the corner (2, 2) is nearest to the quarter x > 2, y < 2, which belongs to the first curve
  check_plane("a corner", s, {s.line(1, 2, 2, 2), s.line(2, 2, 2, 3)}, [](double x, double y)
  { return x < 2 ? x + y - 4 : y - 2; }, {12, 13}, {}, 1e-7);
  check_plane("a cross", s, {s.line(1, 2, 3, 2), s.line(2, 1, 2, 3)},
              [](double x, double y) { return std::abs(x - 2) - std::abs(y - 2); }, {});
  const std::vector<Curve> equal(2, s.line(1, 2, 3, 2));
  Voronoi diagram(s.tm, equal);
  CHECK(diagram.arcs().empty() && !diagram.is_empty(0) && diagram.is_empty(1));
  CHECK_NEAR(diagram.area(0), 25., 1e-12);
}

// A later curve that ends on an earlier one: all points that are nearest to that end are in the cell of the first one,
// also those that a ray of the later curve meets at its end.
void curve_that_ends_on_another()
{
  const test_support::Scope scope("an end on another curve");
  const Mesh tm = to_face_graph(icosphere(1));
  const Location end(face_descriptor(15), {.5, .5, 0});
  const std::vector<Location> there(2, end);
  const std::vector<Location> path{
    Location(face_descriptor(14), {1, 0, 0}), Location(face_descriptor(14), {.267611, 0, .732389}), end};
  const Voronoi diagram(tm, std::vector<Curve>{Curve(tm, there), Curve(tm, path)});
  for(std::size_t i = 0; i < 2; ++i)
  {
    CHECK_EQUAL(diagram.Euler_characteristic(i), 1);
    CHECK(diagram.is_disk(i));
    CHECK_EQUAL(diagram.boundary(i).size(), 1u);
  }
}

// A curve that is there twice has one cell, also if it begins so near to an edge that the parts of the face beside its
// first point are as narrow as rounding; and if it is given in the faces on either side of an edge.
void equal_curves()
{
  const test_support::Scope scope("equal curves");
  const Mesh tm = to_face_graph(noisy_sphere(1, .3, 70));
  const auto has_one_cell = [&](const Curve& a, const Curve& b)
  {
    const Voronoi diagram(tm, std::vector<Curve>{a, b});
    return diagram.arcs().empty() && !diagram.is_empty(0) && diagram.is_empty(1);
  };
  const face_descriptor f(27);
  const std::vector<Location> near_edge{Location(f, {1 - .000416719 - 1.89249e-14, .000416719, 1.89249e-14}),
                                        Location(f, {1 - .0905243 - .568544, .0905243, .568544})};
  CHECK(has_one_cell(Curve(tm, near_edge), Curve(tm, near_edge)));
  test_support::Random random(1);
  int number_of_curves = 0;
  for(int i = 0; i < 40; ++i)
  {
    const std::vector<Location> locations = random_locations(tm, 4, random);
    std::vector<Location> others = locations;
    for(Location& l : others)
      for(std::size_t k = 0; k < 3; ++k)
        if(l.second[k] == 0 && l.second[(k + 1) % 3] != 0 && l.second[(k + 2) % 3] != 0)
        {
          to_neighbor(tm, l, k);
          break;
        }
    try
    {
      CHECK(has_one_cell(Curve(tm, locations), Curve(tm, others)));
      ++number_of_curves;
    }
    catch(const CGAL::Surface_mesh_geodesics::Invalid_geodesic_input&)
    {} // two locations in no common face
  }
  CHECK(number_of_curves > 10);
}

// The cell of a curve may be a whole component, without any arc; its mesh is that component.
void cells_without_arcs()
{
  const test_support::Scope scope("cells without arcs");
  Mesh tm = to_face_graph(flat_patch(2, 2, 0., true, 1));
  const Mesh other = to_face_graph(icosphere(1));
  std::vector<Curve> curves = CGAL::Surface_mesh_geodesics::border_curves(tm);
  tm += other;
  const vertex_descriptor v(num_vertices(tm) - 1);
  curves.emplace_back(tm, std::vector<vertex_descriptor>{v, target(halfedge(v, tm), tm),
                                                         source(halfedge(v, tm), tm)});
  const Voronoi diagram(tm, curves);
  CHECK(diagram.arcs().empty());
  for(std::size_t i = 0; i < 2; ++i)
  {
    Mesh cell;
    auto faces_of_cell = cell.add_property_map<face_descriptor, face_descriptor>("f:f").first;
    diagram.cell_mesh(i, cell, faces_of_cell, 1e-3);
    CHECK(is_valid_polygon_mesh(cell));
    CHECK_NEAR(CGAL::Polygon_mesh_processing::area(cell), diagram.area(i), 1e-12);
    CHECK(diagram.area(i) > 1);
  }
  // More sites than vertices: numbers of sites are no vertices.
  const Mesh small = to_face_graph(flat_patch(1, 1, 0., true, 1));
  Voronoi many(small);
  for(std::size_t i = 0; i < 100; ++i)
    many.add_site(CGAL::Surface_mesh_geodesics::border_curves(small)[0], i == 99 ? 1. : 0.);
  Mesh cell;
  auto faces_of_cell = cell.add_property_map<face_descriptor, face_descriptor>("f:f").first;
  many.cell_mesh(99, cell, faces_of_cell, 1e-3);
  CHECK_NEAR(CGAL::Polygon_mesh_processing::area(cell), many.area(99), 1e-12);
  CHECK_NEAR(many.area(99), 1., 1e-12);
}

// --- against distances from one site at a time ---

// Is the diagram certified? As in test_Voronoi_on_hostile_meshes.cpp, the areas of needles have half of the digits.
bool is_right(const Voronoi& diagram)
{
  const Certificate certificate = CGAL::Surface_mesh_geodesics::certify_geodesic_Voronoi_diagram(diagram);
  for(std::size_t k = 0; k < Certificate::number_of_conditions; ++k)
  {
    const Certificate::Condition condition = static_cast<Certificate::Condition>(k);
    const double tolerance = condition == Certificate::Condition::AREAS ? 0x1p-26 : Certificate::default_tolerance;
    if(!(certificate.worst_violation(condition) <= tolerance))
      return false;
  }
  return true;
}

// The distances from each site, less its weight.
class Distances_of_curves
{
public:
  Distances_of_curves(const Mesh& tm, const std::vector<Curve>& curves, const Weights& weights) : m_weights(weights)
  {
    m_weights.resize(curves.size(), 0.);
    for(const Curve& c : curves)
    {
      m_paths.emplace_back(new Paths(tm));
      m_paths.back()->add_source_curve(c);
    }
  }

  double operator()(std::size_t i, vertex_descriptor v) const
  {
    return m_paths[i]->shortest_distance_to_source_points(v).first - m_weights[i];
  }

  double operator()(std::size_t i, const Voronoi::Face_location& l) const
  {
    return m_paths[i]->shortest_distance_to_source_points(l.first, l.second).first - m_weights[i];
  }

  template <typename Place>
  double nearest(const Place& p) const
  {
    double best = infinity;
    for(std::size_t i = 0; i < m_paths.size(); ++i)
      best = (std::min)(best, (*this)(i, p));
    return best;
  }

private:
  std::vector<std::unique_ptr<Paths>> m_paths;
  Weights m_weights;
};

// Labels with and without a diagram. Requires: all sites reach all vertices.
void check_labels(const Mesh& tm, const Voronoi& diagram, const std::vector<Curve>& curves, const Weights& weights,
                  const Distances_of_curves& distance)
{
  std::map<vertex_descriptor, std::size_t> label;
  std::map<vertex_descriptor, double> from_label;
  CGAL::Surface_mesh_geodesics::geodesic_Voronoi_labels(
    tm, boost::make_assoc_property_map(label), curves,
    CGAL::parameters::vertex_distance_map(boost::make_assoc_property_map(from_label)).site_weights(weights));
  for(const vertex_descriptor v : vertices(tm))
  {
    const double best = distance.nearest(v);
    CHECK_NEAR(from_label[v], best, 1e-12);
    CHECK_NEAR(distance(label[v], v), best, 1e-12);
    CHECK_NEAR(distance(diagram.nearest_site(v), v), best, 1e-12);
    CHECK_NEAR(diagram.distance_to_nearest_site(v), best, 1e-12);
  }
}

// Each face of the cut mesh is in the cell that it is said to be in, and the faces of a cell have its area.
void check_cut(const Mesh& tm, const Voronoi& diagram, const std::vector<Curve>& curves, double tolerance)
{
  Mesh cut;
  auto site = cut.add_property_map<face_descriptor, std::size_t>("f:site").first;
  diagram.cut(cut, site, tolerance);
  CHECK(is_valid_polygon_mesh(cut));
  double all = 0;
  std::vector<double> area(curves.size(), 0.);
  for(const face_descriptor f : faces(cut))
    if(CHECK(site[f] < curves.size()))
      area[site[f]] += test_meshes::area_of_face(cut, f);
  for(const face_descriptor f : faces(tm))
    all += test_meshes::area_of_face(tm, f);
  double sum = 0;
  for(std::size_t i = 0; i < curves.size(); ++i)
  {
    sum += diagram.area(i);
    CHECK_NEAR(area[i], diagram.area(i), 30 * tolerance);
  }
  CHECK_NEAR(sum, all, 1e-11 * all);
}

// Arcs are as far from both of their sites as from the nearest one.
void check_arcs(const Voronoi& diagram, const Distances_of_curves& distance)
{
  for(const Voronoi::Arc& a : diagram.arcs())
    for(const double t : {0., .25, .5, .75, 1.})
    {
      const Voronoi::Face_location l = a.point(t);
      const double best = distance.nearest(l);
      CHECK_NEAR(a.distance(t), best, 1e-11);
      CHECK_NEAR(distance(a.sites().first, l), best, 1e-11);
      CHECK_NEAR(distance(a.sites().second, l), best, 1e-11);
    }
}

// On a closed surface, the arcs around a disk make one closed line; the polyline that is drawn is shorter by little.
void check_boundaries(const Mesh& tm, const Voronoi& diagram, std::size_t number_of_sites)
{
  for(std::size_t i = 0; i < number_of_sites; ++i)
  {
    double length = 0, drawn = 0;
    for(const Voronoi::Arc& a : diagram.arcs(i))
      length += a.length();
    const auto lines = diagram.boundary_polylines(i, 1e-4);
    CHECK(!diagram.is_disk(i) || lines.size() == 1);
    for(const Voronoi::Boundary_polyline& line : lines)
    {
      CHECK(line.is_closed);
      const auto& l = line.locations;
      for(std::size_t k = 0; k + 1 < l.size(); ++k)
        drawn += std::sqrt(CGAL::squared_distance(Paths::point(l[k].first, l[k].second, tm),
                                                  Paths::point(l[k + 1].first, l[k + 1].second, tm)));
    }
    CHECK(drawn <= length * (1 + 1e-9) && drawn >= .99 * length);
  }
}

void bumpy_spheres()
{
  bool have_parabolas = false;
  for(std::uint64_t seed = 0; seed < 12; ++seed)
  {
    const test_support::Scope scope("bumpy sphere " + std::to_string(seed));
    test_support::Random random(seed);
    const Mesh tm = to_face_graph(noisy_sphere(1 + seed % 2, .2, seed));
    std::vector<Curve> curves;
    for(std::size_t i = 0; i < 4; ++i)
      curves.push_back(random_curve(tm, random));
    Weights weights;
    for(std::size_t i = 0; i < (seed % 2) * curves.size(); ++i)
      weights.push_back(.3 * random.uniform());
    Voronoi diagram(tm);
    add_sites(diagram, curves, weights);
    const Distances_of_curves distance(tm, curves, weights);
    check_labels(tm, diagram, curves, weights, distance);
    check_arcs(diagram, distance);
    check_cut(tm, diagram, curves, 1e-3);
    check_boundaries(tm, diagram, curves.size());
    CHECK(is_right(diagram));
    have_parabolas = have_parabolas || (weights.empty() && !std::all_of(diagram.arcs().begin(), diagram.arcs().end(),
                                                                       [](const auto& a) { return a.is_segment(); }));
  }
  CHECK(have_parabolas);
}

void hostile_surfaces()
{
  for_each_hostile_case([](const Mesh& tm, const std::vector<Curve>& curves, test_support::Random&)
  {
    const Voronoi diagram(tm, curves);
    CHECK(is_right(diagram));
  });
}

// The cell of a curve that another one crosses has two parts: an annulus around a point, and a disk beyond. Their
// Euler characteristics have the sum of a disk. (On bumps, no boundary runs through a vertex of the mesh.)
void curve_that_is_crossed()
{
  Square s(12);
  test_support::Random random(1);
  for(const vertex_descriptor v : vertices(s.tm))
    s.tm.point(v) = Mesh::Point(s.tm.point(v).x(), s.tm.point(v).y(), random.uniform(0., .1));
  std::vector<Point_2> across, loop{{3, 6}};
  for(int y = 0; y <= 12; ++y)
    across.push_back({7, double(y)});
  const auto add_line = [&](double x, double y)
  {
    while(loop.back() != Point_2{x, y})
      loop.push_back({loop.back()[0] + (x > loop.back()[0]) - (x < loop.back()[0]),
                      loop.back()[1] + (y > loop.back()[1]) - (y < loop.back()[1])});
  };
  for(const Point_2& p : {Point_2{3, 8}, Point_2{1, 8}, Point_2{1, 4}, Point_2{3, 4}, Point_2{3, 6}, Point_2{11, 6}})
    add_line(p[0], p[1]);
  Voronoi diagram(s.tm);
  add_sites(diagram, {s.line(across), s.line(loop), Curve(s.tm, s.at(2, 6))}, {1.03, 0., .07});
  CHECK(is_right(diagram));
  CHECK_EQUAL(diagram.Euler_characteristic(1), 1);
  CHECK(!diagram.is_disk(1) && diagram.is_disk(0) && diagram.is_disk(2));
  Mesh cell;
  const auto face_of_face = cell.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:face").first;
  diagram.cell_mesh(1, cell, face_of_face);
  const auto component = cell.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  CHECK_EQUAL(CGAL::Polygon_mesh_processing::connected_components(cell, component), 2u);
}

// --- the interface ---

void sites_that_are_curves()
{
  const Square s(2);
  Voronoi diagram(s.tm);
  CHECK_EQUAL(diagram.add_site(s.bottom(), .25), 0u);
  CHECK_EQUAL(diagram.add_site(s.at(2, 2)), 1u);
  CHECK_EQUAL(diagram.add_site(Curve(s.tm, s.at(0, 2))), 2u);
  CHECK(diagram.site_curve(0) != nullptr && diagram.site_curve(0)->segments().size() == 2);
  CHECK(diagram.site_curve(1) == nullptr && diagram.site_curve(2) == nullptr);
  CHECK_EQUAL(diagram.weight(0), .25);
  CHECK_NEAR(CGAL::squared_distance(diagram.point(diagram.site(0)), s.tm.point(s.at(0, 0))), 0., 1e-30);
  CHECK_NEAR(diagram.distance_to_nearest_site(s.at(1, 1)), .75, 1e-15);
  CHECK_EQUAL(diagram.nearest_site(s.at(1, 1)), 0u);
  CHECK(diagram.is_disk(0) && diagram.is_disk(1) && diagram.is_disk(2));
  CHECK_EQUAL(diagram.Euler_characteristic(0), 1);
  CHECK_EQUAL(diagram.adjacent_sites(0).size(), 2u);
  std::vector<std::array<std::size_t, 3>> dual;
  diagram.dual(std::back_inserter(dual));
  CHECK_EQUAL(dual.size(), diagram.vertices().size());
  double border = 0;
  for(const Voronoi::Boundary_polyline& line : diagram.boundary_polylines(0, 1e-3, true))
    border += line.is_closed ? 1 : 0;
  CHECK_EQUAL(border, 1.);
  const double area = diagram.area(0);
  // The same from lengths; after points alone, the diagram is one of points again.
  std::map<Mesh::Edge_index, double> lengths;
  for(const Mesh::Edge_index e : s.tm.edges())
    lengths[e] = std::sqrt(CGAL::squared_distance(s.tm.point(s.tm.vertex(e, 0)), s.tm.point(s.tm.vertex(e, 1))));
  diagram.use_edge_lengths(boost::make_assoc_property_map(lengths));
  CHECK_NEAR(diagram.area(0), area, 1e-14);
  diagram.remove_all_sites();
  diagram.add_site(s.at(0, 0));
  CHECK_NEAR(diagram.area(0), 4., 1e-15);
}

// A curve of another mesh, and a weight that is no number.
void bad_sites()
{
  const Square s(1), large(5);
  Voronoi diagram(s.tm);
  diagram.add_site(large.top());
  using Error = CGAL::Surface_mesh_geodesics::Invalid_geodesic_input;
  const auto throws = [](const auto& f)
  {
    try
    {
      f();
      return false;
    }
    catch(const Error&)
    {
      return true;
    }
  };
  CHECK(throws([&] { diagram.build(); }));
  diagram.remove_all_sites();
  CHECK(throws([&] { diagram.add_site(s.top(), std::numeric_limits<double>::quiet_NaN()); }));
  CHECK_EQUAL(diagram.number_of_sites(), 0u);
}

} // namespace

int main()
{
  for(const std::size_t n : {1u, 2u, 5u})
    closed_forms_in_the_plane(n);
  touching_curves();
  curve_that_ends_on_another();
  equal_curves();
  cells_without_arcs();
  curve_that_is_crossed();
  bumpy_spheres();
  hostile_surfaces();
  sites_that_are_curves();
  bad_sites();
  return test_result();
}
