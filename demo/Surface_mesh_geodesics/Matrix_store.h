#ifndef SURFACE_MESH_GEODESICS_DEMO_MATRIX_STORE_H
#define SURFACE_MESH_GEODESICS_DEMO_MATRIX_STORE_H

#include "Command.h"
#include "Console.h"
#include "Location_options.h"
#include "Program_mesh.h"

#include <functional>
#include <vector>

namespace geodesics_demo {

// The options of the subcommand matrix for matrices in folders: --store and what goes with it, --status, --verify.
void declare_matrix_store(Option_descriptions& options);

// Is one of the options given that need no mesh on the command line, or one that needs no sources?
bool works_on_stored_matrix(const Arguments& arguments);

// Sources and targets of a mesh: locations, and vertices.
struct Matrix_places
{
  std::vector<Location> sources;
  std::vector<Vertex> targets;
};
using Place_finder = std::function<Matrix_places(const Mesh& mesh)>;

// Throws a Command_error if one of the options is given without --store.
void check_matrix_store_options(const Arguments& arguments);

// Does what --store, --status or --verify ask for. `find_places` is called for each mesh that is read.
void run_on_stored_matrix(const Arguments& arguments, const Place_finder& find_places, const Console& console);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_MATRIX_STORE_H
