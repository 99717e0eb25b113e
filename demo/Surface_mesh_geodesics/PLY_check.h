#ifndef SURFACE_MESH_GEODESICS_DEMO_PLY_CHECK_H
#define SURFACE_MESH_GEODESICS_DEMO_PLY_CHECK_H

#include <string>

namespace geodesics_demo {

// Is this PLY file safe for CGAL's reader? The reader trusts damaged files: it allocates lists of any length, continues
// for any number of items, and writes to invalid memory if a property precedes the first element. So this function
// checks the header, and that no number of items or entries exceeds the rest of the file. The reader checks everything
// else. Pipes are not checked, because they cannot be read twice.
bool may_read_PLY(const std::string& file_name);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_PLY_CHECK_H
