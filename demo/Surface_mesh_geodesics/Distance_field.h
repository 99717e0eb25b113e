#ifndef SURFACE_MESH_GEODESICS_DEMO_DISTANCE_FIELD_H
#define SURFACE_MESH_GEODESICS_DEMO_DISTANCE_FIELD_H

#include "Console.h"
#include "Curve_options.h"
#include "Html_page.h"
#include "Location_options.h"
#include "Obstacle_option.h"
#include "Program_mesh.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace geodesics_demo {

// For each vertex of a mesh, the distance from its nearest source and the index of that source; infinity if no source
// reaches it.
struct Distance_field
{
  static constexpr std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

  std::vector<double> distance;
  std::vector<std::size_t> source; // empty if distances have a sign
  std::vector<Location> foot; // if sources are curves without a sign: the nearest point of a curve, or nowhere

  // The largest finite distance, without its sign; 0 if there is none.
  double largest() const;
};

// Computes the distances up to `radius` of paths that lead around the avoided faces and edges.
Distance_field distances_from(const Mesh& mesh, const Obstacles& avoided, const std::vector<Location>& sources,
                              double radius, const Console& console);

// The same from curves, and the nearest point of the curves for each vertex.
Distance_field distances_from(const Mesh& mesh, const std::vector<Face>& avoided, const std::vector<Curve>& sources,
                              double radius, const Console& console);

// Distances that are negative on one side of the curves. Throws a Command_error if the curves do not separate the
// surface.
Distance_field signed_distances_from(const Mesh& mesh, const std::vector<Face>& avoided,
                                     const std::vector<Curve>& curves, double radius, const Console& console);

// All lines at one distance from the sources.
struct Isoline
{
  double distance;
  std::vector<Point> points; // the first point is repeated at the end of a closed line
};

// One propagation that answers for all points of the surface, and not for vertices only: distances, isolines, and what
// pages need. It keeps the windows on all edges, which takes several times the memory of distances_from().
class Distance_run
{
public:
  Distance_run(const Mesh& mesh, const Obstacles& avoided, const std::vector<Location>& sources, double radius,
               const Console& console);
  // There must be no walls: curves that are sources take none.
  Distance_run(const Mesh& mesh, const Obstacles& avoided, const std::vector<Curve>& sources, double radius,
               const Console& console);
  ~Distance_run();

  Distance_run(const Distance_run&) = delete;
  Distance_run& operator=(const Distance_run&) = delete;

  const Distance_field& field() const { return m_field; }

  // The lines at the given distances, in the same order.
  std::vector<Isoline> isolines(const std::vector<double>& distances) const;

  // For pages, if nothing is avoided: the surface, refined if it has few triangles, and its isolines at the given
  // distances.
  Html_surface surface() const;
  Html_lines lines_on(const Html_surface& surface, const std::vector<double>& distances) const;

  // The paths of this propagation. The class is in Path_finder.h.
  struct Paths;
  const Paths& paths() const { return *m_paths; }

private:
  template <typename Source>
  void run(const Obstacles& avoided, const std::vector<Source>& sources, double radius);

  const Mesh& m_mesh;
  const Console& m_console;
  std::unique_ptr<Paths> m_paths; // hides the headers of paths from the files that use this class
  Distance_field m_field;
};

// n distances strictly between 0 and the largest one; none if the largest is 0.
std::vector<double> evenly_spaced(std::size_t n, double largest);

// About n distances strictly between 0 and the largest one: the multiples of a number with one digit, 1, 2 or 5.
std::vector<double> at_round_distances(std::size_t n, double largest);

// The index of a source for files and tables; -1 for no source.
double source_number(std::size_t source);
std::string source_text(std::size_t source);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_DISTANCE_FIELD_H
