// Thousands of random steps with one diagram: they add sites of all kinds, remove them, build or cancel, take other
// edge lengths, put up obstacles, and ask questions in any order. A new diagram with the same sites, lengths and
// obstacles gives the same answers, bit by bit, or the same exception.

#include "Voronoi_sites.h"
#include "curve_cases.h"
#include "expected_exceptions.h"
#include "impatient_visitor.h"
#include "test_meshes.h"
#include "test_support.h"

#include <cstddef>
#include <exception>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

using curve_cases::Curve;
using Numbers = std::vector<double>;

const std::size_t number_of_steps = 1500;

// A site as it was added.
struct Known_site
{
  Surface_point point;
  std::shared_ptr<const Curve> curve; // instead of the point, unless it is null
  double weight = 0.;
};

void add(Voronoi& diagram, const Known_site& s)
{
  if(s.curve != nullptr)
    diagram.add_site(*s.curve, s.weight);
  else if(s.point.is_vertex())
    diagram.add_site(s.point.vertex, s.weight);
  else
    diagram.add_site(s.point.location, s.weight);
}

void append(Numbers& numbers, const Face_location& l)
{
  numbers.push_back(static_cast<double>(static_cast<std::size_t>(l.first)));
  for(const double b : l.second)
    numbers.push_back(b);
}

class Life
{
public:
  Life(const Indexed_mesh& indexed, test_support::Random& random)
    : m_tm(to_face_graph(indexed)), m_random(random), m_lengths_of_points(add_edge_lengths(m_tm)),
      m_lengths(m_tm.add_property_map<Mesh::Edge_index, double>("e:used_length", 0.).first), m_diagram(m_tm)
  {
    for(const auto e : edges(m_tm))
      m_edges.push_back(e);
    for(const face_descriptor f : faces(m_tm))
      m_faces.push_back(f);
  }

  void run(std::size_t steps)
  {
    for(std::size_t i = 0; i < steps; ++i)
    {
      const std::size_t action = m_random.index(40);
      test_support::Scope scope("step " + std::to_string(i) + ", action " + std::to_string(action));
      if(action < 12)
        change_sites(action);
      else if(action < 22)
        change_state(action);
      else
        compare(m_random.index(number_of_questions));
      CHECK_EQUAL(m_diagram.number_of_sites(), m_sites.size());
    }
  }

  std::size_t number_of_answers() const { return m_number_of_answers; }
  std::size_t number_of_exceptions() const { return m_number_of_exceptions; }

private:
  // --- changes ---

  void change_sites(std::size_t action)
  {
    if(action < 10)
    {
      Known_site s{random_point(), nullptr, 0.};
      if(m_random.index(4) == 0)
        s.curve = std::make_shared<const Curve>(curve_cases::random_curve(m_tm, m_random));
      if(m_random.index(3) == 0)
        s.weight = m_random.uniform(-.3, .3) * m_factor_or_one();
      add(m_diagram, s);
      m_sites.push_back(s);
      CHECK(!m_diagram.is_built());
    }
    else if(action < 11)
    {
      m_diagram.remove_all_sites();
      m_sites.clear();
    }
    else
    {
      m_diagram.clear();
      m_sites.clear();
    }
  }

  void change_state(std::size_t action)
  {
    if(action < 14)
      cancel();
    else if(action < 16)
      take_lengths();
    else if(action < 17)
    {
      m_factor = 0.;
      m_diagram.use_points();
    }
    else if(action < 19)
    {
      m_avoided = some_of(m_faces);
      m_diagram.avoid_faces(m_avoided);
    }
    else if(action < 21)
    {
      m_walls = some_of(m_edges);
      m_diagram.avoid_edges(m_walls);
    }
    else
      reject();
  }

  // Ends a build early. Nothing is computed then.
  void cancel()
  {
    Impatient_visitor visitor;
    visitor.steps_left = m_random.index(4);
    visitor.throws = m_random.index(2) == 0;
    const bool was_built = m_diagram.is_built();
    bool is_complete = false;
    try
    {
      is_complete = m_diagram.build(visitor);
    }
    catch(const std::exception&)
    {}
    CHECK_EQUAL(m_diagram.is_built(), was_built || is_complete);
  }

  void take_lengths()
  {
    m_factor = m_random.uniform(.5, 3.);
    give_lengths(m_diagram);
  }

  void give_lengths(Voronoi& diagram)
  {
    for(const Mesh::Edge_index e : m_edges)
      m_lengths[e] = m_factor * m_lengths_of_points[e];
    diagram.use_edge_lengths(m_lengths);
  }

  // What is invalid changes nothing.
  void reject()
  {
    const bool was_built = m_diagram.is_built();
    const std::vector<face_descriptor> bad_faces{face_descriptor(static_cast<Mesh::size_type>(m_faces.size() + 3))};
    const std::vector<Mesh::Edge_index> bad_edges{Mesh::Edge_index(static_cast<Mesh::size_type>(m_edges.size() + 3))};
    CHECK(throws<Invalid_input>([&] { m_diagram.avoid_faces(bad_faces); }));
    CHECK(throws<Invalid_input>([&] { m_diagram.avoid_edges(bad_edges); }));
    CHECK(throws<Invalid_input>(
      [&] { m_diagram.add_site(random_point().location, std::numeric_limits<double>::infinity()); }));
    CHECK_EQUAL(m_diagram.is_built(), was_built);
  }

  template <typename Element>
  std::vector<Element> some_of(const std::vector<Element>& all)
  {
    std::vector<Element> some;
    for(std::size_t i = m_random.index(5); i > 0 && !all.empty(); --i)
      some.push_back(all[m_random.index(all.size())]);
    return some;
  }

  double m_factor_or_one() const { return m_factor > 0. ? m_factor : 1.; }

  Surface_point random_point()
  {
    if(m_random.index(2) == 0)
      return Surface_point(vertex(m_random.index(num_vertices(m_tm))));
    const auto l = random_location(m_tm, m_random);
    return Surface_point(Face_location(l.first, curve_cases::random_coordinates(m_random)));
  }

  // --- questions ---

  void make_alike(Voronoi& fresh)
  {
    if(m_factor > 0.)
      give_lengths(fresh);
    fresh.avoid_faces(m_avoided);
    fresh.avoid_edges(m_walls);
    for(const Known_site& s : m_sites)
      add(fresh, s);
  }

  void compare(std::size_t question)
  {
    Voronoi fresh(m_tm);
    make_alike(fresh);
    const Surface_point p = random_point();
    const std::size_t i = m_sites.empty() ? 0 : m_random.index(m_sites.size());
    std::string message, expected_message;
    const Numbers answer = ask(m_diagram, question, p, i, message);
    const Numbers expected = ask(fresh, question, p, i, expected_message);
    CHECK_EQUAL(message, expected_message);
    CHECK_EQUAL(answer.size(), expected.size());
    for(std::size_t k = 0; k < answer.size() && k < expected.size(); ++k)
      CHECK(answer[k] == expected[k] || (answer[k] != answer[k] && expected[k] != expected[k]));
    ++m_number_of_answers;
    m_number_of_exceptions += !message.empty();
  }

  Numbers ask(const Voronoi& diagram, std::size_t question, const Surface_point& p, std::size_t i,
              std::string& message) const
  {
    Numbers numbers;
    try
    {
      answer(diagram, question, p, i, numbers);
    }
    catch(const std::exception& e)
    {
      message = e.what();
      numbers.clear();
    }
    return numbers;
  }

  void answer(const Voronoi& diagram, std::size_t question, const Surface_point& p, std::size_t i,
              Numbers& numbers) const
  {
    switch(question)
    {
    case 0:
      append_arcs(diagram, numbers);
      break;
    case 1:
      for(const vertex_descriptor v : vertices(m_tm))
        numbers.push_back(static_cast<double>(diagram.nearest_site(v)));
      break;
    case 2:
      numbers.push_back(static_cast<double>(p.is_vertex() ? diagram.nearest_site(p.vertex)
                                                          : diagram.nearest_site(p.location)));
      break;
    case 3:
      numbers.push_back(p.is_vertex() ? diagram.distance_to_nearest_site(p.vertex)
                                      : diagram.distance_to_nearest_site(p.location));
      break;
    case 4:
      append_nearest_sites(diagram, p, numbers);
      break;
    case 5:
      for(std::size_t k = 0; k < m_sites.size(); ++k)
        numbers.push_back(diagram.area(k));
      break;
    case 6:
      for(const Voronoi::Vertex& v : diagram.vertices())
      {
        append(numbers, v.location());
        numbers.push_back(v.distance());
      }
      numbers.push_back(diagram.energy());
      break;
    case 7:
      if(!m_sites.empty())
      {
        numbers.push_back(diagram.Euler_characteristic(i));
        for(const auto& line : diagram.boundary_polylines(i))
          for(const auto& l : line.locations)
            append(numbers, l);
      }
      break;
    case 8:
      if(!m_sites.empty())
      {
        append(numbers, diagram.site(i));
        const auto c = diagram.centroid(i);
        for(int k = 0; k < 3; ++k)
          numbers.push_back(c[k]);
        numbers.push_back(static_cast<double>(static_cast<std::size_t>(diagram.central_vertex(i))));
      }
      break;
    default:
      append_cut_mesh(diagram, numbers);
    }
  }

  static void append_arcs(const Voronoi& diagram, Numbers& numbers)
  {
    for(const Voronoi::Arc& a : diagram.arcs())
    {
      append(numbers, a.point(0.));
      append(numbers, a.point(.7));
      numbers.push_back(static_cast<double>(a.sites().first));
      numbers.push_back(a.distance(1.));
    }
  }

  static void append_cut_mesh(const Voronoi& diagram, Numbers& numbers)
  {
    Mesh cells;
    const auto site = cells.add_property_map<Mesh::Face_index, std::size_t>("f:site", 0).first;
    diagram.cut(cells, site);
    for(const auto v : vertices(cells))
      for(int k = 0; k < 3; ++k)
        numbers.push_back(cells.point(v)[k]);
    for(const auto f : faces(cells))
      numbers.push_back(static_cast<double>(site[f]));
  }

  static void append_nearest_sites(const Voronoi& diagram, const Surface_point& p, Numbers& numbers)
  {
    std::vector<std::size_t> sites;
    if(p.is_vertex())
      diagram.nearest_sites(p.vertex, std::back_inserter(sites));
    else
      diagram.nearest_sites(p.location, std::back_inserter(sites));
    for(const std::size_t i : sites)
      numbers.push_back(static_cast<double>(i));
  }

  static const std::size_t number_of_questions = 10;

  Mesh m_tm;
  test_support::Random& m_random;
  Edge_lengths m_lengths_of_points, m_lengths;
  Voronoi m_diagram;
  std::vector<Mesh::Edge_index> m_edges, m_walls;
  std::vector<face_descriptor> m_faces, m_avoided;
  std::vector<Known_site> m_sites;
  double m_factor = 0.; // of the lengths in use, 0 for those of the points
  std::size_t m_number_of_answers = 0, m_number_of_exceptions = 0;
};

} // namespace

int main()
{
  test_support::Random random(20261);
  std::size_t answers = 0, exceptions = 0;
  for(const Indexed_mesh& mesh : small_collection(3))
  {
    test_support::Scope scope(mesh.name);
    Life life(mesh, random);
    life.run(number_of_steps / 10);
    answers += life.number_of_answers();
    exceptions += life.number_of_exceptions();
  }
  CHECK(answers > 500);
  CHECK(exceptions > 0 && 2 * exceptions < answers);
  std::cout << answers << " answers, " << exceptions << " exceptions" << std::endl;
  return test_result();
}
