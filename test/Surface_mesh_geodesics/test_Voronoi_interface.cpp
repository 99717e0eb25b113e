// What the class of Voronoi diagrams promises besides a right diagram: lazy construction, changes of sites, clear(),
// use from several threads, exceptions, other types of meshes, property maps and kernels.

#include "Voronoi_test_helpers.h"
#include "expected_exceptions.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <type_traits>
#include <vector>

using namespace test_meshes;

namespace {

void a_diagram_follows_its_sites()
{
  test_support::Scope scope("life of a diagram");
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 3));
  test_support::Random random(4);
  Voronoi diagram(tm);
  CHECK(!diagram.is_built());
  CHECK_EQUAL(diagram.number_of_sites(), 0u);
  CHECK(diagram.arcs().empty() && diagram.edges().empty() && diagram.vertices().empty());
  CHECK_EQUAL(diagram.nearest_site(vertex(0)), null_site);
  CHECK_EQUAL(diagram.distance_to_nearest_site(vertex(0)), -1.);
  CHECK(&diagram.triangle_mesh() == &tm);

  Weighted_sites sites = random_sites(tm, 5, 0., random);
  add_sites(diagram, sites);
  CHECK(!diagram.is_built());
  diagram.build();
  CHECK(diagram.is_built());
  Voronoi_validator(tm, diagram, sites).check_all(random, 20);
  CHECK(diagram.statistics().maximum_windows_alive > 0);
  CHECK(diagram.number_of_kept_windows().first <= diagram.number_of_kept_windows().second);

  // one site more
  CHECK_EQUAL(diagram.add_site(vertex(7), .01), 5u);
  sites.emplace_back(vertex(7), .01);
  CHECK(!diagram.is_built());
  CHECK_EQUAL(diagram.nearest_site(vertex(7)), 5u);
  CHECK(diagram.is_built());
  CHECK_EQUAL(diagram.weight(5), .01);
  CHECK(length(coordinates(diagram.site(5), tm) - coordinates(vertex(7), tm)) < 1e-14);
  Voronoi_validator(tm, diagram, sites).check_all(random, 20);

  // ranges of sites, after clear()
  diagram.clear();
  CHECK_EQUAL(diagram.number_of_sites(), 0u);
  CHECK(!diagram.is_built());
  CHECK_EQUAL(diagram.add_sites(std::vector<vertex_descriptor>{vertex(1), vertex(2)}), 0u);
  CHECK_EQUAL(diagram.add_sites(std::vector<Face_location>{random_location(tm, random)}), 2u);
  CHECK_EQUAL(diagram.number_of_sites(), 3u);
  CHECK_EQUAL(diagram.nearest_site(diagram.site(2)), 2u);
  diagram.clear();
  CHECK(diagram.arcs().empty() && diagram.edges().empty() && diagram.vertices().empty());

  // sites in the constructor
  const std::vector<vertex_descriptor> some{vertex(3), vertex(9)};
  const Voronoi of_vertices(tm, some), of_locations(tm, std::vector<Face_location>{random_location(tm, random)});
  CHECK_EQUAL(of_vertices.number_of_sites(), 2u);
  CHECK_EQUAL(of_vertices.nearest_site(vertex(9)), 1u);
  CHECK_EQUAL(of_locations.nearest_site(vertex(0)), 0u);
  static_assert(!std::is_constructible<Voronoi, const Mesh&, const std::vector<double>&>::value,
                "numbers are no sites");
}

// A property map of the points of a mesh that counts its reads.
struct Counting_point_map
{
  using key_type = vertex_descriptor;
  using value_type = Mesh::Point;
  using reference = Mesh::Point;
  using category = boost::readable_property_map_tag;

  const Mesh* tm;
  std::size_t* count;

  friend Mesh::Point get(const Counting_point_map& map, vertex_descriptor v)
  {
    ++*map.count;
    return map.tm->point(v);
  }
};

// Other sites on the same mesh, as in each iteration of Lloyd's method. The mesh is not read again, and the former
// sites have no influence.
void former_sites_have_no_influence()
{
  test_support::Scope scope("other sites on the same mesh");
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 3));
  std::size_t count = 0;
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  using CGAL::Default;
  CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits, Default, Default, Default, Counting_point_map> diagram(
    tm, get(boost::vertex_index, tm), get(boost::halfedge_index, tm), get(boost::face_index, tm),
    Counting_point_map{&tm, &count});
  test_support::Random random(14);
  bool is_read = false;
  for(const std::size_t n : {40u, 7u, 1u, 0u, 20u})
  {
    diagram.remove_all_sites();
    CHECK_EQUAL(diagram.number_of_sites(), 0u);
    CHECK(!diagram.is_built());
    const Weighted_sites sites = random_sites(tm, n, n == 7 ? .1 : 0., random);
    add_sites(diagram, sites);
    count = 0;
    diagram.build();
    CHECK(is_read ? count == 0 : count >= num_vertices(tm));
    is_read = true;
    Voronoi fresh(tm);
    add_sites(fresh, sites);
    CHECK_EQUAL(diagram.arcs().size(), fresh.arcs().size());
    for(std::size_t i = 0; i < fresh.arcs().size(); ++i)
    {
      CHECK(diagram.arcs()[i].sites() == fresh.arcs()[i].sites());
      CHECK(diagram.arcs()[i].point(.5) == fresh.arcs()[i].point(.5));
    }
    for(std::size_t i = 0; i < n; ++i)
    {
      CHECK_EQUAL(diagram.area(i), fresh.area(i));
      CHECK(diagram.adjacent_sites(i) == fresh.adjacent_sites(i));
    }
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_EQUAL(diagram.nearest_site(v), fresh.nearest_site(v));
      CHECK_EQUAL(diagram.distance_to_nearest_site(v), fresh.distance_to_nearest_site(v));
    }
  }
}

void elements_fit_together()
{
  test_support::Scope scope("elements");
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  test_support::Random random(6);
  const Weighted_sites sites = random_sites(tm, 8, .1, random);
  Voronoi diagram(tm);
  add_sites(diagram, sites);
  bool has_hyperbola = false;
  for(const Voronoi::Arc& a : diagram.arcs())
  {
    has_hyperbola = has_hyperbola || !a.is_segment();
    const double tolerance = 1e-4;
    std::vector<Face_location> samples;
    a.sample(tolerance, std::back_inserter(samples));
    CHECK(samples.size() >= 2);
    CHECK(!a.is_segment() || samples.size() == 2);
    double sum = 0.;
    for(std::size_t i = 1; i < samples.size(); ++i)
    {
      CHECK(samples[i].first == a.face());
      sum += length(coordinates(samples[i], tm) - coordinates(samples[i - 1], tm));
    }
    CHECK_CLOSE(a.length(), sum, 1e-2);
    // the polyline is inscribed, up to the rounding of its points, whose coordinates are of the order of 1
    const double rounding = 16. * std::numeric_limits<double>::epsilon() * static_cast<double>(samples.size());
    CHECK(sum <= a.length() * (1. + 1e-12) + rounding);
    for(const double t : {.125, .625}) // points of the arc are near the polyline
    {
      const Coordinates p = coordinates(a.point(t), tm);
      double gap = infinity;
      for(std::size_t i = 1; i < samples.size(); ++i)
      {
        const Coordinates q = coordinates(samples[i - 1], tm), r = coordinates(samples[i], tm);
        gap = (std::min)(gap, length(cross(p - q, r - q)) / length(r - q));
      }
      CHECK(gap <= tolerance);
    }
  }
  CHECK(has_hyperbola);
  for(const Voronoi::Edge& e : diagram.edges())
  {
    std::vector<Kernel::Point_3> polyline;
    e.polyline(1e-3, std::back_inserter(polyline));
    CHECK(polyline.size() >= e.arcs().size() + 1);
    CHECK_EQUAL(diagram.edges()[e.index()].index(), e.index());
  }
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    for(const Voronoi::Arc& a : diagram.arcs(i))
    {
      CHECK(a.sites().first == i || a.sites().second == i);
    }
    const vertex_descriptor c = diagram.central_vertex(i);
    if(c != boost::graph_traits<Mesh>::null_vertex())
    {
      CHECK_EQUAL(diagram.nearest_site(c), i);
    }
  }
}

template <class Function>
void check_throws(Reason reason, Function function)
{
  bool has_thrown = false;
  try
  {
    function();
  }
  catch(const Invalid_input& e)
  {
    has_thrown = true;
    CHECK(e.reason() == reason);
    CHECK(std::string(e.what()).size() > 10);
  }
  CHECK(has_thrown);
}

// Handles are equal if and only if they refer to the same element of the same diagram.
template <typename Element, typename Elements_of>
void check_handles(const Voronoi& diagram, const Voronoi& other, Elements_of elements)
{
  Element element;
  CHECK(element == Element());
  CHECK(elements(diagram).size() > 1);
  CHECK(element != elements(diagram)[0]);
  element = elements(diagram)[0];
  CHECK(element == elements(diagram)[0]);
  CHECK(element != elements(diagram)[1]);
  CHECK(element != elements(other)[0]);
}

void handles_of_one_element_are_equal()
{
  test_support::Scope scope("handles");
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  test_support::Random random(6);
  const Weighted_sites sites = random_sites(tm, 8, .1, random);
  Voronoi diagram(tm), other(tm);
  add_sites(diagram, sites);
  add_sites(other, sites);
  check_handles<Voronoi::Vertex>(diagram, other, [](const Voronoi& d) { return d.vertices(); });
  check_handles<Voronoi::Arc>(diagram, other, [](const Voronoi& d) { return d.arcs(); });
  check_handles<Voronoi::Edge>(diagram, other, [](const Voronoi& d) { return d.edges(); });
}

// Queries reject locations that are not in the mesh, with and without sites.
void absent_locations_are_rejected()
{
  test_support::Scope scope("absent locations");
  const Mesh tm = to_face_graph(cube());
  const std::vector<vertex_descriptor> no_vertices = {vertex(100), boost::graph_traits<Mesh>::null_vertex()};
  const std::vector<Face_location> no_locations
    = {Face_location(boost::graph_traits<Mesh>::null_face(), {1., 0., 0.}), Face_location(face(0), {2., -.5, -.5})};
  Voronoi diagram(tm);
  for(const bool has_site : {false, true})
  {
    if(has_site)
      diagram.add_site(vertex(0));
    for(const vertex_descriptor v : no_vertices)
    {
      check_throws(Reason::INVALID_DESCRIPTOR, [&] { diagram.nearest_site(v); });
      check_throws(Reason::INVALID_DESCRIPTOR, [&] { diagram.distance_to_nearest_site(v); });
    }
    for(const Face_location& l : no_locations)
    {
      check_throws(Reason::INVALID_LOCATION, [&] { diagram.nearest_site(l); });
      check_throws(Reason::INVALID_LOCATION, [&] { diagram.distance_to_nearest_site(l); });
    }
    const Face_location inside(face(0), {.2, .3, .5});
    CHECK_EQUAL(diagram.nearest_site(inside), has_site ? 0u : null_site);
    CHECK_EQUAL(diagram.distance_to_nearest_site(inside) == -1., !has_site);
    CHECK(diagram.is_built());
  }
}

// Parameters beyond the ends of arcs, and invalid tolerances.
void parameters_of_arcs_are_clamped()
{
  test_support::Scope scope("parameters of arcs");
  const Mesh tm = to_face_graph(cube());
  Voronoi diagram(tm);
  diagram.add_site(vertex(0), .1);
  diagram.add_site(vertex(6));
  CHECK(!diagram.arcs().empty());
  for(const auto& a : diagram.arcs())
  {
    CHECK(a.point(-1.) == a.point(0.) && a.point(2.) == a.point(1.));
    CHECK(a.distance(-1.) == a.distance(0.) && a.distance(2.) == a.distance(1.));
    std::vector<Face_location> coarse;
    a.sample(1e300, std::back_inserter(coarse));
    CHECK(coarse.size() == 2 && coarse.front() == a.point(0.) && coarse.back() == a.point(1.));
  }
#if !defined(CGAL_NO_PRECONDITIONS) && !defined(CGAL_NDEBUG)
  for(const double tolerance : {0., -1., std::numeric_limits<double>::quiet_NaN()})
  {
    std::vector<Kernel::Point_3> points;
    CHECK(throws<CGAL::Precondition_exception>(
      [&] { diagram.edges().front().polyline(tolerance, std::back_inserter(points)); }));
    CHECK(points.empty());
  }
#endif
}

void invalid_input_is_rejected()
{
  test_support::Scope scope("invalid input");
  const Mesh tm = to_face_graph(cube());
  Voronoi diagram(tm);
  for(const double w : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity})
  {
    check_throws(Reason::INVALID_OFFSET, [&] { diagram.add_site(vertex(0), w); });
    check_throws(Reason::INVALID_OFFSET, [&] { diagram.add_site(location_of_vertex(vertex(0), face(0), tm), w); });
  }
  CHECK_EQUAL(diagram.number_of_sites(), 0u);
  diagram.add_site(boost::graph_traits<Mesh>::null_vertex());
  diagram.add_site(vertex(100));
  check_throws(Reason::INVALID_DESCRIPTOR, [&] { diagram.build(); });
  for(std::size_t i = 0; i < 2; ++i)
  {
    CHECK(diagram.site(i).first == boost::graph_traits<Mesh>::null_face());
  }

  for(const double w : {1e13, 1e308})
  {
    diagram.clear();
    diagram.add_site(vertex(0), -w);
    diagram.add_site(vertex(1), w);
    check_throws(Reason::INVALID_OFFSET, [&] { diagram.build(); });
  }

  const std::vector<std::pair<Reason, Weighted_site>> invalid = {
    {Reason::INVALID_DESCRIPTOR, Weighted_site(vertex(100))},
    {Reason::INVALID_LOCATION, Weighted_site(Face_location(face(0), {2., -.5, -.5}))},
    {Reason::INVALID_LOCATION, Weighted_site(Face_location(face(0), {infinity, 0., 0.}))},
    {Reason::INVALID_LOCATION, Weighted_site(Face_location(boost::graph_traits<Mesh>::null_face(), {1., 0., 0.}))}};
  for(const auto& i : invalid)
  {
    diagram.clear();
    diagram.add_site(vertex(1));
    add_sites(diagram, {i.second});
    for(int times = 0; times < 2; ++times)
    {
      check_throws(i.first, [&] { diagram.build(); });
      check_throws(i.first, [&] { diagram.nearest_site(vertex(0)); });
      CHECK(!diagram.is_built());
    }
    diagram.clear();
    diagram.add_site(vertex(1));
    diagram.add_site(vertex(3));
    CHECK_EQUAL(diagram.nearest_site(vertex(3)), 1u);
    CHECK_CLOSE(diagram.area(0) + diagram.area(1), 6., 1e-12);
  }
}

// Returns the answers to all kinds of queries. Queries the site and the distance of each point of `queries`.
std::vector<double> all_answers(const Voronoi& diagram, const std::vector<Face_location>& queries)
{
  std::vector<double> result;
  for(const Face_location& q : queries)
  {
    result.push_back(static_cast<double>(diagram.nearest_site(q)));
    result.push_back(diagram.distance_to_nearest_site(q));
  }
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
  {
    result.push_back(diagram.area(i));
    result.push_back(diagram.Euler_characteristic(i));
    result.push_back(static_cast<double>(diagram.adjacent_sites(i).size()));
  }
  for(const Voronoi::Edge& e : diagram.edges())
  {
    result.push_back(e.length());
  }
  return result;
}

// The first query builds the diagram, measures it and propagates again. Any thread may make it.
void any_thread_may_build()
{
  test_support::Scope scope("threads");
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 8));
  test_support::Random random(9);
  const Weighted_sites sites = random_sites(tm, 6, .05, random);
  std::vector<Face_location> queries;
  for(int i = 0; i < 50; ++i)
  {
    queries.push_back(random_location(tm, random));
  }
  Voronoi expected(tm), diagram(tm);
  add_sites(expected, sites);
  add_sites(diagram, sites);
  const std::vector<double> values = all_answers(expected, queries);
  std::vector<std::vector<double>> results(4);
  std::vector<std::thread> threads;
  for(std::vector<double>& r : results)
  {
    threads.emplace_back([&] { r = all_answers(diagram, queries); });
  }
  // Distances at vertices are known before distances in faces, and do not change when the latter are computed.
  double largest_difference = 0;
  threads.emplace_back([&]
  {
    for(int times = 0; times < 100; ++times)
    {
      for(const vertex_descriptor v : vertices(tm))
      {
        largest_difference = (std::max)(largest_difference, std::abs(diagram.distance_to_nearest_site(v)
                                                                     - expected.distance_to_nearest_site(v)));
      }
    }
  });
  for(std::thread& t : threads)
  {
    t.join();
  }
  for(const std::vector<double>& r : results)
  {
    CHECK(r == values);
  }
  CHECK_EQUAL(largest_difference, 0.);
}

// Its cell has no area and lies in no face.
void the_cell_of_an_isolated_vertex_has_no_area()
{
  test_support::Scope scope("isolated vertex");
  const Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  const vertex_descriptor isolated = vertex(num_vertices(tm) - 1);
  Voronoi diagram(tm);
  diagram.add_site(vertex(0));
  diagram.add_site(isolated);
  CHECK(diagram.site(1).first == boost::graph_traits<Mesh>::null_face());
  CHECK_EQUAL(diagram.nearest_site(isolated), 1u);
  CHECK_EQUAL(diagram.distance_to_nearest_site(isolated), 0.);
  CHECK_EQUAL(diagram.area(1), 0.);
  CHECK(diagram.centroid(1) == tm.point(isolated));
  CHECK(diagram.central_vertex(1) == isolated);
}

// The same diagram with another class of meshes, another kernel, and maps of the user.
template <class Other_kernel, class Other_mesh>
void other_meshes_agree(const std::string& name)
{
  test_support::Scope scope(name);
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Other_kernel, Other_mesh>;
  using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
  const Indexed_mesh indexed = cube_grid(2);
  const Mesh tm = to_face_graph(indexed);
  Other_mesh other = to_face_graph<Other_mesh>(indexed);
  CGAL::set_halfedgeds_items_id(other);
  const std::vector<std::size_t> numbers = {0, 5, 11};
  const std::vector<typename boost::graph_traits<Other_mesh>::vertex_descriptor> all(vertices(other).begin(),
                                                                                      vertices(other).end());
  Voronoi expected(tm);
  Diagram diagram(other);
  for(const std::size_t v : numbers)
  {
    expected.add_site(vertex(v), .125);
    diagram.add_site(all[v], typename Traits::FT(.125));
  }
  double sum = 0.;
  for(std::size_t i = 0; i < numbers.size(); ++i)
  {
    sum += CGAL::to_double(diagram.area(i));
    CHECK_EQUAL(diagram.nearest_site(all[numbers[i]]), i);
    CHECK_EQUAL(CGAL::to_double(diagram.distance_to_nearest_site(all[numbers[i]])), -.125);
  }
  CHECK_CLOSE(sum, 24., 1e-12);
  double l = 0., m = 0.;
  for(const auto& e : expected.edges())
  {
    l += e.length();
  }
  for(const auto& e : diagram.edges())
  {
    m += CGAL::to_double(e.length());
  }
  CHECK_CLOSE(l, m, 1e-12);
  for(std::size_t v = 0; v < all.size(); ++v)
  {
    CHECK_CLOSE(CGAL::to_double(diagram.distance_to_nearest_site(all[v])),
                expected.distance_to_nearest_site(vertex(v)), 1e-13);
  }
}

void maps_of_the_user_are_used()
{
  test_support::Scope scope("maps");
  using Vertex_map = Mesh::Property_map<vertex_descriptor, unsigned int>;
  using Face_map = Mesh::Property_map<face_descriptor, unsigned int>;
  using Point_map = Mesh::Property_map<vertex_descriptor, Kernel::Point_3>;
  using Diagram
    = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Paths_traits, Vertex_map, CGAL::Default, Face_map, Point_map>;
  Mesh tm = to_face_graph(cube());
  Vertex_map vertex_map = tm.add_property_map<vertex_descriptor, unsigned int>("v:number", 0).first;
  Face_map face_map = tm.add_property_map<face_descriptor, unsigned int>("f:number", 0).first;
  Point_map points = tm.add_property_map<vertex_descriptor, Kernel::Point_3>("v:twice", {}).first;
  unsigned int n = static_cast<unsigned int>(num_vertices(tm));
  for(const vertex_descriptor v : vertices(tm))
  {
    vertex_map[v] = --n;
    const Coordinates p = 2. * coordinates(v, tm);
    points[v] = Kernel::Point_3(p[0], p[1], p[2]);
  }
  n = static_cast<unsigned int>(num_faces(tm));
  for(const face_descriptor f : faces(tm))
  {
    face_map[f] = --n;
  }
  Diagram diagram(tm, vertex_map, get(boost::halfedge_index, tm), face_map, points);
  diagram.add_sites(std::vector<vertex_descriptor>{vertex(0), vertex(6), vertex(3)});
  CHECK_CLOSE(diagram.area(0) + diagram.area(1) + diagram.area(2), 24., 1e-12);
  for(const face_descriptor f : faces(tm))
  {
    for(const auto& a : diagram.arcs(f))
    {
      CHECK(a.face() == f);
    }
  }
  for(std::size_t i = 0; i < 3; ++i)
  {
    const auto site = diagram.site(i);
    CHECK_EQUAL(diagram.nearest_site(site), i);
  }
}

// Coordinates of type float do not add up to 1 up to the rounding of double. What a diagram returns may be asked for.
void kernels_of_float()
{
  test_support::Scope scope("kernel of float");
  using Float_kernel = CGAL::Simple_cartesian<float>;
  using Float_mesh = CGAL::Surface_mesh<Float_kernel::Point_3>;
  using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<
    CGAL::Surface_mesh_shortest_path_traits<Float_kernel, Float_mesh>>;
  using Location = Diagram::Face_location;
  Float_mesh tm;
  add_to_face_graph(noisy_sphere(1, .1, 7), tm);
  const Mesh exact = to_face_graph(noisy_sphere(1, .1, 7)); // the same faces; the same points, up to rounding
  Diagram diagram(tm);
  Voronoi expected(exact);
  test_support::Random random(3);
  const auto random_coordinates = [&]
  {
    const float a = static_cast<float>(random.uniform()) / 2, b = static_cast<float>(random.uniform()) / 2;
    return Diagram::Barycentric_coordinates{a, b, 1.f - a - b};
  };
  const auto in_double = [](const Location& l)
  { // exact up to the rounding of float
    const double a = l.second[0], b = l.second[1];
    return Face_location(l.first, {a, b, (std::max)(0., 1 - a - b)});
  };
  for(unsigned int i = 0; i < 12; ++i)
  {
    const Location l(face_descriptor(5 * i), random_coordinates());
    CHECK_EQUAL(diagram.add_site(l), expected.add_site(in_double(l)));
  }
  for(const face_descriptor f : tm.faces())
  {
    const Location l(f, random_coordinates());
    CHECK_NEAR(diagram.distance_to_nearest_site(l), expected.distance_to_nearest_site(in_double(l)), 1e-5);
  }
  for(const Diagram::Arc& a : diagram.arcs())
    CHECK_NEAR(diagram.distance_to_nearest_site(a.point(.3)), a.distance(.3), 1e-5);
  for(const Diagram::Boundary_polyline& b : diagram.boundary_polylines(0))
  {
    const CGAL::Surface_mesh_geodesics::Surface_curve<Float_mesh> curve(tm, b.locations);
    CHECK_EQUAL(curve.segments().size() + 1, b.locations.size());
  }
  CHECK(throws<CGAL::Surface_mesh_geodesics::Invalid_geodesic_input>(
    [&] { diagram.nearest_site(Location(face_descriptor(0), {.3f, .3f, .4001f})); }));
}

} // namespace

int main()
{
  a_diagram_follows_its_sites();
  former_sites_have_no_influence();
  elements_fit_together();
  handles_of_one_element_are_equal();
  absent_locations_are_rejected();
  parameters_of_arcs_are_clamped();
  invalid_input_is_rejected();
  any_thread_may_build();
  the_cell_of_an_isolated_vertex_has_no_area();
  maps_of_the_user_are_used();
  other_meshes_agree<Kernel, CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>("Polyhedron_3");
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  other_meshes_agree<Exact_kernel, CGAL::Polyhedron_3<Exact_kernel, CGAL::Polyhedron_items_with_id_3>>("exact kernel");
  kernels_of_float();
  return test_result();
}
