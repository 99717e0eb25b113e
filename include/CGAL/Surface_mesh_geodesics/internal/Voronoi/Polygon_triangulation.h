// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_POLYGON_TRIANGULATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_POLYGON_TRIANGULATION_H

// Triangulates a small polygon whose sides and vertices must be kept, even if rounding has made it overlap itself, by
// dynamic programming over the diagonals (G. T. Klincsek, Minimal triangulations of polygonal domains, 1980).
//
// All triangulations of the cyclic sequence of vertices are candidates. The result has as few clockwise triangles as
// possible, then as few without area, and among these candidates the best shapes. In a simple polygon all triangles are
// counterclockwise, so that they do not overlap; for any other polygon the result still has the right combinatorics.
//
// The cost of a candidate is the pair of its badness (an integer, so that it is exact) and the sum of the shapes of its
// good triangles, compared in this order. Both add up over the parts on the two sides of a triangle, which is what
// dynamic programming needs.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The results are those of the last call of build(). The object is reused so that its arrays are allocated a few times
// only.
class Polygon_triangulation
{
public:
  using Point = Planar_point<double>;
  using Triangle = std::array<std::uint32_t, 3>;

  // Triangulates a polygon, given counterclockwise; triangles refer to the indices of its vertices. is_allowed(i, j)
  // tells whether a diagonal may be used; a forbidden one counts more than all triangles that are not counterclockwise.
  // Of equal candidates the one with the lowest apex is taken. Takes cubic time, and memory quadratic in the number of
  // vertices. A polygon of less than three vertices has no triangles.
  //
  // Formula: the cost of (i, j) is 0 for a side of the polygon, where j = i + 1, else the least sum of the costs of (i,
  // k), of (k, j) and of the triangle (i, k, j), over all k between i and j; FORBIDDEN is added for a diagonal that is
  // not allowed. The last pair, (0, n - 1), is a side again.
  template <typename IsAllowed>
  void build(const std::vector<Point>& polygon, IsAllowed is_allowed)
  {
    m_triangles.clear();
    m_badness = 0;
    const std::size_t n = polygon.size();
    if(n < 3)
      return;
    // At i * n + j: the cost and the apex for the part between the diagonal (i, j) and the sides i, ..., j.
    m_cost.assign(n * n, Cost());
    m_apex.assign(n * n, 0);
    for(std::size_t width = 2; width < n; ++width)
      for(std::size_t i = 0; i + width < n; ++i)
      {
        const std::size_t j = i + width;
        m_cost[i * n + j] = cheapest(polygon, i, j);
        if(width + 1 < n && !is_allowed(i, j))
          m_cost[i * n + j].badness += FORBIDDEN;
      }
    m_badness = m_cost[n - 1].badness;
    collect(0, static_cast<std::uint32_t>(n - 1), n);
  }

  const std::vector<Triangle>& triangles() const { return m_triangles; }

  // Returns 0 if all triangles are counterclockwise and all diagonals allowed, a larger number otherwise.
  std::uint64_t badness() const { return m_badness; }

  // Returns whether a badness, or a sum of some, stands for triangles that lie on others or for forbidden diagonals. It
  // is larger than that of any usual number of triangles without area then.
  static bool has_overlap(std::uint64_t badness) { return badness >= CLOCKWISE; }

private:
  // Above the number of bad triangles of any polygon that fits in memory. A sum of such terms, one for each diagonal,
  // does not overflow.
  static constexpr std::uint64_t FORBIDDEN = std::uint64_t(1) << 32;

  // The badness of a clockwise triangle, which lies on others. A triangle without area does no harm: its badness is 1.
  static constexpr std::uint64_t CLOCKWISE = std::uint64_t(1) << 10;

  struct Cost
  {
    std::uint64_t badness = 0;
    double shape = 0;

    void add(const Cost& other)
    {
      badness += other.badness;
      shape += other.shape;
    }

    bool is_less(const Cost& other) const
    {
      return badness != other.badness ? badness < other.badness : shape < other.shape;
    }
  };

  // Finds the apex of the triangle at the diagonal (i, j) for which the part behind the diagonal is cheapest, and
  // returns its cost. A triangle only adds to the cost, so an apex whose two parts are not cheaper than the best one is
  // skipped. Requires: all smaller parts are known.
  Cost cheapest(const std::vector<Point>& polygon, std::size_t i, std::size_t j)
  {
    const std::size_t n = polygon.size();
    CGAL_assertion(i + 1 < j && j < n);
    Cost best;
    best.badness = (std::numeric_limits<std::uint64_t>::max)();
    for(std::size_t k = i + 1; k < j; ++k)
    {
      Cost c = m_cost[i * n + k];
      c.add(m_cost[k * n + j]);
      if(!c.is_less(best))
        continue;
      c.add(cost(polygon[i], polygon[k], polygon[j]));
      if(c.is_less(best))
      {
        best = c;
        m_apex[i * n + j] = static_cast<std::uint32_t>(k);
      }
    }
    return best;
  }

  // Returns the cost of a triangle; its shape is the sum of the squares of the sides over twice the area, which is
  // smallest for equal sides. A triangle that is not counterclockwise beyond rounding is bad and has no shape.
  static Cost cost(const Point& a, const Point& b, const Point& c)
  {
    const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y, wx = c.x - b.x, wy = c.y - b.y;
    const double squares = ux * ux + uy * uy + vx * vx + vy * vy + wx * wx + wy * wy;
    const double area = ux * vy - uy * vx;
    Cost result;
    if(area > Tolerance<double>::area() * squares)
      result.shape = squares / area;
    else
      result.badness = area < -Tolerance<double>::area() * squares ? CLOCKWISE : 1;
    return result;
  }

  // Lists the triangles of the part between the diagonal (i, j) and the sides i, ..., j. Calls itself at most as deep
  // as the polygon has vertices.
  void collect(std::uint32_t i, std::uint32_t j, std::size_t n)
  {
    if(j < i + 2)
      return;
    const std::uint32_t k = m_apex[i * n + j];
    m_triangles.push_back(Triangle{i, k, j});
    collect(i, k, n);
    collect(k, j, n);
  }

  std::vector<Cost> m_cost;          // of the part of the diagonal (i, j), at i * n + j for i < j
  std::vector<std::uint32_t> m_apex; // of its triangle at that diagonal, if j > i + 1
  std::vector<Triangle> m_triangles;
  std::uint64_t m_badness = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_POLYGON_TRIANGULATION_H
