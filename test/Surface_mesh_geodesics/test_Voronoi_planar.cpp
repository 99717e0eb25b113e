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
    points.push_back(flat(s.point.is_vertex() ? coordinates(s.point.vertex, tm) : coordinates(s.point.location, tm)));
  }
  return points;
}

bool is_inside(const Point_2& p, double size, double margin)
{
  return p.x() > margin && p.y() > margin && p.x() < size - margin && p.y() < size - margin;
}

// The diagram has exactly the expected vertices inside, each once and with its sites.
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

using Pair = std::pair<std::size_t, std::size_t>;

// The pairs of sites that are adjacent in the plane, and those of them that are adjacent inside the square.
struct Adjacencies
{
  std::set<Pair> all, needed;

  // Adds a pair, given the finite ends of its edge of the diagram. The surface need not
  // have an edge of length zero (four sites on a circle).
  void add(const Pair& pair, const std::vector<Point_2>& ends, double size)
  {
    all.insert(pair);
    const bool has_length
      = ends.size() == 1 || (ends.size() == 2 && std::sqrt(CGAL::squared_distance(ends[0], ends[1])) > 1e-9 * size);
    if(has_length && std::any_of(ends.begin(), ends.end(),
                                 [&](const Point_2& p) { return is_inside(p, size, 1e-9 * size); }))
    {
      needed.insert(pair);
    }
  }
};

// Each edge of the plane with a vertex inside the square is an adjacency on the surface, and each adjacency on the
// surface is an edge of the plane.
void check_adjacencies(const Voronoi& diagram, const Adjacencies& expected)
{
  std::set<Pair> found;
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
  {
    for(const std::size_t j : diagram.adjacent_sites(i))
    {
      found.insert(std::minmax(i, j));
    }
  }
  CHECK(std::includes(expected.all.begin(), expected.all.end(), found.begin(), found.end()));
  CHECK(std::includes(found.begin(), found.end(), expected.needed.begin(), expected.needed.end()));
}

Adjacencies adjacencies_of(const Delaunay& delaunay, const std::map<Point_2, std::size_t>& first, double size)
{
  Adjacencies result;
  for(auto e = delaunay.finite_edges_begin(); e != delaunay.finite_edges_end(); ++e)
  {
    const std::size_t i = first.at(e->first->vertex(Delaunay::cw(e->second))->point());
    const std::size_t j = first.at(e->first->vertex(Delaunay::ccw(e->second))->point());
    const auto f = e->first, g = f->neighbor(e->second);
    std::vector<Point_2> ends;
    for(const auto& side : {f, g})
    {
      if(!delaunay.is_infinite(side))
      {
        ends.push_back(delaunay.dual(side));
      }
    }
    result.add(std::minmax(i, j), ends, size);
  }
  return result;
}

// Arcs between sites without weights are straight, even where a path from one of the sites passes a flat vertex.
void check_straight_arcs(const Voronoi& diagram, const Mesh& tm, double size)
{
  for(const Voronoi::Arc& a : diagram.arcs())
  {
    const Coordinates p = coordinates(a.point(0.), tm), q = coordinates(a.point(1.), tm);
    CHECK_NEAR(length(cross(q - p, coordinates(a.point(.5), tm) - p)), 0., 1e-10 * length(q - p) * size);
  }
}

void diagrams_are_dual_to_Delaunay(const Mesh& tm, double size, std::size_t number, test_support::Random& random)
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
  check_vertices(diagram, expected, size);
  check_adjacencies(diagram, adjacencies_of(delaunay, first, size));
  check_straight_arcs(diagram, tm, size);
}

// The additively weighted diagram of the plane, with the index of our site for each of its sites.
struct Apollonius_diagram
{
  Apollonius graph;
  std::map<std::pair<Point_2, double>, std::size_t> number_of_site;

  Apollonius_diagram(const std::vector<Point_2>& points, const Weighted_sites& sites)
  {
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      number_of_site.emplace(std::make_pair(points[i], sites[i].weight), i);
      graph.insert(Apollonius::Site_2(points[i], sites[i].weight));
    }
  }

  std::size_t site_of(const Apollonius::Site_2& s) const
  {
    return number_of_site.at(std::make_pair(s.point(), CGAL::to_double(s.weight())));
  }

  std::vector<std::pair<Point_2, std::set<std::size_t>>> vertices() const
  {
    std::vector<std::pair<Point_2, std::set<std::size_t>>> result;
    for(auto f = graph.finite_faces_begin(); f != graph.finite_faces_end(); ++f)
    {
      const Apollonius::Site_2 s = graph.dual(f);
      std::set<std::size_t> corners;
      for(int k = 0; k < 3; ++k)
      {
        corners.insert(site_of(f->vertex(k)->site()));
      }
      result.emplace_back(s.point(), corners);
    }
    return result;
  }

  Adjacencies adjacencies(double size) const
  {
    using Structure = Apollonius::Triangulation_data_structure;
    Adjacencies result;
    for(auto e = graph.finite_edges_begin(); e != graph.finite_edges_end(); ++e)
    {
      const auto f = e->first, g = f->neighbor(e->second);
      const Pair pair = std::minmax(site_of(f->vertex(Structure::cw(e->second))->site()),
                                    site_of(f->vertex(Structure::ccw(e->second))->site()));
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
      result.add(pair, ends, size);
    }
    return result;
  }
};

void weights_give_Apollonius_diagrams(const Mesh& tm, double size, std::size_t number, test_support::Random& random)
{
  test_support::Scope scope(std::to_string(number) + " sites with weights");
  Weighted_sites sites = random_sites(tm, number, 0., random);
  for(Weighted_site& s : sites)
  {
    s.weight = random.uniform(0., .08) * size;
  }
  const Apollonius_diagram plane(points_of(sites, tm), sites);
  Voronoi diagram(tm);
  add_sites(diagram, sites);
  std::set<std::size_t> visible;
  for(auto v = plane.graph.finite_vertices_begin(); v != plane.graph.finite_vertices_end(); ++v)
  {
    visible.insert(plane.site_of(v->site()));
  }
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    CHECK_EQUAL(diagram.is_empty(i), visible.count(i) == 0);
  }
  check_vertices(diagram, plane.vertices(), size);
  check_adjacencies(diagram, plane.adjacencies(size));
}

void planar_diagrams_agree(const Mesh& tm, double size, const std::string& name, test_support::Random& random)
{
  test_support::Scope scope(name);
  for(const std::size_t number : {3u, 10u, 30u, 100u})
  {
    diagrams_are_dual_to_Delaunay(tm, size, number, random);
  }
  for(const std::size_t number : {3u, 10u, 30u})
  {
    weights_give_Apollonius_diagrams(tm, size, number, random);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260603);
  test_support::Random random(seed);
  planar_diagrams_agree(to_face_graph(flat_patch(12, 12, 0., false, seed)), 12., "grid", random);
  for(std::size_t i = 0; i < 4; ++i)
  {
    planar_diagrams_agree(to_face_graph(flat_patch(12, 12, .15, true, seed + i)), 12., "patch", random);
  }
  std::cout << number_of_vertices << " vertices" << std::endl;
  CHECK(number_of_vertices > 1000);
  return test_result();
}
