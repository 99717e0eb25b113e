#ifndef SURFACE_MESH_GEODESICS_APP_PLY_CHECK_H
#define SURFACE_MESH_GEODESICS_APP_PLY_CHECK_H

#include <string>

namespace geodesics_app {

// May CGAL's reader be given this PLY file? It believes what damaged files say: it makes room for lists of any length,
// goes on for as many items as are promised, and writes to nowhere if a property comes before the first element. So the
// header has to be in order, and no number of items or entries may exceed what is left of the file. Whether the rest is
// right is for the reader to say. What comes from a pipe cannot be read twice and is not checked.
bool may_read_PLY(const std::string& file_name);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_PLY_CHECK_H
