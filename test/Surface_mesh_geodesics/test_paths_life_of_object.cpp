// Thousands of random steps with one object: they add and remove sources, one by one and in ranges, build or clear the
// structure, replace points by edge lengths, and make queries of all kinds. A new object with the same sources gives
// the same answer to every query, and so does a const reference to the object.

#include "expected_exceptions.h"
#include "impatient_visitor.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"


#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

const std::size_t number_of_steps = 12000;

// A source, with the iterator that the object returned for it.
struct Known_source
{
  Surface_point point;
  Geodesic_paths::Source_point_iterator iterator;
};

class Life
{
public:
  Life(const Indexed_mesh& indexed, test_support::Random& random)
    : m_tm(to_face_graph(indexed)), m_size(size_of(m_tm)), m_random(random),
      m_lengths_of_points(add_edge_lengths(m_tm)),
      m_lengths(m_tm.add_property_map<Mesh::Edge_index, double>("e:used_length", 0.).first), m_paths(m_tm)
  {
    for(const auto e : edges(m_tm))
    {
      m_edges.push_back(e);
    }
  }

  void run(std::size_t steps)
  {
    for(std::size_t i = 0; i < steps; ++i)
    {
      const std::size_t action = m_random.index(40);
      test_support::Scope scope("step " + std::to_string(i) + ", action " + std::to_string(action));
      if(action < 16)
      {
        change_sources(action);
      }
      else if(action < 25)
      {
        change_state(action);
      }
      else
      {
        ask_something(action);
      }
      check_sources();
    }
  }

  std::size_t number_of_queries() const { return m_number_of_queries; }

private:
  void change_sources(std::size_t action)
  {
    if(action < 8)
    {
      add_one();
    }
    else if(action < 9)
    {
      add_range();
    }
    else if(action < 15)
    {
      remove_one();
    }
    else
    {
      m_paths.remove_all_source_points();
      m_sources.clear();
    }
  }

  void change_state(std::size_t action)
  {
    if(action < 20)
    {
      action < 18 ? m_paths.build_sequence_tree() : m_paths.build_sequence_tree_for_faces();
      CHECK(!m_paths.changed_since_last_build());
    }
    else if(action < 21)
    {
      m_paths.clear();
      m_sources.clear();
      m_factor = 0.;
      CHECK(!m_paths.changed_since_last_build());
    }
    else if(action < 23)
    {
      cancel();
    }
    else if(action < 24)
    {
      fail();
    }
    else
    {
      change_lengths();
    }
  }

  void ask_something(std::size_t action)
  {
    if(action < 28)
    {
      query_all_vertices();
    }
    else if(action < 29)
    {
      query_isolines();
    }
    else
    {
      query();
    }
  }

  // Returns a vertex, a point of an edge, a point of a face, or the point of an existing source.
  Surface_point random_point()
  {
    const std::size_t kind = m_random.index(8);
    if(kind == 0 && !m_sources.empty())
    {
      return m_sources[m_random.index(m_sources.size())].point;
    }
    if(kind < 4)
    {
      return Surface_point(vertex(m_random.index(num_vertices(m_tm))));
    }
    if(kind < 6)
    {
      auto h = halfedge(m_edges[m_random.index(m_edges.size())], m_tm);
      if(is_border(h, m_tm) || (m_random.index(2) == 0 && !is_border(opposite(h, m_tm), m_tm)))
      {
        h = opposite(h, m_tm);
      }
      return Surface_point(location_on_halfedge(h, m_random.index(3) == 0 ? .5 : m_random.uniform(), m_tm));
    }
    return Surface_point(random_location(m_tm, m_random));
  }

  void add_one()
  {
    const Surface_point point = random_point();
    m_sources.push_back({point, add(m_paths, point)});
    CHECK(m_paths.changed_since_last_build());
  }

  void add_range()
  {
    std::vector<Face_location> locations;
    for(std::size_t i = m_random.index(4); i > 0; --i)
    {
      locations.push_back(random_location(m_tm, m_random));
    }
    std::vector<Geodesic_paths::Face_location> range(locations.begin(), locations.end());
    auto it = m_paths.add_source_points(range.begin(), range.end());
    for(const Face_location& location : locations)
    {
      m_sources.push_back({Surface_point(location), it++});
    }
    CHECK(it == m_paths.source_points_end());
  }

  void remove_one()
  {
    if(m_sources.empty())
    {
      return;
    }
    const std::size_t i = m_random.index(m_sources.size());
    m_paths.remove_source_point(m_sources[i].iterator);
    m_sources.erase(m_sources.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK(m_paths.changed_since_last_build());
  }

  void cancel()
  {
    Impatient_visitor visitor;
    visitor.steps_left = m_random.index(3);
    const bool had_changed = m_paths.changed_since_last_build();
    const bool is_complete = m_random.index(2) == 0 ? m_paths.build_sequence_tree(visitor)
                                                    : m_paths.build_sequence_tree_for_faces(visitor);
    // A build that only adds windows keeps the distances of vertices.
    CHECK_EQUAL(m_paths.changed_since_last_build(), !is_complete && had_changed);
    CHECK(is_complete || had_changed || !m_sources.empty());
  }

  // The build rejects an invalid source, which is then removed.
  void fail()
  {
    const auto bad = m_paths.add_source_point(face(0), {.7, .7, .7});
    CHECK(throws<std::invalid_argument>([&] { m_paths.build_sequence_tree(); }));
    m_paths.remove_source_point(bad);
  }

  // Takes lengths from a map: those of the points times a factor. If the lengths are invalid, nothing changes.
  void change_lengths()
  {
    if(m_edges.empty())
    {
      return;
    }
    const bool is_bad = m_random.index(4) == 0;
    const double factor = m_random.uniform(.5, 3.);
    const bool had_changed = m_paths.changed_since_last_build();
    const std::size_t visits = m_paths.statistics().vertices_visited;
    use_lengths(m_paths, factor, is_bad);
    CHECK_EQUAL(m_paths.changed_since_last_build(), had_changed || (!is_bad && !m_sources.empty()));
    CHECK_EQUAL(m_paths.statistics().vertices_visited, visits);
    m_factor = is_bad ? m_factor : factor;
    for(const Mesh::Edge_index e : m_edges) // the object has copied them
    {
      m_lengths[e] = -1.;
    }
  }

  void use_lengths(Geodesic_paths& paths, double factor, bool is_bad)
  {
    for(const Mesh::Edge_index e : m_edges)
    {
      m_lengths[e] = factor * m_lengths_of_points[e];
    }
    m_lengths[m_edges[m_random.index(m_edges.size())]] *= is_bad ? -1. : 1.;
    CHECK_EQUAL(throws<std::invalid_argument>([&] { paths.use_edge_lengths(m_lengths); }), is_bad);
  }

  // Gives an object the same sources and the same lengths.
  void make_alike(Geodesic_paths& fresh)
  {
    if(m_factor > 0.)
    {
      use_lengths(fresh, m_factor, false);
    }
    for(const Known_source& s : m_sources)
    {
      add(fresh, s.point);
    }
  }

  void query()
  {
    ++m_number_of_queries;
    const Surface_point point = random_point();
    Geodesic_paths fresh(m_tm);
    make_alike(fresh);
    // the structure does not depend on whether windows are kept
    Answer answer = ask(m_paths, point);
    const Answer expected = ask(fresh, point);
    CHECK_EQUAL(answer.distance, expected.distance);
    CHECK_EQUAL(answer.source, expected.source);
    CHECK_EQUAL(nearest(m_paths, point), expected.source);
    CHECK_EQUAL(nearest(std::as_const(m_paths), point), expected.source);
    CHECK(!m_paths.changed_since_last_build());
    CHECK_EQUAL(m_paths.statistics().vertices_visited > 0, !m_sources.empty());
    if(m_random.index(2) == 0)
    {
      const Polyline polyline = polyline_of(m_paths, point);
      CHECK(polyline == polyline_of(fresh, point));
      CHECK(polyline == polyline_of(std::as_const(m_paths), point));
      if(m_factor == 0.)
      {
        const std::vector<Coordinates> points = checked_path(m_paths, point, m_tm, m_size);
        CHECK(points == checked_path(fresh, point, m_tm, m_size));
      }
      else
      {
        double length = 0.;
        for(std::size_t i = 1; i < polyline.size(); ++i)
        {
          length += m_factor * std::sqrt(CGAL::squared_distance(polyline[i - 1].first, polyline[i].first));
        }
        CHECK_NEAR(length, (std::max)(answer.distance, 0.), 1e-10 * m_size * m_factor);
      }
    }
  }

  void query_all_vertices()
  {
    ++m_number_of_queries;
    Geodesic_paths fresh(m_tm);
    make_alike(fresh);
    const auto farthest = m_paths.farthest_vertex();
    CHECK(farthest == fresh.farthest_vertex() && farthest == std::as_const(m_paths).farthest_vertex());
    auto distances = get(CGAL::dynamic_vertex_property_t<double>(), m_tm);
    auto expected = get(CGAL::dynamic_vertex_property_t<double>(), m_tm);
    m_paths.shortest_distances_to_source_points(distances);
    fresh.shortest_distances_to_source_points(expected);
    double largest = -1.;
    for(const vertex_descriptor v : vertices(m_tm))
    {
      CHECK_EQUAL(get(distances, v), get(expected, v));
      largest = (std::max)(largest, get(distances, v));
    }
    CHECK_EQUAL(farthest.second, largest);
    CHECK_EQUAL(farthest.first == boost::graph_traits<Mesh>::null_vertex(), m_sources.empty());
    std::as_const(m_paths).shortest_distances_to_source_points(expected);
    for(const vertex_descriptor v : vertices(m_tm))
    {
      CHECK_EQUAL(get(distances, v), get(expected, v));
    }
  }

  void query_isolines()
  {
    ++m_number_of_queries;
    Geodesic_paths fresh(m_tm);
    make_alike(fresh);
    const double value = m_random.uniform(.2, .9) * m_paths.farthest_vertex().second;
    std::vector<std::vector<Kernel::Point_3>> lines, expected, of_const;
    m_paths.isolines(value, std::back_inserter(lines));
    fresh.isolines(value, std::back_inserter(expected));
    std::as_const(m_paths).isolines(value, std::back_inserter(of_const));
    CHECK(lines == expected && lines == of_const);
    CHECK(value > 0. || lines.empty());
  }

  using Polyline = std::vector<std::pair<Kernel::Point_3, face_descriptor>>;

  // `Paths` may be const
  template <class Paths>
  static Polyline polyline_of(Paths& paths, const Surface_point& point)
  {
    Polyline result;
    ask_polyline(paths, point, std::back_inserter(result));
    return result;
  }

  template <class Paths>
  static std::size_t nearest(Paths& paths, const Surface_point& point)
  {
    return point.is_vertex() ? paths.nearest_source_point(point.vertex)
                             : paths.nearest_source_point(point.location.first, point.location.second);
  }

  // the iterators are those of the sources that are left, in the order of addition
  void check_sources()
  {
    CHECK_EQUAL(m_paths.number_of_source_points(), m_sources.size());
    auto it = m_paths.source_points_begin();
    for(const Known_source& s : m_sources)
    {
      if(!CHECK(it != m_paths.source_points_end()))
      {
        return;
      }
      CHECK(it == s.iterator);
      if(!s.point.is_vertex())
      {
        CHECK(s.iterator->first == s.point.location.first && s.iterator->second == s.point.location.second);
      }
      else if(m_tm.is_isolated(s.point.vertex))
      {
        CHECK(s.iterator->first == boost::graph_traits<Mesh>::null_face());
      }
      else
      {
        CHECK(*s.iterator == m_paths.face_location(s.point.vertex));
      }
      ++it;
    }
    CHECK(it == m_paths.source_points_end());
  }

  using Lengths = Mesh::Property_map<Mesh::Edge_index, double>;

  Mesh m_tm;
  const double m_size;
  test_support::Random& m_random;
  const Lengths m_lengths_of_points;
  Lengths m_lengths;
  double m_factor = 0.; // zero: lengths come from the points
  Geodesic_paths m_paths;
  std::vector<Mesh::Edge_index> m_edges;
  std::vector<Known_source> m_sources;
  std::size_t m_number_of_queries = 0;
};

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260405);
  test_support::Random random(seed);
  const std::vector<Indexed_mesh> meshes{
    irregular_tetrahedron(), cube(), noisy_sphere(1, .1, seed), rough_terrain(4, 1.5, seed),
    saddle_fan(6), strip(3), plane_cells("square with a hole", {"###", "#.#", "###"}),
    random_cuts(noisy_sphere(1, .1, seed), .3, seed), two_components_and_an_isolated_vertex(),
    to_indexed_mesh(load_data("single_triangle"), "single_triangle"),
    to_indexed_mesh(load_data("isolated_vertex"), "isolated_vertex"),
    to_indexed_mesh(load_data("two_tri_square"), "two_tri_square")};
  std::size_t number_of_queries = 0;
  for(const Indexed_mesh& indexed : meshes)
  {
    test_support::Scope scope(indexed.name);
    Life life(indexed, random);
    life.run(number_of_steps / meshes.size());
    number_of_queries += life.number_of_queries();
  }
  std::cout << number_of_steps << " steps, " << number_of_queries << " queries" << std::endl;
  return test_result();
}
