// Prints a hash of the bits of all answers on each mesh: distances, those of Parallel_tag (visits in batches, whose
// bits do not depend on the number of threads), lengths and points of paths, arcs of a geodesic Voronoi diagram.
// scripts/check_determinism.sh compares what differently compiled programs print.
// Usage: print_hashes MESH...

#include "../include/several_threads.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;

// The FNV-1a hash of the bits of all numbers added.
class Hash
{
public:
  void add(double number)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    for(int i = 0; i < 8; ++i)
    {
      m_value = (m_value ^ ((bits >> (8 * i)) & 255u)) * 1099511628211u;
    }
  }

  void add(const Kernel::Point_3& p)
  {
    add(p.x());
    add(p.y());
    add(p.z());
  }

  friend std::ostream& operator<<(std::ostream& out, const Hash& hash)
  {
    return out << std::hex << std::setw(16) << std::setfill('0') << hash.m_value << std::dec << std::setfill(' ');
  }

private:
  std::uint64_t m_value = 14695981039346656037u;
};

// vertices spread over the mesh
std::vector<Mesh::Vertex_index> some_vertices(const Mesh& mesh, std::size_t number)
{
  const std::size_t n = num_vertices(mesh);
  std::vector<Mesh::Vertex_index> result;
  for(std::size_t i = 0; i < number && i < n; ++i)
  {
    result.emplace_back(static_cast<Mesh::size_type>(i * n / (number < n ? number : n)));
  }
  return result;
}

template <typename Tag>
Hash hash_of_distances(Mesh& mesh)
{
  Hash hash;
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0.).first;
  for(const std::size_t number : {std::size_t(1), std::size_t(10)})
  {
    CGAL::Surface_mesh_geodesics::geodesic_distances<Tag>(mesh, distance, some_vertices(mesh, number));
    for(const Mesh::Vertex_index v : vertices(mesh))
    {
      hash.add(distance[v]);
    }
  }
  return hash;
}

Hash hash_of_paths(const Mesh& mesh)
{
  Hash hash;
  Paths paths(mesh);
  paths.add_source_point(*faces(mesh).begin(), {0.25, 0.375, 0.375});
  std::size_t i = 0;
  for(const Mesh::Face_index f : faces(mesh))
  {
    if(i++ % (1 + num_faces(mesh) / 500) == 0)
    {
      std::vector<Kernel::Point_3> points;
      hash.add(paths.shortest_path_points_to_source_points(f, {0.5, 0.125, 0.375}, std::back_inserter(points)).first);
      for(const Kernel::Point_3& p : points)
      {
        hash.add(p);
      }
    }
  }
  return hash;
}

Hash hash_of_diagram(const Mesh& mesh)
{
  Hash hash;
  Diagram diagram(mesh);
  double weight = 0.;
  for(const Mesh::Vertex_index v : some_vertices(mesh, 10))
  {
    diagram.add_site(v, weight);
    weight += 1e-5;
  }
  for(const auto& arc : diagram.arcs())
  {
    for(const double t : {0., 0.5, 1.})
    {
      hash.add(diagram.point(arc.point(t)));
      hash.add(arc.distance(t));
    }
  }
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
  {
    hash.add(diagram.area(i));
  }
  return hash;
}

} // namespace

int main(int argc, char* argv[])
{
  for(int i = 1; i < argc; ++i)
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(argv[i], mesh) || !CGAL::is_triangle_mesh(mesh) || is_empty(mesh))
    {
      std::cerr << argv[i] << " is no triangle mesh" << std::endl;
      return EXIT_FAILURE;
    }
    const std::string name = argv[i];
    std::cout << name.substr(name.find_last_of('/') + 1) << " distances "
              << hash_of_distances<CGAL::Sequential_tag>(mesh) << " in batches "
              << hash_of_distances<test_support::Visits_in_batches>(mesh) << " paths " << hash_of_paths(mesh)
              << " diagram " << hash_of_diagram(mesh) << std::endl;
  }
}
