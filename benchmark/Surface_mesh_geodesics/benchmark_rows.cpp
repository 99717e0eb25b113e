// Rows of the matrix of all distances between vertices, each pair once: what the order of the vertices saves. Prints
// one line of comma separated values per mesh and order. The first number is the processor time of a full row, to all
// vertices; the others are ratios to it: rows that end at their last target, and rows that are also pruned with
// landmarks, as the package computes them. The rows are evenly spread over the matrix.
//
// With --brain, a folded closed surface with 8,192 vertices is measured instead: all pairs within 100 mm.
//
// With --interleave N, N rows are propagated in turn by one thread, 256 visits each, instead: the ratio of the time to
// that of one row after the other.

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Private_access.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <queue>
#include <utility>

namespace Geodesics = CGAL::Surface_mesh_geodesics;
namespace internal = Geodesics::internal;

namespace {

using Solver = Geodesics::Geodesic_distance_solver<Benchmark_mesh>;
using Vertices = std::vector<Benchmark_vertex>;
using Matrix = internal::Distance_matrix<double>;

Vertices all_vertices(const Benchmark_mesh& mesh)
{
  Vertices result;
  for(const Benchmark_vertex v : vertices(mesh))
  {
    if(!mesh.is_isolated(v))
    {
      result.push_back(v);
    }
  }
  return result;
}

// --- orders ---

// From the outside to the first vertex.
Vertices breadth_first(const Benchmark_mesh& mesh)
{
  Vertices order;
  std::vector<bool> is_found(mesh.number_of_vertices(), false);
  for(const Benchmark_vertex first : all_vertices(mesh))
  {
    std::queue<Benchmark_vertex> waiting;
    const auto find = [&](Benchmark_vertex v)
    {
      if(!is_found[v])
      {
        is_found[v] = true;
        waiting.push(v);
      }
    };
    for(find(first); !waiting.empty(); waiting.pop())
    {
      order.push_back(waiting.front());
      for(const Benchmark_vertex v : vertices_around_target(mesh.halfedge(waiting.front()), mesh))
      {
        find(v);
      }
    }
  }
  return Vertices(order.rbegin(), order.rend());
}

Vertices along_Hilbert_curve(const Benchmark_mesh& mesh)
{
  Vertices order = all_vertices(mesh);
  using Points = Benchmark_mesh::Property_map<Benchmark_vertex, Benchmark_kernel::Point_3>;
  CGAL::hilbert_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Benchmark_kernel, Points>(mesh.points()));
  return order;
}

// Peels the surface from all sides: descending distance from a vertex whose farthest vertex is as near as possible,
// among 32 random ones.
Vertices farthest_from_center_first(const Benchmark_mesh& mesh)
{
  Solver solver(mesh);
  Vertices order = all_vertices(mesh);
  std::vector<double> best(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  const auto largest = [&](const std::vector<double>& distance)
  { return *std::max_element(distance.begin(), distance.end()); };
  Geodesics::geodesic_distance_matrix(solver, random_vertices(mesh, 32), vertices(mesh),
                                      [&](std::size_t, const std::vector<double>& row)
                                      {
                                        if(largest(row) < largest(best))
                                        {
                                          best = row;
                                        }
                                      });
  std::stable_sort(order.begin(), order.end(),
                   [&](Benchmark_vertex a, Benchmark_vertex b) { return best[a] > best[b]; });
  return order;
}

Vertices shuffled(const Benchmark_mesh& mesh)
{
  Vertices order = all_vertices(mesh);
  std::mt19937_64 random(20261124);
  for(std::size_t i = order.size(); i > 1; --i)
  {
    std::swap(order[i - 1], order[random() % i]);
  }
  return order;
}

// --- measurements ---

void measure_order(const Settings& settings, const std::string& prefix, const Solver& solver, const std::string& name,
                   const Vertices& order, std::size_t rows)
{
  const auto& surface = internal::Private_access::surface(solver);
  const Matrix matrix(surface.mesh(), surface.source_set_of_vertices(order, "source"), surface.copies());
  const std::vector<internal::Vertex_id>& ids = matrix.sources().vertices;
  const auto always = []() { return true; };
  std::unique_ptr<const Matrix::Landmarks> landmarks;
  matrix.find_landmarks(landmarks, always);
  const auto worker = matrix.make_worker();
  std::vector<double> row, full, ending, pruned;
  const auto time_of_rows = [&](const auto& fill_row)
  {
    return milliseconds_of(CLOCK_PROCESS_CPUTIME_ID, [&]()
    {
      for(std::size_t k = 0; k < rows; ++k)
      {
        fill_row((2 * k + 1) * ids.size() / (2 * rows));
      }
    });
  };
  const auto fill_all = [&](std::size_t i)
  { matrix.fill_dense_row(*worker, i, ids.data(), ids.data() + ids.size(), row, always); };
  const auto fill_rest = [&](std::size_t i) { matrix.fill_triangular_row(*worker, i, i, nullptr, row, always); };
  const auto fill_pruned
    = [&](std::size_t i) { matrix.fill_triangular_row(*worker, i, i, landmarks.get(), row, always); };
  for(std::size_t k = 0; k < settings.repetitions; ++k)
  {
    full.push_back(time_of_rows(fill_all));
    ending.push_back(time_of_rows(fill_rest) / full.back());
    pruned.push_back(time_of_rows(fill_pruned) / full.back());
  }
  std::cout << prefix << name << ',' << cell(median(full) / static_cast<double>(rows), 3) << ','
            << cell(median(ending), 3) << ',' << cell(median(pruned), 3) << std::endl;
}

void measure_orders(const Settings& settings, const std::string& prefix, const Benchmark_mesh& mesh, std::size_t rows)
{
  const Solver solver(mesh);
  measure_order(settings, prefix, solver, "of the file", all_vertices(mesh), rows);
  measure_order(settings, prefix, solver, "random", shuffled(mesh), rows);
  measure_order(settings, prefix, solver, "Hilbert curve", along_Hilbert_curve(mesh), rows);
  measure_order(settings, prefix, solver, "breadth first", breadth_first(mesh), rows);
  measure_order(settings, prefix, solver, "farthest from a center first", farthest_from_center_first(mesh), rows);
  measure_order(settings, prefix, solver, "peeled from an end",
                Geodesics::geodesic_peeling_order(solver, all_vertices(mesh)), rows);
}

// One after the other and in turn, alternating; the sources of neighboring rows are neighbors in the order of peeling.
void measure_interleaving(const Settings& settings, const std::string& prefix, const Benchmark_mesh& mesh,
                          std::size_t rows, std::size_t number)
{
  using Propagation = internal::Distance_propagation<double>;
  const Solver solver(mesh);
  const auto& surface = internal::Private_access::surface(solver);
  const std::vector<internal::Vertex_id> ids = surface.checked_ids(
    Geodesics::geodesic_peeling_order(solver, all_vertices(mesh)), "vertex");
  std::vector<internal::Vertex_distance_field<double>> fields(number);
  std::vector<std::unique_ptr<Propagation>> propagations;
  for(auto& field : fields)
  {
    propagations.push_back(std::make_unique<Propagation>(surface.mesh(), field));
  }
  const auto time_of_rows = [&](std::size_t slice)
  {
    return milliseconds_of(CLOCK_PROCESS_CPUTIME_ID, [&]()
    {
      for(std::size_t first = 0; first + number <= rows; first += number)
      {
        for(std::size_t k = 0; k < number; ++k)
        {
          propagations[k]->restart();
          propagations[k]->add_source(ids[ids.size() / (rows + 1) * (first + 1) + k], 0);
        }
        std::vector<bool> is_complete(number, false);
        for(std::size_t left = number, k = 0; left > 0; k = (k + 1) % number)
        {
          std::size_t visits = 0;
          if(!is_complete[k] && propagations[k]->run([&](std::size_t, double) { return visits++ < slice; }))
          {
            is_complete[k] = true;
            --left;
          }
        }
      }
    });
  };
  std::vector<double> times, ratios;
  for(std::size_t k = 0; k < settings.repetitions; ++k)
  {
    times.push_back(time_of_rows(std::size_t(-1)));
    ratios.push_back(time_of_rows(256) / times.back());
  }
  std::cout << prefix << number << ',' << cell(median(times) / static_cast<double>(rows), 3) << ','
            << cell(median(ratios), 3) << std::endl;
}

// A closed surface with 8,192 vertices, of the size of a hemisphere of a brain in mm, with folds.
Benchmark_mesh folded_sphere()
{
  const std::size_t rings = 90, segments = 91;
  const double pi = 3.14159265358979323846;
  Benchmark_mesh mesh;
  const auto add_vertex = [&](double polar, double azimuth)
  {
    const double radius = 55 * (1 + .12 * std::sin(9 * polar + 2 * std::sin(3 * azimuth)) * std::sin(polar)
                                + .08 * std::sin(13 * azimuth + 3 * polar) * std::sin(polar));
    return mesh.add_vertex(Benchmark_kernel::Point_3(1.5 * radius * std::cos(polar),
                                                     radius * std::sin(polar) * std::cos(azimuth),
                                                     .8 * radius * std::sin(polar) * std::sin(azimuth)));
  };
  Vertices v;
  for(std::size_t i = 0; i < rings; ++i)
  {
    for(std::size_t j = 0; j < segments; ++j)
    {
      v.push_back(add_vertex(pi * (static_cast<double>(i) + 1) / static_cast<double>(rings + 1),
                             2 * pi * static_cast<double>(j) / static_cast<double>(segments)));
    }
  }
  const Benchmark_vertex north = add_vertex(0, 0), south = add_vertex(pi, 0);
  const auto at = [&](std::size_t i, std::size_t j) { return v[i * segments + j % segments]; };
  for(std::size_t j = 0; j < segments; ++j)
  {
    mesh.add_face(north, at(0, j), at(0, j + 1));
    mesh.add_face(south, at(rings - 1, j + 1), at(rings - 1, j));
    for(std::size_t i = 0; i + 1 < rings; ++i)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return mesh;
}

bool measure_brain(const Settings& settings)
{
  const Benchmark_mesh mesh = folded_sphere();
  std::size_t entries = 0;
  const Spread time = repeated(settings, CLOCK_MONOTONIC, [&]()
  {
    entries = 0;
    Geodesics::sparse_geodesic_distance_matrix(
      mesh, vertices(mesh), vertices(mesh), 100.,
      [&](std::size_t, const std::vector<std::pair<std::size_t, double>>& row) { entries += row.size(); });
  });
  std::cout << "folded sphere," << mesh.number_of_faces() << ',' << mesh.number_of_vertices() << ",100,"
            << cell(static_cast<double>(entries) / static_cast<double>(mesh.number_of_vertices()), 1) << ','
            << cell(time.middle / 1000, 2) << std::endl;
  return entries > mesh.number_of_vertices();
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  std::size_t rows = 60, interleaved = 0;
  bool is_brain = false;
  if(!read_settings(argc, argv, settings, [&](const std::string& option, const std::string& value) {
       is_brain = is_brain || option == "--brain";
       return option == "--brain" || read_number_option(option, value, "--rows", rows)
              || read_number_option(option, value, "--interleave", interleaved);
     })
     && !is_brain)
  {
    return usage(argv[0], " mesh...   (--rows N: rows measured, 60; --interleave N; --brain 1)");
  }
  if(is_brain)
  {
    print_head(settings, "all pairs within 100 mm, clock time of one thread in s",
               "mesh,faces,vertices,radius_mm,entries_per_row,seconds");
    return measure_brain(settings) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  print_head(settings, "rows of all distances, processor times",
             interleaved > 0 ? "mesh,subdivisions,faces,rows_in_turn,ms_per_row,in_turn_to_one_by_one"
                             : "mesh,subdivisions,faces,order,ms_per_full_row,ending_to_full,pruned_to_full");
  for(const std::string& file : settings.meshes)
  {
    Benchmark_mesh mesh;
    if(!read_mesh(file, settings.subdivisions, mesh))
    {
      return EXIT_FAILURE;
    }
    const std::string prefix = file_name(file) + ',' + std::to_string(settings.subdivisions) + ','
                               + std::to_string(mesh.number_of_faces()) + ',';
    if(interleaved > 0)
      measure_interleaving(settings, prefix, mesh, rows, interleaved);
    else
      measure_orders(settings, prefix, mesh, rows);
  }
  return EXIT_SUCCESS;
}
