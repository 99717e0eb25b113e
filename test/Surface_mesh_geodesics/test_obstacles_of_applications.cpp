// Faces to avoid of remeshing, of stored matrices and of certificates: results are those of the mesh without these
// faces, and the folder of a matrix knows them.

#include "expected_exceptions.h"
#include "faces_to_avoid.h"
#include "matrix_store_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/centroid.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace matrix_store;
using SMG::Invalid_geodesic_input;

namespace {

namespace np = CGAL::parameters;

using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
using Filtered = CGAL::Face_filtered_graph<Mesh>;
using Faces = std::vector<face_descriptor>;

// --- certificates ---

template <typename Graph, typename Parameters>
auto certificate_of(const Graph& tm, std::map<vertex_descriptor, double>& distance, vertex_descriptor source,
                    const Parameters& parameters)
{
  return SMG::certify_geodesic_distances(tm, boost::make_assoc_property_map(distance), source, parameters);
}

// The certificate is that of the mesh without the faces, in all numbers; and distances of the whole mesh fail.
void certificates_of_distances()
{
  const test_support::Scope scope("certificates of distances");
  test_support::Random random(3);
  std::size_t differing = 0;
  for(const Indexed_mesh& indexed : small_collection(2))
  {
    const test_support::Scope scope_of_mesh(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    const Faces avoided = random_faces(tm, .15, random), rest = other_faces(tm, avoided);
    if(avoided.empty() || rest.empty())
      continue;
    const vertex_descriptor source = target(halfedge(rest[0], tm), tm);
    std::map<vertex_descriptor, double> around, straight;
    SMG::geodesic_distances(tm, boost::make_assoc_property_map(around), source, np::faces_to_avoid(avoided));
    SMG::geodesic_distances(tm, boost::make_assoc_property_map(straight), source);
    const auto certificate = certificate_of(tm, around, source, np::faces_to_avoid(avoided));
    const Filtered filtered(tm, rest);
    const auto expected = certificate_of(filtered, around, source, np::default_values());
    using Certificate = std::decay_t<decltype(certificate)>;
    CHECK(certificate.is_certified());
    for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
    {
      const auto c = static_cast<Certificate::Condition>(i);
      const auto d = static_cast<std::decay_t<decltype(expected)>::Condition>(i);
      // Vertices without a face left count among those that are not reached.
      if(c != Certificate::Condition::REACH && c != Certificate::Condition::REVERSE)
        CHECK_EQUAL(certificate.number_of_checks(c), expected.number_of_checks(d));
    }
    const auto lengths = boost::make_function_property_map<boost::graph_traits<Mesh>::edge_descriptor>(
      [&](boost::graph_traits<Mesh>::edge_descriptor e)
      { return std::sqrt(CGAL::squared_distance(tm.point(CGAL::source(e, tm)), tm.point(target(e, tm)))); });
    CHECK(SMG::certify_geodesic_distances_from_edge_lengths(tm, lengths, boost::make_assoc_property_map(around), source,
                                                            np::faces_to_avoid(avoided)).is_certified());
    const bool is_same = std::all_of(around.begin(), around.end(), [&](const auto& d)
                                     { return std::abs(d.second - straight[d.first]) <= 1e-6 * d.second; });
    if(is_same)
      continue;
    ++differing;
    CHECK(!certificate_of(tm, straight, source, np::faces_to_avoid(avoided)).is_certified());
    CHECK(!certificate_of(tm, around, source, np::default_values()).is_certified());
  }
  CHECK(differing > 5);
  const Mesh tm = to_face_graph(icosphere(1));
  std::map<vertex_descriptor, double> distance;
  CHECK(throws<Invalid_geodesic_input>([&] { certificate_of(tm, distance, vertex_descriptor(0),
                                                            np::faces_to_avoid(Faces{face_descriptor(5000)})); }));
}

// A diagram that says wrongly that it avoids one more face.
struct Lying_diagram
  : Diagram
{
  using Diagram::Diagram;
  bool avoids_face(face_descriptor f) const { return f == one_more || Diagram::avoids_face(f); }
  face_descriptor one_more = Mesh::null_face();
};

void certificates_of_diagrams()
{
  const test_support::Scope scope("certificates of diagrams");
  test_support::Random random(4);
  std::size_t number = 0;
  for(const Indexed_mesh& indexed : small_collection(5))
  {
    const test_support::Scope scope_of_mesh(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    const Faces avoided = random_faces(tm, .15, random), rest = other_faces(tm, avoided);
    if(avoided.empty() || rest.size() < 3)
      continue;
    Lying_diagram diagram(tm);
    diagram.avoid_faces(avoided);
    for(const face_descriptor f : faces(tm))
      CHECK_EQUAL(diagram.avoids_face(f), std::count(avoided.begin(), avoided.end(), f) > 0);
    diagram.add_site(target(halfedge(rest[0], tm), tm));
    diagram.add_site(Diagram::Face_location(rest.back(), {{.2, .3, .5}}));
    // A site at the rim whose face is to be avoided, if there is one.
    for(const face_descriptor f : avoided)
    {
      const auto h = halfedge(f, tm);
      if(!is_border(opposite(h, tm), tm) && !diagram.avoids_face(face(opposite(h, tm), tm)))
      {
        diagram.add_site(Diagram::Face_location(f, {{.75, .25, 0}}));
        break;
      }
    }
    const Diagram& honest = diagram;
    const auto certificate = SMG::certify_geodesic_Voronoi_diagram(honest);
    CHECK(certificate.is_certified());
    const auto lengths = boost::make_function_property_map<boost::graph_traits<Mesh>::edge_descriptor>(
      [&](boost::graph_traits<Mesh>::edge_descriptor e)
      { return std::sqrt(CGAL::squared_distance(tm.point(CGAL::source(e, tm)), tm.point(target(e, tm)))); });
    diagram.use_edge_lengths(lengths);
    CHECK(SMG::certify_geodesic_Voronoi_diagram_from_edge_lengths(honest, lengths).is_certified());
    diagram.use_points();
    // A face that no arc crosses and that has no site.
    const double area = CGAL::Polygon_mesh_processing::area(tm);
    const auto is_plain = [&](face_descriptor f)
    {
      for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
        if(diagram.site(i).first == f)
          return false;
      return diagram.arcs(f).empty() && diagram.nearest_site(target(halfedge(f, tm), tm)) != Diagram::null_site()
          && CGAL::Polygon_mesh_processing::face_area(f, tm) > 1e-6 * area;
    };
    const auto plain = std::find_if(rest.begin(), rest.end(), is_plain);
    if(plain == rest.end())
      continue;
    diagram.one_more = *plain;
    ++number;
    const auto violations
      = SMG::internal::certify_diagram_with_points<CGAL::Surface_mesh_geodesic_paths, Traits, CGAL::Sequential_tag>(
        diagram, np::default_values());
    CHECK(violations[SMG::internal::DIAGRAM_AREAS].size > 1e-9);
  }
  CHECK(number > 3);
}

// --- remeshing ---

using Point = std::array<double, 3>;

// The triangles of a mesh by their points, each beginning with its least point, sorted.
std::vector<std::array<Point, 3>> triangles_of(const Mesh& tm)
{
  std::vector<std::array<Point, 3>> result;
  for(const face_descriptor f : faces(tm))
  {
    std::array<Point, 3> corners;
    std::size_t k = 0;
    for(const vertex_descriptor v : vertices_around_face(halfedge(f, tm), tm))
      corners[k++] = {tm.point(v).x(), tm.point(v).y(), tm.point(v).z()};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.push_back(corners);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// The new mesh is that of the filtered graph. (Meshes without symmetry: ties depend on the order of vertices.)
void remeshing_without_faces()
{
  const test_support::Scope scope("remeshing");
  for(std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    test_support::Random random(seed);
    const Mesh tm = to_face_graph(noisy_sphere(3, .05, seed));
    // A cap and some single faces.
    Faces avoided = random_faces(tm, .01, random);
    for(const face_descriptor f : faces(tm))
      if(tm.point(target(halfedge(f, tm), tm)).z() > .8)
        avoided.push_back(f);
    const Filtered filtered(tm, other_faces(tm, avoided));
    Mesh found, by_map, expected, whole;
    const auto report = SMG::geodesic_remeshing(tm, 60, found, np::faces_to_avoid(avoided));
    const auto expected_report = SMG::geodesic_remeshing(filtered, 60, expected);
    CHECK(report.is_complete && num_faces(found) > 60);
    CHECK_EQUAL(report.number_of_components, expected_report.number_of_components);
    CHECK_EQUAL(report.number_of_split_vertices, expected_report.number_of_split_vertices);
    CHECK_EQUAL(report.number_of_vertices, expected_report.number_of_vertices);
    CHECK(triangles_of(found) == triangles_of(expected));
    const auto is_avoided = boost::make_function_property_map<face_descriptor>(
      [&](face_descriptor f) { return std::count(avoided.begin(), avoided.end(), f) > 0; });
    SMG::geodesic_remeshing(tm, 60, by_map, np::faces_to_avoid(is_avoided));
    CHECK(triangles_of(by_map) == triangles_of(found));
    SMG::geodesic_remeshing(tm, 60, whole);
    CHECK(triangles_of(whole) != triangles_of(found));
    CHECK(is_closed(whole) && !is_closed(found));
  }
}

// Vertices where faces touch are split, as on a mesh that is pinched from the start.
void remeshing_of_touching_faces()
{
  const test_support::Scope scope("touching faces");
  const Mesh tm = to_face_graph(flat_patch(8, 8, 0., false, 1));
  // What is left: two quarters of the square, which touch in its center.
  Faces avoided;
  const Kernel::Point_3 middle = CGAL::centroid(tm.points().begin(), tm.points().end());
  for(const face_descriptor f : faces(tm))
  {
    double x = 0, y = 0;
    for(const vertex_descriptor v : vertices_around_face(halfedge(f, tm), tm))
    {
      x += tm.point(v).x() / 3;
      y += tm.point(v).y() / 3;
    }
    if((x < middle.x()) != (y < middle.y()))
      avoided.push_back(f);
  }
  CHECK_EQUAL(2 * avoided.size(), num_faces(tm));
  Mesh output;
  auto report = SMG::geodesic_remeshing(tm, 20, output, np::faces_to_avoid(avoided));
  CHECK(report.is_complete);
  CHECK_EQUAL(report.number_of_components, 2u);
  CHECK_EQUAL(report.number_of_split_vertices, 1u);
  const double area = CGAL::Polygon_mesh_processing::area(tm);
  CHECK(CGAL::Polygon_mesh_processing::area(output) > .4 * area);
  CHECK(CGAL::Polygon_mesh_processing::area(output) <= .5 * area * (1 + 1e-12));
  // A pinched mesh of which one umbrella is left, and of which all are left but for one face.
  Mesh pinched;
  const auto center = pinched.add_vertex(Kernel::Point_3(0, 0, 0));
  std::vector<Faces> fans;
  for(const double z : {-1., 1.})
  {
    std::vector<vertex_descriptor> rim;
    for(std::size_t k = 0; k < 5; ++k)
      rim.push_back(pinched.add_vertex(Kernel::Point_3(std::cos(1.2566 * double(k)), std::sin(1.2566 * double(k)), z)));
    if(z > 0)
      std::reverse(rim.begin(), rim.end());
    fans.emplace_back();
    for(std::size_t k = 0; k < 4; ++k)
      fans.back().push_back(pinched.add_face(center, rim[k], rim[k + 1]));
  }
  CHECK_EQUAL(num_faces(pinched), 8u);
  const auto splits_without = [&](const Faces& faces)
  {
    Mesh result;
    const auto r = SMG::geodesic_remeshing(pinched, 100, result, np::faces_to_avoid(faces));
    CHECK(r.is_complete);
    CHECK_EQUAL(num_faces(result), num_faces(pinched) - faces.size());
    return r.number_of_split_vertices;
  };
  CHECK_EQUAL(splits_without({}), 1u);
  CHECK_EQUAL(splits_without(fans[0]), 0u);
  CHECK_EQUAL(splits_without(fans[1]), 0u);
  CHECK_EQUAL(splits_without({fans[0][1]}), 2u);
  CHECK_EQUAL(splits_without({fans[0][0]}), 1u);
}

void remeshing_of_bad_input()
{
  const test_support::Scope scope("bad input");
  Mesh tm = to_face_graph(icosphere(2)), output;
  CHECK(throws<Invalid_geodesic_input>(
    [&] { SMG::geodesic_remeshing(tm, 20, output, np::faces_to_avoid(Faces{face_descriptor(50000)})); }));
  const auto all = faces(tm);
  const auto report = SMG::geodesic_remeshing(tm, 20, output, np::faces_to_avoid(Faces(all.begin(), all.end())));
  CHECK(report.is_complete && output.is_empty());
  CHECK_EQUAL(report.number_of_components, 0u);
  // Points of vertices without a face that is left are checked nevertheless, as for distances.
  const vertex_descriptor v(0);
  Faces star;
  for(const face_descriptor f : faces_around_target(halfedge(v, tm), tm))
    star.push_back(f);
  CHECK(SMG::geodesic_remeshing(tm, 20, output, np::faces_to_avoid(star)).is_complete);
  CHECK(num_faces(output) > 20 && !is_closed(output));
  tm.point(v) = Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const std::size_t number_before = num_faces(output);
  CHECK(throws<Invalid_geodesic_input>([&] { SMG::geodesic_remeshing(tm, 20, output, np::faces_to_avoid(star)); }));
  CHECK_EQUAL(num_faces(output), number_before);
}

// --- stored matrices ---

// The hash of the matrix, which follows the targets in a manifest.
std::string hash_of_matrix(const fs::path& folder)
{
  const std::string text = bytes_of(folder / "manifest.json");
  const std::size_t at = text.find("\"hash\"", text.find("\"targets\"")) + 6;
  const std::size_t begin = text.find('"', at) + 1;
  return text.substr(begin, text.find('"', begin) - begin);
}

// A sphere with faces to avoid, and a call for a folder.
struct Store_calls
{
  Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  test_support::Random random{6};
  Faces avoided = random_faces(tm, .1, random);
  Options options = shards_of_five_rows();

  template <typename Parameters>
  Status operator()(const Test_folder& folder, const Parameters& parameters) const
  {
    return SMG::store_geodesic_distance_matrix(tm, vertices(tm), vertices(tm), folder.name(), parameters);
  }
};

// The rows are those of the other functions, and the folder names the faces.
void stored_rows()
{
  const test_support::Scope scope("stored rows");
  const Store_calls store_in;
  const Mesh& tm = store_in.tm;
  const Faces& avoided = store_in.avoided;
  CHECK(avoided.size() > 3);
  Rows expected;
  SMG::geodesic_distance_matrix(tm, vertices(tm), vertices(tm),
                                [&](std::size_t, const std::vector<double>& row) { expected.push_back(row); },
                                np::faces_to_avoid(avoided));
  CHECK(expected != expected_matrix(tm));
  Test_folder folder("avoided");
  // Some rows first; the rest by a map, and in another order, as the faces are a set.
  CHECK(store_in(folder, named(store_in.options).faces_to_avoid(avoided).end_row(40)).is_complete());
  const auto is_avoided = boost::make_function_property_map<face_descriptor>(
    [&](face_descriptor f) { return std::count(avoided.begin(), avoided.end(), f) > 0; });
  CHECK(store_in(folder, named(store_in.options).faces_to_avoid(is_avoided)).is_complete());
  Row_visitor visitor;
  CHECK(store_in(folder, named(store_in.options).faces_to_avoid(Faces(avoided.rbegin(), avoided.rend()))
                           .visitor(std::ref(visitor))).is_complete());
  CHECK_EQUAL(visitor.computed, 0u);
  CHECK_EQUAL(visitor.found, num_vertices(tm));
  CHECK(stored_numbers(folder.path()) == flat(expected));
  const Store store(folder.name());
  CHECK(store.faces_to_avoid() == std::vector<std::size_t>(avoided.begin(), avoided.end()));
  for(std::size_t i = 0; i < expected.size(); ++i)
    CHECK(store.row(i) == expected[i]);
  // The folder tells the faces to the check.
  const auto check = SMG::check_geodesic_distance_matrix(tm, folder.name(), 20);
  CHECK_EQUAL(check.rows_compared, 20u);
  CHECK_EQUAL(check.rows_different, 0u);
  CHECK(check.worst_asymmetry < 1e-14 && check.worst_triangle_violation < 1e-14);
}

// Without the faces, with one face less, and the other way round: refused, with both hashes, and nothing changes.
void stores_with_other_faces()
{
  const test_support::Scope scope("other faces");
  const Store_calls store_in;
  const Faces& avoided = store_in.avoided;
  const auto with = [&](const Faces& faces) { return named(store_in.options).faces_to_avoid(faces); };
  Test_folder folder("avoided"), other("whole"), none("none");
  CHECK(store_in(folder, with(avoided)).is_complete());
  CHECK(store_in(other, named(store_in.options)).is_complete());
  CHECK(stored_numbers(other.path()) == flat(expected_matrix(store_in.tm)));
  CHECK(Store(other.name()).faces_to_avoid().empty());
  CHECK(bytes_of(other.path() / "manifest.json").find("avoid") == std::string::npos);
  const auto before = contents(folder.path());
  const std::string hash = hash_of_matrix(folder.path()), hash_of_whole = hash_of_matrix(other.path());
  CHECK(hash.size() == 16 && hash_of_whole.size() == 16 && hash != hash_of_whole);
  CHECK_EQUAL(Store(folder.name()).mesh_hash(), Store(other.name()).mesh_hash());
  const auto is_refused = [&](const Test_folder& f, const Faces& faces)
  {
    const std::string message = message_of(Store_error::Reason::DIFFERENT_MATRIX, [&] { store_in(f, with(faces)); });
    CHECK(message.find(hash_of_matrix(f.path())) != std::string::npos);
    return message;
  };
  CHECK(is_refused(folder, {}).find(hash_of_whole) != std::string::npos);
  CHECK(is_refused(other, avoided).find(hash) != std::string::npos);
  is_refused(folder, Faces(avoided.begin() + 1, avoided.end()));
  CHECK(contents(folder.path()) == before);
  CHECK(throws<Invalid_geodesic_input>([&] { store_in(none, with(Faces{face_descriptor(50000)})); }));
  CHECK(!fs::exists(none.path()));
  // A manifest that has lost the faces, and faces that the mesh does not have.
  remove_from_manifest(folder.path(), "faces_to_avoid");
  message_of(Store_error::Reason::NOT_A_STORE, [&] { Store damaged(folder.name()); });
  SMG::internal::Store_description description;
  description.faces_to_avoid = {1, 320};
  message_of(Store_error::Reason::NOT_A_STORE, [&] { SMG::internal::stored_faces_to_avoid(description, 320); });
  description.faces_to_avoid = {1, 319};
  const std::vector<char> flags = SMG::internal::stored_faces_to_avoid(description, 320);
  CHECK(flags.size() == 320 && std::count(flags.begin(), flags.end(), 1) == 2 && flags[1] == 1 && flags[319] == 1);
}

// --- curves ---

// A curve of one vertex is a source like that vertex: rejected inside of the faces to avoid, valid at their rim, also
// where a segment without length is given in a face to avoid that has no neighbor at its edges there.
void curves_of_one_point()
{
  const test_support::Scope scope("curves of one point");
  using Curve = SMG::Surface_curve<Mesh>;
  const Mesh tm = to_face_graph(icosphere(1));
  const vertex_descriptor v(0);
  std::map<vertex_descriptor, double> found, expected;
  Faces star;
  for(const face_descriptor f : faces_around_target(halfedge(v, tm), tm))
    star.push_back(f);
  const auto distances = [&](const auto& source, const Faces& avoided, std::map<vertex_descriptor, double>& result)
  { SMG::geodesic_distances(tm, boost::make_assoc_property_map(result), source, np::faces_to_avoid(avoided)); };
  CHECK(throws<Invalid_geodesic_input>([&] { distances(v, star, found); }));
  CHECK(throws<Invalid_geodesic_input>([&] { distances(Curve(tm, v), star, found); }));
  const std::vector<vertex_descriptor> twice(2, v);
  for(const face_descriptor left : star) // all faces but one
  {
    Faces avoided = star;
    avoided.erase(std::find(avoided.begin(), avoided.end(), left));
    distances(v, avoided, expected);
    distances(Curve(tm, twice), avoided, found);
    CHECK(found == expected);
  }
}

} // namespace

int main()
{
  certificates_of_distances();
  certificates_of_diagrams();
  remeshing_without_faces();
  remeshing_of_touching_faces();
  remeshing_of_bad_input();
  stored_rows();
  stores_with_other_faces();
  curves_of_one_point();
  return test_result();
}
