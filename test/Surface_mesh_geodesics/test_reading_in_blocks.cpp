// Several threads that read a mesh in blocks make the same intrinsic mesh and the same tables as one thread, in the
// same bits, and find the same fault. They share the reading of a Surface_mesh; the calling thread alone reads maps of
// the user.

#include "distance_test_helpers.h"
#include "intrinsic_mesh_helpers.h"
#include "mesh_operations.h"
#include "test_meshes.h"
#include "test_support.h"
#include "thread_team.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/Consecutive_elements.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/One_block.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Block_team.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh_builder.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/face_shape.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/mesh_invariants.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Quotient.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/named_params_helper.h>

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

// --- which maps are read in blocks -----------------------------------------------------------------------------------

template <typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
constexpr bool is_consecutive(const TriangleMesh&, const VertexIndexMap&, const FaceIndexMap&)
{
  return internal::Consecutive_elements<TriangleMesh, VertexIndexMap, FaceIndexMap>::is_possible;
}

template <typename TriangleMesh>
using Own_points = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type;

template <typename Kernel_>
constexpr bool has_shared_points
  = internal::Has_shared_points<CGAL::Surface_mesh<typename Kernel_::Point_3>,
                                Own_points<CGAL::Surface_mesh<typename Kernel_::Point_3>>>::value;

static_assert(has_shared_points<CGAL::Simple_cartesian<double>> && has_shared_points<CGAL::Simple_cartesian<float>>
                && has_shared_points<CGAL::Exact_predicates_inexact_constructions_kernel>,
              "points with built-in numbers");
static_assert(!has_shared_points<CGAL::Exact_predicates_exact_constructions_kernel>
                && !has_shared_points<CGAL::Simple_cartesian<CGAL::Quotient<CGAL::MP_Float>>>,
              "points with other numbers");
static_assert(!internal::Has_shared_points<Mesh, Map_of_user<Own_points<Mesh>>>::value, "points of the user");

struct Mesh_of_user : Mesh
{};

// The maps that the functions find, and those that are the defaults of classes.
void only_maps_of_the_mesh_are_read_in_blocks()
{
  Mesh tm;
  const Mesh_of_user derived;
  const auto np = CGAL::parameters::default_values();
  const auto own_vertices = get(boost::vertex_index, tm);
  const auto own_faces = get(boost::face_index, tm);
  const auto vertices_of_user = tm.add_property_map<vertex_descriptor, std::uint32_t>("v:index_of_user").first;
  CHECK(is_consecutive(tm, own_vertices, own_faces));
  CHECK(is_consecutive(tm, CGAL::get_initialized_vertex_index_map(tm, np),
                       CGAL::get_initialized_face_index_map(tm, np)));
  CHECK(!is_consecutive(tm, vertices_of_user, own_faces));
  CHECK(!is_consecutive(derived, own_vertices, own_faces));
  CHECK(!is_consecutive(CGAL::Face_filtered_graph<Mesh>(tm), own_vertices, own_faces));
}

// --- meshes ----------------------------------------------------------------------------------------------------------

// An intrinsic mesh, and what the tables between it and the user's mesh say.
struct Read_mesh
{
  Intrinsic mesh;
  std::vector<vertex_descriptor> vertices;  // of the vertices of the intrinsic mesh
  std::vector<internal::Vertex_id> ids;     // of the vertices of the user
  std::vector<face_descriptor> faces;       // of the faces of the intrinsic mesh
  std::vector<internal::Halfedge_id> first; // of the faces of the user; null_id if a face was left out

  friend bool operator==(const Read_mesh& a, const Read_mesh& b)
  {
    return is_same_mesh(a.mesh, b.mesh) && a.mesh.unit() == b.mesh.unit() && a.vertices == b.vertices
        && a.ids == b.ids && a.faces == b.faces && a.first == b.first;
  }
};

// Reads a mesh, or only what a source can reach.
template <typename Blocks_, typename VertexIndexMap, typename FaceIndexMap, typename VertexPointMap>
Read_mesh read(const Mesh& tm, const vertex_descriptor* source, const Blocks_& blocks, VertexIndexMap vim,
               FaceIndexMap fim, VertexPointMap vpm)
{
  using Surface = internal::Intrinsic_surface<double, Mesh, VertexIndexMap, FaceIndexMap>;
  const internal::Shape_from_points<double, Mesh, VertexPointMap> shape(tm, vpm);
  const Surface surface = source == nullptr ? Surface(tm, vim, fim, shape, blocks)
                                            : Surface(tm, vim, fim, shape, std::vector{*source}, blocks);
  Read_mesh result{surface.mesh(), {}, {}, {}, {}};
  for(internal::Vertex_id v = 0; v < surface.number_of_vertices(); ++v)
    result.vertices.push_back(surface.descriptor(v));
  for(const vertex_descriptor v : vertices(tm))
    result.ids.push_back(surface.id(v));
  for(internal::Face_id f = 0; f < surface.mesh().number_of_faces(); ++f)
    result.faces.push_back(surface.descriptor_of_face(f));
  for(const face_descriptor f : faces(tm))
    result.first.push_back(surface.first_halfedge(f));
  return result;
}

// Reads a mesh through its own maps, or some maps of the user instead.
enum Maps_of_user { NONE, INDICES, POINTS, ALL };

template <typename Blocks_>
Read_mesh read(const Mesh& tm, Maps_of_user maps, const Blocks_& blocks, const vertex_descriptor* source = nullptr)
{
  std::atomic<bool> is_read_elsewhere(false);
  const auto vim = get(boost::vertex_index, tm);
  const auto fim = get(boost::face_index, tm);
  const auto vpm = get(CGAL::vertex_point, tm);
  const auto user = [&](const auto& map) { return map_of_user(map, is_read_elsewhere); };
  const Read_mesh result = maps == NONE    ? read(tm, source, blocks, vim, fim, vpm)
                         : maps == INDICES ? read(tm, source, blocks, user(vim), user(fim), vpm)
                         : maps == POINTS  ? read(tm, source, blocks, vim, fim, user(vpm))
                                           : read(tm, source, blocks, user(vim), user(fim), user(vpm));
  CHECK(!is_read_elsewhere);
  return result;
}

void check_mesh(const Mesh& tm, const vertex_descriptor* source = nullptr)
{
  const Read_mesh expected = read(tm, ALL, internal::One_block(), source);
  CHECK(internal::are_invariants_kept(expected.mesh));
  for(const Maps_of_user maps : {NONE, INDICES, POINTS})
  {
    CHECK(read(tm, maps, internal::One_block(), source) == expected);
  }
  for(const Maps_of_user maps : {NONE, INDICES, POINTS, ALL})
  {
    for(const std::size_t threads : numbers_of_threads)
    {
      CHECK(read(tm, maps, blocks_of(threads), source) == expected);
    }
  }
}

void meshes_are_the_same(test_support::Random& random)
{
  test_support::Scope scope("meshes");
  check_mesh(to_face_graph(icosphere(1)));
  check_mesh(to_face_graph(noisy_sphere(5, .1, 3)));
  check_mesh(to_face_graph(rough_terrain(80, .3, 5)));
  check_mesh(to_face_graph(saddle_fan(5000))); // all faces around one vertex
  check_mesh(Mesh());
  Mesh vertices_alone;
  for(int i = 0; i < 5000; ++i)
  {
    vertices_alone.add_vertex(Mesh::Point(i, 0, 0));
  }
  check_mesh(vertices_alone);
  Mesh without_area = to_face_graph(icosphere(4)); // all its faces are degenerate
  for(const vertex_descriptor v : vertices(without_area))
  {
    without_area.point(v) = Mesh::Point(without_area.point(v).x(), 0, 0);
  }
  check_mesh(without_area);
  for(int i = 0; i < 4; ++i)
  {
    // Borders, pinched and isolated vertices, many components.
    check_mesh(to_face_graph(without_faces(i % 2 == 0 ? noisy_sphere(5, .1, 7) : wavy_tube(60, 60), "with holes",
                                           [&](std::size_t) { return random.uniform(0., 1.) < .2 * (i + 1); })));
    const Mesh tm = to_face_graph(without_faces(noisy_sphere(5, .1, 8), "in pieces",
                                                [&](std::size_t) { return random.uniform(0., 1.) < .5; }));
    const vertex_descriptor source(static_cast<std::uint32_t>(random.index(num_vertices(tm)))); // also an isolated one
    check_mesh(tm, &source);
  }
}

// Removed elements leave gaps in the indices, and new ones may fill them.
void removed_elements_are_left_out(test_support::Random& random)
{
  test_support::Scope scope("removed elements");
  Mesh tm = to_face_graph(noisy_sphere(5, .1, 9));
  const vertex_descriptor alone = tm.add_vertex(Mesh::Point(1, 2, 3));
  tm.remove_vertex(alone); // nothing else is missing
  CHECK(tm.has_garbage());
  check_mesh(tm);
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
  CHECK(tm.number_of_removed_vertices() > 1 && tm.number_of_removed_faces() == removed);
  check_mesh(tm);
  CHECK_EQUAL(intrinsic_mesh(tm).number_of_faces(), all.size() - removed);
  Mesh collected = tm;
  collected.collect_garbage();
  check_mesh(collected);
  CHECK_EQUAL(intrinsic_mesh(collected).number_of_faces(), all.size() - removed);
  const auto added = [&](double x) { return tm.add_vertex(Mesh::Point(x, 5, 5)); };
  tm.add_face(added(0), added(1), added(.5)); // of elements that had been removed
  check_mesh(tm);
}

template <typename Function>
std::string fault_of(const Function& function)
{
  try
  {
    function();
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
  const std::string expected = fault_of([&]() { read(tm, ALL, internal::One_block()); });
  CHECK(expected != "none");
  for(const Maps_of_user maps : {NONE, INDICES, POINTS})
  {
    CHECK_EQUAL(fault_of([&]() { read(tm, maps, internal::One_block()); }), expected);
  }
  for(const Maps_of_user maps : {NONE, INDICES, POINTS, ALL})
  {
    for(const std::size_t threads : numbers_of_threads)
    {
      CHECK_EQUAL(fault_of([&]() { read(tm, maps, blocks_of(threads)); }), expected);
    }
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
      const vertex_descriptor v = random_vertex(tm, random);
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
  for(const std::uint32_t index : {0u, 1000000000u}) // an index that another corner has, and one of no vertex
  {
    Mesh tm = valid;
    for(int k = 0; k < 3; ++k)
    {
      const auto f = face_descriptor(static_cast<std::uint32_t>(random.index(num_faces(tm))));
      const auto h = halfedge(f, tm);
      tm.set_target(h, index == 0 ? tm.target(tm.next(h)) : vertex_descriptor(index));
    }
    check_fault(tm);
  }
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
  only_maps_of_the_mesh_are_read_in_blocks();
  each_number_belongs_to_one_block();
  exception_of_the_first_block_is_thrown();
  meshes_are_the_same(random);
  removed_elements_are_left_out(random);
  faults_of_meshes_are_the_same(random);
  umbrellas_are_the_same();
  faults_are_the_same(random);
  return test_result();
}
