// Remeshes each given mesh with 200, 1000 and 4000 samples, and compares the new mesh with the given one: topology,
// faces without area, distance in space. Prints one line of comma separated values per mesh and number of samples.
//
// Files that are not surfaces are prepared: polygons are oriented, vertices that several surfaces share are duplicated,
// and faces that are not triangles are triangulated. Distances are measured from the vertices and the centers of the
// faces of either mesh to the other one.

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

using Point = Benchmark_kernel::Point_3;
using Topology = std::pair<long, long>; // the Euler characteristic and the number of borders
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Benchmark_mesh>;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Benchmark_kernel, Primitive>>;
#else
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Benchmark_kernel, Primitive>>;
#endif

bool read(const std::string& file, Benchmark_mesh& mesh)
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if(!CGAL::IO::read_polygon_soup(file, points, polygons) || polygons.empty())
  {
    return false;
  }
  if(!PMP::is_polygon_soup_a_polygon_mesh(polygons))
  {
    PMP::orient_polygon_soup(points, polygons);
  }
  if(!PMP::is_polygon_soup_a_polygon_mesh(polygons))
  {
    return false;
  }
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  PMP::triangulate_faces(mesh);
  return CGAL::is_triangle_mesh(mesh);
}

// In ascending order. Takes a copy with a vertex for each umbrella.
std::vector<Topology> topology_of_components(Benchmark_mesh mesh)
{
  PMP::duplicate_non_manifold_vertices(mesh);
  auto component = mesh.add_property_map<Benchmark_mesh::Face_index, std::size_t>("f:topology").first;
  std::vector<Topology> topology(PMP::connected_components(mesh, component));
  const auto of = [&](Benchmark_mesh::Halfedge_index h) -> Topology&
  { return topology[component[mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h)]]; };
  for(const auto f : mesh.faces())
  {
    ++of(mesh.halfedge(f)).first;
  }
  for(const auto e : mesh.edges())
  {
    --of(mesh.halfedge(e)).first;
  }
  for(const auto v : mesh.vertices())
  {
    if(!mesh.is_isolated(v))
    {
      ++of(mesh.halfedge(v)).first;
    }
  }
  std::vector<Benchmark_mesh::Halfedge_index> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  for(const auto h : borders)
  {
    ++of(h).second;
  }
  std::sort(topology.begin(), topology.end());
  return topology;
}

std::array<Point, 3> corners_of(const Benchmark_mesh& mesh, Benchmark_mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))};
}

std::size_t number_of_degenerate_faces(const Benchmark_mesh& mesh)
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  const auto exact = [](const Point& p) { return Exact(p.x(), p.y(), p.z()); };
  return static_cast<std::size_t>(std::count_if(mesh.faces().begin(), mesh.faces().end(), [&](auto f)
  {
    const std::array<Point, 3> c = corners_of(mesh, f);
    return CGAL::collinear(exact(c[0]), exact(c[1]), exact(c[2]));
  }));
}

double distance_from(const Benchmark_mesh& from, const Benchmark_mesh& to)
{
  Tree tree(faces(to).begin(), faces(to).end(), to);
  double largest = 0;
  for(const auto f : from.faces())
  {
    const std::array<Point, 3> c = corners_of(from, f);
    for(const Point& p : {c[0], c[1], c[2], CGAL::centroid(c[0], c[1], c[2])})
    {
      largest = (std::max)(largest, tree.squared_distance(p));
    }
  }
  return std::sqrt(largest);
}

double extent(const Benchmark_mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return std::sqrt(CGAL::squared_distance(Point(box.xmin(), box.ymin(), box.zmin()),
                                          Point(box.xmax(), box.ymax(), box.zmax())));
}

// Returns whether the new mesh is what the function promises.
bool print_row(const Settings& settings, const std::string& file, const Benchmark_mesh& mesh, std::size_t n)
{
  Benchmark_mesh coarse;
  CGAL::Surface_mesh_geodesics::Geodesic_remeshing_report report;
  const double milliseconds = milliseconds_of(settings.clock_id(), [&]
  { report = CGAL::Surface_mesh_geodesics::geodesic_remeshing(mesh, n, coarse); });
  std::vector<Benchmark_mesh::Halfedge_index> pinched;
  PMP::non_manifold_vertices(coarse, std::back_inserter(pinched));
  const bool is_valid = CGAL::is_valid_polygon_mesh(coarse) && CGAL::is_triangle_mesh(coarse) && pinched.empty();
  const bool is_same = topology_of_components(mesh) == topology_of_components(coarse);
  const std::size_t before = number_of_degenerate_faces(mesh), after = number_of_degenerate_faces(coarse);
  const double distance = (std::max)(distance_from(mesh, coarse), distance_from(coarse, mesh));
  std::cout << file_name(file) << ',' << mesh.number_of_vertices() << ',' << mesh.number_of_faces() << ','
            << report.number_of_components << ',' << n << ',' << (is_valid ? "yes" : "no") << ','
            << (is_same ? "yes" : "no") << ',' << coarse.number_of_vertices() << ','
            << report.number_of_added_samples << ',' << report.number_of_rounds << ','
            << report.number_of_components_of_samples << ',' << report.kept_components.size() << ','
            << report.number_of_split_vertices << ',' << before << ',' << after << ','
            << cell(100 * distance / extent(mesh), 3) << ',' << cell(milliseconds / 1000, 2) << std::endl;
  return is_valid && is_same && after <= before;
}

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    std::cerr << "usage: " << argv[0] << " [options] mesh...\n"
              << "  --list FILE   more mesh files, one per line\n"
              << "  --flags TEXT  compiler flags, for the first lines of the output\n"
              << "  --no-header   rows only\n";
    return EXIT_FAILURE;
  }
  try
  {
    if(settings.print_header)
    {
      print_machine(settings);
      std::cout << "mesh,vertices,faces,components,samples,is_manifold,same_topology,new_vertices,added_samples,rounds,"
                   "components_of_samples,kept_components,split_vertices,degenerate_faces,new_degenerate_faces,"
                   "distance_percent,seconds"
                << std::endl;
    }
    bool is_good = true;
    for(const std::string& file : settings.meshes)
    {
      Benchmark_mesh mesh;
      if(!read(file, mesh))
      {
        std::cerr << "skipped: " << file << " (no surface)" << std::endl;
        continue;
      }
      for(const std::size_t n : {200u, 1000u, 4000u})
      {
        is_good = print_row(settings, file, mesh, n) && is_good;
      }
    }
    return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return method_failed;
  }
}
