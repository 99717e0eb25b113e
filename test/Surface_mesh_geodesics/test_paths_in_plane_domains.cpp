// Paths in plane domains, convex or with holes. The distances are known from a visibility graph, or by hand: random
// points in all representations, sources near vertices, paths that bend at corners.

#include "path_test_helpers.h"
#include "surface_points.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;

// --- distances by a visibility graph: a convex domain minus some open boxes ---

struct Box
{
  double x0, y0, x1, y1;
};

bool sees(const Coordinates& p, const Coordinates& q, const Box& box)
{
  double begin = 0., end = 1.;
  const double low[2] = {box.x0, box.y0}, high[2] = {box.x1, box.y1};
  for(std::size_t i = 0; i < 2; ++i)
  {
    const double d = q[i] - p[i];
    if(std::abs(d) < 1e-13)
    {
      if(p[i] <= low[i] + 1e-13 || p[i] >= high[i] - 1e-13)
      {
        return true;
      }
      continue;
    }
    begin = (std::max)(begin, (std::min)((low[i] - p[i]) / d, (high[i] - p[i]) / d));
    end = (std::min)(end, (std::max)((low[i] - p[i]) / d, (high[i] - p[i]) / d));
  }
  return end - begin < 1e-9;
}

double plane_distance(const Coordinates& p, const Coordinates& q, const std::vector<Box>& boxes)
{
  std::vector<Coordinates> nodes{p, q};
  for(const Box& b : boxes)
  {
    for(const double x : {b.x0, b.x1})
    {
      for(const double y : {b.y0, b.y1})
      {
        if(std::abs(x) < 50. && std::abs(y) < 50.)
        {
          nodes.push_back({x, y, 0.});
        }
      }
    }
  }
  std::vector<double> d(nodes.size(), infinity);
  d[0] = 0.;
  for(std::size_t round = 0; round < nodes.size(); ++round)
  {
    for(std::size_t i = 0; i < nodes.size(); ++i)
    {
      for(std::size_t j = 0; j < nodes.size(); ++j)
      {
        if(std::all_of(boxes.begin(), boxes.end(), [&](const Box& b) { return sees(nodes[i], nodes[j], b); }))
        {
          d[j] = (std::min)(d[j], d[i] + length(nodes[j] - nodes[i]));
        }
      }
    }
  }
  return d[1];
}

// Checks random pairs of points of a plane mesh, each given in several ways.
void check_plane_mesh(const std::string& name, const Mesh& tm, const std::vector<Box>& boxes, std::size_t pairs,
                test_support::Random& random, double relative = tolerance)
{
  test_support::Scope scope(name);
  const double size = size_of(tm);
  Geodesic_paths paths(tm);
  for(std::size_t i = 0; i < pairs; ++i)
  {
    std::vector<Surface_point> sources = random_spot(tm, random);
    random.shuffle(sources);
    sources.resize((std::min)(sources.size(), std::size_t(3)), sources.front());
    std::vector<std::vector<Surface_point>> queries;
    for(std::size_t j = 0; j < 6; ++j)
    {
      queries.push_back(random_spot(tm, random));
      random.shuffle(queries.back());
      queries.back().resize((std::min)(queries.back().size(), std::size_t(4)), queries.back().front());
    }
    queries.push_back(sources); // from a point to itself
    for(const Surface_point& source : sources)
    {
      paths.remove_all_source_points();
      add(paths, source);
      test_support::Scope source_scope("from " + description(source));
      for(const std::vector<Surface_point>& spot : queries)
      {
        for(const Surface_point& query : spot)
        {
          test_support::Scope query_scope("to " + description(query));
          const double expected = plane_distance(position(source, tm), position(query, tm), boxes);
          const double d = ask(paths, query).distance;
          CHECK_NEAR(d, expected, relative * size);
          const auto points = checked_path(paths, query, tm, size, (std::max)(1e-10, relative));
          if(&spot == &queries.back())
          {
            CHECK(d <= 1e-15 * size);
            CHECK(points.size() == 1 || polyline_length(points) <= 1e-15 * size);
          }
        }
      }
    }
  }
}

void distances_between_random_points_are_those_in_the_domain(test_support::Random& random)
{
  for(const std::string name :
      {"two_tri_square", "two_tri_square_b", "single_triangle", "kite_pp3d30", "square100_gc111", "strip4", "grid4",
       "grid5", "grid6", "grid7", "grid8", "grid9", "grid5_tiny_1e-9", "grid5_huge_1e9", "needle_dup_position",
       "cap_zero_area"})
  {
    check_plane_mesh(name, load_data(name), {}, 40, random);
  }
  check_plane_mesh("grid5_offset_1e6", load_data("grid5_offset_1e6"), {}, 40, random, 1e-15);
  check_plane_mesh("sliver_1e-12", load_data("sliver_1e-12"), {}, 40, random, 1e-9);
  check_plane_mesh("L_shape", load_data("L_shape"), {{1., 1., 1e3, 1e3}}, 60, random);
  check_plane_mesh("square with one hole", to_face_graph(plane_cells("one hole", {"###", "#.#", "###"})),
             {{1., 1., 2., 2.}}, 100, random);
  check_plane_mesh("square with two holes", to_face_graph(plane_cells("two holes", {"#####", "#.#.#", "#####"})),
             {{1., 1., 2., 2.}, {3., 1., 4., 2.}}, 60, random);
}

// A source at a small distance from a vertex makes long and thin faces there.
void sources_near_to_vertices_have_exact_distances(test_support::Random& random)
{
  for(const std::string name : {"single_triangle", "two_tri_square", "grid4", "grid7"})
  {
    test_support::Scope scope(name + ", sources near to vertices");
    const Mesh tm = load_data(name);
    const double size = size_of(tm);
    Geodesic_paths paths(tm);
    for(std::size_t i = 0; i < 1000; ++i)
    {
      const double e = std::pow(10., -1. - static_cast<double>(i % 13)) * random.uniform(.5, 1.);
      const double share = random.index(2) == 0 ? 1. : random.uniform(.2, .8);
      const std::size_t k = random.index(3), side = 1 + random.index(2);
      Face_location source(face(random.index(num_faces(tm))), {0., 0., 0.});
      source.second[k] = 1. - e;
      source.second[(k + side) % 3] = e * share;
      source.second[(k + 3 - side) % 3] = e * (1. - share);
      paths.remove_all_source_points();
      add(paths, Surface_point(source));
      test_support::Scope source_scope("from " + description(Surface_point(source)));
      for(std::size_t j = 0; j < 4; ++j)
      {
        Face_location query = random_location(tm, random);
        if(j == 0)
        {
          query.first = source.first;
        }
        if(random.index(2) == 0)
        {
          const std::size_t zero = random.index(3);
          query.second[(zero + 1) % 3] += query.second[zero];
          query.second[zero] = 0.;
        }
        test_support::Scope query_scope("to " + description(Surface_point(query)));
        CHECK_NEAR(ask(paths, Surface_point(query)).distance, length(coordinates(source, tm) - coordinates(query, tm)),
                   tolerance * size);
        checked_path(paths, Surface_point(query), tm, size);
      }
    }
  }
}

// --- paths that bend, with distances by hand ---

Surface_point vertex_at(double x, double y, const Mesh& tm)
{
  for(const vertex_descriptor v : vertices(tm))
  {
    if(coordinates(v, tm) == Coordinates{x, y, 0.})
    {
      return Surface_point(v);
    }
  }
  CHECK(false);
  return Surface_point(vertex_descriptor());
}

// Returns the points where a path in the plane changes its direction.
std::vector<Coordinates> bends(const std::vector<Coordinates>& path)
{
  std::vector<Coordinates> result;
  for(std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    if(std::abs(cross(path[i] - path[i - 1], path[i + 1] - path[i])[2]) > 1e-10)
    {
      result.push_back(path[i]);
    }
  }
  return result;
}

// One query, with the possible bends of its path.
struct Path_by_hand
{
  double x, y, distance;
  std::vector<std::vector<Coordinates>> possible_bends;
};

void check_by_hand(const Mesh& tm, const Surface_point& source, const std::vector<Path_by_hand>& expected)
{
  Geodesic_paths paths(tm);
  add(paths, source);
  for(const Path_by_hand& path : expected)
  {
    for(const Surface_point& query : {vertex_at(path.x, path.y, tm), in_plane(path.x, path.y, tm)})
    {
      test_support::Scope scope("to " + description(query));
      CHECK_CLOSE(ask(paths, query).distance, path.distance, tolerance);
      const auto found = bends(checked_path(paths, query, tm, 3.));
      CHECK(std::find(path.possible_bends.begin(), path.possible_bends.end(), found) != path.possible_bends.end());
    }
  }
}

// A square of side 3 with a square hole in its middle, flat.
void paths_bend_around_a_hole()
{
  const double r2 = std::sqrt(2.), r5 = std::sqrt(5.);
  const Coordinates low{2., 1., 0.}, high{1., 2., 0.};
  for(const std::size_t n : {1u, 2u, 4u})
  {
    test_support::Scope scope("ring around a hole, cells of side 1/" + std::to_string(n));
    const Mesh tm = to_face_graph(plane_cells("ring", {"###", "#.#", "###"}, n));
    check_by_hand(tm, vertex_at(0., 0., tm),
                  {{3., 0., 3., {{}}},
                   {0., 3., 3., {{}}},
                   {1., 1., r2, {{}}},
                   {1., 2., r5, {{}}},
                   {2., 2., r5 + 1., {{low}, {high}}},
                   {2., 3., r5 + r2, {{high}}},
                   {3., 2., r5 + r2, {{low}}},
                   {3., 3., 2. * r5, {{low}, {high}}}});
    // along one side of the hole, or the other one
    check_by_hand(tm, vertex_at(1., 0., tm), {{1., 3., 3., {{}}}, {2., 3., 2. + r2, {{low}, {high}}}});
  }
}

// A square of side 2 without a quarter: the border has a corner that paths bend around.
void paths_bend_at_a_corner_of_the_border()
{
  const double r2 = std::sqrt(2.), r5 = std::sqrt(5.);
  const Coordinates corner{1., 1., 0.};
  for(const std::size_t n : {2u, 4u})
  {
    test_support::Scope scope("corner of the border, cells of side 1/" + std::to_string(n));
    const Mesh tm = to_face_graph(plane_cells("L", {"##", "#."}, n));
    check_by_hand(tm, vertex_at(1., 2., tm),
                  {{2., 1., 2., {{corner}}},
                   {2., 0., 1. + r2, {{corner}}},
                   {2., .5, 1. + r5 / 2., {{corner}}},
                   {1., 0., 2., {{}}},
                   {.5, 0., std::sqrt(4.25), {{}}},
                   {0., 0., r5, {{}}}});
    check_by_hand(tm, vertex_at(.5, 2., tm), {{2., .5, r5, {{corner}}}, {1.5, 0., r5, {{}}}});
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260402);
  test_support::Random random(seed);
  paths_bend_around_a_hole();
  paths_bend_at_a_corner_of_the_border();
  distances_between_random_points_are_those_in_the_domain(random);
  sources_near_to_vertices_have_exact_distances(random);
  return test_result();
}
