# Checks of the headers, as CTest tests of the configuration `full`, with g++ and clang++ if they are there:
# - each header compiles alone, with warnings as errors, and may be included twice;
# - all headers compile after macros with short names, such as those of Windows;
# - two units that both include every header link together into one program (finds a missing `inline`);
# - the programs compile without warnings with the compiler that does not build them, in the groups of the build:
#   templates show their warnings only when they are instantiated.
#
# The compiler that builds the programs reads each header alone. The other one does so in the configuration `long`,
# where each program compiles alone, too: groups hide missing includes.

find_program(Surface_mesh_geodesics_GCC NAMES g++)
find_program(Surface_mesh_geodesics_CLANG NAMES clang++)
mark_as_advanced(Surface_mesh_geodesics_GCC Surface_mesh_geodesics_CLANG)

set(check_folder "${CMAKE_CURRENT_BINARY_DIR}/check_headers")
set(own_include_folder "${CMAKE_CURRENT_SOURCE_DIR}/include")

# --- the flags -------------------------------------------------------------------------------------------------------

# Only the headers of the libraries are system headers, so that warnings in our own headers count. A folder that the
# compiler searches by default must not be named, because that would change the order of the standard headers.
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

# A source is written only if its text changes, so that a new configuration compiles nothing again.
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

surface_mesh_geodesics_write_unit("after_macros.cpp" "#include \"macros_of_other_headers.h\"\n${all_includes}\n")

# --- the tests -------------------------------------------------------------------------------------------------------

# CGAL's targets bring the libraries, but these commands do not use targets.
set(number_libraries)
foreach(library IN ITEMS "${MPFR_LIBRARIES}" "${GMP_LIBRARIES}")
  if(EXISTS "${library}")
    list(APPEND number_libraries "${library}")
  endif()
endforeach()

# Adds a test of the configuration `full` or `long`.
function(surface_mesh_geodesics_add_header_test configuration name)
  add_test(
    NAME "${name}"
    COMMAND ${ARGN}
    CONFIGURATIONS ${configuration})
  set(labels headers)
  if(configuration STREQUAL "long")
    list(APPEND labels long)
  endif()
  set_tests_properties("${name}" PROPERTIES LABELS "${labels}")
endfunction()

# Adds a test that compiles a unit with the command `compile`.
function(surface_mesh_geodesics_add_unit_test configuration name unit folder uses_eigen)
  set(options)
  if(uses_eigen)
    set(options -DCGAL_EIGEN3_ENABLED)
  endif()
  surface_mesh_geodesics_add_header_test(${configuration} "${name}" ${compile} ${options} "-I${folder}/include"
                                         -fsyntax-only "${unit}")
endfunction()

get_property(program_sources GLOBAL PROPERTY Surface_mesh_geodesics_PROGRAM_SOURCES)
get_property(program_units GLOBAL PROPERTY Surface_mesh_geodesics_PROGRAM_UNITS)

foreach(compiler IN ITEMS "${Surface_mesh_geodesics_GCC}" "${Surface_mesh_geodesics_CLANG}")
  if(NOT compiler)
    message(STATUS "NOTICE: g++ or clang++ was not found: the headers are checked with the other one only.")
    continue()
  endif()
  get_filename_component(compiler_name "${compiler}" NAME)
  set(compile "${compiler}" "@${check_folder}/flags.txt")
  set(configuration_of_headers long)
  if((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND compiler STREQUAL Surface_mesh_geodesics_GCC)
     OR (CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND compiler STREQUAL Surface_mesh_geodesics_CLANG))
    set(configuration_of_headers full)
  endif()

  foreach(header IN LISTS headers)
    surface_mesh_geodesics_add_header_test(
      ${configuration_of_headers} "header_alone/${compiler_name}/${header}" ${compile} -fsyntax-only
      "${check_folder}/alone/${header}.cpp")
  endforeach()

  foreach(definition IN ITEMS -UCGAL_LINKED_WITH_TBB -DCGAL_LINKED_WITH_TBB)
    surface_mesh_geodesics_add_header_test(
      full "headers_after_macros/${compiler_name}/${definition}" ${compile} ${definition}
      "-I${CMAKE_CURRENT_SOURCE_DIR}/test/Surface_mesh_geodesics/include" -fsyntax-only
      "${check_folder}/after_macros.cpp")
  endforeach()

  set(program "${check_folder}/two_units_${compiler_name}")
  surface_mesh_geodesics_add_header_test(
    full "two_units_link/${compiler_name}" ${compile} "${check_folder}/first_unit.cpp"
    "${check_folder}/second_unit.cpp" -o "${program}" ${number_libraries} -pthread)
  surface_mesh_geodesics_add_header_test(full "two_units_run/${compiler_name}" "${program}")
  set_tests_properties("two_units_link/${compiler_name}" PROPERTIES FIXTURES_SETUP "two_units_${compiler_name}")
  set_tests_properties("two_units_run/${compiler_name}" PROPERTIES FIXTURES_REQUIRED "two_units_${compiler_name}")

  if(configuration_of_headers STREQUAL "full")
    continue() # this compiler builds the programs
  endif()
  foreach(unit IN LISTS program_units)
    string(REPLACE "|" ";" unit "${unit}")
    list(GET unit 0 source)
    list(GET unit 1 folder)
    list(GET unit 2 uses_eigen)
    get_filename_component(name "${source}" NAME_WE)
    surface_mesh_geodesics_add_unit_test(full "unit_compiles/${compiler_name}/${name}" "${source}" "${folder}"
                                         ${uses_eigen})
  endforeach()
  foreach(source IN LISTS program_sources)
    get_filename_component(folder "${source}" DIRECTORY)
    get_filename_component(name "${source}" NAME_WE)
    surface_mesh_geodesics_uses_eigen("${source}" uses_eigen)
    surface_mesh_geodesics_add_unit_test(long "program_compiles/${compiler_name}/${name}" "${source}" "${folder}"
                                         ${uses_eigen})
  endforeach()
endforeach()
