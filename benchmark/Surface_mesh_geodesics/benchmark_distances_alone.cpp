// Distances of all vertices from vertex 0 by geodesic_distances(), and nothing else. Prints the number of faces, the
// median of the processor times of the calls in milliseconds, and a hash of the bits of all distances. It compiles with
// older versions of the headers: compare_revisions.sh compares two of them.

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <boost/functional/hash.hpp>

namespace {

std::size_t hash_of_bits(const std::vector<double>& distances)
{
  const char* const first = reinterpret_cast<const char*>(distances.data());
  return boost::hash_range(first, first + distances.size() * sizeof(double));
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    std::cerr << "usage: " << argv[0] << " [options] MESH\n";
    print_common_usage();
    return EXIT_FAILURE;
  }
  Benchmark_mesh mesh;
  if(read_wanted_mesh(settings, mesh) != 0)
  {
    std::cerr << "no triangle mesh: " << settings.meshes.front() << '\n';
    return EXIT_FAILURE;
  }
  auto distance = mesh.add_property_map<Benchmark_vertex, double>("v:distance").first;
  const Benchmark_vertex source(0);
  const Spread ms = repeated(settings, CLOCK_PROCESS_CPUTIME_ID,
                             [&] { CGAL::Surface_mesh_geodesics::geodesic_distances(mesh, distance, source); });
  std::cout << mesh.number_of_faces() << ' ' << cell(ms.middle, 3) << ' ' << hash_of_bits(values_of(distance, mesh))
            << std::endl;
  return EXIT_SUCCESS;
}
