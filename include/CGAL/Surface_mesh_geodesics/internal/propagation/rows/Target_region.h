// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_TARGET_REGION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_TARGET_REGION_H

// Prunes a run from a vertex s that needs the distances of some targets only. A visit of a vertex v is skipped if no
// shortest path to a target leads through the star of v. Proof, with the landmarks l of Landmark_distances.h:
//
// - The windows that wait in the star are not nearer than the key k of the visit. So a path to a target t through them
//   passes a point p of the star with d(s, p) >= k, and d(s, t) = d(s, p) + d(p, t). The radius r of the star bounds
//   d(v, p).
// - By the triangle inequality, d(p, t) >= d(l, p) - d(l, t) >= d(l, v) - r - d(l, t), and
//   d(p, t) >= d(l, t) - d(l, p) >= d(l, t) - d(l, v) - r.
// - Let u(t) be an upper bound of d(s, t). So the path exists only if for every landmark
//     k - r + d(l, v) <= u(t) + d(l, t)   and   k - r - d(l, v) <= u(t) - d(l, t).
//
// The targets are in groups, by their nearest landmark. The right sides are replaced by their maxima over a group; a
// visit is needed if both inequalities hold for all landmarks and some group. Upper bounds are d(l, s) + d(l, t), and
// the length of a path that the run has found. As the run goes on, targets with final distances drop out and bounds
// become smaller: the maxima are computed anew each time when the number of visits since the last time reaches half of
// the number of targets that are left, so the cost of each visit is constant (amortized). If no visit is skipped
// between two such times, the targets lie all around, and the run goes on without pruning.
//
// Skipped windows are never part of the paths that are measured, so distances have the bits of a run without pruning.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/Landmark_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Target_region
{
public:
  using Landmarks = Landmark_distances<FT>;

  // The landmarks are referred to.
  explicit Target_region(const Landmarks& landmarks) : m_landmarks(landmarks) {}

  // Begins a run from source i to the sources behind it, as far as they are in its component. `sources` are those of
  // the landmarks. Linear in the number of these targets.
  void begin(const std::vector<Vertex_id>& sources, std::size_t i)
  {
    m_is_useful = true;
    m_targets.clear();
    const typename Landmarks::Entry& from = m_landmarks[sources[i]];
    for(const std::size_t k : m_landmarks.component_of(i))
      if(k >= i)
        m_targets.push_back(Target{sources[k], least_sum(from, m_landmarks[sources[k]])});
    update();
  }

  // Returns whether a shortest path to a target may lead through the star of v at a distance of at least `key`.
  // `distance` has the distances of all vertices found so far; those that are clearly less than `key` are final.
  bool is_needed(Vertex_id v, const FT& key, const std::vector<FT>& distance)
  {
    if(!m_is_useful)
      return true;
    if(++m_visits > m_targets.size() / 2 + 16)
    {
      m_is_useful = m_skipped > 0;
      drop_final_targets(key, distance);
      update();
    }
    const typename Landmarks::Entry& at = m_landmarks[v];
    const float nearest = static_cast<float>(key) - at.back();
    // Neighboring visits mostly have their reason in one group.
    if(m_groups[m_last_group].may_reach(at, nearest))
      return true;
    for(std::size_t g = 0; g < Landmarks::number; ++g)
      if(m_groups[g].may_reach(at, nearest))
      {
        m_last_group = g;
        return true;
      }
    ++m_skipped;
    return false;
  }

private:
  // One that is not known to be final.
  struct Target
  {
    Vertex_id vertex;
    float most; // an upper bound of the distance
  };

  // The maxima of u(t) + d(l, t) and u(t) - d(l, t) over the targets of a group, for all landmarks.
  struct Group
  {
    typename Landmarks::Entry sum, difference; // the last numbers have no meaning, and are never exceeded

    void clear()
    {
      sum.fill(-std::numeric_limits<float>::infinity());
      difference = sum;
      sum.back() = difference.back() = std::numeric_limits<float>::infinity();
    }

    // Rounding of single precision is relative to the sum.
    void add(const typename Landmarks::Entry& target, float most)
    {
      for(std::size_t l = 0; l < target.size(); ++l)
      {
        const float s = most + target[l], margin = s * relative_margin;
        sum[l] = (std::max)(sum[l], s + margin);
        difference[l] = (std::max)(difference[l], most - target[l] + margin);
      }
    }

    // (Without a branch inside, as vectors of landmarks are compared.)
    bool may_reach(const typename Landmarks::Entry& at, float nearest) const
    {
      int violated = 0;
      for(std::size_t l = 0; l < at.size(); ++l)
        violated += static_cast<int>(nearest + at[l] > sum[l])
                    + static_cast<int>(nearest - at[l] > difference[l]);
      return violated == 0;
    }
  };

  static constexpr float relative_margin = 1e-6f; // some units of rounding

  // The least length of the ways over a landmark.
  static float least_sum(const typename Landmarks::Entry& a, const typename Landmarks::Entry& b)
  {
    float least = std::numeric_limits<float>::infinity();
    for(std::size_t l = 0; l < Landmarks::number; ++l)
      least = (std::min)(least, a[l] + b[l]);
    return least;
  }

  // Also takes over the lengths of paths that the run has found, which are upper bounds.
  void drop_final_targets(const FT& key, const std::vector<FT>& distance)
  {
    std::size_t left = 0;
    for(const Target& target : m_targets)
    {
      const FT& d = distance[target.vertex];
      if(!is_clearly_less<FT>(d, key))
        m_targets[left++] = Target{target.vertex, (std::min)(target.most, static_cast<float>(d))};
    }
    m_targets.resize(left);
  }

  // Computes the maxima of all groups from the targets that are left.
  void update()
  {
    for(Group& group : m_groups)
      group.clear();
    for(const Target& target : m_targets)
      m_groups[m_landmarks.nearest(target.vertex)].add(m_landmarks[target.vertex], target.most);
    m_visits = m_skipped = 0;
  }

  const Landmarks& m_landmarks;
  std::vector<Target> m_targets;
  std::array<Group, Landmarks::number> m_groups;
  std::size_t m_last_group = 0;
  std::size_t m_visits = 0;   // since the last update
  std::size_t m_skipped = 0;  // among these visits
  bool m_is_useful = true;    // false for the rest of a run that has skipped no visit between two updates
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_TARGET_REGION_H
