#ifndef SURFACE_MESH_GEODESICS_SCHEDULERS_OF_THESIS_H
#define SURFACE_MESH_GEODESICS_SCHEDULERS_OF_THESIS_H

// The schedulers of the benchmark. Programs include them through this file, because their own includes must not depend
// on the folder of the program: several programs are compiled as one unit elsewhere.

#include "../../../benchmark/Surface_mesh_geodesics/include/Scheduled_propagation.h"

#endif // SURFACE_MESH_GEODESICS_SCHEDULERS_OF_THESIS_H
