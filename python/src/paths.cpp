// Shortest paths, isolines, and geodesics that are given by directions.

#include "Engines.h"

#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>
#include <CGAL/for_each.h>

#include <pybind11/stl.h>

#include <iterator>
#include <limits>
#include <string>

namespace geodesics_python {

Places::Places(const Mesh& mesh, const Place_arrays& arrays)
{
  const auto& [vertex, face, weights] = arrays;
  vertices = to_vertices(vertex);
  const auto id = vertex.unchecked<1>(), f = face.unchecked<1>();
  const auto b = weights.unchecked<2>();
  if(std::none_of(vertex.data(), vertex.data() + id.shape(0), [](std::int64_t v) { return v < 0; }))
    return;
  for(py::ssize_t i = 0; i < id.shape(0); ++i)
  {
    if(id(i) < 0)
      locations.emplace_back(Face(static_cast<Mesh::size_type>(f(i))), Barycentric{b(i, 0), b(i, 1), b(i, 2)});
    else
      locations.push_back(Paths::face_location(vertices[std::size_t(i)], mesh));
    if(locations.back().first == Mesh::null_face())
      throw std::invalid_argument("vertex " + std::to_string(id(i))
                                  + " has no face: it cannot stand beside points of faces");
  }
  vertices.clear();
}

// Paths from a set of sources.
struct Path_engine
{
  Path_engine(const Surface& surface, const Places& given) : sources(given), paths(surface.mesh())
  {
    paths.avoid_faces(surface.avoided_faces());
    if(surface.has_lengths())
      paths.use_edge_lengths(surface.lengths());
    sources.visit([&](const auto& range) { paths.add_source_points(range.begin(), range.end()); });
  }

  bool has_sources(const Places& given) const
  {
    return sources.vertices == given.vertices && sources.locations == given.locations;
  }

  const Places sources;
  Paths paths;
};

namespace {

struct Path
{
  double length = std::numeric_limits<double>::infinity();
  std::int64_t source = -1;
  Line line; // from the source to the target
};

// Collects the elements of a path, from the target to the source.
class Path_writer
{
public:
  Path_writer(const Surface& surface, const Paths& paths)
    : m_mesh(surface.mesh()), m_paths(paths), m_has_points(!surface.has_lengths())
  {}

  void operator()(Mesh::Halfedge_index h, double t) { add(m_paths.point(h, t), Paths::face_location(h, t, m_mesh)); }
  void operator()(Vertex v) { add(m_mesh.point(v), Paths::face_location(v, m_mesh)); }
  void operator()(Face f, const Barycentric& b) { add(m_paths.point(f, b), {f, b}); }

  // The line from the source to the target.
  Line reversed() const
  {
    Line line;
    for(std::size_t i = m_elements.size(); i-- > 0;)
      line.add(m_elements[i].first, m_elements[i].second);
    return line;
  }

private:
  // Leaves out a point that rounding makes equal to the one before, as the package does.
  void add(const Point& p, const Location& location)
  {
    if(m_elements.empty() || !m_has_points || m_elements.back().first != p)
      m_elements.emplace_back(p, location);
  }

  const Mesh& m_mesh;
  const Paths& m_paths;
  const bool m_has_points;
  std::vector<std::pair<Point, Location>> m_elements;
};

template <typename... Target>
Path path_to(const Surface& surface, const Paths& paths, const Target&... target)
{
  Path_writer writer(surface, paths);
  const double length = paths.shortest_path_sequence_to_source_points(target..., writer).first;
  if(length < 0)
    return {};
  return {length, static_cast<std::int64_t>(paths.nearest_source_point(target...)), writer.reversed()};
}

// Returns an engine that is built for the sources; null if the visitor cancels. The last engine serves again if it has
// the same sources, however many threads have built it. Call it inside Surface::run_alone().
std::shared_ptr<Path_engine> engine_of(Surface& surface, const Places& sources, bool everywhere,
                                       Interruptible& visitor)
{
  if(surface.path_engine == nullptr || !surface.path_engine->has_sources(sources))
    surface.path_engine = std::make_shared<Path_engine>(surface, sources);
  Paths& paths = surface.path_engine->paths;
  const bool is_built = everywhere ? paths.build_sequence_tree_for_faces(visitor) : paths.build_sequence_tree(visitor);
  return is_built ? surface.path_engine : nullptr;
}

// Returns for each target the path from the nearest source: length, source, points, faces, weights.
py::list paths_to(Surface& surface, const Place_arrays& source_places, const Place_arrays& target_places,
                  const Call& call)
{
  const Places sources(surface.mesh(), source_places), targets(surface.mesh(), target_places);
  std::vector<Path> paths(targets.size());
  Interruptible visitor(call.second, 2);
  surface.run_alone(visitor, call.first, [&]()
  {
    const auto engine = engine_of(surface, sources, !targets.are_vertices(), visitor);
    if(engine == nullptr)
      return;
    std::atomic<std::size_t> number_done{0};
    CGAL::for_each<Threads>(paths, [&](Path& path)
    {
      const std::size_t i = std::size_t(&path - paths.data());
      path = targets.are_vertices()
               ? path_to(surface, engine->paths, targets.vertices[i])
               : path_to(surface, engine->paths, targets.locations[i].first, targets.locations[i].second);
      visitor.set_part_done(1 + double(++number_done) / double(targets.size()));
      return visitor.ask_and_go_further();
    });
  });
  py::list result;
  for(Path& path : paths)
    result.append(py::make_tuple(path.length, path.source) + path.line.to_tuple());
  return result;
}

// Returns a list of lines for each level.
py::list isolines(Surface& surface, const Place_arrays& places, const Array<double>& levels, const Call& call)
{
  const Places sources(surface.mesh(), places);
  std::vector<std::vector<std::vector<Point>>> lines(static_cast<std::size_t>(levels.size()));
  const double* const level = levels.data();
  Interruptible visitor(call.second, 1 + lines.size());
  surface.run_alone(visitor, call.first, [&]()
  {
    const auto engine = engine_of(surface, sources, true, visitor);
    for(std::size_t i = 0; engine != nullptr && i < lines.size() && visitor.ask_and_go_further(); ++i)
    {
      engine->paths.isolines(level[i], std::back_inserter(lines[i]));
      visitor.set_part_done(double(i + 2));
    }
  });
  py::list result;
  for(const auto& lines_of_level : lines)
  {
    py::list arrays;
    for(const std::vector<Point>& line : lines_of_level)
      arrays.append(points_to_array(line));
    result.append(arrays);
  }
  return result;
}

// Returns for each vertex its distance, the direction in which its path leaves the source, and the source.
py::tuple directions(Surface& surface, const Place_arrays& places, const Call& call)
{
  const Places sources(surface.mesh(), places);
  const std::size_t n = surface.mesh().number_of_vertices();
  std::vector<double> distance(n), direction(n);
  std::vector<std::int64_t> source(n, -1);
  Interruptible visitor(call.second, 2);
  const auto map_of = [&](std::vector<double>& values)
  {
    const auto index = get(boost::vertex_index, surface.mesh());
    return interruptible(visitor, boost::make_iterator_property_map(values.begin(), index));
  };
  surface.run_alone(visitor, call.first, [&]()
  {
    const auto engine = engine_of(surface, sources, false, visitor);
    if(engine == nullptr)
      return;
    engine->paths.shortest_distances_to_source_points(map_of(distance));
    engine->paths.directions_at_source(map_of(direction));
    for(const Vertex v : surface.mesh().vertices())
      if(double& d = distance[std::size_t(v)]; d >= 0)
        source[std::size_t(v)] = static_cast<std::int64_t>(engine->paths.nearest_source_point(v));
      else
        d = std::numeric_limits<double>::infinity();
  });
  return py::make_tuple(to_array(std::move(distance)), to_array(std::move(direction)), to_array(std::move(source)));
}

// Traces a geodesic from a place. Returns its length, why it ends (a value of Traced_geodesic::End), the direction in
// which it would go on, points, faces, weights.
py::tuple trace(const Surface& surface, const Place_arrays& arrays, double direction, double length)
{
  const Places places(surface.mesh(), arrays);
  geodesics::Traced_geodesic<Mesh> traced;
  Line line;
  Interruptible visitor{py::none()};
  const auto points = interruptible(visitor, surface.mesh().points());
  const auto trace_from = [&](const auto& range)
  {
    return surface.has_lengths()
      ? geodesics::trace_geodesic_from_edge_lengths(surface.mesh(), interruptible(visitor, surface.lengths()),
                                                    range[0], direction, length)
      : geodesics::trace_geodesic(surface.mesh(), range[0], direction, length,
                                  CGAL::parameters::faces_to_avoid(surface.avoided_faces()).vertex_point_map(points));
  };
  visitor.run([&]()
  {
    traced = places.visit(trace_from);
    traced.points.resize(traced.locations.size()); // zeros on a surface without points
    for(std::size_t i = 0; i < traced.locations.size(); ++i)
      line.add(Point(traced.points[i][0], traced.points[i][1], traced.points[i][2]), traced.locations[i]);
  });
  return py::make_tuple(traced.length, int(traced.end), traced.direction) + line.to_tuple();
}

// Returns the direction of a vector of space at a place.
double direction_of(const Surface& surface, const Place_arrays& places, const std::array<double, 3>& vector)
{
  return Places(surface.mesh(), places)
    .visit([&](const auto& range)
           { return geodesics::geodesic_direction(surface.mesh(), range[0], vector,
                                                  CGAL::parameters::faces_to_avoid(surface.avoided_faces())); });
}

} // namespace

void bind_paths(Surface_class& surface)
{
  surface.def("paths", &paths_to).def("isolines", &isolines).def("directions", &directions)
    .def("trace", &trace).def("direction_of", &direction_of);
}

} // namespace geodesics_python
