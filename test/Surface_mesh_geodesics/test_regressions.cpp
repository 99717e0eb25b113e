// Small meshes on which other programs were wrong or crashed, with the right answers.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

// The expected distances below have ten digits.
const double written = 1e-10;
const double tolerance = 1e-12;

// The query point a is not a vertex, so it is the source: distances are symmetric.
double distance_between(const Face_location& a, std::size_t b, const Mesh& tm)
{
  return distances(tm, a)[b];
}

std::vector<double> Euclidean_field(const Mesh& tm, const Coordinates& p)
{
  std::vector<double> result;
  for(const vertex_descriptor v : vertices(tm))
  {
    result.push_back(length(coordinates(v, tm) - p));
  }
  return result;
}

void sources_on_edges_of_a_square_have_exact_distances()
{
  test_support::Scope scope("two_tri_square");
  const Mesh tm = load_data("two_tri_square");
  for(const Face_location& s : on_edge(0, 1, .5, tm))
  {
    CHECK_FIELDS_CLOSE(distances(tm, s), (std::vector<double>{.5, .5, 1.1180339887498949, 1.1180339887498949}),
                       tolerance);
  }
  for(const Face_location& s : on_edge(0, 1, .25, tm))
  {
    CHECK_FIELDS_CLOSE(distances(tm, s), (std::vector<double>{.25, .75, 1.25, std::sqrt(1.0625)}), tolerance);
  }
  for(const double t : {.25, .75})
  {
    const Coordinates p{t, t, 0.};
    CHECK_EQUAL(on_edge(0, 2, t, tm).size(), 2u);
    for(const Face_location& s : on_edge(0, 2, t, tm))
    {
      CHECK_FIELDS_CLOSE(distances(tm, s), Euclidean_field(tm, p), tolerance);
    }
  }
  // two points of one edge are sources; each vertex belongs to the nearer one
  for(const Face_location& first : on_edge(0, 2, .25, tm))
  {
    for(const Face_location& second : on_edge(0, 2, .75, tm))
    {
      const std::vector<double> result = distances(tm, std::vector<Face_location>{first, second});
      CHECK_FIELDS_CLOSE(result, (std::vector<double>{.25 * std::sqrt(2.), std::sqrt(.625), .25 * std::sqrt(2.),
                                                      std::sqrt(.625)}),
                         tolerance);
    }
  }
  {
    const Face_location first = on_edge(0, 1, .25, tm).front();
    const Face_location second = on_edge(0, 1, .75, tm).front();
    CHECK_FIELDS_CLOSE(distances(tm, std::vector<Face_location>{first, second}),
                       (std::vector<double>{.25, .25, std::sqrt(1.0625), std::sqrt(1.0625)}), tolerance);
  }
}

void sources_inside_a_face_have_exact_distances()
{
  test_support::Scope scope("two_tri_square_b");
  const Mesh tm = load_data("two_tri_square_b");
  CHECK_CLOSE(distance_between(location_in_plane(0, .5, tm), 1, tm), .5, tolerance);
  CHECK_CLOSE(distance_between(location_in_plane(0, .25, tm), 1, tm), .75, tolerance);
  CHECK_FIELDS_CLOSE(distances(tm, std::vector<vertex_descriptor>{vertex(0), vertex(1)}),
                     (std::vector<double>{0, 0, 1, 1}), tolerance);

  // Two sources strictly inside one face. The query point becomes a vertex.
  const Indexed_mesh indexed = to_indexed_mesh(tm, "two_tri_square_b");
  const Face_location query = location_in_plane(.625, .5, tm);
  const auto corners = corners_of_face(query.first, tm);
  Indexed_mesh split = indexed;
  for(std::size_t f = 0; f < indexed.faces.size(); ++f)
  {
    const Triangle& t = indexed.faces[f];
    std::array<double, 3> weights{};
    bool is_the_face = true;
    for(std::size_t k = 0; k < 3; ++k)
    {
      bool found = false;
      for(std::size_t l = 0; l < 3; ++l)
      {
        if(std::size_t(corners[l]) == t[k])
        {
          weights[k] = query.second[l];
          found = true;
        }
      }
      is_the_face = is_the_face && found;
    }
    if(is_the_face)
    {
      split = with_point_in_face(indexed, f, weights);
    }
  }
  const Mesh split_tm = to_face_graph(split);
  auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), split_tm);
  const std::vector<Face_location> sources{location_in_plane(.75, .125, split_tm),
                                           location_in_plane(.625, .125, split_tm)};
  const std::vector<double> result =
    distances_with_options(split_tm, sources, options_with_map<Mesh>(nearest));
  CHECK_CLOSE(result.back(), .375, tolerance);
  CHECK_EQUAL(get(nearest, vertex(result.size() - 1)), 1u);
}

void distances_in_a_triangle_are_Euclidean()
{
  test_support::Scope scope("single_triangle");
  const Mesh tm = load_data("single_triangle");
  CHECK_FIELDS_CLOSE(distances(tm, on_edge(0, 1, .25, tm).front()),
                     (std::vector<double>{.75, 2.25, std::sqrt(16.5625)}), tolerance);
  CHECK_FIELDS_CLOSE(distances(tm, vertex(0)), (std::vector<double>{0, 3, 4}), tolerance);
  CHECK_FIELDS_CLOSE(distances(tm, vertex(1)), (std::vector<double>{3, 0, 5}), tolerance);
  CHECK_FIELDS_CLOSE(distances(tm, Face_location(face(0), {1. / 3., 1. / 3., 1. / 3.})),
                     Euclidean_field(tm, {1., 4. / 3., 0.}), tolerance);
}

void grids_are_Euclidean()
{
  for(std::size_t n = 4; n <= 9; ++n)
  {
    const std::string name = "grid" + std::to_string(n);
    test_support::Scope scope(name);
    const Mesh tm = load_data(name);
    CHECK_EQUAL(num_vertices(tm), n * n);
    for(const vertex_descriptor v : vertices(tm))
    {
      const std::vector<double> expected = Euclidean_field(tm, coordinates(v, tm));
      const std::vector<double> result = distances(tm, v);
      CHECK_FIELDS_CLOSE(result, expected, tolerance);
      CHECK_EQUAL(result[std::size_t(v)], 0.);
      for(const face_descriptor f : faces_around(v, tm))
      {
        CHECK(distances(tm, location_of_vertex(v, f, tm)) == result);
      }
    }
    // the corner (0, 1, 0) given as a point
    const std::vector<double> from_point = distances(tm, location_in_plane(0., 1., tm));
    CHECK_EQUAL(from_point[n - 1], 0.);
    CHECK_FIELDS_CLOSE(from_point, distances(tm, vertex(n - 1)), tolerance);
  }
}

void noise_at_a_corner_changes_no_distance()
{
  test_support::Scope scope("grid5, noise");
  const Mesh tm = load_data("grid5");
  const face_descriptor f = face(6);
  const auto corners = corners_of_face(f, tm);
  CHECK(std::size_t(corners[0]) + std::size_t(corners[1]) + std::size_t(corners[2]) == 3 + 4 + 9);
  for(std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t v = std::size_t(corners[k]);
    const std::vector<double> expected = Euclidean_field(tm, coordinates(corners[k], tm));
    for(const Face_location& location : noisy_locations_of_vertex(corners[k], f, tm))
    {
      const std::vector<double> result = distances(tm, location);
      CHECK(result[v] < 1e-12);
      for(std::size_t i = 0; i < result.size(); ++i)
      {
        CHECK_NEAR(result[i], expected[i], 1e-12);
      }
    }
  }
}

void unreachable_vertices_are_at_infinity()
{
  {
    test_support::Scope scope("isolated_vertex");
    const Mesh tm = load_data("isolated_vertex");
    CHECK_EQUAL(num_vertices(tm), 5u);
    CHECK_FIELDS_CLOSE(distances(tm, vertex(0)), (std::vector<double>{0, 1, std::sqrt(2.), 1, infinity}), tolerance);
    CHECK_FIELDS_CLOSE(distances(tm, vertex(4)),
                       (std::vector<double>{infinity, infinity, infinity, infinity, 0}), tolerance);
    CHECK_FIELDS_CLOSE(distances(tm, std::vector<vertex_descriptor>{vertex(4), vertex(1)}),
                       (std::vector<double>{1, 0, 1, std::sqrt(2.), 0}), tolerance);
  }
  {
    test_support::Scope scope("two_components");
    const Mesh tm = load_data("two_components");
    CHECK_FIELDS_CLOSE(distances(tm, vertex(0)), (std::vector<double>{0, 1, 1, infinity, infinity, infinity}),
                       tolerance);
    CHECK_FIELDS_CLOSE(distances(tm, std::vector<vertex_descriptor>{vertex(0), vertex(3)}),
                       (std::vector<double>{0, 1, 1, 0, 1, 1}), tolerance);
  }
}

void flat_meshes_of_the_heat_method_have_exact_distances()
{
  {
    test_support::Scope scope("kite_pp3d30");
    const Mesh tm = load_data("kite_pp3d30");
    CHECK_FIELDS_CLOSE(distances(tm, vertex(2)), (std::vector<double>{2, std::sqrt(10.), 0, std::sqrt(10.)}),
                       tolerance);
  }
  {
    test_support::Scope scope("square100_gc111");
    const Mesh tm = load_data("square100_gc111");
    CHECK_FIELDS_CLOSE(distances(tm, vertex(0)), (std::vector<double>{0, 100, 100. * std::sqrt(2.), 100}), tolerance);
  }
}

void needle_without_area_does_no_harm()
{
  const double r2 = std::sqrt(2.);
  test_support::Scope scope("needle_dup_position");
  const Mesh tm = load_data("needle_dup_position");
  CHECK_FIELDS_CLOSE(distances(tm, vertex(0)), (std::vector<double>{0, 1, r2, 1, 1, 2, std::sqrt(5.)}), tolerance);
  for(const vertex_descriptor v : vertices(tm))
  {
    test_support::Scope source_scope("source " + std::to_string(std::size_t(v)));
    const std::vector<double> expected = Euclidean_field(tm, coordinates(v, tm));
    CHECK_FIELDS_CLOSE(distances(tm, v), expected, tolerance);
    for(const face_descriptor f : faces_around(v, tm))
    {
      CHECK_FIELDS_CLOSE(distances(tm, location_of_vertex(v, f, tm)), expected, tolerance);
    }
  }
  // inside the needle, which is the segment from vertex 1 to vertex 2
  CHECK_FIELDS_CLOSE(distances(tm, Face_location(face(2), {.25, .25, .5})),
                     Euclidean_field(tm, coordinates(Face_location(face(2), {.25, .25, .5}), tm)), tolerance);
  for(const double t : {.25, .5})
  {
    for(const Face_location& s : on_edge(1, 4, t, tm))
    {
      CHECK_FIELDS_CLOSE(distances(tm, s), Euclidean_field(tm, {1., 0., 0.}), tolerance);
    }
    for(const Face_location& s : on_edge(1, 2, t, tm))
    {
      CHECK_FIELDS_CLOSE(distances(tm, s), Euclidean_field(tm, {1., t, 0.}), tolerance);
    }
  }
}

void cap_without_area_does_no_harm()
{
  const double r2 = std::sqrt(2.);
  test_support::Scope scope("cap_zero_area");
  const Mesh tm = load_data("cap_zero_area");
  CHECK_FIELDS_CLOSE(distances(tm, vertex(3)), (std::vector<double>{r2, r2, 1, 0, 2}), tolerance);
  for(const vertex_descriptor v : vertices(tm))
  {
    test_support::Scope source_scope("source " + std::to_string(std::size_t(v)));
    CHECK_FIELDS_CLOSE(distances(tm, v), Euclidean_field(tm, coordinates(v, tm)), tolerance);
  }
  for(const double t : {.25, .5, .75})
  {
    test_support::Scope source_scope("long edge at " + std::to_string(t));
    for(const Face_location& s : on_edge(0, 1, t, tm))
    {
      CHECK_FIELDS_CLOSE(distances(tm, s), Euclidean_field(tm, {2. * t, 0., 0.}), tolerance);
    }
    for(const Face_location& s : on_edge(0, 2, t, tm))
    {
      CHECK_FIELDS_CLOSE(distances(tm, s), Euclidean_field(tm, {t, 0., 0.}), tolerance);
    }
  }
  // inside the cap
  const Face_location inside(face(1), {.25, .25, .5});
  CHECK_FIELDS_CLOSE(distances(tm, inside), Euclidean_field(tm, coordinates(inside, tm)), tolerance);
}

void thin_sliver_does_no_harm()
{
  const double r2 = std::sqrt(2.);
  test_support::Scope scope("sliver_1e-12");
  const Mesh tm = load_data("sliver_1e-12");
  CHECK_FIELDS_CLOSE(distances(tm, vertex(3)), (std::vector<double>{r2, r2, 1. + 1e-12, 0, 2}), 1e-12);
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_FIELDS_CLOSE(distances(tm, v), Euclidean_field(tm, coordinates(v, tm)), 1e-12);
  }
}

void scale_and_position_do_not_matter()
{
  struct Entry
  {
    const char* name;
    double size;
    double relative;
  };
  for(const Entry& entry : {Entry{"grid5_tiny_1e-9", 1e-9, 1e-12}, Entry{"grid5_huge_1e9", 1e9, 1e-12},
                            Entry{"grid5_offset_1e6", 1., 1e-9}})
  {
    test_support::Scope scope(entry.name);
    const Mesh tm = load_data(entry.name);
    const std::vector<double> result = distances(tm, vertex(0));
    CHECK_CLOSE(result[4], entry.size, entry.relative);
    CHECK_CLOSE(result[24], entry.size * std::sqrt(2.), entry.relative);
    CHECK_CLOSE(result[12], entry.size / std::sqrt(2.), entry.relative);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_FIELDS_CLOSE(distances(tm, v), Euclidean_field(tm, coordinates(v, tm)), entry.relative);
    }
  }
}

void distances_on_polyhedra_are_exact()
{
  const double r2 = std::sqrt(2.);
  {
    test_support::Scope scope("cube");
    Mesh tm = load_data("cube");
    CHECK_FIELDS_CLOSE(distances(tm, vertex(0)), (std::vector<double>{0, 1, 1, r2, 1, r2, r2, std::sqrt(5.)}),
                       tolerance);
    // from the center of a face, which lies on a diagonal, to the opposite center
    const Indexed_mesh split = with_point_on_edge(to_indexed_mesh(tm, "cube"), 1, 7, .5);
    const Mesh split_tm = to_face_graph(split);
    CHECK_EQUAL(split.points.size(), 9u);
    CHECK_CLOSE(split.points.back()[2], 1., 1e-15);
    for(const Face_location& s : on_edge(0, 6, .5, split_tm))
    {
      CHECK_CLOSE(distances(split_tm, s).back(), 2., tolerance);
    }
  }
  {
    test_support::Scope scope("tetra");
    const Mesh tm = load_data("tetra");
    const double d = std::sqrt(8. / 3.);
    CHECK_FIELDS_CLOSE(distances(tm, Face_location(face(0), {1. / 3., 1. / 3., 1. / 3.})),
                       (std::vector<double>{d, d, d, 2. * d}), tolerance);
    CHECK_CLOSE(d, 1.6329931619, written);
  }
  {
    test_support::Scope scope("octahedron");
    const Mesh tm = load_data("octahedron");
    const std::vector<double> single = distances(tm, vertex(0));
    CHECK_CLOSE(single[1], std::sqrt(6.), tolerance);
    CHECK(distances(tm, std::vector<vertex_descriptor>{vertex(0), vertex(0)}) == single);
    std::vector<Face_location> same{location_of_vertex(vertex(0), face(0), tm)};
    for(const face_descriptor f : faces_around(vertex(0), tm))
    {
      same.push_back(location_of_vertex(vertex(0), f, tm));
    }
    auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
    CHECK(distances_with_options(tm, same, options_with_map<Mesh>(nearest)) == single);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK(get(nearest, v) < same.size());
    }
    CHECK_FIELDS_CLOSE(distances(tm, std::vector<vertex_descriptor>{vertex(0), vertex(2), vertex(4)}),
                       (std::vector<double>{0, r2, 0, r2, 0, r2}), tolerance);
  }
}

void paths_bend_at_a_reflex_border_vertex()
{
  const double r2 = std::sqrt(2.);
  test_support::Scope scope("L_shape");
  const Mesh tm = load_data("L_shape");
  CHECK_FIELDS_CLOSE(distances(tm, vertex(7)),
                     (std::vector<double>{std::sqrt(5.), 2, 1. + r2, r2, 1, 2, 1, 0}), tolerance);
}

void vertices_of_a_strip_know_their_nearest_source()
{
  const double r2 = std::sqrt(2.);
  test_support::Scope scope("strip4");
  const Mesh tm = load_data("strip4");
  const std::vector<vertex_descriptor> sources{vertex(0), vertex(8)};
  auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
  const std::vector<double> result =
    distances_with_options(tm, sources, options_with_map<Mesh>(nearest));
  CHECK_FIELDS_CLOSE(result, (std::vector<double>{0, 1, 1, r2, 2, std::sqrt(5.), 1, r2, 0, 1}), tolerance);
  for(std::size_t v = 0; v < 10; ++v)
  {
    if(v / 2 != 2)
    {
      CHECK_EQUAL(get(nearest, vertex(v)), v < 4 ? 0u : 1u);
    }
    else
    {
      CHECK(get(nearest, vertex(v)) < 2);
    }
  }
}

void distances_around_saddle_and_cone_are_exact()
{
  const double r2 = std::sqrt(2.);
  {
    test_support::Scope scope("saddle_fan8");
    const Mesh tm = load_data("saddle_fan8");
    std::vector<double> expected(9, 2.);
    expected[0] = 1.;
    expected[1] = 0.;
    expected[2] = expected[8] = 1.6645969834;
    CHECK_FIELDS_CLOSE(distances(tm, vertex(1)), expected, written);
  }
  {
    test_support::Scope scope("cone64");
    const Mesh tm = load_data("cone64");
    const std::vector<double> result = distances(tm, vertex(1));
    CHECK_CLOSE(result[0], r2, tolerance);
    const double sector = 2. * std::asin(std::sin(pi / 64.) / r2);
    for(std::size_t i = 0; i < 64; ++i)
    {
      const double angle = sector * static_cast<double>((std::min)(i, 64 - i));
      CHECK_CLOSE(result[1 + i], 2. * r2 * std::sin(.5 * angle), tolerance);
    }
    CHECK_CLOSE(result[2], .0981353487, 1e-9); // nine digits
    CHECK_CLOSE(result[17], 1.4910187756, written);
    CHECK_CLOSE(result[33], 2.5340439855, written);
  }
}

void paths_pass_a_pinched_vertex()
{
  const double r2 = std::sqrt(2.);
  test_support::Scope scope("pinched_vertex");
  // Paths may pass a vertex in which two parts of the surface meet.
  const Mesh tm = load_data("pinched_vertex");
  CHECK_FIELDS_CLOSE(distances(tm, vertex(2)), (std::vector<double>{r2, 1, 0, 1. + r2, 2. * r2}), tolerance);
  CHECK_FIELDS_CLOSE(distances(tm, vertex(0)), (std::vector<double>{0, 1, r2, 1, r2}), tolerance);
}

// The reader or an exception must reject an invalid mesh.
void broken_files_are_rejected()
{
  for(const std::string name : {"edge_three_faces", "index_out_of_range"})
  {
    test_support::Scope scope(name);
    bool is_rejected = false;
    try
    {
      Mesh tm;
      if(!read_data(name, tm))
      {
        is_rejected = true;
      }
      else if(num_vertices(tm) > 0)
      {
        // A reader may also skip the bad face; then the distances must be valid.
        for(const double d : distances(tm, vertex(0)))
        {
          CHECK(d >= 0.);
        }
      }
    }
    catch(const std::exception&)
    {
      is_rejected = true;
    }
    CHECK(is_rejected);
  }
}

} // namespace

int main()
{
  sources_on_edges_of_a_square_have_exact_distances();
  sources_inside_a_face_have_exact_distances();
  distances_in_a_triangle_are_Euclidean();
  grids_are_Euclidean();
  noise_at_a_corner_changes_no_distance();
  unreachable_vertices_are_at_infinity();
  flat_meshes_of_the_heat_method_have_exact_distances();
  needle_without_area_does_no_harm();
  cap_without_area_does_no_harm();
  thin_sliver_does_no_harm();
  scale_and_position_do_not_matter();
  distances_on_polyhedra_are_exact();
  paths_bend_at_a_reflex_border_vertex();
  vertices_of_a_strip_know_their_nearest_source();
  distances_around_saddle_and_cone_are_exact();
  paths_pass_a_pinched_vertex();
  broken_files_are_rejected();
  return test_result();
}
