#ifndef SURFACE_MESH_GEODESICS_CELL_TEST_HELPERS_H
#define SURFACE_MESH_GEODESICS_CELL_TEST_HELPERS_H

// What the tests of single cells share: the class of diagrams, a length to compare with, and diagrams full of ties.

#include "mesh_operations.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace test_meshes {

using Diagram_of_cells
  = CGAL::Surface_mesh_geodesic_Voronoi_diagram<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

// The largest distance in space of a vertex from the first one.
inline double extent_from_first_vertex(const Mesh& mesh)
{
  double result = 0;
  for(const vertex_descriptor v : vertices(mesh))
    result = (std::max)(result, std::sqrt(CGAL::squared_distance(mesh.point(*vertices(mesh).begin()), mesh.point(v))));
  return result;
}

// Calls check(mesh, diagram) for diagrams of symmetric meshes with every n-th vertex as a site: curves run along edges
// and through vertices, and four cells meet.
template <class Check>
void for_each_symmetric_diagram(Check check)
{
  for(const Indexed_mesh& indexed : {flat_patch(4, 4, 0., false, 1), cube_grid(3), octahedron(), icosphere(1),
                                     cone_fan(8), saddle_fan(4), torus(1., .4, 8, 8), genus_2_polycube()})
    for(std::size_t step = 1; step < 6; ++step)
    {
      const test_support::Scope scope(indexed.name + ", every " + std::to_string(step) + "th vertex");
      const Mesh mesh = to_face_graph(indexed);
      Diagram_of_cells diagram(mesh);
      for(std::size_t i = 0; i < num_vertices(mesh); i += step)
        diagram.add_site(vertex_descriptor(static_cast<Mesh::size_type>(i)));
      check(mesh, diagram);
    }
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_CELL_TEST_HELPERS_H
