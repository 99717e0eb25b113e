// How much work is a list of one, two, three, ... windows? Most lists of a scan are that short. A propagation from
// vertex 0 collects the lists that it propagates; of those with the wanted number of windows, some are taken in equal
// steps. Each of them crosses its face as in the visit of a vertex (Star_propagation.h): it is pruned, its nearest
// window is found, the lists on the two other edges get room, the list is split, and they get the children.
//
// Prints one line per mesh: the number of windows, how many lists have it, and how many of them have crossed a face.
// valgrind counts the instructions of cross_face() only (count_list_instructions.sh).
//
// The rivals are the final distances of the corners. In a visit, the distance of the apex is often not known yet, so a
// few more children are removed here.

#include "benchmark_surface.h"
#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>

#include <cstdint>
#include <vector>

namespace {

namespace geodesics = CGAL::Surface_mesh_geodesics::internal;

using Mesh = geodesics::Intrinsic_mesh<double>;
using Field = geodesics::Vertex_distance_field<double>;
using List = geodesics::Window_list<double>;
using Pool = geodesics::Window_pool<double>;
using Crossing = geodesics::Window_list_crossing<double, geodesics::All_pruning_rules>;

// A list that has been propagated, and the halfedge across which it has entered a face.
struct Propagated_list
{
  geodesics::Halfedge_id halfedge;
  std::vector<geodesics::Window<double>> windows;
  std::uint32_t steps;
};

// Collects the lists with a number of windows.
struct Collector : geodesics::No_window_keeper
{
  std::size_t number_of_windows;
  std::vector<Propagated_list>* lists;

  Collector(std::size_t n, std::vector<Propagated_list>& l) : number_of_windows(n), lists(&l) {}

  void keep(geodesics::Halfedge_id h, const List& list) const
  {
    if(list.size != number_of_windows)
      return;
    lists->push_back({h, {}, list.steps});
    for(std::size_t i = 0; i < list.size; ++i)
      lists->back().windows.push_back(list.columns.get(i));
  }
};

std::vector<Propagated_list> lists_of(const Benchmark_surface& surface, geodesics::Vertex_id source, std::size_t n,
                                      Field& field)
{
  std::vector<Propagated_list> lists;
  geodesics::Distance_propagation<double, geodesics::All_pruning_rules, Collector> propagation(
    surface.mesh(), field, Collector(n, lists));
  propagation.add_source(source, 0.);
  propagation.run([](std::size_t, double) { return true; });
  return lists;
}

// What one list needs to cross its face.
struct Face_crossing
{
  Pool& pool;
  Crossing& crossing;
  geodesics::Face_frame<double> frame;
  geodesics::Corner_rivals<double> corners;
  List list, left, right;
};

List room(Pool& pool, List& list, std::size_t n)
{
  pool.reserve(list, n);
  return list;
}

// Is not inlined: valgrind finds it by its name.
__attribute__((noinline)) void cross_face(Face_crossing& f)
{
  f.crossing.prune(f.list, f.frame, f.corners);
  if(f.list.size > 0)
  {
    const Crossing::Apex_path path = f.crossing.find_apex_path(f.list, f.frame);
    f.crossing.split(f.list, f.frame, f.corners, path, room(f.pool, f.left, f.list.size),
                     room(f.pool, f.right, f.list.size));
    f.pool.add(f.left, f.crossing.left().size, f.crossing.left().steps);
    f.pool.add(f.right, f.crossing.right().size, f.crossing.right().steps);
  }
  f.pool.release(f.list);
}

// Lets a list cross its face. Lists behind which the mesh ends do not cross it, as there is no edge to leave across.
bool cross(const Mesh& mesh, const Field& field, Crossing& crossing, Pool& pool, const Propagated_list& l)
{
  const geodesics::Face_frame<double> c = mesh.face_frame(l.halfedge);
  if(c.left == geodesics::null_id || c.right == geodesics::null_id)
    return false;
  const auto rival = [&](geodesics::Halfedge_id h) {
    return geodesics::Vertex_rival<double>(field.distance[mesh.source(h)], false);
  };
  const geodesics::Halfedge_id next = geodesics::next_halfedge(l.halfedge);
  Face_crossing f{pool, crossing, c,
                  {rival(l.halfedge), rival(next), rival(geodesics::next_halfedge(next))}, List(), List(), List()};
  pool.reserve(f.list, l.windows.size());
  for(std::size_t i = 0; i < l.windows.size(); ++i)
    f.list.columns.set(i, l.windows[i]);
  f.list.size = static_cast<std::uint32_t>(l.windows.size());
  f.list.steps = l.steps;
  cross_face(f);
  pool.release(f.left);
  pool.release(f.right);
  return true;
}

void print_row(const std::string& file, const Benchmark_mesh& mesh, std::size_t number_of_windows, std::size_t most)
{
  const Benchmark_surface surface = surface_of(mesh);
  Field field;
  const std::vector<Propagated_list> lists
    = lists_of(surface, surface.id(*mesh.vertices().begin()), number_of_windows, field);
  CGAL::Surface_mesh_geodesics::Propagation_statistics statistics;
  Crossing crossing(surface.mesh(), field.distance, statistics);
  Pool pool;
  std::size_t number_crossed = 0;
  const std::size_t step = (std::max)(std::size_t(1), lists.size() / most);
  for(std::size_t i = 0; i < lists.size(); i += step)
    number_crossed += cross(surface.mesh(), field, crossing, pool, lists[i]) ? 1 : 0;
  std::cout << file_name(file) << ',' << mesh.number_of_faces() << ',' << number_of_windows << ',' << lists.size()
            << ',' << number_crossed << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  std::size_t windows = 2, most = 10000;
  if(!read_settings(argc, argv, settings, [&](const std::string& option, const std::string& value) {
       return read_number_option(option, value, "--windows", windows)
              || read_number_option(option, value, "--lists", most);
     }))
  {
    return usage(argv[0], " mesh...\n"
                          "  --windows N           the number of windows of the lists (2)\n"
                          "  --lists N             about how many lists cross their faces (10000)");
  }
  return print_rows_by_level(settings, [&](const std::string& file, std::size_t, const Benchmark_mesh& mesh)
  { print_row(file, mesh, windows, most); });
}
