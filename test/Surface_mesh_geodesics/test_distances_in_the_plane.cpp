// Flat surfaces, convex and with obstacles, on which distances are known: sources at vertices, on edges, in faces, and
// very close to vertices.

#include "distance_test_helpers.h"
#include "exact_distances.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;

double Euclidean_distance(const Coordinates& p, const Coordinates& q)
{
  return length(p - q);
}

void flat_convex_patches_have_Euclidean_distances(test_support::Random& random)
{
  for(const double jitter : {0., 1e-8, 1e-7, 1e-3, .05, .16})
  {
    for(const bool random_diagonals : {false, true})
    {
      test_support::Scope scope("jitter " + std::to_string(jitter) + (random_diagonals ? ", random diagonals" : ""));
      for(const std::size_t n : std::vector<std::size_t>{1, 3, 12})
      {
        const Mesh tm = to_face_graph(flat_patch(n, n + 2, jitter, random_diagonals, random.index(1000000)));
        sources_agree_with(tm, Euclidean_distance, 6, tolerance, random);
      }
      // cells of 1 x 1000
      const Indexed_mesh flat = flat_patch(8, 8, jitter, random_diagonals, random.index(1000000));
      const Mesh stretched = to_face_graph(
        transformed(flat, "stretched", [](const Coordinates& p) { return Coordinates{p[0], 1000. * p[1], 0.}; }));
      sources_agree_with(stretched, Euclidean_distance, 4, tolerance, random);
    }
  }
}

Indexed_mesh rotated_in_plane(const Indexed_mesh& mesh, double angle)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return transformed(mesh, mesh.name + ", rotated", [c, s](const Coordinates& p) {
    return Coordinates{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  });
}

void all_pairs_have_Euclidean_distances(const Indexed_mesh& indexed)
{
  const Mesh tm = to_face_graph(indexed);
  for(const vertex_descriptor s : vertices(tm))
  {
    const std::vector<double> result = distances(tm, s);
    for(const vertex_descriptor v : vertices(tm))
    {
      // not relative: duplicate points are at distance zero, up to rounding
      CHECK_NEAR(result[std::size_t(v)], length(coordinates(s, tm) - coordinates(v, tm)), 1e-13);
    }
  }
}

// Some rows and columns of the grid coincide with their neighbors. The faces between them have no area and one side
// without length.
void flat_patches_with_coinciding_rows_have_Euclidean_distances()
{
  test_support::Scope scope("coinciding rows and columns");
  const std::vector<std::vector<double>> positions{
    {0, 1, 2, 2, 3, 4}, {0, 1, 2, 2, 2, 3}, {0, 0, 1, 1, 2, 2}, {0, 1, 1, 1, 2}};
  test_support::Random random(1);
  for(const std::vector<double>& x : positions)
  {
    for(const std::vector<double>& y : {positions[0], positions[1], positions[2], {0., 1., 2., 3.}})
    {
      for(const bool random_diagonals : {false, true})
      {
        const Indexed_mesh grid = graph_patch(
          "grid", x.size() - 1, y.size() - 1,
          [&](std::size_t i, std::size_t j) { return Coordinates{x[i], y[j], 0.}; },
          [&](std::size_t, std::size_t) { return !random_diagonals || random.index(2) == 0; });
        for(const double angle : {0., .3, 1.1})
        {
          all_pairs_have_Euclidean_distances(rotated_in_plane(grid, angle));
        }
      }
    }
  }
}

// Vertices lie on edges of the neighbors, in a rotated mesh up to rounding.
void flat_patches_with_caps_have_Euclidean_distances()
{
  for(const std::size_t number_of_caps : std::vector<std::size_t>{1, 2, 4, 8, 16})
  {
    for(std::uint64_t seed = 0; seed < 12; ++seed)
    {
      test_support::Scope scope(std::to_string(number_of_caps) + " caps, seed " + std::to_string(seed));
      test_support::Random random(seed);
      const std::size_t n = 1 + random.index(3);
      Indexed_mesh mesh = flat_patch(n, n, seed % 2 == 0 ? 0. : .1, true, seed);
      for(std::size_t i = 0; i < number_of_caps;)
      {
        const std::size_t f = random.index(mesh.faces.size());
        const Triangle& t = mesh.faces[f];
        if(length(cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]])) < 1e-3)
        {
          continue;
        }
        mesh = with_cap(mesh, f, random.index(3), .25 * static_cast<double>(1 + random.index(3)));
        ++i;
      }
      for(const double angle : {0., .7})
      {
        all_pairs_have_Euclidean_distances(rotated_in_plane(mesh, angle));
      }
    }
  }
}

void border_edges_serve_as_sources_at_any_parameter(test_support::Random& random)
{
  test_support::Scope scope("border edges");
  for(const bool random_diagonals : {false, true})
  {
    const Mesh tm = to_face_graph(flat_patch(4, 4, .16, random_diagonals, random.index(1000000)));
    for(const auto h : halfedges(tm))
    {
      if(is_border(h, tm))
      {
        for(const double t : {1e-6, .25, .3, .5, .9, 1. - 1e-6})
        {
          const Face_location location = location_on_halfedge(opposite(h, tm), t, tm);
          const std::vector<double> expected = expected_field(tm, coordinates(location, tm), Euclidean_distance);
          const std::vector<double> result = distances(tm, location);
          for(std::size_t i = 0; i < expected.size(); ++i)
          {
            // not relative: the position of the source itself is rounded
            CHECK_NEAR(result[i], expected[i], 1e-14);
          }
        }
      }
    }
  }
}

// A source very close to a vertex. If rounding determines its direction from the vertex, a little accuracy may be lost.
void sources_next_to_a_vertex_stay_where_they_are(test_support::Random& random)
{
  test_support::Scope scope("next to a vertex");
  const Mesh tm = to_face_graph(flat_patch(4, 4, .16, true, random.index(1000000)));
  for(const double t : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13, 1e-14, 1e-15})
  {
    test_support::Scope distance_scope(std::to_string(std::log10(t)));
    const double allowed = t >= 1e-8 ? tolerance : 1e-11;
    std::vector<Face_location> sources;
    for(const auto h : halfedges(tm))
    {
      if(!is_border(h, tm))
      {
        sources.push_back(location_on_halfedge(h, t, tm));
      }
    }
    for(const face_descriptor f : faces(tm))
    {
      sources.push_back({f, {1. - 1.7 * t, t, .7 * t}});
      sources.push_back({f, {t, .5, .5 - t}});
    }
    for(const Face_location& source : sources)
    {
      const std::vector<double> expected = expected_field(tm, coordinates(source, tm), Euclidean_distance);
      const std::vector<double> result = distances(tm, source);
      for(std::size_t i = 0; i < expected.size(); ++i)
      {
        CHECK_NEAR(result[i], expected[i], allowed);
      }
    }
  }
}

// Adds noise to coordinate k of a location and subtracts it from the next one. The distances stay the same.
void check_noise_in_two_coordinates(const Mesh& tm, const Face_location& exact, std::size_t k, double noise,
                                    const std::vector<double>& expected)
{
  Face_location noisy = exact;
  noisy.second[k] += noise;
  noisy.second[(k + 1) % 3] -= noise;
  const std::vector<double> result = distances(tm, noisy);
  for(std::size_t i = 0; i < result.size(); ++i)
  {
    CHECK_NEAR(result[i], expected[i], 1e-14);
  }
}

void noisy_barycentric_coordinates_are_the_point_they_mean()
{
  test_support::Scope scope("noisy coordinates");
  for(const Indexed_mesh& indexed : {flat_patch(4, 4, .16, true, 3), icosphere(1), rough_terrain(4, 3., 4)})
  {
    const Mesh tm = to_face_graph(indexed);
    for(const vertex_descriptor v : vertices(tm))
    {
      const std::vector<double> expected = distances(tm, v);
      CHECK_EQUAL(expected[std::size_t(v)], 0.);
      for(const face_descriptor f : faces_around(v, tm))
      {
        const Face_location exact = location_of_vertex(v, f, tm);
        CHECK(distances(tm, exact) == expected);
        for(std::size_t k = 0; k < 3; ++k)
        {
          for(const double noise : {1.1e-16, 5.6e-17, -5.6e-17, -1.1e-16, 1e-17})
          {
            check_noise_in_two_coordinates(tm, exact, k, noise, expected);
            Face_location noisy = exact;
            noisy.second[k] += noise;
            CHECK_NEAR(distances(tm, noisy)[std::size_t(v)], 0., 1e-14);
          }
        }
      }
    }
    for(const auto h : halfedges(tm))
    {
      if(is_border(h, tm))
      {
        continue;
      }
      const Face_location exact = location_on_halfedge(h, .3, tm);
      const std::vector<double> expected = distances(tm, exact);
      for(std::size_t k = 0; k < 3; ++k)
      {
        for(const double noise : {5.6e-17, -5.6e-17, -1.1e-16})
        {
          check_noise_in_two_coordinates(tm, exact, k, noise, expected);
        }
      }
    }
  }
}

// ---------------------------------------------------------------------------
// the plane with obstacles
// ---------------------------------------------------------------------------

struct Rectangle
{
  double x0, y0, x1, y1;
};

// Returns whether the segment pq meets the open rectangle.
bool is_blocked(const Coordinates& p, const Coordinates& q, const Rectangle& rectangle)
{
  const double lower[2] = {rectangle.x0, rectangle.y0};
  const double upper[2] = {rectangle.x1, rectangle.y1};
  double t0 = 0.;
  double t1 = 1.;
  for(std::size_t k = 0; k < 2; ++k)
  {
    const double d = q[k] - p[k];
    if(d == 0.)
    {
      if(p[k] <= lower[k] || p[k] >= upper[k])
      {
        return false;
      }
      continue;
    }
    double a = (lower[k] - p[k]) / d;
    double b = (upper[k] - p[k]) / d;
    if(a > b)
    {
      std::swap(a, b);
    }
    t0 = (std::max)(t0, a);
    t1 = (std::min)(t1, b);
  }
  // a margin for segments that only touch a corner
  return t1 - t0 > 1e-12;
}

Exact_distance distance_around(const std::vector<Rectangle>& obstacles, const std::vector<Coordinates>& corners)
{
  return [obstacles, corners](const Coordinates& p, const Coordinates& q) {
    std::vector<Coordinates> nodes = corners;
    nodes.push_back(p);
    nodes.push_back(q);
    const std::size_t n = nodes.size();
    std::vector<double> d(n, infinity);
    d[n - 2] = 0.;
    // Bellman-Ford on the visibility graph
    for(std::size_t round = 0; round < n; ++round)
    {
      for(std::size_t i = 0; i < n; ++i)
      {
        for(std::size_t j = 0; j < n; ++j)
        {
          const double candidate = d[i] + length(nodes[i] - nodes[j]);
          if(candidate < d[j] && std::none_of(obstacles.begin(), obstacles.end(), [&](const Rectangle& r) {
               return is_blocked(nodes[i], nodes[j], r);
             }))
          {
            d[j] = candidate;
          }
        }
      }
    }
    return d[n - 1];
  };
}

void paths_in_the_plane_bend_at_corners(test_support::Random& random)
{
  {
    test_support::Scope scope("square with a hole");
    const Exact_distance exact =
      distance_around({{1, 1, 2, 2}}, {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}});
    for(const std::size_t n : std::vector<std::size_t>{1, 2, 5})
    {
      const Mesh tm = to_face_graph(plane_cells("square with a hole", {"###", "#.#", "###"}, n));
      sources_agree_with(tm, exact, 12, tolerance, random);
    }
    CHECK_CLOSE(exact({0, 0, 0}, {3, 3, 0}), 2. * std::sqrt(5.), 1e-15);
  }
  {
    test_support::Scope scope("square with four holes");
    std::vector<Rectangle> holes;
    std::vector<Coordinates> corners;
    for(const Coordinates& p : {Coordinates{1, 1, 0}, {5, 1, 0}, {3, 2, 0}, {1, 3, 0}, {5, 3, 0}})
    {
      holes.push_back({p[0], p[1], p[0] + 1, p[1] + 1});
      corners.insert(corners.end(), {p, p + Coordinates{1, 0, 0}, p + Coordinates{1, 1, 0}, p + Coordinates{0, 1, 0}});
    }
    const Mesh tm = to_face_graph(square_with_holes(2));
    sources_agree_with(tm, distance_around(holes, corners), 6, tolerance, random);
  }
  {
    test_support::Scope scope("L shape");
    const Mesh tm = to_face_graph(plane_cells("L shape", {"######", "######", "######", "###...", "###...", "###..."}));
    sources_agree_with(tm, distance_around({{3, 3, 6, 6}}, {{3, 3, 0}}), 12, tolerance, random);
  }
  {
    test_support::Scope scope("notches");
    // notches cut into the border from both sides; the obstacles reach beyond it
    const Mesh tm = to_face_graph(plane_cells("notches", {"#####", "####.", "#####", ".####", "#####"}));
    const std::vector<Rectangle> notches{{4, 1, 6, 2}, {-1, 3, 1, 4}};
    sources_agree_with(tm, distance_around(notches, {{4, 1, 0}, {4, 2, 0}, {1, 3, 0}, {1, 4, 0}}), 8, tolerance,
                       random);
  }
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20260102));
  flat_convex_patches_have_Euclidean_distances(random);
  flat_patches_with_coinciding_rows_have_Euclidean_distances();
  flat_patches_with_caps_have_Euclidean_distances();
  border_edges_serve_as_sources_at_any_parameter(random);
  sources_next_to_a_vertex_stay_where_they_are(random);
  noisy_barycentric_coordinates_are_the_point_they_mean();
  paths_in_the_plane_bend_at_corners(random);
  return test_result();
}
