// Two sites that are very near to each other, whose weights differ by nearly as much as they are apart: the curve
// between their cells is a hyperbola that hardly differs from a ray. And cells that are tiny beside the mesh.

#include "Voronoi_test_helpers.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Newton_refinement.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace {

using namespace test_meshes;
namespace internal = CGAL::Surface_mesh_geodesics::internal;
using Point = internal::Planar_point<double>;
using Focus = internal::Additively_weighted_point<double>;

Coordinates in_space(const Mesh& tm, face_descriptor f, const std::array<double, 3>& b)
{
  const auto h = tm.halfedge(f);
  return b[0] * coordinates(tm.source(h), tm) + b[1] * coordinates(tm.target(h), tm)
       + b[2] * coordinates(tm.target(tm.next(h)), tm);
}

bool is_certified(const Voronoi& diagram)
{
  return CGAL::Surface_mesh_geodesics::certify_geodesic_Voronoi_diagram(diagram).is_certified();
}

// The point at distance r from the focus `left`, on the bisector of two points at distance d.
Point point_of_bisector(double d, double s, double r)
{
  // r + s = distance from (d, 0)
  const double cosine = (d * d - s * s - 2 * r * s) / (2 * r * d);
  return {r * cosine, r * std::sqrt(1 - cosine * cosine)};
}

// Points of a thin hyperbola far from its foci: their directions differ by less than rounding tells, their distances
// from the focus do not.
void far_points_of_bisector_are_found()
{
  test_support::Scope scope("angles of far points");
  for(const double d : {1e-2, 1e-4, 1e-6, 1e-8})
  {
    for(const double ratio : {-.9, -.3, 0., .5, .8})
    {
      const double s = ratio * d;
      const Focus left{0, 0, s}, right{d, 0, 0};
      for(const double start : {10 * d, .05, 1.})
      {
        const Point p = point_of_bisector(d, s, start);
        // the two halves of the curve
        for(const bool is_turned : {false, true})
        {
          const internal::Weighted_bisector<double> curve(is_turned ? right : left, is_turned ? left : right, p);
          for(const double factor : {.2, .5, .9, 1.5, 4.})
          {
            const Point q = point_of_bisector(d, s, factor * start);
            const double angle = curve.is_curved() ? curve.angle_near(q) : 0.;
            if(angle > 0)
            {
              // Across the curve, p and q are known up to the rounding of the distances over their gradient.
              const double tolerance = 1e-13 + 1e-14 * start * (1 + factor) * start / d;
              CHECK_NEAR(internal::distance(curve.point_at_angle(angle), q), 0., tolerance);
            }
          }
        }
      }
    }
  }
}

// Steps of Newton's method do not lead past the points that distances are measured from.
void refinement_stays_near_the_points()
{
  const Focus a{0, 0, 0}, b{1.7e-12, 6e-13, 0};
  const internal::Half_plane<double> line = internal::Half_plane<double>::left_of({.01, -.9}, {-1e-13, 0});
  for(const double x : {0., 1e-16, 1e-13, -1e-13, 1e-12})
  {
    const Point p{x, x / 2};
    CHECK(internal::distance(internal::polished_intersection(a, b, line, p, 1.), p) <= 1e-11);
  }
}

struct Counts
{
  std::size_t number_of_diagrams = 0, number_of_both_cells = 0;
};

// One diagram of two sites in a face, on an edge or at a corner, about e apart.
void check_two_sites(const Mesh& tm, double e, test_support::Random& random, Counts& counts)
{
  const face_descriptor f = random_location(tm, random).first;
  const std::size_t kind = random.index(4);
  const double x = kind < 2 ? random.uniform(.1, .5) : 0., y = kind % 2 == 0 ? random.uniform(.1, .4) : 0.;
  const double dx = random.index(3) == 0 ? 0. : e * random.uniform(.2, 1.);
  const double dy = random.index(3) == 0 && dx > 0 ? 0. : e * random.uniform(.2, 1.);
  const std::array<double, 3> a{1 - x - y, x, y}, b{1 - (x + dx) - (y + dy), x + dx, y + dy};
  const double apart = length(in_space(tm, f, a) - in_space(tm, f, b));
  const std::array<double, 8> ratios{0., .5, .999, .99999, 1 - 1e-6, 1 - 1e-10, 1., 1 + 1e-7};
  const double weight = apart * ratios[random.index(ratios.size())];
  const bool is_first_heavy = random.index(2) == 0;
  Voronoi diagram(tm);
  diagram.add_site(Face_location(f, {a[0], a[1], a[2]}), is_first_heavy ? weight : 0.);
  diagram.add_site(Face_location(f, {b[0], b[1], b[2]}), is_first_heavy ? 0. : weight);
  if(random.index(2) == 0)
  {
    diagram.add_site(Face_location(random_location(tm, random).first, {.2, .3, .5}));
  }
  test_support::Scope scope("apart by " + std::to_string(apart * 1e12) + "e-12, kind " + std::to_string(kind));
  CHECK(is_certified(diagram));
  ++counts.number_of_diagrams;
  counts.number_of_both_cells += !diagram.is_empty(0) && !diagram.is_empty(1);
}

void near_sites_are_divided(std::size_t number, std::uint64_t seed)
{
  test_support::Random random(seed);
  const Mesh tm = to_face_graph(rough_terrain(5, .7, seed));
  Counts counts;
  for(int exponent = 2; exponent <= 14; ++exponent)
  {
    for(std::size_t i = 0; i < number; ++i)
    {
      check_two_sites(tm, std::pow(10., -exponent), random, counts);
    }
  }
  CHECK_EQUAL(counts.number_of_diagrams, 13 * number);
  CHECK(4 * counts.number_of_both_cells > counts.number_of_diagrams);
}

// Where no distance tells which of two sites is nearer, the one with the lower index owns the cell; where one is
// nowhere nearer beyond rounding, the other one does, whatever the indices are.
void ties_follow_the_rule()
{
  const Mesh tm = to_face_graph(flat_patch(4, 4, 0., false, 1));
  const face_descriptor f(7);
  const auto empty = [&](double apart, double first_weight, double second_weight)
  {
    Voronoi diagram(tm);
    diagram.add_site(Face_location(f, {.4, .3, .3}), first_weight);
    diagram.add_site(Face_location(f, {.4 - apart, .3 + apart, .3}), second_weight);
    CHECK(is_certified(diagram));
    return std::array<bool, 2>{diagram.is_empty(0), diagram.is_empty(1)};
  };
  const std::array<bool, 2> first{true, false}, second{false, true}, none{false, false};
  CHECK(empty(1e-15, 0., 0.) == second);
  CHECK(empty(1e-14, 0., 0.) == second);
  CHECK(empty(1e-9, 0., 0.) == none);
  const double d = 1e-3 * length(in_space(tm, f, {1., 0., 0.}) - in_space(tm, f, {0., 1., 0.}));
  CHECK(empty(1e-3, 0., d) == first);
  CHECK(empty(1e-3, d, 0.) == second);
  CHECK(empty(1e-3, 0., d - 1e-16) == first);
  CHECK(empty(1e-3, d - 1e-16, 0.) == second);
  CHECK(empty(1e-3, 0., d - 1e-11) == none);
  CHECK(empty(1e-3, d - 1e-11, 0.) == none);
  CHECK(empty(1e-3, 0., 2 * d) == first);
}

// A site between four others at a distance of 1e-9: its cell is a square around it.
void tiny_cells_have_centroids()
{
  test_support::Scope scope("tiny cells");
  const Mesh tm = to_face_graph(transformed(flat_patch(4, 4, 0., false, 1), "moved",
                                            [](const Coordinates& c) { return c + Coordinates{.3, .4, .5}; }));
  const double e = 1e-9;
  for(const face_descriptor f : {face_descriptor(7), face_descriptor(12)})
  {
    const Coordinates u = in_space(tm, f, {-1., 1., 0.}), v = in_space(tm, f, {-1., 0., 1.});
    Voronoi diagram(tm);
    const std::array<double, 3> b{.41, .31, .28};
    diagram.add_site(Face_location(f, {b[0], b[1], b[2]}));
    for(const std::array<double, 2>& d : {std::array<double, 2>{e, 0}, {-e, 0}, {0, e}, {0, -e}})
    {
      diagram.add_site(Face_location(f, {b[0] - d[0] - d[1], b[1] + d[0], b[2] + d[1]}));
    }
    const auto c = diagram.centroid(0);
    const Coordinates p = in_space(tm, f, b);
    CHECK_NEAR(c.x(), p[0], 1e-15);
    CHECK_NEAR(c.y(), p[1], 1e-15);
    CHECK_NEAR(c.z(), p[2], 1e-15);
    // The cell of one of a lattice of points. Barycentric coordinates are rounded to about 1e-7 of it.
    const Coordinates n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    if(std::abs(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) < 1e-12)
    {
      CHECK_CLOSE(diagram.area(0), length(n) * e * e, 1e-5);
    }
    CHECK(diagram.area(0) > 0);
  }
}

} // namespace

// The number of diagrams for each distance and a seed may be given as arguments.
int main(int argc, char* argv[])
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 40;
  const std::uint64_t seed = test_support::announce_seed(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 20260811);
  far_points_of_bisector_are_found();
  refinement_stays_near_the_points();
  near_sites_are_divided(number, seed);
  ties_follow_the_rule();
  tiny_cells_have_centroids();
  return test_result();
}
