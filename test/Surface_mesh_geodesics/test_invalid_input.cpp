// The functions reject invalid input, with assertions and without them: they throw Invalid_geodesic_input, which names
// the element, and do not change the maps of the caller.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

using namespace test_meshes;

namespace {

using Reason = SMG::Invalid_geodesic_input::Reason;
using Options = Distance_options<Mesh>;

static_assert(std::is_base_of<std::invalid_argument, SMG::Invalid_geodesic_input>::value,
              "the exception can be caught as std::invalid_argument");

const double nan_value = std::numeric_limits<double>::quiet_NaN();
const std::size_t any_element = no_source - 1;

// Runs `call(distance map, nearest source map)`, and checks the exception and that the maps are unchanged.
template <class TriangleMesh, class Call>
void expect_rejection(const TriangleMesh& tm, Reason reason, std::size_t element, const std::string& what_is_wrong,
                    const Call& call)
{
  test_support::Scope scope(what_is_wrong);
  auto distance_map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  auto nearest_map = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
  for(const auto v : vertices(tm))
  {
    put(distance_map, v, -7.);
    put(nearest_map, v, std::size_t(77));
  }
  bool is_thrown = false;
  try
  {
    call(distance_map, nearest_map);
  }
  catch(const SMG::Invalid_geodesic_input& e)
  {
    is_thrown = true;
    if(!CHECK(e.reason() == reason))
    {
      std::cout << "  what(): " << e.what() << std::endl;
    }
    const std::string text = e.what();
    CHECK(!text.empty());
    if(element != any_element)
    {
      CHECK_EQUAL(e.element(), element);
      if(!CHECK(text.find(std::to_string(element)) != std::string::npos))
      {
        std::cout << "  what(): " << text << std::endl;
      }
    }
  }
  catch(const std::exception& e)
  {
    std::cout << "  another exception: " << e.what() << std::endl;
  }
  CHECK(is_thrown);
  for(const auto v : vertices(tm))
  {
    CHECK_EQUAL(get(distance_map, v), -7.);
    CHECK_EQUAL(get(nearest_map, v), 77u);
  }
}

template <class Sources>
void expect_rejection_of_sources(const Mesh& tm, Reason reason, std::size_t element, const std::string& what_is_wrong,
                               const Sources& sources)
{
  expect_rejection(tm, reason, element, what_is_wrong, [&](auto distance_map, auto nearest_map) {
    SMG::geodesic_distances(tm, distance_map, sources, CGAL::parameters::nearest_source_map(nearest_map));
  });
  expect_rejection(tm, reason, element, what_is_wrong + ", without parameters", [&](auto distance_map, auto) {
    SMG::geodesic_distances(tm, distance_map, sources);
  });
}

void faces_that_are_not_triangles_are_rejected()
{
  Mesh tm;
  const Indexed_mesh triangles = flat_patch(2, 2, 0., false, 1);
  for(const Coordinates& p : triangles.points)
  {
    tm.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  }
  tm.add_face(vertex(0), vertex(3), vertex(4));
  tm.add_face(vertex(0), vertex(4), vertex(1));
  tm.add_face(vertex(3), vertex(6), vertex(7), vertex(4));
  expect_rejection_of_sources(tm, Reason::NOT_A_TRIANGLE, 2, "quadrilateral", vertex(0));
  // even if no path leads there
  expect_rejection_of_sources(tm, Reason::NOT_A_TRIANGLE, 2, "quadrilateral, empty range",
                            std::vector<vertex_descriptor>());

  auto lengths = tm.add_property_map<Mesh::Edge_index, double>("e:test_length", 1.).first;
  expect_rejection(tm, Reason::NOT_A_TRIANGLE, 2, "quadrilateral with lengths", [&](auto distance_map, auto) {
    SMG::geodesic_distances_from_edge_lengths(tm, lengths, distance_map, vertex(0));
  });

  Mesh pentagon;
  for(std::size_t i = 0; i < 5; ++i)
  {
    pentagon.add_vertex(Kernel::Point_3(std::cos(static_cast<double>(i)), std::sin(static_cast<double>(i)), 0.));
  }
  pentagon.add_face(std::vector<vertex_descriptor>{vertex(0), vertex(1), vertex(2), vertex(3), vertex(4)});
  expect_rejection_of_sources(pentagon, Reason::NOT_A_TRIANGLE, 0, "pentagon", vertex(0));
}

void non_manifold_faces_are_rejected()
{
  const auto reject = [](const Mesh& tm, std::size_t element, const char* what) {
    expect_rejection_of_sources(tm, Reason::NON_MANIFOLD, element, what, vertex(0));
    auto lengths = get(CGAL::dynamic_edge_property_t<double>(), tm);
    for(const auto e : edges(tm))
    {
      put(lengths, e, 1.);
    }
    expect_rejection(tm, Reason::NON_MANIFOLD, element, what, [&](auto distance_map, auto) {
      SMG::geodesic_distances_from_edge_lengths(tm, lengths, distance_map, vertex(0));
    });
  };
  Mesh cone; // one triangle, of which two sides are glued: its third side is a loop
  const vertex_descriptor rim = cone.add_vertex(Kernel::Point_3(1., 0., 0.));
  const vertex_descriptor tip = cone.add_vertex(Kernel::Point_3(0., 0., 1.));
  const Mesh::Halfedge_index up = cone.add_edge(rim, tip), around = cone.add_edge(tip, rim), down = opposite(up, cone);
  cone.set_target(opposite(around, cone), rim);
  const Mesh::Face_index f = cone.add_face();
  for(const auto& pair : {std::make_pair(up, down), std::make_pair(down, around), std::make_pair(around, up)})
  {
    cone.set_next(pair.first, pair.second);
    cone.set_face(pair.first, f);
  }
  cone.set_next(opposite(around, cone), opposite(around, cone));
  cone.set_halfedge(f, up);
  cone.set_halfedge(rim, opposite(around, cone));
  cone.set_halfedge(tip, up);
  reject(cone, 0, "face with a vertex twice");

  Mesh torn = to_face_graph(icosphere(1));
  torn.set_target(halfedge(face(7), torn), vertex(40)); // a vertex apart from the others
  reject(torn, any_element, "two faces that disagree");
}

void points_that_are_not_finite_are_rejected()
{
  for(const double bad : {nan_value, infinity, -infinity})
  {
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      Indexed_mesh indexed = rough_terrain(4, 1., 3);
      indexed.points[13][axis] = bad;
      // A Surface_mesh with a plain Cartesian kernel does not compute anything when it is constructed.
      using Plain_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
      const Plain_mesh tm = to_face_graph<Plain_mesh>(indexed);
      expect_rejection(tm, Reason::NON_FINITE_POINT, 13, "coordinate " + std::to_string(bad),
                     [&](auto distance_map, auto) {
                       SMG::geodesic_distances(tm, distance_map, *vertices(tm).begin());
                     });
    }
  }
  // The length overflows though the coordinates are finite.
  Indexed_mesh indexed = rough_terrain(4, 1., 3);
  indexed.points[13] = {1e308, -1e308, 1e308};
  indexed.points[14] = {-1e308, 1e308, -1e308};
  const Mesh tm = to_face_graph(indexed);
  test_support::Scope scope("overflowing length");
  bool is_thrown = false;
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  try
  {
    SMG::geodesic_distances(tm, map, vertex(0));
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK(!std::isnan(get(map, v)));
    }
  }
  catch(const SMG::Invalid_geodesic_input&)
  {
    is_thrown = true;
  }
  CHECK(is_thrown);
}

void invalid_edge_lengths_are_rejected()
{
  Mesh tm = to_face_graph(icosphere(1));
  const auto lengths = add_edge_lengths(tm);
  const Mesh::Edge_index e(17);
  const double good = lengths[e];
  auto reject = [&](double value, Reason reason, const std::string& what_is_wrong, std::size_t element) {
    auto changed = lengths; // a handle to the same values
    changed[e] = value;
    expect_rejection(tm, reason, element, what_is_wrong, [&](auto distance_map, auto nearest_map) {
      SMG::geodesic_distances_from_edge_lengths(tm, changed, distance_map, vertex(0),
                                                CGAL::parameters::nearest_source_map(nearest_map));
    });
    changed[e] = good;
  };
  reject(nan_value, Reason::NON_FINITE_LENGTH, "NaN length", 17);
  reject(infinity, Reason::NON_FINITE_LENGTH, "infinite length", 17);
  reject(-infinity, Reason::NON_FINITE_LENGTH, "minus infinite length", any_element);
  reject(-good, Reason::NEGATIVE_LENGTH, "negative length", 17);
  reject(-1e-300, Reason::NEGATIVE_LENGTH, "tiny negative length", 17);
  // Both faces at the edge violate the inequality; the exception may name either.
  reject(10., Reason::TRIANGLE_INEQUALITY, "edge too long", any_element);
  reject(good * 1e-3, Reason::TRIANGLE_INEQUALITY, "edge too short", any_element);
  // exceeds equality by more than the 1.4e-14 that the reference allows
  const auto h = halfedge(e, tm);
  const double sum = lengths[edge(next(h, tm), tm)] + lengths[edge(prev(h, tm), tm)];
  for(const double excess : {1e-3, 1e-9, 1e-13})
  {
    reject(sum * (1. + excess), Reason::TRIANGLE_INEQUALITY, "just too long", any_element);
  }
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances_from_edge_lengths(tm, lengths, map, vertex(0)));
}

// In the unit of the other component their lengths would underflow; scaling makes some of them zero.
void components_that_are_too_small_are_rejected()
{
  const Indexed_mesh large = flat_patch(1, 1, 0., false, 1), small = flat_patch(3, 2, .1, false, 2);
  Mesh of_one_size = to_face_graph(side_by_side(large, small, "both"));
  const auto lengths_of_one_size = add_edge_lengths(of_one_size);
  for(const double unit : {1e-61, 1e-80, 1e-150, 1e-170, 1e-300})
  {
    test_support::Scope scope("unit " + std::to_string(std::log10(unit)));
    Mesh tm = to_face_graph(side_by_side(large, scaled(small, unit), "both"));
    const std::vector<vertex_descriptor> sources{vertex(0), vertex(large.points.size())};
    expect_rejection_of_sources(tm, Reason::TOO_SMALL, large.faces.size(), "points", sources);
    auto lengths = add_edge_lengths(tm);
    for(const auto e : edges(tm))
    {
      const bool is_small = source(halfedge(e, tm), tm).idx() >= large.points.size();
      lengths[e] = lengths_of_one_size[e] * (is_small ? unit : 1.);
    }
    expect_rejection(tm, Reason::TOO_SMALL, large.faces.size(), "lengths", [&](auto distance_map, auto nearest_map) {
      SMG::geodesic_distances_from_edge_lengths(tm, lengths, distance_map, vertex(0),
                                                CGAL::parameters::nearest_source_map(nearest_map));
    });
  }
}

// Equality up to rounding gives a face without area, which is allowed.
void a_degenerate_triangle_is_allowed()
{
  Mesh tm = to_face_graph(irregular_tetrahedron());
  auto lengths = tm.add_property_map<Mesh::Edge_index, double>("e:test_length", .3).first;
  for(const double factor : {1., 1. + 2e-16, 1. - 2e-16, 1. + 1e-15})
  {
    // vertices 0, 1, 2, 3 on a line at 0, .1, .3, .7: all faces have area zero
    const double position[4] = {0., .1, .3, .7};
    for(const auto e : edges(tm))
    {
      const auto h = halfedge(e, tm);
      lengths[e] =
        std::abs(position[std::size_t(source(h, tm))] - position[std::size_t(target(h, tm))]);
      if(lengths[e] > .5)
      {
        lengths[e] *= factor;
      }
    }
    const std::vector<double> result = distances_from_edge_lengths(tm, lengths, vertex(0));
    for(std::size_t i = 0; i < 4; ++i)
    {
      CHECK_CLOSE(result[i], position[i], 1e-14);
    }
  }
}

void locations_outside_their_face_are_rejected()
{
  const Mesh tm = to_face_graph(icosphere(1));
  const std::vector<std::array<double, 3>> bad_weights{{1.5, -.25, -.25},
                                                       {-.1, .6, .5},
                                                       {.5, -1e-3, .501},
                                                       {.5, -1e-8, .5 + 1e-8},
                                                       {.5, .25, .25 + 1e-8},
                                                       {.5, .5, .5},
                                                       {0., 0., 0.},
                                                       {.3, .3, .3},
                                                       {1., 1., 0.},
                                                       {-1., 1., 1.},
                                                       {nan_value, .5, .5},
                                                       {.5, nan_value, .5},
                                                       {.5, .5, nan_value},
                                                       {infinity, 0., 0.},
                                                       {infinity, -infinity, 1.}};
  std::size_t i = 0;
  for(const std::array<double, 3>& weights : bad_weights)
  {
    const std::string name = "weights " + std::to_string(i++);
    const Face_location bad(face(5), weights);
    expect_rejection_of_sources(tm, Reason::INVALID_LOCATION, any_element, name, bad);
    // The exception names the invalid location, the third in the range.
    const Face_location good(face(6), {.2, .3, .5});
    expect_rejection_of_sources(tm, Reason::INVALID_LOCATION, 2, name + ", in a range",
                              std::vector<Face_location>{good, good, bad, good});
  }
}

// The tolerances of the reference: coordinates may miss their face by 9.3e-10, and count as zero up to 1.4e-14.
void rounded_locations_are_allowed()
{
  const Mesh tm = to_face_graph(icosphere(1));
  for(const double error : {1e-10, -1e-10})
  {
    CHECK_EQUAL(distances(tm, Face_location(face(5), {.5, .5, error})).size(), num_vertices(tm));
    CHECK_EQUAL(distances(tm, Face_location(face(5), {.5, .25, .25 + error})).size(), num_vertices(tm));
  }
  const vertex_descriptor corner = corners_of_face(face(5), tm)[0];
  const auto distance_of_corner = [&](double x)
  { return distances(tm, Face_location(face(5), {1. - x, x, 0.}))[std::size_t(corner)]; };
  CHECK_EQUAL(distance_of_corner(1e-14), 0.);
  CHECK(distance_of_corner(1e-13) > 0.);
}

void null_and_foreign_descriptors_are_rejected()
{
  const Mesh tm = to_face_graph(icosphere(1));
  const face_descriptor null_face = boost::graph_traits<Mesh>::null_face();
  const vertex_descriptor null_vertex = boost::graph_traits<Mesh>::null_vertex();
  const std::size_t n = num_vertices(tm);
  const std::size_t m = num_faces(tm);

  expect_rejection_of_sources(tm, Reason::INVALID_DESCRIPTOR, any_element, "null vertex", null_vertex);
  expect_rejection_of_sources(tm, Reason::INVALID_DESCRIPTOR, 1, "null vertex in a range",
                            std::vector<vertex_descriptor>{vertex(0), null_vertex});
  expect_rejection_of_sources(tm, Reason::INVALID_DESCRIPTOR, any_element, "vertex of a larger mesh", vertex(n));
  expect_rejection_of_sources(tm, Reason::INVALID_DESCRIPTOR, 2, "vertex of a larger mesh in a range",
                            std::vector<vertex_descriptor>{vertex(0), vertex(1), vertex(n + 1000)});
  expect_rejection_of_sources(tm, Reason::INVALID_LOCATION, 0, "null face",
                            Face_location(null_face, {.2, .3, .5}));
  expect_rejection_of_sources(tm, Reason::INVALID_DESCRIPTOR, any_element, "face of a larger mesh",
                            Face_location(face(m), {.2, .3, .5}));
  expect_rejection_of_sources(tm, Reason::INVALID_DESCRIPTOR, any_element, "face of a larger mesh, a vertex of it",
                            Face_location(face(m + 10000), {1., 0., 0.}));

  for(const vertex_descriptor bad : {null_vertex, vertex(n), vertex(n + 100000)})
  {
    expect_rejection(tm, Reason::INVALID_DESCRIPTOR, any_element, "bad target", [&](auto distance_map, auto) {
      Options options;
      options.targets = {vertex(0), bad};
      SMG::geodesic_distances(tm, distance_map, vertex(0), parameters_of(options));
    });
  }

  Mesh with_removed = to_face_graph(flat_patch(4, 4, 0., false, 1));
  CGAL::Euler::remove_face(halfedge(face(0), with_removed), with_removed);
  CGAL::Euler::remove_face(halfedge(face(1), with_removed), with_removed);
  CHECK(with_removed.is_removed(face(0)));
  expect_rejection_of_sources(with_removed, Reason::INVALID_DESCRIPTOR, any_element, "removed face",
                            Face_location(face(0), {.2, .3, .5}));
  for(std::size_t i = 0; i < 25; ++i)
  {
    if(with_removed.is_removed(vertex(i)))
    {
      expect_rejection_of_sources(with_removed, Reason::INVALID_DESCRIPTOR, any_element, "removed vertex", vertex(i));
    }
  }
}

void invalid_offsets_are_rejected()
{
  const Mesh tm = to_face_graph(icosphere(1));
  const std::vector<vertex_descriptor> sources{vertex(0), vertex(3), vertex(7)};
  auto reject = [&](const std::vector<double>& offsets, std::size_t element, const std::string& what_is_wrong) {
    expect_rejection(tm, Reason::INVALID_OFFSET, element, what_is_wrong, [&](auto distance_map, auto nearest_map) {
      auto options = options_with_map<Mesh>(nearest_map);
      options.source_offsets = offsets;
      SMG::geodesic_distances(tm, distance_map, sources, parameters_of(options));
    });
  };
  reject({0., 1., -1.}, 2, "negative offset");
  reject({0., -1e-300, 1.}, 1, "tiny negative offset");
  reject({nan_value, 1., 1.}, 0, "NaN offset");
  reject({0., infinity, 1.}, 1, "infinite offset");
  reject({0., -infinity, 1.}, 1, "minus infinite offset");
  reject({0., 1e13, 1.}, 1, "offset beside which the mesh vanishes");
  reject({0., 1.}, any_element, "too few offsets");
  reject({0., 1., 2., 3.}, any_element, "too many offsets");
  const Mesh tiny = to_face_graph(scaled(icosphere(1), 1e-100));
  expect_rejection(tiny, Reason::INVALID_OFFSET, 1, "offset that is infinite in the unit of the mesh",
                 [&](auto distance_map, auto) {
    Options options;
    options.source_offsets = {0., 1e300, 1.};
    SMG::geodesic_distances(tiny, distance_map, sources, parameters_of(options));
  });
  expect_rejection(tm, Reason::INVALID_OFFSET, any_element, "offset of an empty range", [&](auto distance_map, auto) {
    Options options;
    options.source_offsets = {1.};
    SMG::geodesic_distances(tm, distance_map, std::vector<vertex_descriptor>(), parameters_of(options));
  });
}

// A large offset that is valid costs digits, but not time.
void large_offsets_cost_digits_only()
{
  const Mesh tm = to_face_graph(icosphere(2));
  Distance_options<Mesh> options;
  options.source_offsets = {1e11};
  const std::vector<vertex_descriptor> source{vertex_descriptor(0)};
  SMG::Propagation_statistics statistics;
  options.statistics = &statistics;
  const std::vector<double> with = distances_with_options(tm, source, options);
  const std::size_t windows = statistics.windows_propagated;
  options.source_offsets.clear();
  const std::vector<double> without = distances_with_options(tm, source, options);
  for(std::size_t v = 0; v < without.size(); ++v)
    CHECK(std::abs(with[v] - 1e11 - without[v]) <= 1e-3);
  CHECK(windows <= 2 * statistics.windows_propagated);
}

void invalid_radii_are_rejected()
{
  const Mesh tm = to_face_graph(icosphere(1));
  for(const double radius : {-1., -1e-300, -infinity, nan_value})
  {
    expect_rejection(tm, Reason::INVALID_RADIUS, any_element, "radius " + std::to_string(radius),
                   [&](auto distance_map, auto nearest_map) {
                     auto options = options_with_map<Mesh>(nearest_map);
                     options.maximum_distance = radius;
                     SMG::geodesic_distances(tm, distance_map, vertex(0), parameters_of(options));
                   });
  }
}

// With assertions, CGAL checks index maps before the package sees them.
#ifdef NDEBUG
void index_maps_must_number_from_zero()
{
  Mesh tm = to_face_graph(icosphere(1));
  auto vertex_indices = tm.add_property_map<Mesh::Vertex_index, std::size_t>("v:test_index", 0).first;
  auto face_indices = tm.add_property_map<Mesh::Face_index, std::size_t>("f:test_index", 0).first;
  auto reset = [&]() {
    for(const auto v : vertices(tm))
    {
      vertex_indices[v] = std::size_t(v);
    }
    for(const auto f : faces(tm))
    {
      face_indices[f] = std::size_t(f);
    }
  };
  const Face_location location(face(3), {.2, .3, .5});
  auto reject = [&](const std::string& what_is_wrong) {
    expect_rejection(tm, Reason::INVALID_INDEX_MAP, any_element, what_is_wrong, [&](auto distance_map, auto) {
      SMG::geodesic_distances(tm, distance_map, location,
                              CGAL::parameters::vertex_index_map(vertex_indices).face_index_map(face_indices));
    });
  };
  for(const std::size_t bad : {static_cast<std::size_t>(num_vertices(tm)), std::size_t(1) << 40,
                               (std::numeric_limits<std::size_t>::max)()})
  {
    reset();
    vertex_indices[vertex(11)] = bad;
    reject("vertex index " + std::to_string(bad));
  }
  reset();
  vertex_indices[vertex(11)] = 12;
  reject("vertex index given twice");
  {
    Mesh torn = to_face_graph(icosphere(1));
    torn.remove_vertex(vertex(11)); // its faces remain
    expect_rejection(torn, Reason::INVALID_INDEX_MAP, any_element, "face with a vertex that is not in the mesh",
                   [&](auto distance_map, auto) { SMG::geodesic_distances(torn, distance_map, vertex(0)); });
  }
  reset();
  face_indices[face(11)] = num_faces(tm) + 5;
  reject("face index too large");
  reset();
  face_indices[face(11)] = 12;
  reject("face index given twice");
  reset();
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances(tm, map, location,
                                CGAL::parameters::vertex_index_map(vertex_indices).face_index_map(face_indices)));
}
#endif

void catching_the_base_class_works()
{
  const Mesh tm = to_face_graph(icosphere(1));
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  bool is_caught = false;
  try
  {
    SMG::geodesic_distances(tm, map, Face_location(face(5), {2., -1., 0.}));
  }
  catch(const std::invalid_argument& e)
  {
    is_caught = std::string(e.what()).size() > 10;
  }
  CHECK(is_caught);
}

} // namespace

int main()
{
  faces_that_are_not_triangles_are_rejected();
  non_manifold_faces_are_rejected();
  points_that_are_not_finite_are_rejected();
  invalid_edge_lengths_are_rejected();
  components_that_are_too_small_are_rejected();
  a_degenerate_triangle_is_allowed();
  locations_outside_their_face_are_rejected();
  rounded_locations_are_allowed();
  null_and_foreign_descriptors_are_rejected();
  invalid_offsets_are_rejected();
  large_offsets_cost_digits_only();
  invalid_radii_are_rejected();
#ifdef NDEBUG
  index_maps_must_number_from_zero();
#endif
  catching_the_base_class_works();
  return test_result();
}
