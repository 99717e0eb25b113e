#ifndef SURFACE_MESH_GEODESICS_DEMO_DISTANCE_FIELD_H
#define SURFACE_MESH_GEODESICS_DEMO_DISTANCE_FIELD_H

#include "Console.h"
#include "Curve_options.h"
#include "Html_page.h"
#include "Location_options.h"
#include "Obstacle_option.h"
#include "Program_mesh.h"

#include <array>
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
Distance_field distances_from(const Mesh& mesh, const Obstacles& avoided, const std::vector<Curve>& sources,
                              double radius, const Console& console);

// Distances that are negative on one side of the curves. Throws a Command_error if the curves do not separate the
// surface.
Distance_field signed_distances_from(const Mesh& mesh, const Obstacles& avoided, const std::vector<Curve>& curves,
                                     double radius, const Console& console);

// A line at one distance from the sources, which may have a sign.
struct Isoline
{
  double distance;
  std::vector<Point> points; // the first point is repeated at the end of a closed line
};

// One propagation that has more than the distances of vertices: isolines, and what pages need.
class Distance_run
{
public:
  // Answers for all points of the surface. It keeps the windows on all edges, which takes several times the memory of
  // distances_from().
  Distance_run(const Mesh& mesh, const Obstacles& avoided, const std::vector<Location>& sources, double radius,
               const Console& console);
  Distance_run(const Mesh& mesh, const Obstacles& avoided, const std::vector<Curve>& sources, double radius,
               const Console& console);

  // Finds the isolines of the given distances on its way, and keeps no windows: it takes little more memory than
  // distances_from().
  Distance_run(const Mesh& mesh, const Obstacles& avoided, const std::vector<Location>& sources, double radius,
               const std::vector<double>& levels, const Console& console);
  ~Distance_run();

  Distance_run(const Distance_run&) = delete;
  Distance_run& operator=(const Distance_run&) = delete;

  const Distance_field& field() const { return m_field; }

  // The lines at the given distances, in the same order. If no windows are kept, these are some of the levels.
  std::vector<Isoline> isolines(const std::vector<double>& distances) const;

  // The lines at the given distances from curves that separate the surface, those on the negative side first, each with
  // its signed distance: for 1 and 2 those of -2, -1, 1 and 2. Requires: windows are kept.
  std::vector<Isoline> signed_isolines(const std::vector<double>& distances) const;

  // For pages: the surface, refined if it has few triangles, and its isolines at the given distances. A point of a wall
  // is there once for each side, with the distance on that side. Faces that paths avoid have infinite distances inside.
  // Requires: windows are kept, or the surface is not refined (is_refined()).
  Html_surface surface() const;
  Html_lines lines_on(const Html_surface& surface, const std::vector<double>& distances) const;

  // The paths of this propagation, if it keeps windows. The class is in Path_finder.h.
  struct Paths;
  const Paths& paths() const { return *m_paths; }

private:
  template <typename Source>
  void run(const std::vector<Source>& sources);

  bool is_avoided(Face f) const { return !m_is_avoided.empty() && m_is_avoided[f] != 0; }
  template <typename Find>
  std::vector<Isoline> found_isolines(const std::vector<double>& distances, Find find) const;
  std::vector<std::vector<Face>> sectors(Mesh::Halfedge_index on_wall, const std::vector<char>& is_wall) const;
  void divide_at_walls(Html_surface& surface) const;
  double distance_within(Face f, std::array<double, 3> b) const;

  const Mesh& m_mesh;
  const Console& m_console;
  const Obstacles m_avoided;
  const std::vector<char> m_is_avoided; // by face, or empty
  const double m_radius;
  std::unique_ptr<Paths> m_paths; // hides the headers of paths from the files that use this class
  Distance_field m_field;
  std::vector<Isoline> m_isolines; // of all levels, if no windows are kept
};

// The index of a source for files and tables; -1 for no source.
double source_number(std::size_t source);
std::string source_text(std::size_t source);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_DISTANCE_FIELD_H
