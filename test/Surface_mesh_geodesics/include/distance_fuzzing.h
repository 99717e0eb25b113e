#ifndef SURFACE_MESH_GEODESICS_DISTANCE_FUZZING_H
#define SURFACE_MESH_GEODESICS_DISTANCE_FUZZING_H

// Distances on random hostile surfaces, checked in two ways that do not rely on the propagation: by the certificate,
// and on small surfaces by a referee that unfolds from each source with more digits. Several threads, if there are any,
// have to find the same distances. A case that fails is reduced while it still fails, and saved.

#include "distance_case.h"
#include "distance_test_helpers.h"
#include "edge_sequence_search.h"
#include "hostile_cases.h"
#include "several_threads.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <CGAL/tags.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace distance_fuzzing {

using namespace test_meshes;

using Fifty_digits
  = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Options = Distance_options<Mesh, Mesh::Property_map<vertex_descriptor, std::size_t>>;
using Certificate = SMG::Geodesic_distance_certificate<Mesh>;
using Condition = Certificate::Condition;
using Lengths = Mesh::Property_map<Mesh::Edge_index, double>;

// The error of double, relative to the distance. Points nearer to each other than a few units of rounding of the extent
// of the surface are not distinguished; each source in a face rounds the locations in it once more.
const double tolerance = 1e-12;
const double tolerance_of_extent = 8 * std::numeric_limits<double>::epsilon();

// If the error exceeds this, the referee computes again with more digits.
const double tolerance_of_referee = 1e-13;

// The function that proves lower bounds may be inaccurate between nearly equal vertices. See also tolerance_of_proof().
const double usual_tolerance_of_proof = 1e-8, largest_tolerance_of_proof = 1e-6;

// The largest surfaces on which distances are compared with those of a referee.
const std::size_t largest_number_of_faces = 60, largest_number_of_faces_subdivided = 200;

// The result of a check. `fault` is empty if there is no fault.
struct Findings
{
  std::string fault;
  bool is_surface = true, is_compared = false, needs_digits = false;
  double worst_error = 0., worst_violation = 0.;
};

// A case as a user would pass it: a mesh, possibly with lengths, and sources as the functions take them.
struct Input
{
  explicit Input(const Distance_case& c) : has_points(c.has_points)
  {
    if(has_points)
    {
      tm = to_face_graph(c.surface.mesh);
      for(std::size_t f = 0; f < c.surface.mesh.faces.size(); ++f) // coordinates follow the list of corners
      {
        while(tm.source(tm.halfedge(face(f))) != vertex(c.surface.mesh.faces[f][0]))
        {
          tm.set_halfedge(face(f), tm.next(tm.halfedge(face(f))));
        }
      }
    }
    else
    {
      std::vector<std::array<Mesh::Edge_index, 3>> edge_of_side;
      tm = to_face_graph(c.surface, edge_of_side);
      lengths = tm.add_property_map<Mesh::Edge_index, double>("e:length", 0.).first;
      for(std::size_t f = 0; f < edge_of_side.size(); ++f)
      {
        for(std::size_t k = 0; k < 3; ++k)
        {
          lengths[edge_of_side[f][k]] = c.surface.length(f, k);
        }
      }
    }
    distance = tm.add_property_map<vertex_descriptor, double>("v:distance", -1.).first;
    options.nearest_source_map = tm.add_property_map<vertex_descriptor, std::size_t>("v:nearest", 0).first;
    read_sources(c);
  }

  // Calls a function with the range of vertices or of locations.
  template <class Call>
  auto with_sources(const Call& call) const
  {
    return m_vertices.size() == m_locations.size() ? call(m_vertices) : call(m_locations);
  }

  template <class Tag>
  void compute()
  {
    with_sources([&](const auto& sources)
    {
      const auto np = parameters_of(options);
      return has_points ? SMG::geodesic_distances<Tag>(tm, distance, sources, np)
                        : SMG::geodesic_distances_from_edge_lengths<Tag>(tm, lengths, distance, sources, np);
    });
  }

  Certificate certificate() const
  {
    return with_sources([&](const auto& sources)
    {
      const auto np = certificate_parameters_of(options);
      return has_points ? SMG::certify_geodesic_distances(tm, distance, sources, np)
                        : SMG::certify_geodesic_distances_from_edge_lengths(tm, lengths, distance, sources, np);
    });
  }

  bool has_points;
  Mesh tm;
  Lengths lengths;
  Mesh::Property_map<vertex_descriptor, double> distance;
  Options options;

private:
  // Makes vertices if all sources are vertices, otherwise locations in faces.
  void read_sources(const Distance_case& c)
  {
    bool has_offset = false;
    for(const Numbered_source& s : c.sources)
    {
      has_offset = has_offset || s.offset != 0.;
      options.source_offsets.push_back(s.offset);
      if(s.is_vertex())
      {
        m_vertices.push_back(vertex(s.vertex));
      }
      m_locations.push_back(s.is_vertex() ? location_of(c, s.vertex) : Face_location(face(s.face), s.coordinates));
    }
    if(!has_offset)
    {
      options.source_offsets.clear();
    }
  }

  static Face_location location_of(const Distance_case& c, std::size_t v)
  {
    for(std::size_t f = 0; f < c.surface.mesh.faces.size(); ++f)
    {
      for(std::size_t k = 0; k < 3; ++k)
      {
        if(c.surface.mesh.faces[f][k] == v)
        {
          Face_location location(face(f), {0., 0., 0.});
          location.second[k] = 1.;
          return location;
        }
      }
    }
    return {};
  }

  std::vector<vertex_descriptor> m_vertices;
  std::vector<Face_location> m_locations;
};

// --- the referees ---

// The distances of all vertices from one source, without its offset. Empty if two vertices have several edges even
// after the surface has been subdivided.
template <class FT>
std::vector<FT> distances_from(const Distance_case& c, const Numbered_source& s)
{
  Glued_surface<FT> surface = with_digits<FT>(c);
  const std::array<FT, 3> coordinates{FT(s.coordinates[0]), FT(s.coordinates[1]), FT(s.coordinates[2])};
  const std::size_t v = s.is_vertex() ? s.vertex : Point_insertion<FT>(surface).insert(s.face, coordinates);
  while(!surface.is_triangle_mesh())
  {
    if(4 * surface.edges.size() > largest_number_of_faces_subdivided)
    {
      return {};
    }
    surface = midpoint_subdivision(surface);
  }
  std::map<std::pair<std::size_t, std::size_t>, FT> lengths;
  for(std::size_t f = 0; f < surface.edges.size(); ++f)
  {
    for(std::size_t k = 0; k < 3; ++k)
    {
      lengths[std::minmax(surface.mesh.faces[f][k], surface.mesh.faces[f][(k + 1) % 3])] = surface.length(f, k);
    }
  }
  const auto length = [&](std::size_t a, std::size_t b) { return lengths.at(std::minmax(a, b)); };
  Edge_sequence_search<FT> search(surface.mesh, length, c.has_points ? 1 : 3);
  std::vector<FT> result = search.from_vertex(v);
  result.resize(c.surface.mesh.points.size());
  return result;
}

inline double extent_of(const Distance_case& c)
{
  double extent = 0.;
  if(!c.has_points)
  {
    return *std::max_element(c.surface.lengths.begin(), c.surface.lengths.end());
  }
  for(const Triangle& t : c.surface.mesh.faces)
  {
    for(const std::size_t v : t)
    {
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Coordinates& first = c.surface.mesh.points[c.surface.mesh.faces[0][0]];
        extent = (std::max)(extent, std::abs(c.surface.mesh.points[v][i] - first[i]));
      }
    }
  }
  return extent;
}

// Locations on edges are rounded relative to the lengths of the edges. Seen from a vertex whose nearest neighbor is as
// near as the shortest edge is long, this rounding is an angle. Two windows that should meet may leave a gap of that
// angle, in which the function of the proof is too large. No vertex lies in the gap: its distance would be wrong, and
// the referee would find it.
inline double tolerance_of_proof(const Distance_case& c)
{
  const Glued_surface<double> surface = with_digits<double>(c);
  double shortest = infinity;
  for(const double length : surface.lengths)
  {
    shortest = length > 0. ? (std::min)(shortest, length) : shortest;
  }
  const double angle = std::numeric_limits<double>::epsilon() * extent_of(c) / shortest;
  return (std::min)((std::max)(usual_tolerance_of_proof, angle), largest_tolerance_of_proof);
}

// The relative error of a number, beyond what rounding of the extent allows. `extent` is multiplied by the number of
// sources.
inline double relative_error(double number, double right, double extent)
{
  if(number == right)
  {
    return 0.;
  }
  const double error = (std::max)(std::abs(number - right) - tolerance_of_extent * extent, 0.);
  return std::isfinite(error) && right >= 0. ? (error > 0. ? error / right : 0.) : infinity;
}

// Does a surface given by lengths have faces without height? The search by edge sequences may miss paths behind them,
// because its cones have no width there.
inline bool may_the_referee_miss_paths(const Distance_case& c)
{
  for(std::size_t f = 0; f < c.surface.edges.size() && !c.has_points; ++f)
  {
    double longest = 0., sum = 0.;
    for(std::size_t k = 0; k < 3; ++k)
    {
      longest = (std::max)(longest, c.surface.length(f, k));
      sum += c.surface.length(f, k);
    }
    if(!(sum - 2. * longest > 0x1p-40 * longest))
    {
      return true;
    }
  }
  return false;
}

// Compares the distances, and the distances from the nearest sources, with those of a referee, and returns the largest
// error, or a negative number without a referee. Where the referee may miss paths, the distances must not be longer
// than its own. The certificate shows that they are not too short.
template <class FT>
double error_against_referee(const Distance_case& c, const Input& input)
{
  const double extent = static_cast<double>(c.sources.size()) * extent_of(c);
  const bool may_be_shorter = may_the_referee_miss_paths(c);
  std::vector<std::vector<FT>> from_source;
  for(const Numbered_source& s : c.sources)
  {
    from_source.push_back(distances_from<FT>(c, s));
    if(from_source.back().empty())
    {
      return -1.;
    }
  }
  double worst = 0.;
  for(std::size_t v = 0; v < c.surface.mesh.points.size(); ++v)
  {
    FT right = std::numeric_limits<FT>::infinity();
    for(std::size_t i = 0; i < c.sources.size(); ++i)
    {
      right = (std::min)(right, FT(from_source[i][v] + FT(c.sources[i].offset)));
    }
    const double d = input.distance[vertex(v)], r = static_cast<double>(right);
    worst = (std::max)(worst, may_be_shorter && d < r ? 0. : relative_error(d, r, extent));
    const std::size_t nearest = input.options.nearest_source_map[vertex(v)];
    if(!std::isfinite(r))
    {
      worst = nearest != no_source ? infinity : worst;
    }
    else if(!may_be_shorter)
    {
      const double from_nearest
        = nearest < c.sources.size() ? static_cast<double>(FT(from_source[nearest][v] + FT(c.sources[nearest].offset)))
                                     : infinity;
      worst = (std::max)(worst, relative_error(from_nearest, r, extent));
    }
  }
  return worst;
}

inline void compare_with_referee(const Distance_case& c, const Input& input, Findings& findings)
{
  const double error = c.surface.edges.size() <= largest_number_of_faces ? error_against_referee<long double>(c, input)
                                                                         : -1.;
  if(error < 0.)
  {
    return;
  }
  findings.is_compared = true;
  findings.worst_error = error;
  if(!(findings.worst_error <= tolerance_of_referee)) // finds out which of the two is inaccurate
  {
    findings.needs_digits = true;
    findings.worst_error = error_against_referee<Fifty_digits>(c, input);
  }
  if(!(findings.worst_error <= tolerance))
  {
    findings.fault = "a distance differs from that of the referee";
  }
}

inline void certify(const Distance_case& c, const Input& input, Findings& findings)
{
  const Certificate certificate = input.certificate();
  findings.worst_violation = certificate.worst_violation();
  for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
  {
    const Condition condition = static_cast<Condition>(i);
    const double allowed = condition == Condition::PROOF ? tolerance_of_proof(c) : Certificate::default_tolerance;
    if(!(certificate.worst_violation(condition) <= allowed))
    {
      findings.fault = std::string("not certified: ") + Certificate::name(condition);
    }
  }
}

#ifdef CGAL_LINKED_WITH_TBB

// Compares the distances with those that several threads compute, which stay in the input.
inline void compare_with_threads(const Distance_case& c, Input& input, Findings& findings)
{
  const std::vector<double> expected = values_at_vertices(input.tm, input.distance);
  input.compute<test_support::Several_threads>();
  const double extent = static_cast<double>(c.sources.size()) * extent_of(c);
  for(std::size_t v = 0; v < expected.size(); ++v)
  {
    if(!(relative_error(input.distance[vertex(v)], expected[v], extent) <= tolerance))
    {
      findings.fault = "several threads find another distance";
    }
  }
}

#endif // CGAL_LINKED_WITH_TBB

inline Findings examine(const Distance_case& c)
{
  Findings findings;
  try
  {
    Input input(c);
    try
    {
      input.compute<CGAL::Sequential_tag>();
      certify(c, input, findings);
      compare_with_referee(c, input, findings);
#ifdef CGAL_LINKED_WITH_TBB
      compare_with_threads(c, input, findings);
#endif
    }
    catch(const CGAL::Surface_mesh_geodesics::Invalid_geodesic_input& e)
    {
      // The offset may be a length of a component that is larger by any factor than those of the sources.
      using Reason = CGAL::Surface_mesh_geodesics::Invalid_geodesic_input::Reason;
      if(e.reason() == Reason::INVALID_OFFSET && c.name == "several components")
        findings.is_surface = false;
      else
        findings.fault = std::string("an exception: ") + e.what();
    }
    catch(const std::exception& e)
    {
      findings.fault = std::string("an exception: ") + e.what();
    }
  }
  catch(const std::logic_error&) // not every random list of faces is a surface
  {
    findings.is_surface = false;
  }
  return findings;
}

// --- cases that fail ---

// Removes sources and faces as long as a fault remains: first many faces at once, then single faces.
inline Distance_case shrunk(Distance_case c, std::size_t most_trials = 2000)
{
  const auto is_faulty = [&](const Distance_case& smaller)
  {
    return most_trials > 0 && !smaller.sources.empty() && --most_trials > 0 && !examine(smaller).fault.empty();
  };
  for(std::size_t part = (c.surface.edges.size() + 1) / 2; part > 0; part /= 2)
  {
    for(bool is_smaller = true; is_smaller;)
    {
      is_smaller = false;
      for(std::size_t i = c.sources.size(); i-- > 0;)
      {
        Distance_case smaller = without_source(c, i);
        if(is_faulty(smaller))
        {
          c = std::move(smaller);
          is_smaller = true;
        }
      }
      for(std::size_t first = 0; first < c.surface.edges.size();)
      {
        Distance_case smaller = with_faces(c, [&](std::size_t f) { return f < first || f >= first + part; });
        if(is_faulty(smaller))
        {
          c = std::move(smaller);
          is_smaller = true;
        }
        else
        {
          first += part;
        }
      }
    }
  }
  return c;
}

inline void report(const Distance_case& c, const Findings& findings, std::uint64_t seed, const std::string& folder)
{
  test_support::Scope scope(c.name + ", seed " + std::to_string(seed));
  test_support::report_failure(__FILE__, __LINE__, findings.fault);
  const Distance_case small = shrunk(c);
  const std::string stem = folder + "/distances_" + std::to_string(seed);
  std::cout << "  relative error " << findings.worst_error << ", violation " << findings.worst_violation
            << "\n  again: fuzz_distances 1 " << seed << "\n";
  if(write_case(small, stem))
  {
    std::cout << "  smaller, " << small.surface.edges.size() << " faces and " << small.sources.size()
              << " sources: fuzz_distances --case " << stem << std::endl;
  }
}

// --- many cases ---

struct Counts
{
  std::size_t surfaces = 0, no_surfaces = 0, sources = 0, distances = 0, compared = 0, with_digits = 0, certified = 0,
              faults = 0;
  double worst_error = 0., worst_violation = 0.;
};

inline std::uint64_t& seed_at_work()
{
  static std::uint64_t seed = 0;
  return seed;
}

// A signal handler. Prints the seed of the current surface, so that a crash can be reproduced.
extern "C" inline void tell_seed_and_die(int signal)
{
  std::fprintf(stderr, "signal %d at seed %llu; again: fuzz_distances 1 %llu\n", signal,
               static_cast<unsigned long long>(seed_at_work()), static_cast<unsigned long long>(seed_at_work()));
  std::_Exit(EXIT_FAILURE);
}

inline Distance_case case_of_seed(std::uint64_t seed, const hostile_cases::Families& all)
{
  test_support::Random random(seed);
  Distance_case c = all[seed % all.size()].make(random);
  hostile_cases::add_sources(c, random);
  return c;
}

inline void count(const Distance_case& c, const Findings& findings, Counts& counts)
{
  ++(findings.is_surface ? counts.surfaces : counts.no_surfaces);
  counts.sources += findings.is_surface ? c.sources.size() : 0;
  counts.distances += findings.is_compared ? c.surface.mesh.points.size() : 0;
  counts.compared += findings.is_compared;
  counts.with_digits += findings.needs_digits;
  counts.certified += findings.is_surface && findings.worst_violation <= Certificate::default_tolerance;
  counts.faults += !findings.fault.empty();
  counts.worst_error = (std::max)(counts.worst_error, findings.worst_error);
  counts.worst_violation = (std::max)(counts.worst_violation, findings.worst_violation);
}

inline void print(const std::vector<Counts>& counts, const hostile_cases::Families& families)
{
  std::cout << std::left << std::setw(18) << "family" << std::right << std::setw(10) << "surfaces" << std::setw(10)
            << "none" << std::setw(10) << "sources" << std::setw(10) << "compared" << std::setw(10) << "distances"
            << std::setw(10) << "digits" << std::setw(10) << "certified" << std::setw(10) << "faults"
            << std::setw(14) << "worst error" << std::setw(14) << "violation" << "\n";
  Counts sum;
  for(std::size_t i = 0; i < counts.size(); ++i)
  {
    const Counts& c = counts[i];
    sum.surfaces += c.surfaces;
    sum.sources += c.sources;
    sum.distances += c.distances;
    sum.faults += c.faults;
    std::cout << std::left << std::setw(18) << families[i].name << std::right << std::setw(10)
              << c.surfaces << std::setw(10) << c.no_surfaces << std::setw(10) << c.sources << std::setw(10)
              << c.compared << std::setw(10) << c.distances << std::setw(10) << c.with_digits << std::setw(10)
              << c.certified << std::setw(10) << c.faults << std::setw(14) << c.worst_error << std::setw(14)
              << c.worst_violation << "\n";
  }
  std::cout << sum.surfaces << " surfaces, " << sum.sources << " sources, " << sum.distances
            << " distances compared with those of a referee, " << sum.faults << " faults" << std::endl;
}

// Surface number i depends only on the seed plus i.
inline std::vector<Counts>
distances_on_hostile_surfaces(std::size_t number, std::uint64_t seed, const std::string& folder = ".",
                              const hostile_cases::Families& families = hostile_cases::families())
{
  for(const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL})
  {
    std::signal(signal, tell_seed_and_die);
  }
  std::vector<Counts> counts(families.size());
  for(std::uint64_t s = seed; s < seed + number; ++s)
  {
    seed_at_work() = s;
    const Distance_case c = case_of_seed(s, families);
    const Findings findings = examine(c);
    ++test_support::state().number_of_checks;
    count(c, findings, counts[s % counts.size()]);
    if(!findings.fault.empty())
    {
      report(c, findings, s, folder);
    }
  }
  print(counts, families);
  return counts;
}

// Surfaces without orientation are not valid meshes. The functions must reject them.
inline std::size_t number_rejected(std::size_t number, std::uint64_t seed)
{
  std::size_t result = 0;
  for(std::uint64_t s = seed; s < seed + number; ++s)
  {
    test_support::Random random(s);
    try
    {
      to_face_graph(hostile_cases::not_orientable(random));
    }
    catch(const std::logic_error&)
    {
      ++result;
    }
  }
  return result;
}

} // namespace distance_fuzzing

#endif // SURFACE_MESH_GEODESICS_DISTANCE_FUZZING_H
