#ifndef SURFACE_MESH_GEODESICS_DEMO_LOCATION_OPTIONS_H
#define SURFACE_MESH_GEODESICS_DEMO_LOCATION_OPTIONS_H

#include "Command.h"
#include "Console.h"
#include "Program_mesh.h"

#include <string>
#include <vector>

namespace geodesics_demo {

// A location on a mesh: a vertex, or a point of a face.
// Nowhere if both are null.
struct Location
{
  Vertex vertex;          // the null vertex for a point of a face
  Face_location face_location; // the null face for a vertex
  double weight = 0;           // of a site, from the column `weight` of a table

  bool is_vertex() const { return vertex != Mesh::null_vertex(); }
};

// The options that specify locations: for the role "source" they are --source, --source-point, --source-file and
// --source-random. They may be combined, and all but the last one repeated. Where locations must be vertices, there is
// no --source-point, and files contain vertices only. Where curves may be given as well (Curve_options.h), messages
// name their options, too.
class Location_options
{
public:
  enum class Kind { ANY_PLACES, VERTICES, PLACES_AND_CURVES };

  explicit Location_options(const std::string& role, Kind kind = Kind::ANY_PLACES) : m_role(role), m_kind(kind) {}

  // Adds the options. The option --seed is not among them: the roles of a command share it.
  void declare(Option_descriptions& options) const;

  // Is at least one of the options given?
  bool are_given(const Arguments& arguments) const;

  // Returns the locations in this order: vertices, points, files, random vertices; within each kind in the order of the
  // command line. Prints the random vertices. Throws a Command_error for a location that the mesh does not have.
  std::vector<Location> locations(const Arguments& arguments, const Mesh& mesh, const Console& console) const;

  // The same; throws a Command_error if there is no location.
  std::vector<Location> required_locations(const Arguments& arguments, const Mesh& mesh, const Console& console) const;

  // The same for the kind VERTICES.
  std::vector<Vertex> vertices(const Arguments& arguments, const Mesh& mesh, const Console& console) const;

private:
  std::string m_role;
  Kind m_kind;
};

// The option --seed of random locations.
void declare_seed(Option_descriptions& options);

// Is a seed given, although no location is chosen at random?
bool is_seed_unused(const Arguments& arguments);

// The point of a location.
Point point_of(const Location& location, const Mesh& mesh);
Point point_of(const Face_location& location, const Mesh& mesh);

// A point of a face as a location: a vertex if it is at one, up to rounding.
Location as_location(const Face_location& location, const Mesh& mesh);

// The vertices of the locations if all of them are vertices; else an empty range.
std::vector<Vertex> as_vertices(const std::vector<Location>& locations);

// Each location as a point of a face. Throws a Command_error for a vertex without faces.
std::vector<Face_location> as_face_locations(const std::vector<Location>& locations, const Mesh& mesh);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_LOCATION_OPTIONS_H
