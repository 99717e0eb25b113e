// Minimal and unusual parameters of the class: a traits class with only what the concept SurfaceMeshShortestPathTraits
// requires, property maps of all four kinds, meshes of several types, exact kernels.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/properties_Linear_cell_complex_for_combinatorial_map.h>
#ifdef CGAL_USE_CORE
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;
const std::uint64_t seed = 20260404;

// --- comparison with the mesh type and the kernel of the other tests ---

// the weights of the corners of a triangle as coordinates in a face
template <class Graph, class Vertex, class Face>
std::array<double, 3> weights_in_face(const Triangle& triangle, const std::array<double, 3>& weights,
                                      const std::vector<Vertex>& all_vertices, Face f, const Graph& tm)
{
  const auto corners = corners_of_face<Graph>(f, tm);
  std::array<double, 3> result{};
  for(std::size_t k = 0; k < 3; ++k)
  {
    for(std::size_t l = 0; l < 3; ++l)
    {
      if(corners[k] == all_vertices[triangle[l]])
      {
        result[k] = weights[l];
      }
    }
  }
  return result;
}

// Compares the answers of an object of any type with those of the usual type, with sources and queries at vertices and
// in faces. `construct` makes coordinates from three numbers. Lengths of the first object are `scale` times as long.
template <class Paths, class Graph, class Construct>
class Comparison
{
public:
  Comparison(Paths& paths, const Graph& tm, const Indexed_mesh& indexed,
             const std::vector<typename Paths::vertex_descriptor>& all_vertices,
             const std::vector<typename Paths::face_descriptor>& all_faces, Construct construct, double scale)
    : m_paths(paths), m_tm(tm), m_indexed(indexed), m_vertices(all_vertices), m_faces(all_faces),
      m_construct(construct), m_scale(scale),
      m_expected_vertices(add_to_face_graph(indexed, m_expected_tm, &m_expected_faces)), m_expected(m_expected_tm),
      m_random(seed)
  {}

  void run()
  {
    for(std::size_t i = 0; i < 4; ++i)
    {
      i % 2 == 0 ? add_vertex() : add_location();
      for(std::size_t j = 0; j < 20; ++j)
      {
        m_points.clear();
        m_expected_points.clear();
        j % 2 == 0 ? ask_at_vertex() : ask_at_location();
        check_points();
      }
    }
  }

private:
  // A random point of a face for both objects.
  struct Location_pair
  {
    std::size_t face;
    std::array<double, 3> expected, weights;
  };

  std::size_t random_index_of_vertex() { return m_indexed.faces[m_random.index(m_indexed.faces.size())][0]; }

  Location_pair random_location_pair()
  {
    const std::size_t f = m_random.index(m_faces.size());
    const double a = m_random.uniform(.1, .4), b = m_random.uniform(.1, .4);
    const std::array<double, 3> w{a, b, 1. - a - b};
    return {f, weights_in_face(m_indexed.faces[f], w, m_expected_vertices, m_expected_faces[f], m_expected_tm),
            weights_in_face(m_indexed.faces[f], w, m_vertices, m_faces[f], m_tm)};
  }

  void add_vertex()
  {
    const std::size_t v = random_index_of_vertex();
    m_expected.add_source_point(m_expected_vertices[v]);
    m_paths.add_source_point(m_vertices[v]);
  }

  void add_location()
  {
    const Location_pair l = random_location_pair();
    m_expected.add_source_point(m_expected_faces[l.face], l.expected);
    m_paths.add_source_point(m_faces[l.face], m_construct(l.weights[0], l.weights[1], l.weights[2]));
  }

  void ask_at_vertex()
  {
    const std::size_t v = random_index_of_vertex();
    const double expected =
      m_expected.shortest_path_points_to_source_points(m_expected_vertices[v], std::back_inserter(m_expected_points))
        .first;
    const double distance = CGAL::to_double(
      m_paths.shortest_path_points_to_source_points(m_vertices[v], std::back_inserter(m_points)).first);
    CHECK_EQUAL(CGAL::to_double(m_paths.shortest_distance_to_source_points(m_vertices[v]).first), distance);
    CHECK_CLOSE(distance, m_scale * expected, tolerance);
  }

  void ask_at_location()
  {
    const Location_pair l = random_location_pair();
    const double expected = m_expected
                              .shortest_path_points_to_source_points(m_expected_faces[l.face], l.expected,
                                                                     std::back_inserter(m_expected_points))
                              .first;
    const auto b = m_construct(l.weights[0], l.weights[1], l.weights[2]);
    const double distance = CGAL::to_double(
      m_paths.shortest_path_points_to_source_points(m_faces[l.face], b, std::back_inserter(m_points)).first);
    CHECK_EQUAL(CGAL::to_double(m_paths.shortest_distance_to_source_points(m_faces[l.face], b).first), distance);
    CHECK_CLOSE(distance, m_scale * expected, tolerance);
  }

  void check_points()
  {
    if(!CHECK_EQUAL(m_points.size(), m_expected_points.size()))
    {
      return;
    }
    for(std::size_t k = 0; k < m_points.size(); ++k)
    {
      CHECK_NEAR(length(to_coordinates(m_points[k]) - m_scale * to_coordinates(m_expected_points[k])), 0., 1e-12);
    }
  }

  Paths& m_paths;
  const Graph& m_tm;
  const Indexed_mesh& m_indexed;
  const std::vector<typename Paths::vertex_descriptor>& m_vertices;
  const std::vector<typename Paths::face_descriptor>& m_faces;
  Construct m_construct;
  double m_scale;
  Mesh m_expected_tm;
  std::vector<face_descriptor> m_expected_faces;
  std::vector<vertex_descriptor> m_expected_vertices;
  Geodesic_paths m_expected;
  test_support::Random m_random;
  std::vector<typename Paths::Point_3> m_points;
  std::vector<Kernel::Point_3> m_expected_points;
};

template <class Paths, class Graph, class Construct>
void all_queries_agree(Paths& paths, const Graph& tm, const Indexed_mesh& indexed,
                       const std::vector<typename Paths::vertex_descriptor>& all_vertices,
                       const std::vector<typename Paths::face_descriptor>& all_faces, Construct construct,
                       double scale = 1.)
{
  Comparison<Paths, Graph, Construct>(paths, tm, indexed, all_vertices, all_faces, construct, scale).run();
}

const auto as_array = [](double a, double b, double c)
{ return std::array<double, 3>{a, b, c}; };

// --- a minimal traits class ---

// A point with its coordinates. Triangles and barycentric coordinates have no public members. Only the function objects
// read them.
class Archetype_point
{
public:
  Archetype_point() = default;
  Archetype_point(double x, double y, double z) : m_x(x), m_y(y), m_z(z) {}
  double x() const { return m_x; }
  double y() const { return m_y; }
  double z() const { return m_z; }
  bool operator==(const Archetype_point& p) const { return m_x == p.m_x && m_y == p.m_y && m_z == p.m_z; }
  bool operator!=(const Archetype_point& p) const { return !(*this == p); }

private:
  double m_x = 0., m_y = 0., m_z = 0.;
};

class Archetype_triangle
{
  friend struct Archetype_construct_triangle;
  friend struct Archetype_construct_vertex;
  Archetype_triangle(const Archetype_point& a, const Archetype_point& b, const Archetype_point& c) : m_points{a, b, c}
  {}
  std::array<Archetype_point, 3> m_points;
};

class Archetype_coordinates
{
  friend struct Archetype_construct_coordinates;
  friend struct Archetype_weight;
  Archetype_coordinates(double a, double b, double c) : m_weights{a, b, c} {}
  std::array<double, 3> m_weights;
};

struct Archetype_construct_triangle
{
  Archetype_triangle operator()(const Archetype_point& a, const Archetype_point& b, const Archetype_point& c) const
  {
    return {a, b, c};
  }
};

struct Archetype_construct_vertex
{
  Archetype_point operator()(const Archetype_triangle& t, int i) const
  {
    return t.m_points[static_cast<std::size_t>(i)];
  }
};

struct Archetype_construct_coordinates
{
  Archetype_coordinates operator()(double a, double b, double c) const { return {a, b, c}; }
};

struct Archetype_weight
{
  double operator()(const Archetype_coordinates& b, std::size_t i) const { return b.m_weights[i]; }
};

struct Archetype_construct_barycenter
{
  Archetype_point operator()(const Archetype_point& p, double w, const Archetype_point& q) const
  {
    return (*this)(p, w, q, 1. - w, q, 0.);
  }
  Archetype_point operator()(const Archetype_point& p, double u, const Archetype_point& q, double v,
                             const Archetype_point& r, double w) const
  {
    return {u * p.x() + v * q.x() + w * r.x(), u * p.y() + v * q.y() + w * r.y(), u * p.z() + v * q.z() + w * r.z()};
  }
};

struct Archetype_ray
{};

// Without a default constructor, the class has to use the given object.
class Archetype_traits
{
public:
  using Triangle_mesh = Mesh;
  using FT = double;
  using Point_3 = Archetype_point;
  using Ray_3 = Archetype_ray;
  using Triangle_3 = Archetype_triangle;
  using Barycentric_coordinates = Archetype_coordinates;
  using Construct_triangle_3 = Archetype_construct_triangle;
  using Construct_vertex_3 = Archetype_construct_vertex;
  using Construct_barycenter_3 = Archetype_construct_barycenter;
  using Construct_barycentric_coordinates = Archetype_construct_coordinates;
  using Construct_barycentric_coordinates_weight = Archetype_weight;

  explicit Archetype_traits(int) {}

  Construct_triangle_3 construct_triangle_3_object() const { return {}; }
  Construct_vertex_3 construct_vertex_3_object() const { return {}; }
  Construct_barycenter_3 construct_barycenter_3_object() const { return {}; }
  Construct_barycentric_coordinates construct_barycentric_coordinates_object() const { return {}; }
  Construct_barycentric_coordinates_weight construct_barycentric_coordinates_weight_object() const { return {}; }
};

// the points of a mesh as points of the archetype
struct Archetype_point_map
{
  using key_type = vertex_descriptor;
  using value_type = Archetype_point;
  using reference = Archetype_point;
  using category = boost::readable_property_map_tag;

  const Mesh* tm;
  friend Archetype_point get(const Archetype_point_map& map, vertex_descriptor v)
  {
    const Coordinates p = coordinates(v, *map.tm);
    return {p[0], p[1], p[2]};
  }
};

void a_minimal_traits_class_is_enough()
{
  test_support::Scope scope("minimal traits class");
  const Indexed_mesh indexed = noisy_sphere(2, .1, 3);
  Mesh tm;
  std::vector<face_descriptor> all_faces;
  const auto all_vertices = add_to_face_graph(indexed, tm, &all_faces);
  using Paths = CGAL::Surface_mesh_geodesic_paths<Archetype_traits, CGAL::Default, CGAL::Default, CGAL::Default,
                                                  Archetype_point_map>;
  Paths paths(tm, get(boost::vertex_index, tm), get(boost::halfedge_index, tm), get(boost::face_index, tm),
              Archetype_point_map{&tm}, Archetype_traits(0));
  all_queries_agree(paths, tm, indexed, all_vertices, all_faces, Archetype_construct_coordinates());
  const auto location = paths.face_location(halfedge(all_faces[5], tm), .25);
  CHECK(location.first == all_faces[5]);
  CHECK_EQUAL(Archetype_weight()(location.second, 0), .75);
  CHECK_EQUAL(Archetype_weight()(location.second, 1), .25);
  static_cast<void>(paths.face_location(all_vertices[3]));
  static_cast<void>(paths.point(halfedge(all_faces[5], tm), .25));
  std::vector<std::pair<Archetype_point, face_descriptor>> polyline;
  paths.shortest_path_polyline_to_source_points(all_vertices[7], std::back_inserter(polyline));
  CHECK(!polyline.empty());
}

// --- property maps ---

// A map that is only readable, and returns its values by copy.
template <class Key, class Value>
struct Own_map
{
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;

  const std::map<Key, Value>* values;
  friend Value get(const Own_map& map, const Key& key) { return map.values->at(key); }
};

void maps_of_the_user_replace_those_of_the_mesh()
{
  test_support::Scope scope("property maps");
  const Indexed_mesh indexed = noisy_sphere(2, .1, 4);
  Mesh tm;
  std::vector<face_descriptor> all_faces;
  const auto all_vertices = add_to_face_graph(indexed, tm, &all_faces);
  std::map<vertex_descriptor, unsigned int> vertex_indices;
  std::map<Mesh::Halfedge_index, unsigned int> halfedge_indices;
  std::map<face_descriptor, unsigned int> face_indices;
  std::map<vertex_descriptor, Kernel::Point_3> points;
  // the indices may have any order
  unsigned int i = static_cast<unsigned int>(num_vertices(tm));
  for(const vertex_descriptor v : vertices(tm))
  {
    const Coordinates p = 3. * coordinates(v, tm);
    vertex_indices[v] = --i;
    points.emplace(v, Kernel::Point_3(p[0], p[1], p[2]));
    tm.point(v) = Kernel::Point_3(1., 2., double(i)); // must not be read
  }
  i = static_cast<unsigned int>(num_halfedges(tm));
  for(const auto h : halfedges(tm))
  {
    halfedge_indices[h] = --i;
  }
  i = static_cast<unsigned int>(num_faces(tm));
  for(const face_descriptor f : faces(tm))
  {
    face_indices[f] = --i;
  }
  using VIM = Own_map<vertex_descriptor, unsigned int>;
  using HIM = Own_map<Mesh::Halfedge_index, unsigned int>;
  using FIM = Own_map<face_descriptor, unsigned int>;
  using VPM = Own_map<vertex_descriptor, Kernel::Point_3>;
  {
    using Paths = CGAL::Surface_mesh_geodesic_paths<Paths_traits, VIM, HIM, FIM, VPM>;
    static_assert(std::is_same<Paths::Vertex_index_map, VIM>::value, "");
    static_assert(std::is_same<Paths::Halfedge_index_map, HIM>::value, "");
    static_assert(std::is_same<Paths::Face_index_map, FIM>::value, "");
    static_assert(std::is_same<Paths::Vertex_point_map, VPM>::value, "");
    Paths paths(tm, VIM{&vertex_indices}, HIM{&halfedge_indices}, FIM{&face_indices}, VPM{&points});
    all_queries_agree(paths, tm, indexed, all_vertices, all_faces, as_array, 3.);
    CHECK(paths.point(all_vertices[5]) == points.at(all_vertices[5]));
  }
  {
    // only the map of points
    using Paths =
      CGAL::Surface_mesh_geodesic_paths<Paths_traits, CGAL::Default, CGAL::Default, CGAL::Default, VPM>;
    Paths paths(tm, get(boost::vertex_index, tm), get(boost::halfedge_index, tm), get(boost::face_index, tm),
                VPM{&points});
    all_queries_agree(paths, tm, indexed, all_vertices, all_faces, as_array, 3.);
  }
}

// --- mesh types ---

template <class Graph>
struct External_maps
{
  using Traits = boost::graph_traits<Graph>;
  using VIM = boost::const_associative_property_map<std::map<typename Traits::vertex_descriptor, std::size_t>>;
  using HIM = boost::const_associative_property_map<std::map<typename Traits::halfedge_descriptor, std::size_t>>;
  using FIM = boost::const_associative_property_map<std::map<typename Traits::face_descriptor, std::size_t>>;

  std::map<typename Traits::vertex_descriptor, std::size_t> vertex_indices;
  std::map<typename Traits::halfedge_descriptor, std::size_t> halfedge_indices;
  std::map<typename Traits::face_descriptor, std::size_t> face_indices;

  explicit External_maps(const Graph& tm)
  {
    for(const auto v : vertices(tm))
    {
      vertex_indices.emplace(v, vertex_indices.size());
    }
    for(const auto h : halfedges(tm))
    {
      halfedge_indices.emplace(h, halfedge_indices.size());
    }
    for(const auto f : faces(tm))
    {
      face_indices.emplace(f, face_indices.size());
    }
  }
};

template <class Graph>
void meshes_without_indices_need_external_maps_only(const std::string& name)
{
  test_support::Scope scope(name);
  using Maps = External_maps<Graph>;
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Graph>;
  using Paths =
    CGAL::Surface_mesh_geodesic_paths<Traits, typename Maps::VIM, typename Maps::HIM, typename Maps::FIM>;
  for(const Indexed_mesh& indexed : {noisy_sphere(2, .1, 5), rough_terrain(6, 1.5, 5)})
  {
    Graph tm;
    std::vector<typename Paths::face_descriptor> all_faces;
    const auto all_vertices = add_to_face_graph(indexed, tm, &all_faces);
    const Maps maps(tm);
    Paths paths(tm, typename Maps::VIM(maps.vertex_indices), typename Maps::HIM(maps.halfedge_indices),
                typename Maps::FIM(maps.face_indices), get(CGAL::vertex_point, tm));
    all_queries_agree(paths, tm, indexed, all_vertices, all_faces, as_array);
  }
}

void a_part_of_a_mesh_agrees_with_a_mesh_of_its_faces()
{
  test_support::Scope scope("Face_filtered_graph");
  using Graph = CGAL::Face_filtered_graph<Mesh>;
  const Indexed_mesh whole = noisy_sphere(2, .1, 6);
  Mesh tm;
  std::vector<face_descriptor> all_faces, kept_faces;
  const auto all_vertices = add_to_face_graph(whole, tm, &all_faces);
  // the faces of the upper half, and the same as a mesh
  Indexed_mesh part = whole;
  part.faces.clear();
  for(std::size_t f = 0; f < all_faces.size(); ++f)
  {
    const Triangle& t = whole.faces[f];
    if(whole.points[t[0]][2] + whole.points[t[1]][2] + whole.points[t[2]][2] > -.3)
    {
      kept_faces.push_back(all_faces[f]);
      part.faces.push_back(t);
    }
  }
  CHECK(kept_faces.size() < all_faces.size());
  const Graph graph(tm, kept_faces);
  using Paths = CGAL::Surface_mesh_geodesic_paths<CGAL::Surface_mesh_shortest_path_traits<Kernel, Graph>>;
  Paths paths(graph);
  all_queries_agree(paths, graph, part, all_vertices, kept_faces, as_array);
}

// --- kernels ---

template <class Exact_kernel>
void exact_kernels_give_the_same_answers(const std::string& name)
{
  test_support::Scope scope(name);
  using Exact_mesh = CGAL::Surface_mesh<typename Exact_kernel::Point_3>;
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Exact_kernel, Exact_mesh>;
  using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
  using FT = typename Exact_kernel::FT;
  const Indexed_mesh indexed = noisy_sphere(1, .1, 7);
  Exact_mesh tm;
  std::vector<typename Paths::face_descriptor> all_faces;
  const auto all_vertices = add_to_face_graph(indexed, tm, &all_faces);
  Paths paths(tm);
  all_queries_agree(paths, tm, indexed, all_vertices, all_faces,
                    [](double a, double b, double c) { return std::array<FT, 3>{FT(a), FT(b), FT(c)}; });
  // exact thirds
  const FT third = FT(1) / FT(3);
  paths.clear();
  paths.add_source_point(all_faces[5], {third, third, third});
  CHECK(paths.shortest_distance_to_source_points(all_faces[5], {third, third, third}).first == FT(0));
  const auto corner = source(halfedge(all_faces[5], tm), tm);
  std::vector<typename Exact_kernel::Point_3> points;
  paths.shortest_path_points_to_source_points(corner, std::back_inserter(points));
  CHECK_EQUAL(points.size(), 2u);
  CHECK(points.back() == paths.point(all_faces[5], {third, third, third}));
}

} // namespace

int main()
{
  test_support::announce_seed(seed);
  a_minimal_traits_class_is_enough();
  maps_of_the_user_replace_those_of_the_mesh();
  meshes_without_indices_need_external_maps_only<CGAL::Polyhedron_3<Kernel>>("Polyhedron_3");
  meshes_without_indices_need_external_maps_only<CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type>("Linear_cell_complex");
  a_part_of_a_mesh_agrees_with_a_mesh_of_its_faces();
  exact_kernels_give_the_same_answers<CGAL::Exact_predicates_exact_constructions_kernel>("exact constructions");
#ifdef CGAL_USE_CORE
  exact_kernels_give_the_same_answers<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt>(
    "exact constructions with roots");
#endif
  return test_result();
}
