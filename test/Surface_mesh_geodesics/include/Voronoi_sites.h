#ifndef SURFACE_MESH_GEODESICS_VORONOI_SITES_H
#define SURFACE_MESH_GEODESICS_VORONOI_SITES_H

// Sites of diagrams, with weights, and the distances from each of them alone.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace test_meshes {

using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Paths_traits>;
using Shortest_path = CGAL::Surface_mesh_shortest_path<Paths_traits>;
using halfedge_descriptor = boost::graph_traits<Mesh>::halfedge_descriptor;
using Edge_lengths = Mesh::Property_map<Mesh::Edge_index, double>;

const std::size_t null_site = Voronoi::null_site();

struct Weighted_site
{
  Surface_point point;
  double weight = 0.;

  Weighted_site(const Surface_point& p, double w = 0.) : point(p), weight(w) {}
  Weighted_site(vertex_descriptor v, double w = 0.) : point(v), weight(w) {}
  Weighted_site(const Face_location& l, double w = 0.) : point(l), weight(w) {}
};

using Weighted_sites = std::vector<Weighted_site>;

template <typename Diagram>
void add_sites(Diagram& diagram, const Weighted_sites& sites)
{
  for(const Weighted_site& s : sites)
  {
    if(s.point.is_vertex())
    {
      diagram.add_site(s.point.vertex, s.weight);
    }
    else
    {
      diagram.add_site(s.point.location, s.weight);
    }
  }
}

inline double area_of_face(const Mesh& tm, face_descriptor f)
{
  const auto corner = corners_of_face(f, tm);
  const Coordinates p = coordinates(corner[0], tm);
  return length(cross(coordinates(corner[1], tm) - p, coordinates(corner[2], tm) - p)) / 2.;
}

// The distances from each single site, minus its weight, by Surface_mesh_geodesic_paths. On request, compares those of
// sites at vertices with Surface_mesh_shortest_path.
class Distances_of_sites
{
public:
  Distances_of_sites(const Mesh& tm, const Weighted_sites& sites, const Edge_lengths* lengths = nullptr,
                     bool compares_with_shortest_path = false)
    : m_sites(sites)
  {
    for(const Weighted_site& s : sites)
    {
      m_paths.push_back(std::make_unique<Geodesic_paths>(tm));
      if(lengths != nullptr)
      {
        m_paths.back()->use_edge_lengths(*lengths);
      }
      add(*m_paths.back(), s.point);
      m_paths.back()->build_sequence_tree_for_faces();
      m_originals.emplace_back();
      if(compares_with_shortest_path && s.point.is_vertex())
      {
        m_originals.back() = std::make_unique<Shortest_path>(tm);
        m_originals.back()->add_source_point(s.point.vertex);
      }
    }
  }

  // Returns infinity if the site does not reach the point.
  double without_weight(std::size_t i, const Surface_point& q)
  {
    const Geodesic_paths& paths = *m_paths[i];
    const double d = ask(paths, q).distance;
    if(m_originals[i] != nullptr && is_safe(q))
    {
      const double expected = ask(*m_originals[i], q).distance;
      ++m_number_of_comparisons;
      CHECK_NEAR(d, expected, 1e-11 * (std::max)(d, expected));
    }
    return d < 0. ? infinity : d;
  }

  double operator()(std::size_t i, const Surface_point& q) { return without_weight(i, q) - m_sites[i].weight; }

  std::vector<double> all(const Surface_point& q)
  {
    std::vector<double> result;
    for(std::size_t i = 0; i < m_paths.size(); ++i)
    {
      result.push_back((*this)(i, q));
    }
    return result;
  }

  std::size_t number_of_comparisons() const { return m_number_of_comparisons; }

private:
  // Surface_mesh_shortest_path may be wrong at points that are on an edge up to rounding.
  static bool is_safe(const Surface_point& q)
  {
    const auto& b = q.location.second;
    return q.is_vertex() || (std::min)({b[0], b[1], b[2]}) > 1e-5;
  }

  Weighted_sites m_sites;
  std::vector<std::unique_ptr<Geodesic_paths>> m_paths;
  std::vector<std::unique_ptr<Shortest_path>> m_originals;
  std::size_t m_number_of_comparisons = 0;
};


// Returns a random vertex, a random point of an edge, or a random point in a face.
inline Surface_point random_point(const Mesh& tm, test_support::Random& random)
{
  const std::size_t kind = random.index(3);
  if(kind == 0)
  {
    return Surface_point(random_vertex(tm, random));
  }
  Face_location l = random_location(tm, random);
  if(kind == 1)
  {
    const std::size_t k = random.index(3);
    l.second[k] = random.uniform(.05, .95);
    l.second[(k + 1) % 3] = 1. - l.second[k];
    l.second[(k + 2) % 3] = 0.;
  }
  return Surface_point(l);
}

inline Weighted_sites random_sites(const Mesh& tm, std::size_t number, double largest_weight,
                                   test_support::Random& random)
{
  Weighted_sites sites;
  for(std::size_t i = 0; i < number; ++i)
  {
    const Surface_point p = random_point(tm, random);
    sites.emplace_back(p, largest_weight == 0. ? 0. : random.uniform(-largest_weight, largest_weight));
  }
  return sites;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_VORONOI_SITES_H
