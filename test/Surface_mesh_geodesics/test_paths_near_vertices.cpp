// Paths between points very near vertices, on needles. Each path is as long as the distance, and in a rectangle the
// distance is that of the straight line. fuzz_paths_near_vertices.cpp checks many more meshes.

#include "paths_near_vertices.h"

#include <cstdint>
#include <iostream>

using namespace paths_near_vertices;

namespace {

// A line passes a vertex at a distance of 1e-16, on faces of 1 x 1e-6. An earlier version followed it on the wrong
// side.
void a_line_through_a_vertex_of_needles_is_found()
{
  test_support::Scope scope("line through a vertex");
  Mesh tm;
  std::vector<vertex_descriptor> v;
  for(int j = 0; j <= 2; ++j)
  {
    for(int i = 0; i <= 3; ++i)
    {
      v.push_back(tm.add_vertex(Kernel::Point_3(i, 1e-6 * j, 0.)));
    }
  }
  // all choices of the diagonals
  for(unsigned int cuts = 0; cuts < 64; ++cuts)
  {
    Mesh cut = tm;
    for(std::size_t k = 0; k < 6; ++k)
    {
      const std::size_t corner = k / 3 * 4 + k % 3;
      const vertex_descriptor a = v[corner], b = v[corner + 1], c = v[corner + 5], d = v[corner + 4];
      if((cuts >> k & 1) != 0)
      {
        cut.add_face(a, b, c);
        cut.add_face(a, c, d);
      }
      else
      {
        cut.add_face(a, b, d);
        cut.add_face(b, c, d);
      }
    }
    for(std::size_t f = 0; f < 12; ++f)
    {
      Geodesic_paths paths(cut);
      paths.add_source_point(face_descriptor(5), {0.9999999999, 4.7282399108046434e-11, 5.2717600891953569e-11});
      checked_path(paths,
                   Surface_point(Geodesic_paths::Face_location(
                     face_descriptor(static_cast<std::uint32_t>(f)),
                     {0.060463493181134559, 0.79075815096729074, 0.1487783558515747})),
                   cut, 3.);
    }
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = 20260407;
  std::cout << "seed " << seed << "\n";
  test_support::Random random(seed);
  a_line_through_a_vertex_of_needles_is_found();
  paths_in_rectangles_of_long_faces_are_found(20000, random);
  paths_on_squeezed_meshes_are_found(2000, random);
  return test_support::test_result();
}
