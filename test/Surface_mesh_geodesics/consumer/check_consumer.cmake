# Installs the package into a folder of its own, then configures, builds and runs the project beside this file with it.
# Needs -Dbuild_folder, -Dwork_folder, -Dreadme, -Dcompiler, -DCGAL_DIR and -Dgenerator.
cmake_minimum_required(VERSION 3.19...3.31)

set(prefix "${work_folder}/prefix")
set(consumer_build "${work_folder}/build")
file(REMOVE_RECURSE "${work_folder}")

execute_process(COMMAND "${CMAKE_COMMAND}" --install "${build_folder}" --prefix "${prefix}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND
    "${CMAKE_COMMAND}" -G "${generator}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${consumer_build}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DCGAL_DIR=${CGAL_DIR}" "-DCMAKE_CXX_COMPILER=${compiler}"
    -DCMAKE_BUILD_TYPE=Release
  COMMAND_ERROR_IS_FATAL ANY)

# A package installed elsewhere on this machine must not have answered in our place.
load_cache("${consumer_build}" READ_WITH_PREFIX found_ Surface_mesh_geodesics_DIR)
string(FIND "${found_Surface_mesh_geodesics_DIR}" "${prefix}/" position)
if(NOT position EQUAL 0)
  message(FATAL_ERROR "The package was found in ${found_Surface_mesh_geodesics_DIR}, not in ${prefix}")
endif()

# A CGAL that is too old is rejected by the package, with a message that says so, and not by some header.
file(WRITE "${work_folder}/old_cgal/CGALConfig.cmake" "set(CGAL_VERSION 5.4.5)\n")
execute_process(
  COMMAND
    "${CMAKE_COMMAND}" -G "${generator}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${work_folder}/old_cgal/build"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DCGAL_DIR=${work_folder}/old_cgal" "-DCMAKE_CXX_COMPILER=${compiler}"
  RESULT_VARIABLE result
  OUTPUT_QUIET
  ERROR_VARIABLE message)
string(REGEX REPLACE "[ \n]+" " " message "${message}")
if(result EQUAL 0 OR NOT message MATCHES "needs CGAL 5\\.5 or newer, found 5\\.4\\.5 in")
  message(FATAL_ERROR "An old CGAL: the result was ${result}, with\n${message}")
endif()

execute_process(COMMAND "${CMAKE_COMMAND}" --build "${consumer_build}" --config Release COMMAND_ERROR_IS_FATAL ANY)
find_program(
  my_program my_program
  PATHS "${consumer_build}" "${consumer_build}/Release"
  NO_DEFAULT_PATH REQUIRED)
execute_process(
  COMMAND "${my_program}" "${CMAKE_CURRENT_LIST_DIR}/square.off"
  OUTPUT_VARIABLE output
  COMMAND_ERROR_IS_FATAL ANY)

# The unit square, seen from one of its corners: two sides, the diagonal, half the diagonal.
set(expected "v0 0\nv1 1\nv2 1.41421\nv3 1\nv4 0.707107\n")
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "my_program printed\n${output}instead of\n${expected}")
endif()

# Without a mesh, or without triangles, it says so.
file(WRITE "${work_folder}/quad.off" "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
foreach(argument IN ITEMS "" "${work_folder}/missing.off" "${work_folder}/quad.off")
  execute_process(COMMAND "${my_program}" ${argument} RESULT_VARIABLE result ERROR_VARIABLE message)
  if(NOT result EQUAL 1 OR NOT message MATCHES "usage: my_program")
    message(FATAL_ERROR "my_program ${argument} ended with ${result} and the message: ${message}")
  endif()
endforeach()

# The README shows this very project: it cannot fall behind the interface.
file(READ "${readme}" readme_text)
foreach(pair IN ITEMS "cpp|main.cpp" "cmake|CMakeLists.txt")
  string(REPLACE "|" ";" pair "${pair}")
  list(GET pair 0 language)
  list(GET pair 1 name)
  file(READ "${CMAKE_CURRENT_LIST_DIR}/${name}" text)
  string(FIND "${readme_text}" "```${language}\n${text}```" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "What ${readme} shows as ${name} is not test/Surface_mesh_geodesics/consumer/${name}")
  endif()
endforeach()
