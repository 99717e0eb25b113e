// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_PARTNERS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_PARTNERS_H

// Finds the fronts of a list that may be the other end of a given one.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Cell_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The partners of a front have the same two cells, on their other sides: the two ends of a curve are partners. In most
// faces there are two or four fronts, which are compared one by one. Where hundreds of cells cross a face, nearly all
// pairs of fronts have other cells; so after some searches in a longer list, its fronts are sorted by their cells.
template <typename FT>
class Front_partners
{
public:
  using Front = Cell_front<FT>;

  // Begins with a list: it is another one, or the number, the order or the cells of its fronts have changed.
  void restart()
  {
    m_sorted.clear();
    m_number_of_searches = 0;
  }

  // Returns the first partner of front i with an index of at least j and for which is_wanted(index) holds; the number
  // of fronts if there is none. For n fronts, m searches take time O(n log n + m log n), plus that of the partners that
  // they ask about; a few searches take time O(n) each. Requires: j is at most the number of fronts; all calls since
  // restart() are about one list.
  template <typename IsWanted>
  std::size_t first(const std::vector<Front>& fronts, std::size_t i, std::size_t j, IsWanted is_wanted)
  {
    const Front& f = fronts[i];
    if(fronts.size() <= few || ++m_number_of_searches <= few)
    {
      while(j < fronts.size() && !(fronts[j].left == f.right && fronts[j].right == f.left && is_wanted(j)))
        ++j;
      return j;
    }
    if(m_sorted.empty())
      sort(fronts);
    for(auto it = std::lower_bound(m_sorted.begin(), m_sorted.end(), Entry{f.right, f.left, j});
        it != m_sorted.end() && it->left == f.right && it->right == f.left; ++it)
      if(is_wanted(it->index))
        return it->index;
    return fronts.size();
  }

private:
  static constexpr std::size_t few = 16;

  struct Entry
  {
    Vertex_id left, right;
    std::size_t index;

    friend bool operator<(const Entry& a, const Entry& b)
    {
      return std::tie(a.left, a.right, a.index) < std::tie(b.left, b.right, b.index);
    }
  };

  void sort(const std::vector<Front>& fronts)
  {
    for(std::size_t i = 0; i < fronts.size(); ++i)
      m_sorted.push_back(Entry{fronts[i].left, fronts[i].right, i});
    std::sort(m_sorted.begin(), m_sorted.end());
  }

  std::vector<Entry> m_sorted; // empty as long as fronts are compared one by one
  std::size_t m_number_of_searches = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_PARTNERS_H
