// Curves on other types of meshes: whatever takes curves has the same results as on a Surface_mesh with the same points
// and faces. Polyhedra store their indices, linear cell complexes have other halfedges, and a filtered graph lacks
// elements of the graph below it.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics.h>

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;

namespace {

// What a mesh makes of the same curves, as numbers: of vertices in the order of vertices(tm).
struct Results
{
  std::vector<double> distances, signed_distances, path_lengths, path_sizes, areas, isoline_lengths;
  std::vector<std::size_t> labels, sources, samples;
};

// The curves are a shortest path from vertex 0 to vertex 30, the link of vertex 60, and a line in space at vertex 90.
template <typename TriangleMesh>
class Curves_on
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Curve = SMG::Surface_curve<TriangleMesh>;
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, TriangleMesh>;

public:
  explicit Curves_on(const TriangleMesh& tm)
    : m_tm(tm), m_vertices(vertices(tm).begin(), vertices(tm).end())
  {
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      m_number[m_vertices[i]] = i;
    const std::array<vertex_descriptor, 2> ends{m_vertices[0], m_vertices[30]};
    m_curves = {SMG::shortest_path_curve(tm, ends), link_of(m_vertices[60]), line_at(m_vertices[90])};
  }

  Results results() const
  {
    Results r;
    find_distances(r);
    find_paths(r);
    find_cells(r);
    find_isolines(r);
    std::vector<vertex_descriptor> samples;
    SMG::geodesic_farthest_point_sampling(m_tm, 5, std::back_inserter(samples), np::first_curves(m_curves));
    for(const vertex_descriptor v : samples)
      r.samples.push_back(m_number.at(v));
    return r;
  }

private:
  // A closed curve along edges.
  Curve link_of(vertex_descriptor v) const
  {
    std::vector<halfedge_descriptor> link;
    for(const halfedge_descriptor h : halfedges_around_target(v, m_tm))
      link.push_back(prev(h, m_tm));
    return Curve::along_halfedges(m_tm, std::vector<halfedge_descriptor>(link.rbegin(), link.rend()));
  }

  // Between the centers of two neighboring faces at a vertex, across their edge.
  Curve line_at(vertex_descriptor v) const
  {
    const auto points = get(CGAL::vertex_point, m_tm);
    const halfedge_descriptor h = halfedge_to_largest_neighbor(v), o = opposite(h, m_tm);
    const auto &p = get(points, source(h, m_tm)), &q = get(points, target(h, m_tm));
    const auto middle = CGAL::midpoint(p, q);
    const std::vector<Kernel::Point_3> line{
      CGAL::centroid(p, q, get(points, target(next(h, m_tm), m_tm))), middle,
      CGAL::centroid(p, q, get(points, target(next(o, m_tm), m_tm)))};
    return SMG::polyline_curve(m_tm, line);
  }

  // Each type of mesh may begin its walk around a vertex anywhere.
  halfedge_descriptor halfedge_to_largest_neighbor(vertex_descriptor v) const
  {
    halfedge_descriptor result = opposite(halfedge(v, m_tm), m_tm);
    for(const halfedge_descriptor h : halfedges_around_source(v, m_tm))
      if(m_number.at(target(result, m_tm)) < m_number.at(target(h, m_tm)))
        result = h;
    return result;
  }

  void find_distances(Results& r) const
  {
    std::map<vertex_descriptor, double> distance, signed_distance;
    std::map<vertex_descriptor, std::size_t> nearest, label;
    const std::vector<double> offsets{.3, 0., .1};
    SMG::geodesic_distances(m_tm, boost::make_assoc_property_map(distance), m_curves,
                            np::source_offsets(offsets)
                              .nearest_source_map(boost::make_assoc_property_map(nearest)));
    SMG::signed_geodesic_distances(m_tm, boost::make_assoc_property_map(signed_distance), m_curves[1]);
    SMG::geodesic_Voronoi_labels(m_tm, boost::make_assoc_property_map(label), m_curves);
    for(const vertex_descriptor v : m_vertices)
    {
      r.distances.push_back(distance.at(v));
      r.signed_distances.push_back(signed_distance.at(v));
      r.sources.push_back(nearest.at(v));
      r.labels.push_back(label.at(v));
    }
  }

  void find_paths(Results& r) const
  {
    CGAL::Surface_mesh_geodesic_paths<Traits> paths(m_tm);
    for(const Curve& c : m_curves)
      paths.add_source_curve(c);
    for(std::size_t i = 0; i < m_vertices.size(); i += 7)
    {
      std::vector<Kernel::Point_3> path;
      r.path_lengths.push_back(
        paths.shortest_path_points_to_source_points(m_vertices[i], std::back_inserter(path)).first);
      CHECK_NEAR(length_of(path), r.path_lengths.back(), 1e-12);
      r.path_sizes.push_back(static_cast<double>(path.size()));
    }
  }

  void find_cells(Results& r) const
  {
    CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits> diagram(m_tm);
    for(const Curve& c : m_curves)
      diagram.add_site(c);
    diagram.build();
    for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
      r.areas.push_back(diagram.area(i));
    CHECK(SMG::certify_geodesic_Voronoi_diagram(diagram).is_certified());
  }

  void find_isolines(Results& r) const
  {
    const std::vector<double> levels{.2, .5, .9};
    std::vector<std::pair<std::size_t, std::vector<Kernel::Point_3>>> lines;
    SMG::geodesic_isolines(m_tm, m_curves, levels, std::back_inserter(lines));
    r.isoline_lengths.assign(levels.size(), 0.);
    for(const auto& line : lines)
      r.isoline_lengths[line.first] += length_of(line.second);
  }

  static double length_of(const std::vector<Kernel::Point_3>& line)
  {
    std::vector<Coordinates> points;
    for(const Kernel::Point_3& p : line)
      points.push_back(to_coordinates(p));
    return polyline_length(points);
  }

  const TriangleMesh& m_tm;
  std::vector<vertex_descriptor> m_vertices;
  std::map<vertex_descriptor, std::size_t> m_number;
  std::vector<Curve> m_curves;
};

template <typename TriangleMesh>
Results results_on(const TriangleMesh& tm)
{
  return Curves_on<TriangleMesh>(tm).results();
}

// Faces begin at other corners, and edges at other ends, so the last digits differ.
void check_results(const Results& found, const Results& expected)
{
  CHECK_FIELDS_CLOSE(found.distances, expected.distances, 1e-13);
  CHECK_FIELDS_CLOSE(found.signed_distances, expected.signed_distances, 1e-13);
  CHECK_FIELDS_CLOSE(found.path_lengths, expected.path_lengths, 1e-13);
  CHECK_FIELDS_CLOSE(found.path_sizes, expected.path_sizes, 1e-13);
  CHECK_FIELDS_CLOSE(found.areas, expected.areas, 1e-13);
  CHECK_FIELDS_CLOSE(found.isoline_lengths, expected.isoline_lengths, 1e-13);
  CHECK(found.labels == expected.labels);
  CHECK(found.sources == expected.sources);
  CHECK(found.samples == expected.samples);
}

// The expected results mean something: each curve is the nearest one somewhere, and the link has two sides.
void check_expected(const Results& r)
{
  for(std::size_t i = 0; i < 3; ++i)
  {
    CHECK(std::count(r.labels.begin(), r.labels.end(), i) > 10);
    CHECK(r.areas[i] > 0);
    CHECK(r.isoline_lengths[i] > 0);
  }
  CHECK(*std::min_element(r.signed_distances.begin(), r.signed_distances.end()) < 0);
  CHECK(*std::max_element(r.signed_distances.begin(), r.signed_distances.end()) > 0);
  CHECK_EQUAL(r.samples.size(), std::size_t(5));
}

void test_other_structures()
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  using Complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;
  const Indexed_mesh sphere = noisy_sphere(3, .1, 5);
  const Mesh tm = to_face_graph(sphere);
  const Results expected = results_on(tm);
  check_expected(expected);
  {
    const test_support::Scope scope("polyhedron");
    Polyhedron polyhedron = to_face_graph<Polyhedron>(sphere);
    CGAL::set_halfedgeds_items_id(polyhedron);
    check_results(results_on(polyhedron), expected);
  }
  {
    const test_support::Scope scope("linear cell complex");
    check_results(results_on(to_face_graph<Complex>(sphere)), expected);
  }
}

// Part of a surface, and a copy of that part.
void test_filtered_graph()
{
  const test_support::Scope scope("filtered graph");
  const Mesh whole = to_face_graph(noisy_sphere(4, .1, 6));
  std::vector<face_descriptor> part;
  for(const face_descriptor f : faces(whole))
    if(whole.point(source(halfedge(f, whole), whole)).z() > -.5)
      part.push_back(f);
  CHECK(part.size() < num_faces(whole));
  const CGAL::Face_filtered_graph<Mesh> filtered(whole, part);
  Indexed_mesh copied;
  std::map<vertex_descriptor, std::size_t> number;
  for(const vertex_descriptor v : vertices(filtered))
  {
    number[v] = copied.points.size();
    copied.points.push_back({whole.point(v).x(), whole.point(v).y(), whole.point(v).z()});
  }
  for(const face_descriptor f : faces(filtered))
  {
    const auto h = halfedge(f, whole);
    copied.faces.push_back({number.at(source(h, whole)), number.at(target(h, whole)),
                            number.at(target(next(h, whole), whole))});
  }
  const Results expected = results_on(to_face_graph(copied));
  check_expected(expected);
  check_results(results_on(filtered), expected);
}

} // namespace

int main()
{
  test_other_structures();
  test_filtered_graph();
  return test_result();
}
