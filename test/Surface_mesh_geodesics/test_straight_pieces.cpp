// Follows the last straight piece of the path to each vertex across the faces, as the arrival describes it. On meshes
// without needles, the first attempt leads to the root of the piece, with the right length. Then tests the laws of two
// basic functions of paths: turning an image into the frame of a side, and the distance at a point of a face.

#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using internal::Vertex_id;
using Intrinsic_mesh = internal::Intrinsic_mesh<double>;
using Field = internal::Vertex_distance_field<double>;
using Face_frame = internal::Face_frame<double>;

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
  const Vertex_id end = piece.trace(piece_to(mesh, field, v)).vertex;
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

void pieces_have_the_length_of_the_distance(const Indexed_mesh& indexed, const std::vector<std::size_t>& sources)
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

// --- laws of unfolding ---

// The mirror image of the face: A and B are swapped.
Face_frame mirrored(Face_frame c)
{
  std::swap(c.apex_x, c.apex_rest);
  std::swap(c.left_length, c.right_length);
  return c;
}

// The image keeps its distance from the corner, and has the depth below the line of the side that the plane gives.
void check_image_below_left_side(const Face_frame& c, double x, double depth)
{
  const internal::Side_angle<double> angle = internal::left_angle(c);
  const internal::Image_below_edge<double> image = internal::image_below_side(angle, x, depth);
  const double size = std::hypot(x, depth), rounding = 1e-14 * size;
  CHECK_NEAR(std::hypot(image.x, image.depth), size, rounding);
  CHECK_NEAR(image.x, (x * c.apex_x - depth * c.apex_y) / c.left_length, rounding);
  CHECK_NEAR(image.depth, (x * c.apex_y + depth * c.apex_x) / c.left_length, rounding);
  // scaling by a power of two is exact
  for(const int exponent : {-40, 1, 60})
  {
    const double factor = std::ldexp(1., exponent);
    const internal::Image_below_edge<double> scaled = internal::image_below_side(angle, factor * x, factor * depth);
    CHECK(scaled.x == factor * image.x && scaled.depth == factor * image.depth);
  }
}

void images_are_rotated_about_a_corner(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(indexed));
  for(internal::Face_id f = 0; f < mesh.number_of_faces(); ++f)
  {
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Face_frame c = mesh.face_frame(internal::halfedge_of(f, k)), m = mirrored(c);
      const internal::Side_angle<double> left = internal::left_angle(c), right = internal::right_angle(c);
      CHECK_NEAR(std::hypot(left.cosine, left.sine), 1., 1e-13);
      CHECK_NEAR(std::hypot(right.cosine, right.sine), 1., 1e-13);
      CHECK(left.sine >= 0 && right.sine >= 0);
      CHECK(internal::left_angle(m).cosine == right.cosine && internal::left_angle(m).sine == right.sine);
      const double x = random.uniform(-1., 2.) * c.length, depth = random.uniform(0., 2.) * c.length;
      check_image_below_left_side(c, x, depth);
      check_image_below_left_side(m, c.length - x, depth);
    }
  }
}

// --- laws of the distance at a point of a face ---

// A mesh with the distances and windows from some sources.
struct Solved_mesh
{
  Intrinsic_mesh mesh;
  Field field;
  internal::Edge_window_field<double> windows;

  Solved_mesh(const Indexed_mesh& indexed, const std::vector<std::size_t>& sources)
    : mesh(intrinsic_mesh(to_face_graph(indexed)))
  {
    using Keeper = internal::Window_keeper<double>;
    windows.reset(mesh.number_of_faces());
    internal::Distance_propagation<double, internal::All_pruning_rules, Keeper> propagation(mesh, field,
                                                                                            Keeper(windows));
    for(const std::size_t s : sources)
    {
      propagation.add_source(static_cast<Vertex_id>(s % mesh.number_of_vertices()), 0.);
    }
    CHECK(propagation.run([](std::size_t, double) { return true; }));
  }

  double distance(internal::Face_id f, const std::array<double, 3>& b) const
  {
    return internal::arrival_at_location(mesh, field, windows, f, b).distance;
  }
};

std::array<double, 3> random_weights(test_support::Random& random)
{
  const double a = random.uniform(), b = random.uniform() * (1. - a);
  return {a, b, 1. - a - b};
}

// The distance between two points of a face in the plane of the face.
double distance_in_face(const Intrinsic_mesh& mesh, internal::Face_id f, const std::array<double, 3>& a,
                        const std::array<double, 3>& b)
{
  const Face_frame c = mesh.face_frame(internal::halfedge_of(f, 0));
  const std::array<double, 2> p = internal::point_in_frame(c, a, 0), q = internal::point_in_frame(c, b, 0);
  return std::hypot(q[0] - p[0], q[1] - p[1]);
}

// At a corner the distance is that of the vertex; on an edge both faces agree; in a face it changes at most by the
// distance of the points.
void distances_in_faces_obey_their_laws(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Solved_mesh solved(indexed, {0, 17, 40});
  const Intrinsic_mesh& mesh = solved.mesh;
  for(internal::Face_id f = 0; f < mesh.number_of_faces(); ++f)
  {
    for(unsigned int k = 0; k < 3; ++k)
    {
      std::array<double, 3> corner{};
      corner[k] = 1.;
      const internal::Halfedge_id h = internal::halfedge_of(f, k), o = mesh.opposite(h);
      const double expected = solved.field.distance[mesh.source(h)];
      CHECK(solved.distance(f, corner) <= expected);
      CHECK_CLOSE(solved.distance(f, corner), expected, 1e-13);
      if(o == internal::null_id)
      {
        continue;
      }
      const double t = random.uniform();
      std::array<double, 3> here{}, there{};
      here[k] = there[internal::next_corner(internal::index_in_face(o))] = 1. - t;
      here[internal::next_corner(k)] = there[internal::index_in_face(o)] = t;
      CHECK_CLOSE(solved.distance(f, here), solved.distance(internal::face_of(o), there), 1e-12);
    }
    const std::array<double, 3> a = random_weights(random), b = random_weights(random);
    const double d = solved.distance(f, a), e = solved.distance(f, b);
    CHECK(std::abs(d - e) <= distance_in_face(mesh, f, a, b) + 1e-13 * (d + e));
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261124);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : {noisy_sphere(4, .05, seed), rough_terrain(20, .3, seed), torus(1., .4, 24, 12),
                                     saddle_patch(12), cube_grid(6), genus_2_polycube()})
  {
    pieces_have_the_length_of_the_distance(indexed, {0});
    pieces_have_the_length_of_the_distance(indexed, {3, 50, 101});
    images_are_rotated_about_a_corner(indexed, random);
    distances_in_faces_obey_their_laws(indexed, random);
  }
  return test_result();
}
