// On a flat square the diagram is that of the plane: its vertices inside the square, and which cells are
// adjacent there, are those of CGAL's Delaunay triangulation, with weights those of the Apollonius graph.

#include "Voronoi_test_helpers.h"

#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Delaunay_triangulation_2.h>


#include <iostream>

using namespace test_meshes;

namespace {

using Point_2 = Kernel::Point_2;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using Apollonius = CGAL::Apollonius_graph_2<CGAL::Apollonius_graph_filtered_traits_2<Kernel>>;

std::size_t number_of_vertices = 0;

Point_2 flat(const Coordinates& p) { return Point_2(p[0], p[1]); }

std::vector<Point_2> points_of(const Weighted_sites& sites, const Mesh& tm)
{
  std::vector<Point_2> points;
  for(const Weighted_site& s : sites)
  {
    points.push_back(flat(s.place.is_vertex() ? coordinates(s.place.vertex, tm) : coordinates(s.place.location, tm)));
  }
  return points;
}

bool is_inside(const Point_2& p, double size, double margin)
{
  return p.x() > margin && p.y() > margin && p.x() < size - margin && p.y() < size - margin;
}

// Each vertex expected inside is there once, with its sites, and nothing else is.
void check_vertices(const Voronoi& diagram, const std::vector<std::pair<Point_2, std::set<std::size_t>>>& expected,
                    double size)
{
  const double margin = 1e-9 * size;
  std::size_t number = 0;
  for(std::size_t k = 0; k < expected.size(); ++k)
  {
    const auto& e = expected[k];
    if(!is_inside(e.first, size, margin))
    {
      continue;
    }
    // several triangles with the same circle are one vertex
    number += std::none_of(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(k), [&](const auto& other)
    { return std::sqrt(CGAL::squared_distance(other.first, e.first)) <= 1e-10 * size; }) ? 1 : 0;
    std::size_t matches = 0;
    for(const Voronoi::Vertex& v : diagram.vertices())
    {
      const Point_2 p(v.point().x(), v.point().y());
      if(std::sqrt(CGAL::squared_distance(p, e.first)) <= 1e-10 * size)
      {
        ++matches;
        CHECK(std::includes(v.sites().begin(), v.sites().end(), e.second.begin(), e.second.end()));
      }
    }
    CHECK_EQUAL(matches, 1u);
  }
  std::size_t found = 0;
  for(const Voronoi::Vertex& v : diagram.vertices())
  {
    found += is_inside(Point_2(v.point().x(), v.point().y()), size, margin) ? 1 : 0;
  }
  CHECK_EQUAL(found, number);
  number_of_vertices += number;
}

// Edges of the plane with a vertex inside the square are adjacencies of the surface; and those are Delaunay edges.
void test_Delaunay(const Mesh& tm, double size, std::size_t number, test_support::Random& random)
{
  test_support::Scope scope(std::to_string(number) + " sites");
  const Weighted_sites sites = random_sites(tm, number, 0., random);
  const std::vector<Point_2> points = points_of(sites, tm);
  Delaunay delaunay;
  std::map<Point_2, std::size_t> first;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    first.emplace(points[i], i);
    delaunay.insert(points[i]);
  }
  Voronoi diagram(tm);
  add_sites(diagram, sites);
  std::vector<std::pair<Point_2, std::set<std::size_t>>> expected;
  std::set<std::pair<std::size_t, std::size_t>> edges, needed;
  for(auto f = delaunay.finite_faces_begin(); f != delaunay.finite_faces_end(); ++f)
  {
    std::set<std::size_t> corners;
    for(int k = 0; k < 3; ++k)
    {
      corners.insert(first.at(f->vertex(k)->point()));
    }
    const Point_2 center = delaunay.dual(f);
    expected.emplace_back(center, corners);
  }
  for(auto e = delaunay.finite_edges_begin(); e != delaunay.finite_edges_end(); ++e)
  {
    const std::size_t i = first.at(e->first->vertex(Delaunay::cw(e->second))->point());
    const std::size_t j = first.at(e->first->vertex(Delaunay::ccw(e->second))->point());
    edges.insert(std::minmax(i, j));
    const auto f = e->first, g = f->neighbor(e->second);
    std::vector<Point_2> ends;
    for(const auto& side : {f, g})
    {
      if(!delaunay.is_infinite(side))
      {
        ends.push_back(delaunay.dual(side));
      }
    }
    // (four sites on a circle: the edge has no length)
    const bool has_length = ends.size() == 1 || std::sqrt(CGAL::squared_distance(ends[0], ends.back())) > 1e-9 * size;
    if(has_length && std::any_of(ends.begin(), ends.end(),
                                 [&](const Point_2& p) { return is_inside(p, size, 1e-9 * size); }))
    {
      needed.insert(std::minmax(i, j));
    }
  }
  check_vertices(diagram, expected, size);
  std::set<std::pair<std::size_t, std::size_t>> found;
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    for(const std::size_t j : diagram.adjacent_sites(i))
    {
      found.insert(std::minmax(i, j));
    }
  }
  CHECK(std::includes(edges.begin(), edges.end(), found.begin(), found.end()));
  CHECK(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
  for(const Voronoi::Arc& a : diagram.arcs())
  {
    // straight, also where images of a source are a way round a vertex
    const Coordinates p = coordinates(a.point(0.), tm), q = coordinates(a.point(1.), tm);
    CHECK_NEAR(length(cross(q - p, coordinates(a.point(.5), tm) - p)), 0., 1e-10 * length(q - p) * size);
  }
}

void test_Apollonius(const Mesh& tm, double size, std::size_t number, test_support::Random& random)
{
  test_support::Scope scope(std::to_string(number) + " sites with weights");
  Weighted_sites sites = random_sites(tm, number, 0., random);
  for(Weighted_site& s : sites)
  {
    s.weight = random.uniform(0., .08) * size;
  }
  const std::vector<Point_2> points = points_of(sites, tm);
  Apollonius graph;
  std::map<std::pair<Point_2, double>, std::size_t> number_of_site;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    number_of_site.emplace(std::make_pair(points[i], sites[i].weight), i);
    graph.insert(Apollonius::Site_2(points[i], sites[i].weight));
  }
  Voronoi diagram(tm);
  add_sites(diagram, sites);
  std::set<std::size_t> visible;
  const auto site_of = [&](const Apollonius::Site_2& s)
  { return number_of_site.at(std::make_pair(s.point(), CGAL::to_double(s.weight()))); };
  for(auto v = graph.finite_vertices_begin(); v != graph.finite_vertices_end(); ++v)
  {
    visible.insert(site_of(v->site()));
  }
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    CHECK_EQUAL(diagram.is_empty(i), visible.count(i) == 0);
  }
  std::vector<std::pair<Point_2, std::set<std::size_t>>> expected;
  for(auto f = graph.finite_faces_begin(); f != graph.finite_faces_end(); ++f)
  {
    const Apollonius::Site_2 s = graph.dual(f);
    std::set<std::size_t> corners;
    for(int k = 0; k < 3; ++k)
    {
      corners.insert(site_of(f->vertex(k)->site()));
    }
    expected.emplace_back(s.point(), corners);
  }
  check_vertices(diagram, expected, size);

  // Edges of the plane with a vertex inside the square are adjacencies of the surface; and those are Apollonius edges.
  std::set<std::pair<std::size_t, std::size_t>> edges, needed, found;
  for(auto e = graph.finite_edges_begin(); e != graph.finite_edges_end(); ++e)
  {
    const auto f = e->first, g = f->neighbor(e->second);
    const std::pair<std::size_t, std::size_t> pair
      = std::minmax(site_of(f->vertex(Apollonius::Triangulation_data_structure::cw(e->second))->site()),
                    site_of(f->vertex(Apollonius::Triangulation_data_structure::ccw(e->second))->site()));
    edges.insert(pair);
    std::vector<Point_2> ends;
    for(const auto& side : {f, g})
    {
      if(!graph.is_infinite(side))
      {
        Apollonius::Site_2 center;
        CHECK(CGAL::assign(center, graph.dual(side)));
        ends.push_back(center.point());
      }
    }
    const bool has_length = ends.size() == 1
                         || (ends.size() == 2 && std::sqrt(CGAL::squared_distance(ends[0], ends[1])) > 1e-9 * size);
    if(has_length && std::any_of(ends.begin(), ends.end(),
                                 [&](const Point_2& p) { return is_inside(p, size, 1e-9 * size); }))
    {
      needed.insert(pair);
    }
  }
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    for(const std::size_t j : diagram.adjacent_sites(i))
    {
      found.insert(std::minmax(i, j));
    }
  }
  CHECK(std::includes(edges.begin(), edges.end(), found.begin(), found.end()));
  CHECK(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
}

void test_mesh(const Mesh& tm, double size, const std::string& name, test_support::Random& random)
{
  test_support::Scope scope(name);
  for(const std::size_t number : {3u, 10u, 30u, 100u})
  {
    test_Delaunay(tm, size, number, random);
  }
  for(const std::size_t number : {3u, 10u, 30u})
  {
    test_Apollonius(tm, size, number, random);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260603);
  test_support::Random random(seed);
  test_mesh(to_face_graph(flat_patch(12, 12, 0., false, seed)), 12., "grid", random);
  for(std::size_t i = 0; i < 4; ++i)
  {
    test_mesh(to_face_graph(flat_patch(12, 12, .15, true, seed + i)), 12., "patch", random);
  }
  std::cout << number_of_vertices << " vertices" << std::endl;
  CHECK(number_of_vertices > 1000);
  return test_result();
}
