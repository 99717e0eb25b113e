// The checks behind a certificate of distances, one by one. They do not trust the proposals of a propagation, but find
// bounds that are too long, missing windows, and paths that leave their faces.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"
#include "thread_team.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Chunk_team.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Component_extents.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

namespace SMGI = SMG::internal;

// A mesh, the distances from some vertices, and the windows of the propagation, except those that enter a face with the
// vertex `into` from a face with the vertex `from`, or from anywhere if `from` is null_id.
struct Witness
{
  using Keeper = SMGI::Window_keeper<double>;

  struct Keeper_without
  {
    Keeper keeper;
    const SMGI::Intrinsic_mesh<double>& mesh;
    SMGI::Vertex_id into, from;

    bool is_at(SMGI::Halfedge_id h, SMGI::Vertex_id v) const
    {
      const auto& corners = mesh.face(SMGI::face_of(h)).vertex;
      return std::find(corners.begin(), corners.end(), v) != corners.end();
    }

    template <typename List>
    void keep(SMGI::Halfedge_id h, const List& list)
    {
      if(!is_at(h, into) || (from != SMGI::null_id && !is_at(mesh.opposite(h), from)))
      {
        keeper.keep(h, list);
      }
    }
    void advance(double) const {}
  };

  Witness(const Indexed_mesh& indexed, SMGI::Vertex_id into = SMGI::null_id, SMGI::Vertex_id from = SMGI::null_id,
          const std::vector<SMGI::Vertex_id>& sources = {0})
    : tm(to_face_graph(indexed))
  {
    const auto vim = get(boost::vertex_index, tm);
    const auto fim = get(boost::face_index, tm);
    const auto vpm = get(CGAL::vertex_point, tm);
    SMGI::Shape_from_points<double, Mesh, std::decay_t<decltype(vpm)>> shape(tm, vpm);
    const SMGI::Obstacles nothing_is_avoided;
    SMGI::Face_graph_reader<double, Mesh, std::decay_t<decltype(vim)>, std::decay_t<decltype(fim)>>(
      tm, vim, fim, nothing_is_avoided)
      .read(shape, mesh, table, []() { return std::vector<char>(); }, SMGI::One_block());
    windows.reset(mesh.number_of_faces());
    field.keeps_images = true;
    SMGI::Distance_propagation<double, SMGI::All_pruning_rules, Keeper_without> propagation(
      mesh, field, Keeper_without{Keeper(windows), mesh, into, from});
    for(const SMGI::Vertex_id v : sources)
    {
      propagation.add_source(v, 0.);
    }
    propagation.run([](std::size_t, double) { return true; });
    extents = SMGI::extents_of_components(mesh);
  }

  SMGI::Vertex_id id(std::size_t v) const { return table.vertex_of_index[v]; }

  template <typename Chunks>
  SMGI::Worst_violation<double> worst(const Chunks& chunks) const
  {
    SMGI::Lower_bound_function<double> function(mesh, field.distance, windows);
    return SMGI::prove_lower_bounds(chunks, function, extents, []() { return true; });
  }

  double violation() const { return worst(SMGI::Chunk_team<SMGI::Calling_thread>()).size; }

  Mesh tm;
  SMGI::Intrinsic_mesh<double> mesh;
  SMGI::Face_graph_correspondence<Mesh> table;
  SMGI::Vertex_distance_field<double> field;
  SMGI::Edge_window_field<double> windows;
  std::vector<double> extents;
};

void threads_find_the_same(const Witness& witness)
{
  const SMGI::Worst_violation<double> expected = witness.worst(SMGI::Chunk_team<SMGI::Calling_thread>());
  for(const std::size_t number_of_threads : {1u, 2u, 3u, 7u})
  {
    const SMGI::Worst_violation<double> found
      = witness.worst(SMGI::Chunk_team<Thread_team>(Thread_team(number_of_threads)));
    CHECK(found.size == expected.size);
    CHECK(found.vertex == expected.vertex);
    CHECK(found.number_of_checks == expected.number_of_checks);
  }
}

void wrong_bounds_are_found()
{
  test_support::Scope scope("bounds");
  for(const Indexed_mesh& indexed : {icosphere(1), saddle_patch(6), genus_2_polycube()})
  {
    test_support::Scope mesh_scope(indexed.name);
    Witness witness(indexed);
    CHECK(witness.violation() < 1e-14);
    threads_find_the_same(witness);
    for(SMGI::Vertex_id v = 1; v < witness.mesh.number_of_vertices(); ++v)
    {
      const double right = witness.field.distance[v];
      witness.field.distance[v] = right * (1 + 1e-9);
      CHECK(witness.violation() > 1e-11);
      if(v % 16 == 0)
        threads_find_the_same(witness);
      witness.field.distance[v] = right;
    }
  }
}

double value_at(const std::vector<SMGI::Distance_piece<double>>& pieces, double t)
{
  for(const SMGI::Distance_piece<double>& p : pieces)
    if(t <= p.end)
      return p.at(t);
  return pieces.back().at(t);
}

// Paths go on along the edge from both ends of an interval that is much nearer than what is beside it.
void paths_go_on_from_the_ends_of_an_interval()
{
  SMGI::Edge_distance_function<double> function;
  function.restart(1.);
  function.add({0., 1., 0., 0., 10.}); // from the begin of the edge
  function.add({.4, .6, .5, .1, 1.});
  const double at_end = 1 + std::hypot(.1, .1);
  for(const double t : {.1, .3, .7, .9})
    CHECK_NEAR(value_at(function.pieces(), t), at_end + std::abs(t - .5) - .1, 1e-15);
  function.add({.2, .3, .25, 0., 5.}); // nowhere nearer
  CHECK_EQUAL(function.pieces().size(), 3u);
}

// Returns the largest excess of the function over the condition of the proof, by samples on the border of each face.
double sampled_violation(const Witness& witness, test_support::Random& random)
{
  SMGI::Lower_bound_function<double> function(witness.mesh, witness.field.distance, witness.windows);
  function.make(SMGI::Chunk_team<SMGI::Calling_thread>(), [] { return true; });
  double worst = 0;
  for(SMGI::Face_id f = 0; f < witness.mesh.number_of_faces(); ++f)
  {
    const auto corner = SMGI::layout_of_face(witness.mesh.face(f));
    const double size = SMGI::longest_side(witness.mesh.face(f));
    std::array<std::vector<SMGI::Distance_piece<double>>, 3> on_side;
    for(unsigned int k = 0; k < 3; ++k)
      function.read(SMGI::halfedge_of(f, k), false, on_side[k]);
    for(std::size_t i = 0; i < 200; ++i)
    {
      std::array<SMGI::Planar_point<double>, 2> point{};
      std::array<double, 2> value{};
      for(std::size_t j = 0; j < 2; ++j)
      {
        const unsigned int k = static_cast<unsigned int>(random.index(3));
        const SMGI::Planar_point<double> a = corner[k], b = corner[(k + 1) % 3];
        const double t = random.uniform(0., 1.);
        point[j] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        value[j] = value_at(on_side[k], t * witness.mesh.length(SMGI::halfedge_of(f, k)));
      }
      const double way = std::hypot(point[0].x - point[1].x, point[0].y - point[1].y);
      worst = (std::max)(worst, (value[0] - value[1] - way) / (value[0] + size));
    }
  }
  return worst;
}

// Whatever is wrong with the values, no sample violates the condition by more than twice what the check has found.
void no_sample_exceeds_the_violation()
{
  test_support::Scope scope("samples");
  test_support::Random random(20261129);
  for(const Indexed_mesh& indexed : {icosphere(2), saddle_patch(8), noisy_sphere(2, .2, 3), prism_tube(8, 6, 1., 2.)})
  {
    test_support::Scope mesh_scope(indexed.name);
    std::size_t number_found = 0;
    for(std::size_t i = 0; i < 24; ++i)
    {
      Witness witness(indexed);
      const std::size_t n = witness.mesh.number_of_vertices();
      for(std::size_t k = random.index(4); k-- > 0;)
        witness.field.distance[random.index(n)] *= 1 + random.uniform(-1., 1.) / (i % 2 == 0 ? 4 : 64);
      const double found = witness.violation(), sampled = sampled_violation(witness, random);
      CHECK(sampled <= 2 * found + 1e-14);
      number_found += sampled > 1e-3 ? 1 : 0;
    }
    CHECK(number_found > 4);
  }
}

void missing_windows_are_found()
{
  test_support::Scope scope("windows");
  const Indexed_mesh indexed = icosphere(2);
  const Witness witness(indexed);
  std::size_t number_of_vertices = 0;
  for(SMGI::Vertex_id v = 0; v < witness.mesh.number_of_vertices(); ++v)
  {
    // Nearer to the source, the paths to the points around v are straight from the source and its neighbors.
    if(witness.field.distance[v] * witness.mesh.unit() < 1.2)
    {
      continue;
    }
    CHECK(Witness(indexed, v).violation() > 1e-6);
    ++number_of_vertices;
  }
  CHECK(number_of_vertices > 50);
}

// Shortest paths to the points of AB near A come from the source at D and cross CA. Those to the points near B come
// from the source at B, and so do all paths through BC. If the windows behind CA are missing, that shows only on AB,
// from CA, which is the edge before AB or, in the mirror image, the edge after it.
void windows_missing_on_either_side_are_found()
{
  test_support::Scope scope("both sides");
  for(const bool is_mirrored : {false, true})
  {
    const double x = is_mirrored ? -1. : 1.;
    Indexed_mesh mesh;
    // D A C B E
    mesh.points = {{-0.15 * x, 0.25, 0.}, {0., 0., 0.}, {0.5 * x, 0.9, 0.}, {x, 0., 0.}, {1.5 * x, 0.8, 0.}};
    mesh.faces = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}};
    for(Triangle& t : mesh.faces)
    {
      if(is_mirrored)
      {
        std::swap(t[1], t[2]);
      }
    }
    const Witness names(mesh);
    const SMGI::Vertex_id b = names.id(3), d = names.id(0);
    CHECK(Witness(mesh, SMGI::null_id, SMGI::null_id, {b, d}).violation() < 1e-14);
    CHECK(Witness(mesh, b, d, {b, d}).violation() > 0.01);
  }
}

// A point of a path is missing, or moved along its edge, or moved beyond the end of its edge.
void changed_points_are_found(const Witness& witness, const SMGI::Distance_checks<double>& checks,
                              const SMGI::Path_steps<double>& path, std::size_t i, double length)
{
  SMGI::Path_steps<double> shortcut = path;
  shortcut.erase(shortcut.begin() + static_cast<std::ptrdiff_t>(i));
  CHECK(!(checks.length_to_source(shortcut) < length * (1 - 1e-14)));
  SMGI::Path_steps<double> moved = path;
  moved[i].x = witness.mesh.length(moved[i].halfedge) * (moved[i].x > 0.1 ? 0.01 : 0.9);
  CHECK(checks.length_to_source(moved) > length * (1 + 1e-9));
  moved[i].x = witness.mesh.length(moved[i].halfedge) * 1.5;
  CHECK(checks.length_to_source(moved) == infinity);
}

void paths_are_measured()
{
  test_support::Scope scope("paths");
  const Witness witness(torus(2., 1., 12, 8));
  SMGI::Distance_checks<double> checks(witness.mesh, witness.field.distance);
  checks.add_source(0, 0.);
  const SMGI::Path_tracer<double> tracer(witness.mesh, witness.field);
  std::size_t number_with_edges = 0;
  for(SMGI::Vertex_id v = 0; v < witness.mesh.number_of_vertices(); ++v)
  {
    SMGI::Path_steps<double> path;
    CHECK(tracer.trace_from_vertex(v, path));
    const double length = checks.length_to_source(path);
    CHECK_CLOSE(length, witness.field.distance[v], 1e-14);

    // A path that does not end at a source.
    const SMGI::Path_steps<double> cut_off(path.begin(), path.end() - 1);
    CHECK(checks.length_to_source(cut_off) == infinity);
    // A path through wrong faces.
    SMGI::Path_steps<double> elsewhere = path;
    for(auto& step : elsewhere)
    {
      step.face = (step.face + 48) % static_cast<SMGI::Face_id>(witness.mesh.number_of_faces());
    }
    CHECK(path.size() == 1 || checks.length_to_source(elsewhere) == infinity);
    for(std::size_t i = 1; i + 1 < path.size(); ++i)
    {
      if(path[i].vertex == SMGI::null_id)
      {
        ++number_with_edges;
        changed_points_are_found(witness, checks, path, i, length);
      }
    }
  }
  CHECK(number_with_edges > 50);
}

} // namespace

int main()
{
  wrong_bounds_are_found();
  paths_go_on_from_the_ends_of_an_interval();
  no_sample_exceeds_the_violation();
  missing_windows_are_found();
  windows_missing_on_either_side_are_found();
  paths_are_measured();
  return test_result();
}
