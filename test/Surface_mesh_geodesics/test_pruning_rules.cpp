// Each pruning rule only saves work: without it, the distances are the same, and there are more windows. They are also
// the same with a hundred digits, and those of a brute-force method that unfolds straight lines without any rule.

#include "brute_force_distances.h"
#include "distance_test_helpers.h"
#include "distances_with_rules.h"
#include "test_meshes.h"
#include "test_support.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <chrono>
#include <vector>

using namespace test_meshes;

namespace {

using Hundred_digits =
  boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

const double tolerance = 1e-13;

struct Without_rule_1 : SMG::internal::All_pruning_rules
{
  static constexpr bool rule_1 = false;
};

struct Without_pair_rules : SMG::internal::All_pruning_rules
{
  static constexpr bool pair_rules = false;
};

struct Without_vertex_rule : SMG::internal::All_pruning_rules
{
  static constexpr bool vertex_rule = false;
};

// The number of windows in all runs with these rules and this number type.
template <class Rules, class NumberType>
std::size_t windows_propagated = 0;

template <class Rules, class NumberType, class Sources>
std::vector<double> distances_with_rules(const Mesh& tm, const Sources& sources)
{
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  SMG::Propagation_statistics statistics;
  Distance_options<Mesh> options;
  options.statistics = &statistics;
  CHECK((test_meshes::distances_with_rules<Rules, NumberType>(tm, map, sources, options)));
  windows_propagated<Rules, NumberType> += statistics.windows_propagated;
  return values_at_vertices(tm, map);
}

template <class Sources>
void distances_are_the_same_without_each_rule(const Mesh& tm, const Sources& sources)
{
  const std::vector<double> expected = distances(tm, sources);
  CHECK((distances_with_rules<SMG::internal::All_pruning_rules, double>(tm, sources)) == expected);
  {
    test_support::Scope scope("without rule 1");
    CHECK_FIELDS_CLOSE((distances_with_rules<Without_rule_1, double>(tm, sources)), expected, tolerance);
  }
  {
    test_support::Scope scope("without pair rules");
    CHECK_FIELDS_CLOSE((distances_with_rules<Without_pair_rules, double>(tm, sources)), expected, tolerance);
  }
  {
    test_support::Scope scope("without vertex rule");
    CHECK_FIELDS_CLOSE((distances_with_rules<Without_vertex_rule, double>(tm, sources)), expected, tolerance);
  }
}

// Requires: the same runs have been made with each set of rules.
void each_rule_has_saved_windows()
{
  const std::size_t with_all = windows_propagated<SMG::internal::All_pruning_rules, double>;
  CHECK(with_all > 0);
  CHECK(with_all < (windows_propagated<Without_rule_1, double>));
  CHECK(with_all < (windows_propagated<Without_pair_rules, double>));
  CHECK(with_all < (windows_propagated<Without_vertex_rule, double>));
}

template <class Sources>
void distances_agree_with_a_hundred_digits(const Mesh& tm, const Sources& sources)
{
  test_support::Scope scope("100 digits");
  CHECK_FIELDS_CLOSE((distances_with_rules<SMG::internal::All_pruning_rules, Hundred_digits>(tm, sources)),
                     distances(tm, sources), tolerance);
}

void distances_agree_with_brute_force(const Indexed_mesh& indexed, const Mesh& tm, std::size_t source)
{
  test_support::Scope scope("brute force");
  Brute_force_distances<long double> brute_force(indexed);
  std::vector<double> expected;
  for(const long double d : brute_force.from_vertex(source))
  {
    expected.push_back(static_cast<double>(d));
  }
  CHECK_FIELDS_CLOSE(distances(tm, vertex(source)), expected, tolerance);
}

// Random lengths between 1 and 1.9 satisfy the triangle inequality in any mesh. Most vertices become saddles or sharp
// cones, and the surface is not embedded in space.
void distances_agree_with_brute_force_on_random_metrics(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name + ", random metric");
  Mesh tm = to_face_graph(indexed);
  auto lengths = tm.add_property_map<Mesh::Edge_index, double>("e:test_length", 0.).first;
  for(const auto e : edges(tm))
  {
    lengths[e] = random.uniform(1., 1.9);
  }
  auto length_between = [&](std::size_t a, std::size_t b) -> long double {
    return lengths[edge(halfedge(vertex(a), vertex(b), tm).first, tm)];
  };
  Brute_force_distances<long double> brute_force(indexed, length_between);
  const std::size_t source = std::size_t(random_vertex(tm, random));
  std::vector<double> expected;
  for(const long double d : brute_force.from_vertex(source))
  {
    expected.push_back(static_cast<double>(d));
  }
  CHECK_FIELDS_CLOSE(distances_from_edge_lengths(tm, lengths, vertex(source)), expected, tolerance);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260104);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : collection(seed))
  {
    test_support::Scope scope(indexed.name);
    const auto start = std::chrono::steady_clock::now();
    const Mesh tm = to_face_graph(indexed);
    const std::size_t number_of_faces = indexed.faces.size();
    if(number_of_faces <= 700)
    {
      distances_agree_with_brute_force(indexed, tm, std::size_t(random_vertex(tm, random)));
    }
    if(number_of_faces <= 400)
    {
      distances_agree_with_a_hundred_digits(tm, random_vertex(tm, random));
    }
    if(number_of_faces <= 200)
    {
      distances_are_the_same_without_each_rule(tm, random_vertex(tm, random));
      distances_are_the_same_without_each_rule(tm, random_location(tm, random));
      distances_are_the_same_without_each_rule(tm, std::vector<vertex_descriptor>{random_vertex(tm, random),
                                                                    random_vertex(tm, random)});
      distances_agree_with_a_hundred_digits(tm, std::vector<Face_location>{random_location(tm, random),
                                                            random_location(tm, random)});
    }
    if(number_of_faces <= 400)
    {
      distances_agree_with_brute_force_on_random_metrics(indexed, random);
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::cout << indexed.name << ", " << number_of_faces << " faces: " << time.count() << " s" << std::endl;
  }
  each_rule_has_saved_windows();
  return test_result();
}
