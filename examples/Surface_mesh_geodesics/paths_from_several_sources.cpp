#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Paths = CGAL::Surface_mesh_geodesic_paths<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
using AABB_traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
using AABB_traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

using Polyline = std::vector<Point_3>;

// Three formats of the same paths: polylines.txt of CGAL (for each path the number of its points, and the points), OBJ
// (MeshLab, Blender), and legacy VTK with the numbers of the sources (ParaView).
bool write_paths(const std::vector<Polyline>& paths, const std::vector<std::size_t>& sources)
{
  std::ofstream txt("paths.polylines.txt"), obj("paths.obj"), vtk("paths.vtk");
  std::ostringstream points, lines;
  std::size_t number_of_points = 0;
  txt.precision(17);
  obj.precision(17);
  points.precision(17);
  for(const Polyline& path : paths)
  {
    txt << path.size();
    lines << path.size();
    for(const Point_3& p : path)
    {
      txt << ' ' << p;
      obj << "v " << p << '\n';
      points << p << '\n';
      lines << ' ' << number_of_points++;
    }
    txt << '\n';
    lines << '\n';
    obj << 'l';
    for(std::size_t i = number_of_points - path.size(); i < number_of_points; ++i)
    {
      obj << ' ' << i + 1; // OBJ counts from 1
    }
    obj << '\n';
  }
  vtk << "# vtk DataFile Version 3.0\nshortest paths\nASCII\nDATASET POLYDATA\n"
      << "POINTS " << number_of_points << " double\n"
      << points.str() << "LINES " << paths.size() << ' ' << paths.size() + number_of_points << '\n'
      << lines.str() << "CELL_DATA " << paths.size() << "\nSCALARS source int 1\nLOOKUP_TABLE default\n";
  for(std::size_t source : sources)
  {
    vtk << source << '\n';
  }
  return txt.flush() && obj.flush() && vtk.flush();
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.number_of_faces() == 0)
  {
    std::cerr << "Cannot read a mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Four sources, inside faces.
  Paths paths(mesh);
  const Mesh::size_type n = mesh.number_of_faces();
  for(Mesh::size_type i = 0; i < 4; ++i)
  {
    paths.add_source_point(Mesh::Face_index(i * (n / 4)), {0.2, 0.3, 0.5});
  }
  paths.build_sequence_tree_for_faces(); // queries will come at points that are not vertices

  // Queries at the points of the surface that are nearest to points on a circle around it.
  CGAL::AABB_tree<AABB_traits> tree;
  paths.build_aabb_tree(tree);
  const CGAL::Bbox_3 box = tree.bbox();
  const Point_3 center((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
  std::vector<Polyline> polylines;
  std::vector<std::size_t> nearest_sources;
  for(int i = 0; i < 24; ++i)
  {
    const double angle = i * CGAL_PI / 12;
    const Kernel::Vector_3 direction(std::cos(angle), std::sin(angle), 0.);
    const Paths::Face_location query = paths.locate(center + box.x_span() * direction, tree);

    Polyline polyline; // from the query to its nearest source
    const auto [distance, source] =
        paths.shortest_path_points_to_source_points(query.first, query.second, std::back_inserter(polyline));
    if(source == paths.source_points_end())
    {
      std::cout << paths.point(query.first, query.second) << " is reached by no source" << std::endl;
      continue;
    }
    const std::size_t number = paths.nearest_source_point(query.first, query.second);
    std::cout << "source " << number << ", distance " << distance << ", " << polyline.size() << " points" << std::endl;
    if(polyline.size() > 1) // the path from a source to itself is a point, and no line
    {
      nearest_sources.push_back(number);
      polylines.push_back(polyline);
    }
  }

  if(!write_paths(polylines, nearest_sources))
  {
    std::cerr << "Cannot write paths.polylines.txt, paths.obj or paths.vtk" << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "written: paths.polylines.txt, paths.obj, paths.vtk" << std::endl;
  return EXIT_SUCCESS;
}
