#include "Command_error.h"
#include "Mesh_readers.h"

#include <CGAL/IO/GOCAD.h>

#include <cstddef>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

namespace geodesics_demo {

Polygon_soup read_TS(const std::string& file_name, std::string_view bytes)
{
  Polygon_soup soup;
  std::vector<std::vector<std::size_t>> faces;
  bool is_read = false;
  try
  {
    std::istringstream is{std::string(bytes)};
    is_read = CGAL::IO::read_GOCAD(is, soup.points, faces);
  }
  catch(const std::bad_alloc&)
  {
    throw;
  }
  catch(const std::exception&) // the reader throws for invalid numbers
  {}
  if(!is_read)
    reject_file(file_name, "the file is damaged, incomplete, or not a surface of GOCAD");
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    for(const std::size_t v : faces[f])
    {
      if(v >= soup.points.size())
        reject_file(file_name, "face " + std::to_string(f) + " has the vertex " + std::to_string(v)
                                 + ", but there are only " + std::to_string(soup.points.size()) + " vertices");
      soup.corners.push_back(static_cast<Polygon_soup::Index>(v));
    }
    soup.end_face();
  }
  return soup;
}

} // namespace geodesics_demo
