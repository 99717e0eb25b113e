// Shortest paths, isolines, and geodesics that are given by directions.

#include "Engines.h"

#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace geodesics_python {

Places::Places(const Mesh& mesh, const Array<std::int64_t>& vertex, const Array<std::int64_t>& face,
               const Array<double>& weights)
{
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
      locations.push_back(Paths_with<CGAL::Sequential_tag>::face_location(vertices[std::size_t(i)], mesh));
    if(locations.back().first == Mesh::null_face())
      throw std::invalid_argument("vertex " + std::to_string(id(i))
                                  + " has no face: it cannot stand beside points of faces");
  }
  vertices.clear();
}

// Paths from a set of sources, built by one thread or by several.
class Path_engine
{
public:
  Path_engine(const Surface& surface, const Places& sources, bool is_parallel) : m_sources(sources)
  {
    if(is_parallel)
      set_up(surface, m_parallel);
    else
      set_up(surface, m_sequential);
  }

  bool has_sources(const Places& sources) const
  {
    return m_sources.vertices == sources.vertices && m_sources.locations == sources.locations;
  }

  // Calls use() with the paths.
  template <typename Use>
  auto visit(Use use) const
  {
    return m_parallel != nullptr ? use(*m_parallel) : use(*m_sequential);
  }

  // Returns false if the visitor cancels.
  bool build(bool everywhere, std::size_t threads, Interruptible& visitor)
  {
    bool is_built = false;
    with_threads(threads, [&]()
    {
      visit([&](auto& paths)
      {
        is_built = everywhere ? paths.build_sequence_tree_for_faces(visitor) : paths.build_sequence_tree(visitor);
      });
    });
    return is_built;
  }

private:
  template <typename Paths>
  void set_up(const Surface& surface, std::unique_ptr<Paths>& paths)
  {
    paths = std::make_unique<Paths>(surface.mesh());
    paths->avoid_faces(surface.avoided_faces());
    if(surface.has_lengths())
      paths->use_edge_lengths(surface.lengths());
    m_sources.visit([&](const auto& range) { paths->add_source_points(range.begin(), range.end()); });
  }

  const Places m_sources;
  // One of the two is there.
  std::unique_ptr<Paths_with<CGAL::Sequential_tag>> m_sequential;
  std::unique_ptr<Paths_with<Threads>> m_parallel;
};

namespace {

struct Path
{
  double length = std::numeric_limits<double>::infinity();
  std::int64_t source = -1;
  std::vector<double> points;        // from the source to the target
  std::vector<std::int64_t> faces;   // of each point
  std::vector<double> weights;       // of each point, in its face
};

// Collects the elements of a path, from the target to the source.
template <typename Paths>
class Path_writer
{
public:
  Path_writer(const Surface& surface, const Paths& paths)
    : m_mesh(surface.mesh()), m_paths(paths), m_has_points(!surface.has_lengths())
  {}

  void operator()(Mesh::Halfedge_index h, double t) { add(m_paths.point(h, t), Paths::face_location(h, t, m_mesh)); }
  void operator()(Vertex v) { add(m_mesh.point(v), Paths::face_location(v, m_mesh)); }
  void operator()(Face f, const Barycentric& b) { add(m_paths.point(f, b), {f, b}); }

  // The path from the source to the target.
  Path reversed() const
  {
    const std::size_t n = m_elements.size();
    Path path;
    path.points.resize(3 * n);
    path.faces.resize(n);
    path.weights.resize(3 * n);
    for(std::size_t i = 0; i < n; ++i)
    {
      const auto& [p, location] = m_elements[n - 1 - i];
      const auto& [f, b] = location;
      path.faces[i] = f == Mesh::null_face() ? -1 : std::int64_t(std::size_t(f));
      for(int k = 0; k < 3; ++k)
      {
        path.points[3 * i + std::size_t(k)] = p[k];
        path.weights[3 * i + std::size_t(k)] = b[std::size_t(k)];
      }
    }
    return path;
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

template <typename Paths, typename... Target>
Path path_to(const Surface& surface, const Paths& paths, const Target&... target)
{
  Path_writer<Paths> writer(surface, paths);
  const double length = paths.shortest_path_sequence_to_source_points(target..., writer).first;
  Path path = writer.reversed();
  if(length >= 0)
  {
    path.length = length;
    path.source = static_cast<std::int64_t>(paths.nearest_source_point(target...));
  }
  return path;
}

Path path_to(const Surface& surface, const Path_engine& engine, const Places& targets, std::size_t i)
{
  return engine.visit([&](const auto& paths)
  {
    if(targets.are_vertices())
      return path_to(surface, paths, targets.vertices[i]);
    return path_to(surface, paths, targets.locations[i].first, targets.locations[i].second);
  });
}

// Returns an engine that is built for the sources; null if the visitor cancels. The last engine serves again if it has
// the same sources, however many threads have built it. Call it inside Surface::run_alone().
std::shared_ptr<Path_engine> engine_of(Surface& surface, const Places& sources, bool everywhere, std::size_t threads,
                                       Interruptible& visitor)
{
  if(surface.path_engine == nullptr || !surface.path_engine->has_sources(sources))
    surface.path_engine = std::make_shared<Path_engine>(surface, sources, threads > 1);
  return surface.path_engine->build(everywhere, threads, visitor) ? surface.path_engine : nullptr;
}

template <typename Work>
void for_each_target(std::size_t n, std::size_t threads, const Work& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(threads > 1)
    return with_threads(threads, [&]() { tbb::parallel_for(std::size_t(0), n, work); });
#endif
  static_cast<void>(threads);
  for(std::size_t i = 0; i < n; ++i)
    work(i);
}

py::tuple to_tuple(Path&& path)
{
  return py::make_tuple(path.length, path.source, to_rows(std::move(path.points), 3), to_array(std::move(path.faces)),
                        to_rows(std::move(path.weights), 3));
}

// Returns for each target the path from the nearest source: length, source, points, faces, weights.
py::list paths_to(Surface& surface, const Array<std::int64_t>& vertex, const Array<std::int64_t>& face,
                  const Array<double>& weights, const Array<std::int64_t>& target_vertex,
                  const Array<std::int64_t>& target_face, const Array<double>& target_weights, std::size_t threads,
                  const py::object& progress)
{
  const Places sources(surface.mesh(), vertex, face, weights);
  const Places targets(surface.mesh(), target_vertex, target_face, target_weights);
  std::vector<Path> paths(targets.size());
  Interruptible visitor(progress, 2);
  surface.run_alone(visitor, [&]()
  {
    const auto engine = engine_of(surface, sources, !targets.are_vertices(), threads, visitor);
    if(engine == nullptr)
      return;
    std::atomic<std::size_t> number_done{0};
    for_each_target(targets.size(), threads, [&](std::size_t i)
    {
      if(!visitor.ask_and_go_further())
        return;
      paths[i] = path_to(surface, *engine, targets, i);
      visitor.set_part_done(1 + double(++number_done) / double(targets.size()));
    });
  });
  py::list result;
  for(Path& path : paths)
    result.append(to_tuple(std::move(path)));
  return result;
}

// Returns a list of lines for each level.
py::list isolines(Surface& surface, const Array<std::int64_t>& vertex, const Array<std::int64_t>& face,
                  const Array<double>& weights, const Array<double>& levels, std::size_t threads,
                  const py::object& progress)
{
  const Places sources(surface.mesh(), vertex, face, weights);
  std::vector<std::vector<std::vector<Point>>> lines(static_cast<std::size_t>(levels.size()));
  const double* const level = levels.data();
  Interruptible visitor(progress, 1 + lines.size());
  surface.run_alone(visitor, [&]()
  {
    const auto engine = engine_of(surface, sources, true, threads, visitor);
    for(std::size_t i = 0; engine != nullptr && i < lines.size() && visitor.ask_and_go_further(); ++i)
    {
      engine->visit([&](const auto& paths) { paths.isolines(level[i], std::back_inserter(lines[i])); });
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

// Gets a number for each vertex. It ends the computation with an exception if Python interrupts.
struct Vertex_output
{
  using key_type = Vertex;
  using value_type = double;
  using reference = double;
  using category = boost::writable_property_map_tag;

  friend void put(const Vertex_output& map, Vertex v, double value)
  {
    if(!map.visitor->ask_sometimes_and_go_further())
      throw std::runtime_error("interrupted");
    (*map.values)[std::size_t(v)] = value;
  }

  Interruptible* visitor;
  std::vector<double>* values;
};

// Returns for each vertex its distance, the direction in which its path leaves the source, and the source.
py::tuple directions(Surface& surface, const Array<std::int64_t>& vertex, const Array<std::int64_t>& face,
                     const Array<double>& weights, std::size_t threads, const py::object& progress)
{
  const Places sources(surface.mesh(), vertex, face, weights);
  const std::size_t n = surface.mesh().number_of_vertices();
  std::vector<double> distance(n), direction(n);
  std::vector<std::int64_t> source(n, -1);
  Interruptible visitor(progress, 2);
  surface.run_alone(visitor, [&]()
  {
    const auto engine = engine_of(surface, sources, false, threads, visitor);
    if(engine == nullptr)
      return;
    engine->visit([&](const auto& paths)
    {
      paths.shortest_distances_to_source_points(Vertex_output{&visitor, &distance});
      paths.directions_at_source(Vertex_output{&visitor, &direction});
      for(const Vertex v : surface.mesh().vertices())
        if(double& d = distance[std::size_t(v)]; d >= 0)
          source[std::size_t(v)] = static_cast<std::int64_t>(paths.nearest_source_point(v));
        else
          d = std::numeric_limits<double>::infinity();
    });
  });
  return py::make_tuple(to_array(std::move(distance)), to_array(std::move(direction)), to_array(std::move(source)));
}

// Traces a geodesic from a place. Returns its length, why it ends (a value of Traced_geodesic::End), the direction in
// which it would go on, points, faces, weights.
py::tuple trace(const Surface& surface, const Array<std::int64_t>& vertex, const Array<std::int64_t>& face,
                const Array<double>& weights, double direction, double length)
{
  const Places places(surface.mesh(), vertex, face, weights);
  geodesics::Traced_geodesic<Mesh> traced;
  Interruptible visitor{py::none()};
  visitor.run([&]()
  {
    traced = places.visit([&](const auto& range)
    {
      return surface.has_lengths()
        ? geodesics::trace_geodesic_from_edge_lengths(surface.mesh(), surface.lengths(), range[0], direction, length)
        : geodesics::trace_geodesic(surface.mesh(), range[0], direction, length);
    });
  });
  traced.points.resize(traced.locations.size());
  std::vector<double> points, coordinates;
  std::vector<std::int64_t> faces;
  for(std::size_t i = 0; i < traced.locations.size(); ++i)
  {
    const auto& [f, b] = traced.locations[i];
    points.insert(points.end(), traced.points[i].begin(), traced.points[i].end());
    coordinates.insert(coordinates.end(), b.begin(), b.end());
    faces.push_back(std::int64_t(std::size_t(f)));
  }
  return py::make_tuple(traced.length, int(traced.end), traced.direction, to_rows(std::move(points), 3),
                        to_array(std::move(faces)), to_rows(std::move(coordinates), 3));
}

// Returns the direction of a vector of space at a place.
double direction_of(const Surface& surface, const Array<std::int64_t>& vertex, const Array<std::int64_t>& face,
                    const Array<double>& weights, const std::array<double, 3>& vector)
{
  return Places(surface.mesh(), vertex, face, weights)
    .visit([&](const auto& range) { return geodesics::geodesic_direction(surface.mesh(), range[0], vector); });
}

} // namespace

void bind_paths(Surface_class& surface)
{
  surface.def("paths", &paths_to)
    .def("isolines", &isolines)
    .def("directions", &directions)
    .def("trace", &trace)
    .def("direction_of", &direction_of);
}

} // namespace geodesics_python
