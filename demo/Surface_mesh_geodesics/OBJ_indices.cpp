#include "OBJ_indices.h"

#include "Command_error.h"
#include "Polygon_soup.h"

namespace geodesics_demo {

std::size_t OBJ_indices::read(Text_scanner& in, std::size_t number_of_vertices, const char* what)
{
  const std::string_view word = in.peek_word();
  const std::int64_t i = in.integer_before_slash(), n = static_cast<std::int64_t>(number_of_vertices);
  const std::string_view others = in.position() == word.data() + word.size() ? std::string_view() : in.word();
  if(i == 0 || (!others.empty() && (others[0] != '/' || others.find_first_not_of("/-0123456789") != others.npos)))
    in.complain_of(word, word == "0" || word.substr(0, 2) == "0/"
                           ? std::string("is not an index of a vertex: OBJ counts from 1")
                           : std::string("is not ").append(what));
  if(i < -n || i > most_points)
    in.complain_of(word, "is not an index of a vertex: there are " + std::to_string(n) + " before this line");
  if(i > m_largest)
  {
    m_largest = i;
    m_line_of_largest = in.line();
  }
  return static_cast<std::size_t>(i > 0 ? i - 1 : n + i);
}

void OBJ_indices::check_largest(const std::string& file_name, std::size_t number_of_vertices) const
{
  if(m_largest > static_cast<std::int64_t>(number_of_vertices))
    reject_line(file_name, m_line_of_largest, "there is no vertex " + std::to_string(m_largest) + "; the file has "
                                                + std::to_string(number_of_vertices));
}

} // namespace geodesics_demo
