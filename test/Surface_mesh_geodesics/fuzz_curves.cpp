// Distances from random curves on hostile surfaces, against the smallest distance from each of some vertices to a point
// of the curves. Where no sample comes near enough to the nearest point, as beside edges that are shorter than the
// curve by a factor of a million, the certificate decides. Arguments: the number of surfaces, and the seed.

#include "curve_cases.h"
#include "hostile_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace curve_cases;

namespace {

bool is_proved(const Mesh& tm, Distances& d, const std::vector<Curve>& curves)
{
  return CGAL::Surface_mesh_geodesics::certify_geodesic_distances(tm, boost::make_assoc_property_map(d), curves)
    .is_certified();
}

} // namespace

int main(int argc, char** argv)
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 20000;
  const std::uint64_t seed = test_support::announce_seed(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1);
  double worst = 0;
  std::size_t compared = 0, proved = 0, rejected = 0;
  for(std::uint64_t i = 0; i < number; ++i)
  {
    const test_support::Scope scope("surface " + std::to_string(seed + i));
    test_support::Random random(seed + i);
    Mesh tm;
    if(!hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm))
      continue;
    const std::vector<Curve> curves = random_curves(tm, random);
    Distances d;
    try
    {
      d = distances(tm, curves);
    }
    catch(const CGAL::Surface_mesh_geodesics::Invalid_geodesic_input&)
    {
      ++rejected; // segments that nearly coincide
      continue;
    }
    // No edge is a shortcut, beyond the rounding of the extent, as in error_at().
    const double rounding = 64 * std::numeric_limits<double>::epsilon() * extent(tm);
    for(const auto h : halfedges(tm))
      CHECK(d.at(target(h, tm))
            <= (d.at(source(h, tm)) + std::sqrt(CGAL::squared_distance(tm.point(source(h, tm)),
                                                                      tm.point(target(h, tm))))) * (1 + 1e-13)
                 + rounding);
    for(std::size_t j = 0; j < 3; ++j)
    {
      const vertex_descriptor v = random_vertex(tm, random);
      const double error = error_at(tm, curves, v, d.at(v));
      ++compared;
      if(error <= 1e-12)
        worst = (std::max)(worst, error);
      else if(CHECK(is_proved(tm, d, curves)))
        ++proved;
    }
  }
  CHECK(compared > 0);
  CHECK(200 * rejected <= number + 200);
  std::cout << compared << " distances, worst relative error " << worst << ", " << proved << " proved, " << rejected
            << " surfaces with curves that rounding hides" << std::endl;
  return test_result();
}
