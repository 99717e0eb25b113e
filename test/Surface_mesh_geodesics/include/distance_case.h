#ifndef SURFACE_MESH_GEODESICS_DISTANCE_CASE_H
#define SURFACE_MESH_GEODESICS_DISTANCE_CASE_H

// A surface with sources, for random tests. It consists of indices and numbers only, so that faces can be removed and
// the rest can be written to files and read again.

#include "distance_test_helpers.h"
#include "glued_surface.h"
#include "test_meshes.h"

#include <array>
#include <cstddef>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

// A source: a vertex if it has a vertex index, otherwise a location in a face, with its barycentric coordinates.
struct Numbered_source
{
  std::size_t vertex = no_source;
  std::size_t face = 0;
  std::array<double, 3> coordinates{};
  double offset = 0.;

  bool is_vertex() const { return vertex != no_source; }
};

struct Distance_case
{
  std::string name;
  Glued_surface<double> surface;
  bool has_points = true; // if false, the surface is given by its lengths, and the points are ignored
  std::vector<Numbered_source> sources;
};

inline Distance_case case_of_mesh(const Indexed_mesh& mesh)
{
  return {mesh.name, glued_surface<double>(mesh), true, {}};
}

// The same surface in another number type. The lengths are computed from the points if has_points is true.
template <class FT>
Glued_surface<FT> with_digits(const Distance_case& c)
{
  if(c.has_points)
  {
    return glued_surface<FT>(c.surface.mesh);
  }
  Glued_surface<FT> result;
  result.mesh = c.surface.mesh;
  result.edges = c.surface.edges;
  result.lengths.assign(c.surface.lengths.begin(), c.surface.lengths.end());
  return result;
}

// Keeps the faces for which `is_kept` holds, and the sources on them.
template <class Predicate>
Distance_case with_faces(const Distance_case& c, const Predicate& is_kept)
{
  Distance_case result{c.name, {}, c.has_points, {}};
  Glued_surface<double>& surface = result.surface;
  surface.mesh.name = c.surface.mesh.name;
  std::vector<std::size_t> new_vertex(c.surface.mesh.points.size(), no_source),
    new_edge(c.surface.lengths.size(), no_source), new_face(c.surface.edges.size(), no_source);
  const auto take = [](std::vector<std::size_t>& numbers, std::size_t i, auto& to, const auto& from)
  {
    if(numbers[i] == no_source)
    {
      numbers[i] = to.size();
      to.push_back(from[i]);
    }
    return numbers[i];
  };
  for(std::size_t f = 0; f < new_face.size(); ++f)
  {
    if(!is_kept(f))
    {
      continue;
    }
    new_face[f] = surface.edges.size();
    surface.edges.push_back({});
    surface.mesh.faces.push_back({});
    for(std::size_t k = 0; k < 3; ++k)
    {
      surface.mesh.faces.back()[k]
        = take(new_vertex, c.surface.mesh.faces[f][k], surface.mesh.points, c.surface.mesh.points);
      surface.edges.back()[k] = take(new_edge, c.surface.edges[f][k], surface.lengths, c.surface.lengths);
    }
  }
  for(Numbered_source s : c.sources)
  {
    std::size_t& number = s.is_vertex() ? s.vertex : s.face;
    number = s.is_vertex() ? new_vertex[number] : new_face[number];
    if(number != no_source)
    {
      result.sources.push_back(s);
    }
  }
  return result;
}

inline Distance_case without_source(Distance_case c, std::size_t i)
{
  c.sources.erase(c.sources.begin() + static_cast<std::ptrdiff_t>(i));
  return c;
}

// --- files ---

// Writes <stem>.off and <stem>.sources.txt. The latter has a line for each source and, without points, for each side:
// `vertex <number> <offset>`, `location <face> <coordinates> <offset>`, `side <face> <side> <edge> <length>`.
inline bool write_case(const Distance_case& c, const std::string& stem)
{
  std::ofstream off(stem + ".off"), text(stem + ".sources.txt");
  off.precision(17);
  text.precision(17);
  const Indexed_mesh& mesh = c.surface.mesh;
  off << "OFF\n" << mesh.points.size() << ' ' << mesh.faces.size() << " 0\n";
  for(const Coordinates& p : mesh.points)
  {
    off << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  for(const Triangle& t : mesh.faces)
  {
    off << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }
  for(const Numbered_source& s : c.sources)
  {
    if(s.is_vertex())
    {
      text << "vertex " << s.vertex << ' ' << s.offset << '\n';
    }
    else
    {
      text << "location " << s.face << ' ' << s.coordinates[0] << ' ' << s.coordinates[1] << ' ' << s.coordinates[2]
           << ' ' << s.offset << '\n';
    }
  }
  for(std::size_t s = 0; !c.has_points && s < 3 * c.surface.edges.size(); ++s)
  {
    const std::size_t e = c.surface.edges[s / 3][s % 3];
    text << "side " << s / 3 << ' ' << s % 3 << ' ' << e << ' ' << c.surface.lengths[e] << '\n';
  }
  return off.flush().good() && text.flush().good();
}

// Reads the files of write_case().
inline Distance_case read_case(const std::string& stem)
{
  std::ifstream off(stem + ".off"), text(stem + ".sources.txt");
  std::string word;
  Indexed_mesh mesh;
  mesh.name = stem;
  std::size_t number_of_points = 0, number_of_faces = 0, number = 0;
  off >> word >> number_of_points >> number_of_faces >> number;
  mesh.points.resize(number_of_points);
  mesh.faces.resize(number_of_faces);
  for(Coordinates& p : mesh.points)
  {
    off >> p[0] >> p[1] >> p[2];
  }
  for(Triangle& t : mesh.faces)
  {
    off >> number >> t[0] >> t[1] >> t[2];
  }
  Distance_case c = case_of_mesh(mesh);
  while(text >> word)
  {
    Numbered_source s;
    if(word == "vertex")
    {
      text >> s.vertex >> s.offset;
      c.sources.push_back(s);
    }
    else if(word == "location")
    {
      text >> s.face >> s.coordinates[0] >> s.coordinates[1] >> s.coordinates[2] >> s.offset;
      c.sources.push_back(s);
    }
    else
    {
      std::size_t f = 0, k = 0, e = 0;
      double length = 0;
      text >> f >> k >> e >> length;
      c.has_points = false;
      c.surface.edges.at(f).at(k) = e;
      c.surface.lengths.resize((std::max)(c.surface.lengths.size(), e + 1));
      c.surface.lengths[e] = length;
    }
  }
  if(!off || c.sources.empty())
  {
    throw std::runtime_error("no case can be read from " + stem + ".off and " + stem + ".sources.txt");
  }
  return c;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_DISTANCE_CASE_H
