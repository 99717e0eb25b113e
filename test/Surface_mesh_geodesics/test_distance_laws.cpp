// Laws that distances obey on every mesh, and independence of numbering, scale, order of the sources and type of the
// mesh.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;

double largest_finite(const std::vector<double>& field)
{
  double result = 0.;
  for(const double d : field)
  {
    if(d != infinity)
    {
      result = (std::max)(result, d);
    }
  }
  return result;
}

// The laws of a metric, on all pairs of a few vertices.
void distances_form_a_metric(const Mesh& tm, test_support::Random& random)
{
  std::vector<vertex_descriptor> sample;
  for(std::size_t i = 0; i < 12; ++i)
  {
    sample.push_back(random_vertex(tm, random));
  }
  std::vector<std::vector<double>> fields;
  for(const vertex_descriptor v : sample)
  {
    fields.push_back(distances(tm, v));
    CHECK_EQUAL(fields.back()[std::size_t(v)], 0.);
  }
  for(std::size_t a = 0; a < sample.size(); ++a)
  {
    for(std::size_t b = 0; b < sample.size(); ++b)
    {
      const double ab = fields[a][std::size_t(sample[b])];
      CHECK_CLOSE(ab, fields[b][std::size_t(sample[a])], tolerance);
      CHECK((ab == 0.) == (sample[a] == sample[b]));
      for(std::size_t i = 0; i < fields[a].size(); ++i)
      {
        const double through = ab + fields[b][i];
        if(!(fields[a][i] <= through * (1. + tolerance)))
        {
          CHECK(fields[a][i] <= through * (1. + tolerance));
        }
      }
    }
  }
}

// On an edge the distance changes by at most the length of the edge.
void distances_are_1_Lipschitz_along_edges(const Mesh& tm, test_support::Random& random)
{
  for(std::size_t i = 0; i < 4; ++i)
  {
    const std::vector<double> field =
      i % 2 == 0 ? distances(tm, random_vertex(tm, random)) : distances(tm, random_location(tm, random));
    for(const auto e : edges(tm))
    {
      const vertex_descriptor a = source(halfedge(e, tm), tm);
      const vertex_descriptor b = target(halfedge(e, tm), tm);
      const double da = field[std::size_t(a)];
      const double db = field[std::size_t(b)];
      if(da == infinity || db == infinity)
      {
        CHECK_EQUAL(da, db);
        continue;
      }
      const double edge = length(coordinates(a, tm) - coordinates(b, tm));
      CHECK(std::abs(da - db) <= edge + tolerance * (std::max)(da, db));
    }
  }
}

// No distance on the surface is shorter than the straight line.
void distances_are_at_least_Euclidean(const Mesh& tm, test_support::Random& random)
{
  for(std::size_t i = 0; i < 3; ++i)
  {
    const vertex_descriptor s = random_vertex(tm, random);
    const std::vector<double> field = distances(tm, s);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK(field[std::size_t(v)] >= length(coordinates(s, tm) - coordinates(v, tm)) * (1. - tolerance));
    }
  }
}

void subdivision_changes_no_distance(const Indexed_mesh& indexed, test_support::Random& random)
{
  const Mesh tm = to_face_graph(indexed);
  std::vector<Mesh> finer;
  finer.push_back(to_face_graph(midpoint_subdivision(indexed)));
  if(indexed.faces.size() < 150)
  {
    finer.push_back(to_face_graph(midpoint_subdivision(indexed, 2)));
  }
  for(std::size_t i = 0; i < 3; ++i)
  {
    const vertex_descriptor s = random_vertex(tm, random);
    const std::vector<double> expected = distances(tm, s);
    for(const Mesh& fine : finer)
    {
      std::vector<double> result = distances(fine, s);
      result.resize(expected.size());
      CHECK_FIELDS_CLOSE(result, expected, tolerance);
    }
  }
}

void permutation_changes_no_distance(const Indexed_mesh& indexed, test_support::Random& random)
{
  const Mesh tm = to_face_graph(indexed);
  for(std::size_t i = 0; i < 3; ++i)
  {
    std::vector<std::size_t> new_index;
    const Mesh other = to_face_graph(permuted(indexed, random, new_index));
    const std::size_t a = std::size_t(random_vertex(tm, random));
    const std::size_t b = std::size_t(random_vertex(tm, random));
    const std::vector<double> expected = distances(tm, std::vector<vertex_descriptor>{vertex(a), vertex(b)});
    const std::vector<double> result =
      distances(other, std::vector<vertex_descriptor>{vertex(new_index[a]), vertex(new_index[b])});
    std::vector<double> back(expected.size());
    for(std::size_t v = 0; v < back.size(); ++v)
    {
      back[v] = result[new_index[v]];
    }
    CHECK_FIELDS_CLOSE(back, expected, tolerance);
  }
}

void scaling_by_a_power_of_two_is_exact(const Indexed_mesh& indexed, test_support::Random& random)
{
  const Mesh tm = to_face_graph(indexed);
  const vertex_descriptor s = random_vertex(tm, random);
  const std::vector<Face_location> locations{random_location(tm, random), random_location(tm, random)};
  const std::vector<double> from_vertex = distances(tm, s);
  const double size = largest_finite(from_vertex);

  Distance_options<Mesh> options;
  options.maximum_distance = .4 * size;
  options.source_offsets = {.1 * size, .03 * size};
  const std::vector<double> from_locations = distances_with_options(tm, locations, options);

  for(const int k : {-40, -31, -13, -2, -1, 1, 3, 10, 27, 40})
  {
    const double factor = std::ldexp(1., k);
    const Mesh scaled_tm = to_face_graph(scaled(indexed, factor));
    std::vector<double> expected = from_vertex;
    for(double& d : expected)
    {
      d *= factor;
    }
    CHECK(distances(scaled_tm, s) == expected);

    Distance_options<Mesh> scaled_options;
    scaled_options.maximum_distance = factor * options.maximum_distance;
    scaled_options.source_offsets = {factor * options.source_offsets[0], factor * options.source_offsets[1]};
    expected = from_locations;
    for(double& d : expected)
    {
      d *= factor;
    }
    CHECK(distances_with_options(scaled_tm, locations, scaled_options) == expected);
  }
}

void translation_costs_only_rounding(const Indexed_mesh& indexed, test_support::Random& random)
{
  // Far away the coordinates themselves lose digits. Compares exactly with the mesh that has lost these digits, and
  // with the original up to the digits that remain.
  const Coordinates shift{1e6, -1e6, 1e6};
  const Indexed_mesh moved =
    transformed(indexed, "moved", [&](const Coordinates& p) { return p + shift; });
  const Indexed_mesh moved_back =
    transformed(moved, "moved back", [&](const Coordinates& p) { return p - shift; });
  const Mesh tm = to_face_graph(indexed);
  const Mesh moved_tm = to_face_graph(moved);
  const Mesh moved_back_tm = to_face_graph(moved_back);
  const vertex_descriptor s = random_vertex(tm, random);
  const std::vector<double> result = distances(moved_tm, s);
  CHECK_FIELDS_CLOSE(result, distances(moved_back_tm, s), tolerance);
  const std::vector<double> expected = distances(tm, s);
  const double size = largest_finite(expected);
  for(std::size_t i = 0; i < result.size(); ++i)
  {
    CHECK_NEAR(result[i], expected[i], 1e-9 * (std::max)(1., size));
  }
}

void the_order_of_sources_does_not_matter(const Mesh& tm, test_support::Random& random)
{
  std::vector<vertex_descriptor> vertex_sources;
  std::vector<Face_location> locations;
  for(std::size_t i = 0; i < 5; ++i)
  {
    vertex_sources.push_back(random_vertex(tm, random));
    locations.push_back(random_location(tm, random));
  }
  auto shuffled_sources_agree = [&](auto sources, const char* name) {
    test_support::Scope scope(name);
    const std::vector<double> expected = distances(tm, sources);
    for(std::size_t i = 0; i < 6; ++i)
    {
      random.shuffle(sources);
      const std::vector<double> result = distances(tm, sources);
      CHECK(result == expected);
      CHECK_FIELDS_CLOSE(result, expected, tolerance);
    }
  };
  shuffled_sources_agree(vertex_sources, "vertices in any order");
  shuffled_sources_agree(std::vector<Face_location>{locations[0]}, "one location");
  std::vector<Face_location> in_one_face{locations[0], locations[0]};
  in_one_face.push_back(Face_location(locations[0].first, {.2, .3, .5}));
  in_one_face.push_back(Face_location(locations[0].first, {.7, .2, .1}));
  in_one_face.push_back(Face_location(locations[0].first, {.5, .5, 0.}));
  shuffled_sources_agree(in_one_face, "locations of one face in any order");
  shuffled_sources_agree(locations, "locations in any order");
}

// ---------------------------------------------------------------------------
// types of meshes
// ---------------------------------------------------------------------------

// Computes the distances of a mesh of another type. Compares them in the order in which the vertices were added.
template <class TriangleMesh>
void other_type_gives_the_same(const Indexed_mesh& indexed, const std::vector<double>& expected, std::size_t source,
                               const char* type)
{
  test_support::Scope scope(type);
  TriangleMesh tm;
  const auto vertices_of_points = add_to_face_graph(indexed, tm);
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances(tm, map, vertices_of_points[source]));
  std::vector<double> result;
  for(const auto v : vertices_of_points)
  {
    result.push_back(get(map, v));
  }
  CHECK_FIELDS_CLOSE(result, expected, tolerance);

  // the same source, given as a location at the vertex
  for(const auto f : faces(tm))
  {
    const auto corners = corners_of_face(f, tm);
    for(std::size_t k = 0; k < 3; ++k)
    {
      if(corners[k] == vertices_of_points[source])
      {
        std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>> location(
          f, {0., 0., 0.});
        location.second[k] = 1.;
        CHECK(SMG::geodesic_distances(tm, map, location));
        std::size_t i = 0;
        for(const auto v : vertices_of_points)
        {
          const double again = get(map, v);
          CHECK_EQUAL(again, result[i++]);
        }
        return;
      }
    }
  }
}

void the_type_of_the_mesh_does_not_matter(const Indexed_mesh& indexed, test_support::Random& random)
{
  const Mesh tm = to_face_graph(indexed);
  const vertex_descriptor s = random_vertex(tm, random);
  const std::vector<double> expected = distances(tm, s);

  // Isolated and pinched vertices exist in Surface_mesh only.
  bool is_representable = true;
  for(const vertex_descriptor v : vertices(tm))
  {
    is_representable = is_representable && !tm.is_isolated(v);
    std::size_t number_of_borders = 0;
    if(!tm.is_isolated(v))
    {
      for(const auto h : CGAL::halfedges_around_target(v, tm))
      {
        number_of_borders += is_border(h, tm) ? 1 : 0;
      }
    }
    is_representable = is_representable && number_of_borders <= 1;
  }
  if(is_representable)
  {
    using Polyhedron = CGAL::Polyhedron_3<Kernel>;
    using Polyhedron_with_ids = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
    using Linear_cell_complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
      2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;
    other_type_gives_the_same<Polyhedron>(indexed, expected, std::size_t(s), "Polyhedron_3");
    // The ids are not initialized here, and nothing may rely on them.
    other_type_gives_the_same<Polyhedron_with_ids>(indexed, expected, std::size_t(s), "Polyhedron_3 with ids");
    other_type_gives_the_same<Linear_cell_complex>(indexed, expected, std::size_t(s), "Linear_cell_complex");
    other_type_gives_the_same<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>(
      indexed, expected, std::size_t(s), "Surface_mesh, other kernel");
  }

  {
    test_support::Scope scope("edge lengths only");
    Mesh with_lengths = tm;
    const auto lengths = add_edge_lengths(with_lengths);
    for(const vertex_descriptor v : vertices(with_lengths))
    {
      with_lengths.point(v) = Kernel::Point_3(0, 0, 0);
    }
    CHECK_FIELDS_CLOSE(distances_from_edge_lengths(with_lengths, lengths, s), expected, tolerance);
    const Face_location location = random_location(tm, random);
    CHECK_FIELDS_CLOSE(distances_from_edge_lengths(with_lengths, lengths, location), distances(tm, location),
                       tolerance);
  }
}

void removed_elements_are_not_there(test_support::Random& random)
{
  test_support::Scope scope("Surface_mesh with removed elements");
  for(const Indexed_mesh& indexed : {torus(1., .4, 16, 8), rough_terrain(8, 2., 4), noisy_sphere(2, .1, 5)})
  {
    Mesh tm = to_face_graph(indexed);
    // every ninth vertex with its faces, and a few more faces
    for(std::size_t i = 4; i < indexed.points.size(); i += 9)
    {
      const vertex_descriptor v = vertex(i);
      if(tm.is_removed(v) || tm.is_isolated(v) || CGAL::is_border(v, tm))
      {
        continue;
      }
      CGAL::Euler::remove_center_vertex(halfedge(v, tm), tm);
      // The face that remains is a polygon with more sides. Removes it.
      face_descriptor hole = boost::graph_traits<Mesh>::null_face();
      for(const face_descriptor f : faces(tm))
      {
        if(!CGAL::is_triangle(halfedge(f, tm), tm))
        {
          hole = f;
        }
      }
      if(hole != boost::graph_traits<Mesh>::null_face())
      {
        CGAL::Euler::remove_face(halfedge(hole, tm), tm);
      }
    }
    CHECK(tm.has_garbage());
    CHECK(tm.number_of_removed_vertices() > 0 && tm.number_of_removed_faces() > 0);

    const Indexed_mesh clean = to_indexed_mesh(tm, "clean");
    const Mesh clean_tm = to_face_graph(clean);
    std::vector<vertex_descriptor> live(vertices(tm).begin(), vertices(tm).end());
    std::vector<face_descriptor> live_faces(faces(tm).begin(), faces(tm).end());
    for(std::size_t i = 0; i < 5; ++i)
    {
      const std::size_t s = random.index(live.size());
      CHECK_FIELDS_CLOSE(distances(tm, live[s]), distances(clean_tm, vertex(s)), tolerance);
      const std::size_t f = random.index(live_faces.size());
      const Face_location location(live_faces[f], {.2, .3, .5});
      const Face_location clean_location(face(f), {.2, .3, .5});
      const auto corners = corners_of_face(live_faces[f], tm);
      const auto clean_corners = corners_of_face(face(f), clean_tm);
      if(coordinates(corners[0], tm) == coordinates(clean_corners[0], clean_tm))
      {
        CHECK_FIELDS_CLOSE(distances(tm, location), distances(clean_tm, clean_location), tolerance);
      }
    }
    Mesh collected = tm;
    collected.collect_garbage();
    CHECK_EQUAL(largest_finite(distances(tm, live)), 0.);
    CHECK_EQUAL(distances(collected, vertex(0)).size(), live.size());
  }
}

std::vector<std::size_t> shuffled_numbers(std::size_t n, test_support::Random& random)
{
  std::vector<std::size_t> numbers(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    numbers[i] = i;
  }
  random.shuffle(numbers);
  return numbers;
}

// A map that numbers the elements of a range in a random order.
template <class Index, class Range>
Mesh::Property_map<Index, std::size_t> shuffled_index_map(Mesh& tm, const Range& range, std::size_t n,
                                                          const std::string& name, test_support::Random& random)
{
  auto map = tm.add_property_map<Index, std::size_t>(name, 0).first;
  const std::vector<std::size_t> numbers = shuffled_numbers(n, random);
  std::size_t i = 0;
  for(const Index element : range)
  {
    map[element] = numbers[i++];
  }
  return map;
}

void index_maps_change_no_distance(Mesh tm, const std::vector<vertex_descriptor>& sources, test_support::Random& random)
{
  const std::vector<double> expected = distances(tm, sources);
  const auto vertex_indices
    = shuffled_index_map<Mesh::Vertex_index>(tm, vertices(tm), num_vertices(tm), "v:test_index", random);
  const auto face_indices
    = shuffled_index_map<Mesh::Face_index>(tm, faces(tm), num_faces(tm), "f:test_index", random);
  const auto halfedge_indices
    = shuffled_index_map<Mesh::Halfedge_index>(tm, halfedges(tm), num_halfedges(tm), "h:test_index", random);
  CHECK_FIELDS_CLOSE(distances_with_parameters(tm, sources, CGAL::parameters::vertex_index_map(vertex_indices)),
                     expected, tolerance);
  CHECK_FIELDS_CLOSE(distances_with_parameters(tm, sources, CGAL::parameters::face_index_map(face_indices)),
                     expected, tolerance);
  CHECK_FIELDS_CLOSE(
    distances_with_parameters(tm, sources, CGAL::parameters::halfedge_index_map(halfedge_indices)), expected,
    tolerance);
  CHECK_FIELDS_CLOSE(distances_with_parameters(tm, sources,
                                               CGAL::parameters::vertex_index_map(vertex_indices)
                                                 .face_index_map(face_indices)
                                                 .halfedge_index_map(halfedge_indices)
                                                 .geom_traits(Kernel())),
                     expected, tolerance);
  CHECK_FIELDS_CLOSE(distances_with_parameters(tm, sources,
                                               CGAL::parameters::halfedge_index_map(halfedge_indices)
                                                 .vertex_index_map(vertex_indices)
                                                 .face_index_map(face_indices)),
                     expected, tolerance);
}

void a_point_map_replaces_the_points(const Indexed_mesh& indexed, Mesh tm,
                                     const std::vector<vertex_descriptor>& sources)
{
  auto points = tm.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:test_point").first;
  for(const auto v : vertices(tm))
  {
    points[v] = Kernel::Point_3(3. * tm.point(v).x(), tm.point(v).y(), tm.point(v).z());
  }
  const Mesh stretched = to_face_graph(transformed(
    indexed, "stretched", [](const Coordinates& p) { return Coordinates{3. * p[0], p[1], p[2]}; }));
  CHECK_FIELDS_CLOSE(distances_with_parameters(tm, sources, CGAL::parameters::vertex_point_map(points)),
                     distances(stretched, sources), tolerance);
}

void any_writable_map_takes_the_distances(const Mesh& tm, const std::vector<vertex_descriptor>& sources)
{
  std::map<vertex_descriptor, double> store;
  boost::associative_property_map<std::map<vertex_descriptor, double>> store_map(store);
  CHECK(SMG::geodesic_distances(tm, store_map, sources));
  CHECK_EQUAL(store.size(), num_vertices(tm));
  CHECK_FIELDS_CLOSE(values_at_vertices(tm, store_map), distances(tm, sources), 0.);
}

void named_parameters_are_used(test_support::Random& random)
{
  test_support::Scope scope("named parameters");
  for(const Indexed_mesh& indexed : {icosphere(2), rough_terrain(8, 2., 4)})
  {
    const Mesh tm = to_face_graph(indexed);
    const std::vector<vertex_descriptor> sources{random_vertex(tm, random), random_vertex(tm, random)};
    index_maps_change_no_distance(tm, sources, random);
    a_point_map_replaces_the_points(indexed, tm, sources);
    any_writable_map_takes_the_distances(tm, sources);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260103);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : collection(seed))
  {
    test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    distances_form_a_metric(tm, random);
    distances_are_1_Lipschitz_along_edges(tm, random);
    distances_are_at_least_Euclidean(tm, random);
    subdivision_changes_no_distance(indexed, random);
    permutation_changes_no_distance(indexed, random);
    scaling_by_a_power_of_two_is_exact(indexed, random);
    translation_costs_only_rounding(indexed, random);
    the_order_of_sources_does_not_matter(tm, random);
    the_type_of_the_mesh_does_not_matter(indexed, random);
  }
  removed_elements_are_not_there(random);
  named_parameters_are_used(random);
  return test_result();
}
