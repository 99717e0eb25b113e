#include "Curve_options.h"

#include "Command_error.h"
#include "Curve_file.h"
#include "Point_projection.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/shortest_path_curve.h>

#include <cstddef>
#include <string>
#include <utility>

namespace geodesics_demo {

namespace {

using CGAL::Surface_mesh_geodesics::Invalid_geodesic_input;

Curve joined(const Mesh& mesh, const std::vector<Face_location>& locations, bool is_closed,
             const Obstacles& avoided)
{
  using CGAL::Surface_mesh_geodesics::shortest_path_curve;
  return avoided.faces.empty() && avoided.walls.empty()
           ? shortest_path_curve(mesh, locations, is_closed)
           : shortest_path_curve(mesh, locations, is_closed,
                                 CGAL::parameters::faces_to_avoid(avoided.faces).edges_to_avoid(avoided.walls));
}

void append_file(const std::string& file_name, const Mesh& mesh, const Obstacles& avoided,
                 Point_projection& projection, std::vector<Curve>& curves)
{
  for(const Polyline& polyline : read_polylines(file_name))
  {
    const auto where = [&](std::size_t i) { return file_name + ", line " + std::to_string(polyline.lines[i]); };
    std::vector<Face_location> locations;
    for(std::size_t i = 0; i < polyline.points.size(); ++i)
      locations.push_back(projection.nearest_location(polyline.points[i], where(i), Exit_code::BAD_INPUT));
    try
    {
      curves.push_back(joined(mesh, locations, polyline.is_closed, avoided));
    }
    catch(const Invalid_geodesic_input& error)
    {
      if(error.reason() != Invalid_geodesic_input::Reason::INVALID_CURVE || error.element() >= locations.size())
        throw;
      throw Command_error(Exit_code::BAD_INPUT,
                          where(error.element()) + ": no path leads from this point of a curve to the next one");
    }
  }
}

} // namespace

void declare_curves(Option_descriptions& options, const std::string& role)
{
  options.add_options()
    ((role + "-border").c_str(),
     "all borders of the mesh, or of what --avoid leaves of it; whole edges, and not only their vertices")
    ((role + "-curve").c_str(),
     boost::program_options::value<std::vector<std::string>>()->value_name("FILE")->composing(),
     "the curves in a file: the lines of an .obj, or a .polylines.txt; the points move to the surface, and shortest "
     "paths join them");
  if(options.find_nothrow("snap", false) == nullptr)
    options.add_options()("snap", "points may be farther from the surface than 1 % of the diagonal of the mesh");
}

bool are_curves_given(const Arguments& arguments, const std::string& role)
{
  return has(arguments, role + "-border") || has(arguments, role + "-curve");
}

std::vector<Curve> curves_of(const std::string& role, const Arguments& arguments, const Mesh& mesh,
                             const std::vector<Location>& locations, const Obstacles& avoided,
                             const Console& console)
{
  const Work_sign sign(console, "curves");
  std::vector<Curve> curves;
  for(const Location& p : locations)
    curves.push_back(p.is_vertex() ? Curve(mesh, p.vertex) : Curve(mesh, p.face_location));
  if(has(arguments, role + "-border"))
  {
    std::vector<Curve> borders
      = CGAL::Surface_mesh_geodesics::border_curves(mesh, CGAL::parameters::faces_to_avoid(avoided.faces));
    if(borders.empty())
      throw Command_error(Exit_code::BAD_USAGE, "--" + role + "-border: the surface has no border");
    for(Curve& border : borders)
      curves.push_back(std::move(border));
  }
  Point_projection projection(mesh, has(arguments, "snap"), console, avoided.faces);
  for(const std::string& file_name : all_values(arguments, role + "-curve"))
    append_file(file_name, mesh, avoided, projection, curves);
  projection.remark_on_snaps();
  return curves;
}

Html_lines lines_along(const std::vector<Curve>& curves, const Mesh& mesh)
{
  Html_lines result{"curve", {}};
  for(const Curve& c : curves)
  {
    std::vector<Point> points;
    for(const Curve::Segment& s : c.segments())
    {
      if(points.empty())
        points.push_back(point_of(as_location({s.face, s.source}, mesh), mesh));
      points.push_back(point_of(as_location({s.face, s.target}, mesh), mesh));
    }
    if(!points.empty())
      result.lines.push_back(points);
  }
  return result;
}

} // namespace geodesics_demo
