// The lanes of compilers without vectors, such as Visual C++, have the same bits as one lane (Double_pair.h).

#define CGAL_SURFACE_MESH_GEODESICS_NO_VECTOR_EXTENSION

#include "test_numbers_of_lanes.cpp"
