// The surface behind a Python Solver, and what all bindings share: arrays, sources, and the visitor that lets Python
// interrupt a computation. The Python files check ids and shapes before they call this module; here the mesh is checked
// as a whole.

#ifndef SURFACE_MESH_GEODESICS_PYTHON_SURFACE_H
#define SURFACE_MESH_GEODESICS_PYTHON_SURFACE_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

namespace geodesics_python {

namespace py = pybind11;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Barycentric = std::array<double, 3>;
using Location = std::pair<Face, Barycentric>;

// Arrays in C order, of the one type that the Python files pass.
template <typename T>
using Array = py::array_t<T, py::array::c_style>;

// --- arrays that own their memory ------------------------------------------------------------------------------------

// Moves a vector into an array of one dimension.
template <typename T>
py::array_t<T> to_array(std::vector<T>&& values)
{
  auto* const owner = new std::vector<T>(std::move(values));
  const py::capsule capsule(owner, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>({owner->size()}, {sizeof(T)}, owner->data(), capsule);
}

// Moves a vector of n * columns numbers into an array of n rows, or of one dimension if there is one column.
template <typename T>
py::array_t<T> to_rows(std::vector<T>&& values, std::size_t columns)
{
  const std::size_t rows = values.size() / columns;
  return to_array(std::move(values)).reshape(columns == 1 ? std::vector{rows} : std::vector{rows, columns});
}

py::array_t<double> points_to_array(const std::vector<Point>& points);

// The points of a mesh, and its faces as rows of three vertices.
py::tuple mesh_to_tuple(const Mesh& mesh);

// A line on the surface as Python gets it: its points, a face of each, or -1, and the coordinates there.
struct Line
{
  void add(const Point& p, const Location& location)
  {
    const auto& [f, b] = location;
    points.insert(points.end(), {p[0], p[1], p[2]});
    faces.push_back(f == Mesh::null_face() ? -1 : std::int64_t(std::size_t(f)));
    weights.insert(weights.end(), b.begin(), b.end());
  }

  py::tuple to_tuple()
  {
    return py::make_tuple(to_rows(std::move(points), 3), to_array(std::move(faces)), to_rows(std::move(weights), 3));
  }

  std::vector<double> points, weights;
  std::vector<std::int64_t> faces;
};

// --- how a call computes: the number of threads, and the progress function or None ---

using Call = std::pair<std::size_t, py::object>;

// --- interruption ----------------------------------------------------------------------------------------------------

// Runs a computation that Python can interrupt, in the calling thread and without the interpreter's lock. Twenty times
// a second, the computation stops for a moment: it takes the lock, asks for signals (Ctrl-C), and calls the progress
// function with a number from 0 to 1, which never falls. An exception of either one ends the computation and is passed
// on. When the interpreter ends, so do the computations of daemon threads (stop_all()). These threads then sleep until
// the process ends: one that returned to the interpreter would be aborted, and with it the program.
//
// It is also the visitor of the computation, a model of GeodesicPropagationVisitor.
class Interruptible
{
public:
  // `progress` may be None. `number_of_runs` is how often a propagation begins. Make it in the thread that computes.
  // After stop_all(), run() does not return, except in the thread that has called stop_all().
  explicit Interruptible(py::object progress, std::size_t number_of_runs = 1);
  ~Interruptible();

  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  void on_propagation_begin(std::size_t number_of_vertices) { m_number_of_vertices = number_of_vertices; }

  // With several threads, there may be hundreds of visits between two calls; and none, while a certificate is checked.
  void on_progress(std::size_t number_of_visits, double)
  {
    if(number_of_visits - m_last_visits < 64 && ++m_calls % 64 != 0) // (larger if a run begins)
      return;
    m_last_visits = number_of_visits;
    set_part_done(double(m_run) + double(number_of_visits) / double(m_number_of_vertices + 1));
    ask_and_go_further();
  }

  bool go_further() const { return !m_is_stopped.load(std::memory_order_relaxed); }
  void on_propagation_end() { ++m_run; }

  // `runs` is the number of runs that are done. Any thread may call it.
  void set_part_done(double runs)
  {
    const double part = (std::min)(1., runs / double(m_number_of_runs));
    if(part > m_part_done.load(std::memory_order_relaxed))
      m_part_done.store(part, std::memory_order_relaxed);
  }

  // For what is not a propagation: asks Python if it is time to, and returns whether to go on. Any thread may call it;
  // only the one that computes asks.
  bool ask_and_go_further();

  // The same for loops with short steps: looks at the clock at every 64th call only.
  bool ask_sometimes_and_go_further()
  {
    thread_local unsigned int number_of_calls = 0;
    return ++number_of_calls % 64 != 0 ? go_further() : ask_and_go_further();
  }

  // The same for functions that take no visitor: throws if they have to end. run() passes on what has interrupted it.
  void ask_sometimes_or_throw()
  {
    if(!ask_sometimes_and_go_further())
      throw std::runtime_error("interrupted");
  }

  // Calls compute(), which must not touch Python, and throws what has interrupted it, or what it throws.
  // Requires: this thread holds the interpreter's lock.
  void run(const std::function<void()>& compute);

  // Stops all computations, and waits until their threads sleep; no longer than two seconds for those that run Python.
  // A signal ends the wait. Requires: this thread holds the interpreter's lock.
  static void stop_all();

protected:
  // Calls Python code in the thread that computes. Its exception ends the computation.
  void call_python(const std::function<void()>& call);

private:
  const std::thread::id m_thread = std::this_thread::get_id();
  std::chrono::steady_clock::time_point m_next_question;
  py::object m_progress;
  std::exception_ptr m_interruption; // what Python has thrown
  std::size_t m_number_of_runs, m_run = 0, m_number_of_vertices = 0, m_last_visits = 0, m_calls = 0;
  std::atomic<double> m_part_done{0};
  std::atomic<bool> m_is_stopped{false}, m_is_in_python{false}, m_is_at_end{false};
};

// A property map for functions that take no visitor: they end with an exception if Python interrupts.
template <typename Map>
struct Interruptible_map : Map // which has the types
{
  friend typename Map::reference get(const Interruptible_map& map, const typename Map::key_type& key)
  {
    map.visitor->ask_sometimes_or_throw();
    return get(static_cast<const Map&>(map), key);
  }

  friend void put(const Interruptible_map& map, const typename Map::key_type& key,
                  const typename Map::value_type& value)
  {
    map.visitor->ask_sometimes_or_throw();
    put(static_cast<const Map&>(map), key, value);
  }

  Interruptible* visitor;
};

template <typename Map>
Interruptible_map<Map> interruptible(Interruptible& visitor, const Map& map) { return {map, &visitor}; }

// Returns compute(), which is called without the interpreter's lock.
template <typename Compute>
auto without_lock(const Compute& compute)
{
  decltype(compute()) result{};
  Interruptible{py::none()}.run([&]() { result = compute(); });
  return result;
}

// Calls compute() with at most this number of threads.
void with_threads(std::size_t number, const std::function<void()>& compute);

// --- sources ---------------------------------------------------------------------------------------------------------

// Three arrays from Python: entry i is vertex[i] if that is not negative, and else the point of face[i] with the
// coordinates weights[i].
using Place_arrays = std::tuple<Array<std::int64_t>, Array<std::int64_t>, Array<double>>;

// Vertices, or points of faces.
struct Places
{
  Places(const Mesh& mesh, const Place_arrays& arrays);

  bool are_vertices() const { return locations.empty(); }
  std::size_t size() const { return are_vertices() ? vertices.size() : locations.size(); }

  // Calls use() with the vertices, or with locations if one of the places is a point of a face.
  template <typename Use>
  auto visit(Use use) const { return are_vertices() ? use(vertices) : use(locations); }

  std::vector<Vertex> vertices;
  std::vector<Location> locations;
};

inline std::vector<Vertex> to_vertices(const Array<std::int64_t>& ids) { return {ids.data(), ids.data() + ids.size()}; }

inline py::array_t<std::int64_t> to_ids(const std::vector<Vertex>& vertices)
{
  return to_array(std::vector<std::int64_t>(vertices.begin(), vertices.end()));
}

// --- the surface -----------------------------------------------------------------------------------------------------

struct Distance_engine;
struct Path_engine;

// A mesh, and engines that are made when they are needed. Several threads may use a surface: a computation waits for
// the one before it.
class Surface
{
public:
  // Makes a mesh of points and triangles, without the interpreter's lock. Throws std::invalid_argument with the reason
  // if they do not form a surface. If `lengths` has rows, entry (f, k) is the length of the edge from corner k of face
  // f to the next corner. No path leads through the avoided faces; a surface with lengths has none.
  Surface(const Array<double>& points, const Array<std::int64_t>& faces, const Array<double>& lengths,
          const Array<std::int64_t>& avoided);

  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  const Mesh& mesh() const { return m_mesh; }
  bool has_lengths() const { return m_has_lengths; }
  auto lengths() const { return m_lengths; }
  const std::vector<Face>& avoided_faces() const { return m_avoided; }

  // Calls compute() with at most this number of threads while no other thread computes on this surface, as
  // Interruptible::run() does. Throws std::logic_error if this thread computes on it already and Python calls back.
  void run_alone(Interruptible& visitor, std::size_t threads, const std::function<void()>& compute);

  // Both are used inside run_alone() only.
  std::shared_ptr<Distance_engine> distance_engine;
  std::shared_ptr<Path_engine> path_engine;

private:
  // They return early if Python interrupts.
  void build(const Array<double>& points, const Array<std::int64_t>& faces, const Array<double>& lengths,
             Interruptible& visitor);
  void add_faces(const Array<std::int64_t>& faces, Interruptible& visitor);
  void add_lengths(const Array<std::int64_t>& faces, const Array<double>& lengths, Interruptible& visitor);

  Mesh m_mesh;
  Mesh::Property_map<Mesh::Edge_index, double> m_lengths;
  bool m_has_lengths = false;
  std::vector<Face> m_avoided;
  std::timed_mutex m_mutex;
  std::atomic<std::thread::id> m_owner{std::thread::id()}; // of the mutex
};

// Returns triangles of which some are turned over, such that neighbors have the same orientation. Throws
// std::invalid_argument if that is not possible.
py::array_t<std::int64_t> oriented(std::size_t number_of_vertices, const Array<std::int64_t>& faces);

// --- the parts of the module -----------------------------------------------------------------------------------------

using Surface_class = py::class_<Surface, std::shared_ptr<Surface>>;

void bind_distances(Surface_class& surface);
void bind_paths(Surface_class& surface);
void bind_stores(Surface_class& surface);
void bind_diagrams(py::module_& module, Surface_class& surface);

} // namespace geodesics_python

#endif // SURFACE_MESH_GEODESICS_PYTHON_SURFACE_H
