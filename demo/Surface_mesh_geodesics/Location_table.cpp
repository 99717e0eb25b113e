#include "Location_table.h"

#include "Command_error.h"
#include "number_arguments.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>

namespace geodesics_demo {

namespace {

std::vector<std::string> cells_of(const std::string& line)
{
  return cells_of_row(line, line.find(';') != std::string::npos ? ';' : ',');
}

// Is the text a name, and not a number such as 1e5, nan or inf?
bool is_name(const std::string& text)
{
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 && text != "nan" && text != "inf";
}

} // namespace

std::vector<std::string> Location_table::words_of(const std::string& line, const std::string& where)
{
  std::string text = without_blanks(line.substr(0, line.find('#')));
  if(text.empty())
    return {};
  if(m_is_first && read_names(text, where))
    return {};
  m_is_first = false;
  if(!m_is_table)
  {
    std::replace_if(text.begin(), text.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    std::istringstream is(text);
    return {std::istream_iterator<std::string>(is), std::istream_iterator<std::string>()};
  }
  const std::vector<std::string> cells = cells_of(text);
  m_weight.clear();
  for(const std::size_t c : m_column_of_weight)
    m_weight = c < cells.size() ? cells[c] : std::string();
  for(const std::vector<std::size_t>& columns : m_choices)
  {
    std::vector<std::string> words;
    for(const std::size_t c : columns)
      if(c < cells.size() && !cells[c].empty())
        words.push_back(cells[c]);
    if(words.size() == columns.size())
      return words;
  }
  throw Command_error(Exit_code::BAD_INPUT, where + ": the row has no vertex, no point of a face, and no point");
}

bool Location_table::read_names(const std::string& line, const std::string& where)
{
  m_is_first = false;
  const std::vector<std::string> names = cells_of(line);
  if(!std::all_of(names.begin(), names.end(), is_name))
    return false;
  m_is_table = true;
  for(const std::string& prefix : {m_role + "_", std::string()})
    for(const std::vector<std::string>& wanted : {std::vector<std::string>{"vertex"}, {"face", "b0", "b1", "b2"}})
    {
      std::vector<std::string> columns;
      for(const std::string& name : wanted)
        columns.push_back(prefix + name);
      m_choices.push_back(columns_with(names, columns));
    }
  m_choices.push_back(columns_with(names, {"x", "y", "z"}));
  m_column_of_weight = columns_with(names, {"weight"});
  m_choices.erase(std::remove_if(m_choices.begin(), m_choices.end(),
                                 [](const std::vector<std::size_t>& columns) { return columns.empty(); }),
                  m_choices.end());
  if(m_choices.empty())
    throw Command_error(Exit_code::BAD_INPUT,
                        where + ": the table has none of the columns vertex, " + m_role
                          + "_vertex, face with b0, b1, b2, or x with y, z");
  return true;
}

std::vector<std::size_t> Location_table::columns_with(const std::vector<std::string>& cells,
                                                      const std::vector<std::string>& names) const
{
  std::vector<std::size_t> result;
  for(const std::string& name : names)
  {
    const auto found = std::find(cells.begin(), cells.end(), name);
    if(found == cells.end())
      return {};
    result.push_back(static_cast<std::size_t>(found - cells.begin()));
  }
  return result;
}

} // namespace geodesics_demo
