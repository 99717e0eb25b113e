// Several threads that read a mesh in blocks make the same intrinsic mesh as one thread, in the same bits, and find the
// same fault. They share the reading of a Surface_mesh; maps of the user are read by the calling thread alone.

#include "intrinsic_mesh_helpers.h"
#include "mesh_operations.h"
#include "test_meshes.h"
#include "test_support.h"
#include "thread_team.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/One_block.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Block_team.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh_builder.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/face_shape.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/mesh_invariants.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace test_meshes;

namespace {

namespace SMG = CGAL::Surface_mesh_geodesics;
namespace internal = SMG::internal;
using Blocks = internal::Block_team<Thread_team>;
using Intrinsic = internal::Intrinsic_mesh<double>;
using Connected_faces = std::vector<internal::Connected_face>;

const std::array<std::size_t, 5> numbers_of_threads = {1, 2, 3, 7, 64};

Blocks blocks_of(std::size_t number_of_threads) { return Blocks(Thread_team(number_of_threads)); }

// --- loops in blocks -------------------------------------------------------------------------------------------------

void each_number_belongs_to_one_block()
{
  test_support::Scope scope("numbers");
  for(const std::size_t n : {0u, 1u, 1023u, 1024u, 2047u, 2048u, 100003u})
  {
    for(const std::size_t threads : numbers_of_threads)
    {
      std::vector<int> count(n, 0);
      blocks_of(threads)(n, [&](std::size_t first, std::size_t last)
      {
        for(std::size_t i = first; i < last; ++i)
        {
          ++count[i];
        }
      });
      CHECK(count == std::vector<int>(n, 1));
    }
  }
}

// Each block stops at its first fault.
void exception_of_the_first_block_is_thrown()
{
  test_support::Scope scope("exceptions");
  constexpr std::size_t n = 100000;
  for(const std::size_t threads : numbers_of_threads)
  {
    for(const std::size_t fault : {std::size_t(0), std::size_t(777), n / 2, n - 1})
    {
      std::string found = "none";
      try
      {
        blocks_of(threads)(n, [&](std::size_t first, std::size_t last)
        {
          for(std::size_t i = first; i < last; ++i)
          {
            if(i >= fault)
            {
              throw std::runtime_error(std::to_string(i));
            }
          }
        });
      }
      catch(const std::runtime_error& error)
      {
        found = error.what();
      }
      CHECK_EQUAL(found, std::to_string(fault));
    }
  }
}

// --- maps of the user ------------------------------------------------------------------------------------------------

// A map that returns what another one does, and notes whether another thread has ever read it.
template <typename Map>
struct Map_of_user
{
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = typename boost::property_traits<Map>::value_type;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  Map map;
  std::atomic<bool>* is_read_elsewhere;
  std::thread::id reader = std::this_thread::get_id();

  friend value_type get(const Map_of_user& m, const key_type& k)
  {
    if(std::this_thread::get_id() != m.reader)
    {
      *m.is_read_elsewhere = true;
    }
    return get(m.map, k);
  }
};

template <typename Map>
Map_of_user<Map> map_of_user(const Map& map, std::atomic<bool>& is_read_elsewhere)
{
  return {map, &is_read_elsewhere};
}

// Reads a mesh through maps of the user.
template <typename Blocks_>
Intrinsic mesh_through_maps(const Mesh& tm, const Blocks_& blocks)
{
  std::atomic<bool> is_read_elsewhere(false);
  const Intrinsic result = intrinsic_mesh(tm, blocks, map_of_user(get(boost::vertex_index, tm), is_read_elsewhere),
                                          map_of_user(get(boost::face_index, tm), is_read_elsewhere),
                                          map_of_user(get(CGAL::vertex_point, tm), is_read_elsewhere));
  CHECK(!is_read_elsewhere);
  return result;
}

// --- meshes ----------------------------------------------------------------------------------------------------------

void check_mesh(const Mesh& tm)
{
  const Intrinsic expected = intrinsic_mesh(tm);
  CHECK(internal::are_invariants_kept(expected));
  CHECK(is_same_mesh(mesh_through_maps(tm, internal::One_block()), expected));
  for(const std::size_t threads : numbers_of_threads)
  {
    CHECK(is_same_mesh(intrinsic_mesh(tm, blocks_of(threads)), expected));
    CHECK(is_same_mesh(mesh_through_maps(tm, blocks_of(threads)), expected));
  }
}

void meshes_are_the_same(test_support::Random& random)
{
  test_support::Scope scope("meshes");
  check_mesh(to_face_graph(icosphere(1)));
  check_mesh(to_face_graph(noisy_sphere(5, .1, 3)));
  check_mesh(to_face_graph(rough_terrain(80, .3, 5)));
  check_mesh(to_face_graph(saddle_fan(5000))); // all faces around one vertex
  for(int i = 0; i < 4; ++i)
  {
    // Borders, pinched and isolated vertices, many components.
    check_mesh(to_face_graph(without_faces(i % 2 == 0 ? noisy_sphere(5, .1, 7) : wavy_tube(60, 60), "with holes",
                                           [&](std::size_t) { return random.uniform(0., 1.) < .2 * (i + 1); })));
  }
}

// Removed elements leave gaps in the indices.
void removed_elements_are_left_out(test_support::Random& random)
{
  test_support::Scope scope("removed elements");
  Mesh tm = to_face_graph(noisy_sphere(5, .1, 9));
  const std::vector<face_descriptor> all(faces(tm).begin(), faces(tm).end());
  std::size_t removed = 0;
  for(const face_descriptor f : all)
  {
    if(random.uniform(0., 1.) < .3)
    {
      CGAL::Euler::remove_face(halfedge(f, tm), tm);
      ++removed;
    }
  }
  CHECK(tm.number_of_removed_vertices() > 0 && tm.number_of_removed_faces() == removed);
  check_mesh(tm);
  CHECK_EQUAL(intrinsic_mesh(tm).number_of_faces(), all.size() - removed);
  tm.collect_garbage();
  check_mesh(tm);
  CHECK_EQUAL(intrinsic_mesh(tm).number_of_faces(), all.size() - removed);
}

template <typename Read>
std::string fault_of(const Read& read)
{
  try
  {
    read();
  }
  catch(const SMG::Invalid_geodesic_input& fault)
  {
    return fault.what() + std::to_string(fault.element());
  }
  return "none";
}

// One of several faults is found: the same by any number of threads and through any maps.
void check_fault(const Mesh& tm)
{
  const std::string expected = fault_of([&]() { mesh_through_maps(tm, internal::One_block()); });
  CHECK(expected != "none");
  CHECK_EQUAL(fault_of([&]() { intrinsic_mesh(tm); }), expected);
  for(const std::size_t threads : numbers_of_threads)
  {
    CHECK_EQUAL(fault_of([&]() { intrinsic_mesh(tm, blocks_of(threads)); }), expected);
    CHECK_EQUAL(fault_of([&]() { mesh_through_maps(tm, blocks_of(threads)); }), expected);
  }
}

void faults_of_meshes_are_the_same(test_support::Random& random)
{
  test_support::Scope scope("faults of meshes");
  const Mesh valid = to_face_graph(noisy_sphere(5, .1, 11));
  for(const double number : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300})
  {
    Mesh tm = valid;
    for(int k = 0; k < 3; ++k)
    {
      const auto v = vertex_descriptor(static_cast<std::uint32_t>(random.index(num_vertices(tm))));
      tm.point(v) = Mesh::Point(tm.point(v).x(), number, 0);
    }
    check_fault(tm);
  }
  Mesh with_quads = valid;
  for(int k = 0; k < 3; ++k)
  {
    const auto h = halfedge(*std::next(edges(with_quads).begin(),
                                       static_cast<std::ptrdiff_t>(random.index(num_edges(with_quads)))), with_quads);
    CGAL::Euler::join_face(h, with_quads);
  }
  check_fault(with_quads);
  with_quads.collect_garbage();
  check_fault(with_quads);
}

// --- the builder -----------------------------------------------------------------------------------------------------

// Two spheres that share every seventh vertex: those have two closed umbrellas.
Connected_faces touching_spheres()
{
  const Mesh tm = to_face_graph(icosphere(5));
  const auto n = static_cast<std::uint32_t>(num_vertices(tm)), m = static_cast<std::uint32_t>(num_faces(tm));
  Connected_faces result;
  for(const std::uint32_t sphere : {0u, 1u})
  {
    for(const face_descriptor f : faces(tm))
    {
      internal::Connected_face face;
      auto h = halfedge(f, tm);
      for(std::size_t j = 0; j < 3; ++j, h = next(h, tm))
      {
        const auto v = static_cast<std::uint32_t>(source(h, tm));
        face.corner[j] = v % 7 == 0 ? v : v + sphere * n;
        face.neighbor[j] = static_cast<std::uint32_t>(CGAL::face(opposite(h, tm), tm)) + sphere * m;
      }
      result.push_back(face);
    }
  }
  return result;
}

// Builds a mesh of faces that are all the same equilateral triangle.
template <typename Blocks_>
Intrinsic equilateral_mesh(const Connected_faces& faces, const Blocks_& blocks)
{
  Intrinsic mesh;
  internal::Intrinsic_mesh_builder<double> builder(faces);
  std::vector<internal::Vertex_id> vertex_of_index(3 * faces.size(), internal::null_id);
  const std::size_t n = builder.number_vertices(vertex_of_index);
  builder.set_faces([](std::uint32_t, const std::array<internal::Vertex_id, 3>&, internal::Intrinsic_face<double>& f)
                    { return internal::set_shape_from_lengths<double>({.5, .5, .5}, f); }, mesh, blocks);
  mesh.finish(n, blocks);
  return mesh;
}

void umbrellas_are_the_same()
{
  test_support::Scope scope("umbrellas");
  const Connected_faces faces = touching_spheres();
  const Intrinsic expected = equilateral_mesh(faces, internal::One_block());
  std::size_t number_pinched = 0;
  for(internal::Vertex_id v = 0; v < expected.number_of_vertices(); ++v)
  {
    number_pinched += expected.has(v, Intrinsic::PINCHED) ? 1 : 0;
  }
  CHECK(number_pinched > 1000);
  for(const std::size_t threads : numbers_of_threads)
  {
    CHECK(is_same_mesh(equilateral_mesh(faces, blocks_of(threads)), expected));
  }
}

// Faces that disagree with their neighbors.
void faults_are_the_same(test_support::Random& random)
{
  test_support::Scope scope("faults");
  for(int i = 0; i < 10; ++i)
  {
    Connected_faces faces = touching_spheres();
    for(int k = 0; k < 5; ++k)
    {
      const std::size_t f = random.index(faces.size());
      faces[f].neighbor[random.index(3)] = static_cast<std::uint32_t>(f);
    }
    const std::string expected = fault_of([&]() { equilateral_mesh(faces, internal::One_block()); });
    CHECK(expected != "none");
    for(const std::size_t threads : numbers_of_threads)
    {
      CHECK_EQUAL(fault_of([&]() { equilateral_mesh(faces, blocks_of(threads)); }), expected);
    }
  }
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20261123));
  each_number_belongs_to_one_block();
  exception_of_the_first_block_is_thrown();
  meshes_are_the_same(random);
  removed_elements_are_left_out(random);
  faults_of_meshes_are_the_same(random);
  umbrellas_are_the_same();
  faults_are_the_same(random);
  return test_result();
}
