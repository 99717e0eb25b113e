// Surfaces on which the distances are known: flat ones, polyhedra that unfold by hand,
// cones, cylinders and flat tori that exist as edge lengths only.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;

using Exact_distance = std::function<double(const Coordinates&, const Coordinates&)>;

std::vector<double> expected_field(const Mesh& tm, const Coordinates& source, const Exact_distance& exact)
{
  std::vector<double> result;
  for(const vertex_descriptor v : vertices(tm))
  {
    result.push_back(exact(source, coordinates(v, tm)));
  }
  return result;
}

// sources at vertices, in faces and on edges, these seen from both sides
void sources_agree_with(const Mesh& tm, const Exact_distance& exact, std::size_t number, test_support::Random& random)
{
  std::vector<Mesh::Halfedge_index> all_halfedges(halfedges(tm).begin(), halfedges(tm).end());
  for(std::size_t i = 0; i < number; ++i)
  {
    const vertex_descriptor v = random_vertex(tm, random);
    CHECK_FIELDS_CLOSE(distances(tm, v), expected_field(tm, coordinates(v, tm), exact), tolerance);

    const Face_location location = random_location(tm, random);
    CHECK_FIELDS_CLOSE(distances(tm, location), expected_field(tm, coordinates(location, tm), exact), tolerance);

    const auto h = all_halfedges[random.index(all_halfedges.size())];
    const double t = i % 2 == 0 ? random.uniform(.01, .99) : std::array<double, 3>{.25, .5, .75}[i / 2 % 3];
    for(const auto& side : {std::make_pair(h, t), std::make_pair(opposite(h, tm), 1. - t)})
    {
      if(!is_border(side.first, tm))
      {
        const Face_location edge_location = location_on_halfedge(side.first, side.second, tm);
        CHECK_FIELDS_CLOSE(distances(tm, edge_location), expected_field(tm, coordinates(edge_location, tm), exact),
                           tolerance);
      }
    }
  }
}

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
        sources_agree_with(tm, Euclidean_distance, 6, random);
      }
      // cells of 1 x 1000
      const Indexed_mesh flat = flat_patch(8, 8, jitter, random_diagonals, random.index(1000000));
      const Mesh stretched = to_face_graph(
        transformed(flat, "stretched", [](const Coordinates& p) { return Coordinates{p[0], 1000. * p[1], 0.}; }));
      sources_agree_with(stretched, Euclidean_distance, 4, random);
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

// Rows and columns of a grid that coincide with their neighbours: all their faces have
// area zero and a side of length zero.
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

// Vertices on edges of the neighbours; in a rotated mesh only up to rounding.
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

// A source that is not a vertex but very close to one. Where the direction from the
// vertex to it is made of rounding errors, a little may be lost.
void sources_next_to_a_vertex_keep_their_place(test_support::Random& random)
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
            Face_location noisy = exact;
            noisy.second[k] += noise;
            noisy.second[(k + 1) % 3] -= noise;
            const std::vector<double> result = distances(tm, noisy);
            for(std::size_t i = 0; i < result.size(); ++i)
            {
              CHECK_NEAR(result[i], expected[i], 1e-14);
            }
            noisy = exact;
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
          Face_location noisy = exact;
          noisy.second[k] += noise;
          noisy.second[(k + 1) % 3] -= noise;
          const std::vector<double> result = distances(tm, noisy);
          for(std::size_t i = 0; i < result.size(); ++i)
          {
            CHECK_NEAR(result[i], expected[i], 1e-14);
          }
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

// Does the segment pq meet the open rectangle?
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
      sources_agree_with(tm, exact, 12, random);
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
    sources_agree_with(tm, distance_around(holes, corners), 6, random);
  }
  {
    test_support::Scope scope("L shape");
    const Mesh tm = to_face_graph(plane_cells("L shape", {"######", "######", "######", "###...", "###...", "###..."}));
    sources_agree_with(tm, distance_around({{3, 3, 6, 6}}, {{3, 3, 0}}), 12, random);
  }
  {
    test_support::Scope scope("notches");
    // notches cut into the border from both sides; the obstacles reach beyond it
    const Mesh tm = to_face_graph(plane_cells("notches", {"#####", "####.", "#####", ".####", "#####"}));
    const std::vector<Rectangle> notches{{4, 1, 6, 2}, {-1, 3, 1, 4}};
    sources_agree_with(tm, distance_around(notches, {{4, 1, 0}, {4, 2, 0}, {1, 3, 0}, {1, 4, 0}}), 8, random);
  }
}

// ---------------------------------------------------------------------------
// polyhedra
// ---------------------------------------------------------------------------

// Distance on the surface of the cube [0, n]^3 between points on it.
double distance_on_cube(const Coordinates& p, const Coordinates& q, double n)
{
  // A point in the frame of a face: the face's axis, and its side.
  auto is_on = [n](const Coordinates& point, std::size_t axis, std::size_t side) {
    return point[axis] == (side == 0 ? 0. : n);
  };
  double best = infinity;
  for(std::size_t axis = 0; axis < 3; ++axis)
  {
    for(std::size_t side = 0; side < 2; ++side)
    {
      if(!is_on(p, axis, side))
      {
        continue;
      }
      const std::size_t a = (axis + 1) % 3;
      const std::size_t b = (axis + 2) % 3;
      // same face
      if(is_on(q, axis, side))
      {
        best = (std::min)(best, std::hypot(p[a] - q[a], p[b] - q[b]));
      }
      // Height of q over the face of p.
      const double height = side == 0 ? q[axis] : n - q[axis];
      for(const auto& pair : {std::make_pair(a, b), std::make_pair(b, a)})
      {
        const std::size_t u = pair.first;  // across the edge that is left
        const std::size_t v = pair.second; // along that edge
        for(std::size_t u_side = 0; u_side < 2; ++u_side)
        {
          // distance of p and of q from the plane of the neighbouring face
          const double du = u_side == 0 ? p[u] : n - p[u];
          if(is_on(q, u, u_side))
          {
            // over the common edge
            best = (std::min)(best, std::hypot(du + height, p[v] - q[v]));
            // over the face at either end of the common edge
            for(std::size_t v_side = 0; v_side < 2; ++v_side)
            {
              const double dp = v_side == 0 ? p[v] : n - p[v];
              const double dq = v_side == 0 ? q[v] : n - q[v];
              best = (std::min)(best, std::hypot(du + dq, dp + height));
            }
          }
          if(is_on(q, axis, 1 - side))
          {
            // straight over one side face
            const double qu = u_side == 0 ? q[u] : n - q[u];
            best = (std::min)(best, std::hypot(du + n + qu, p[v] - q[v]));
            // over two side faces
            for(std::size_t v_side = 0; v_side < 2; ++v_side)
            {
              const double dp = v_side == 0 ? p[v] : n - p[v];
              const double dq = v_side == 0 ? q[v] : n - q[v];
              // leave through side u at height 0, arrive through side v at height n
              best = (std::min)(best, std::hypot(du + n + dq, dp + qu));
            }
          }
        }
      }
    }
  }
  return best;
}

void cubes_unfold(test_support::Random& random)
{
  test_support::Scope scope("cube");
  for(const std::size_t n : std::vector<std::size_t>{1, 2, 5})
  {
    const double side = static_cast<double>(n);
    const Mesh tm = to_face_graph(cube_grid(n));
    const Exact_distance exact = [side](const Coordinates& p, const Coordinates& q) {
      return distance_on_cube(p, q, side);
    };
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_FIELDS_CLOSE(distances(tm, v), expected_field(tm, coordinates(v, tm), exact), tolerance);
    }
    for(std::size_t i = 0; i < 30; ++i)
    {
      // Locations on the faces, which keep one coordinate exactly at 0 or n; others
      // are moved there, the sum of rounded weights times n may miss n.
      const Face_location location = random_location(tm, random);
      Coordinates p = coordinates(location, tm);
      for(double& c : p)
      {
        c = std::abs(c) < 1e-14 ? 0. : std::abs(c - side) < 1e-14 ? side : c;
      }
      CHECK_FIELDS_CLOSE(distances(tm, location), expected_field(tm, p, exact), tolerance);
    }
  }
  const Mesh unit = to_face_graph(cube());
  for(const vertex_descriptor v : vertices(unit))
  {
    std::vector<double> sorted = distances(unit, v);
    std::sort(sorted.begin(), sorted.end());
    const double r2 = std::sqrt(2.);
    CHECK_FIELDS_CLOSE(sorted, (std::vector<double>{0, 1, 1, 1, r2, r2, r2, std::sqrt(5.)}), 1e-15);
  }
}

// The regular tetrahedron is a quotient of the plane by the half-turns about the
// points of a triangular lattice: the distance is the minimum over the images.
void regular_tetrahedron_unfolds_onto_a_lattice(test_support::Random& random)
{
  test_support::Scope scope("regular tetrahedron");
  const Indexed_mesh indexed = midpoint_subdivision(regular_tetrahedron(), 3);
  const Mesh tm = to_face_graph(indexed);
  const double a = 2. * std::sqrt(2.); // the edge
  // The face of corners 0, 1, 2 lies in the plane; folding the other three about its
  // sides gives the big triangle whose corners are all vertex 3.
  const std::array<Coordinates, 4> corner{Coordinates{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const Coordinates x0{0, 0, 0};
  const Coordinates x1{a, 0, 0};
  const Coordinates x2{.5 * a, .5 * std::sqrt(3.) * a, 0};
  // The fourth vertex, once for each of the faces (0 1 3), (0 2 3), (1 2 3).
  const Coordinates x013 = x0 + x1 - x2;
  auto to_plane = [&](const Coordinates& p) {
    // barycentric coordinates in space; one of them vanishes
    std::array<double, 4> w{};
    for(std::size_t k = 0; k < 4; ++k)
    {
      w[k] = .25 * (1. + p[0] * corner[k][0] + p[1] * corner[k][1] + p[2] * corner[k][2]);
    }
    const std::size_t missing = static_cast<std::size_t>(std::min_element(w.begin(), w.end()) - w.begin());
    const Coordinates x3 = missing == 0 ? x1 + x2 - x0 : missing == 1 ? x0 + x2 - x1 : x013;
    Coordinates result{0, 0, 0};
    const std::array<Coordinates, 4> plane{x0, x1, x2, x3};
    for(std::size_t k = 0; k < 4; ++k)
    {
      if(k != missing)
      {
        result = result + w[k] * plane[k];
      }
    }
    return result;
  };
  const Exact_distance exact = [&](const Coordinates& p, const Coordinates& q) {
    const Coordinates s = to_plane(p);
    const Coordinates t = to_plane(q);
    double best = infinity;
    for(int i = -4; i <= 4; ++i)
    {
      for(int j = -4; j <= 4; ++j)
      {
        const Coordinates shift = (2. * i) * x1 + (2. * j) * x2;
        best = (std::min)(best, length(t + shift - s));
        best = (std::min)(best, length(shift - t - s));
      }
    }
    return best;
  };
  for(std::size_t i = 0; i < 40; ++i)
  {
    const vertex_descriptor v = random_vertex(tm, random);
    CHECK_FIELDS_CLOSE(distances(tm, v), expected_field(tm, coordinates(v, tm), exact), tolerance);
    const Face_location location = random_location(tm, random, .05);
    CHECK_FIELDS_CLOSE(distances(tm, location), expected_field(tm, coordinates(location, tm), exact), tolerance);
  }
}

void octahedron_and_icosahedron_unfold()
{
  {
    test_support::Scope scope("octahedron");
    const Mesh tm = to_face_graph(octahedron());
    for(const vertex_descriptor v : vertices(tm))
    {
      const std::size_t antipode = std::size_t(v) ^ 1u;
      const std::vector<double> result = distances(tm, v);
      for(std::size_t i = 0; i < 6; ++i)
      {
        CHECK_CLOSE(result[i], i == std::size_t(v) ? 0. : i == antipode ? std::sqrt(6.) : std::sqrt(2.), 1e-15);
      }
    }
    // Centre of a face with edge sqrt(2): the radius of the incircle is sqrt(6) / 6; each
    // far corner is the apex of an adjacent face, the height sqrt(6) / 2 further away.
    const std::vector<double> result =
      distances(tm, Face_location(face(0), {1. / 3., 1. / 3., 1. - 2. / 3.}));
    for(std::size_t i = 0; i < 6; ++i)
    {
      const bool is_corner = i == 0 || i == 2 || i == 4;
      CHECK_CLOSE(result[i], is_corner ? std::sqrt(6.) / 3. : 2. * std::sqrt(6.) / 3., 1e-15);
    }
  }
  {
    test_support::Scope scope("icosahedron");
    const Mesh tm = to_face_graph(icosahedron());
    // edge 2: five neighbours at 2, five over one edge at 2 sqrt(3), the antipode over
    // three faces: the image is one row and a half away
    for(const vertex_descriptor v : vertices(tm))
    {
      std::vector<double> sorted = distances(tm, v);
      std::sort(sorted.begin(), sorted.end());
      std::vector<double> expected{0., 2., 2., 2., 2., 2.};
      expected.insert(expected.end(), 5, 2. * std::sqrt(3.));
      expected.push_back(2. * std::sqrt(7.));
      CHECK_FIELDS_CLOSE(sorted, expected, 1e-15);
    }
  }
}

// ---------------------------------------------------------------------------
// developable surfaces
// ---------------------------------------------------------------------------

// n sectors of chord `chord` and slant 1 around an apex, in `rings` rings; the total
// angle may exceed 2 pi, so the mesh exists as edge lengths in the development only.
void cones_unroll(std::size_t n, std::size_t rings, double total_angle)
{
  test_support::Scope scope("cone of angle " + std::to_string(total_angle));
  const double sector = total_angle / static_cast<double>(n);
  Indexed_mesh indexed;
  indexed.name = "cone";
  indexed.points.push_back({0, 0, 0});
  std::vector<std::pair<double, double>> polar{{0., 0.}};
  for(std::size_t r = 1; r <= rings; ++r)
  {
    for(std::size_t i = 0; i < n; ++i)
    {
      indexed.points.push_back({0, 0, 0});
      polar.push_back({static_cast<double>(r) / static_cast<double>(rings), sector * static_cast<double>(i)});
    }
  }
  auto id = [n](std::size_t r, std::size_t i) { return 1 + (r - 1) * n + i % n; };
  for(std::size_t i = 0; i < n; ++i)
  {
    indexed.faces.push_back({0, id(1, i), id(1, i + 1)});
    for(std::size_t r = 1; r < rings; ++r)
    {
      indexed.faces.push_back({id(r, i), id(r + 1, i), id(r + 1, i + 1)});
      indexed.faces.push_back({id(r, i), id(r + 1, i + 1), id(r, i + 1)});
    }
  }
  auto exact = [&](std::size_t a, std::size_t b) {
    double angle = std::abs(polar[a].second - polar[b].second);
    angle = (std::min)(angle, total_angle - angle);
    const double ra = polar[a].first;
    const double rb = polar[b].first;
    if(angle >= pi)
    {
      return ra + rb;
    }
    // |ra - rb e^(i angle)| without cancellation
    const double s = std::sin(.5 * angle);
    return std::sqrt((ra - rb) * (ra - rb) + 4. * ra * rb * s * s);
  };
  Mesh tm = to_face_graph(indexed);
  auto lengths = tm.add_property_map<Mesh::Edge_index, double>("e:test_length", 0.).first;
  for(const auto e : edges(tm))
  {
    const auto h = halfedge(e, tm);
    lengths[e] = exact(std::size_t(source(h, tm)), std::size_t(target(h, tm)));
  }
  for(std::size_t s = 0; s < indexed.points.size(); s += 1 + n / 7)
  {
    std::vector<double> expected;
    for(std::size_t v = 0; v < indexed.points.size(); ++v)
    {
      expected.push_back(exact(s, v));
    }
    CHECK_FIELDS_CLOSE(distances_from_edge_lengths(tm, lengths, vertex(s)), expected, tolerance);
  }
}

// The prism tube of m sides: unrolled it is a strip of width m * chord, straight at
// both ends, hence convex.
void cylinders_unroll(test_support::Random& random)
{
  for(const std::size_t m : std::vector<std::size_t>{3, 4, 9, 40})
  {
    for(const std::size_t n : std::vector<std::size_t>{1, 4, 13})
    {
      for(const double height : {.05, 3., 30.})
      {
        test_support::Scope scope("cylinder " + std::to_string(m) + " x " + std::to_string(n));
        const Mesh tm = to_face_graph(prism_tube(m, n, 1., height));
        const double chord = 2. * std::sin(pi / static_cast<double>(m));
        const double width = chord * static_cast<double>(m);
        auto unrolled = [&](std::size_t i) {
          return Coordinates{chord * static_cast<double>(i % m),
                             height * static_cast<double>(i / m) / static_cast<double>(n), 0.};
        };
        auto expected_from = [&](const Coordinates& s) {
          std::vector<double> expected;
          for(std::size_t v = 0; v < num_vertices(tm); ++v)
          {
            double best = infinity;
            for(const double wrap : {-width, 0., width})
            {
              best = (std::min)(best, length(unrolled(v) + Coordinates{wrap, 0., 0.} - s));
            }
            expected.push_back(best);
          }
          return expected;
        };
        for(std::size_t i = 0; i < 4; ++i)
        {
          const vertex_descriptor v = random_vertex(tm, random);
          CHECK_FIELDS_CLOSE(distances(tm, v), expected_from(unrolled(std::size_t(v))), tolerance);
          const Face_location location = random_location(tm, random, .05);
          const auto corners = corners_of_face(location.first, tm);
          Coordinates p{0., 0., 0.};
          const Coordinates first = unrolled(std::size_t(corners[0]));
          for(std::size_t k = 0; k < 3; ++k)
          {
            Coordinates corner = unrolled(std::size_t(corners[k]));
            if(corner[0] - first[0] > .5 * width)
            {
              corner[0] -= width;
            }
            else if(first[0] - corner[0] > .5 * width)
            {
              corner[0] += width;
            }
            p = p + location.second[k] * corner;
          }
          // into the strip again, the mesh closes at column m
          if(p[0] < 0.)
          {
            p[0] += width;
          }
          CHECK_FIELDS_CLOSE(distances(tm, location), expected_from(p), tolerance);
        }
      }
    }
  }
}

// A torus with m x n vertices; the lattice is spanned by (a, 0) and (b, c). It has no
// flat embedding: all points are the origin, only the lengths count.
void flat_tori_are_minima_over_a_lattice(std::size_t m, std::size_t n, double a, double b, double c)
{
  test_support::Scope scope("flat torus " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c));
  Indexed_mesh indexed = torus(1., .4, m, n);
  for(Coordinates& p : indexed.points)
  {
    p = {0., 0., 0.};
  }
  Mesh tm = to_face_graph(indexed);
  auto position = [&](std::size_t v) {
    const double s = static_cast<double>(v / n) / static_cast<double>(m);
    const double t = static_cast<double>(v % n) / static_cast<double>(n);
    return Coordinates{a * s + b * t, c * t, 0.};
  };
  auto exact = [&](const Coordinates& p, const Coordinates& q) {
    double best = infinity;
    for(int j = -6; j <= 6; ++j)
    {
      const double nearest = -std::round((q[0] - p[0] + j * b) / a);
      for(const double i : {nearest - 1., nearest, nearest + 1.})
      {
        best = (std::min)(best, length(q - p + Coordinates{i * a + j * b, j * c, 0.}));
      }
    }
    return best;
  };
  // The edges of the grid: each lies in one cell, so its vector is known.
  auto step = [&](std::size_t from, std::size_t to) {
    const std::size_t di = (to / n + m - from / n) % m;
    const std::size_t dj = (to % n + n - from % n) % n;
    const double s = di == m - 1 ? -1. : static_cast<double>(di);
    const double t = dj == n - 1 ? -1. : static_cast<double>(dj);
    return Coordinates{a * s / static_cast<double>(m) + b * t / static_cast<double>(n),
                       c * t / static_cast<double>(n), 0.};
  };
  auto lengths = tm.add_property_map<Mesh::Edge_index, double>("e:test_length", 0.).first;
  for(const auto e : edges(tm))
  {
    const auto h = halfedge(e, tm);
    lengths[e] = length(step(std::size_t(source(h, tm)), std::size_t(target(h, tm))));
  }
  for(const std::size_t s : {std::size_t(0), m * n / 2 + 1, m * n - 1})
  {
    std::vector<double> expected;
    for(std::size_t v = 0; v < num_vertices(tm); ++v)
    {
      expected.push_back(exact(position(s), position(v)));
    }
    CHECK_FIELDS_CLOSE(distances_from_edge_lengths(tm, lengths, vertex(s)), expected, tolerance);
  }
  // a source inside a face
  const face_descriptor f = face(tm.number_of_faces() / 3);
  const auto corners = corners_of_face(f, tm);
  const std::array<double, 3> weights{.2, .5, .3};
  Coordinates p = position(std::size_t(corners[0]));
  for(std::size_t k = 1; k < 3; ++k)
  {
    p = p + weights[k] * step(std::size_t(corners[0]), std::size_t(corners[k]));
  }
  std::vector<double> expected;
  for(std::size_t v = 0; v < num_vertices(tm); ++v)
  {
    expected.push_back(exact(p, position(v)));
  }
  CHECK_FIELDS_CLOSE(distances_from_edge_lengths(tm, lengths, Face_location(f, weights)), expected, tolerance);
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20260102));
  flat_convex_patches_have_Euclidean_distances(random);
  flat_patches_with_coinciding_rows_have_Euclidean_distances();
  flat_patches_with_caps_have_Euclidean_distances();
  border_edges_serve_as_sources_at_any_parameter(random);
  sources_next_to_a_vertex_keep_their_place(random);
  noisy_barycentric_coordinates_are_the_point_they_mean();
  paths_in_the_plane_bend_at_corners(random);
  cubes_unfold(random);
  regular_tetrahedron_unfolds_onto_a_lattice(random);
  octahedron_and_icosahedron_unfold();
  for(const double total_angle : {1., 2., 3.5, 4.442, 6., 2. * pi, 6.5, 9., 20.})
  {
    cones_unroll(24, 1, total_angle);
    cones_unroll(36, 5, total_angle);
  }
  cylinders_unroll(random);
  flat_tori_are_minima_over_a_lattice(6, 6, 1., 0., 1.);
  flat_tori_are_minima_over_a_lattice(10, 7, 2., .3, .5);
  flat_tori_are_minima_over_a_lattice(12, 12, 1., .5, std::sqrt(3.) / 2.);
  flat_tori_are_minima_over_a_lattice(9, 11, 1., .25, 8.);
  // Edges wind around the torus, so that shortest paths cross each of them again and again, and more faces than there
  // are: this is the square torus of the first line.
  flat_tori_are_minima_over_a_lattice(5, 5, 1., 12., 1.);
  flat_tori_are_minima_over_a_lattice(3, 4, 1., 7., 1.);
  return test_result();
}
