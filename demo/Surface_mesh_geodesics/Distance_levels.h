#ifndef SURFACE_MESH_GEODESICS_DEMO_DISTANCE_LEVELS_H
#define SURFACE_MESH_GEODESICS_DEMO_DISTANCE_LEVELS_H

#include "Location_options.h"
#include "Program_mesh.h"

#include <cstddef>
#include <vector>

namespace geodesics_demo {

// A distance that no vertex exceeds that the sources reach around the avoided faces: the largest distance along edges.
// On usual meshes it is larger than the largest distance by a tenth. It takes a small part of the time of distances, so
// that isolines can be chosen before these are computed.
double bound_of_distances(const Mesh& mesh, const std::vector<Face>& avoided, const std::vector<Location>& sources);

// About n distances strictly between 0 and the largest one, at most 1000: the multiples of a number with one digit, 1,
// 2 or 5.
std::vector<double> at_round_distances(std::size_t n, double largest);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_DISTANCE_LEVELS_H
