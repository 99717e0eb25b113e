#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using edge_descriptor = boost::graph_traits<Mesh>::edge_descriptor;

namespace Geodesics = CGAL::Surface_mesh_geodesics;

// A flat torus: a rectangle with opposite sides glued together. No mesh in space has these distances, but edge lengths
// suffice. The points of the vertices are not used.
int main()
{
  const std::size_t columns = 24, rows = 16;
  const double width = 3, height = 2;

  Mesh mesh;
  std::vector<vertex_descriptor> grid(columns * rows);
  for(vertex_descriptor& v : grid)
  {
    v = mesh.add_vertex(Kernel::Point_3(0, 0, 0));
  }
  auto vertex_at = [&](std::size_t column, std::size_t row) { return grid[(row % rows) * columns + column % columns]; };

  auto length = mesh.add_property_map<edge_descriptor, double>("e:length").first;
  const double dx = width / columns, dy = height / rows;
  auto set_length = [&](vertex_descriptor a, vertex_descriptor b, double l) { length[edge(a, b, mesh).first] = l; };
  for(std::size_t row = 0; row < rows; ++row)
  {
    for(std::size_t column = 0; column < columns; ++column)
    {
      const vertex_descriptor a = vertex_at(column, row), b = vertex_at(column + 1, row);
      const vertex_descriptor c = vertex_at(column + 1, row + 1), d = vertex_at(column, row + 1);
      mesh.add_face(a, b, c);
      mesh.add_face(a, c, d);
      set_length(a, b, dx);
      set_length(a, d, dy);
      set_length(a, c, std::hypot(dx, dy));
    }
  }

  auto distance = mesh.add_property_map<vertex_descriptor, double>("v:distance").first;
  Geodesics::geodesic_distances_from_edge_lengths(mesh, length, distance, vertex_at(0, 0));

  // On a flat torus the distance is known: take the shorter way around in both directions.
  double largest = 0, largest_error = 0;
  for(std::size_t row = 0; row < rows; ++row)
  {
    for(std::size_t column = 0; column < columns; ++column)
    {
      const double x = dx * static_cast<double>((std::min)(column, columns - column));
      const double y = dy * static_cast<double>((std::min)(row, rows - row));
      const double found = distance[vertex_at(column, row)];
      largest = (std::max)(largest, found);
      largest_error = (std::max)(largest_error, std::abs(found - std::hypot(x, y)));
    }
  }
  std::cout << "largest distance: " << largest << " (half of the diagonal: " << std::hypot(width, height) / 2 << ")\n"
            << "largest error:    " << largest_error << std::endl;
  return EXIT_SUCCESS;
}
