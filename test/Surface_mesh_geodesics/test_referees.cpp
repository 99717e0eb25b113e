// Distances against referees that share no rounding with the library: its own propagation with a hundred digits, with
// and without pruning rules, and a search of all edge sequences that is written from the definition. The meshes are
// small and hostile. Arguments: the number of meshes and the seed.

#include "distance_test_helpers.h"
#include "distances_with_rules.h"
#include "edge_sequence_search.h"
#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

using Hundred_digits =
  boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

// The error of double, relative to the distance. Points nearer to each other than a few units of rounding of the extent
// of the mesh are not distinguished.
const double tolerance = 1e-12;
const double tolerance_of_extent = 8 * std::numeric_limits<double>::epsilon();

// The same for a hundred digits. Some tolerances are square roots of the precision: a vertex of a needle thinner than
// 1e-50 may not be distinguished from the edge.
const double tolerance_of_hundred_digits = 1e-45;

using Without_rules = SMG::internal::No_pruning_rules;

struct Without_rules_of_pairs : Without_rules
{
  static constexpr bool vertex_rule = true;
};

double extent_of(const Indexed_mesh& mesh)
{
  double extent = 0;
  for(const Coordinates& p : mesh.points)
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      extent = (std::max)(extent, std::abs(p[i] - mesh.points.front()[i]));
    }
  }
  return extent;
}

template <class Rules>
std::vector<Hundred_digits> propagated(const Mesh& tm, vertex_descriptor source)
{
  auto map = get(CGAL::dynamic_vertex_property_t<Hundred_digits>(), tm);
  const Distance_options<Mesh> options;
  CHECK((distances_with_rules<Rules, Hundred_digits>(tm, map, source, options)));
  std::vector<Hundred_digits> result;
  for(const auto v : vertices(tm))
  {
    result.push_back(get(map, v));
  }
  return result;
}

// The largest difference of two fields, relative to the values.
double largest_difference(const std::vector<Hundred_digits>& a, const std::vector<Hundred_digits>& b)
{
  double largest = 0;
  for(std::size_t v = 0; v < a.size(); ++v)
  {
    if(a[v] != b[v])
    {
      const Hundred_digits d = abs(a[v] - b[v]) / (std::max)(a[v], b[v]);
      largest = d < infinity ? (std::max)(largest, static_cast<double>(d)) : infinity;
    }
  }
  return largest;
}

void check_close(const std::vector<double>& distances, const std::vector<Hundred_digits>& expected, double extent)
{
  CHECK_EQUAL(distances.size(), expected.size());
  for(std::size_t v = 0; v < distances.size(); ++v)
  {
    const double e = static_cast<double>(expected[v]);
    test_support::Scope scope("vertex " + std::to_string(v));
    CHECK_NEAR(distances[v], e, tolerance * e + tolerance_of_extent * extent);
  }
}

struct Counts
{
  std::size_t meshes = 0, distances = 0, with_hundred_digits = 0, without_rules_of_pairs = 0, without_rules = 0;
  double worst = 0;
};

void compare_on(const Indexed_mesh& indexed, const Mesh& tm, std::size_t source, Counts& counts)
{
  Edge_sequence_search<Hundred_digits> search(indexed);
  const std::vector<Hundred_digits> expected = search.from_vertex(source);
  check_close(distances(tm, vertex(source)), expected, extent_of(indexed));
  ++counts.meshes;
  counts.distances += expected.size();

  const auto compare = [&](const std::vector<Hundred_digits>& field)
  {
    const double difference = largest_difference(field, expected);
    counts.worst = (std::max)(counts.worst, difference);
    CHECK(difference <= tolerance_of_hundred_digits);
  };
  if(indexed.faces.size() <= 40)
  {
    compare(propagated<SMG::internal::All_pruning_rules>(tm, vertex(source)));
    ++counts.with_hundred_digits;
  }
  if(indexed.faces.size() <= 20)
  {
    test_support::Scope scope("without rules of pairs");
    compare(propagated<Without_rules_of_pairs>(tm, vertex(source)));
    ++counts.without_rules_of_pairs;
  }
  if(indexed.faces.size() <= 10)
  {
    test_support::Scope scope("without rules");
    compare(propagated<Without_rules>(tm, vertex(source)));
    ++counts.without_rules;
  }
}

void hostile_meshes_agree(std::size_t number, std::uint64_t seed)
{
  test_support::Random random(seed);
  Counts counts;
  while(counts.meshes < number)
  {
    Indexed_mesh indexed = hostile_meshes::hostile_mesh(random);
    if(indexed.faces.size() > 60)
    {
      continue;
    }
    Mesh tm;
    if(!hostile_meshes::is_surface(indexed, tm))
    {
      continue;
    }
    test_support::Scope scope("mesh " + std::to_string(counts.meshes) + ", " + indexed.name);
    compare_on(indexed, tm, std::size_t(random_vertex(tm, random)), counts);
  }
  CHECK(counts.with_hundred_digits >= number / 2);
  CHECK(counts.without_rules_of_pairs >= number / 4);
  CHECK(counts.without_rules >= number / 20);
  std::cout << counts.meshes << " hostile meshes, " << counts.distances << " distances; with a hundred digits "
            << counts.with_hundred_digits << ", " << counts.without_rules_of_pairs << " without rules of pairs, "
            << counts.without_rules << " without any rule: worst relative difference " << counts.worst << std::endl;
}

// Lengths between 1 and 1.9 make triangles of any shape. Most vertices are saddles or sharp; the surface has no
// embedding.
void random_metrics_agree(std::size_t number, std::uint64_t seed)
{
  test_support::Scope scope("random metrics");
  test_support::Random random(seed);
  const std::vector<Indexed_mesh> meshes = {icosahedron(),           octahedron(),
                                            torus(2., 1., 4, 3),     flat_patch(4, 4, 0., true, seed),
                                            prism_tube(5, 3, 1., 1.), saddle_fan(6)};
  for(std::size_t i = 0; i < number; ++i)
  {
    const Indexed_mesh& indexed = meshes[i % meshes.size()];
    test_support::Scope mesh_scope(indexed.name);
    Mesh tm = to_face_graph(indexed);
    auto lengths = tm.add_property_map<Mesh::Edge_index, double>("e:test_length", 0.).first;
    for(const auto e : edges(tm))
    {
      lengths[e] = random.uniform(1., 1.9);
    }
    const std::size_t source = std::size_t(random_vertex(tm, random));
    const auto length = [&](std::size_t a, std::size_t b)
    { return Hundred_digits(lengths[tm.edge(tm.halfedge(vertex(a), vertex(b)))]); };
    Edge_sequence_search<Hundred_digits> search(indexed, length, 3);
    check_close(distances_from_edge_lengths(tm, lengths, vertex(source)), search.from_vertex(source), 1.);
  }
}

// The referees against known distances.
void the_search_is_right()
{
  test_support::Scope scope("search");
  const Indexed_mesh patch = flat_patch(5, 4, .2, true, 3);
  Edge_sequence_search<Hundred_digits> on_patch(patch);
  const std::vector<Hundred_digits> d = on_patch.from_vertex(7);
  for(std::size_t v = 0; v < d.size(); ++v)
  {
    Hundred_digits square(0);
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Hundred_digits x = Hundred_digits(patch.points[v][i]) - Hundred_digits(patch.points[7][i]);
      square += x * x;
    }
    CHECK(abs(d[v] - sqrt(square)) <= Hundred_digits(1e-80));
  }
  // from a corner of a cube to the opposite one, across two faces
  const Indexed_mesh box = cube();
  Edge_sequence_search<Hundred_digits> on_box(box);
  const std::vector<Hundred_digits> from_corner = on_box.from_vertex(0);
  CHECK(abs(*std::max_element(from_corner.begin(), from_corner.end()) - sqrt(Hundred_digits(5)))
        <= Hundred_digits(1e-80));
  // a component that is not reached
  const Indexed_mesh apart = two_components_and_an_isolated_vertex();
  Edge_sequence_search<double> on_apart(apart);
  const std::vector<double> reached = on_apart.from_vertex(0), right = distances(to_face_graph(apart), vertex(0));
  CHECK_FIELDS_CLOSE(reached, right, 1e-13);
  CHECK_EQUAL(reached.back(), infinity);
}

} // namespace

int main(int argc, char* argv[])
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 200;
  const std::uint64_t seed = test_support::announce_seed(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 20260703);
  the_search_is_right();
  hostile_meshes_agree(number, seed);
  random_metrics_agree(60, seed + 1);
  return test_result();
}
