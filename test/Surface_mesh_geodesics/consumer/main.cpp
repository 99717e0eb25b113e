#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <iostream>

int main(int argc, char* argv[])
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  if(argc < 2 || !CGAL::IO::read_OFF(argv[1], mesh) || mesh.is_empty() || !is_triangle_mesh(mesh))
  {
    std::cerr << "usage: my_program triangles.off\n";
    return 1;
  }
  auto distance = mesh.add_property_map<CGAL::SM_Vertex_index, double>("v:distance").first;
  CGAL::Surface_mesh_geodesics::geodesic_distances(mesh, distance, *vertices(mesh).begin());
  for(auto v : vertices(mesh)) std::cout << v << " " << distance[v] << "\n";
}
