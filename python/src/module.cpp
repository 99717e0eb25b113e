// The module _core: a surface made of arrays, and what does not depend on the algorithms.

#include "Surface.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#endif

#include <map>
#include <set>
#include <string>

namespace geodesics_python {

py::array_t<double> points_to_array(const std::vector<Point>& points)
{
  std::vector<double> numbers;
  numbers.reserve(3 * points.size());
  for(const Point& p : points)
    numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
  return to_rows(std::move(numbers), 3);
}

py::tuple mesh_to_tuple(const Mesh& mesh)
{
  const std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  std::vector<std::int64_t> faces;
  for(const Face f : mesh.faces()) // in the order of Surface::add_faces()
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
      faces.push_back(std::int64_t(std::size_t(mesh.source(h))));
  return py::make_tuple(points_to_array(points), to_rows(std::move(faces), 3));
}

// The computations that run now, and the thread that ends the program.
static std::mutex running_mutex;
static std::set<Interruptible*> running;
static std::thread::id ending_thread;

static constexpr std::chrono::milliseconds time_between_questions(50);

Interruptible::Interruptible(py::object progress, std::size_t number_of_runs)
  : m_progress(std::move(progress)), m_number_of_runs(number_of_runs)
{
  const std::lock_guard<std::mutex> lock(running_mutex);
  m_is_stopped = ending_thread != std::thread::id() && ending_thread != m_thread;
  running.insert(this);
}

Interruptible::~Interruptible()
{
  const std::lock_guard<std::mutex> lock(running_mutex);
  running.erase(this);
}

void Interruptible::stop_all()
{
  int rounds = 0;
  for(bool is_done = false; !is_done; ++rounds)
  {
    if(PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    const py::gil_scoped_release release;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard<std::mutex> lock(running_mutex);
    ending_thread = std::this_thread::get_id();
    is_done = true;
    for(Interruptible* i : running)
    {
      i->m_is_stopped = true;
      is_done = is_done && (i->m_is_at_end || (i->m_is_in_python && rounds > 2000));
    }
  }
}

void Interruptible::run(const std::function<void()>& compute)
{
  m_next_question = std::chrono::steady_clock::now() + time_between_questions;
  std::exception_ptr failure;
  {
    const py::gil_scoped_release release;
    try
    {
      if(!m_is_stopped)
        compute();
    }
    catch(...)
    {
      failure = std::current_exception();
    }
    m_is_at_end = m_is_stopped && m_interruption == nullptr; // stopped by stop_all(), maybe before it began
    while(m_is_at_end)
      std::this_thread::sleep_for(std::chrono::hours(1));
  }
  if(m_interruption != nullptr || failure != nullptr)
    std::rethrow_exception(m_interruption != nullptr ? m_interruption : failure);
}

bool Interruptible::ask_and_go_further()
{
  if(std::this_thread::get_id() != m_thread || m_is_stopped || std::chrono::steady_clock::now() < m_next_question)
    return go_further();
  call_python([this]()
  {
    if(PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    if(!m_progress.is_none())
      m_progress(m_part_done.load());
  });
  m_next_question = std::chrono::steady_clock::now() + time_between_questions;
  return go_further();
}

void Interruptible::call_python(const std::function<void()>& call)
{
  const py::gil_scoped_acquire acquire;
  m_is_in_python = true;
  try
  {
    call();
  }
  catch(...)
  {
    m_interruption = std::current_exception();
    m_is_stopped = true;
  }
  m_is_in_python = false;
}

void with_threads([[maybe_unused]] std::size_t number, const std::function<void()>& compute)
{
#ifdef CGAL_LINKED_WITH_TBB
  // More threads than this only take memory. (TBB starts no more than the machine has unless it is told to.)
  const std::size_t most = (std::max)(std::size_t(32), std::size_t(tbb::info::default_concurrency()));
  const int n = static_cast<int>((std::min)(number, most));
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    std::size_t((std::max)(n, tbb::info::default_concurrency())));
  // An arena leaves some memory behind when it ends, so each thread keeps one for each number.
  thread_local std::map<int, tbb::task_arena> arenas;
  arenas.try_emplace(n, n).first->second.execute(compute);
#else
  compute();
#endif
}

Surface::Surface(const Array<double>& points, const Array<std::int64_t>& faces, const Array<double>& lengths,
                 const Array<std::int64_t>& avoided)
  : m_avoided(avoided.data(), avoided.data() + avoided.size())
{
  Interruptible visitor{py::none()};
  visitor.run([&]() { build(points, faces, lengths, visitor); });
}

void Surface::build(const Array<double>& points, const Array<std::int64_t>& faces, const Array<double>& lengths,
                    Interruptible& visitor)
{
  const auto p = points.unchecked<2>();
  const std::size_t n = std::size_t(p.shape(0)), m = std::size_t(faces.shape(0));
  if(n >= (std::size_t(1) << 31) || m >= (std::size_t(1) << 30))
    throw std::invalid_argument("the mesh is too large: at most 2**31 - 1 vertices and 2**30 - 1 faces");
  m_mesh.reserve(Mesh::size_type(n), Mesh::size_type(3 * m / 2 + 16), Mesh::size_type(m));
  for(py::ssize_t v = 0; v < p.shape(0) && visitor.ask_sometimes_and_go_further(); ++v)
    m_mesh.add_vertex(Point(p(v, 0), p(v, 1), p(v, 2)));
  add_faces(faces, visitor);
  if(lengths.shape(0) > 0)
    add_lengths(faces, lengths, visitor);
}

void Surface::add_faces(const Array<std::int64_t>& faces, Interruptible& visitor)
{
  const auto id = faces.unchecked<2>();
  std::array<Vertex, 3> corners;
  for(py::ssize_t f = 0; f < id.shape(0) && visitor.ask_sometimes_and_go_further(); ++f)
  {
    for(std::size_t k = 0; k < 3; ++k)
      corners[k] = Vertex(static_cast<Mesh::size_type>(id(f, py::ssize_t(k))));
    if(corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
      throw std::invalid_argument("F[" + std::to_string(f) + "] has a vertex twice");
    const Face face = m_mesh.add_face(corners);
    if(face == Mesh::null_face())
      throw std::invalid_argument("F[" + std::to_string(f)
                                  + "] does not fit the faces before it: an edge has more than two faces, or two faces "
                                    "of opposite orientation, or too many parts of the surface meet at a vertex");
    // Weights belong to the corners in the order of the array.
    while(m_mesh.source(m_mesh.halfedge(face)) != corners[0])
      m_mesh.set_halfedge(face, m_mesh.next(m_mesh.halfedge(face)));
  }
}

void Surface::add_lengths(const Array<std::int64_t>& faces, const Array<double>& lengths, Interruptible& visitor)
{
  const auto l = lengths.unchecked<2>();
  m_lengths = m_mesh.add_property_map<Mesh::Edge_index, double>("e:length", -1.).first;
  m_has_lengths = true;
  for(py::ssize_t f = 0; f < faces.shape(0) && visitor.ask_sometimes_and_go_further(); ++f)
  {
    auto h = m_mesh.halfedge(Face(static_cast<Mesh::size_type>(f)));
    for(py::ssize_t k = 0; k < 3; ++k, h = m_mesh.next(h))
    {
      double& length = m_lengths[m_mesh.edge(h)];
      if(length >= 0 && length != l(f, k))
        throw std::invalid_argument("L[" + std::to_string(f) + ", " + std::to_string(k)
                                    + "] differs from the length that another face gives to the same edge");
      length = l(f, k);
    }
  }
}

py::array_t<std::int64_t> oriented(std::size_t number_of_vertices, const Array<std::int64_t>& faces)
{
  std::vector<Point> points(number_of_vertices, CGAL::ORIGIN);
  std::vector<std::vector<std::size_t>> triangles;
  const auto id = faces.unchecked<2>();
  for(py::ssize_t f = 0; f < id.shape(0); ++f)
    triangles.push_back({std::size_t(id(f, 0)), std::size_t(id(f, 1)), std::size_t(id(f, 2))});
  if(!without_lock([&]() { return CGAL::Polygon_mesh_processing::orient_polygon_soup(points, triangles); }))
    throw std::invalid_argument("the triangles cannot be oriented: they do not form a surface with two sides");
  std::vector<std::int64_t> result;
  for(const std::vector<std::size_t>& triangle : triangles)
    for(const std::size_t v : triangle)
      result.push_back(std::int64_t(v));
  return to_rows(std::move(result), 3);
}

void Surface::run_alone(Interruptible& visitor, std::size_t threads, const std::function<void()>& compute)
{
  if(m_owner.load() == std::this_thread::get_id())
    throw std::logic_error("Python code that a computation has called uses the solver that computes");
  visitor.run([&]()
  {
    std::unique_lock<std::timed_mutex> lock(m_mutex, std::defer_lock);
    while(visitor.ask_and_go_further() && !lock.try_lock_for(time_between_questions))
      ;
    if(!lock.owns_lock())
      return;
    m_owner = std::this_thread::get_id();
    const std::shared_ptr<void> at_end(nullptr, [this](void*) { m_owner = std::thread::id(); });
    with_threads(threads, compute);
  });
}

} // namespace geodesics_python

PYBIND11_MODULE(_core, module)
{
  using namespace geodesics_python;
  module.doc() = "The compiled part of surface_mesh_geodesics. Programs use the classes of the package.";
  module.attr("__version__") = SURFACE_MESH_GEODESICS_VERSION;
  module.def("oriented", &oriented);
  Surface_class surface(module, "Surface");
  surface.def(py::init<const Array<double>&, const Array<std::int64_t>&, const Array<double>&,
                       const Array<std::int64_t>&>())
    .def("arrays", [](const Surface& s) { return mesh_to_tuple(s.mesh()); });
  bind_distances(surface);
  bind_paths(surface);
  bind_stores(surface);
  bind_diagrams(module, surface);
  // Before the interpreter ends: a computation that ends later would find no interpreter.
  py::module_::import("atexit").attr("register")(py::cpp_function(&Interruptible::stop_all));
}
