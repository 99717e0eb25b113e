#ifndef SURFACE_MESH_GEODESICS_DEMO_DISTANCE_FIELD_H
#define SURFACE_MESH_GEODESICS_DEMO_DISTANCE_FIELD_H

#include "Console.h"
#include "Html_page.h"
#include "Location_options.h"
#include "Program_mesh.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace geodesics_demo {

// For each vertex of a mesh, the distance from its nearest source and the index of that source; infinity if no source
// reaches it.
struct Distance_field
{
  static constexpr std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

  std::vector<double> distance;
  std::vector<std::size_t> source;

  // The largest finite distance; 0 if there is none.
  double largest() const;
};

// Computes the distances up to `radius`.
Distance_field distances_from(const Mesh& mesh, const std::vector<Location>& sources, double radius,
                              const Console& console);

// All lines at one distance from the sources.
struct Isoline
{
  double distance;
  std::vector<Point> points; // the first point is repeated at the end of a closed line
};

// The lines at the given distances, in the same order.
std::vector<Isoline> isolines_around(const Mesh& mesh, const std::vector<Location>& sources,
                                     const std::vector<double>& distances, const Console& console);

// n distances strictly between 0 and the largest one; none if the largest is 0.
std::vector<double> evenly_spaced(std::size_t n, double largest);

// For pages: the surface, and its isolines at the given distances.
Html_surface surface_with_distances(const Mesh& mesh, const std::vector<Location>& sources,
                                    const Distance_field& field);
Html_lines lines_on(const Html_surface& surface, const Mesh& mesh, const std::vector<Location>& sources,
                    const std::vector<double>& distances, const Console& console);

// A column of numbers for files; -1 for no source.
double source_number(std::size_t source);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_DISTANCE_FIELD_H
