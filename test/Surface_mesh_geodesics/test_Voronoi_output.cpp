// The files of a Voronoi diagram, read back.

#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Surface_mesh_geodesics/write_geodesic_Voronoi_diagram.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test_meshes;
namespace Geodesics = CGAL::Surface_mesh_geodesics;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;

const double tolerance = 1e-4;

double length_of_edges(const Voronoi& voronoi)
{
  double sum = 0;
  for(const auto& e : voronoi.edges())
    sum += e.length();
  return sum;
}

double distance_of(const Coordinates& a, const Coordinates& b) { return length(b - a); }

// words, one by one
std::string word(std::istream& is)
{
  std::string w;
  is >> w;
  return w;
}

void skip_to(std::istream& is, const std::string& w)
{
  while(is && word(is) != w)
    continue;
  CHECK(static_cast<bool>(is));
}

template <typename Number = std::size_t>
Number number(std::istream& is)
{
  Number n{};
  is >> n;
  CHECK(static_cast<bool>(is));
  return n;
}

std::vector<Coordinates> points(std::istream& is, std::size_t n)
{
  std::vector<Coordinates> result(n);
  for(Coordinates& p : result)
    is >> p[0] >> p[1] >> p[2];
  CHECK(static_cast<bool>(is));
  return result;
}

void obj_output_has_all_edges(const Voronoi& voronoi)
{
  std::stringstream s;
  s.precision(17);
  CHECK(Geodesics::write_geodesic_Voronoi_diagram_OBJ(s, voronoi, tolerance));
  std::vector<Coordinates> v;
  std::size_t number_of_lines = 0, number_of_groups = 0;
  double sum = 0;
  for(std::string line; std::getline(s, line);)
  {
    std::istringstream is(line);
    const std::string kind = word(is);
    if(kind == "v")
      v.push_back(points(is, 1).front());
    else if(kind == "g")
    {
      const auto sites = voronoi.edges()[number_of_groups++].sites();
      CHECK_EQUAL(word(is), "edge_" + std::to_string(sites.first) + "_" + std::to_string(sites.second));
    }
    else
    {
      CHECK_EQUAL(kind, std::string("l"));
      ++number_of_lines;
      std::size_t i, j;
      for(is >> i; is >> j; i = j)
        sum += distance_of(v.at(i - 1), v.at(j - 1));
    }
  }
  CHECK_EQUAL(number_of_lines, voronoi.edges().size());
  CHECK_EQUAL(number_of_groups, voronoi.edges().size());
  CHECK_CLOSE(sum, length_of_edges(voronoi), 1e-2);
}

void ply_output_has_mesh_and_edges(const Mesh& mesh, const Voronoi& voronoi)
{
  std::stringstream s;
  s.precision(17);
  CHECK(Geodesics::write_geodesic_Voronoi_diagram_PLY(s, voronoi, tolerance));
  {
    // CGAL reads the mesh
    std::stringstream copy(s.str());
    Mesh read;
    CHECK(CGAL::IO::read_PLY(copy, read));
    CHECK_CLOSE(CGAL::to_double(CGAL::Polygon_mesh_processing::area(read)),
                CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh)), 1e-9);
  }
  skip_to(s, "vertex");
  const std::size_t nv = number(s);
  skip_to(s, "face");
  const std::size_t nf = number(s);
  skip_to(s, "edge");
  const std::size_t ne = number(s);
  skip_to(s, "end_header");
  const std::vector<Coordinates> v = points(s, nv);
  std::vector<double> area(voronoi.number_of_sites(), 0.);
  std::vector<char> has_face(nv, 0);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> site_on_left; // of the sides of faces
  std::vector<std::array<int, 3>> color(voronoi.number_of_sites(), {-1, -1, -1});
  for(std::size_t i = 0; i < nf; ++i)
  {
    CHECK_EQUAL(number(s), std::size_t(3));
    const std::size_t a = number(s), b = number(s), c = number(s);
    const int red = number<int>(s), green = number<int>(s), blue = number<int>(s);
    const std::size_t site = number(s);
    CHECK(red >= 0 && red < 256 && green >= 0 && green < 256 && blue >= 0 && blue < 256);
    if(color.at(site)[0] == -1)
      color[site] = {red, green, blue};
    CHECK((color[site] == std::array<int, 3>{red, green, blue}));
    area[site] += length(cross(v.at(b) - v.at(a), v.at(c) - v.at(a))) / 2;
    site_on_left[{a, b}] = site_on_left[{b, c}] = site_on_left[{c, a}] = site;
    has_face[a] = has_face[b] = has_face[c] = 1;
  }
  CHECK(std::find(has_face.begin(), has_face.end(), 0) == has_face.end());
  for(std::size_t i = 0; i < area.size(); ++i)
    CHECK_NEAR(area[i], voronoi.area(i), tolerance * length_of_edges(voronoi));
  for(std::size_t i = 1; i < color.size(); ++i)
    CHECK(color[i] != color[i - 1]);
  double sum = 0;
  for(std::size_t i = 0; i < ne; ++i)
  {
    const std::size_t a = number(s), b = number(s), left = number(s), right = number(s);
    CHECK(left < area.size() && right < area.size() && left != right);
    CHECK_EQUAL(site_on_left.at({a, b}), left);
    CHECK_EQUAL(site_on_left.at({b, a}), right);
    sum += distance_of(v.at(a), v.at(b));
  }
  CHECK_CLOSE(sum, length_of_edges(voronoi), 1e-2);
  CHECK(word(s).empty());
}

void vtk_output_has_all_edges(const Mesh& mesh, const Voronoi& voronoi)
{
  std::stringstream s;
  s.precision(17);
  CHECK(Geodesics::write_geodesic_Voronoi_diagram_VTK(s, voronoi, tolerance));
  skip_to(s, "POINTS");
  const std::size_t nv = number(s);
  CHECK_EQUAL(word(s), std::string("double"));
  const std::vector<Coordinates> v = points(s, nv);
  CHECK_EQUAL(word(s), std::string("LINES"));
  const std::size_t nl = number(s), line_size = number(s);
  CHECK_EQUAL(nl, voronoi.edges().size());
  double sum = 0;
  std::size_t numbers = 0;
  for(std::size_t i = 0; i < nl; ++i)
  {
    const std::size_t n = number(s);
    numbers += n + 1;
    std::size_t a = number(s);
    for(std::size_t j = 1; j < n; ++j)
    {
      const std::size_t b = number(s);
      sum += distance_of(v.at(a), v.at(b));
      a = b;
    }
  }
  CHECK_EQUAL(numbers, line_size);
  CHECK_CLOSE(sum, length_of_edges(voronoi), 1e-2);
  CHECK_EQUAL(word(s), std::string("POLYGONS"));
  const std::size_t nf = number(s);
  CHECK_EQUAL(number(s), 4 * nf);
  double area = 0;
  for(std::size_t i = 0; i < nf; ++i)
  {
    CHECK_EQUAL(number(s), std::size_t(3));
    const std::size_t a = number(s), b = number(s), c = number(s);
    area += length(cross(v.at(b) - v.at(a), v.at(c) - v.at(a))) / 2;
  }
  CHECK_CLOSE(area, CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh)), 1e-12);
  CHECK_EQUAL(word(s), std::string("CELL_DATA"));
  CHECK_EQUAL(number(s), nl + nf);
  for(const std::string name : {"site", "left_site", "right_site"})
  {
    skip_to(s, "SCALARS");
    CHECK_EQUAL(word(s), name);
    skip_to(s, "default");
    for(std::size_t i = 0; i < nl; ++i)
    {
      const auto sites = voronoi.edges()[i].sites();
      const long expected = name == "site" ? -1l : static_cast<long>(name == "left_site" ? sites.first : sites.second);
      CHECK_EQUAL(number<long>(s), expected);
    }
    for(std::size_t i = 0; i < nf; ++i)
      CHECK(number(s) < voronoi.number_of_sites());
  }
  CHECK(word(s).empty());
}

void file_names_choose_the_format(const Voronoi& voronoi)
{
  for(const std::string name : {"Voronoi_output.obj", "Voronoi_output.ply", "Voronoi_output.vtk"})
  {
    CHECK(Geodesics::write_geodesic_Voronoi_diagram(name, voronoi, tolerance));
    std::ifstream is(name);
    CHECK(static_cast<bool>(is) && !word(is).empty());
    is.close();
    CHECK_EQUAL(std::remove(name.c_str()), 0);
  }
  CHECK(!Geodesics::write_geodesic_Voronoi_diagram("Voronoi_output.stl", voronoi, tolerance));
  CHECK(!Geodesics::write_geodesic_Voronoi_diagram("no_such_folder/Voronoi_output.ply", voronoi, tolerance));
}

// A function of the text that `write` writes to a stream.
template <typename Write>
std::string text_of(const Write& write)
{
  std::ostringstream s;
  s.precision(17);
  CHECK(write(s));
  return s.str();
}

// Without a tolerance, all functions take a thousandth of the diagonal of the bounding box.
void functions_have_a_default_tolerance(const Mesh& mesh, const Voronoi& voronoi)
{
  test_support::Scope scope("default tolerance");
  const double default_tolerance = voronoi.default_tolerance();
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  CHECK_CLOSE(default_tolerance,
              std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()) / 1000, 1e-14);
  using namespace Geodesics;
  CHECK(text_of([&](std::ostream& s) { return write_geodesic_Voronoi_diagram_OBJ(s, voronoi); })
        == text_of([&](std::ostream& s) { return write_geodesic_Voronoi_diagram_OBJ(s, voronoi, default_tolerance); }));
  CHECK(text_of([&](std::ostream& s) { return write_geodesic_Voronoi_diagram_PLY(s, voronoi); })
        == text_of([&](std::ostream& s) { return write_geodesic_Voronoi_diagram_PLY(s, voronoi, default_tolerance); }));
  CHECK(text_of([&](std::ostream& s) { return write_geodesic_Voronoi_diagram_VTK(s, voronoi); })
        == text_of([&](std::ostream& s) { return write_geodesic_Voronoi_diagram_VTK(s, voronoi, default_tolerance); }));
  const std::string name = "Voronoi_output_default.obj";
  CHECK(write_geodesic_Voronoi_diagram(name, voronoi));
  std::ostringstream of_file;
  of_file << std::ifstream(name).rdbuf();
  CHECK(of_file.str() == text_of([&](std::ostream& s) { return write_geodesic_Voronoi_diagram_OBJ(s, voronoi); }));
  CHECK_EQUAL(std::remove(name.c_str()), 0);

  Mesh cut, cell, expected;
  voronoi.cut(cut, cut.add_property_map<face_descriptor, std::size_t>("f:site").first);
  voronoi.cut(expected, expected.add_property_map<face_descriptor, std::size_t>("f:site").first, default_tolerance);
  CHECK_EQUAL(num_faces(cut), num_faces(expected));
  CHECK(num_faces(cut) > num_faces(mesh));
  expected.clear();
  voronoi.cell_mesh(3, cell, cell.add_property_map<face_descriptor, face_descriptor>("f:face").first);
  voronoi.cell_mesh(3, expected, expected.add_property_map<face_descriptor, face_descriptor>("f:face").first,
                    default_tolerance);
  CHECK_EQUAL(num_faces(cell), num_faces(expected));
  CHECK_EQUAL(voronoi.boundary_polylines(3).front().locations.size(),
              voronoi.boundary_polylines(3, default_tolerance).front().locations.size());
}

// Where all points are the same, the lengths decide.
void surfaces_without_points_have_a_default_tolerance()
{
  test_support::Scope scope("default tolerance of lengths");
  Mesh mesh = to_face_graph(noisy_sphere(2, .02, 8));
  for(const double scale : {1., 1e-6, 1e9})
  {
    auto length = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
    const Mesh with_points = to_face_graph(noisy_sphere(2, .02, 8));
    double longest = 0;
    for(const auto e : mesh.edges())
    {
      length[e] = scale * CGAL::Polygon_mesh_processing::edge_length(halfedge(e, with_points), with_points);
      longest = (std::max)(longest, length[e]);
    }
    for(const auto v : mesh.vertices())
      mesh.point(v) = Mesh::Point(1, 2, 3);
    Voronoi voronoi(mesh);
    voronoi.use_edge_lengths(length);
    voronoi.add_site(*vertices(mesh).begin());
    voronoi.add_site(*std::next(vertices(mesh).begin(), 50));
    CHECK(voronoi.default_tolerance() >= longest / 4000);
    CHECK(voronoi.default_tolerance() <= longest / 250);
    CHECK(!voronoi.boundary_polylines(0).empty());
  }
  const Mesh empty;
  CHECK(Voronoi(empty).default_tolerance() > 0);
}

} // namespace

int main()
{
  const Mesh mesh = to_face_graph(noisy_sphere(3, .02, 8));
  Voronoi voronoi(mesh);
  for(std::size_t i = 0; i < 12; ++i)
    voronoi.add_site(Voronoi::Face_location(face_descriptor(static_cast<Mesh::size_type>(100 * i)), {.2, .3, .5}),
                     i % 3 == 0 ? .05 : 0.);
  obj_output_has_all_edges(voronoi);
  ply_output_has_mesh_and_edges(mesh, voronoi);
  vtk_output_has_all_edges(mesh, voronoi);
  file_names_choose_the_format(voronoi);
  functions_have_a_default_tolerance(mesh, voronoi);
  surfaces_without_points_have_a_default_tolerance();
  return test_result();
}
