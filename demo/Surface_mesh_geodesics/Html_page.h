#ifndef SURFACE_MESH_GEODESICS_APP_HTML_PAGE_H
#define SURFACE_MESH_GEODESICS_APP_HTML_PAGE_H

#include "Command.h"
#include "Place_options.h"
#include "Program_mesh.h"

#include <CGAL/IO/Color.h>

#include <array>
#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace geodesics_app {

// Triangles with the exact distance at each point.
struct Html_surface
{
  std::vector<Point> points;
  std::vector<double> distances; // infinite where there is no source
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> cells; // of the triangles in a Voronoi diagram; else empty
};

// What is drawn on the surface. The role is one that page.js knows.
struct Html_lines
{
  std::string role;
  std::vector<std::vector<Point>> lines;
};

struct Html_dots
{
  std::string role;
  std::vector<Point> points;
};

// A page that shows a surface, and is complete in itself: it opens without a network.
struct Html_page
{
  std::string title, subtitle;
  Html_surface surface;
  std::vector<double> band_limits; // multiples of the first one
  std::vector<CGAL::IO::Color> cell_colors; // of the sites of a Voronoi diagram; else empty
  std::vector<Html_lines> lines;
  std::vector<Html_dots> dots;
};

// the points of places.
Html_dots dots_at(const std::string& role, const std::vector<Place>& places, const Mesh& mesh);

// "bunny.off: 37706 vertices, 75408 faces", for the subtitle.
std::string description_of(const std::string& file_name, const Mesh& mesh);

// Distances are interpolated between the points of the page. A surface of few triangles is therefore divided, each
// triangle into k^2, until it has some ten thousand. `distance(t, b)` gives the distance at the barycentric coordinates
// `b` of the triangle with the number `t`.
using Distance_in_triangle = std::function<double(std::size_t t, const std::array<double, 3>& b)>;
Html_surface refined(const Html_surface& surface, const Distance_in_triangle& distance);

// whether `refined()` divides triangles of a surface that has so many.
bool is_refined(std::size_t number_of_triangles);

// The lines of equal distance on a refined surface, by linear interpolation in its triangles; each segment is a line.
Html_lines lines_between_bands(const Html_surface& surface, const std::vector<double>& limits);

void write_html_page(std::ostream& os, const Html_page& page);

// The option --html of a command, and its values. They throw a Command_error if pages cannot be written because the
// program was built without three.js.
void declare_html(Option_descriptions& options);
std::vector<std::string> html_names(const Arguments& arguments);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_HTML_PAGE_H
