#ifndef SURFACE_MESH_GEODESICS_EXPECTED_EXCEPTIONS_H
#define SURFACE_MESH_GEODESICS_EXPECTED_EXCEPTIONS_H

// Tells whether a call throws the exception that a test expects. All other exceptions end the test program.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>

namespace test_meshes {

using Invalid_input = CGAL::Surface_mesh_geodesics::Invalid_geodesic_input;
using Reason = Invalid_input::Reason;

// Returns whether a call throws an exception of this type.
template <class Exception, class Function>
bool throws(Function function)
{
  try
  {
    function();
  }
  catch(const Exception&)
  {
    return true;
  }
  return false;
}

// Returns whether a call throws Invalid_geodesic_input with this reason.
template <class Function>
bool throws_reason(Reason reason, Function function)
{
  try
  {
    function();
  }
  catch(const Invalid_input& e)
  {
    return e.reason() == reason;
  }
  return false;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_EXPECTED_EXCEPTIONS_H
