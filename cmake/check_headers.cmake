# Checks of the headers, as CTest tests, with every compiler of g++ and clang++ that is there:
# - each header compiles alone, with warnings as errors, and may be included twice;
# - two units that both include every header link together into one program (finds a missing `inline`);
# - the programs compile without warnings with the compiler that does not build them: templates only show their
#   warnings once they are instantiated.

find_program(Surface_mesh_geodesics_GCC NAMES g++)
find_program(Surface_mesh_geodesics_CLANG NAMES clang++)
mark_as_advanced(Surface_mesh_geodesics_GCC Surface_mesh_geodesics_CLANG)

set(check_folder "${CMAKE_CURRENT_BINARY_DIR}/check_headers")
set(own_include_folder "${CMAKE_CURRENT_SOURCE_DIR}/include")

# --- the flags -------------------------------------------------------------------------------------------------------

# Our own headers are ordinary ones, so that their warnings count; those of the libraries are system headers. A folder
# that the compiler knows by itself must not be named: it would change the order of the standard headers.
string(REPLACE ";" "|" implicit_folders "${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES};/usr/include")
string(REPLACE "+" "\\+" implicit_folders "${implicit_folders}")
set(library_folders "$<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_INCLUDE_DIRECTORIES>")
if(TARGET Eigen3::Eigen)
  string(APPEND library_folders ";$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>")
endif()
set(library_folders "$<REMOVE_DUPLICATES:$<FILTER:${library_folders},EXCLUDE,^(${implicit_folders})?$>>")
set(library_definitions "$<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_COMPILE_DEFINITIONS>")

string(JOIN "\n" flags -std=c++17 ${Surface_mesh_geodesics_WARNING_FLAGS} -Werror "-I\"${own_include_folder}\"")
string(APPEND flags "\n$<$<BOOL:${library_folders}>:-isystem\"$<JOIN:${library_folders},\"\n-isystem\">\">")
string(APPEND flags "\n$<$<BOOL:${library_definitions}>:-D$<JOIN:${library_definitions},\n-D>>\n")
file(GENERATE OUTPUT "${check_folder}/flags.txt" CONTENT "${flags}")

# --- the units -------------------------------------------------------------------------------------------------------

# The generated sources are only written when they change, so that a new configuration compiles nothing anew.
function(surface_mesh_geodesics_write_unit file content)
  file(GENERATE OUTPUT "${check_folder}/${file}" CONTENT "${content}")
endfunction()

file(
  GLOB_RECURSE headers
  CONFIGURE_DEPENDS
  RELATIVE "${own_include_folder}"
  "${own_include_folder}/*.h")

set(all_includes)
foreach(header IN LISTS headers)
  surface_mesh_geodesics_write_unit("alone/${header}.cpp" "#include <${header}>\n#include <${header}>\n")
  string(APPEND all_includes "#include <${header}>\n")
endforeach()
surface_mesh_geodesics_write_unit("first_unit.cpp" "${all_includes}\nint second_unit();\n
int main()\n{\n  return second_unit();\n}\n")
surface_mesh_geodesics_write_unit("second_unit.cpp" "${all_includes}\nint second_unit();\n
int second_unit()\n{\n  return 0;\n}\n")

# What most programs include of the libraries. Clang reads it once for all programs, which halves the time of them all;
# g++ sees the programs as they are.
surface_mesh_geodesics_write_unit("libraries.h" "#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>
")

# --- the tests -------------------------------------------------------------------------------------------------------

# CGAL tells its targets the libraries, but a command that is not one of CMake's own has to name them itself.
set(number_libraries)
foreach(library IN ITEMS "${MPFR_LIBRARIES}" "${GMP_LIBRARIES}")
  if(EXISTS "${library}")
    list(APPEND number_libraries "${library}")
  endif()
endforeach()

get_property(program_sources GLOBAL PROPERTY Surface_mesh_geodesics_PROGRAM_SOURCES)

foreach(compiler IN ITEMS "${Surface_mesh_geodesics_GCC}" "${Surface_mesh_geodesics_CLANG}")
  if(NOT compiler)
    message(STATUS "NOTICE: g++ or clang++ was not found: the headers are checked with the other one only.")
    continue()
  endif()
  get_filename_component(compiler_name "${compiler}" NAME)
  set(compile "${compiler}" "@${check_folder}/flags.txt")

  foreach(header IN LISTS headers)
    set(test "header_alone/${compiler_name}/${header}")
    add_test(NAME "${test}" COMMAND ${compile} -fsyntax-only "${check_folder}/alone/${header}.cpp")
    set_tests_properties("${test}" PROPERTIES LABELS headers)
  endforeach()

  set(program "${check_folder}/two_units_${compiler_name}")
  add_test(NAME "two_units_link/${compiler_name}"
           COMMAND ${compile} "${check_folder}/first_unit.cpp" "${check_folder}/second_unit.cpp" -o "${program}"
                   ${number_libraries} -pthread)
  add_test(NAME "two_units_run/${compiler_name}" COMMAND "${program}")
  set_tests_properties("two_units_link/${compiler_name}" PROPERTIES LABELS headers
                                                                    FIXTURES_SETUP "two_units_${compiler_name}")
  set_tests_properties("two_units_run/${compiler_name}" PROPERTIES LABELS headers
                                                                   FIXTURES_REQUIRED "two_units_${compiler_name}")

  if((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND compiler STREQUAL Surface_mesh_geodesics_GCC)
     OR (CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND compiler STREQUAL Surface_mesh_geodesics_CLANG))
    continue()
  endif()
  set(libraries "${check_folder}/libraries.pch")
  if(compiler STREQUAL Surface_mesh_geodesics_CLANG)
    add_test(NAME program_compiles/libraries
             COMMAND ${compile} -x c++-header "${check_folder}/libraries.h" -o "${libraries}")
    set_tests_properties(program_compiles/libraries PROPERTIES LABELS headers FIXTURES_SETUP compiled_libraries)
  endif()
  foreach(source IN LISTS program_sources)
    get_filename_component(folder "${source}" DIRECTORY)
    get_filename_component(name "${source}" NAME_WE)
    set(test "program_compiles/${compiler_name}/${name}")
    set(options)
    set(fixtures)
    surface_mesh_geodesics_uses_eigen("${source}" uses_eigen)
    if(uses_eigen) # (a definition that the compiled libraries do not have)
      set(options -DCGAL_EIGEN3_ENABLED)
    elseif(compiler STREQUAL Surface_mesh_geodesics_CLANG)
      set(options -include-pch "${libraries}")
      set(fixtures compiled_libraries)
    endif()
    add_test(NAME "${test}" COMMAND ${compile} ${options} "-I${folder}/include" -fsyntax-only "${source}")
    set_tests_properties("${test}" PROPERTIES LABELS headers FIXTURES_REQUIRED "${fixtures}")
  endforeach()
endforeach()
