// Faces with hundreds of sources. Their parts are those of a Delaunay triangulation, which flips of edges make: the
// mesh keeps its invariants and its lengths, each source is found again, and undo() restores every bit. Distances in
// the plane and on a tetrahedron are known in other ways; diagrams are certified. The cost grows with the number of
// sources, not with its square.

#include "Voronoi_test_helpers.h"
#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/mesh_invariants.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Face_parts.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using Located = internal::Located_source<double>;
using internal::Face_id;
using internal::Vertex_id;

enum class Layout { EVEN, CLUSTER, LINE, NEAR_EDGE, GRID, ON_EDGES };

// Coordinates of n points in a face.
std::vector<std::array<double, 3>> points_in_face(Layout layout, std::size_t n, test_support::Random& random)
{
  std::vector<std::array<double, 3>> result;
  for(std::size_t i = 0; i < n; ++i)
  {
    double x = random.uniform(0., 1.), y = random.uniform(0., 1.);
    const std::size_t m = static_cast<std::size_t>(std::sqrt(double(n))) + 1;
    if(layout == Layout::CLUSTER)
    {
      x = .3 + 1e-6 * x;
      y = .4 + 1e-6 * y;
    }
    else if(layout == Layout::LINE)
      y = .1 + .3 * x;
    else if(layout == Layout::NEAR_EDGE)
    {
      const double t = double(i + 1) / double(n + 1);
      x = .05 + .9 * t * t;
      y = .0017;
    }
    else if(layout == Layout::GRID)
    {
      x = double(i % m + 1) / double(2 * m);
      y = double(i / m + 1) / double(2 * m);
    }
    if(x + y > 1)
    {
      x = 1 - x;
      y = 1 - y;
    }
    std::array<double, 3> b{1 - x - y, x, y};
    if(layout == Layout::ON_EDGES)
    {
      const std::size_t k = random.index(3);
      b[(k + 1) % 3] += b[k];
      b[k] = 0;
    }
    result.push_back(b);
  }
  return result;
}

double area(const internal::Intrinsic_face<double>& f) { return f.length[0] * f.apex_y / 2; }

// The sides of parts have the lengths that their ends have in the whole face, and the areas of the parts fill it.
void check_parts(const internal::Intrinsic_mesh<double>& mesh, const internal::Intrinsic_mesh<double>& before,
                 const internal::Face_parts<double>& parts, Face_id whole)
{
  const internal::Intrinsic_face<double>& face = before.face(whole);
  const auto p = internal::layout_of_face(face);
  const double size = *std::max_element(face.length.begin(), face.length.end());
  double sum = 0;
  for(const Face_id f : *parts.parts_of(whole))
  {
    const internal::Face_part<double>& part = *parts.find_part_of(f);
    for(unsigned int k = 0; k < 3; ++k)
    {
      double x = 0, y = 0;
      for(unsigned int i = 0; i < 3; ++i)
      {
        const double d = part.corner[(k + 1) % 3][i] - part.corner[k][i];
        x += d * p[i].x;
        y += d * p[i].y;
      }
      CHECK_NEAR(mesh.face(f).length[k], std::hypot(x, y), 1e-13 * size);
    }
    sum += area(mesh.face(f));
  }
  CHECK_NEAR(sum, area(face), 1e-12 * size * size);
}

// Returns how many edges inside of the face are not Delaunay, beyond rounding.
std::size_t number_of_other_edges(const internal::Intrinsic_mesh<double>& mesh,
                                  const internal::Face_parts<double>& parts, Face_id whole)
{
  std::size_t result = 0;
  const auto angle = [&](internal::Halfedge_id h) // opposite to h
  {
    const double a = mesh.length(h), b = mesh.length(internal::next_halfedge(h)),
                 c = mesh.length(internal::previous_halfedge(h));
    return std::acos((std::max)(-1., (std::min)(1., (b * b + c * c - a * a) / (2 * b * c))));
  };
  for(const Face_id f : *parts.parts_of(whole))
    for(unsigned int k = 0; k < 3; ++k)
    {
      const internal::Halfedge_id h = internal::halfedge_of(f, k), o = mesh.opposite(h);
      if(o != internal::null_id && parts.is_inside_whole(h, o) && angle(h) + angle(o) > 3.15)
        ++result;
    }
  return result / 2;
}

void insertions(const Mesh& tm, Layout layout, std::size_t n, test_support::Random& random)
{
  const test_support::Scope scope("layout " + std::to_string(int(layout)));
  const internal::Intrinsic_mesh<double> before = intrinsic_mesh(tm);
  internal::Intrinsic_mesh<double> mesh = before;
  internal::Source_insertion<double> insertion(mesh);
  for(int run = 0; run < 2; ++run)
  {
    std::vector<Located> sources;
    const Face_id face = static_cast<Face_id>(random.index(before.number_of_faces()));
    const std::vector<std::array<double, 3>> points = points_in_face(layout, n, random);
    for(const std::array<double, 3>& b : points)
    {
      Located s;
      s.face = face;
      s.coordinates = b;
      s.position = sources.size();
      sources.push_back(s);
    }
    sources.push_back(sources.front()); // a point twice
    sources.back().position = n;
    std::vector<Vertex_id> vertices(n + 1);
    internal::insert_located_sources(sources, insertion, vertices);
    CHECK(internal::are_invariants_kept(mesh));
    CHECK_EQUAL(vertices[0], vertices[n]);
    for(std::size_t i = 0; i < n; ++i)
    {
      std::array<double, 3> b = points[i];
      const Face_id part = insertion.parts().part_with(mesh, face, b);
      const std::size_t k = static_cast<std::size_t>(std::max_element(b.begin(), b.end()) - b.begin());
      // Between narrow parts, the point may seem to be beside its vertex.
      CHECK(layout == Layout::NEAR_EDGE || mesh.face(part).vertex[k] == vertices[i]);
      CHECK_EQUAL(insertion.parts().coordinates_in_whole(part, b), face);
      for(std::size_t j = 0; j < 3; ++j)
        CHECK_NEAR(b[j], points[i][j], 1e-12);
    }
    if(layout != Layout::GRID) // where locations are equal
      CHECK_EQUAL(std::set<Vertex_id>(vertices.begin(), vertices.end()).size(), n);
    check_parts(mesh, before, insertion.parts(), face);
    const bool is_even = layout == Layout::EVEN || layout == Layout::CLUSTER || layout == Layout::GRID;
    if(is_even && area(before.face(face)) > .01)
      CHECK(number_of_other_edges(mesh, insertion.parts(), face) <= n / 10);
    insertion.undo();
    CHECK(is_same_mesh(mesh, before));
  }
}

std::vector<Face_location> locations_in_two_faces(const Mesh& tm, Layout layout, std::size_t n,
                                                  test_support::Random& random)
{
  std::vector<Face_location> result;
  for(int i = 0; i < 2; ++i)
  {
    const face_descriptor f(static_cast<face_descriptor::size_type>(random.index(num_faces(tm))));
    for(const std::array<double, 3>& b : points_in_face(layout, n / 2, random))
      result.emplace_back(f, b);
  }
  return result;
}

void distances_in_the_plane(Layout layout, test_support::Random& random)
{
  const test_support::Scope scope("plane, layout " + std::to_string(int(layout)));
  const Mesh tm = to_face_graph(flat_patch(1, 1, 0., true, 1));
  const std::vector<Face_location> sources = locations_in_two_faces(tm, layout, 400, random);
  Geodesic_paths paths(tm);
  paths.add_source_points(sources.begin(), sources.end());
  for(int i = 0; i < 200; ++i)
  {
    const Face_location q = i % 4 == 0 ? sources[random.index(sources.size())] : random_location(tm, random);
    const Kernel::Point_3 p = paths.point(q.first, q.second);
    double expected = infinity;
    for(const Face_location& s : sources)
      expected = (std::min)(expected, std::sqrt(CGAL::squared_distance(p, paths.point(s.first, s.second))));
    CHECK_NEAR(paths.shortest_distance_to_source_points(q.first, q.second).first, expected, 1e-14);
  }
}

// The order of the sources does not matter. The distances are those from single sources, and those of CGAL's class
// (which errs if sources are on edges or next to them).
void distances_on_a_tetrahedron(Layout layout, test_support::Random& random)
{
  const test_support::Scope scope("tetrahedron, layout " + std::to_string(int(layout)));
  const Mesh tm = to_face_graph(irregular_tetrahedron());
  std::vector<Face_location> sources = locations_in_two_faces(tm, layout, 300, random);
  Geodesic_paths paths(tm), others(tm);
  Shortest_path original(tm);
  std::vector<std::unique_ptr<Geodesic_paths>> single;
  paths.add_source_points(sources.begin(), sources.end());
  for(const Face_location& s : sources)
  {
    original.add_source_point(s.first, s.second);
    single.push_back(std::make_unique<Geodesic_paths>(tm));
    single.back()->add_source_point(s);
  }
  for(std::size_t i = sources.size(); i > 1; --i)
    std::swap(sources[i - 1], sources[random.index(i)]);
  others.add_source_points(sources.begin(), sources.end());
  for(int i = 0; i < 100; ++i)
  {
    const Face_location q = random_location(tm, random);
    const auto distance = [&](auto& p)
    { return double(p.shortest_distance_to_source_points(q.first, q.second).first); };
    double expected = infinity;
    for(const auto& p : single)
      expected = (std::min)(expected, distance(*p));
    CHECK_NEAR(distance(paths), expected, 1e-13);
    if(layout != Layout::ON_EDGES && layout != Layout::NEAR_EDGE)
      CHECK_NEAR(distance(paths), distance(original), 1e-12);
    CHECK_EQUAL(distance(paths), distance(others));
  }
}

void diagrams(const Mesh& tm, Layout layout, test_support::Random& random)
{
  const test_support::Scope scope("diagram, layout " + std::to_string(int(layout)));
  Voronoi diagram(tm);
  diagram.add_sites(locations_in_two_faces(tm, layout, 120, random));
  CHECK(CGAL::Surface_mesh_geodesics::certify_geodesic_Voronoi_diagram(diagram).worst_violation()
        <= CGAL::Surface_mesh_geodesics::Geodesic_Voronoi_certificate::default_tolerance);
  double sum = 0, expected = 0;
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
    sum += diagram.area(i);
  for(const face_descriptor f : faces(tm))
    expected += area_of_face(tm, f);
  CHECK_NEAR(sum, expected, 1e-12 * expected);
}

// Without flips, the number of windows grows with the square of the number of sources.
void cost_is_linear(test_support::Random& random)
{
  const Mesh tm = to_face_graph(flat_patch(1, 1, 0., true, 1));
  for(const std::size_t n : {200u, 800u, 3200u})
  {
    const std::vector<Face_location> sources = locations_in_two_faces(tm, Layout::EVEN, n, random);
    Voronoi diagram(tm);
    diagram.add_sites(sources);
    diagram.build();
    CHECK(diagram.number_of_kept_windows().second <= 40 * n);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261129);
  test_support::Random random(seed);
  for(const Layout layout :
      {Layout::EVEN, Layout::CLUSTER, Layout::LINE, Layout::NEAR_EDGE, Layout::GRID, Layout::ON_EDGES})
  {
    for(const Indexed_mesh& indexed : small_collection(seed))
    {
      const test_support::Scope scope(indexed.name);
      insertions(to_face_graph(indexed), layout, 100, random);
    }
    distances_in_the_plane(layout, random);
    distances_on_a_tetrahedron(layout, random);
    diagrams(to_face_graph(flat_patch(1, 1, 0., true, 1)), layout, random);
    diagrams(to_face_graph(irregular_tetrahedron()), layout, random);
  }
  cost_is_linear(random);
  return test_result();
}
