// Follows the last straight piece of the path to each vertex across the faces, as the arrival describes it. On meshes
// without needles it leads to its root, with the right length, at the first attempt.

#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>

#include <cstddef>
#include <cstdint>
#include <vector>

using namespace test_meshes;

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using internal::Vertex_id;
using Intrinsic_mesh = internal::Intrinsic_mesh<double>;
using Field = internal::Vertex_distance_field<double>;

internal::Piece_start<double> piece_to(const Intrinsic_mesh& mesh, const Field& field, Vertex_id v)
{
  const internal::Vertex_arrival<double>& arrival = field.arrival[v];
  const internal::Face_frame<double> c = mesh.face_frame(arrival.halfedge);
  return {arrival.halfedge, c.apex_x, c.apex_y, arrival.abscissa, field.image[v].x, field.image[v].depth, arrival.root,
          field.distance[v]};
}

void check_piece(const Intrinsic_mesh& mesh, const Field& field, Vertex_id v)
{
  internal::Path_steps<double> steps;
  internal::Straight_piece<double> piece(mesh, field, 0., steps);
  const Vertex_id end = piece.trace(piece_to(mesh, field, v));
  if(!CHECK(end != internal::null_id))
  {
    return;
  }
  double length = 0;
  for(const internal::Path_step<double>& step : steps)
  {
    CHECK(step.face != internal::null_id);
    length += step.gap;
  }
  CHECK_EQUAL(steps.back().vertex, end);
  CHECK_CLOSE(length + field.distance[end], field.distance[v], 1e-12);
  CHECK(field.source_of(end) == field.source_of(v));
}

void check_pieces(const Indexed_mesh& indexed, const std::vector<std::size_t>& sources)
{
  test_support::Scope scope(indexed.name);
  const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(indexed));
  Field field;
  field.keeps_images = true;
  internal::Distance_propagation<double> propagation(mesh, field);
  for(const std::size_t s : sources)
  {
    propagation.add_source(static_cast<Vertex_id>(s % mesh.number_of_vertices()), 0.);
  }
  CHECK(propagation.run([](std::size_t, double) { return true; }));
  for(Vertex_id v = 0; v < mesh.number_of_vertices(); ++v)
  {
    if(!field.is_source(v) && field.arrival[v].halfedge != internal::null_id)
    {
      check_piece(mesh, field, v);
    }
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261124);
  for(const Indexed_mesh& indexed : {noisy_sphere(4, .05, seed), rough_terrain(20, .3, seed), torus(1., .4, 24, 12),
                                     saddle_patch(12), cube_grid(6), genus_2_polycube()})
  {
    check_pieces(indexed, {0});
    check_pieces(indexed, {3, 50, 101});
  }
  return test_result();
}
