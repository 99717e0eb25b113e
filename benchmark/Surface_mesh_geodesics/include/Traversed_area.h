// The traversed area of the thesis (section 4.3): the set R of the faces that the wavefront has passed.

#ifndef TRAVERSED_AREA_H
#define TRAVERSED_AREA_H

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace schedulers {

using CGAL::Surface_mesh_geodesics::internal::Face_id;

// A face that has joined never leaves. The faces that have joined in the present iteration are the region that the
// thesis writes as a difference, Delta R = R' \ R.
class Traversed_area
{
public:
  explicit Traversed_area(std::size_t number_of_faces) : m_joined_in(number_of_faces, 0) {}

  void begin_iteration() { ++m_iteration; }

  // Adds a face. Returns whether it was outside before.
  bool add(Face_id f)
  {
    const bool is_outside = !contains(f);
    if(is_outside)
    {
      m_joined_in[f] = m_iteration;
    }
    return is_outside;
  }

  bool contains(Face_id f) const { return m_joined_in[f] != 0; }

  // Has the face joined in the present iteration? Requires: begin_iteration() was called.
  bool is_new(Face_id f) const { return m_joined_in[f] == m_iteration; }

private:
  std::vector<std::uint32_t> m_joined_in; // the iteration, by face; 0 for a face outside
  std::uint32_t m_iteration = 0;
};

} // namespace schedulers

#endif // TRAVERSED_AREA_H
