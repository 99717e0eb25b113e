// The answers of Surface_mesh_shortest_path on the smallest meshes that show each of its faults, and the right ones.
// All meshes are plane and contain the straight line between the two points, so the distance is the length of the line.
//
// The program prints the table of the user manual. It fails if our answers are wrong, not if the other class has been
// repaired. The assertions of that class are a part of its answers, so they are enabled here.
#undef NDEBUG
#undef CGAL_NDEBUG

#include "distance_test_helpers.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>

#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/version.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

// If an assertion of the other class fails, its memory leaks. Tells the leak sanitizer to ignore that.
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions()
{
  return "leak:Surface_mesh_shortest_path\n";
}

using namespace test_meshes;

namespace {

using Original = CGAL::Surface_mesh_shortest_path<Paths_traits>;

const double tolerance = 1e-14;

std::string text(double number)
{
  if(std::isnan(number))
  {
    return "nan"; // with either sign
  }
  std::ostringstream out;
  out << std::setprecision(6) << number;
  return out.str();
}

// One row of the table. Numbers are in the unit of the mesh.
class Row
{
public:
  Row(const std::string& mesh, const Indexed_mesh& indexed, const std::string& question, double unit = 1.)
    : m_scope(question), m_mesh(mesh), m_number_of_faces(indexed.faces.size()), m_question(question), m_unit(unit),
      m_tm(to_face_graph(scaled(indexed, unit))), m_ours(m_tm), m_original(m_tm)
  {}

  const Mesh& mesh() const { return m_tm; }

  // Adds a source to both classes.
  void add_source(const Surface_point& p)
  {
    add_to(m_ours, p);
    ask_original([&]() {
      add_to(m_original, p);
      return std::string();
    });
  }

  // The distance is `expected` times the unit. If `asks_original` is false, the other class is not queried.
  void ask_distance(const Surface_point& q, double expected, bool asks_original = true)
  {
    const double d = ask(m_ours, q).distance;
    const double expected_answer = expected < 0. ? expected : expected * m_unit;
    CHECK_CLOSE(d, expected_answer, tolerance);
    add(m_our_answers, text(d < 0. ? d : d / m_unit));
    if(asks_original)
    {
      ask_original([&]() {
        const double other = answer_of_original(q);
        return text(other < 0. ? other : other / m_unit);
      });
    }
  }

  // The number of points of the path is a column of the table.
  void ask_path(const Surface_point& q, const std::vector<Coordinates>& expected)
  {
    add(m_our_answers, std::to_string(check_path(q, expected)) + " points");
    ask_original([&]() {
      std::vector<Kernel::Point_3> other;
      ask_points(m_original, q, std::back_inserter(other));
      return std::to_string(other.size()) + " points";
    });
  }

  // Checks that our path has these points; returns their number.
  std::size_t check_path(const Surface_point& q, const std::vector<Coordinates>& expected)
  {
    std::vector<Kernel::Point_3> points;
    ask_points(m_ours, q, std::back_inserter(points));
    CHECK_EQUAL(points.size(), expected.size());
    for(std::size_t i = 0; i < points.size() && i < expected.size(); ++i)
    {
      const Coordinates difference = (1. / m_unit) * to_coordinates(points[i]) - expected[i];
      CHECK(length(difference) <= 16. * tolerance);
    }
    return points.size();
  }

  // Certifies the distances of all vertices from a vertex, for any query.
  void certify(std::size_t source)
  {
    const auto map = m_tm.add_property_map<vertex_descriptor, double>("v:distance", 0.).first;
    CHECK(SMG::geodesic_distances(m_tm, map, vertex(source)));
    CHECK(SMG::certify_geodesic_distances(m_tm, map, vertex(source)).is_certified());
  }

  void set_answer_of_original(const std::string& answer) { m_original_answers = answer; }

  void print() const
  {
    std::cout << "| " << m_mesh << " | " << m_number_of_faces << " | " << m_question << " | " << m_original_answers
              << " | " << m_our_answers << " |" << std::endl;
  }

private:
  template <class Paths>
  static void add_to(Paths& paths, const Surface_point& p)
  {
    if(p.is_vertex())
    {
      paths.add_source_point(p.vertex);
    }
    else
    {
      paths.add_source_point(p.location);
    }
  }

  static void add(std::string& answers, const std::string& answer)
  {
    answers += (answers.empty() || answer.empty() ? "" : ", ") + answer;
  }

  double answer_of_original(const Surface_point& q)
  {
    return q.is_vertex() ? m_original.shortest_distance_to_source_points(q.vertex).first
                         : m_original.shortest_distance_to_source_points(q.location.first, q.location.second).first;
  }

  // After a failure the object of the other class is no longer used.
  template <class Question>
  void ask_original(const Question& question)
  {
    if(m_has_failed)
    {
      return;
    }
    try
    {
      const std::string answer = question();
      add(m_original_answers, answer);
    }
    catch(const CGAL::Failure_exception&)
    {
      m_has_failed = true;
      add(m_original_answers, "assertion fails");
    }
  }

  test_support::Scope m_scope;
  std::string m_mesh;
  std::size_t m_number_of_faces;
  std::string m_question;
  double m_unit;
  Mesh m_tm;
  Geodesic_paths m_ours;
  Original m_original;
  bool m_has_failed = false;
  std::string m_our_answers, m_original_answers;
};

// --- the meshes ---

Indexed_mesh triangle()
{
  return {"triangle", {{0., 0., 0.}, {3., 0., 0.}, {0., 4., 0.}}, {{0, 1, 2}}};
}

Indexed_mesh square()
{
  return {"square", {{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {1., 1., 0.}}, {{0, 1, 2}, {2, 1, 3}}};
}

Indexed_mesh triangle_and_point()
{
  return {"triangle and point", {{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {5., 5., 5.}}, {{0, 1, 2}}};
}

// Two vertices are at (1, 0, 0): the first face is the segment from (0, 0, 0) to there.
Indexed_mesh edge_without_length()
{
  return {"edge without length", {{0., 0., 0.}, {1., 0., 0.}, {1., 0., 0.}, {2., 1., 0.}}, {{0, 1, 2}, {2, 1, 3}}};
}

// The line from the first vertex to the last one crosses all three inner edges.
Indexed_mesh fan_of_four()
{
  return {"fan of four",
          {{0., 2., 0.}, {1., 2., 0.}, {4., 4., 0.}, {2., 0., 0.}, {5., 2., 0.}, {5., 4., 0.}},
          {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {2, 4, 5}}};
}

// --- locations ---

// Returns the point of a face with these weights of its vertices.
Surface_point in_face(std::size_t f, const std::array<std::pair<std::size_t, double>, 3>& weights, const Mesh& tm)
{
  Face_location location(face(f), {0., 0., 0.});
  const auto corners = corners_of_face(face(f), tm);
  for(std::size_t k = 0; k < 3; ++k)
  {
    for(const auto& weight : weights)
    {
      if(corners[k] == vertex(weight.first))
      {
        location.second[k] = weight.second;
      }
    }
  }
  return Surface_point(location);
}

// --- the rows ---

void sources_on_edges_have_exact_distances()
{
  {
    Row row("triangle", triangle(), "from (3/4, 0) to the corners");
    row.add_source(on_edge(0, 1, .25, row.mesh()).front());
    row.ask_distance(vertex(0), .75);
    row.ask_distance(vertex(1), 2.25);
    row.ask_distance(vertex(2), std::sqrt(.75 * .75 + 4. * 4.));
    row.check_path(vertex(2), {{0., 4., 0.}, {.75, 0., 0.}});
    row.print();
  }
  Row row("triangle", triangle(), "from (3/4, 0) to itself");
  row.add_source(on_edge(0, 1, .25, row.mesh()).front());
  row.ask_distance(on_edge(0, 1, .25, row.mesh()).front(), 0.);
  row.print();
}

void sources_at_vertices_up_to_rounding_are_the_vertices()
{
  {
    Row row("triangle", triangle(), "from (0, 4), and 1.1e-16 of its weight at (0, 0), to the corners");
    row.add_source(in_face(0, {{{0, 1.1e-16}, {1, 0.}, {2, 1.}}}, row.mesh()));
    row.ask_distance(vertex(0), 4.);
    row.ask_distance(vertex(1), 5.);
    row.ask_distance(vertex(2), 0.);
    row.print();
  }
  Row row("triangle", triangle(), "from (0, 4), and -1.1e-16 of its weight at (0, 0), to the corners");
  row.add_source(in_face(0, {{{0, -1.1e-16}, {1, 0.}, {2, 1.}}}, row.mesh()));
  row.ask_distance(vertex(0), 4.);
  row.ask_distance(vertex(1), 5.);
  row.ask_distance(vertex(2), 0.);
  row.print();
}

void queries_on_the_border_are_answered()
{
  Row row("triangle", triangle(), "from (0, 4) to (0, 3/2)");
  row.add_source(vertex(2));
  row.ask_distance(on_edge(0, 2, .375, row.mesh()).front(), 2.5);
  row.print();
}

void several_sources_are_all_found()
{
  {
    Row row("square", square(), "from both (0, 0) and (1, 0) to the corners");
    row.add_source(vertex(0));
    row.add_source(vertex(1));
    for(std::size_t i = 0; i < 4; ++i)
    {
      row.ask_distance(vertex(i), i < 2 ? 0. : 1.);
    }
    row.print();
  }
  Row row("square", square(), "from both (3/4, 1/8) and (5/8, 1/8) to (5/8, 1/2)");
  row.add_source(in_face(0, {{{0, .125}, {1, .75}, {2, .125}}}, row.mesh()));
  row.add_source(in_face(0, {{{0, .25}, {1, .625}, {2, .125}}}, row.mesh()));
  const Surface_point query = in_face(1, {{{1, .5}, {2, .375}, {3, .125}}}, row.mesh());
  CHECK((coordinates(query.location, row.mesh()) == Coordinates{.625, .5, 0.}));
  row.ask_distance(query, .375);
  row.check_path(query, {{.625, .5, 0.}, {.625, .375, 0.}, {.625, .125, 0.}});
  row.print();
}

void edges_may_have_no_length()
{
  Row row("triangle with an edge of length 0", edge_without_length(), "from (0, 0) to the vertices");
  row.add_source(vertex(0));
  const std::array<double, 4> expected{0., 1., 1., 1. + std::sqrt(2.)};
  for(std::size_t i = 0; i < 4; ++i)
  {
    row.ask_distance(vertex(i), expected[i], false);
  }
  row.set_answer_of_original("freed memory is read"); // so the test does not query it here
  row.print();
}

void isolated_vertices_reach_themselves_only()
{
  Row row("triangle and a vertex without faces", triangle_and_point(), "from the vertex to all vertices");
  row.add_source(vertex(3));
  for(std::size_t i = 0; i < 4; ++i)
  {
    row.ask_distance(vertex(i), i == 3 ? 0. : -1.);
  }
  row.print();
}

void points_of_paths_are_not_repeated()
{
  Row row("square", square(), "from (0, 0) to (3/8, 5/8): the path");
  row.add_source(vertex(0));
  row.ask_path(on_edge(1, 2, .625, row.mesh()).front(), {{.375, .625, 0.}, {0., 0., 0.}});
  row.print();
}

// From (0, 2) to (5, 4) the line has the points (5/2, 3), (15/4, 7/2) and (25/6, 11/3) on inner edges.
void rays_near_vertices_are_not_lost(double unit, const std::string& name)
{
  Row row("fan of four triangles, unit " + name, fan_of_four(), "from (0, 2) to (5, 4)", unit);
  row.add_source(vertex(0));
  row.ask_distance(vertex(5), std::sqrt(29.));
  row.check_path(vertex(5), {{5., 4., 0.}, {25. / 6., 11. / 3., 0.}, {3.75, 3.5, 0.}, {2.5, 3., 0.}, {0., 2., 0.}});
  row.certify(0);
  row.print();
}

void small_meshes_have_exact_distances()
{
  for(const double unit : {1e-160, 1e-170})
  {
    Row row("triangle, unit " + text(unit), triangle(), "from (0, 0) to the corners", unit);
    row.add_source(vertex(0));
    row.ask_distance(vertex(0), 0.);
    row.ask_distance(vertex(1), 3.);
    row.ask_distance(vertex(2), 4.);
    row.certify(0);
    row.print();
  }
}

} // namespace

int main()
{
  std::cout << "CGAL " << CGAL_VERSION_STR << "\n"
            << "| mesh | faces | question | `Surface_mesh_shortest_path` | this package |\n"
            << "|---|--:|---|---|---|\n";
  sources_on_edges_have_exact_distances();
  sources_at_vertices_up_to_rounding_are_the_vertices();
  queries_on_the_border_are_answered();
  several_sources_are_all_found();
  edges_may_have_no_length();
  isolated_vertices_reach_themselves_only();
  points_of_paths_are_not_repeated();
  rays_near_vertices_are_not_lost(3., "3");
  rays_near_vertices_are_not_lost(1., "1");
  rays_near_vertices_are_not_lost(1e-120, "1e-120");
  rays_near_vertices_are_not_lost(1e120, "1e120");
  small_meshes_have_exact_distances();
  return test_result();
}
