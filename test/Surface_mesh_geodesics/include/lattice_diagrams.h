#ifndef TEST_LATTICE_DIAGRAMS_H
#define TEST_LATTICE_DIAGRAMS_H

// Diagrams of curves on flat grids whose points are those of a lattice (lattice_curves.h). Weights are often the
// distance of two ends, so that bisectors are rays.

#include "Voronoi_test_helpers.h"
#include "curve_cases.h"
#include "curves_in_plane.h"
#include "lattice_curves.h"

#include <CGAL/Polygon_mesh_processing/locate.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lattice_diagrams {

using namespace curve_cases;
using namespace lattice_curves;

// What the cases of a run have in common. The lattice divides each edge of a face into this number of parts; with a
// jitter, the vertices of the grid are not on a lattice themselves.
struct Lattice
{
  std::size_t parts;
  double jitter;
  bool has_weights;
  std::size_t most_points = 3; // of a curve
};

inline Point_2 point(const Mesh& tm, const Location& l)
{
  const auto p = CGAL::Polygon_mesh_processing::construct_point(l, tm);
  return {p.x(), p.y()};
}

inline double distance_from(const Mesh& tm, const std::vector<Location>& curve, const Point_2& p)
{
  double smallest = distance_to_segment(p, point(tm, curve.front()), point(tm, curve.front()));
  for(std::size_t i = 1; i < curve.size(); ++i)
    smallest = std::min(smallest, distance_to_segment(p, point(tm, curve[i - 1]), point(tm, curve[i])));
  return smallest;
}

// Sites on the grid, most of them in one face.
struct Sites
{
  std::vector<std::vector<Location>> curves;
  std::vector<double> weights;
};

inline double lattice_weight(const Mesh& tm, const Lattice& lattice, const Sites& sites, std::size_t i,
                             test_support::Random& random)
{
  const std::size_t kind = lattice.has_weights ? random.index(4) : 0;
  if(kind == 0)
    return 0;
  if(kind == 1)
    return static_cast<double>(random.index(4)) / static_cast<double>(lattice.parts);
  const std::vector<Location>&first = sites.curves[0], &curve = sites.curves[i];
  const Point_2 p = point(tm, first[random.index(first.size())]);
  const Point_2 q = point(tm, curve[random.index(curve.size())]);
  const double d = std::hypot(p[0] - q[0], p[1] - q[1]);
  return kind == 2 ? d : -d;
}

inline Sites random_sites(const Mesh& tm, const Lattice& lattice, test_support::Random& random)
{
  Sites sites{random_curves(tm, lattice.parts, lattice.most_points, random), {}};
  const std::size_t n = sites.curves.size();
  sites.weights.assign(n, 0.);
  for(std::size_t i = 1; i < n; ++i)
    sites.weights[i] = lattice_weight(tm, lattice, sites, i, random);
  return sites;
}

// A random mesh and random sites: the same for the same seed.
struct Lattice_case
{
  test_support::Random random;
  Mesh mesh;
  Sites sites;

  Lattice_case(const Lattice& lattice, std::uint64_t seed)
    : random(seed), mesh(to_face_graph(flat_patch(3 + random.index(2), 3, lattice.jitter, true, seed % 7))),
      sites(random_sites(mesh, lattice, random))
  {}

  void add_sites_to(Voronoi& diagram) const
  {
    for(std::size_t i = 0; i < sites.curves.size(); ++i)
      diagram.add_site(Curve(mesh, sites.curves[i]), sites.weights[i]);
  }
};

} // namespace lattice_diagrams

#endif // TEST_LATTICE_DIAGRAMS_H
