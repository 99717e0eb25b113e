#include "Surface_repair.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace geodesics_demo {

namespace {

namespace Processing = CGAL::Polygon_mesh_processing;

using Polygons = std::vector<std::vector<std::size_t>>;

using Edges = std::set<std::pair<std::size_t, std::size_t>>;

// CGAL copies its visitors, so this one counts elsewhere. It is told of an edge once for each of its faces.
struct Counting_visitor
  : public Processing::Default_orientation_visitor
{
  Counting_visitor(Repair_report& counts, Edges& split_edges) : report(&counts), edges(&split_edges) {}

  void non_manifold_edge(std::size_t u, std::size_t v, std::size_t) { edges->insert(std::minmax(u, v)); }
  void polygon_orientation_reversed(std::size_t) { ++report->reversed_faces; }
  void duplicated_vertex(std::size_t, std::size_t) { ++report->new_vertices; }

  Repair_report* report;
  Edges* edges;
};

Polygons polygons_of(const Polygon_soup& soup)
{
  Polygons result;
  result.reserve(soup.number_of_faces());
  for(std::size_t f = 0; f < soup.number_of_faces(); ++f)
    result.emplace_back(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin_of(f)),
                        soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.ends[f]));
  return result;
}

// Leaves out corners that repeat the one before them. Is the rest no polygon?
bool is_degenerate(std::vector<std::size_t>& polygon)
{
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while(polygon.size() > 1 && polygon.front() == polygon.back())
    polygon.pop_back();
  std::vector<std::size_t> sorted = polygon;
  std::sort(sorted.begin(), sorted.end());
  return polygon.size() < 3 || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

// Leaves out the polygons that are degenerate, with their marks. Returns their number.
std::size_t leave_out_degenerate(Polygons& polygons, std::vector<char>& is_marked)
{
  std::size_t kept = 0;
  for(std::size_t f = 0; f < polygons.size(); ++f)
  {
    if(is_degenerate(polygons[f]))
      continue;
    std::swap(polygons[kept], polygons[f]);
    if(!is_marked.empty())
      is_marked[kept] = is_marked[f];
    ++kept;
  }
  const std::size_t left_out = polygons.size() - kept;
  polygons.resize(kept);
  is_marked.resize((std::min)(is_marked.size(), kept));
  return left_out;
}

std::string counted(std::size_t n, const std::string& one, const std::string& many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

} // namespace

std::string Repair_report::text() const
{
  std::string result;
  const auto add = [&](std::size_t n, const char* one, const char* many)
  {
    if(n > 0)
      result += (result.empty() ? "" : ", ") + counted(n, one, many);
  };
  add(merged_vertices, "vertex merged with another one", "vertices merged with others");
  add(degenerate_faces, "degenerate face left out", "degenerate faces left out");
  add(repeated_faces, "repeated face left out", "repeated faces left out");
  add(reversed_faces, "face reversed", "faces reversed");
  add(split_edges, "edge with more than two faces split", "edges with more than two faces split");
  add(new_vertices, "vertex copied to separate parts", "vertices copied to separate parts");
  return result;
}

Repair_report repair(Polygon_soup& soup)
{
  Repair_report report;
  Polygons polygons = polygons_of(soup);
  report.merged_vertices = Processing::merge_duplicate_points_in_polygon_soup(soup.points, polygons);
  report.degenerate_faces = leave_out_degenerate(polygons, soup.is_marked);
  report.repeated_faces = Processing::merge_duplicate_polygons_in_polygon_soup(soup.points, polygons);
  Edges split_edges;
  Processing::orient_polygon_soup(soup.points, polygons,
                                  CGAL::parameters::visitor(Counting_visitor(report, split_edges)));
  report.split_edges = split_edges.size();
  soup.corners.clear();
  soup.ends.clear();
  soup.lines.clear();
  for(const std::vector<std::size_t>& polygon : polygons)
  {
    for(const std::size_t v : polygon)
      soup.corners.push_back(static_cast<Polygon_soup::Index>(v));
    soup.end_face();
  }
  return report;
}

} // namespace geodesics_demo
