// The files of a Voronoi diagram, read back.

#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Surface_mesh_geodesics/write_geodesic_Voronoi_diagram.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <ios>
#include <istream>
#include <iterator>
#include <map>
#include <ostream>
#include <sstream>
#include <streambuf>
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
  std::vector<std::array<int, 3>> color(voronoi.number_of_sites());
  for(std::size_t i = 0; i < color.size(); ++i)
  {
    skip_to(s, "site");
    CHECK_EQUAL(number(s), i);
    CHECK_EQUAL(word(s), std::string("color"));
    color[i][0] = number<int>(s);
    color[i][1] = number<int>(s);
    color[i][2] = number<int>(s);
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
  for(std::size_t i = 0; i < nf; ++i)
  {
    CHECK_EQUAL(number(s), std::size_t(3));
    const std::size_t a = number(s), b = number(s), c = number(s);
    const int red = number<int>(s), green = number<int>(s), blue = number<int>(s);
    const std::size_t site = number(s);
    CHECK(red >= 0 && red < 256 && green >= 0 && green < 256 && blue >= 0 && blue < 256);
    CHECK((color.at(site) == std::array<int, 3>{red, green, blue}));
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

// Reads a number from bytes of either order.
template <typename Number>
Number number_of_bytes(std::istream& is, bool highest_first)
{
  std::array<unsigned char, sizeof(Number)> bytes{};
  is.read(reinterpret_cast<char*>(bytes.data()), sizeof(Number));
  CHECK(static_cast<bool>(is));
  const std::uint16_t one = 1;
  const bool machine_has_highest_first = *reinterpret_cast<const unsigned char*>(&one) == 0;
  if(highest_first != machine_has_highest_first)
    std::reverse(bytes.begin(), bytes.end());
  Number x{};
  std::memcpy(&x, bytes.data(), sizeof(Number));
  return x;
}

// The words of a text, and those of a binary file as a text would have them.
class Words
{
public:
  explicit Words(bool highest_first) : m_highest_first(highest_first) { m_os.precision(17); }

  template <typename Number>
  void add_numbers(std::istream& is, std::size_t n)
  {
    for(std::size_t i = 0; i < n; ++i)
      m_os << +number_of_bytes<Number>(is, m_highest_first) << ' ';
  }

  void add_line(const std::string& line) { m_os << line << ' '; }

  std::vector<std::string> all() const { return of_text(m_os.str()); }

  static std::vector<std::string> of_text(const std::string& text)
  {
    std::istringstream is(text);
    return {std::istream_iterator<std::string>(is), std::istream_iterator<std::string>()};
  }

private:
  bool m_highest_first;
  std::ostringstream m_os;
};

std::vector<std::string> words_of_binary_PLY(std::istream& is)
{
  Words words(false);
  std::map<std::string, std::size_t> count;
  std::string line;
  while(std::getline(is, line) && line != "end_header")
  {
    std::istringstream of_line(line);
    if(word(of_line) == "element")
    {
      const std::string element = word(of_line);
      count[element] = number(of_line);
    }
    words.add_line(line == "format binary_little_endian 1.0" ? "format ascii 1.0" : line);
  }
  words.add_line(line);
  words.add_numbers<double>(is, 3 * count["vertex"]);
  for(std::size_t i = 0; i < count["face"]; ++i)
  {
    words.add_numbers<std::uint8_t>(is, 1);
    words.add_numbers<std::int32_t>(is, 3);
    words.add_numbers<std::uint8_t>(is, 3);
    words.add_numbers<std::int32_t>(is, 1);
  }
  words.add_numbers<std::int32_t>(is, 4 * count["edge"]);
  CHECK(is.peek() == std::char_traits<char>::eof());
  return words.all();
}

// A block of bytes follows the line that has its size, and ends with a line break.
std::vector<std::string> words_of_binary_VTK(std::istream& is)
{
  Words words(true);
  std::size_t number_of_cells = 0;
  for(std::string line; std::getline(is, line);)
  {
    words.add_line(line == "BINARY" ? "ASCII" : line);
    std::istringstream of_line(line);
    const std::string kind = word(of_line);
    if(kind == "POINTS")
      words.add_numbers<double>(is, 3 * number(of_line));
    else if(kind == "LINES" || kind == "POLYGONS")
    {
      number(of_line);
      words.add_numbers<std::int32_t>(is, number(of_line));
    }
    else if(kind == "LOOKUP_TABLE")
      words.add_numbers<std::int32_t>(is, number_of_cells);
    else
    {
      if(kind == "CELL_DATA")
        number_of_cells = number(of_line);
      continue; // no block follows
    }
    CHECK_EQUAL(is.get(), int('\n'));
  }
  return words.all();
}

// Binary files hold the numbers of the text, bit by bit; CGAL reads the mesh.
void binary_files_hold_the_same(const Voronoi& voronoi)
{
  std::stringstream ply, vtk, binary_ply, binary_vtk;
  ply.precision(17);
  vtk.precision(17);
  CGAL::IO::set_binary_mode(binary_ply);
  CGAL::IO::set_binary_mode(binary_vtk);
  CHECK(Geodesics::write_geodesic_Voronoi_diagram_PLY(ply, voronoi, tolerance));
  CHECK(Geodesics::write_geodesic_Voronoi_diagram_PLY(binary_ply, voronoi, tolerance));
  CHECK(Geodesics::write_geodesic_Voronoi_diagram_VTK(vtk, voronoi, tolerance));
  CHECK(Geodesics::write_geodesic_Voronoi_diagram_VTK(binary_vtk, voronoi, tolerance));
  std::stringstream copy(binary_ply.str());
  CHECK(words_of_binary_PLY(binary_ply) == Words::of_text(ply.str()));
  CHECK(words_of_binary_VTK(binary_vtk) == Words::of_text(vtk.str()));
  Mesh from_text, from_bytes;
  CHECK(CGAL::IO::read_PLY(ply, from_text));
  CHECK(CGAL::IO::read_PLY(copy, from_bytes));
  CHECK_EQUAL(num_faces(from_bytes), num_faces(from_text));
  for(const vertex_descriptor v : vertices(from_text))
    CHECK(from_bytes.point(v) == from_text.point(v));
}

// A device that is full after some bytes.
class Small_device : public std::streambuf
{
public:
  explicit Small_device(std::size_t room) : m_room(room) {}

private:
  int_type overflow(int_type c) override
  {
    if(m_room == 0)
      return traits_type::eof();
    --m_room;
    return c;
  }

  std::size_t m_room;
};

// A full device ends the output with `false`, or with the exception that the stream has been told to throw.
void full_devices_are_reported(const Voronoi& voronoi)
{
  test_support::Scope scope("full device");
  using Write = bool (*)(std::ostream&, const Voronoi&, double);
  const std::array<Write, 2> writers{{Geodesics::write_geodesic_Voronoi_diagram_PLY<Voronoi>,
                                      Geodesics::write_geodesic_Voronoi_diagram_VTK<Voronoi>}};
  for(const auto mode : {CGAL::IO::ASCII, CGAL::IO::BINARY})
    for(const std::size_t room : {20u, 3000u, 70000u})
      for(const Write write : writers)
      {
        Small_device device(room), other_device(room);
        std::ostream os(&device), throwing(&other_device);
        CGAL::IO::set_mode(os, mode);
        CGAL::IO::set_mode(throwing, mode);
        throwing.exceptions(std::ios::badbit | std::ios::failbit);
        CHECK(!write(os, voronoi, tolerance));
        CHECK(throws<std::ios_base::failure>([&] { write(throwing, voronoi, tolerance); }));
      }
}

// The mode of a stream changes nothing in a format that is always text.
void obj_output_is_text(const Voronoi& voronoi)
{
  std::ostringstream text, binary;
  CGAL::IO::set_binary_mode(binary);
  CHECK(Geodesics::write_geodesic_Voronoi_diagram_OBJ(text, voronoi, tolerance));
  CHECK(Geodesics::write_geodesic_Voronoi_diagram_OBJ(binary, voronoi, tolerance));
  CHECK(text.str() == binary.str());
}

void file_names_choose_the_format(const Voronoi& voronoi)
{
  for(const std::string name : {"Voronoi_output.obj", "Voronoi_output.ply", "Voronoi_output.vtk"})
  {
    CHECK(Geodesics::write_geodesic_Voronoi_diagram(name, voronoi, tolerance));
    std::ifstream is(name, std::ios::binary);
    std::stringstream bytes, expected;
    bytes << is.rdbuf();
    is.close();
    CHECK_EQUAL(std::remove(name.c_str()), 0);
    CGAL::IO::set_binary_mode(expected);
    expected.precision(17);
    if(name == "Voronoi_output.obj")
      CHECK(Geodesics::write_geodesic_Voronoi_diagram_OBJ(expected, voronoi, tolerance));
    else if(name == "Voronoi_output.ply")
      CHECK(Geodesics::write_geodesic_Voronoi_diagram_PLY(expected, voronoi, tolerance));
    else
      CHECK(Geodesics::write_geodesic_Voronoi_diagram_VTK(expected, voronoi, tolerance));
    CHECK(bytes.str() == expected.str());
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
  binary_files_hold_the_same(voronoi);
  obj_output_is_text(voronoi);
  full_devices_are_reported(voronoi);
  file_names_choose_the_format(voronoi);
  functions_have_a_default_tolerance(mesh, voronoi);
  surfaces_without_points_have_a_default_tolerance();
  return test_result();
}
