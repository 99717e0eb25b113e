// Computes distances on each given mesh, certifies them, and compares them with those of
// CGAL::Surface_mesh_shortest_path. Prints one line of comma separated values per mesh.
//
// Files that are not surfaces are prepared. Faces that are not triangles are triangulated, after geodesic_distances()
// has thrown its exception for them. Faces that do not fit together are oriented, and vertices that several surfaces
// share are duplicated. The source is the first vertex with a face. The original runs in its own process with a time
// limit, because it may take long or fail; it gets no vertices without faces, which it does not accept. Where both
// differ by more than 1e-12, the distances of the original are certified too, which shows which ones are right.

#include "benchmark_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace Geodesics = CGAL::Surface_mesh_geodesics;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Certificate = Geodesics::Geodesic_distance_certificate<Mesh>;

const double tolerance_of_comparison = 1e-12;

// ---------------------------------------------------------------------------------------------------------------------
// Meshes
// ---------------------------------------------------------------------------------------------------------------------

enum class Preparation : int
{
  NONE,
  TRIANGULATED,
  ORIENTED,
  ORIENTED_AND_TRIANGULATED,
  WITHOUT_FACES,
  UNREADABLE,
  NOT_REFUSED,
  NOT_TRIANGULATED
};

const char* name(Preparation p)
{
  const char* names[] = {"as it is",
                         "refused: not triangles; triangulated",
                         "oriented",
                         "oriented; refused: not triangles; triangulated",
                         "no faces",
                         "unreadable",
                         "not triangles but not refused",
                         "cannot be triangulated"};
  return names[static_cast<int>(p)];
}

bool is_surface(Preparation p) { return p < Preparation::WITHOUT_FACES; }

Vertex source_of(const Mesh& mesh)
{
  const auto range = mesh.vertices();
  return *std::find_if(range.begin(), range.end(), [&](Vertex v) { return !mesh.is_isolated(v); });
}

Preparation read_soup(const std::string& file, Mesh& mesh)
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  if(!CGAL::IO::read_polygon_soup(file, points, polygons))
  {
    return Preparation::UNREADABLE;
  }
  if(polygons.empty())
  {
    return Preparation::WITHOUT_FACES;
  }
  PMP::repair_polygon_soup(points, polygons);
  PMP::orient_polygon_soup(points, polygons);
  if(!PMP::is_polygon_soup_a_polygon_mesh(polygons))
  {
    return Preparation::UNREADABLE;
  }
  mesh.clear();
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return Preparation::ORIENTED;
}

// Does geodesic_distances() report faces that are not triangles?
bool is_refused(const Mesh& mesh)
{
  std::vector<double> distances(mesh.num_vertices(), 0.);
  try
  {
    Geodesics::geodesic_distances(mesh, CGAL::make_property_map(distances), source_of(mesh));
  }
  catch(const Geodesics::Invalid_geodesic_input& e)
  {
    return e.reason() == Geodesics::Invalid_geodesic_input::Reason::NOT_A_TRIANGLE;
  }
  return false;
}

Preparation prepare(const std::string& file, Mesh& mesh)
{
  Preparation result = Preparation::NONE;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.number_of_faces() == 0)
  {
    result = read_soup(file, mesh);
  }
  if(!is_surface(result) || CGAL::is_triangle_mesh(mesh))
  {
    return result;
  }
  if(!is_refused(mesh))
  {
    return Preparation::NOT_REFUSED;
  }
  PMP::triangulate_faces(mesh);
  if(!CGAL::is_triangle_mesh(mesh))
  {
    return Preparation::NOT_TRIANGULATED;
  }
  return result == Preparation::NONE ? Preparation::TRIANGULATED : Preparation::ORIENTED_AND_TRIANGULATED;
}

// ---------------------------------------------------------------------------------------------------------------------
// The measuring process
// ---------------------------------------------------------------------------------------------------------------------

struct Report
{
  std::uint64_t vertices = 0, faces = 0, reached = 0;
  Preparation preparation = Preparation::NONE;
  double worst_violation = 0;
  int worst_condition = 0;
  double seconds_to_compute = 0, seconds_to_certify = 0;
  char exception[200] = "";
};

Certificate certificate_of(const Mesh& mesh, const std::vector<double>& distances)
{
  return Geodesics::certify_geodesic_distances(mesh, CGAL::make_property_map(distances), source_of(mesh));
}

int condition_of_worst_violation(const Certificate& c)
{
  int worst = 0;
  for(int i = 0; i < static_cast<int>(Certificate::number_of_conditions); ++i)
  {
    if(c.worst_violation(static_cast<Certificate::Condition>(i))
       > c.worst_violation(static_cast<Certificate::Condition>(worst)))
    {
      worst = i;
    }
  }
  return worst;
}

void measure_ours(const Mesh& mesh, clockid_t clock, std::vector<double>& distances, Report& report)
{
  double start = milliseconds_now(clock);
  Geodesics::geodesic_distances(mesh, CGAL::make_property_map(distances), source_of(mesh));
  report.seconds_to_compute = (milliseconds_now(clock) - start) / 1000;
  report.reached = static_cast<std::uint64_t>(
    std::count_if(distances.begin(), distances.end(),
                  [](double d) { return d < std::numeric_limits<double>::infinity(); }));
  start = milliseconds_now(clock);
  const Certificate c = certificate_of(mesh, distances);
  report.seconds_to_certify = (milliseconds_now(clock) - start) / 1000;
  report.worst_violation = c.worst_violation();
  report.worst_condition = condition_of_worst_violation(c);
}

void measure_original(const Mesh& mesh, std::vector<double>& distances)
{
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  CGAL::Surface_mesh_shortest_path<Traits> shortest_paths(mesh);
  shortest_paths.add_source_point(source_of(mesh));
  for(const Vertex v : mesh.vertices())
  {
    const double d = mesh.is_isolated(v) ? -1 : shortest_paths.shortest_distance_to_source_points(v).first;
    distances[v] = d < 0 ? std::numeric_limits<double>::infinity() : d;
  }
}

int measuring_process(const Settings& settings)
{
  Mesh mesh;
  Report report;
  std::vector<double> distances;
  report.preparation = prepare(settings.meshes.front(), mesh);
  report.vertices = mesh.number_of_vertices();
  report.faces = mesh.number_of_faces();
  if(!is_surface(report.preparation))
  {
    send_and_exit(settings, report, distances);
  }
  distances.assign(mesh.num_vertices(), 0.);
  try
  {
    if(settings.method == "ours")
    {
      measure_ours(mesh, settings.clock_id(), distances, report);
    }
    else
    {
      measure_original(mesh, distances);
    }
  }
  catch(const Geodesics::Invalid_geodesic_input& e)
  {
    std::string(e.what()).copy(report.exception, sizeof(report.exception) - 1);
  }
  send_and_exit(settings, report, distances);
}

// ---------------------------------------------------------------------------------------------------------------------
// The process that compares
// ---------------------------------------------------------------------------------------------------------------------

struct Totals
{
  std::size_t meshes = 0, certified = 0, excepted = 0, without_faces = 0, failed = 0;
  std::size_t compared = 0, equal = 0, refuted = 0;
  double worst_violation = 0, worst_difference = 0;
};

// The certificate of the distances of the original, where they differ from ours.
double violation_of_original(const std::string& file, const std::vector<double>& distances)
{
  Mesh mesh;
  prepare(file, mesh);
  return certificate_of(mesh, distances).worst_violation();
}

void compare_with_original(const Settings& settings, const std::string& file, const std::vector<double>& ours,
                           Totals& totals)
{
  Report report;
  std::vector<double> original;
  if(run_measurement(settings, file, "original", {}, report, original) != 0)
  {
    std::cout << "fails or takes longer,,";
    return;
  }
  ++totals.compared;
  const double difference = largest_relative_difference(ours, original);
  std::cout << "computed," << difference << ',';
  if(difference <= tolerance_of_comparison)
  {
    ++totals.equal;
    totals.worst_difference = (std::max)(totals.worst_difference, difference);
    return;
  }
  const double violation = violation_of_original(file, original);
  totals.refuted += violation > Certificate::default_tolerance;
  std::cout << violation;
}

void print_row(const Settings& settings, const std::string& file, Totals& totals)
{
  ++totals.meshes;
  Report report;
  std::vector<double> distances;
  Settings without_limit = settings;
  without_limit.time_limit = 0;
  if(run_measurement(without_limit, file, "ours", {}, report, distances) != 0)
  {
    ++totals.failed;
    std::cout << file_name(file) << ",,,,,failed,,,,,,," << std::endl;
    return;
  }
  std::cout << file_name(file) << ',' << report.vertices << ',' << report.faces << ',' << report.reached << ','
            << name(report.preparation) << ',';
  if(!is_surface(report.preparation))
  {
    ++(report.preparation == Preparation::WITHOUT_FACES ? totals.without_faces : totals.failed);
    std::cout << "none,,,,,,," << std::endl;
    return;
  }
  if(report.exception[0] != '\0')
  {
    ++totals.excepted;
    std::cout << "exception: " << report.exception << ",,,,,,," << std::endl;
    return;
  }
  const bool is_certified = report.worst_violation <= Certificate::default_tolerance;
  totals.certified += is_certified;
  totals.worst_violation = (std::max)(totals.worst_violation, report.worst_violation);
  const char* condition = report.worst_violation > 0
                          ? Certificate::name(static_cast<Certificate::Condition>(report.worst_condition))
                          : "";
  std::cout << (is_certified ? "certified" : "violated") << ',' << report.worst_violation << ',' << condition << ','
            << cell(report.seconds_to_compute, 3) << ',' << cell(report.seconds_to_certify, 3) << ',';
  if(settings.wants("original"))
  {
    compare_with_original(settings, file, distances, totals);
  }
  else
  {
    std::cout << ",,";
  }
  std::cout << std::endl;
}

void print_totals(const Totals& t)
{
  std::cout << "# " << t.meshes << " meshes: " << t.certified << " certified (worst violation " << t.worst_violation
            << "), " << t.excepted << " refused with an exception, " << t.without_faces << " without faces, "
            << t.failed << " failed\n"
            << "# " << t.compared << " compared with the original: " << t.equal << " equal (worst difference "
            << t.worst_difference << "), " << t.refuted << " where the certificate refutes the original" << std::endl;
}

int main(int argc, char* argv[])
{
  Settings settings;
  settings.time_limit = 60;
  settings.kernel = "epick";
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    std::cerr << "usage: " << argv[0] << " [options] mesh...\n"
              << "  --list FILE           more mesh files, one per line\n"
              << "  --only ours           do not compare with the original\n"
              << "  --time-limit SECONDS  of the original (60)\n"
              << "  --memory-limit MB     give up a run that would need more\n"
              << "  --flags TEXT          compiler flags, for the first lines of the output\n"
              << "  --no-header           rows only\n";
    return EXIT_FAILURE;
  }
  try
  {
    if(settings.is_measuring())
    {
      return measuring_process(settings);
    }
    if(settings.print_header)
    {
      print_machine(settings);
      std::cout << "# source: the first vertex with a face; the original gets " << settings.time_limit << " s\n"
                << "mesh,vertices,faces,reached,preparation,result,worst_violation,worst_condition,"
                   "seconds_to_compute,seconds_to_certify,original,largest_relative_difference,violation_of_original"
                << std::endl;
    }
    Totals totals;
    for(const std::string& file : settings.meshes)
    {
      print_row(settings, file, totals);
    }
    print_totals(totals);
    const bool is_good = totals.certified + totals.excepted + totals.without_faces == totals.meshes
                      && totals.equal + totals.refuted == totals.compared;
    return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return method_failed;
  }
}
