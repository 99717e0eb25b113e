# What the tests, the examples and the benchmark programs share: every .cpp file of their folder is one program.

set(Surface_mesh_geodesics_WARNING_FLAGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion)

# Optional: programs that include headers of Eigen, or of Heat_method_3, which needs it, are left out without it.
find_package(Eigen3 QUIET NO_MODULE)
if(NOT TARGET Eigen3::Eigen)
  message(STATUS "NOTICE: Eigen was not found: the programs that use it are left out.")
endif()

# Optional: programs that ask for CGAL_LINKED_WITH_TBB, or for what is parallel if available, are linked with it.
find_package(TBB QUIET)
if(TBB_FOUND)
  include(CGAL_TBB_support OPTIONAL)
endif()
if(NOT TARGET CGAL::TBB_support)
  message(STATUS "NOTICE: TBB was not found: nothing is computed in parallel.")
endif()

# Whether a program includes headers of Eigen, or headers of CGAL that do nothing without it.
function(surface_mesh_geodesics_uses_eigen source out_answer)
  file(STRINGS "${source}" lines REGEX "^#include <(Eigen|CGAL/Heat_method_3)/")
  if(lines)
    set(${out_answer} ON PARENT_SCOPE)
  else()
    set(${out_answer} OFF PARENT_SCOPE)
  endif()
endfunction()

# Takes the programs that cannot be compiled here out of a list of source files.
function(surface_mesh_geodesics_leave_out list_of_sources)
  set(kept)
  foreach(source IN LISTS ${list_of_sources})
    surface_mesh_geodesics_uses_eigen("${source}" uses_eigen)
    if(TARGET Eigen3::Eigen OR NOT uses_eigen)
      list(APPEND kept "${source}")
    endif()
  endforeach()
  set(${list_of_sources} ${kept} PARENT_SCOPE)
endfunction()

# Adds a program named like its source file and notes the file for the checks with a second compiler. The headers that
# the programs of a folder share are in include/ beside them.
function(surface_mesh_geodesics_add_program source)
  get_filename_component(folder "${source}" DIRECTORY)
  get_filename_component(name "${source}" NAME_WE)
  add_executable(${name} "${source}")
  target_include_directories(${name} PRIVATE "${folder}/include")
  target_link_libraries(${name} PRIVATE CGAL::Surface_mesh_geodesics)
  surface_mesh_geodesics_uses_eigen("${source}" uses_eigen)
  if(uses_eigen)
    target_link_libraries(${name} PRIVATE Eigen3::Eigen)
    target_compile_definitions(${name} PRIVATE CGAL_EIGEN3_ENABLED)
  endif()
  file(STRINGS "${source}" lines_with_tbb REGEX "CGAL_LINKED_WITH_TBB|Parallel_if_available_tag")
  if(lines_with_tbb AND TARGET CGAL::TBB_support)
    target_link_libraries(${name} PRIVATE CGAL::TBB_support)
  endif()
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${name} PRIVATE ${Surface_mesh_geodesics_WARNING_FLAGS})
    if(Surface_mesh_geodesics_WARNINGS_AS_ERRORS)
      target_compile_options(${name} PRIVATE -Werror)
    endif()
  endif()
  set_property(GLOBAL APPEND PROPERTY Surface_mesh_geodesics_PROGRAM_SOURCES "${source}")
endfunction()

# Adds one CTest test per line of arguments in `name.cmd` beside the source file, or one without arguments when there is
# no such file. Empty lines and lines that start with # do not count. The names of the tests go to `out_tests`.
function(surface_mesh_geodesics_add_runs source working_directory out_tests)
  get_filename_component(folder "${source}" DIRECTORY)
  get_filename_component(name "${source}" NAME_WE)
  set(tests)
  if(EXISTS "${folder}/${name}.cmd")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${folder}/${name}.cmd")
    file(STRINGS "${folder}/${name}.cmd" lines REGEX "^[ \t]*[^# \t]")
    foreach(line IN LISTS lines)
      list(LENGTH tests number)
      math(EXPR number "${number} + 1")
      separate_arguments(arguments UNIX_COMMAND "${line}")
      add_test(
        NAME ${name}_${number}
        COMMAND ${name} ${arguments}
        WORKING_DIRECTORY "${working_directory}")
      list(APPEND tests ${name}_${number})
    endforeach()
  else()
    add_test(
      NAME ${name}
      COMMAND ${name}
      WORKING_DIRECTORY "${working_directory}")
    set(tests ${name})
  endif()
  set(${out_tests}
      ${tests}
      PARENT_SCOPE)
endfunction()

# Looks for one of CGAL's meshes, such as bunny00.off, which Debian keeps in an archive of the package libcgal-demo. Its
# path goes to `out_path`, which is empty if there is none.
function(surface_mesh_geodesics_find_cgal_mesh name out_path)
  set(archive "/usr/share/doc/libcgal-dev/data.tar.gz")
  set(folder "${PROJECT_BINARY_DIR}/cgal_data")
  set(path "${folder}/data/meshes/${name}")
  if(NOT EXISTS "${path}" AND EXISTS "${archive}")
    file(ARCHIVE_EXTRACT INPUT "${archive}" DESTINATION "${folder}" PATTERNS "data/meshes/${name}")
  endif()
  if(NOT EXISTS "${path}")
    message(STATUS "NOTICE: ${archive} is not there: no test runs on CGAL's mesh ${name}.")
    set(path "")
  endif()
  set(${out_path} "${path}" PARENT_SCOPE)
endfunction()
