# Functions for tests, examples and benchmark programs. Each .cpp file of their folders is a program.

set(Surface_mesh_geodesics_WARNING_FLAGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion)

# Optional. Without Eigen, programs are left out that include its headers or those of Heat_method_3, which needs it.
find_package(Eigen3 QUIET NO_MODULE)
if(NOT TARGET Eigen3::Eigen)
  message(STATUS "NOTICE: Eigen was not found: the programs that use it are left out.")
endif()

# Optional. Programs that mention CGAL_LINKED_WITH_TBB or Parallel_if_available_tag are linked with TBB.
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

# Removes the programs that cannot be compiled here from a list of source files.
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

# Sets the options of a program or of a group of them: the shared headers in include/ of their folder, the libraries,
# the warnings.
function(surface_mesh_geodesics_set_up_program target folder uses_eigen uses_tbb)
  target_include_directories(${target} PRIVATE "${folder}/include")
  target_link_libraries(${target} PRIVATE CGAL::Surface_mesh_geodesics)
  if(uses_eigen)
    target_link_libraries(${target} PRIVATE Eigen3::Eigen)
    target_compile_definitions(${target} PRIVATE CGAL_EIGEN3_ENABLED)
  endif()
  if(uses_tbb AND TARGET CGAL::TBB_support)
    target_link_libraries(${target} PRIVATE CGAL::TBB_support)
  endif()
  target_compile_options(${target} PRIVATE ${Surface_mesh_geodesics_PROGRAM_FLAGS})
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE ${Surface_mesh_geodesics_WARNING_FLAGS})
    if(Surface_mesh_geodesics_WARNINGS_AS_ERRORS)
      target_compile_options(${target} PRIVATE -Werror)
      # GCC 12 warns that std::vector copies from a null pointer where it has inlined the assignment of an empty list.
      if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
        target_compile_options(${target} PRIVATE -Wno-error=nonnull)
      endif()
    endif()
  endif()
endfunction()

# Notes a unit, its folder and whether it uses Eigen for the checks with a second compiler (check_headers.cmake).
function(surface_mesh_geodesics_note_unit unit folder uses_eigen)
  set_property(GLOBAL APPEND PROPERTY Surface_mesh_geodesics_PROGRAM_UNITS "${unit}|${folder}|${uses_eigen}")
endfunction()

# Adds a program named like its source file.
function(surface_mesh_geodesics_add_program source uses_eigen uses_tbb)
  get_filename_component(folder "${source}" DIRECTORY)
  get_filename_component(name "${source}" NAME_WE)
  surface_mesh_geodesics_note_unit("${source}" "${folder}" ${uses_eigen})
  add_executable(${name} "${source}")
  surface_mesh_geodesics_set_up_program(${name} "${folder}" ${uses_eigen} ${uses_tbb})
endfunction()

# Adds one executable that holds several programs, and a link to it for each of them. For the rest of the build, the
# links are the programs.
function(surface_mesh_geodesics_add_program_group group uses_eigen uses_tbb)
  list(GET ARGN 0 source)
  get_filename_component(folder "${source}" DIRECTORY)
  set(unit "${CMAKE_CURRENT_BINARY_DIR}/${group}.cpp")
  set(script "${PROJECT_SOURCE_DIR}/cmake/write_program_group.cmake")
  add_custom_command(
    OUTPUT "${unit}"
    COMMAND "${CMAKE_COMMAND}" "-Doutput=${unit}" "-Dsources=${ARGN}" -P "${script}"
    DEPENDS ${ARGN} "${script}"
    COMMENT "Writing ${group}.cpp"
    VERBATIM)
  surface_mesh_geodesics_note_unit("${unit}" "${folder}" ${uses_eigen})
  add_executable(${group} "${unit}")
  surface_mesh_geodesics_set_up_program(${group} "${folder}" ${uses_eigen} ${uses_tbb})
  foreach(source IN LISTS ARGN)
    get_filename_component(name "${source}" NAME_WE)
    set(link "${CMAKE_CURRENT_BINARY_DIR}/${name}")
    add_custom_command(TARGET ${group} POST_BUILD COMMAND "${CMAKE_COMMAND}" -E create_symlink ${group} "${link}")
    add_executable(${name} IMPORTED GLOBAL)
    set_target_properties(${name} PROPERTIES IMPORTED_LOCATION "${link}")
  endforeach()
endfunction()

# Adds a program for each source file, and notes the files for the checks that compile each of them alone. Programs are
# grouped if Surface_mesh_geodesics_GROUP_PROGRAMS is on, at most `size` in a group, except those that define or undefine
# macros.
function(surface_mesh_geodesics_add_programs group size)
  set_property(GLOBAL APPEND PROPERTY Surface_mesh_geodesics_PROGRAM_SOURCES ${ARGN})
  foreach(source IN LISTS ARGN)
    surface_mesh_geodesics_uses_eigen("${source}" uses_eigen)
    file(STRINGS "${source}" lines_with_tbb REGEX "CGAL_LINKED_WITH_TBB|Parallel_if_available_tag")
    file(STRINGS "${source}" lines_with_macros REGEX "^#(define|undef|pragma)")
    set(uses_tbb OFF)
    if(lines_with_tbb)
      set(uses_tbb ON)
    endif()
    if(NOT Surface_mesh_geodesics_GROUP_PROGRAMS OR lines_with_macros)
      surface_mesh_geodesics_add_program("${source}" ${uses_eigen} ${uses_tbb})
    else()
      list(APPEND sources_${uses_eigen}_${uses_tbb} "${source}")
    endif()
  endforeach()
  set(number 0)
  # Groups with threads take longest. They come first, so that no processor waits for one of them at the end.
  foreach(uses_eigen IN ITEMS OFF ON)
    foreach(uses_tbb IN ITEMS ON OFF)
      set(sources ${sources_${uses_eigen}_${uses_tbb}})
      while(sources)
        list(LENGTH sources left)
        math(EXPR groups_left "(${left} + ${size} - 1) / ${size}")
        math(EXPR share "(${left} + ${groups_left} - 1) / ${groups_left}") # groups take about the same time
        list(SUBLIST sources 0 ${share} part)
        list(REMOVE_ITEM sources ${part})
        math(EXPR number "${number} + 1")
        surface_mesh_geodesics_add_program_group(${group}_${number} ${uses_eigen} ${uses_tbb} ${part})
      endwhile()
    endforeach()
  endforeach()
endfunction()

# Adds one CTest test for each line of arguments in the file `name.cmd` beside the source file, or one test without
# arguments if that file does not exist. Skips empty lines and lines that start with #. Returns the names of the tests
# in `out_tests`.
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

# Looks for one of CGAL's meshes, such as bunny00.off, in an archive of Debian's package libcgal-demo. Returns its path
# in `out_path`, which is empty if the mesh is not found.
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
