# Builds and installs a project that takes the package in with add_subdirectory(): nothing but that project is built,
# tested and installed. Then installs the package from a folder where nothing has been built: headers, but no program and
# no man page. Needs -Dpackage, -Dwork_folder, -Dcompiler, -DCGAL_DIR and -Dgenerator.
cmake_minimum_required(VERSION 3.19...3.31)

set(build "${work_folder}/build")
set(prefix "${work_folder}/prefix")
file(REMOVE_RECURSE "${work_folder}")

function(configure source folder)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -G "${generator}" -S "${source}" -B "${folder}" "-DCMAKE_CXX_COMPILER=${compiler}"
            "-DCGAL_DIR=${CGAL_DIR}" ${ARGN}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The files below a folder, relative to it and sorted.
function(list_files folder out_files)
  file(GLOB_RECURSE files RELATIVE "${folder}" "${folder}/*")
  list(SORT files)
  set(${out_files} "${files}" PARENT_SCOPE)
endfunction()

configure("${CMAKE_CURRENT_LIST_DIR}/as_subdirectory" "${build}" "-Dpackage=${package}")
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${build}" --config Release OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${build}" --config Release --prefix "${prefix}"
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
list_files("${prefix}" installed)
if(NOT installed MATCHES "^bin/consumer(\\.exe)?$")
  message(FATAL_ERROR "A project with the package as a subdirectory has installed ${installed}")
endif()
execute_process(
  COMMAND "${prefix}/${installed}" "${CMAKE_CURRENT_LIST_DIR}/square.off"
  OUTPUT_VARIABLE output
  COMMAND_ERROR_IS_FATAL ANY)
if(NOT output MATCHES "^v0 0\nv1 1\nv2 1\\.41421\n")
  message(FATAL_ERROR "The consumer printed\n${output}")
endif()
execute_process(
  COMMAND "${CMAKE_CTEST_COMMAND}" --show-only
  WORKING_DIRECTORY "${build}"
  OUTPUT_VARIABLE tests
  COMMAND_ERROR_IS_FATAL ANY)
if(NOT tests MATCHES "Total Tests: 0")
  message(FATAL_ERROR "A project with the package as a subdirectory has got tests:\n${tests}")
endif()

# If it wants to, it installs the package as well.
configure("${CMAKE_CURRENT_LIST_DIR}/as_subdirectory" "${build}" -DSurface_mesh_geodesics_INSTALL=ON)
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${build}" --config Release --prefix "${prefix}"
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
set(header "include/CGAL/Surface_mesh_geodesics.h")
if(NOT EXISTS "${prefix}/${header}")
  message(FATAL_ERROR "Surface_mesh_geodesics_INSTALL has not installed ${header}")
endif()

configure("${package}" "${work_folder}/unbuilt" -DSurface_mesh_geodesics_TESTS=OFF -DSurface_mesh_geodesics_EXAMPLES=OFF
          -DSurface_mesh_geodesics_BENCHMARK=OFF -DSurface_mesh_geodesics_PROGRAM=ON)
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${work_folder}/unbuilt" --prefix "${work_folder}/unbuilt_prefix"
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
list_files("${work_folder}/unbuilt_prefix" installed)
if(NOT header IN_LIST installed)
  message(FATAL_ERROR "The package has not installed ${header}")
endif()
foreach(file IN LISTS installed)
  if(NOT file MATCHES "^(include|share/cmake)/")
    message(FATAL_ERROR "The package has installed ${file} though nothing has been built")
  endif()
endforeach()
