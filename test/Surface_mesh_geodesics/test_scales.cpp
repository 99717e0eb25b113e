// Neither the unit of a mesh nor its position in space changes an answer: distances, paths, geodesic Voronoi diagrams.
//
// With a power of two as the unit, all coordinates are multiplied without rounding, and the answers are the same bits.
// With any other unit, or far from the origin, coordinates are rounded. The result is another mesh, whose vertices have
// moved by at most m = sqrt(3) u M, where u = 2^-53 and M is the largest coordinate. A path of n pieces on one
// mesh is a path of n pieces on the other one, if its points keep their barycentric coordinates, and each piece becomes
// longer by at most 2 m. So the distances d on both meshes differ by at most 2 n m, where n belongs to the path with
// more pieces, plus the errors of the two computations, a few units for each face: less than 8 n u d each. The answers
// for the rounded mesh are also certified.

#include "Voronoi_test_helpers.h"
#include "distance_test_helpers.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

const double unit_roundoff = 0x1p-53;

// --- queries ---

struct Questions
{
  vertex_descriptor vertex_source;
  std::vector<Face_location> location_sources;
  std::vector<Face_location> queries;
  Weighted_sites sites; // weights in the unit of the mesh
};

Questions questions_for(const Mesh& tm, test_support::Random& random)
{
  Questions q;
  q.vertex_source = random_vertex(tm, random);
  for(std::size_t i = 0; i < 3; ++i)
  {
    q.location_sources.push_back(random_location(tm, random));
    q.queries.push_back(random_location(tm, random));
  }
  q.sites = random_sites(tm, 4, .01, random);
  return q;
}

// All answers on one mesh. Each distance has the number of pieces of its path.
struct Answers
{
  std::vector<double> distances; // of vertices and of the queries
  std::vector<std::size_t> pieces;
  std::vector<double> coordinates; // of all points of paths and of the diagram
  std::vector<double> lengths;     // of the arcs of the diagram, and distances of their points
  std::vector<double> areas;
  std::vector<double> parameters; // numbers without a unit: indices, barycentric coordinates
};

void add_distances(Geodesic_paths& paths, const std::vector<Surface_point>& queries, Answers& answers)
{
  for(const Surface_point& p : queries)
  {
    std::vector<Kernel::Point_3> points;
    const double d = ask_points(paths, p, std::back_inserter(points)).distance;
    answers.distances.push_back(d < 0. ? infinity : d); // -1 means unreachable and has no unit
    answers.pieces.push_back(points.empty() ? 0 : points.size() - 1);
    for(const Kernel::Point_3& point : points)
    {
      answers.coordinates.insert(answers.coordinates.end(), {point.x(), point.y(), point.z()});
    }
  }
}

void add_location(const Face_location& l, Answers& answers)
{
  answers.parameters.push_back(static_cast<double>(std::size_t(l.first)));
  answers.parameters.insert(answers.parameters.end(), l.second.begin(), l.second.end());
}

void add_diagram(const Voronoi& diagram, Answers& answers)
{
  for(const Voronoi::Arc& a : diagram.arcs())
  {
    for(const double t : {0., .25, 1.})
    {
      add_location(a.point(t), answers);
      answers.lengths.push_back(a.distance(t));
    }
    answers.lengths.push_back(a.length());
  }
  for(const Voronoi::Vertex& v : diagram.vertices())
  {
    add_location(v.location(), answers);
    const auto p = v.point();
    answers.coordinates.insert(answers.coordinates.end(), {p.x(), p.y(), p.z()});
    answers.lengths.push_back(v.distance());
  }
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
  {
    answers.areas.push_back(diagram.area(i));
    const auto c = diagram.centroid(i);
    answers.coordinates.insert(answers.coordinates.end(), {c.x(), c.y(), c.z()});
    answers.parameters.push_back(static_cast<double>(diagram.Euler_characteristic(i)));
  }
  for(const vertex_descriptor v : vertices(diagram.triangle_mesh()))
  {
    answers.parameters.push_back(static_cast<double>(diagram.nearest_site(v)));
  }
}

Weighted_sites with_unit(Weighted_sites sites, double unit)
{
  for(Weighted_site& s : sites)
  {
    s.weight *= unit;
  }
  return sites;
}

// Adds the distances and the numbers of pieces, not the diagram.
Answers answers_for(const Mesh& tm, const Questions& q, double unit, bool has_diagram)
{
  Answers answers;
  std::vector<Surface_point> points(vertices(tm).begin(), vertices(tm).end());
  points.insert(points.end(), q.queries.begin(), q.queries.end());
  Geodesic_paths paths(tm);
  paths.add_source_point(q.vertex_source);
  add_distances(paths, points, answers);
  paths.remove_all_source_points();
  paths.add_source_points(q.location_sources.begin(), q.location_sources.end());
  add_distances(paths, points, answers);
  if(has_diagram)
  {
    Voronoi diagram(tm);
    add_sites(diagram, with_unit(q.sites, unit));
    add_diagram(diagram, answers);
  }
  return answers;
}

// --- powers of two ---

void check_bits(const std::vector<double>& found, const std::vector<double>& expected, double factor, const char* name)
{
  test_support::Scope scope(name);
  if(!CHECK_EQUAL(found.size(), expected.size()))
  {
    return;
  }
  std::size_t differ = 0;
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    differ += found[i] != expected[i] * factor ? 1 : 0;
  }
  CHECK_EQUAL(differ, 0u);
}

// The unit 2^-500 is about 3e-151, and areas in it are 9e-302: normal numbers.
void powers_of_two_change_no_bit(const Indexed_mesh& indexed, const Questions& q)
{
  const Answers expected = answers_for(to_face_graph(indexed), q, 1., true);
  for(const int k : {-500, -301, -30, -1, 30, 301, 490})
  {
    test_support::Scope scope("unit 2^" + std::to_string(k));
    const double unit = std::ldexp(1., k);
    const Answers found = answers_for(to_face_graph(scaled(indexed, unit)), q, unit, true);
    check_bits(found.distances, expected.distances, unit, "distances");
    check_bits(found.coordinates, expected.coordinates, unit, "points");
    check_bits(found.lengths, expected.lengths, unit, "lengths of the diagram");
    check_bits(found.areas, expected.areas, unit * unit, "areas");
    check_bits(found.parameters, expected.parameters, 1., "locations, cells");
  }
}

// Areas in the unit of the mesh are 0 or infinite here, and products of three lengths are farther out of range.
void cells_of_extreme_units_are_right()
{
  const Indexed_mesh indexed = saddle_patch(5);
  const Mesh tm = to_face_graph(indexed);
  Voronoi expected(tm);
  expected.add_site(vertex(0));
  expected.add_site(vertex(20));
  for(const int k : {-1010, -990, -700, -520, 505, 515, 700})
  {
    test_support::Scope scope("unit 2^" + std::to_string(k));
    const double unit = std::ldexp(1., k);
    const Mesh other = to_face_graph(scaled(indexed, unit));
    Voronoi found(other);
    found.add_site(vertex(0));
    found.add_site(vertex(20));
    for(const std::size_t i : {std::size_t(0), std::size_t(1)})
    {
      const auto c = expected.centroid(i), d = found.centroid(i);
      check_bits({d.x(), d.y(), d.z()}, {c.x(), c.y(), c.z()}, unit, "centroid");
    }
    CHECK(SMG::certify_geodesic_Voronoi_diagram(found).is_certified());
  }
}

void powers_of_two_for_edge_lengths(const Indexed_mesh& indexed, const Questions& q)
{
  Mesh tm = to_face_graph(indexed);
  const auto lengths = add_edge_lengths(tm);
  const std::vector<double> expected = distances_from_edge_lengths(tm, lengths, q.vertex_source);
  for(const int k : {-900, -500, -30, 30, 500, 900})
  {
    Mesh other = tm;
    auto scaled_lengths = other.add_property_map<Mesh::Edge_index, double>("e:scaled", 0.).first;
    for(const auto e : edges(other))
    {
      scaled_lengths[e] = std::ldexp(lengths[e], k);
    }
    check_bits(distances_from_edge_lengths(other, scaled_lengths, q.vertex_source), expected, std::ldexp(1., k),
               "edge lengths");
  }
}

// --- other units, other positions ---

// The worst error of one kind of meshes and of one unit, relative to the largest distance, and relative to the bound.
struct Worst
{
  double error = 0., share_of_bound = 0., certificate = 0., certificate_of_diagram = 0.;
};

std::map<std::string, Worst> worst_of;

double largest_coordinate(const Indexed_mesh& indexed)
{
  double largest = 0.;
  for(const Coordinates& p : indexed.points)
  {
    for(const double x : p)
    {
      largest = (std::max)(largest, std::abs(x));
    }
  }
  return largest;
}

double longest_edge(const Mesh& tm)
{
  double longest = 0.;
  for(const auto e : edges(tm))
  {
    const auto h = halfedge(e, tm);
    longest = (std::max)(longest, length(coordinates(source(h, tm), tm) - coordinates(target(h, tm), tm)));
  }
  return longest;
}

using Certificate = SMG::Geodesic_Voronoi_certificate;

// Two conditions know rounding of this size, relative to the longest edge; `shift` is m, in the unit.
// - Boundaries of cells are compared as points in space, whose coordinates are rounded: each is a sum of three
//   products, and errs by less than 4 u M. Two points differ by 8 m.
// - Where the surface was flat, vertices bend by angles of about m over an edge. Of two paths that differ by the square
//   of such an angle, the propagation keeps one, whose window may begin at this distance beside a vertex. From there
//   to a point that is as near to the vertex, the bound is a path around the end of the window. It is longer by at most
//   twice the way, a few m. Vertices are right.
void check_certificates(Mesh& tm, const Questions& q, double unit, double shift, Worst& worst)
{
  const auto map = tm.add_property_map<vertex_descriptor, double>("v:distance", 0.).first;
  CHECK(SMG::geodesic_distances(tm, map, q.vertex_source));
  const auto certificate = SMG::certify_geodesic_distances(tm, map, q.vertex_source);
  CHECK(certificate.is_certified());
  worst.certificate = (std::max)(worst.certificate, certificate.worst_violation());
  // The certificate detects errors in this unit.
  const vertex_descriptor v = faces_around(q.vertex_source, tm).empty() ? q.vertex_source : vertex(0);
  const double d = get(map, v);
  if(d > 0. && d < infinity)
  {
    put(map, v, d * (1. + 1e-6));
    CHECK(!SMG::certify_geodesic_distances(tm, map, q.vertex_source).is_certified());
    put(map, v, d * (1. - 1e-6));
    CHECK(!SMG::certify_geodesic_distances(tm, map, q.vertex_source).is_certified());
  }
  Voronoi diagram(tm);
  add_sites(diagram, with_unit(q.sites, unit));
  const Certificate certificate_of_diagram = SMG::certify_geodesic_Voronoi_diagram(diagram);
  for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
  {
    const auto c = static_cast<Certificate::Condition>(i);
    const bool knows_rounding = c == Certificate::Condition::BOUNDARIES || c == Certificate::Condition::DISTANCES;
    const double further = knows_rounding ? 8. * shift * unit / longest_edge(tm) : 0.;
    CHECK(certificate_of_diagram.worst_violation(c) <= Certificate::default_tolerance + further);
  }
  worst.certificate_of_diagram = (std::max)(worst.certificate_of_diagram, certificate_of_diagram.worst_violation());
}

// `moved` is the mesh after a change of unit and position: its coordinates are those of `indexed` up to rounding.
void only_rounding_differs(const Indexed_mesh& indexed, const Indexed_mesh& moved, double unit, const Questions& q,
                     const std::string& name)
{
  test_support::Scope scope(name);
  Worst& worst = worst_of[name];
  Mesh tm = to_face_graph(moved);
  const Answers expected = answers_for(to_face_graph(indexed), q, 1., false);
  const Answers found = answers_for(tm, q, unit, false);
  const double shift = std::sqrt(3.) * unit_roundoff * largest_coordinate(moved) / unit;
  double largest = 0.;
  for(const double d : expected.distances)
  {
    largest = d < infinity ? (std::max)(largest, d) : largest;
  }
  for(std::size_t i = 0; i < expected.distances.size(); ++i)
  {
    if(expected.distances[i] == infinity)
    {
      CHECK_EQUAL(found.distances[i], infinity);
      continue;
    }
    const double pieces = static_cast<double>((std::max)(expected.pieces[i], found.pieces[i]));
    // One more piece allows for the rounding of a path without pieces.
    const double bound = (pieces + 1.) * (2. * shift + 16. * unit_roundoff * expected.distances[i]);
    const double error = std::abs(found.distances[i] / unit - expected.distances[i]);
    CHECK(error <= bound);
    worst.error = (std::max)(worst.error, error / largest);
    worst.share_of_bound = (std::max)(worst.share_of_bound, bound > 0. ? error / bound : 0.);
  }
  check_certificates(tm, q, unit, shift, worst);
}

void print_table()
{
  std::cout << "| unit or position | worst relative error | of the bound | certificate | of the diagram |\n"
            << "|---|--:|--:|--:|--:|\n"
            << std::setprecision(2) << std::scientific;
  for(const auto& w : worst_of)
  {
    std::cout << "| " << w.first << " | " << w.second.error << " | " << w.second.share_of_bound << " | "
              << w.second.certificate << " | " << w.second.certificate_of_diagram << " |\n";
  }
  std::cout << std::defaultfloat << std::setprecision(6);
}

// A flat mesh so far away that its distance from the origin is not finite in the unit of the mesh. Such a mesh is
// parallel to a coordinate plane.
void distance_from_the_origin_does_not_matter(std::uint64_t seed)
{
  test_support::Scope scope("flat mesh far away");
  const Indexed_mesh tiny = scaled(flat_patch(5, 7, .3, true, seed), std::ldexp(1., -700));
  const Mesh near = to_face_graph(tiny);
  const Mesh far = to_face_graph(transformed(tiny, "far", [](const Coordinates& p) {
    return Coordinates{p[0], p[1], std::ldexp(-1., 700)};
  }));
  const std::vector<double> expected = distances(near, vertex(0));
  CHECK(expected.back() > 0 && expected.back() < 1e-200);
  CHECK(distances(far, vertex(0)) == expected);
}

} // namespace

int main()
{
  cells_of_extreme_units_are_right();
  const std::uint64_t seed = test_support::announce_seed(20260207);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : small_collection(seed))
  {
    test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    const Questions q = questions_for(tm, random);
    powers_of_two_change_no_bit(indexed, q);
    powers_of_two_for_edge_lengths(indexed, q);
    for(const auto& unit : {std::make_pair("1e-150", 1e-150), std::make_pair("1e-9", 1e-9), std::make_pair("1e9", 1e9),
                            std::make_pair("1e150", 1e150)})
    {
      only_rounding_differs(indexed, scaled(indexed, unit.second), unit.second, q, std::string("unit ") + unit.first);
    }
    const Indexed_mesh moved = transformed(indexed, "moved", [](const Coordinates& p) {
      return p + Coordinates{1e6, -1e6, 1e6};
    });
    only_rounding_differs(indexed, moved, 1., q, "moved by 1e6");
  }
  distance_from_the_origin_does_not_matter(seed);
  print_table();
  return test_result();
}
