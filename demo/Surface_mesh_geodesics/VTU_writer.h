#ifndef SURFACE_MESH_GEODESICS_DEMO_VTU_WRITER_H
#define SURFACE_MESH_GEODESICS_DEMO_VTU_WRITER_H

#include "Drawing.h"

#include <ostream>

namespace geodesics_demo {

// Writes an unstructured grid of VTK: an XML header, then all numbers in binary, not compressed. The cells are the
// lines, then the triangles; the points if there are neither. Cells of triangles have no numbers of lines: NaN, or -1
// for whole numbers.
void write_VTU(std::ostream& os, const Drawing& drawing);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_VTU_WRITER_H
