#ifndef SURFACE_MESH_GEODESICS_DEMO_HTML_PAGE_H
#define SURFACE_MESH_GEODESICS_DEMO_HTML_PAGE_H

#include "Command.h"
#include "Location_options.h"
#include "Obstacle_option.h"
#include "Program_mesh.h"

#include <CGAL/IO/Color.h>

#include <array>
#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace geodesics_demo {

// Triangles with the exact distance at each point.
struct Html_surface
{
  std::vector<Point> points;
  std::vector<double> distances; // infinite where no source reaches; a wall has points for each of its sides
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> cells; // by triangle, for a Voronoi diagram; else empty
  std::vector<char> is_avoided; // by triangle; empty if paths avoid no faces
};

// Lines or dots on the surface. The role is one that page.js knows.
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

// A page that shows a surface. It is self-contained: it opens without a network.
struct Html_page
{
  std::string title, subtitle;
  const Mesh* mesh = nullptr; // of the file: clicks have its numbers of faces and vertices, and paths run on it
  Obstacles avoided;
  Html_surface surface;
  std::vector<double> band_limits; // multiples of the first one
  std::vector<CGAL::IO::Color> cell_colors; // by site, for a Voronoi diagram; else empty
  std::vector<Html_lines> lines;
  std::vector<Html_dots> dots;
};

// The points of locations.
Html_dots dots_at(const std::string& role, const std::vector<Location>& locations, const Mesh& mesh);

// The lines of walls.
Html_lines lines_of_walls(const std::vector<Mesh::Edge_index>& walls, const Mesh& mesh);

// "bunny.off: 37706 vertices, 75408 faces", for the subtitle.
std::string description_of(const std::string& file_name, const Mesh& mesh);

// Refines a surface of few triangles: divides each triangle into k^2, until there are some ten thousand, because a page
// interpolates distances between its points. `distance(t, b)` returns the distance at the barycentric coordinates `b`
// of triangle `t`.
using Distance_in_triangle = std::function<double(std::size_t t, const std::array<double, 3>& b)>;
Html_surface refined(const Html_surface& surface, const Distance_in_triangle& distance);

// Does `refined()` divide the triangles of a surface with this number of triangles?
bool is_refined(std::size_t number_of_triangles);

// The isolines of a refined surface, by linear interpolation in its triangles. Each segment is a line of its own.
Html_lines lines_between_bands(const Html_surface& surface, const std::vector<double>& limits);

// Remarks on a page that is too large for many browsers.
void write_html_page(std::ostream& os, const Html_page& page, const Console& console);

// The words of the command line, which pages show. main.cpp sets them.
void set_command_line(const std::vector<std::string>& words);

// The option --html of a command, and its values. Throws a Command_error if the program was built without three.js.
void declare_html(Option_descriptions& options);
std::vector<std::string> html_names(const Arguments& arguments);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_HTML_PAGE_H
