#ifndef SURFACE_MESH_GEODESICS_APP_PLACE_OPTIONS_H
#define SURFACE_MESH_GEODESICS_APP_PLACE_OPTIONS_H

#include "Command.h"
#include "Console.h"
#include "Program_mesh.h"

#include <string>
#include <vector>

namespace geodesics_app {

// A place on a mesh: a vertex, or a point of a face.
struct Place
{
  Vertex vertex;          // the null vertex for a point of a face
  Face_location location; // the null face for a vertex

  bool is_vertex() const { return vertex != Mesh::null_vertex(); }
};

// The options that tell places: for the role "source" they are --source, --source-point, --source-file and
// --source-random. All of them may be given, and all but the last one several times. Where places must be vertices,
// there is no --source-point, and a file holds numbers of vertices.
class Place_options
{
public:
  enum class Kind { ANY_PLACES, VERTICES };

  explicit Place_options(const std::string& role, Kind kind = Kind::ANY_PLACES) : m_role(role), m_kind(kind) {}

  // adds the options. All roles of a command have the option --seed in common, which is not among them.
  void declare(Option_descriptions& options) const;

  // whether at least one of the options is there.
  bool are_given(const Arguments& arguments) const;

  // returns the places in this order: vertices, points, those in files, random ones; and within each in the order of
  // the command line. Throws a Command_error for a place that the mesh does not have. The user is told which vertices
  // have been chosen at random.
  std::vector<Place> places(const Arguments& arguments, const Mesh& mesh, const Console& console) const;

  // does the same, where there must be at least one place.
  std::vector<Place> required_places(const Arguments& arguments, const Mesh& mesh, const Console& console) const;

  // does the same for the kind VERTICES.
  std::vector<Vertex> vertices(const Arguments& arguments, const Mesh& mesh, const Console& console) const;

private:
  std::string m_role;
  Kind m_kind;
};

// The option --seed of random places.
void declare_seed(Option_descriptions& options);

// whether a seed is given, but no place is chosen at random.
bool is_seed_unused(const Arguments& arguments);

// the point of a place.
Point point_of(const Place& place, const Mesh& mesh);

// the vertex of each place if all places are vertices; else an empty range.
std::vector<Vertex> as_vertices(const std::vector<Place>& places);

// the place of each as a point of a face. Throws a Command_error for a vertex without faces.
std::vector<Face_location> as_locations(const std::vector<Place>& places, const Mesh& mesh);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_PLACE_OPTIONS_H
