// What the benchmark programs share: measuring processes, the peak of memory, medians, the command line.
//
// A program starts itself again for every measurement, so that the peak of memory belongs to one method and no run
// profits from memory or caches that another one has warmed up. Linux only (fork, /proc).

#ifndef BENCHMARK_SUPPORT_H
#define BENCHMARK_SUPPORT_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/version.h>

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

// ---------------------------------------------------------------------------------------------------------------------
// The command line
// ---------------------------------------------------------------------------------------------------------------------

struct Settings
{
  std::vector<std::string> meshes;
  std::string kernel = "simple";
  std::string clock = "processor";
  std::string only;
  std::string flags = "not given";
  std::size_t repetitions = 5;
  std::size_t subdivisions = 0;
  std::size_t minimum_faces = 0;
  std::size_t time_limit = 0;   // seconds; 0: none
  std::size_t memory_limit = 0; // MB; 0: none
  bool print_header = true;

  // Of measuring processes.
  int pipe_end = -1;
  std::string method;

  bool is_measuring() const { return pipe_end >= 0; }
  bool wants(const std::string& who) const { return only.empty() || only == who; }
  clockid_t clock_id() const { return (clock == "wall") ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID; }
};

inline void print_common_usage()
{
  std::cerr << "  --list FILE           more mesh files, one per line\n"
            << "  --repetitions N       runs of each method (5)\n"
            << "  --only ours|original  run one method only\n"
            << "  --subdivide K         K midpoint subdivisions first (0)\n"
            << "  --kernel simple|epick Simple_cartesian<double> or Exact_predicates_inexact_constructions_kernel\n"
            << "  --clock processor|wall  processor time of the process (default), or time that passes\n"
            << "  --minimum-faces N     skip smaller meshes\n"
            << "  --time-limit SECONDS  give up a run after that time\n"
            << "  --memory-limit MB     give up a run that would need more\n"
            << "  --flags TEXT          compiler flags, for the first lines of the output\n"
            << "  --no-header           rows only\n";
}

inline bool read_list(const std::string& file, std::vector<std::string>& meshes)
{
  std::ifstream in(file);
  std::string line;
  if(!in)
  {
    return false;
  }
  while(std::getline(in, line))
  {
    if(!line.empty() && line[0] != '#')
    {
      meshes.push_back(line);
    }
  }
  return true;
}

// Reads an option of one program whose value is a positive number. Returns false, and changes nothing, if this is
// another option or no such number.
inline bool read_number_option(const std::string& option, const std::string& value, const std::string& name,
                               std::size_t& number)
{
  const std::size_t read = option == name ? std::strtoul(value.c_str(), nullptr, 10) : 0;
  if(read == 0)
  {
    return false;
  }
  number = read;
  return true;
}

inline bool read_common_option(const std::string& option, const std::string& value, Settings& settings)
{
  const std::size_t number = std::strtoul(value.c_str(), nullptr, 10);
  if(option == "--list")
  {
    return read_list(value, settings.meshes);
  }
  if(option == "--only" && (value == "ours" || value == "original"))
  {
    settings.only = value;
  }
  else if(option == "--kernel" && (value == "simple" || value == "epick"))
  {
    settings.kernel = value;
  }
  else if(option == "--clock" && (value == "processor" || value == "wall"))
  {
    settings.clock = value;
  }
  else if(option == "--flags")
  {
    settings.flags = value;
  }
  else if(option == "--repetitions" && number > 0)
  {
    settings.repetitions = number;
  }
  else if(option == "--subdivide")
  {
    settings.subdivisions = number;
  }
  else if(option == "--minimum-faces")
  {
    settings.minimum_faces = number;
  }
  else if(option == "--time-limit")
  {
    settings.time_limit = number;
  }
  else if(option == "--memory-limit")
  {
    settings.memory_limit = number;
  }
  else if(option == "--measure")
  {
    settings.pipe_end = static_cast<int>(number);
  }
  else if(option == "--method")
  {
    settings.method = value;
  }
  else
  {
    return false;
  }
  return true;
}

// Reads the command line; `read_own_option(option, value)` reads the options of one program only. Returns false if the
// command line is wrong.
template <class ReadOwnOption>
bool read_settings(int argc, char* argv[], Settings& settings, const ReadOwnOption& read_own_option)
{
  for(int i = 1; i < argc; ++i)
  {
    const std::string option = argv[i];
    if(option.compare(0, 2, "--") != 0)
    {
      settings.meshes.push_back(option);
    }
    else if(option == "--no-header")
    {
      settings.print_header = false;
    }
    else if(++i == argc || !(read_own_option(option, argv[i]) || read_common_option(option, argv[i], settings)))
    {
      return false;
    }
  }
  return !settings.meshes.empty();
}

// ---------------------------------------------------------------------------------------------------------------------
// The measuring process
// ---------------------------------------------------------------------------------------------------------------------

// Its exit codes.
const int cannot_read = 2;
const int not_wanted = 3; // fewer faces than --minimum-faces, or not a triangle mesh
const int method_failed = 4;

inline double milliseconds_now(clockid_t clock)
{
  timespec now;
  ::clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// Returns a number of kilobytes from /proc/self/status. (`getrusage()` is of no use here: its maximum is inherited from
// the process that called exec().)
inline std::uint64_t status_kilobytes(const std::string& name)
{
  std::ifstream in("/proc/self/status");
  std::string line;
  while(std::getline(in, line))
  {
    if(line.compare(0, name.size(), name) == 0)
    {
      return std::strtoull(line.c_str() + name.size() + 1, nullptr, 10);
    }
  }
  return 0;
}

// Returns the memory that reading the mesh has freed to the system and resets the peak. Otherwise a method could use
// the freed memory for free, or its peak could be that of the reading.
inline std::uint64_t start_of_memory_measurement()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5" << std::endl;
  return status_kilobytes("VmRSS:");
}

// The kernel counts pages in batches, so a method that adds hardly any memory may seem to have freed some.
inline std::uint64_t added_memory(std::uint64_t resident_before)
{
  const std::uint64_t peak = status_kilobytes("VmHWM:");
  return (peak > resident_before) ? peak - resident_before : 0;
}

template <class Mesh>
Mesh midpoint_subdivision(const Mesh& mesh)
{
  Mesh fine;
  fine.reserve(mesh.number_of_vertices() + mesh.number_of_edges(),
               2 * mesh.number_of_edges() + 3 * mesh.number_of_faces(), 4 * mesh.number_of_faces());
  // The old vertices keep their numbers.
  std::vector<typename Mesh::Vertex_index> old_vertex(mesh.num_vertices()), middle(mesh.num_edges());
  for(typename Mesh::Vertex_index v : mesh.vertices())
  {
    old_vertex[v] = fine.add_vertex(mesh.point(v));
  }
  for(typename Mesh::Edge_index e : mesh.edges())
  {
    middle[e] = fine.add_vertex(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  }
  for(typename Mesh::Face_index f : mesh.faces())
  {
    std::array<typename Mesh::Vertex_index, 3> corner, opposite;
    typename Mesh::Halfedge_index h = mesh.halfedge(f);
    for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
    {
      corner[i] = old_vertex[mesh.source(h)];
      opposite[i] = middle[mesh.edge(h)];
    }
    fine.add_face(corner[0], opposite[0], opposite[2]);
    fine.add_face(corner[1], opposite[1], opposite[0]);
    fine.add_face(corner[2], opposite[2], opposite[1]);
    fine.add_face(opposite[0], opposite[1], opposite[2]);
  }
  return fine;
}

// Reads the only mesh of a measuring process. Returns the exit code, 0 for success.
template <class Mesh>
int read_wanted_mesh(const Settings& settings, Mesh& mesh)
{
  if(!CGAL::IO::read_polygon_mesh(settings.meshes.front(), mesh) || mesh.number_of_faces() == 0)
  {
    return cannot_read;
  }
  if(mesh.number_of_faces() < settings.minimum_faces || !CGAL::is_triangle_mesh(mesh))
  {
    return not_wanted;
  }
  for(std::size_t i = 0; i < settings.subdivisions; ++i)
  {
    mesh = midpoint_subdivision(mesh);
  }
  return 0;
}

inline bool write_all(int file, const void* data, std::size_t size)
{
  const char* position = static_cast<const char*>(data);
  while(size > 0)
  {
    const ssize_t written = ::write(file, position, size);
    if(written <= 0)
    {
      return false;
    }
    position += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

// Sends a report and the answers of a method to the process that compares, and ends this process without destructors,
// which only take time.
template <class Report>
[[noreturn]] void send_and_exit(const Settings& settings, const Report& report, const std::vector<double>& answers)
{
  static_assert(std::is_trivially_copyable<Report>::value, "a report is sent as it is stored");
  const std::uint64_t size = answers.size();
  const bool sent = write_all(settings.pipe_end, &report, sizeof(report)) &&
                    write_all(settings.pipe_end, &size, sizeof(size)) &&
                    write_all(settings.pipe_end, answers.data(), answers.size() * sizeof(double));
  std::fflush(nullptr);
  ::_exit(sent ? 0 : method_failed);
}

// ---------------------------------------------------------------------------------------------------------------------
// The process that compares
// ---------------------------------------------------------------------------------------------------------------------

inline bool read_all(int file, void* data, std::size_t size)
{
  char* position = static_cast<char*>(data);
  while(size > 0)
  {
    const ssize_t got = ::read(file, position, size);
    if(got <= 0)
    {
      return false;
    }
    position += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

// The command line of a measuring process, which reports through the given end of a pipe.
inline std::vector<std::string> arguments_of_measurement(const Settings& settings, int report_end,
                                                         const std::string& mesh, const std::string& method,
                                                         const std::vector<std::string>& own_options)
{
  std::vector<std::string> arguments = {"benchmark",
                                        "--measure",
                                        std::to_string(report_end),
                                        "--method",
                                        method,
                                        "--kernel",
                                        settings.kernel,
                                        "--clock",
                                        settings.clock,
                                        "--subdivide",
                                        std::to_string(settings.subdivisions),
                                        "--minimum-faces",
                                        std::to_string(settings.minimum_faces)};
  arguments.insert(arguments.end(), own_options.begin(), own_options.end());
  arguments.push_back(mesh);
  return arguments;
}

// Runs this program again in the child process, with limits of time and memory, which survive exec(). Does not return.
[[noreturn]] inline void become_measurement(const Settings& settings, std::vector<std::string>& arguments)
{
  std::vector<char*> argument_pointers;
  for(std::string& argument : arguments)
  {
    argument_pointers.push_back(&argument[0]);
  }
  argument_pointers.push_back(nullptr);
  ::alarm(static_cast<unsigned int>(settings.time_limit));
  if(settings.memory_limit > 0)
  {
    rlimit limit;
    limit.rlim_cur = limit.rlim_max = static_cast<rlim_t>(settings.memory_limit) << 20;
    ::setrlimit(RLIMIT_AS, &limit);
  }
  ::execv("/proc/self/exe", argument_pointers.data());
  ::_exit(method_failed);
}

// Reads a report and its answers. Returns whether both are complete.
template <class Report>
bool read_report(int end, Report& report, std::vector<double>& answers)
{
  std::uint64_t size = 0;
  if(!read_all(end, &report, sizeof(report)) || !read_all(end, &size, sizeof(size)))
  {
    return false;
  }
  answers.resize(size);
  return read_all(end, answers.data(), answers.size() * sizeof(double));
}

// Starts this program again for one measurement. Returns the exit code of that process; it is 0 if the report is
// complete.
template <class Report>
int run_measurement(const Settings& settings, const std::string& mesh, const std::string& method,
                    const std::vector<std::string>& own_options, Report& report, std::vector<double>& answers)
{
  int ends[2];
  if(::pipe(ends) != 0)
  {
    return method_failed;
  }
  std::vector<std::string> arguments = arguments_of_measurement(settings, ends[1], mesh, method, own_options);
  const pid_t child = ::fork();
  if(child < 0)
  {
    ::close(ends[0]);
    ::close(ends[1]);
    return method_failed;
  }
  if(child == 0)
  {
    ::close(ends[0]);
    become_measurement(settings, arguments);
  }
  ::close(ends[1]);
  const bool complete = read_report(ends[0], report, answers);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if(!WIFEXITED(status))
  {
    return method_failed;
  }
  return (WEXITSTATUS(status) == 0 && !complete) ? method_failed : WEXITSTATUS(status);
}

// Prints what an exit code other than 0 means. Returns whether the comparison leaves out this mesh.
inline bool is_skipped(int code, const std::string& mesh, const std::string& method)
{
  if(code == not_wanted)
  {
    std::cerr << "skipped: " << mesh << " (too small, or not a triangle mesh)" << std::endl;
    return true;
  }
  if(code == cannot_read)
  {
    std::cerr << "skipped: " << mesh << " (cannot be read as one surface)" << std::endl;
    return true;
  }
  std::cerr << "failed: " << method << " on " << mesh << std::endl;
  return false;
}

inline double median(std::vector<double> values)
{
  if(values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return (values.size() % 2 == 1) ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// The median of the ratios of adjacent runs: a machine that becomes slower for a while affects both methods alike.
inline double median_ratio(const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> ratios;
  for(std::size_t i = 0; i < (std::min)(a.size(), b.size()); ++i)
  {
    ratios.push_back(a[i] / b[i]);
  }
  return median(ratios);
}

// The largest |a - b| / b. Infinity if one method reaches a vertex that the other one does not.
inline double largest_relative_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  if(a.size() != b.size())
  {
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
  {
    if(a[i] == b[i])
    {
      continue;
    }
    const double difference = std::abs(a[i] - b[i]) / b[i];
    largest = (difference <= largest) ? largest
                                      : (std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference);
  }
  return largest;
}

// Formats a number; the result is empty if the number was not measured.
inline std::string cell(double number, int digits)
{
  if(std::isnan(number))
  {
    return "";
  }
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, number);
  return text;
}

inline std::string file_name(const std::string& path)
{
  return path.substr(path.find_last_of('/') + 1);
}

// ---------------------------------------------------------------------------------------------------------------------
// The machine
// ---------------------------------------------------------------------------------------------------------------------

inline std::string processor()
{
  std::ifstream in("/proc/cpuinfo");
  std::string line;
  while(std::getline(in, line))
  {
    if(line.compare(0, 10, "model name") == 0)
    {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown processor";
}

inline void print_machine(const Settings& settings)
{
  std::cout << "# machine: " << processor() << ", " << std::thread::hardware_concurrency() << " hardware threads\n"
#if defined(__clang__)
            << "# compiler: clang " << __clang_version__
#elif defined(__GNUC__)
            << "# compiler: g++ " << __VERSION__
#else
            << "# compiler: unknown"
#endif
            << ", flags: " << settings.flags << '\n'
#if defined(NDEBUG)
            << "# built: assertions off"
#else
            << "# built: ASSERTIONS ON"
#endif
#if defined(__OPTIMIZE__)
            << ", optimized"
#else
            << ", NOT OPTIMIZED"
#endif
            << '\n'
            << "# CGAL " << CGAL_VERSION_STR << ", kernel: "
            << (settings.kernel == "epick" ? "Exact_predicates_inexact_constructions_kernel"
                                           : "Simple_cartesian<double>")
            << " for all methods, one thread unless a column says otherwise\n";
}

#endif // BENCHMARK_SUPPORT_H
