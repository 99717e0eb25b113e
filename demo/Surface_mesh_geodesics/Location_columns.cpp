#include "Location_columns.h"

#include "Number_text.h"

#include <algorithm>
#include <sstream>

namespace geodesics_demo {

namespace {

std::string coordinates(const Location& location, char separator)
{
  std::ostringstream os;
  for(const double b : location.face_location.second)
    os << separator << Number_text(b);
  return os.str();
}

} // namespace

Location_columns::Location_columns(const std::string& prefix, const std::vector<Location>& locations)
{
  const auto is_point = [](const Location& p) { return p.face_location.first != Mesh::null_face(); };
  const bool has_points = std::any_of(locations.begin(), locations.end(), is_point);
  m_names = "," + prefix + "vertex";
  m_empty_cells = ",";
  if(has_points)
  {
    for(const char* name : {"face", "b0", "b1", "b2"})
      m_names += "," + prefix + name;
    m_empty_cells = ",,,,,";
  }
  for(const Location& p : locations)
  {
    if(p.is_vertex())
      m_cells.push_back("," + std::to_string(p.vertex.idx()) + (has_points ? ",,,," : ""));
    else if(!is_point(p))
      m_cells.push_back(m_empty_cells);
    else
      m_cells.push_back(",," + std::to_string(p.face_location.first.idx()) + coordinates(p, ','));
  }
}

std::string name_of(const Location& location)
{
  return location.is_vertex() ? std::to_string(location.vertex.idx())
                              : std::to_string(location.face_location.first.idx()) + coordinates(location, ' ');
}

std::string description_of(const Location& location)
{
  return location.is_vertex() ? "vertex " + name_of(location)
                              : "the point" + coordinates(location, ' ') + " of face "
                                  + std::to_string(location.face_location.first.idx());
}

} // namespace geodesics_demo
