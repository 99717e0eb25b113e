// Windows and strips kept for faces stay until they are released, windows in the order in which they were added. Their
// memory is reused.

#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/window/Face_windows.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using internal::Halfedge_id;
using internal::Vertex_id;
using Window = internal::Kept_window<double>;
using Windows = internal::Face_windows<double>;

Window window(Vertex_id root)
{
  return Window{root + .25, root + .5, -double(root), 2. * root, root};
}

std::vector<Vertex_id> roots(const Windows& windows, Halfedge_id h)
{
  std::vector<Vertex_id> result;
  windows.for_each_window(h, [&](const Window& w)
  {
    const Window expected = window(w.root);
    CHECK(w.begin == expected.begin && w.end == expected.end);
    CHECK(w.image_x == expected.image_x && w.image_depth == expected.image_depth);
    result.push_back(w.root);
  });
  return result;
}

// Adds lists of all lengths to the edges of some faces, and releases them, in random order.
void each_edge_keeps_its_windows(test_support::Random& random)
{
  const std::size_t number_of_faces = 5;
  Windows windows;
  windows.reset(number_of_faces);
  std::vector<std::vector<Vertex_id>> expected(3 * number_of_faces);
  Vertex_id next = 1;
  std::size_t size = 0, largest = 0, memory = 0;
  for(int round = 0; round < 20000; ++round)
  {
    const std::size_t k = random.index(expected.size());
    const Halfedge_id h = internal::halfedge_of(static_cast<internal::Face_id>(k / 3), static_cast<unsigned>(k % 3));
    if(expected[k].size() > 20 || random.index(4) == 0)
    {
      windows.release(h);
      size -= expected[k].size();
      expected[k].clear();
    }
    else
    {
      const std::size_t n = random.index(9);
      windows.add(h, n, [&](std::size_t i) { return window(static_cast<Vertex_id>(next + i)); });
      for(std::size_t i = 0; i < n; ++i)
        expected[k].push_back(next++);
      size += n;
      largest = (std::max)(largest, size);
    }
    CHECK(roots(windows, h) == expected[k]);
    CHECK_EQUAL(windows.size(), size);
    CHECK_EQUAL(windows.maximum_size(), largest);
    if(round == 1000)
      memory = windows.memory();
  }
  CHECK(windows.memory() <= 2 * memory); // released memory is reused
}

void a_new_or_reset_container_is_empty()
{
  Windows windows;
  windows.reset(1);
  const Halfedge_id h = internal::halfedge_of(0, 1);
  CHECK(roots(windows, h).empty());
  windows.release(h);
  windows.add(h, 0, [](std::size_t) { return window(1); });
  CHECK(roots(windows, h).empty());
  windows.add(h, window(3));
  CHECK(roots(windows, h) == std::vector<Vertex_id>{3});
  windows.reset(1);
  CHECK(roots(windows, h).empty());
  CHECK_EQUAL(windows.maximum_size(), std::size_t(0));
}

// The same for strips: each edge has its own, the latest first, and places of released ones are taken again.
void each_edge_keeps_its_strips(test_support::Random& random)
{
  using Strips = std::vector<std::uint32_t>; // known by their sides
  const std::size_t number_of_faces = 5;
  internal::Edge_strip_field<double> field;
  field.release(internal::halfedge_of(0, 0)); // does nothing before reset()
  field.reset(number_of_faces);
  std::vector<Strips> expected(3 * number_of_faces);
  std::uint32_t next = 1;
  std::size_t size = 0, largest = 0;
  for(int round = 0; round < 20000; ++round)
  {
    const std::size_t k = random.index(expected.size());
    const Halfedge_id h = internal::halfedge_of(static_cast<internal::Face_id>(k / 3), static_cast<unsigned>(k % 3));
    if(expected[k].size() > 20 || random.index(8) == 0)
    {
      field.release(h);
      size -= expected[k].size();
      expected[k].clear();
    }
    else
    {
      const double x = next;
      field.keep(h, internal::Strip<double>{x, x + .5, .6, .8, 2 * x, -x, next, 3});
      expected[k].insert(expected[k].begin(), next++);
      largest = (std::max)(largest, ++size);
    }
    Strips found;
    field.for_each_strip(h, [&](const internal::Strip<double>& s)
    {
      CHECK(s.begin == s.side && s.distance == 2. * s.side && s.foot == -double(s.side) && s.faces_crossed == 3);
      found.push_back(s.side);
    });
    CHECK(found == expected[k]);
    CHECK_EQUAL(field.size(), largest);
  }
  field.clear();
  CHECK_EQUAL(field.size(), std::size_t(0));
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(7));
  each_edge_keeps_its_windows(random);
  a_new_or_reset_container_is_empty();
  each_edge_keeps_its_strips(random);
  return test_result();
}
