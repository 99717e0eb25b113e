# Installs into a folder of its own, and runs the program from there. Needs -Dbuild_folder, -Dprefix and -Dversion.
cmake_minimum_required(VERSION 3.19...3.31)

file(REMOVE_RECURSE "${prefix}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${build_folder}" --prefix "${prefix}"
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND "${prefix}/bin/surface_mesh_geodesics" --version
  OUTPUT_VARIABLE output
  COMMAND_ERROR_IS_FATAL ANY)
if(NOT output MATCHES "^surface_mesh_geodesics ${version} with CGAL [0-9.]+\n$")
  message(FATAL_ERROR "The installed program printed ${output}")
endif()
if(NOT EXISTS "${prefix}/share/man/man1/surface_mesh_geodesics.1")
  message(FATAL_ERROR "The man page was not installed")
endif()
if(NOT EXISTS "${prefix}/share/bash-completion/completions/surface_mesh_geodesics")
  message(FATAL_ERROR "The completion for bash was not installed")
endif()
