#include "Polygon_soup.h"

#include <CGAL/IO/OFF/File_scanner_OFF.h>

#include <cstddef>
#include <fstream>
#include <ios>
#include <istream>
#include <string>

namespace geodesics_demo {

namespace {

// Reads the next vertex: its coordinates only.
bool read_vertex(CGAL::File_scanner_OFF& scanner, std::istream& in, Polygon_soup& soup)
{
  double x = 0, y = 0, z = 0, w = 1;
  scanner.scan_vertex(x, y, z, w);
  soup.points.emplace_back(x / w, y / w, z / w);
  if(scanner.has_normals())
    scanner.scan_normal(x, y, z);
  if(scanner.has_vcolors())
  {
    unsigned char red = 0, green = 0, blue = 0;
    scanner.scan_color(red, green, blue);
  }
  if(scanner.has_textures())
    scanner.scan_texture(x, y);
  return in.good();
}

// Reads the next face, which has at most as many corners as there are points.
bool read_face(CGAL::File_scanner_OFF& scanner, std::istream& in, Polygon_soup& soup)
{
  const std::size_t f = soup.faces.size();
  std::size_t size = 0;
  scanner.scan_facet(size, f);
  if((!in.good() && !in.eof()) || size > soup.points.size())
    return false;
  soup.faces.emplace_back();
  for(std::size_t k = 0; k < size; ++k)
  {
    std::size_t v = 0;
    scanner.scan_facet_vertex_index(v, k + 1, f);
    if(in.fail() || v >= soup.points.size())
      return false;
    soup.faces.back().push_back(v);
  }
  if(scanner.has_fcolors())
  {
    unsigned char red = 0, green = 0, blue = 0;
    scanner.scan_color(red, green, blue);
  }
  return true;
}

} // namespace

bool read_OFF(const std::string& file_name, Polygon_soup& soup)
{
  std::ifstream in(file_name, std::ios::binary);
  CGAL::File_scanner_OFF scanner(in);
  if(in.fail())
    return false;
  for(std::size_t i = 0; i < scanner.size_of_vertices(); ++i)
    if(!read_vertex(scanner, in, soup))
      return false;
  for(std::size_t i = 0; i < scanner.size_of_facets(); ++i)
    if(!read_face(scanner, in, soup))
      return false;
  return !in.fail();
}

} // namespace geodesics_demo
