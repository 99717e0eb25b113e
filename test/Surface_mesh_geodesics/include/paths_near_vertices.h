#ifndef SURFACE_MESH_GEODESICS_PATHS_NEAR_VERTICES_H
#define SURFACE_MESH_GEODESICS_PATHS_NEAR_VERTICES_H

// Paths where rounding decides on which side of a vertex a line passes: sources and queries very near vertices,
// on faces that are up to a million times longer than wide.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <vector>

namespace paths_near_vertices {

using namespace test_meshes;

// Sets coordinates to zero that the class treats as zero, because snapping would move the point.
inline void clear_small_coordinates(std::array<double, 3>& b)
{
  const auto largest = std::max_element(b.begin(), b.end());
  double others = 0.;
  for(auto x = b.begin(); x != b.end(); ++x)
  {
    if(x != largest)
    {
      *x = *x < 1.5e-14 ? 0. : *x;
      others += *x;
    }
  }
  *largest = 1. - others;
}

inline Geodesic_paths::Face_location location_near_vertex(const Mesh& tm, test_support::Random& random)
{
  const double part = std::pow(10., random.uniform(-14., -4.));
  const double share = random.uniform() * (random.index(3) == 0 ? 1e-3 : 1.);
  std::array<double, 3> b{1. - part, part * share, part * (1. - share)};
  clear_small_coordinates(b);
  std::rotate(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(random.index(3)), b.end());
  return {random_location(tm, random).first, {b[0], b[1], b[2]}};
}

inline Surface_point random_query(const Mesh& tm, test_support::Random& random)
{
  switch(random.index(6))
  {
  case 0:
    return Surface_point(random_vertex(tm, random));
  case 1:
    return Surface_point(location_near_vertex(tm, random));
  default:
    return Surface_point(random_location(tm, random));
  }
}

inline Coordinates point_of(const Surface_point& p, const Geodesic_paths& paths)
{
  return p.is_vertex() ? to_coordinates(paths.point(p.vertex))
                       : to_coordinates(paths.point(p.location.first, p.location.second));
}

struct Worst
{
  double path = 0., distance = 0.;
};

// Queries some paths. Checks that each is as long as its distance.
inline void check_paths(Geodesic_paths& paths, const Mesh& tm, bool is_convex_and_flat, test_support::Random& random,
                        Worst& worst)
{
  const double size = size_of(tm);
  std::vector<Coordinates> sources;
  const std::size_t number_of_sources = random.index(4) == 0 ? 2 : 1;
  for(std::size_t i = 0; i < number_of_sources; ++i)
  {
    const Geodesic_paths::Face_location s = location_near_vertex(tm, random);
    paths.add_source_point(s);
    sources.push_back(to_coordinates(paths.point(s.first, s.second)));
  }
  for(int i = 0; i < 20; ++i)
  {
    const Surface_point q = random_query(tm, random);
    std::vector<Kernel::Point_3> points;
    const Answer answer = ask_points(paths, q, std::back_inserter(points));
    std::vector<Coordinates> polyline;
    for(const Kernel::Point_3& p : points)
    {
      polyline.push_back(to_coordinates(p));
    }
    if(answer.distance < 0.)
    {
      CHECK(points.empty());
      continue;
    }
    // the coordinates of points are rounded, and barycentric coordinates below 1.4e-14 are treated as zero
    const double rounding = 6e-14 * size;
    const double path_error = std::abs(polyline_length(polyline) - answer.distance);
    if(!CHECK(path_error <= 1e-10 * answer.distance + rounding))
    {
      std::cout << "  " << description(q) << ": path " << polyline_length(polyline) << ", distance " << answer.distance
                << "\n";
    }
    worst.path = (std::max)(worst.path, (path_error - rounding) / (answer.distance + rounding));
    if(is_convex_and_flat)
    {
      double straight = std::numeric_limits<double>::infinity();
      for(const Coordinates& s : sources)
      {
        straight = (std::min)(straight, length(s - point_of(q, paths)));
      }
      // Windows narrower than 1e-13 of their edge are dropped. So are windows that rounding does not show to be shorter
      // than a path through a vertex. That costs accuracy at points very near the gap.
      const double sliver = 1e-12 * size;
      const double error = std::abs(straight - answer.distance);
      if(!CHECK(error <= 1e-9 * straight + sliver))
      {
        std::cout << "  " << description(q) << ": straight " << straight << ", distance " << answer.distance << "\n";
      }
      worst.distance = (std::max)(worst.distance, (error - sliver) / (straight + sliver));
    }
  }
}

// Makes m x n cells of size dx x dy, each cut along one of its diagonals.
inline Indexed_mesh rectangle(std::size_t m, std::size_t n, double dx, double dy, test_support::Random& random)
{
  Indexed_mesh mesh;
  mesh.name = "rectangle";
  for(std::size_t j = 0; j <= n; ++j)
  {
    for(std::size_t i = 0; i <= m; ++i)
    {
      mesh.points.push_back({static_cast<double>(i) * dx, static_cast<double>(j) * dy, 0.});
    }
  }
  for(std::size_t j = 0; j < n; ++j)
  {
    for(std::size_t i = 0; i < m; ++i)
    {
      const std::size_t a = j * (m + 1) + i, b = a + 1, d = a + m + 1, c = d + 1;
      add_quadrilateral(mesh, a, b, c, d, random.index(2) == 0);
    }
  }
  return mesh;
}

inline void paths_in_rectangles_of_long_faces_are_found(std::size_t number, test_support::Random& random)
{
  Worst worst;
  for(std::size_t i = 0; i < number; ++i)
  {
    std::ostringstream name;
    name << "rectangle " << i;
    test_support::Scope scope(name.str());
    const double width = std::pow(10., random.uniform(-6., 0.));
    const bool is_flipped = random.index(2) == 0;
    const std::size_t m = 1 + random.index(4), n = 1 + random.index(4);
    const Mesh tm = to_face_graph(rectangle(m, n, is_flipped ? width : 1., is_flipped ? 1. : width, random));
    Geodesic_paths paths(tm);
    check_paths(paths, tm, true, random, worst);
  }
  std::cout << number << " rectangles, relative errors beyond rounding: path " << worst.path << ", distance "
            << worst.distance << "\n";
}

// Checks other meshes, squeezed in a random direction.
inline void paths_on_squeezed_meshes_are_found(std::size_t number, test_support::Random& random)
{
  Worst worst;
  const std::vector<Indexed_mesh> meshes = small_collection(20260408);
  for(std::size_t i = 0; i < number; ++i)
  {
    const Indexed_mesh& mesh = meshes[random.index(meshes.size())];
    std::ostringstream name;
    name << mesh.name << " " << i;
    test_support::Scope scope(name.str());
    const double angle = random.uniform(), first = std::pow(10., random.uniform(-6., 0.)),
                 second = std::pow(10., random.uniform(-3., 0.));
    const std::size_t axis = random.index(3);
    const Mesh tm = to_face_graph(transformed(mesh, mesh.name, [&](const Coordinates& p)
    {
      Coordinates q{std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1],
                    p[2]};
      q[axis] *= first;
      q[(axis + 1) % 3] *= second;
      return q;
    }));
    Geodesic_paths paths(tm);
    check_paths(paths, tm, false, random, worst);
  }
  std::cout << number << " squeezed meshes, relative error of paths beyond rounding: " << worst.path << "\n";
}

} // namespace paths_near_vertices

#endif // SURFACE_MESH_GEODESICS_PATHS_NEAR_VERTICES_H
