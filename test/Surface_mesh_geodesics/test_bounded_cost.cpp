// The number of windows is bounded on meshes full of ties, needles or coincident vertices.
//
// In theory an edge of a mesh with F faces has O(F) windows (Mitchell, Mount, Papadimitriou): adjacent windows of an
// edge come through different faces, and a vertex that both pass separates them. Fans of degree n and rows of thin
// faces reach this bound, because a line crosses all of their faces. Where faces are about equal, a line crosses about
// sqrt(F) faces, and no more windows are expected. So the number of windows per edge must not grow faster than F, or
// than sqrt(F), from one size to the next, with a margin of a quarter for effects of small sizes. It must also stay
// below twice the number measured when the limit was set. If a pruning rule fails, the number is many times as large.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

struct Cost
{
  double faces = 0.;
  double windows_per_edge = 0.; // windows that are propagated
  double visits_per_vertex = 0.;
};

Cost cost_of(const Mesh& tm, const std::vector<vertex_descriptor>& sources)
{
  SMG::Propagation_statistics statistics;
  Distance_options<Mesh> options;
  options.statistics = &statistics;
  const std::vector<double> d = distances_with_options(tm, sources, options);
  for(const double x : d)
  {
    CHECK(std::isfinite(x) && x >= 0.);
  }
  Cost cost;
  cost.faces = static_cast<double>(num_faces(tm));
  cost.windows_per_edge = static_cast<double>(statistics.windows_propagated) / static_cast<double>(num_edges(tm));
  cost.visits_per_vertex = static_cast<double>(statistics.vertices_visited) / static_cast<double>(num_vertices(tm));
  return cost;
}

enum class Sources
{
  ONE,
  ALL
};

enum class Faces
{
  EQUAL,
  THIN
};

// Checks three sizes of a family against the largest number of windows per edge.
void check_family(const std::string& name, Faces shape, double windows_per_edge,
                  const std::vector<Indexed_mesh>& sizes, Sources sources = Sources::ONE)
{
  test_support::Scope scope(name);
  std::vector<Cost> costs;
  for(const Indexed_mesh& indexed : sizes)
  {
    const Mesh tm = to_face_graph(indexed);
    if(sources == Sources::ALL)
    {
      costs.push_back(cost_of(tm, std::vector<vertex_descriptor>(vertices(tm).begin(), vertices(tm).end())));
    }
    else
    {
      // the more expensive of two sources: the first vertex and the middle vertex
      const Cost a = cost_of(tm, {vertex(0)}), b = cost_of(tm, {vertex(num_vertices(tm) / 2)});
      costs.push_back(a.windows_per_edge > b.windows_per_edge ? a : b);
    }
  }
  std::cout << "| " << name;
  for(const Cost& cost : costs)
  {
    std::cout << " | " << static_cast<std::size_t>(cost.faces) << ": " << std::setprecision(3)
              << cost.windows_per_edge << ", " << cost.visits_per_vertex;
  }
  std::cout << " | " << windows_per_edge << " |" << std::endl;
  for(std::size_t i = 0; i < costs.size(); ++i)
  {
    CHECK(costs[i].windows_per_edge <= windows_per_edge);
    if(i > 0)
    {
      // Numbers below one window per edge are too small to measure growth.
      const double before = (std::max)(1., costs[i - 1].windows_per_edge);
      const double ratio = costs[i].faces / costs[i - 1].faces;
      CHECK(costs[i].windows_per_edge <= 1.25 * before * (shape == Faces::THIN ? ratio : std::sqrt(ratio)));
    }
  }
}

// A sphere whose first vertices are pulled out: each becomes the tip of a needle.
Indexed_mesh spikes(std::size_t subdivisions, std::size_t number)
{
  Indexed_mesh mesh = icosphere(subdivisions);
  for(std::size_t i = 0; i < number; ++i)
  {
    mesh.points[i] = 6. * mesh.points[i];
  }
  return mesh;
}

// Moves every third vertex onto a neighbor that has not been moved. The result has edges without length and faces
// without area.
Indexed_mesh with_coincident_vertices(const Indexed_mesh& mesh)
{
  Indexed_mesh result = mesh;
  for(const Triangle& t : mesh.faces)
  {
    for(std::size_t k = 0; k < 3; ++k)
    {
      if(t[k] % 3 == 0 && t[(k + 1) % 3] % 3 != 0)
      {
        result.points[t[k]] = mesh.points[t[(k + 1) % 3]];
      }
    }
  }
  return result;
}

// Sorts points and faces, since their order in a convex hull depends on addresses.
Indexed_mesh sorted(const Indexed_mesh& mesh)
{
  Indexed_mesh result = mesh;
  std::sort(result.points.begin(), result.points.end());
  for(Triangle& t : result.faces)
  {
    for(std::size_t& v : t)
    {
      const auto position = std::lower_bound(result.points.begin(), result.points.end(), mesh.points[v]);
      v = static_cast<std::size_t>(position - result.points.begin());
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(result.faces.begin(), result.faces.end());
  return result;
}

Indexed_mesh random_convex_hull(std::size_t number, std::uint64_t seed)
{
  test_support::Random random(seed);
  std::vector<Kernel::Point_3> points;
  while(points.size() < number)
  {
    const Coordinates p{random.uniform(-1., 1.), random.uniform(-1., 1.), random.uniform(-1., 1.)};
    const double r = length(p);
    if(r > .1 && r < 1.)
    {
      points.push_back(Kernel::Point_3(p[0] / r, p[1] / r, p[2] / r));
    }
  }
  Mesh tm;
  CGAL::convex_hull_3(points.begin(), points.end(), tm);
  return sorted(to_indexed_mesh(tm, "random convex hull"));
}

template <class Make>
std::vector<Indexed_mesh> three(const Make& make, std::size_t a, std::size_t b, std::size_t c)
{
  return {make(a), make(b), make(c)};
}

template <class Make>
std::vector<Indexed_mesh> subdivided(const Make& mesh, std::size_t first)
{
  return three([&](std::size_t n) { return midpoint_subdivision(mesh, n); }, first, first + 1, first + 2);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260311);
  std::cout << "| family | faces: windows per edge, visits per vertex | | | windows per edge at most |\n"
            << "|---|---|---|---|--:|" << std::endl;
  check_family("Schwarz lanterns", Faces::THIN, 54.,
               {Schwarz_lantern(8, 16), Schwarz_lantern(16, 64), Schwarz_lantern(32, 256)});
  check_family("flat lanterns", Faces::THIN, 240.,
               {Schwarz_lantern(6, 60), Schwarz_lantern(6, 240), Schwarz_lantern(6, 960)});
  check_family("needle spheres", Faces::THIN, 70.,
               three([](std::size_t n) { return needle_sphere(n, 6); }, 24, 96, 384));
  check_family("cones", Faces::THIN, 1.5, three(cone_fan, 100, 1000, 10000));
  check_family("saddles", Faces::THIN, .1, three(saddle_fan, 100, 1000, 10000));
  check_family("flat fans", Faces::THIN, 1., three([](std::size_t n) { return fan("", n, 0., 0.); }, 100, 1000, 10000));
  check_family("bipyramids", Faces::THIN, 780., three([](std::size_t n) { return bipyramid(n, .5); }, 100, 400, 1600));
  check_family("doubly covered polygons", Faces::THIN, 860.,
               three([](std::size_t n) { return bipyramid(n, 0.); }, 100, 400, 1600));
  check_family("doubly covered square, subdivided", Faces::EQUAL, 28., subdivided(bipyramid(4, 0.), 4));
  check_family("cube, subdivided", Faces::EQUAL, 33., subdivided(cube(), 4));
  check_family("polycube, subdivided", Faces::EQUAL, 73., subdivided(genus_2_polycube(), 4));
  check_family("spikes", Faces::EQUAL, 27., {spikes(3, 12), spikes(4, 42), spikes(5, 162)});
  check_family("spikes everywhere", Faces::EQUAL, 90., {spikes(2, 42), spikes(3, 162), spikes(4, 642)});
  check_family("strips of squares", Faces::EQUAL, 1., three(strip, 100, 1000, 10000));
  check_family("grids of squares", Faces::EQUAL, 23.,
               three([](std::size_t n) { return flat_patch(n, n, 0., false, 1); }, 20, 40, 80));
  check_family("grids, random diagonals", Faces::EQUAL, 28.,
               three([&](std::size_t n) { return flat_patch(n, n, 0., true, seed); }, 20, 40, 80));
  check_family("spheres, all vertices are sources", Faces::EQUAL, 1.4, three(icosphere, 3, 4, 5), Sources::ALL);
  check_family("spheres, coincident vertices", Faces::EQUAL, 22.,
               three([](std::size_t n) { return with_coincident_vertices(icosphere(n)); }, 2, 3, 4));
  check_family("grids, coincident vertices", Faces::EQUAL, 12.,
               three([](std::size_t n) { return with_coincident_vertices(flat_patch(n, n, 0., false, 1)); }, 10, 20,
                     40));
  check_family("random convex hulls", Faces::EQUAL, 27.,
               three([&](std::size_t n) { return random_convex_hull(n, seed); }, 250, 1000, 4000));
  return test_result();
}
