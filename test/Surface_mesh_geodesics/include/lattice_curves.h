#ifndef TEST_LATTICE_CURVES_H
#define TEST_LATTICE_CURVES_H

// Curves whose points are those of a lattice in the faces of a mesh: they share points and segments, cross and continue
// each other, and run along edges.

#include "Voronoi_test_helpers.h"
#include "curve_cases.h"

#include <cstddef>
#include <vector>

namespace lattice_curves {

using curve_cases::Location;
using curve_cases::Mesh;
using Face = boost::graph_traits<Mesh>::face_descriptor;

inline Location lattice_point(Face f, std::size_t parts, test_support::Random& random)
{
  const std::size_t a = random.index(parts + 1), b = random.index(parts + 1 - a);
  const double n = static_cast<double>(parts);
  return Location(f, {static_cast<double>(a) / n, static_cast<double>(b) / n, static_cast<double>(parts - a - b) / n});
}

// Makes two to four curves, each in one face, most of them in the same one. The lattice divides each edge into `parts`.
inline std::vector<std::vector<Location>> random_curves(const Mesh& tm, std::size_t parts, std::size_t most_points,
                                                        test_support::Random& random)
{
  std::vector<std::vector<Location>> curves;
  const std::size_t n = 2 + random.index(3), number_of_faces = num_faces(tm);
  const Face shared(static_cast<Face::size_type>(random.index(number_of_faces)));
  for(std::size_t i = 0; i < n; ++i)
  {
    const Face f = random.index(3) != 0 ? shared : Face(static_cast<Face::size_type>(random.index(number_of_faces)));
    std::vector<Location> curve;
    for(std::size_t m = 1 + random.index(most_points); m > 0; --m)
      curve.push_back(lattice_point(f, parts, random));
    curves.push_back(curve);
  }
  return curves;
}

// Calls visit(location) for lattice points and random ones in all faces.
template <typename Visit>
void for_each_query(const Mesh& tm, test_support::Random& random, Visit visit)
{
  for(const Face f : faces(tm))
  {
    for(int i = 0; i <= 8; ++i)
      for(int j = 0; i + j <= 8; ++j)
        visit(Location(f, {i / 8., j / 8., (8 - i - j) / 8.}));
    for(int i = 0; i < 20; ++i)
    {
      const double s = random.uniform(), t = random.uniform() * (1 - s);
      visit(Location(f, {1 - s - t, s, t}));
    }
  }
}

} // namespace lattice_curves

#endif // TEST_LATTICE_CURVES_H
