# Writes one unit that holds several programs. Runs as a script when a program of the group has changed:
#   cmake -Doutput=UNIT.cpp "-Dsources=A.cpp;B.cpp" -P write_program_group.cmake
#
# Each program stands in a namespace with its name. The unit reads the headers of all programs first, outside of the
# namespaces: their include guards make the same lines inside the programs empty. So a program must not include a
# header without guards, such as CGAL/Exact_rational.h of CGAL 5.5. The name under which the unit is called decides
# which program runs.
cmake_minimum_required(VERSION 3.19...3.31)

set(includes)
set(programs)
set(calls)
foreach(source IN LISTS sources)
  get_filename_component(name "${source}" NAME_WE)
  # Conditions around includes come along; without what they guard, other conditions are empty.
  file(STRINGS "${source}" directives REGEX "^#")
  string(JOIN "\n" directives ${directives})
  string(APPEND includes "${directives}\n")
  string(APPEND programs "namespace ${name} {\n#include \"${source}\"\n} // namespace ${name}\n\n")
  string(APPEND calls "  if(name == \"${name}\")\n    return call(${name}::main, argc, argv);\n")
endforeach()

file(CONFIGURE OUTPUT "${output}" CONTENT [=[
// Made by write_program_group.cmake.
@includes@
#include <iostream>
#include <string>

@programs@
namespace {

int call(int (*program)(), int, char*[])
{
  return program();
}

int call(int (*program)(int, char*[]), int argc, char* argv[])
{
  return program(argc, argv);
}

} // namespace

int main(int argc, char* argv[])
{
  static_cast<void>(static_cast<int (*)(int (*)(), int, char*[])>(call));
  static_cast<void>(static_cast<int (*)(int (*)(int, char*[]), int, char*[])>(call));
  const std::string path = argv[0];
  std::string name = path.substr(path.find_last_of("/\\") + 1);
  name = name.substr(0, name.find(".exe"));
@calls@
  std::cerr << "No program of this group is called " << name << std::endl;
  return 1;
}
]=] @ONLY)
