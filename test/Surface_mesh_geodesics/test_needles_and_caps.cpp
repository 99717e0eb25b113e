// Faces without area or nearly so, and edges without length or nearly so: small random meshes with collapsed vertices
// and caps, moved by 1e-15 to 1e-9, and polygons squeezed to slivers. Each of them gave a wrong distance once.

#include "distance_test_helpers.h"
#include "distances_with_rules.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Delaunay_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <limits>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

std::vector<long double> distances_in_long_double(const Mesh& tm, vertex_descriptor source)
{
  auto map = get(CGAL::dynamic_vertex_property_t<long double>(), tm);
  distances_with_rules<SMG::internal::All_pruning_rules, long double>(tm, map, source,
                                                                      Distance_options<Mesh>());
  std::vector<long double> result;
  for(const vertex_descriptor v : vertices(tm))
  {
    result.push_back(get(map, v));
  }
  return result;
}

void distances_are_right(const std::string& name)
{
  test_support::Scope scope(name);
  const Mesh tm = load_data(name);
  std::vector<std::vector<double>> all;
  for(const vertex_descriptor s : vertices(tm))
  {
    all.push_back(distances(tm, s));
  }
  for(const vertex_descriptor s : vertices(tm))
  {
    const std::vector<long double> more_digits = distances_in_long_double(tm, s);
    for(const vertex_descriptor v : vertices(tm))
    {
      const double d = all[std::size_t(s)][std::size_t(v)];
      // the distance is the same with other rounding and from the other end, and not shorter than in space
      CHECK(std::abs(d - static_cast<double>(more_digits[std::size_t(v)])) <= 1e-12 * (1 + d));
      CHECK(std::abs(d - all[std::size_t(v)][std::size_t(s)]) <= 1e-12 * (1 + d));
      CHECK(d >= length(coordinates(s, tm) - coordinates(v, tm)) - 1e-12);
    }
  }
}

// A saddle z = x y, squeezed in x by 1e-11 and flattened: all faces are slivers, folded onto each other. Each vertex
// has a path along the edges, but all windows to some vertices were once lost to rounding.
void all_vertices_are_reached()
{
  test_support::Scope scope("flattened saddle");
  Indexed_mesh mesh;
  const std::size_t n = 15;
  for(std::size_t c = 0; c < n; ++c)
  {
    for(std::size_t j = 0; j < n; ++j)
    {
      const double x = (static_cast<double>(c) - 7) * 1.578217088527334e-11;
      const double z = -(7 - static_cast<double>(c)) * 3.4038340961305637e-4 * (static_cast<double>(j) - 7);
      mesh.points.push_back({x, 0, z});
    }
  }
  for(std::size_t c = 0; c + 1 < n; ++c)
  {
    for(std::size_t j = 0; j + 1 < n; ++j)
    {
      const std::size_t a = n * c + j;
      add_quadrilateral(mesh, a, a + n, a + n + 1, a + 1);
    }
  }
  const Mesh tm = to_face_graph(mesh);
  for(const std::size_t source : {60u, 0u, 112u, 200u})
  {
    const vertex_descriptor s(static_cast<Mesh::size_type>(source));
    const std::vector<double> d = distances(tm, s);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK(d[std::size_t(v)] < std::numeric_limits<double>::infinity());
      CHECK(d[std::size_t(v)] >= length(coordinates(s, tm) - coordinates(v, tm)) * (1 - 1e-12));
    }
  }
}

using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

// Flips random edges of quadrangles that are convex.
void flip_edges(Triangulation& t, std::size_t number, test_support::Random& random)
{
  for(std::size_t i = 0; i < number; ++i)
  {
    const std::vector<Triangulation::Edge> edges(t.finite_edges_begin(), t.finite_edges_end());
    const auto [f, k] = edges[random.index(edges.size())];
    const auto g = f->neighbor(k);
    if(t.is_infinite(f) || t.is_infinite(g))
      continue;
    const Kernel::Point_2 &p = f->vertex(k)->point(), &q = g->vertex(g->index(f))->point();
    if(CGAL::left_turn(p, f->vertex(t.ccw(k))->point(), q) && CGAL::left_turn(q, f->vertex(t.cw(k))->point(), p))
      t.tds().flip(f, k);
  }
}

// Some triangulation of a convex polygon with points inside; x may crowd near 0.
Triangulation random_triangulation(std::size_t number, bool is_crowded, test_support::Random& random)
{
  Triangulation t;
  while(t.number_of_vertices() < number || t.dimension() < 2)
  {
    const double u = random.uniform(), x = is_crowded ? u * u * u * u : u;
    t.insert(Kernel::Point_2(std::floor(1024 * x), std::floor(1024 * random.uniform())));
  }
  flip_edges(t, 200, random);
  return t;
}

Mesh squeezed(const Triangulation& t, double factor)
{
  Mesh tm;
  std::map<Triangulation::Vertex_handle, vertex_descriptor> number;
  for(const auto v : t.finite_vertex_handles())
    number[v] = tm.add_vertex(Kernel::Point_3(v->point().x(), factor * v->point().y(), 0));
  for(const auto f : t.finite_face_handles())
    tm.add_face(number[f->vertex(0)], number[f->vertex(1)], number[f->vertex(2)]);
  return tm;
}

// A convex polygon in the plane, squeezed until its faces have a height of 2^-14 to 2^-34 of their lengths: all
// shortest paths are straight. Around 2^-26, a path along a vertex is as long as the one beside it, and the one beside
// it was lost once: distances were up to four times as long.
void squeezed_polygons()
{
  test_support::Random random(20261129);
  for(std::size_t i = 0; i < 60; ++i)
  {
    const Triangulation t = random_triangulation(5 + random.index(35), i % 2 == 0, random);
    for(const int e : {14, 20, 23, 24, 25, 26, 27, 28, 30, 34})
    {
      const test_support::Scope scope("polygon " + std::to_string(i) + ", squeezed by 2^-" + std::to_string(e));
      const Mesh tm = squeezed(t, std::ldexp(1., -e));
      for(const vertex_descriptor s : vertices(tm))
      {
        const std::vector<double> d = distances(tm, s);
        for(const vertex_descriptor v : vertices(tm))
          CHECK_NEAR(d[std::size_t(v)], length(coordinates(s, tm) - coordinates(v, tm)), 1e-12 * 1024);
      }
    }
  }
}

} // namespace

int main()
{
  squeezed_polygons();
  all_vertices_are_reached();
  for(const char* name :
      {"cap_A_9682", "cap_source_in_front", "caps_back_to_back", "caps_two_rotated", "needle_1e-12",
       "needle_1e-12b", "needle_1e-15", "needle_B_3828", "needle_B_6574", "needle_B_6892"})
  {
    distances_are_right(name);
  }
  return test_result();
}
