#include "Reachability.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace geodesics_demo {

std::size_t number_of_components(const Mesh& mesh)
{
  std::size_t result = 0;
  std::vector<bool> is_visited(mesh.number_of_faces(), false);
  std::vector<Face> stack;
  const auto visit = [&](Face f)
  {
    if(f == Mesh::null_face() || is_visited[f])
      return false;
    is_visited[f] = true;
    stack.push_back(f);
    return true;
  };
  for(const Face first : mesh.faces())
  {
    result += visit(first) ? 1 : 0;
    while(!stack.empty())
    {
      const Mesh::Halfedge_index h = mesh.halfedge(stack.back());
      stack.pop_back();
      for(const Mesh::Halfedge_index side : {h, mesh.next(h), mesh.prev(h)})
        visit(mesh.face(mesh.opposite(side)));
    }
  }
  return result;
}

std::string reason_for_unreached(const Mesh& mesh, bool has_obstacles)
{
  std::size_t isolated = 0;
  for(const Vertex v : mesh.vertices())
    isolated += mesh.is_isolated(v) ? 1 : 0;
  const std::size_t components = number_of_components(mesh);
  std::string text = "; the mesh has " + std::to_string(components) + (components == 1 ? " component" : " components");
  if(isolated > 0)
    text += " and " + counted_vertices(isolated) + " without faces";
  if(has_obstacles)
    text += ", and paths avoid faces or edges";
  return text;
}

void remark_on_unreached(const Mesh& mesh, std::size_t number_of_vertices, bool has_obstacles,
                         const Console& console)
{
  if(number_of_vertices > 0)
    console.note(std::to_string(number_of_vertices) + " of " + counted_vertices(mesh.number_of_vertices())
                 + (number_of_vertices == 1 ? " is" : " are") + " not reached"
                 + reason_for_unreached(mesh, has_obstacles));
}

void remark_on_unreached(const Mesh& mesh, const Distance_field& field, bool has_obstacles, const Console& console)
{
  remark_on_unreached(mesh,
                      static_cast<std::size_t>(std::count_if(field.distance.begin(), field.distance.end(),
                                                             [](double d) { return !std::isfinite(d); })),
                      has_obstacles, console);
}

} // namespace geodesics_demo
