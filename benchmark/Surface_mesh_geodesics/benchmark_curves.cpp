// Curves as sources: distances of all vertices from the border of a mesh, as curves, and from the same border as
// vertices. Skips meshes without border, meshes with fewer faces than --minimum-faces, and files without a triangle
// mesh. Meshes with fewer than 60,000 faces are refined by Loop's subdivision first. Prints one line of comma separated
// values per mesh; whole calls of geodesic_distances(), processor times. The ratio is the median of those of adjacent
// runs.

#include "benchmark_surface.h"
#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <CGAL/Subdivision_method_3/subdivision_methods_3.h>

#include <string>
#include <vector>

namespace {

namespace Geodesics = CGAL::Surface_mesh_geodesics;
using Vertex = Benchmark_mesh::Vertex_index;

template <typename Sources>
double milliseconds_from(const Settings& settings, Benchmark_mesh& mesh, const Sources& sources,
                         Geodesics::Propagation_statistics& statistics)
{
  const auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  statistics = Geodesics::Propagation_statistics();
  return milliseconds_of(settings.clock_id(), [&]() {
    Geodesics::geodesic_distances(mesh, distance, sources, CGAL::parameters::statistics(&statistics));
  });
}

double megabytes(std::size_t bytes) { return static_cast<double>(bytes) / (1024. * 1024.); }

// What a call needs at its peak, with its copy of the mesh, its tables and the results.
double megabytes_of_call(const Geodesics::Propagation_statistics& s)
{
  return megabytes(s.intrinsic_mesh_bytes + s.maximum_window_bytes);
}

void print_row(const Settings& settings, const std::string& file, Benchmark_mesh& mesh)
{
  const auto curves = Geodesics::border_curves(mesh);
  std::vector<Vertex> border;
  for(const Vertex v : mesh.vertices())
    if(mesh.is_border(v) && !mesh.is_isolated(v))
      border.push_back(v);
  if(border.empty())
    return;
  std::vector<double> from_curves, from_vertices;
  Geodesics::Propagation_statistics of_curves, of_vertices;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    from_curves.push_back(milliseconds_from(settings, mesh, curves, of_curves));
    from_vertices.push_back(milliseconds_from(settings, mesh, border, of_vertices));
  }
  const double curve_mb = megabytes(of_curves.maximum_window_bytes);
  const double vertex_mb = megabytes(of_vertices.maximum_window_bytes);
  std::cout << file_name(file) << ',' << mesh.number_of_faces() << ',' << border.size() << ','
            << cell(median(from_curves), 1) << ',' << cell(median(from_vertices), 1) << ','
            << cell(median_ratio(from_curves, from_vertices), 2) << ',' << of_curves.windows_propagated << ','
            << of_vertices.windows_propagated << ',' << cell(curve_mb, 2) << ',' << cell(vertex_mb, 2) << ','
            << cell(curve_mb / vertex_mb, 2) << ','
            << cell(megabytes_of_call(of_curves) / megabytes_of_call(of_vertices), 2) << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
    return usage(argv[0], " mesh...   (--minimum-faces N; --list FILE)");
  print_head(settings, "distances of all vertices from the border, as curves and as vertices, processor times of whole "
                       "calls; memory of windows and strips, and of whole calls",
             "mesh,faces,border_vertices,curves_ms,vertices_ms,ratio,curve_windows,vertex_windows,curve_mb,vertex_mb,"
             "memory_ratio,call_memory_ratio");
  for(const std::string& file : settings.meshes)
  {
    Benchmark_mesh mesh;
    if(!read_mesh(file, 0, mesh) || mesh.number_of_faces() < settings.minimum_faces || CGAL::is_closed(mesh))
      continue;
    while(mesh.number_of_faces() < 60000)
      CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
    print_row(settings, file, mesh);
  }
  return EXIT_SUCCESS;
}
