// Surfaces on which distances are known: polyhedra that unfold by hand, and cones, cylinders and flat tori that exist
// as edge lengths only. Flat surfaces: test_distances_in_the_plane.cpp.

#include "distance_test_helpers.h"
#include "exact_distances.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;

// ---------------------------------------------------------------------------
// polyhedra
// ---------------------------------------------------------------------------

// The surface of the cube [0, n]^3, laid out around one face.
class Cube_surface
{
public:
  explicit Cube_surface(double n) : m_n(n) {}

  // Returns the distance of two points of the surface, the smallest over all unfoldings.
  double distance(const Coordinates& p, const Coordinates& q) const
  {
    double best = infinity;
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      for(std::size_t side = 0; side < 2; ++side)
      {
        if(is_on(p, axis, side))
        {
          best = (std::min)(best, distance_from_face(p, axis, side, q));
        }
      }
    }
    return best;
  }

private:
  bool is_on(const Coordinates& p, std::size_t axis, std::size_t side) const
  {
    return p[axis] == (side == 0 ? 0. : m_n);
  }

  // The distance of p from the plane of a face.
  double height(const Coordinates& p, std::size_t axis, std::size_t side) const
  {
    return side == 0 ? p[axis] : m_n - p[axis];
  }

  // Returns the distance over the unfoldings that begin in one face of p, given by its axis and its side.
  double distance_from_face(const Coordinates& p, std::size_t axis, std::size_t side, const Coordinates& q) const
  {
    const std::size_t a = (axis + 1) % 3;
    const std::size_t b = (axis + 2) % 3;
    double best = is_on(q, axis, side) ? std::hypot(p[a] - q[a], p[b] - q[b]) : infinity;
    for(std::size_t u_side = 0; u_side < 2; ++u_side)
    {
      for(const auto& pair : {std::make_pair(a, b), std::make_pair(b, a)})
      {
        if(is_on(q, pair.first, u_side))
        {
          best = (std::min)(best, distance_to_side_face(p, axis, side, q, pair.first, u_side, pair.second));
        }
        if(is_on(q, axis, 1 - side))
        {
          best = (std::min)(best, distance_to_opposite_face(p, q, pair.first, u_side, pair.second));
        }
      }
    }
    return best;
  }

  // Returns the distance to a point of the face across the edge at side u_side of axis u. Axis v is along that edge.
  double distance_to_side_face(const Coordinates& p, std::size_t axis, std::size_t side, const Coordinates& q,
                               std::size_t u, std::size_t u_side, std::size_t v) const
  {
    const double du = height(p, u, u_side);
    const double height_of_q = height(q, axis, side);
    // over the common edge
    double best = std::hypot(du + height_of_q, p[v] - q[v]);
    // over the face at either end of the common edge
    for(std::size_t v_side = 0; v_side < 2; ++v_side)
    {
      best = (std::min)(best, std::hypot(du + height(q, v, v_side), height(p, v, v_side) + height_of_q));
    }
    return best;
  }

  // Returns the distance to a point of the opposite face over paths that first cross the face at side u_side of axis u.
  double distance_to_opposite_face(const Coordinates& p, const Coordinates& q, std::size_t u, std::size_t u_side,
                                   std::size_t v) const
  {
    const double du = height(p, u, u_side);
    const double qu = height(q, u, u_side);
    // straight over that face
    double best = std::hypot(du + m_n + qu, p[v] - q[v]);
    // over that face and an adjacent one: leaves through side u at height 0, arrives through side v at height n
    for(std::size_t v_side = 0; v_side < 2; ++v_side)
    {
      best = (std::min)(best, std::hypot(du + m_n + height(q, v, v_side), height(p, v, v_side) + qu));
    }
    return best;
  }

  double m_n;
};

void cubes_unfold(test_support::Random& random)
{
  test_support::Scope scope("cube");
  for(const std::size_t n : std::vector<std::size_t>{1, 2, 5})
  {
    const double side = static_cast<double>(n);
    const Mesh tm = to_face_graph(cube_grid(n));
    const Exact_distance exact = [side](const Coordinates& p, const Coordinates& q) {
      return Cube_surface(side).distance(p, q);
    };
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_FIELDS_CLOSE(distances(tm, v), expected_field(tm, coordinates(v, tm), exact), tolerance);
    }
    for(std::size_t i = 0; i < 30; ++i)
    {
      // The location is on a face, but rounding may move its coordinate away from 0 or n. It moves back here.
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
    // Center of a face with edge sqrt(2): the radius of the incircle is sqrt(6) / 6; each
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
    // edge 2: five neighbors at 2, five over one edge at 2 sqrt(3), the antipode over
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

// n sectors of slant 1 around an apex, in `rings` rings. The total angle may exceed 2 pi, so the mesh is given by the
// edge lengths of its development.
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
      add_quadrilateral(indexed, id(r, i), id(r + 1, i), id(r + 1, i + 1), id(r, i + 1));
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
          // back into the strip, because the mesh closes at column m
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

// A flat torus of m x n vertices, whose lattice is spanned by (a, 0) and (b, c). It has no flat embedding: all points
// are the origin, and only the lengths count.
class Flat_torus
{
public:
  Flat_torus(std::size_t m, std::size_t n, double a, double b, double c) : m_m(m), m_n(n), m_a(a), m_b(b), m_c(c)
  {
    Indexed_mesh indexed = torus(1., .4, m, n);
    for(Coordinates& p : indexed.points)
    {
      p = {0., 0., 0.};
    }
    mesh = to_face_graph(indexed);
    lengths = mesh.add_property_map<Mesh::Edge_index, double>("e:test_length", 0.).first;
    for(const auto e : edges(mesh))
    {
      const auto h = halfedge(e, mesh);
      lengths[e] = length(step(std::size_t(source(h, mesh)), std::size_t(target(h, mesh))));
    }
  }

  Coordinates position(std::size_t v) const
  {
    const double s = static_cast<double>(v / m_n) / static_cast<double>(m_m);
    const double t = static_cast<double>(v % m_n) / static_cast<double>(m_n);
    return {m_a * s + m_b * t, m_c * t, 0.};
  }

  // The vector of an edge of the grid. Each edge lies in one cell, so the vector is known.
  Coordinates step(std::size_t from, std::size_t to) const
  {
    const std::size_t di = (to / m_n + m_m - from / m_n) % m_m;
    const std::size_t dj = (to % m_n + m_n - from % m_n) % m_n;
    const double s = di == m_m - 1 ? -1. : static_cast<double>(di);
    const double t = dj == m_n - 1 ? -1. : static_cast<double>(dj);
    return {m_a * s / static_cast<double>(m_m) + m_b * t / static_cast<double>(m_n), m_c * t / static_cast<double>(m_n),
            0.};
  }

  std::vector<double> distances_from(const Coordinates& p) const
  {
    std::vector<double> result;
    for(std::size_t v = 0; v < num_vertices(mesh); ++v)
    {
      result.push_back(distance(p, position(v)));
    }
    return result;
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, double> lengths;

private:
  double distance(const Coordinates& p, const Coordinates& q) const
  {
    double best = infinity;
    for(int j = -6; j <= 6; ++j)
    {
      const double nearest = -std::round((q[0] - p[0] + j * m_b) / m_a);
      for(const double i : {nearest - 1., nearest, nearest + 1.})
      {
        best = (std::min)(best, length(q - p + Coordinates{i * m_a + j * m_b, j * m_c, 0.}));
      }
    }
    return best;
  }

  std::size_t m_m, m_n;
  double m_a, m_b, m_c;
};

void flat_tori_are_minima_over_a_lattice(std::size_t m, std::size_t n, double a, double b, double c)
{
  test_support::Scope scope("flat torus " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c));
  const Flat_torus flat(m, n, a, b, c);
  const Mesh& tm = flat.mesh;
  for(const std::size_t s : {std::size_t(0), m * n / 2 + 1, m * n - 1})
  {
    CHECK_FIELDS_CLOSE(distances_from_edge_lengths(tm, flat.lengths, vertex(s)),
                       flat.distances_from(flat.position(s)), tolerance);
  }
  // a source inside a face
  const face_descriptor f = face(tm.number_of_faces() / 3);
  const auto corners = corners_of_face(f, tm);
  const std::array<double, 3> weights{.2, .5, .3};
  Coordinates p = flat.position(std::size_t(corners[0]));
  for(std::size_t k = 1; k < 3; ++k)
  {
    p = p + weights[k] * flat.step(std::size_t(corners[0]), std::size_t(corners[k]));
  }
  CHECK_FIELDS_CLOSE(distances_from_edge_lengths(tm, flat.lengths, Face_location(f, weights)),
                     flat.distances_from(p), tolerance);
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20260106));
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
  // This is the square torus of the first line. Here the edges wind around it, so shortest paths cross each of them
  // many times, and cross more faces than the torus has.
  flat_tori_are_minima_over_a_lattice(5, 5, 1., 12., 1.);
  flat_tori_are_minima_over_a_lattice(3, 4, 1., 7., 1.);
  return test_result();
}
