#include "Text_scanner.h"

#include "Command_error.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>

namespace geodesics_demo {

namespace {

bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool is_end_of_line(char c)
{
  return c == '\n' || c == '\r';
}

// A word as it is shown in a message: short, and without control characters.
std::string shown(std::string_view word)
{
  const std::size_t most = 40;
  std::string text;
  for(const char c : word.substr(0, most))
    text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return word.size() > most ? text + "..." : text;
}

// Is the word a number with a comma, as in 0,5?
bool has_decimal_comma(std::string_view word)
{
  const std::size_t comma = word.find(',');
  return comma != std::string_view::npos && word.find_first_not_of("+-0123456789eE,") == std::string_view::npos
      && word.find(',', comma + 1) == std::string_view::npos && comma + 1 < word.size();
}

} // namespace

std::string_view without_mark_of_byte_order(const std::string& file_name, std::string_view text)
{
  if(text.substr(0, 3) == "\xef\xbb\xbf")
    return text.substr(3);
  if(text.substr(0, 2) == "\xff\xfe" || text.substr(0, 2) == "\xfe\xff")
    reject_line(file_name, 1, "the text is in UTF-16; store it in ASCII or UTF-8");
  return text;
}

Text_scanner::Text_scanner(const std::string& file_name, std::string_view text, char comment, bool has_continuation)
  : m_file_name(file_name), m_comment(comment), m_has_continuation(has_continuation)
{
  const std::string_view letters = without_mark_of_byte_order(file_name, text);
  m_position = letters.data();
  m_end = letters.data() + letters.size();
}

void Text_scanner::skip_blanks()
{
  for(; m_position != m_end; ++m_position)
  {
    const char c = *m_position;
    if(is_blank(c))
      continue;
    if(c == m_comment && m_comment != 0)
    {
      while(m_position != m_end && !is_end_of_line(*m_position))
        ++m_position;
      return;
    }
    if(c != '\\' || !m_has_continuation || m_position + 1 == m_end || !is_end_of_line(m_position[1]))
      return;
    ++m_position;
    pass_end_of_line();
    --m_position; // the loop moves on
  }
}

void Text_scanner::pass_end_of_line()
{
  if(*m_position == '\r' && m_position + 1 != m_end && m_position[1] == '\n')
    ++m_position;
  ++m_position;
  ++m_line;
}

bool Text_scanner::has_word()
{
  skip_blanks();
  return m_position != m_end && !is_end_of_line(*m_position);
}

bool Text_scanner::find_line()
{
  while(!has_word())
  {
    if(m_position == m_end)
      return false;
    pass_end_of_line();
  }
  return true;
}

void Text_scanner::skip_line()
{
  while(has_word())
    word();
  if(m_position != m_end)
    pass_end_of_line();
}

std::string_view Text_scanner::word()
{
  const std::string_view result = peek_word();
  m_position += result.size();
  return result;
}

std::string_view Text_scanner::peek_word()
{
  if(!has_word())
    return {};
  const char* last = m_position;
  while(last != m_end && !is_blank(*last) && !is_end_of_line(*last) && (*last != m_comment || m_comment == 0)
        && !(*last == '\\' && m_has_continuation && last + 1 != m_end && is_end_of_line(last[1])))
    ++last;
  return std::string_view(m_position, static_cast<std::size_t>(last - m_position));
}

double Text_scanner::number(const char* what)
{
  const std::string_view text = word();
  const char *first = text.data(), *const last = text.data() + text.size();
  if(text.size() > 1 && *first == '+' && first[1] != '-')
    ++first;
  double x = 0;
  const std::from_chars_result result = std::from_chars(first, last, x);
  if(result.ec == std::errc::result_out_of_range && result.ptr == last)
    x = std::strtod(std::string(first, last).c_str(), nullptr); // a tiny number becomes 0; a large one is infinite
  else if(text.empty() || result.ec != std::errc() || result.ptr != last)
    complain_of_number(text, what);
  if(!std::isfinite(x))
    complain_of(text, std::string("is not a finite number: ").append(what).append(" is needed"));
  return x;
}

std::int64_t Text_scanner::integer(const char* what, std::int64_t least, std::int64_t most)
{
  const std::string_view text = word();
  std::int64_t i = 0;
  const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), i);
  if(text.empty() || result.ec == std::errc::invalid_argument || result.ptr != text.data() + text.size())
    complain_of_number(text, what);
  if(result.ec != std::errc() || i < least || i > most)
    complain_of(text, std::string("is not ").append(what).append(
                        most < least ? "" : " from " + std::to_string(least) + " to " + std::to_string(most)));
  return i;
}

std::int64_t Text_scanner::integer_before_slash()
{
  std::int64_t i = 0;
  const std::from_chars_result result = std::from_chars(m_position, m_end, i);
  if(result.ec != std::errc())
    return 0;
  m_position = result.ptr;
  return i;
}

void Text_scanner::complain_of_number(std::string_view word, const char* what) const
{
  if(word.empty())
    complain(std::string("the line ends, but ").append(what).append(" is needed"));
  if(has_decimal_comma(word))
    complain_of(word, "is not a number: decimals are written with a point, not with a comma");
  complain_of(word, std::string("is not ").append(what));
}

void Text_scanner::complain(const std::string& what) const
{
  reject_line(m_file_name, m_line, what);
}

void Text_scanner::complain_of(std::string_view word, const std::string& what) const
{
  complain("'" + shown(word) + "' " + what);
}

} // namespace geodesics_demo
