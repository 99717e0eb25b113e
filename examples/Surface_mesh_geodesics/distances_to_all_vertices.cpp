#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;

namespace Geodesics = CGAL::Surface_mesh_geodesics;

// Dark blue to light yellow, ever lighter, in bands that are light and dark in turn: their borders are isolines.
CGAL::IO::Color color_of_distance(double distance, double largest)
{
  static const std::array<std::array<double, 3>, 6> ramp = {
      {{76, 40, 140}, {56, 96, 174}, {30, 138, 160}, {62, 178, 122}, {168, 208, 70}, {252, 232, 92}}};
  const int number_of_bands = 30;
  if(!std::isfinite(distance))
  {
    return CGAL::IO::Color(128, 128, 128); // not reachable
  }
  const double t = (largest > 0) ? distance / largest : 0;
  const std::size_t i = (std::min)(static_cast<std::size_t>(5 * t), std::size_t(4));
  const double weight = 5 * t - static_cast<double>(i);
  const int band = (std::min)(static_cast<int>(number_of_bands * t), number_of_bands - 1);
  const double brightness = (band % 2 == 0) ? 1. : 0.68;
  std::array<unsigned char, 3> rgb;
  for(std::size_t k = 0; k < 3; ++k)
  {
    rgb[k] = static_cast<unsigned char>(brightness * ((1 - weight) * ramp[i][k] + weight * ramp[i + 1][k]));
  }
  return CGAL::IO::Color(rgb[0], rgb[1], rgb[2]);
}

// Writes the distances as numbers, and the mesh with the colours. The PLY file holds the distances, too, as the
// property "distance" of its vertices.
bool write_results(Mesh& mesh, double largest, const std::string& distances_file, const std::string& colored_mesh_file)
{
  auto distance =
      mesh.add_property_map<vertex_descriptor, double>("v:distance").first; // the one that main() has filled
  auto color = mesh.add_property_map<vertex_descriptor, CGAL::IO::Color>("v:color").first;
  std::ofstream csv(distances_file);
  csv.precision(17);
  csv << "vertex,distance\n";
  for(vertex_descriptor v : vertices(mesh))
  {
    csv << v.idx() << ',' << distance[v] << '\n';
    color[v] = color_of_distance(distance[v], largest);
  }
  std::ofstream ply(colored_mesh_file, std::ios::binary);
  CGAL::IO::set_binary_mode(ply);
  return csv.flush() && CGAL::IO::write_PLY(ply, mesh) && ply.flush();
}

// usage: distances_to_all_vertices [mesh [source vertex...]] [--distances file.csv] [--colored-mesh file.ply]
int main(int argc, char* argv[])
{
  std::string mesh_file, distances_file = "distances.csv", colored_mesh_file = "distances.ply";
  std::vector<vertex_descriptor> sources;
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    std::istringstream number(argument);
    Mesh::size_type index;
    if((argument == "--distances" || argument == "--colored-mesh") && i + 1 < argc)
    {
      (argument == "--distances" ? distances_file : colored_mesh_file) = argv[++i];
    }
    else if(mesh_file.empty())
    {
      mesh_file = argument;
    }
    else if(number >> index && number.eof())
    {
      sources.push_back(vertex_descriptor(index));
    }
    else
    {
      std::cerr << argument << " is neither an option nor the index of a vertex" << std::endl;
      return EXIT_FAILURE;
    }
  }
  mesh_file = mesh_file.empty() ? "data/bumpy_sphere.off" : mesh_file;

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(mesh_file, mesh) || mesh.is_empty())
  {
    std::cerr << "Cannot read a mesh from " << mesh_file << std::endl;
    return EXIT_FAILURE;
  }
  if(sources.empty())
  {
    sources.push_back(*vertices(mesh).begin());
  }

  auto distance = mesh.add_property_map<vertex_descriptor, double>("v:distance").first;
  Geodesics::Propagation_statistics statistics;
  Geodesics::Geodesic_distance_options<Mesh> options;
  options.statistics = &statistics;
  CGAL::Real_timer timer;
  timer.start();
  try
  {
    Geodesics::geodesic_distances(mesh, distance, sources, options);
  }
  catch(const Geodesics::Invalid_geodesic_input&
            error) // a face that is not a triangle, a source that does not exist, ...
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  timer.stop();

  double largest = 0;
  for(vertex_descriptor v : vertices(mesh))
  {
    // Vertices of components without a source are at the distance infinity.
    largest = std::isfinite(distance[v]) ? (std::max)(largest, distance[v]) : largest;
  }
  if(!write_results(mesh, largest, distances_file, colored_mesh_file))
  {
    std::cerr << "Cannot write " << distances_file << " or " << colored_mesh_file << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "vertices:         " << mesh.number_of_vertices() << "\n"
            << "faces:            " << mesh.number_of_faces() << "\n"
            << "time:             " << 1000 * timer.time() << " ms\n"
            << "windows created:  " << statistics.windows_created << "\n"
            << "largest distance: " << largest << "\n"
            << "written:          " << distances_file << ", " << colored_mesh_file << std::endl;
  return EXIT_SUCCESS;
}
