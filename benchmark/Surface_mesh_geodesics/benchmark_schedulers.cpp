// The schedules and the variants of the thesis (chapter 4) on the windows of this package: FTP, OPFTP, VTP and OPVTP,
// each with and without the rules for pairs of windows ("trimming"), and VTP-Exhaustive, VTP-Trimming and VTP-CH. All
// distances from vertex 0, on each mesh and on decimated versions with about a quarter and a half of its edges.
//
// Standard output gets one line of comma separated values per mesh and variant, and then the figures of the thesis in
// the same columns. Ratios are to VTP with trimming on the same mesh; those of times are medians of the ratios of
// adjacent runs. Times are those of the propagation alone, without reading the mesh. Standard error gets tables 4.1 to
// 4.5 with our ratios below those of the thesis; the meshes are different ones (thesis_tables.h).
//
// "Package" is Distance_propagation, whose distances are those expected. FTP-List is FTP with another queue key. The
// program fails if a distance of any variant differs from the expected one by more than 1e-12, relative.
//
// VTP-MMP, in the rest of table 4.3, has no counterpart: it keeps the windows of all edges and trims against them.

#include "Scheduled_propagation.h"
#include "benchmark_surface.h"
#include "decimated_mesh.h"
#include "runs_in_process.h"
#include "thesis_tables.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>

#include <functional>
#include <iomanip>
#include <limits>
#include <sstream>

namespace {

namespace geodesics = CGAL::Surface_mesh_geodesics::internal;
using CGAL::Surface_mesh_geodesics::Propagation_statistics;
using Intrinsic_mesh = geodesics::Intrinsic_mesh<double>;
using Field = geodesics::Vertex_distance_field<double>;

const double largest_difference_allowed = 1e-12;
const double parts[] = {.25, .5, 1.};

// --- runs ------------------------------------------------------------------------------------------------------------

struct Row
{
  std::string mesh;
  std::size_t faces;
  std::string variant, trimming;
  Spread milliseconds;
  double time_ratio;
  Propagation_statistics statistics;
  double windows_ratio, peak_ratio, difference;
};

// A variant and how it computes the distances from a vertex.
struct Variant
{
  std::string name, trimming;
  std::function<Propagation_statistics(const Intrinsic_mesh&, Field&, geodesics::Vertex_id)> run;
};

template <class Propagation>
Propagation_statistics run(const Intrinsic_mesh& mesh, Field& field, geodesics::Vertex_id source)
{
  Propagation propagation(mesh, field);
  propagation.add_source(source, 0.);
  propagation.run();
  return propagation.statistics();
}

template <class Rules>
Propagation_statistics run_package(const Intrinsic_mesh& mesh, Field& field, geodesics::Vertex_id source)
{
  geodesics::Distance_propagation<double, Rules> propagation(mesh, field);
  propagation.add_source(source, 0.);
  propagation.run([](std::size_t, double) { return true; });
  return propagation.statistics();
}

// The first one is the one whose distances are expected, the second one the one that ratios refer to.
std::vector<Variant> all_variants()
{
  using namespace schedulers;
  return {{"package", "yes", run_package<geodesics::All_pruning_rules>},
          {"VTP", "yes", run<Vtp<double>>},
          {"OPVTP", "yes", run<Order_preserving_vtp<double>>},
          {"FTP", "yes", run<Ftp<double>>},
          {"OPFTP", "yes", run<Order_preserving_ftp<double>>},
          {"FTP-List", "yes", run<Ftp_by_lists<double>>},
          {"package", "no", run_package<Rules_without_pairs>},
          {"VTP", "no", run<Vtp<double, Without_pairs>>},
          {"OPVTP", "no", run<Order_preserving_vtp<double, Without_pairs>>},
          {"FTP", "no", run<Ftp<double, Without_pairs>>},
          {"OPFTP", "no", run<Order_preserving_ftp<double, Without_pairs>>},
          {"FTP-List", "no", run<Ftp_by_lists<double, Without_pairs>>},
          {"VTP-Exhaustive", "all pairs", run<Vtp<double, Exhaustive_pruning>>},
          {"VTP-Trimming", "bisectors", run<Vtp<double, Bisector_trimming>>},
          {"VTP-CH", "one split", run<Vtp<double, One_split_for_each_angle>>}};
}

// Measures all variants in turn, so that what slows the machine down for a while slows all of them down.
std::vector<Row> measure(const Settings& settings, const std::string& file, const Benchmark_mesh& mesh)
{
  const Benchmark_surface surface = surface_of(mesh);
  const geodesics::Vertex_id source = surface.id(*mesh.vertices().begin());
  const std::vector<Variant> variants = all_variants();
  std::vector<Row> rows(variants.size());
  std::vector<std::vector<double>> times(variants.size());
  std::vector<double> expected;
  for(std::size_t repetition = 0; repetition < settings.repetitions; ++repetition)
  {
    for(std::size_t i = 0; i < variants.size(); ++i)
    {
      Field field;
      times[i].push_back(milliseconds_of(
        settings.clock_id(), [&]() { rows[i].statistics = variants[i].run(surface.mesh(), field, source); }));
      if(expected.empty())
      {
        expected = field.distance;
      }
      rows[i].difference = largest_relative_difference(field.distance, expected);
    }
  }
  const auto ratio = [](std::size_t a, std::size_t b) { return static_cast<double>(a) / static_cast<double>(b); };
  for(std::size_t i = 0; i < variants.size(); ++i)
  {
    Row& row = rows[i];
    row.mesh = file_name(file);
    row.faces = mesh.number_of_faces();
    row.variant = variants[i].name;
    row.trimming = variants[i].trimming;
    row.milliseconds = Spread(times[i]);
    row.time_ratio = median_ratio(times[i], times[1]);
    row.windows_ratio = ratio(row.statistics.windows_propagated, rows[1].statistics.windows_propagated);
    row.peak_ratio = ratio(row.statistics.maximum_windows_alive, rows[1].statistics.maximum_windows_alive);
  }
  return rows;
}

// --- output ----------------------------------------------------------------------------------------------------------

void print(const Row& row)
{
  std::cout << row.mesh << ',' << row.faces << ',' << row.variant << ',' << row.trimming << ',' << row.milliseconds
            << ',' << cell(row.time_ratio, 3) << ',' << row.statistics.windows_propagated << ','
            << row.statistics.windows_created << ',' << cell(row.windows_ratio, 3) << ','
            << row.statistics.maximum_windows_alive << ",," << cell(row.peak_ratio, 3) << ',' << row.difference
            << std::endl;
}

// Prints the figures of the thesis; the columns that it does not have stay empty.
void print_thesis()
{
  for(const thesis::Model& model : thesis::models())
  {
    const thesis::Run& vtp = model.runs[thesis::VTP];
    const auto print_run = [&](const std::string& name, const thesis::Run& r)
    {
      std::cout << model.name << " (thesis)," << 1000 * model.faces << ',' << name << ",," << cell(1e3 * r.seconds, 0)
                << ",,," << cell(r.seconds / vtp.seconds, 3) << ',' << r.windows << ",,"
                << cell(static_cast<double>(r.windows) / static_cast<double>(vtp.windows), 3) << ",,"
                << cell(r.megabytes, 3) << ',' << cell(r.megabytes / vtp.megabytes, 3) << ",\n";
    };
    print_run("VTP", vtp);
    for(const thesis::Comparison& comparison : thesis::comparisons())
    {
      if(model.runs[comparison.variant].seconds > 0)
      {
        print_run(comparison.name, model.runs[comparison.variant]);
      }
    }
  }
}

void print_ratios(const std::string& mesh, std::size_t faces, const std::string& variant, double time, double windows,
                  double peak)
{
  std::cerr << std::left << std::setw(26) << mesh << std::right << std::setw(10) << faces << "  " << std::left
            << std::setw(28) << variant << std::right << std::fixed << std::setprecision(3) << std::setw(9) << time
            << std::setw(9) << windows << std::setw(9) << peak << '\n';
}

// Prints tables 4.1 to 4.5 of the thesis as ratios to VTP, ours below those of the thesis.
void print_tables(const std::vector<Row>& rows)
{
  for(const thesis::Comparison& comparison : thesis::comparisons())
  {
    std::cerr << "\nTable " << comparison.table << ": " << comparison.name << " / VTP\n"
              << "mesh                           faces  variant                          time  windows     peak\n";
    for(const thesis::Model& model : thesis::models())
    {
      const thesis::Run &a = model.runs[comparison.variant], &b = model.runs[thesis::VTP];
      if(a.seconds > 0)
      {
        print_ratios(std::string(model.name) + " (thesis)", 1000 * model.faces, comparison.name, a.seconds / b.seconds,
                     static_cast<double>(a.windows) / static_cast<double>(b.windows), a.megabytes / b.megabytes);
      }
    }
    for(const Row& row : rows)
    {
      if(row.variant == comparison.name)
      {
        print_ratios(row.mesh, row.faces, row.variant + ", trimming: " + row.trimming, row.time_ratio,
                     row.windows_ratio, row.peak_ratio);
      }
    }
  }
  std::cerr << "\nNot in a table of the thesis\n";
  for(const Row& row : rows)
  {
    if(row.variant == "VTP" || row.variant == "package" || row.variant == "OPFTP" || row.variant == "FTP-List")
    {
      print_ratios(row.mesh, row.faces, row.variant + ", trimming: " + row.trimming, row.time_ratio, row.windows_ratio,
                   row.peak_ratio);
    }
  }
}

// Names the variants with other distances than the package. Returns whether there are none.
bool are_distances_equal(const std::vector<Row>& rows)
{
  bool are_equal = true;
  for(const Row& row : rows)
  {
    if(!(row.difference <= largest_difference_allowed))
    {
      std::cerr << row.mesh << ", " << row.faces << " faces: distances of " << row.variant << " (trimming: "
                << row.trimming << ") differ by " << row.difference << '\n';
      are_equal = false;
    }
  }
  return are_equal;
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], " mesh...");
  }
  print_head(settings, "propagation without reading the mesh, processor times",
             "mesh,faces,variant,trimming," + spread_columns("run_ms")
               + ",time_over_VTP,windows_propagated,windows_created,windows_over_VTP,peak_windows,peak_mb,"
                 "peak_over_VTP,largest_relative_difference");
  std::vector<Row> rows;
  for(const std::string& file : settings.meshes)
  {
    for(const double part : parts)
    {
      Benchmark_mesh mesh;
      if(!read_mesh(file, settings.subdivisions, mesh))
      {
        return EXIT_FAILURE;
      }
      decimate(mesh, part);
      for(const Row& row : measure(settings, file, mesh))
      {
        print(row);
        rows.push_back(row);
      }
    }
  }
  print_thesis();
  print_tables(rows);
  return are_distances_equal(rows) ? EXIT_SUCCESS : EXIT_FAILURE;
}
