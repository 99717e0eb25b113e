#ifndef SURFACE_MESH_GEODESICS_APP_DISTANCE_FIELD_H
#define SURFACE_MESH_GEODESICS_APP_DISTANCE_FIELD_H

#include "Console.h"
#include "Html_page.h"
#include "Place_options.h"
#include "Program_mesh.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace geodesics_app {

// For each vertex of a mesh its distance from the nearest source, infinite where there is none, and the number of that.
struct Distance_field
{
  static constexpr std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

  std::vector<double> distance;
  std::vector<std::size_t> source;

  // the largest distance that is finite; 0 if there is none.
  double largest() const;
};

// computes the distances that are not greater than `radius`.
Distance_field distances_from(const Mesh& mesh, const std::vector<Place>& sources, double radius,
                              const Console& console);

// All lines on which the distance from the sources has one value.
struct Isoline
{
  double distance;
  std::vector<Point> points; // the first one again at the end if the line is closed
};

// the lines at the given distances, in their order.
std::vector<Isoline> isolines_around(const Mesh& mesh, const std::vector<Place>& sources,
                                     const std::vector<double>& distances, const Console& console);

// n distances between 0 and the largest one, both left out; none if that is 0.
std::vector<double> evenly_spaced(std::size_t n, double largest);

// For pages: the surface, and the isolines on it at the given distances.
Html_surface surface_with_distances(const Mesh& mesh, const std::vector<Place>& sources, const Distance_field& field);
Html_lines lines_on(const Html_surface& surface, const Mesh& mesh, const std::vector<Place>& sources,
                    const std::vector<double>& distances, const Console& console);

// a column of numbers for files: -1 for no source.
double source_number(std::size_t source);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_DISTANCE_FIELD_H
