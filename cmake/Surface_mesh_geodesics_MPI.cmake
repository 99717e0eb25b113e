# The target CGAL::Surface_mesh_geodesics_MPI, for geodesic_distance_matrix_mpi.h: the package with Boost.MPI. There is no
# such target if MPI or Boost.MPI is missing (Debian: libboost-mpi-dev, openmpi-bin). MPIEXEC_EXECUTABLE is mpirun.
find_package(MPI QUIET COMPONENTS CXX)
if(MPI_CXX_FOUND)
  find_package(Boost QUIET COMPONENTS mpi serialization)
endif()
if(TARGET Boost::mpi AND NOT TARGET Surface_mesh_geodesics_MPI)
  add_library(Surface_mesh_geodesics_MPI INTERFACE)
  add_library(CGAL::Surface_mesh_geodesics_MPI ALIAS Surface_mesh_geodesics_MPI)
  target_link_libraries(Surface_mesh_geodesics_MPI INTERFACE CGAL::Surface_mesh_geodesics Boost::mpi Boost::serialization
                                                             MPI::MPI_CXX)
  target_compile_definitions(Surface_mesh_geodesics_MPI INTERFACE CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI)
endif()
