// The invariants of intrinsic meshes hold after construction, after each insertion of a source, and after the insertion
// is undone, which restores every bit. The checks of the invariants find faults.

#include "distance_test_helpers.h"
#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/mesh_invariants.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/equal_sources.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;

// A face of doubles fills a cache line.
static_assert(sizeof(internal::Intrinsic_face<double>) == 64 && alignof(internal::Intrinsic_face<double>) == 64);

using Intrinsic = internal::Intrinsic_mesh<double>;
using Insertion = internal::Source_insertion<double>;

// Coordinates inside a face, on an edge or at a corner.
std::array<double, 3> random_coordinates(test_support::Random& random)
{
  std::array<double, 3> b{random.uniform(.1, 1.), random.uniform(.1, 1.), random.uniform(.1, 1.)};
  for(std::size_t number_of_zeros = random.index(3); number_of_zeros > 0; --number_of_zeros)
  {
    b[(random.index(2) + number_of_zeros) % 3] = 0.;
  }
  const double sum = b[0] + b[1] + b[2];
  return {b[0] / sum, b[1] / sum, b[2] / sum};
}

void insertions_keep_the_invariants_and_can_be_undone(const Mesh& tm, test_support::Random& random)
{
  const Intrinsic before = intrinsic_mesh(tm);
  CHECK(internal::are_invariants_kept(before));
  Intrinsic mesh = before;
  Insertion insertion(mesh);
  for(int run = 0; run < 2; ++run)
  {
    const auto crowded = static_cast<internal::Face_id>(random.index(before.number_of_faces()));
    for(int i = 0; i < 20; ++i)
    {
      const auto any = static_cast<internal::Face_id>(random.index(before.number_of_faces()));
      insertion.insert(i % 2 == 0 ? crowded : any, random_coordinates(random));
      CHECK(internal::are_invariants_kept(mesh));
    }
    insertion.undo();
    CHECK(is_same_mesh(mesh, before));
  }
}

void equal_points_are_one_vertex(const Mesh& tm, test_support::Random& random)
{
  Intrinsic mesh = intrinsic_mesh(tm);
  Insertion insertion(mesh);
  const std::array<double, 3> b = random_coordinates(random);
  const internal::Vertex_id v = insertion.insert(0, b);
  const std::size_t number_of_faces = mesh.number_of_faces();
  CHECK_EQUAL(insertion.insert(0, b), v);
  CHECK_EQUAL(mesh.number_of_faces(), number_of_faces);
}

// Changes one thing of a valid mesh, and checks that the fault is found.
template <class Change>
void fault_is_found(const Mesh& tm, Change change)
{
  Intrinsic mesh = intrinsic_mesh(tm);
  change(mesh);
  CHECK(!internal::are_invariants_kept(mesh));
}

void the_checks_find_faults()
{
  test_support::Scope scope("faults");
  const Mesh tm = to_face_graph(icosphere(1));
  fault_is_found(tm, [](Intrinsic& mesh) { mesh.face(3).apex_y = -1.; });
  fault_is_found(tm, [](Intrinsic& mesh) { mesh.face(3).length[0] = 2. * mesh.face(3).length[1]; });
  fault_is_found(tm, [](Intrinsic& mesh) { mesh.face(3).length[2] *= 1. + 1e-15; });
  fault_is_found(tm, [](Intrinsic& mesh) { mesh.face(3).opposite[1] = internal::null_id; });
  fault_is_found(tm, [](Intrinsic& mesh) { std::swap(mesh.face(3).opposite[0], mesh.face(3).opposite[1]); });
  fault_is_found(tm, [](Intrinsic& mesh) { std::swap(mesh.face(3).vertex[0], mesh.face(3).vertex[1]); });
  fault_is_found(tm, [](Intrinsic& mesh)
                 { mesh.set_halfedge(mesh.face(3).vertex[0], internal::halfedge_of(3, 1)); });
  fault_is_found(tm, [](Intrinsic& mesh) { mesh.set_kind(0, Intrinsic::DEGENERATE); });
  fault_is_found(tm, [](Intrinsic& mesh) { mesh.set_kind(0, Intrinsic::PINCHED); });
}

// Two vertices with an edge whose length vanishes in rounding. Of the sources at one of them, the nearest decides.
void least_offset_of_a_vertex_decides_about_equal_sources()
{
  test_support::Scope scope("equal sources");
  Mesh tm = to_face_graph(icosphere(1));
  tm.point(tm.source(tm.halfedge(vertex(0)))) = tm.point(vertex(0));
  const Intrinsic mesh = intrinsic_mesh(tm);
  internal::Halfedge_id shortest = 0;
  for(internal::Face_id f = 0; f < mesh.number_of_faces(); ++f)
    for(unsigned int k = 0; k < 3; ++k)
      if(mesh.length(internal::halfedge_of(f, k)) < mesh.length(shortest))
        shortest = internal::halfedge_of(f, k);
  const internal::Vertex_id u = mesh.source(shortest), v = mesh.target(shortest);
  using Ties = std::vector<std::pair<internal::Vertex_id, internal::Vertex_id>>;
  const auto ties = [&](const std::vector<internal::Vertex_id>& vertices, const std::vector<double>& offsets)
  {
    Ties result;
    internal::for_each_equal_source(mesh, vertices, offsets, [&](internal::Vertex_id from, internal::Vertex_id to)
                                    { result.emplace_back(from, to); });
    return result;
  };
  CHECK((ties({u, v}, {0., 0.}) == Ties{{v, u}}));
  CHECK((ties({v, u}, {0., 0.}) == Ties{{u, v}}));
  CHECK(ties({u, v}, {0., .5}).empty());
  CHECK((ties({u, u, v}, {.5, 0., 0.}) == Ties{{v, u}}));
  CHECK((ties({u, v, u}, {.5, 0., 0.}) == Ties{{v, u}}));
  CHECK((ties({v, u, v, u}, {.5, .25, .25, .75}) == Ties{{u, v}}));
  CHECK(ties({u, u, v}, {.5, 0., .5}).empty());
}

// A table in large pages is a table like others, and the caller's error number stays. A table with elements is not
// moved.
void large_tables_are_reserved()
{
  for(const std::size_t n : {std::size_t(0), std::size_t(1), std::size_t(1000000), std::size_t(5000000)})
  {
    std::vector<int> table;
    errno = 7;
    internal::reserve_large(table, n);
    CHECK_EQUAL(errno, 7);
    CHECK(table.capacity() >= n && table.empty());
    const int* const first = table.data();
    table.resize(n, 3);
    CHECK(table.data() == first && std::count(table.begin(), table.end(), 3) == static_cast<std::ptrdiff_t>(n));
    internal::reserve_large(table, 2 * n + 1);
    CHECK(n == 0 || table.data() == first);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260107);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : meshes_of_many_kinds(seed))
  {
    test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    insertions_keep_the_invariants_and_can_be_undone(tm, random);
    equal_points_are_one_vertex(tm, random);
  }
  the_checks_find_faults();
  large_tables_are_reserved();
  least_offset_of_a_vertex_decides_about_equal_sources();
  return test_result();
}
