#include "Point_projection.h"

#include "Location_options.h"
#include "Obstacle_option.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace geodesics_demo {

namespace {

// "1.41 % of the diagonal of the mesh", as the limit is told; "2.12 times the diagonal of the mesh" if it is more.
std::string part_of_diagonal(double part)
{
  std::ostringstream text;
  text.precision(3);
  if(part < 1)
    text << 100 * part << " %";
  else
    text << part << " times";
  return text.str() + (part < 1 ? " of the diagonal of the mesh" : " the diagonal of the mesh");
}

} // namespace

Face_location Point_projection::nearest_location(const std::array<double, 3>& x, const std::string& where,
                                                 Exit_code code)
{
  check_is_near(x, where, code);
  if(m_tree == nullptr)
    build_tree(where, code);
  const Point p(x[0], x[1], x[2]);
  const Face_location location = m_tree->nearest_location(p);
  check_snap(p, location, where, code);
  return location;
}

void Point_projection::remark_on_snaps() const
{
  if(!(m_farthest_snap > largest_silent_snap))
    return;
  std::ostringstream text;
  text << m_where_farthest << ": the point was moved to " << goal() << ", by " << part_of_diagonal(m_farthest_snap);
  if(m_number_of_snaps > 1)
    text << "; the farthest of " << m_number_of_snaps << " points";
  m_console.note(text.str());
}

// (The tree of no faces has no nearest point.)
void Point_projection::build_tree(const std::string& where, Exit_code code)
{
  const std::vector<char> is_avoided = flags_of_faces(m_mesh, m_avoided);
  if(!is_avoided.empty() && std::find(is_avoided.begin(), is_avoided.end(), 0) == is_avoided.end())
    throw Command_error(code, where + ": no face is left for the point, as all are to be avoided");
  m_tree.reset(new Face_tree(m_mesh, m_avoided));
}

// Rounding would choose the nearest location of a point that is very far away, and its unit is probably wrong.
void Point_projection::check_is_near(const std::array<double, 3>& x, const std::string& where, Exit_code code)
{
  if(m_limit < 0)
    m_limit = 1e6 * diagonal(m_mesh);
  const Point p = m_mesh.point(*m_mesh.vertices().begin());
  for(int k = 0; k < 3 && m_limit > 0; ++k)
    if(!(std::abs(x[static_cast<std::size_t>(k)] - p[k]) <= m_limit))
      throw Command_error(code, where + ": the distance of the point from the mesh is more than a million times "
                                        "the size of the mesh");
}

void Point_projection::check_snap(const Point& p, const Face_location& location, const std::string& where,
                                  Exit_code code)
{
  if(m_diagonal < 0)
    m_diagonal = diagonal(m_mesh);
  const auto v = p - point_of(location, m_mesh);
  const double distance = std::hypot(v.x(), v.y(), v.z()), part = m_diagonal > 0 ? distance / m_diagonal : 0;
  if(part > largest_snap && !m_may_snap)
  {
    std::ostringstream text;
    text << where << ": the point is " << distance << " from " << goal() << ", " << part_of_diagonal(part)
         << "; --snap moves it to " << goal() << " all the same";
    throw Command_error(code, text.str());
  }
  ++m_number_of_snaps;
  if(!(part > m_farthest_snap))
    return;
  m_farthest_snap = part;
  m_where_farthest = where;
}

} // namespace geodesics_demo
