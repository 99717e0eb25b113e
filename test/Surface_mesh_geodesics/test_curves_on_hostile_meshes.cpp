// Distances from random curves on hostile meshes, against the smallest distance from a vertex to a point of the curves.
// fuzz_curves.cpp does the same with many more surfaces.

#include "curve_cases.h"
#include "hostile_meshes.h"
#include "test_support.h"

#include <cstdint>
#include <string>
#include <vector>

using namespace curve_cases;
using CGAL::Surface_mesh_geodesics::Invalid_geodesic_input;

namespace {

void distances_are_right()
{
  for_each_hostile_case([](const Mesh& tm, const std::vector<Curve>& curves, test_support::Random& random)
  {
    const Distances d = distances(tm, curves);
    const vertex_descriptor v = random_vertex(tm, random);
    CHECK(error_at(tm, curves, v, d.at(v)) <= 1e-12);
  });
}

// Random surfaces on which earlier versions failed. 116: segments nearly coincide, and the walk along one of them did
// not end; now the curves may be rejected. 50085: windows of a vertex beside an edge of the length 1e-6 were left out
// although a shortest path needed one. 11148: the same beside a source at the distance 1e-10. 3009, 16982: strips
// turned by a wrong angle beside an edge of the length 1e-11, and distances were too small. 70995: a distance was
// negative. 12479: a corner of a curve on an edge, in front of a flat face, emitted nothing.
void faults_do_not_come_back()
{
  for(const std::uint64_t seed : {116u, 50085u, 11148u, 3009u, 16982u, 70995u, 12479u})
  {
    const test_support::Scope scope("surface " + std::to_string(seed));
    test_support::Random random(seed);
    Mesh tm;
    CHECK(hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm));
    const std::vector<Curve> curves = random_curves(tm, random);
    try
    {
      const Distances d = distances(tm, curves);
      for(const vertex_descriptor v : vertices(tm))
        CHECK(d.at(v) >= 0 && error_at(tm, curves, v, d.at(v)) <= 1e-12);
    }
    catch(const Invalid_geodesic_input& error)
    {
      CHECK(error.reason() == Invalid_geodesic_input::Reason::INVALID_CURVE && seed == 116);
    }
  }
}

} // namespace

int main()
{
  distances_are_right();
  faults_do_not_come_back();
  return test_result();
}
