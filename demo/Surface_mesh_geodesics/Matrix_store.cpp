#include "Matrix_store.h"

#include "Command_error.h"
#include "Face_marks.h"
#include "Input_file.h"
#include "Mpi_job.h"
#include "Obstacle_option.h"
#include "Row_progress.h"
#include "number_arguments.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_mpi.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace geodesics_demo {

namespace po = boost::program_options;
namespace fs = std::filesystem;

using CGAL::Surface_mesh_geodesics::Geodesic_distance_matrix_store;
using CGAL::Surface_mesh_geodesics::Geodesic_matrix_store_check;
using CGAL::Surface_mesh_geodesics::Geodesic_matrix_store_error;
using CGAL::Surface_mesh_geodesics::Geodesic_matrix_store_status;

namespace {

using Tag = CGAL::Parallel_if_available_tag; // the rows do not depend on the tag

const char* const options_of_stores[]
  = {"rows", "float32", "symmetric", "peel", "resume", "memory", "shard-rows", "meshes", "mpi"};

// --- arguments ---

// "A:B".
bool parse_rows(const std::string& text, std::size_t& first, std::size_t& end)
{
  const std::vector<std::string> parts = split(text, ':');
  return parts.size() == 2 && parse_index(parts[0], first) && parse_index(parts[1], end) && first <= end;
}

// A number of bytes, with K, M or G for powers of 1024.
bool parse_bytes(std::string text, std::size_t& bytes)
{
  const std::string units = "KMG";
  const std::size_t unit = text.empty() ? std::string::npos : units.find(text.back());
  if(unit != std::string::npos)
    text.pop_back();
  const std::size_t shift = unit == std::string::npos ? 0 : 10 * (unit + 1);
  if(!parse_index(text, bytes) || bytes == 0 || bytes > (std::numeric_limits<std::size_t>::max)() >> shift)
    return false;
  bytes <<= shift;
  return true;
}

template <typename Check>
po::typed_value<std::string>* checked_value(const char* option, const char* wanted, const Check& check)
{
  return po::value<std::string>()->notifier([=](const std::string& text)
  {
    if(!check(text))
      throw Command_error(Exit_code::BAD_USAGE, std::string("--") + option + ": '" + text + "' is not " + wanted);
  });
}

auto store_parameters(const Arguments& arguments, const std::string& mesh_name, bool compare_checksums)
{
  std::size_t first = 0, end = (std::numeric_limits<std::size_t>::max)(), memory = std::size_t(64) << 20;
  if(has(arguments, "rows"))
    parse_rows(arguments["rows"].as<std::string>(), first, end);
  if(has(arguments, "memory"))
    parse_bytes(arguments["memory"].as<std::string>(), memory);
  const double infinity = std::numeric_limits<double>::infinity();
  return CGAL::parameters::use_float32(has(arguments, "float32"))
    .use_symmetry(has(arguments, "symmetric"))
    .maximum_distance(positive_argument_or(arguments, "radius", infinity))
    .rows_per_shard(count_argument_or(arguments, "shard-rows", 0))
    .first_row(first)
    .end_row(end)
    .memory_limit(memory)
    .mesh_name(mesh_name)
    .compare_checksums(compare_checksums);
}

// Whatever goes wrong with a folder, as the program reports it.
template <typename Function>
void with_store_errors(const Function& function)
{
  using Reason = Geodesic_matrix_store_error::Reason;
  try
  {
    function();
  }
  catch(const Geodesic_matrix_store_error& error)
  {
    const Reason reason = error.reason();
    throw Command_error(reason == Reason::FILE_ERROR       ? Exit_code::BAD_OUTPUT
                        : reason == Reason::INVALID_OPTION ? Exit_code::BAD_USAGE
                        : reason == Reason::NOT_STORED || reason == Reason::DAMAGED
                            || reason == Reason::NOT_REPRESENTABLE
                          ? Exit_code::NO_RESULT
                          : Exit_code::BAD_INPUT,
                        error.what());
  }
}

// --- storing ---

void print(const Geodesic_matrix_store_status& status)
{
  std::cout << "rows,rows_done,shards,shards_done,shards_in_work\n"
            << status.rows << ',' << status.rows_done << ',' << status.shards << ',' << status.shards_done << ','
            << status.shards_in_work << '\n';
}

// Prints the status of a call that has ended. What it has left to others is missing: a program that goes on with the
// matrix must not take it for a whole one. Rows without a shard are no mistake: an array job may have more tasks than
// there are rows.
void print_end(const Geodesic_matrix_store_status& status, const Arguments& arguments, const Console& console)
{
  print(status);
  if(!status.is_complete())
    throw Command_error(Exit_code::NO_RESULT,
                        "missing rows: " + std::to_string(status.rows - status.rows_done)
                          + ", shards that other processes have locked: " + std::to_string(status.shards_in_work)
                          + "; --resume computes what is missing when these have ended");
  if(status.shards == 0 && has(arguments, "rows"))
    console.note("no shard begins in the rows " + arguments["rows"].as<std::string>() + ": nothing was computed");
}

// Computes with sources in the form that the package takes: all are vertices, or all are locations in faces.
template <typename Sources, typename Parameters>
Geodesic_matrix_store_status store(const Mesh& mesh, const Sources& sources, const std::vector<Vertex>& targets,
                                   const Obstacles& avoided, const std::string& folder,
                                   const Parameters& parameters, const Mpi_job* job, Row_progress& progress)
{
  const auto np = parameters.visitor(std::ref(progress)).faces_to_avoid(avoided.faces)
                    .edges_to_avoid(avoided.walls);
#ifdef CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI
  if(job != nullptr)
    return CGAL::Surface_mesh_geodesics::store_geodesic_distance_matrix_mpi<Tag>(job->world(), mesh, sources, targets,
                                                                                 folder, np);
#endif
  static_cast<void>(job);
  return CGAL::Surface_mesh_geodesics::store_geodesic_distance_matrix<Tag>(mesh, sources, targets, folder, np);
}

Geodesic_matrix_store_status store(const std::string& mesh_name, const Mesh& mesh, const std::string& folder,
                                   const Arguments& arguments, const Place_finder& find_places, const Mpi_job* job,
                                   const Console& console, bool compare_checksums = true)
{
  Matrix_places places = find_places(mesh);
  std::error_code error; // an absolute name: --verify finds it from any folder
  const auto parameters
    = store_parameters(arguments, fs::absolute(mesh_name, error).string(), compare_checksums);
  const Obstacles avoided = obstacles(arguments, mesh);
  Row_progress progress(console);
  std::vector<Vertex> vertices = as_vertices(places.sources);
  if(has(arguments, "peel") && vertices == places.targets) // others are rejected, as not symmetric
  {
    vertices = CGAL::Surface_mesh_geodesics::geodesic_peeling_order(
      mesh, vertices, CGAL::parameters::faces_to_avoid(avoided.faces).edges_to_avoid(avoided.walls));
    places.targets = vertices;
  }
  if(!vertices.empty())
    return store(mesh, vertices, places.targets, avoided, folder, parameters, job, progress);
  return store(mesh, as_face_locations(places.sources, mesh), places.targets, avoided, folder, parameters, job,
               progress);
}

// Without --resume, a matrix that is there already is a mistake; an array job, whose tasks have rows, makes it at some
// time.
void check_is_new(const std::string& folder, const Arguments& arguments)
{
  if(!has(arguments, "resume") && !has(arguments, "rows") && fs::exists(fs::path(folder) / "manifest.json"))
    throw Command_error(Exit_code::BAD_USAGE,
                        folder + ": the folder has a matrix; --resume computes what is missing of it");
}

// The names in a file, one in a line; blanks around them and lines with # do not count. The largest file comes first,
// so that little is left to do when the last mesh begins.
std::vector<std::string> meshes_of_list(const std::string& list)
{
  std::ifstream is = opened_text_file(list);
  std::vector<std::pair<std::uintmax_t, std::string>> meshes;
  for(std::string line; std::getline(is, line);)
  {
    const std::size_t begin = line.find_first_not_of(" \t\r"), end = line.find_last_not_of(" \t\r");
    if(begin == std::string::npos || line[begin] == '#')
      continue;
    const std::string name = line.substr(begin, end - begin + 1);
    check_is_readable(name);
    std::error_code error;
    meshes.emplace_back(fs::file_size(name, error), name);
  }
  std::stable_sort(meshes.begin(), meshes.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> names;
  for(const auto& mesh : meshes)
    names.push_back(mesh.second);
  return names;
}

// A folder for each mesh, with the name of the mesh.
std::vector<std::string> folders_of_meshes(const std::vector<std::string>& names, const Arguments& arguments)
{
  std::vector<std::string> folders;
  for(const std::string& name : names)
  {
    const fs::path stem = fs::path(name).stem();
    if(stem.empty() || stem == "." || stem == "..")
      throw Command_error(Exit_code::BAD_USAGE, name + ": the name of the file gives no name for a folder");
    folders.push_back((fs::path(arguments["store"].as<std::string>()) / stem).string());
    if(std::find(folders.begin(), folders.end() - 1, folders.back()) != folders.end() - 1)
      throw Command_error(Exit_code::BAD_USAGE, "two meshes of the list would have the folder " + folders.back());
  }
  return folders;
}

// The status of all folders.
Geodesic_matrix_store_status sum_of_stores(const std::vector<std::string>& folders)
{
  Geodesic_matrix_store_status sum;
  for(const std::string& folder : folders)
  {
    const Geodesic_matrix_store_status status = Geodesic_distance_matrix_store(folder).status();
    sum.rows += status.rows;
    sum.rows_done += status.rows_done;
    sum.shards += status.shards;
    sum.shards_done += status.shards_done;
    sum.shards_in_work += status.shards_in_work;
  }
  return sum;
}

// Calls function(), and returns what is wrong with the mesh, or with its matrix; an empty text if nothing is. What the
// next mesh would suffer from, too, passes through.
template <typename Function>
std::string fault_of_mesh(const Function& function)
{
  try
  {
    with_store_errors(function);
  }
  catch(const Command_error& error)
  {
    if(error.code() != Exit_code::BAD_INPUT && error.code() != Exit_code::NO_RESULT)
      throw;
    return error.what();
  }
  catch(const CGAL::Surface_mesh_geodesics::Invalid_geodesic_input& error)
  {
    return error.what();
  }
  return "";
}

// Each process of a job begins with meshes of its own, so that it reads few and checks few files. When it is through
// with them, it helps the others: the locks of shards make sure that each shard is computed once. A process alone, or
// one of several that know nothing of each other, does the first part with all meshes.
//
// A mesh with a fault is left out, and the program ends with an error when the others are done.
void store_meshes(const Arguments& arguments, const Place_finder& find_places, const Mpi_job* job,
                  const Console& console)
{
  const std::vector<std::string> names = meshes_of_list(arguments["meshes"].as<std::string>());
  const std::vector<std::string> folders = folders_of_meshes(names, arguments);
  const std::size_t rank = job == nullptr ? 0 : static_cast<std::size_t>(job->rank());
  const std::size_t ranks = job == nullptr ? 1 : static_cast<std::size_t>(job->size());
  if(rank == 0)
    for(const std::string& folder : folders)
      check_is_new(folder, arguments);
  if(job != nullptr)
    job->wait_for_all(); // before the first folder is made
  std::size_t number_of_faults = 0;
  std::vector<char> is_complete(names.size(), true);
  const auto store_mesh = [&](std::size_t k, bool compare_checksums)
  {
    const std::string fault = fault_of_mesh([&]()
    {
      is_complete[k] = store(names[k], read_mesh(names[k], console), folders[k], arguments, find_places, nullptr,
                             console, compare_checksums)
                         .is_complete();
    });
    if(!fault.empty() && compare_checksums)
    {
      ++number_of_faults;
      Console(false).note(fault + (fault.find(names[k]) == 0 ? "" : " (" + names[k] + ")"));
    }
  };
  for(std::size_t k = rank; k < names.size(); k += ranks)
    store_mesh(k, true);
  for(std::size_t i = 0; job != nullptr && i < names.size(); ++i)
  {
    const std::size_t k = (rank + i) % names.size(); // not all help with the same mesh
    if(!fs::exists(fs::path(folders[k]) / "manifest.json")
       || !Geodesic_distance_matrix_store(folders[k]).status().is_complete())
      store_mesh(k, false);
  }
  if(job != nullptr)
    job->wait_for_all();
  // What this process has left to others may be a damaged shard that they have not replaced.
  for(std::size_t k = 0; k < names.size(); ++k)
    if(!is_complete[k] && !Geodesic_distance_matrix_store(folders[k]).damaged_shards().empty())
      throw Command_error(Exit_code::NO_RESULT, folders[k] + ": other processes have locked damaged shards; --resume "
                                                             "computes them again when these have ended");
  if(number_of_faults > 0)
    throw Command_error(Exit_code::BAD_INPUT, std::to_string(number_of_faults) + " of the meshes have faults");
  if(rank == 0)
    print_end(sum_of_stores(folders), arguments, console);
}

void store_one(const Arguments& arguments, const Place_finder& find_places, const Console& console)
{
  const std::string folder = arguments["store"].as<std::string>();
  check_is_new(folder, arguments);
  print_end(store(mesh_argument(arguments), read_mesh(arguments, console), folder, arguments, find_places, nullptr,
                  console),
            arguments, console);
}

// The same by all processes of a job. Rank 0 speaks for all.
void store_in_job(const Arguments& arguments, const Place_finder& find_places, const Mpi_job& job,
                  const Console& console)
{
  const Console silent(true);
  const Console& own_console = job.rank() == 0 ? console : silent;
  if(has(arguments, "meshes"))
  {
    store_meshes(arguments, find_places, &job, own_console);
    return;
  }
  const std::string name = mesh_argument(arguments), folder = arguments["store"].as<std::string>();
  const auto read = [&]()
  {
    check_is_new(folder, arguments);
    return read_marked_polygons(arguments, own_console);
  };
  const Geodesic_matrix_store_status status
    = store(name, job.mesh(name, read, own_console), folder, arguments, find_places, &job, own_console);
  if(job.rank() == 0)
    print_end(status, arguments, own_console);
}

// --- checking ---

// Single precision rounds each distance by 2^-24.
double tolerance(const Geodesic_distance_matrix_store& matrix)
{
  return matrix.uses_float32() ? 0x1p-21 : 0x1p-40;
}

void verify(const Arguments& arguments, const Console& console)
{
  const std::string folder = arguments["verify"].as<std::string>();
  const Geodesic_distance_matrix_store matrix(folder);
  const Geodesic_matrix_store_status status = matrix.status();
  const std::vector<std::pair<std::size_t, std::size_t>> damaged = matrix.damaged_shards();
  for(const std::pair<std::size_t, std::size_t>& rows : damaged)
    console.note("the shard of the rows " + std::to_string(rows.first) + ':' + std::to_string(rows.second)
                 + " is damaged; --resume computes it again");
  if(status.shards_done == 0 && status.shards > 0)
    throw Command_error(Exit_code::NO_RESULT, folder + ": nothing is stored that could be checked");
  std::cout << "check,number,failures,worst\n"
            << "checksums of shards," << status.shards_done << ',' << damaged.size() << ",\n";
  if(!damaged.empty())
    throw Command_error(Exit_code::NO_RESULT, folder + ": some shards are damaged");
  const std::string mesh_name = has(arguments, "mesh") ? mesh_argument(arguments) : matrix.mesh_name();
  if(mesh_name.empty())
    throw Command_error(Exit_code::BAD_USAGE, folder + ": the folder names no mesh; give the file of the mesh");
  const Geodesic_matrix_store_check check
    = CGAL::Surface_mesh_geodesics::check_geodesic_distance_matrix(read_mesh(mesh_name, console), folder);
  const double limit = tolerance(matrix);
  std::cout << "rows computed anew," << check.rows_compared << ',' << check.rows_different << ",\n"
            << "symmetry of pairs," << check.pairs_compared << ',' << (check.worst_asymmetry > limit ? 1 : 0) << ','
            << check.worst_asymmetry << '\n'
            << "triangle inequalities," << check.triangles_checked << ','
            << (check.worst_triangle_violation > limit ? 1 : 0) << ',' << check.worst_triangle_violation << '\n';
  if(check.rows_different > 0 || check.worst_asymmetry > limit || check.worst_triangle_violation > limit)
    throw Command_error(Exit_code::NO_RESULT, folder + ": the distances are not those of the mesh " + mesh_name);
}

} // namespace

void declare_matrix_store(Option_descriptions& options)
{
  options.add_options()
    ("store", po::value<std::string>()->value_name("FOLDER"),
     "write the matrix to a folder of NumPy files that other calls complete, instead of a table")
    ("rows", checked_value("rows", "A:B with whole numbers A and B, such as 0:1000",
                           [](const std::string& text) { std::size_t a = 0, b = 0; return parse_rows(text, a, b); })
               ->value_name("A:B"),
     "only the shards whose first row is at least A and less than B, for the tasks of an array job")
    ("float32", "store numbers of 32 bits: distances are rounded to the nearest one")
    ("symmetric", "store distances of different sources only, and each pair once: half of the space. Rows take less "
                  "time only with --peel")
    ("peel", "with --symmetric: sort the vertices so that rows take less time; the manifest lists them in this order")
    ("resume", "compute what is missing of the matrix in the folder")
    ("memory", checked_value("memory", "a number of bytes, such as 500M or 2G",
                             [](const std::string& text) { std::size_t n = 0; return parse_bytes(text, n); })
                 ->value_name("M"),
     "the memory for rows that are not written yet, in bytes, or with K, M or G (default: 64M)")
    ("shard-rows", count_value("shard-rows", 1)->value_name("N"), "the number of rows of a shard (default: by size)")
    ("meshes", po::value<std::string>()->value_name("LIST"),
     "instead of MESH: a file with the names of meshes, one in a line; each gets a folder in FOLDER")
    ("mpi", "share the work with the other processes that mpirun has started")
    ("status", po::value<std::string>()->value_name("FOLDER"), "tell how much of a stored matrix is done")
    ("verify", po::value<std::string>()->value_name("FOLDER"),
     "check a stored matrix: its checksums, and samples of its rows with the mesh that the folder names, or with MESH");
}

bool works_on_stored_matrix(const Arguments& arguments)
{
  return has(arguments, "store") || has(arguments, "status") || has(arguments, "verify");
}

void check_matrix_store_options(const Arguments& arguments)
{
  for(const char* const option : options_of_stores)
    if(has(arguments, option) && !has(arguments, "store"))
      throw Command_error(Exit_code::BAD_USAGE, std::string("--") + option + " needs --store");
  for(const std::string option : {"avoid", "avoid-property"})
  {
    if((has(arguments, "status") || has(arguments, "verify")) && has(arguments, option))
      throw Command_error(Exit_code::BAD_USAGE, "a stored matrix tells the faces to avoid: no --" + option);
    if(has(arguments, "meshes") && has(arguments, option))
      throw Command_error(Exit_code::BAD_USAGE, "--" + option + " names the faces of one mesh: not with --meshes");
  }
  if((has(arguments, "status") || has(arguments, "verify")) && has(arguments, "walls"))
    throw Command_error(Exit_code::BAD_USAGE, "a stored matrix tells the edges to avoid: no --walls");
  if(has(arguments, "meshes") && has(arguments, "walls"))
    throw Command_error(Exit_code::BAD_USAGE, "--walls names the edges of one mesh: not with --meshes");
  if(has(arguments, "store") && arguments["store"].as<std::string>().empty())
    throw Command_error(Exit_code::BAD_USAGE, "--store needs the name of a folder");
  if(has(arguments, "status") && has(arguments, "mesh"))
    throw Command_error(Exit_code::BAD_USAGE, "with --status, no mesh can be given");
  if(has(arguments, "store") && has(arguments, "output"))
    throw Command_error(Exit_code::BAD_USAGE, "--store and --output exclude each other");
  if(works_on_stored_matrix(arguments) && has(arguments, "repair")) // --verify reads the file as it is
    throw Command_error(Exit_code::BAD_USAGE, "a stored matrix is that of the mesh in its file: no --repair");
  if(has(arguments, "store") && mesh_argument(arguments) == "-")
    throw Command_error(Exit_code::BAD_USAGE, "a stored matrix names the file of its mesh: not -");
  if(has(arguments, "symmetric") && (has(arguments, "radius")))
    throw Command_error(Exit_code::BAD_USAGE, "--symmetric and --radius exclude each other");
  if(has(arguments, "peel") && !has(arguments, "symmetric"))
    throw Command_error(Exit_code::BAD_USAGE, "--peel needs --symmetric");
  if(has(arguments, "meshes") && (has(arguments, "rows") || has(arguments, "mesh")))
    throw Command_error(Exit_code::BAD_USAGE, "with --meshes, no mesh and no --rows can be given");
  if(has(arguments, "store") + has(arguments, "status") + has(arguments, "verify") > 1)
    throw Command_error(Exit_code::BAD_USAGE, "--store, --status and --verify exclude each other");
}

void run_on_stored_matrix(const Arguments& arguments, const Place_finder& find_places, const Console& console)
{
  with_store_errors([&]()
  {
    if(has(arguments, "status"))
      print(Geodesic_distance_matrix_store(arguments["status"].as<std::string>()).status());
    else if(has(arguments, "verify"))
      verify(arguments, console);
    else if(has(arguments, "mpi"))
      run_mpi_job([&](const Mpi_job& job)
                  { with_store_errors([&]() { store_in_job(arguments, find_places, job, console); }); });
    else if(has(arguments, "meshes"))
      store_meshes(arguments, find_places, nullptr, console);
    else
      store_one(arguments, find_places, console);
  });
}

} // namespace geodesics_demo
