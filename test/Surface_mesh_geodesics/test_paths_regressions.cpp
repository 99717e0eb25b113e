// Meshes and situations in which other programs are wrong or crash, with answers that are known by other means:
// plane geometry, with a visibility graph where the domain is not convex, and the unfolding of a cube.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;

// --- places ---

Mesh::Halfedge_index halfedge_between(std::size_t a, std::size_t b, const Mesh& tm)
{
  return halfedge(vertex(a), vertex(b), tm).first;
}

// The point a + t (b - a) from every face at that edge.
std::vector<Place> on_edge(std::size_t a, std::size_t b, double t, const Mesh& tm)
{
  std::vector<Place> places;
  const auto h = halfedge_between(a, b, tm);
  if(!is_border(h, tm))
  {
    places.push_back(location_on_halfedge(h, t, tm));
  }
  if(!is_border(opposite(h, tm), tm))
  {
    places.push_back(location_on_halfedge(opposite(h, tm), 1. - t, tm));
  }
  return places;
}

// A vertex as itself, as a corner of each face, and as a corner with noise.
std::vector<Place> at_vertex(std::size_t i, const Mesh& tm)
{
  const vertex_descriptor v = vertex(i);
  std::vector<Place> places{v};
  for(const face_descriptor f : faces_around(v, tm))
  {
    const Face_location exact = location_of_vertex(v, f, tm);
    places.push_back(exact);
    std::size_t k = 0;
    while(exact.second[k] != 1.)
    {
      ++k;
    }
    const double noises[4][3] = {
      {1., 0., 5.6e-17}, {1. - 1e-16, 0., 1.1e-16}, {1., 0., -5.6e-17}, {1., 5.6e-17, -5.6e-17}};
    for(const auto& noise : noises)
    {
      for(const std::size_t shift : {1u, 2u})
      {
        Face_location noisy = exact;
        noisy.second[k] = noise[0];
        noisy.second[(k + shift) % 3] = noise[1];
        noisy.second[(k + 3 - shift) % 3] = noise[2];
        places.push_back(noisy);
      }
    }
  }
  return places;
}

std::vector<Place> with_noise(std::vector<Place> places)
{
  const std::size_t n = places.size();
  for(std::size_t i = 0; i < n; ++i)
  {
    for(const double noise : {1.1e-16, -5.6e-17})
    {
      Face_location location = places[i].location;
      for(double& b : location.second)
      {
        if(b == 0.)
        {
          b = noise;
        }
      }
      places.push_back(location);
    }
  }
  return places;
}

Coordinates position(const Place& p, const Mesh& tm)
{
  return p.is_vertex() ? coordinates(p.vertex, tm) : coordinates(p.location, tm);
}

Place in_plane(double x, double y, const Mesh& tm)
{
  for(const face_descriptor f : faces(tm))
  {
    const auto corners = corners_of_face(f, tm);
    std::array<Coordinates, 3> p;
    for(std::size_t k = 0; k < 3; ++k)
    {
      p[k] = coordinates(corners[k], tm);
    }
    const double area = cross(p[1] - p[0], p[2] - p[0])[2];
    std::array<double, 3> weights{};
    bool is_inside = area != 0.;
    for(std::size_t k = 0; k < 3 && is_inside; ++k)
    {
      const Coordinates& a = p[(k + 1) % 3];
      const Coordinates& b = p[(k + 2) % 3];
      weights[k] = cross(b - a, Coordinates{x, y, 0.} - a)[2] / area;
      is_inside = weights[k] >= -1e-14;
    }
    if(is_inside)
    {
      return Place(Face_location(f, weights));
    }
  }
  CHECK(false);
  return Place(Face_location());
}

// All ways to give one random point: a vertex, a point of an edge, or a point inside a face.
std::vector<Place> random_spot(const Mesh& tm, test_support::Random& random)
{
  const std::size_t kind = random.index(4);
  if(kind == 0)
  {
    return at_vertex(std::size_t(random_vertex(tm, random)), tm);
  }
  if(kind == 1)
  {
    return {Place(random_location(tm, random, random.index(3) == 0 ? 1e-6 : 1e-2))};
  }
  std::vector<Mesh::Edge_index> all_edges(edges(tm).begin(), edges(tm).end());
  const auto e = all_edges[random.index(all_edges.size())];
  const auto h = halfedge(e, tm);
  const double special[8] = {.5, .25, 1. / 3., .75, .9, 1e-3, 1e-7, 1. - 1e-7};
  const double t = random.index(2) == 0 ? random.uniform(.01, .99) : special[random.index(8)];
  return with_noise(on_edge(std::size_t(source(h, tm)), std::size_t(target(h, tm)), t, tm));
}

// --- plane domains: a convex region without some open boxes ---

struct Box
{
  double x0, y0, x1, y1;
};

bool sees(const Coordinates& p, const Coordinates& q, const Box& box)
{
  double begin = 0., end = 1.;
  const double low[2] = {box.x0, box.y0}, high[2] = {box.x1, box.y1};
  for(std::size_t i = 0; i < 2; ++i)
  {
    const double d = q[i] - p[i];
    if(std::abs(d) < 1e-13)
    {
      if(p[i] <= low[i] + 1e-13 || p[i] >= high[i] - 1e-13)
      {
        return true;
      }
      continue;
    }
    begin = (std::max)(begin, (std::min)((low[i] - p[i]) / d, (high[i] - p[i]) / d));
    end = (std::min)(end, (std::max)((low[i] - p[i]) / d, (high[i] - p[i]) / d));
  }
  return end - begin < 1e-9;
}

double plane_distance(const Coordinates& p, const Coordinates& q, const std::vector<Box>& boxes)
{
  std::vector<Coordinates> nodes{p, q};
  for(const Box& b : boxes)
  {
    for(const double x : {b.x0, b.x1})
    {
      for(const double y : {b.y0, b.y1})
      {
        if(std::abs(x) < 50. && std::abs(y) < 50.)
        {
          nodes.push_back({x, y, 0.});
        }
      }
    }
  }
  std::vector<double> d(nodes.size(), infinity);
  d[0] = 0.;
  for(std::size_t round = 0; round < nodes.size(); ++round)
  {
    for(std::size_t i = 0; i < nodes.size(); ++i)
    {
      for(std::size_t j = 0; j < nodes.size(); ++j)
      {
        if(std::all_of(boxes.begin(), boxes.end(), [&](const Box& b) { return sees(nodes[i], nodes[j], b); }))
        {
          d[j] = (std::min)(d[j], d[i] + length(nodes[j] - nodes[i]));
        }
      }
    }
  }
  return d[1];
}

// Random pairs of points of a plane mesh, each in several of the ways to give it.
void plane_mesh(const std::string& name, const Mesh& tm, const std::vector<Box>& boxes, std::size_t pairs,
                test_support::Random& random, double relative = tolerance)
{
  test_support::Scope scope(name);
  const double size = size_of(tm);
  Geodesic_paths paths(tm);
  for(std::size_t i = 0; i < pairs; ++i)
  {
    std::vector<Place> sources = random_spot(tm, random);
    random.shuffle(sources);
    sources.resize((std::min)(sources.size(), std::size_t(3)), sources.front());
    std::vector<std::vector<Place>> queries;
    for(std::size_t j = 0; j < 6; ++j)
    {
      queries.push_back(random_spot(tm, random));
      random.shuffle(queries.back());
      queries.back().resize((std::min)(queries.back().size(), std::size_t(4)), queries.back().front());
    }
    queries.push_back(sources); // from a point to itself
    for(const Place& source : sources)
    {
      paths.remove_all_source_points();
      add(paths, source);
      test_support::Scope source_scope("from " + description(source));
      for(const std::vector<Place>& spot : queries)
      {
        for(const Place& query : spot)
        {
          test_support::Scope query_scope("to " + description(query));
          const double expected = plane_distance(position(source, tm), position(query, tm), boxes);
          const double d = ask(paths, query).distance;
          CHECK_NEAR(d, expected, relative * size);
          const auto points = checked_path(paths, query, tm, size, (std::max)(1e-10, relative));
          if(&spot == &queries.back())
          {
            CHECK(d <= 1e-15 * size);
            CHECK(points.size() == 1 || polyline_length(points) <= 1e-15 * size);
          }
        }
      }
    }
  }
}

void plane_meshes(test_support::Random& random)
{
  for(const std::string name :
      {"two_tri_square", "two_tri_square_b", "single_triangle", "kite_pp3d30", "square100_gc111", "strip4", "grid4",
       "grid5", "grid6", "grid7", "grid8", "grid9", "grid5_tiny_1e-9", "grid5_huge_1e9", "needle_dup_position",
       "cap_zero_area"})
  {
    plane_mesh(name, load_data(name), {}, 40, random);
  }
  plane_mesh("grid5_offset_1e6", load_data("grid5_offset_1e6"), {}, 40, random, 1e-15);
  plane_mesh("sliver_1e-12", load_data("sliver_1e-12"), {}, 40, random, 1e-9);
  plane_mesh("L_shape", load_data("L_shape"), {{1., 1., 1e3, 1e3}}, 60, random);
  plane_mesh("square with one hole", to_face_graph(plane_cells("one hole", {"###", "#.#", "###"})),
             {{1., 1., 2., 2.}}, 100, random);
  plane_mesh("square with two holes", to_face_graph(plane_cells("two holes", {"#####", "#.#.#", "#####"})),
             {{1., 1., 2., 2.}, {3., 1., 4., 2.}}, 60, random);
}

// A source at a small distance from a vertex makes long and thin faces there.
void sources_near_to_vertices(test_support::Random& random)
{
  for(const std::string name : {"single_triangle", "two_tri_square", "grid4", "grid7"})
  {
    test_support::Scope scope(name + ", sources near to vertices");
    const Mesh tm = load_data(name);
    const double size = size_of(tm);
    Geodesic_paths paths(tm);
    for(std::size_t i = 0; i < 1000; ++i)
    {
      const double e = std::pow(10., -1. - static_cast<double>(i % 13)) * random.uniform(.5, 1.);
      const double share = random.index(2) == 0 ? 1. : random.uniform(.2, .8);
      const std::size_t k = random.index(3), side = 1 + random.index(2);
      Face_location source(face(random.index(num_faces(tm))), {0., 0., 0.});
      source.second[k] = 1. - e;
      source.second[(k + side) % 3] = e * share;
      source.second[(k + 3 - side) % 3] = e * (1. - share);
      paths.remove_all_source_points();
      add(paths, Place(source));
      test_support::Scope source_scope("from " + description(Place(source)));
      for(std::size_t j = 0; j < 4; ++j)
      {
        Face_location query = random_location(tm, random);
        if(j == 0)
        {
          query.first = source.first;
        }
        if(random.index(2) == 0)
        {
          const std::size_t zero = random.index(3);
          query.second[(zero + 1) % 3] += query.second[zero];
          query.second[zero] = 0.;
        }
        test_support::Scope query_scope("to " + description(Place(query)));
        CHECK_NEAR(ask(paths, Place(query)).distance, length(coordinates(source, tm) - coordinates(query, tm)),
                   tolerance * size);
        checked_path(paths, Place(query), tm, size);
      }
    }
  }
}

// --- one by one ---

void edge_sources_are_not_mirrored()
{
  {
    test_support::Scope scope("single_triangle");
    const Mesh tm = load_data("single_triangle");
    const std::vector<double> expected{.75, 2.25, std::sqrt(16.5625)};
    for(const Place& source : with_noise(on_edge(0, 1, .25, tm)))
    {
      Geodesic_paths paths(tm);
      add(paths, source);
      for(std::size_t i = 0; i < 3; ++i)
      {
        CHECK_CLOSE(ask(paths, Place(vertex(i))).distance, expected[i], tolerance);
        checked_path(paths, Place(vertex(i)), tm, 4.);
      }
    }
  }
  test_support::Scope scope("two_tri_square");
  const Mesh tm = load_data("two_tri_square");
  for(const Place& source : on_edge(0, 1, .25, tm))
  {
    Geodesic_paths paths(tm);
    add(paths, source);
    const std::vector<double> expected{.25, .75, 1.25, std::sqrt(1.0625)};
    for(std::size_t i = 0; i < 4; ++i)
    {
      CHECK_CLOSE(ask(paths, Place(vertex(i))).distance, expected[i], tolerance);
    }
    for(const Place& query : on_edge(0, 1, .75, tm))
    {
      CHECK_CLOSE(ask(paths, query).distance, .5, tolerance);
      CHECK_EQUAL(checked_path(paths, query, tm, 1.).size(), 2u);
    }
  }
  for(const Place& source : on_edge(0, 2, .25, tm))
  {
    Geodesic_paths paths(tm);
    add(paths, source);
    for(const Place& query : on_edge(0, 2, .75, tm))
    {
      CHECK_CLOSE(ask(paths, query).distance, std::sqrt(.5), tolerance);
      CHECK_EQUAL(checked_path(paths, query, tm, 1.).size(), 2u);
    }
  }
}

void noise_at_a_corner()
{
  test_support::Scope scope("noise at a corner of grid5");
  const Mesh tm = load_data("grid5");
  const vertex_descriptor corner = corners_of_face(face(6), tm)[2];
  Geodesic_paths expected(tm);
  expected.add_source_point(corner);
  CHECK_EQUAL(std::size_t(corner), 4u);
  for(const Place& source : at_vertex(4, tm))
  {
    Geodesic_paths paths(tm);
    add(paths, source);
    CHECK_EQUAL(ask(paths, Place(corner)).distance, 0.);
    CHECK_EQUAL(ask(paths, source).distance, 0.);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_EQUAL(ask(paths, Place(v)).distance, ask(expected, Place(v)).distance);
    }
    CHECK_EQUAL(checked_path(paths, Place(corner), tm, 1.).size(), 1u);
  }
}

void border_edge_queries()
{
  test_support::Scope scope("two_tri_square_b, queries on the border");
  const Mesh tm = load_data("two_tri_square_b");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(1));
  CHECK_CLOSE(ask(paths, in_plane(0., .5, tm)).distance, .5, tolerance);
  CHECK_CLOSE(ask(paths, in_plane(0., .25, tm)).distance, .75, tolerance);
  CHECK_EQUAL(checked_path(paths, in_plane(0., .25, tm), tm, 1.).size(), 2u);
}

void two_vertex_sources()
{
  test_support::Scope scope("two_tri_square_b, two vertices");
  const Mesh tm = load_data("two_tri_square_b");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  paths.add_source_point(vertex(1));
  const std::vector<double> expected{0., 0., 1., 1.};
  for(std::size_t i = 0; i < 4; ++i)
  {
    const Answer answer = ask(paths, Place(vertex(i)));
    CHECK_CLOSE(answer.distance, expected[i], tolerance);
    CHECK_EQUAL(answer.source, i % 2);
  }
}

void several_face_sources(test_support::Random& random)
{
  const Mesh tm = load_data("two_tri_square_b");
  {
    test_support::Scope scope("two_tri_square_b, two sources in one face");
    Geodesic_paths paths(tm);
    add(paths, in_plane(.75, .125, tm));
    add(paths, in_plane(.625, .125, tm));
    const Answer answer = ask(paths, in_plane(.625, .5, tm));
    CHECK_CLOSE(answer.distance, .375, tolerance);
    CHECK_EQUAL(answer.source, 1u);
    checked_path(paths, in_plane(.625, .5, tm), tm, 1.);
  }
  for(const std::string name : {"two_tri_square", "grid4", "grid6", "grid9"})
  {
    test_support::Scope scope(name + ", several sources");
    const Mesh grid = load_data(name);
    Geodesic_paths paths(grid);
    for(std::size_t round = 0; round < 40; ++round)
    {
      const std::size_t number = 2 + random.index(12);
      paths.remove_all_source_points();
      std::vector<Coordinates> positions;
      for(std::size_t i = 0; i < number; ++i)
      {
        // random points, points of one line, and points that have been taken already
        std::vector<Place> spot = random_spot(grid, random);
        Place source = spot[random.index(spot.size())];
        if(i > 0 && random.index(3) == 0)
        {
          const Coordinates p = positions[random.index(i)];
          source = in_plane(p[0], random.index(3) == 0 ? p[1] : random.uniform(), grid);
        }
        add(paths, source);
        positions.push_back(position(source, grid));
      }
      for(std::size_t j = 0; j < 30; ++j)
      {
        const std::vector<Place> spot = random_spot(grid, random);
        const Place query = j < number ? in_plane(positions[j][0], positions[j][1], grid)
                                       : spot[random.index(spot.size())];
        double expected = infinity;
        for(const Coordinates& p : positions)
        {
          expected = (std::min)(expected, length(p - position(query, grid)));
        }
        test_support::Scope query_scope("to " + description(query));
        const Answer answer = ask(paths, query);
        CHECK_NEAR(answer.distance, expected, tolerance);
        if(CHECK(answer.source < number))
        {
          CHECK_NEAR(length(positions[answer.source] - position(query, grid)), expected, tolerance);
        }
        checked_path(paths, query, grid, 1.);
      }
    }
  }
}

void isolated_vertices_and_components()
{
  {
    test_support::Scope scope("isolated_vertex");
    const Mesh tm = load_data("isolated_vertex");
    Geodesic_paths paths(tm);
    paths.add_source_point(vertex(0));
    const std::vector<double> expected{0., 1., std::sqrt(2.), 1., -1.};
    for(std::size_t i = 0; i < 5; ++i)
    {
      CHECK_CLOSE(ask(paths, Place(vertex(i))).distance, expected[i], tolerance);
      CHECK_EQUAL(checked_path(paths, Place(vertex(i)), tm, 1.).empty(), i == 4);
    }
    paths.remove_all_source_points();
    const auto isolated = paths.add_source_point(vertex(4));
    for(std::size_t i = 0; i < 5; ++i)
    {
      CHECK_EQUAL(ask(paths, Place(vertex(i))).distance, i == 4 ? 0. : -1.);
      CHECK_EQUAL(checked_path(paths, Place(vertex(i)), tm, 1.).size(), i == 4 ? 1u : 0u);
    }
    CHECK(isolated->first == Geodesic_paths::Graph_traits::null_face());
    CHECK_EQUAL(ask(paths, Place(location_of_vertex(vertex(2), face(0), tm))).distance, -1.);
    CHECK_EQUAL(ask(paths, in_plane(.25, .5, tm)).distance, -1.);
    CHECK(checked_path(paths, in_plane(.25, .5, tm), tm, 1.).empty());
    paths.add_source_point(vertex(1));
    CHECK_EQUAL(ask(paths, Place(vertex(4))).source, 0u);
    CHECK_EQUAL(ask(paths, Place(vertex(3))).source, 1u);
    CHECK_CLOSE(ask(paths, in_plane(.5, .5, tm)).distance, std::sqrt(.5), tolerance);
  }
  test_support::Scope scope("two_components");
  const Mesh tm = load_data("two_components");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  for(std::size_t i = 0; i < 6; ++i)
  {
    CHECK_EQUAL(ask(paths, Place(vertex(i))).distance, i > 2 ? -1. : i == 0 ? 0. : 1.);
  }
  CHECK(checked_path(paths, Place(Face_location(face(1), {.25, .25, .5})), tm, 1.).empty());
  paths.add_source_point(vertex(3));
  for(std::size_t i = 0; i < 6; ++i)
  {
    CHECK_EQUAL(ask(paths, Place(vertex(i))).distance, i % 3 == 0 ? 0. : 1.);
    CHECK_EQUAL(ask(paths, Place(vertex(i))).source, i / 3);
  }
  checked_path(paths, Place(Face_location(face(1), {.25, .25, .5})), tm, 1.);
}

void points_of_paths_are_not_repeated()
{
  {
    test_support::Scope scope("grid6");
    const Mesh tm = load_data("grid6");
    Geodesic_paths paths(tm);
    paths.add_source_point(vertex(0));
    CHECK_EQUAL(checked_path(paths, Place(vertex(5)), tm, 1.).size(), 6u);
    for(const vertex_descriptor s : vertices(tm))
    {
      paths.remove_all_source_points();
      paths.add_source_point(s);
      for(const vertex_descriptor v : vertices(tm))
      {
        CHECK_NEAR(ask(paths, Place(v)).distance, length(coordinates(s, tm) - coordinates(v, tm)), tolerance);
        checked_path(paths, Place(v), tm, 1.);
      }
    }
  }
  test_support::Scope scope("cap_zero_area");
  const Mesh tm = load_data("cap_zero_area");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(4));
  const double r2 = std::sqrt(2.);
  const std::vector<double> expected{r2, r2, 1., 2., 0.};
  for(std::size_t i = 0; i < 5; ++i)
  {
    CHECK_CLOSE(ask(paths, Place(vertex(i))).distance, expected[i], tolerance);
    checked_path(paths, Place(vertex(i)), tm, 1.);
  }
}

void edges_without_length()
{
  test_support::Scope scope("needle_dup_position");
  const Mesh tm = load_data("needle_dup_position");
  const std::vector<double> expected{0., 1., std::sqrt(2.), 1., 1., 2., std::sqrt(5.)};
  for(const Place& source : at_vertex(0, tm))
  {
    Geodesic_paths paths(tm);
    add(paths, source);
    for(std::size_t i = 0; i < 7; ++i)
    {
      CHECK_CLOSE(ask(paths, Place(vertex(i))).distance, expected[i], tolerance);
      checked_path(paths, Place(vertex(i)), tm, 2.);
    }
    for(const double t : {.25, .5})
    {
      for(const Place& query : on_edge(1, 4, t, tm))
      {
        CHECK_CLOSE(ask(paths, query).distance, 1., tolerance);
        checked_path(paths, query, tm, 2.);
      }
    }
  }
  for(const Place& source : on_edge(1, 4, .25, tm))
  {
    Geodesic_paths paths(tm);
    add(paths, source);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_NEAR(ask(paths, Place(v)).distance, length(coordinates(v, tm) - Coordinates{1., 0., 0.}), tolerance);
      checked_path(paths, Place(v), tm, 2.);
    }
  }
}

// --- surfaces in space ---

// Rolls the cube so that the face of q comes to the plane on which p is, in all ways with at most three turns.
void roll(Coordinates q, std::vector<Coordinates> centers, double x, double y, const Coordinates& p, double& best)
{
  if(std::abs(q[2]) < 1e-14)
  {
    best = (std::min)(best, length(q - p));
  }
  if(centers.size() == 4)
  {
    return;
  }
  // centres: those of the faces that have lain on the plane, carried along with the cube
  for(std::size_t direction = 0; direction < 4; ++direction)
  {
    auto turn = [&](const Coordinates& c) -> Coordinates
    {
      switch(direction)
      {
      case 0:
        return {x + 1. + c[2], c[1], x + 1. - c[0]};
      case 1:
        return {x - c[2], c[1], c[0] - x};
      case 2:
        return {c[0], y + 1. + c[2], y + 1. - c[1]};
      default:
        return {c[0], y - c[2], c[1] - y};
      }
    };
    const double dx = direction == 0 ? 1. : direction == 1 ? -1. : 0.;
    const double dy = direction == 2 ? 1. : direction == 3 ? -1. : 0.;
    std::vector<Coordinates> carried;
    bool comes_back = false;
    for(const Coordinates& c : centers)
    {
      carried.push_back(turn(c));
      comes_back = comes_back || std::abs(carried.back()[2]) < 1e-14;
    }
    if(comes_back)
    {
      continue;
    }
    carried.push_back({x + dx + .5, y + dy + .5, 0.});
    roll(turn(q), carried, x + dx, y + dy, p, best);
  }
}

double cube_distance(const Coordinates& p, const Coordinates& q)
{
  double best = infinity;
  for(std::size_t axis = 0; axis < 3; ++axis)
  {
    for(const double side : {0., 1.})
    {
      if(std::abs(p[axis] - side) > 1e-14)
      {
        continue;
      }
      // the cube with that face down; a reflection does no harm
      auto place = [axis, side](Coordinates c) -> Coordinates
      {
        std::swap(c[axis], c[2]);
        c[2] = std::abs(c[2] - side);
        return c;
      };
      roll(place(q), {{.5, .5, 0.}}, 0., 0., place(p), best);
    }
  }
  return best;
}

void cube_surface(test_support::Random& random)
{
  CHECK_CLOSE(cube_distance({0., 0., 0.}, {1., 1., 1.}), std::sqrt(5.), tolerance);
  CHECK_CLOSE(cube_distance({.5, .5, 0.}, {.5, .5, 1.}), 2., tolerance);
  CHECK_CLOSE(cube_distance({.5, 0., .5}, {1., .5, .5}), 1., tolerance);
  Indexed_mesh indexed = to_indexed_mesh(load_data("cube"), "cube");
  for(std::size_t round = 0; round < 3; ++round)
  {
    test_support::Scope scope("cube, subdivided " + std::to_string(round) + " times");
    const Mesh tm = to_face_graph(indexed);
    Geodesic_paths paths(tm);
    for(std::size_t i = 0; i < 60; ++i)
    {
      const std::vector<Place> spot = random_spot(tm, random);
      const Place source = spot[random.index(spot.size())];
      paths.remove_all_source_points();
      add(paths, source);
      for(std::size_t j = 0; j < 12; ++j)
      {
        const std::vector<Place> other = random_spot(tm, random);
        const Place query = other[random.index(other.size())];
        CHECK_NEAR(ask(paths, query).distance, cube_distance(position(source, tm), position(query, tm)), tolerance);
        checked_path(paths, query, tm, 1.);
      }
    }
    if(round == 0)
    {
      const std::vector<double> expected{
        0., 1., 1., std::sqrt(2.), 1., std::sqrt(2.), std::sqrt(2.), std::sqrt(5.)};
      for(const Place& source : at_vertex(0, tm))
      {
        paths.remove_all_source_points();
        add(paths, source);
        for(std::size_t v = 0; v < 8; ++v)
        {
          CHECK_CLOSE(ask(paths, Place(vertex(v))).distance, expected[v], tolerance);
          checked_path(paths, Place(vertex(v)), tm, 1.);
        }
      }
    }
    indexed = midpoint_subdivision(indexed);
  }
}

// --- paths that bend, with distances by hand ---

Place vertex_at(double x, double y, const Mesh& tm)
{
  for(const vertex_descriptor v : vertices(tm))
  {
    if(coordinates(v, tm) == Coordinates{x, y, 0.})
    {
      return Place(v);
    }
  }
  CHECK(false);
  return Place(vertex_descriptor());
}

// The points of a path in the plane where it changes its direction.
std::vector<Coordinates> bends(const std::vector<Coordinates>& path)
{
  std::vector<Coordinates> result;
  for(std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    if(std::abs(cross(path[i] - path[i - 1], path[i + 1] - path[i])[2]) > 1e-10)
    {
      result.push_back(path[i]);
    }
  }
  return result;
}

// One query, and the ways its path may bend.
struct Path_by_hand
{
  double x, y, distance;
  std::vector<std::vector<Coordinates>> possible_bends;
};

void check_by_hand(const Mesh& tm, const Place& source, const std::vector<Path_by_hand>& expected)
{
  Geodesic_paths paths(tm);
  add(paths, source);
  for(const Path_by_hand& path : expected)
  {
    for(const Place& query : {vertex_at(path.x, path.y, tm), in_plane(path.x, path.y, tm)})
    {
      test_support::Scope scope("to " + description(query));
      CHECK_CLOSE(ask(paths, query).distance, path.distance, tolerance);
      const auto found = bends(checked_path(paths, query, tm, 3.));
      CHECK(std::find(path.possible_bends.begin(), path.possible_bends.end(), found) != path.possible_bends.end());
    }
  }
}

// A square of side 3 with a square hole in its middle, flat.
void ring_around_a_hole()
{
  const double r2 = std::sqrt(2.), r5 = std::sqrt(5.);
  const Coordinates low{2., 1., 0.}, high{1., 2., 0.};
  for(const std::size_t n : {1u, 2u, 4u})
  {
    test_support::Scope scope("ring around a hole, cells of side 1/" + std::to_string(n));
    const Mesh tm = to_face_graph(plane_cells("ring", {"###", "#.#", "###"}, n));
    check_by_hand(tm, vertex_at(0., 0., tm),
                  {{3., 0., 3., {{}}},
                   {0., 3., 3., {{}}},
                   {1., 1., r2, {{}}},
                   {1., 2., r5, {{}}},
                   {2., 2., r5 + 1., {{low}, {high}}},
                   {2., 3., r5 + r2, {{high}}},
                   {3., 2., r5 + r2, {{low}}},
                   {3., 3., 2. * r5, {{low}, {high}}}});
    // along one side of the hole, or the other one
    check_by_hand(tm, vertex_at(1., 0., tm), {{1., 3., 3., {{}}}, {2., 3., 2. + r2, {{low}, {high}}}});
  }
}

// A square of side 2 without a quarter: the border has a corner that paths bend around.
void corner_of_the_border()
{
  const double r2 = std::sqrt(2.), r5 = std::sqrt(5.);
  const Coordinates corner{1., 1., 0.};
  for(const std::size_t n : {2u, 4u})
  {
    test_support::Scope scope("corner of the border, cells of side 1/" + std::to_string(n));
    const Mesh tm = to_face_graph(plane_cells("L", {"##", "#."}, n));
    check_by_hand(tm, vertex_at(1., 2., tm),
                  {{2., 1., 2., {{corner}}},
                   {2., 0., 1. + r2, {{corner}}},
                   {2., .5, 1. + r5 / 2., {{corner}}},
                   {1., 0., 2., {{}}},
                   {.5, 0., std::sqrt(4.25), {{}}},
                   {0., 0., r5, {{}}}});
    check_by_hand(tm, vertex_at(.5, 2., tm), {{2., .5, r5, {{corner}}}, {1.5, 0., r5, {{}}}});
  }
}

// Congruent triangles around a vertex, with more than a full turn in all. Unfolded around it, the rim is a part of a
// regular polygon: the path is a chord, or goes through the vertex if the angle there is at least pi on both sides.
void saddle_vertices()
{
  for(const double z : {.1, .3, .7})
  {
    for(const std::size_t n : {6u, 8u, 10u, 16u})
    {
      test_support::Scope scope("saddle vertex, " + std::to_string(n) + " faces, z " + std::to_string(z));
      const Mesh tm = to_face_graph(fan("saddle", n, z, -z));
      const double radius = std::sqrt(1. + z * z);
      const double angle = 2. * std::asin(std::hypot(std::sin(pi / static_cast<double>(n)), z) / radius);
      CHECK(angle * static_cast<double>(n) > 2. * pi);
      Geodesic_paths paths(tm);
      paths.add_source_point(vertex(1));
      for(std::size_t i = 0; i < n; ++i)
      {
        const std::size_t steps = (std::min)(i, n - i);
        const double turn = angle * static_cast<double>(steps);
        const Place query(vertex(1 + i));
        CHECK_CLOSE(ask(paths, query).distance, 2. * radius * (turn < pi ? std::sin(turn / 2.) : 1.), tolerance);
        const auto points = checked_path(paths, query, tm, radius);
        CHECK_EQUAL(points.size(), turn < pi ? steps + 1 : 3u);
        CHECK_EQUAL(std::count(points.begin(), points.end(), Coordinates{0., 0., 0.}), turn < pi ? 0 : 1);
      }
    }
  }
}

void other_surfaces()
{
  {
    test_support::Scope scope("tetra");
    const Mesh tm = load_data("tetra");
    Geodesic_paths paths(tm);
    add(paths, Place(Face_location(face(0), {1. / 3., 1. / 3., 1. / 3.})));
    for(std::size_t v = 0; v < 4; ++v)
    {
      CHECK_CLOSE(ask(paths, Place(vertex(v))).distance, (v == 3 ? 2. : 1.) * std::sqrt(8. / 3.), tolerance);
      checked_path(paths, Place(vertex(v)), tm, 3.);
    }
  }
  {
    test_support::Scope scope("octahedron");
    const Mesh tm = load_data("octahedron");
    Geodesic_paths single(tm);
    single.add_source_point(vertex(0));
    CHECK_CLOSE(ask(single, Place(vertex(1))).distance, std::sqrt(6.), tolerance);
    Geodesic_paths twice(tm);
    twice.add_source_point(vertex(0));
    for(const Place& same : at_vertex(0, tm))
    {
      add(twice, same);
    }
    Geodesic_paths three(tm);
    const std::vector<vertex_descriptor> sources{vertex(0), vertex(2), vertex(4)};
    const auto first = three.add_source_points(sources.begin(), sources.end());
    CHECK(first == three.source_points_begin());
    for(std::size_t v = 0; v < 6; ++v)
    {
      CHECK_EQUAL(ask(twice, Place(vertex(v))).distance, ask(single, Place(vertex(v))).distance);
      CHECK_EQUAL(ask(twice, Place(vertex(v))).source, 0u);
      checked_path(twice, Place(vertex(v)), tm, 1.);
      CHECK_CLOSE(ask(three, Place(vertex(v))).distance, v % 2 == 0 ? 0. : std::sqrt(2.), tolerance);
      checked_path(three, Place(vertex(v)), tm, 1.);
    }
  }
  {
    test_support::Scope scope("L_shape");
    const Mesh tm = load_data("L_shape");
    Geodesic_paths paths(tm);
    paths.add_source_point(vertex(7));
    const auto points = checked_path(paths, Place(vertex(2)), tm, 2.);
    CHECK_CLOSE(polyline_length(points), 1. + std::sqrt(2.), tolerance);
    CHECK(std::find(points.begin(), points.end(), coordinates(vertex(4), tm)) != points.end());
  }
  {
    test_support::Scope scope("saddle_fan8");
    const Mesh tm = load_data("saddle_fan8");
    Geodesic_paths paths(tm);
    paths.add_source_point(vertex(1));
    for(std::size_t v = 0; v < 9; ++v)
    {
      const double expected = v == 0 ? 1. : v == 1 ? 0. : v == 2 || v == 8 ? 1.6645969834 : 2.;
      CHECK_CLOSE(ask(paths, Place(vertex(v))).distance, expected, 1e-10);
      const auto points = checked_path(paths, Place(vertex(v)), tm, 1.);
      if(expected == 2.)
      {
        CHECK_EQUAL(points.size(), 3u);
      }
    }
  }
  {
    test_support::Scope scope("cone64");
    const Mesh tm = load_data("cone64");
    Geodesic_paths paths(tm);
    paths.add_source_point(vertex(1));
    const double r2 = std::sqrt(2.);
    const double sector = 2. * std::asin(std::sin(pi / 64.) / r2);
    for(std::size_t i = 0; i < 64; ++i)
    {
      const std::size_t steps = (std::min)(i, 64 - i);
      CHECK_CLOSE(ask(paths, Place(vertex(1 + i))).distance,
                  2. * r2 * std::sin(.5 * sector * static_cast<double>(steps)), tolerance);
      CHECK_EQUAL(checked_path(paths, Place(vertex(1 + i)), tm, r2).size(), 1 + steps);
    }
    // along a generator of the cone, in any face there
    for(const double t : {.25, .5})
    {
      for(const Place& query : on_edge(17, 0, t, tm))
      {
        const double a = 16. * sector, r = r2 * (1. - t);
        CHECK_CLOSE(ask(paths, query).distance, std::sqrt(2. + r * r - 2. * r2 * r * std::cos(a)), tolerance);
        checked_path(paths, query, tm, r2);
      }
    }
  }
  {
    test_support::Scope scope("pinched_vertex");
    const Mesh tm = load_data("pinched_vertex");
    const double r2 = std::sqrt(2.);
    Geodesic_paths paths(tm);
    paths.add_source_point(vertex(2));
    const std::vector<double> expected{r2, 1., 0., 1. + r2, 2. * r2};
    for(std::size_t v = 0; v < 5; ++v)
    {
      CHECK_CLOSE(ask(paths, Place(vertex(v))).distance, expected[v], tolerance);
      checked_path(paths, Place(vertex(v)), tm, 1.);
    }
    for(const face_descriptor f : faces(tm))
    {
      checked_path(paths, Place(Face_location(f, {.25, .25, .5})), tm, 1.);
    }
  }
}

void broken_files_are_refused()
{
  for(const std::string name : {"edge_three_faces", "index_out_of_range"})
  {
    test_support::Scope scope(name);
    bool is_refused = false;
    try
    {
      Mesh tm;
      is_refused = !read_data(name, tm);
      if(!is_refused && num_vertices(tm) > 0)
      {
        Geodesic_paths paths(tm);
        paths.add_source_point(vertex(0));
        paths.build_sequence_tree_for_faces();
      }
    }
    catch(const std::exception&)
    {
      is_refused = true;
    }
    CHECK(is_refused);
  }
}

// Every file of the folder, so that none is forgotten: from each vertex and from points of faces the distances are
// those of geodesic_distances(), and each path has the length of its distance.
void every_file(test_support::Random& random)
{
  std::size_t number_of_meshes = 0;
  for(const auto& entry : std::filesystem::directory_iterator("data"))
  {
    const std::string name = entry.path().stem().string();
    Mesh tm;
    if(entry.path().extension() != ".off" || name == "edge_three_faces" || name == "index_out_of_range")
    {
      continue;
    }
    test_support::Scope scope(name);
    if(!CHECK(read_data(name, tm)))
    {
      continue;
    }
    ++number_of_meshes;
    const double size = size_of(tm);
    auto expected = get(CGAL::dynamic_vertex_property_t<double>(), tm);
    for(std::size_t i = 0; i < num_vertices(tm) + 5; ++i)
    {
      const Place place = i < num_vertices(tm) ? Place(vertex(i)) : Place(random_location(tm, random));
      test_support::Scope source_scope("source " + description(place));
      Geodesic_paths paths(tm);
      add(paths, place);
      if(place.is_vertex())
      {
        CGAL::Surface_mesh_geodesics::geodesic_distances(tm, expected, place.vertex);
      }
      else
      {
        CGAL::Surface_mesh_geodesics::geodesic_distances(tm, expected, place.location);
      }
      for(const vertex_descriptor v : vertices(tm))
      {
        const double distance = ask(paths, Place(v)).distance;
        CHECK_EQUAL(distance < 0. ? infinity : distance, get(expected, v));
        checked_path(paths, Place(v), tm, size);
      }
      checked_path(paths, place, tm, size);
    }
  }
  CHECK(number_of_meshes >= 37);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260402);
  test_support::Random random(seed);
  edge_sources_are_not_mirrored();
  noise_at_a_corner();
  border_edge_queries();
  two_vertex_sources();
  several_face_sources(random);
  isolated_vertices_and_components();
  points_of_paths_are_not_repeated();
  edges_without_length();
  cube_surface(random);
  ring_around_a_hole();
  corner_of_the_border();
  saddle_vertices();
  other_surfaces();
  broken_files_are_refused();
  plane_meshes(random);
  sources_near_to_vertices(random);
  every_file(random);
  return test_result();
}
