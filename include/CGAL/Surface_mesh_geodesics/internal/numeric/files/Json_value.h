// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_JSON_VALUE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_JSON_VALUE_H

// Values of JSON, a strict reader and a writer: as much as manifests need, which is objects, arrays, texts and numbers.
//
// The reader accepts RFC 8259 with at most 20 levels, and without two members of one name. The writer prints numbers so
// that reading them again gives the same bits.
//
// Boost.PropertyTree, the only reader of JSON in the Boost of Debian 12, reads numbers as texts and accepts members
// twice; it cannot write a number without quotation marks. A manifest decides whether hours of work are kept or done
// again, so this reader takes a text as it is meant or not at all.

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <locale>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Members of an object keep their order. Functions that ask for a type or a member throw a Geodesic_matrix_store_error
// if the value has another type, or not that member.
class Json_value
{
public:
  // A word is `true`, `false` or `null`. Manifests have none, but members that other programs have added may.
  enum class Type { TEXT, NUMBER, ARRAY, OBJECT, WORD };
  using Members = std::vector<std::pair<std::string, Json_value>>;

  // An object without members.
  Json_value() : m_type(Type::OBJECT) {}
  Json_value(const std::string& text) : m_type(Type::TEXT), m_text(text) {}
  Json_value(const char* text) : m_type(Type::TEXT), m_text(text) {}
  // Requires: the number is finite.
  // Infinity and values that are not numbers do not exist in JSON; locations and radii that are not finite have been
  // rejected before.
  Json_value(double number) : m_type(Type::NUMBER), m_number(number) {}
  // Requires: the number is at most 2^53.
  Json_value(std::size_t number) : Json_value(static_cast<double>(number)) {}
  // The elements may have different types.
  Json_value(std::vector<Json_value> elements) : m_type(Type::ARRAY), m_elements(std::move(elements)) {}

  // Requires: the text is one of the words.
  static Json_value word(const std::string& text)
  {
    Json_value value(text);
    value.m_type = Type::WORD;
    return value;
  }

  // Callers that accept a text or a list, as for sources, ask for the type.
  Type type() const { return m_type; }
  bool is_text(const std::string& text) const { return m_type == Type::TEXT && m_text == text; }

  // The three functions throw unless the value has the type.
  const std::string& text() const { return expect(Type::TEXT, "a text"), m_text; }
  double number() const { return expect(Type::NUMBER, "a number"), m_number; }
  const std::vector<Json_value>& elements() const { return expect(Type::ARRAY, "an array"), m_elements; }
  const Members& members() const { return expect(Type::OBJECT, "an object"), m_members; }

  // A number that counts something: whole, from 0 to 2^53.
  std::size_t count() const
  {
    const double value = number();
    if(!(value >= 0) || value > 9007199254740992. || value != std::floor(value))
      complain("a number is not a whole one");
    return static_cast<std::size_t>(value);
  }

  // Returns a member, or null if there is none.
  const Json_value* find(const std::string& name) const
  {
    for(const auto& member : members())
      if(member.first == name)
        return &member.second;
    return nullptr;
  }

  // The same, for members that must be there.
  const Json_value& at(const std::string& name) const
  {
    const Json_value* const value = find(name);
    if(value == nullptr)
      complain("the member '" + name + "' is missing");
    return *value;
  }

  // Adds a member. Requires: there is none of this name.
  void add(const std::string& name, Json_value value) { m_members.emplace_back(name, std::move(value)); }

  // The text of the value: a line for each member, and arrays of numbers in one line.
  std::string written(std::size_t indentation = 0) const
  {
    switch(m_type)
    {
      case Type::TEXT: return quoted(m_text);
      case Type::NUMBER: return written_number();
      case Type::WORD: return m_text;
      case Type::ARRAY: return written_array(indentation);
      default: return written_object(indentation);
    }
  }

  [[noreturn]] static void complain(const std::string& what)
  {
    throw Geodesic_matrix_store_error(Geodesic_matrix_store_error::Reason::NOT_A_STORE,
                                      "the manifest is damaged: " + what);
  }

private:
  // Throws unless the value has this type.
  void expect(Type type, const char* what) const
  {
    if(m_type != type)
      complain(std::string("a value is not ") + what);
  }

  // The number of bytes of the character of UTF-8 at a position; 0 if there is none.
  static std::size_t bytes_of_character(const std::string& text, std::size_t i)
  {
    const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
    const unsigned int first = byte(i), second = byte(i + 1);
    const std::size_t n
      = first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
    for(std::size_t k = 1; k < n; ++k)
      if((byte(i + k) & 0xc0) != 0x80)
        return 0;
    // More bytes than needed, halves of characters, and codes beyond the last one.
    const bool is_wrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0)
                       || (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
    return is_wrong ? 0 : n;
  }

  // Only what JSON requires is escaped: quotation marks, backslashes, control characters. Bytes that are not UTF-8, as
  // names of files may have, become the codes U+DC80 to U+DCFF, as in Python.
  static std::string quoted(const std::string& text)
  {
    std::string result = "\"";
    for(std::size_t i = 0; i < text.size();)
    {
      const std::size_t n = bytes_of_character(text, i);
      const unsigned int c = static_cast<unsigned char>(text[i]);
      if(c == '"' || c == '\\')
        result += '\\';
      if(n == 0 || c < 0x20)
      {
        char code[8];
        std::snprintf(code, sizeof code, "\\u%04x", n == 0 ? 0xdc00 + c : c);
        result += code;
      }
      else
        result.append(text, i, n);
      i += n == 0 ? 1 : n;
    }
    return result + '"';
  }

  // The shortest text that leads back to the number, in any locale. Whole numbers have neither a point nor an exponent:
  // other readers tell integers by that.
  std::string written_number() const
  {
    const bool is_minus_zero = m_number == 0 && std::signbit(m_number); // integers have no such number
    if(m_number == std::floor(m_number) && std::abs(m_number) < 9007199254740992. && !is_minus_zero)
      return std::to_string(static_cast<long long>(m_number));
    char text[40];
    const std::to_chars_result end = std::to_chars(text, text + sizeof text, m_number);
    return std::string(text, end.ptr);
  }

  // Elements that are arrays or objects get a line each, so that a person can read the list of shards.
  std::string written_array(std::size_t indentation) const
  {
    bool is_flat = true;
    for(const Json_value& element : m_elements)
      is_flat = is_flat && element.m_type == Type::NUMBER;
    const std::string line = is_flat ? "" : '\n' + std::string(indentation + 2, ' ');
    std::string result = "[";
    for(std::size_t k = 0; k < m_elements.size(); ++k)
      result += (k == 0 ? "" : is_flat ? ", " : ",") + line + m_elements[k].written(indentation + 2);
    return result + (is_flat || m_elements.empty() ? "]" : '\n' + std::string(indentation, ' ') + ']');
  }

  // A line for each member.
  std::string written_object(std::size_t indentation) const
  {
    const std::string line = '\n' + std::string(indentation + 2, ' ');
    std::string result = "{";
    for(std::size_t k = 0; k < m_members.size(); ++k)
      result += (k == 0 ? "" : ",") + line + quoted(m_members[k].first) + ": "
              + m_members[k].second.written(indentation + 2);
    return result + (m_members.empty() ? "}" : '\n' + std::string(indentation, ' ') + '}');
  }

  Type m_type;
  std::string m_text;
  double m_number = 0;
  // Only the member that belongs to the type is used.
  std::vector<Json_value> m_elements;
  Members m_members;
};

// Reads a text. Each function begins at m_next, and leaves it behind what it has read.
class Json_reader
{
public:
  explicit Json_reader(const std::string& text) : m_text(text) {}

  // Returns the value that is the whole text.
  Json_value read()
  {
    Json_value value = read_value(0);
    skip_blanks();
    if(m_next != m_text.size())
      complain("something follows its end");
    return value;
  }

private:
  static constexpr int most_levels = 20;

  // Messages name the byte, as a damaged file may have no lines.
  [[noreturn]] void complain(const std::string& what) const
  {
    Json_value::complain(what + " (byte " + std::to_string(m_next) + ")");
  }

  // The four blanks of JSON; others, such as no-break spaces, are errors.
  void skip_blanks()
  {
    while(m_next < m_text.size() && (m_text[m_next] == ' ' || m_text[m_next] == '\n' || m_text[m_next] == '\r'
                                     || m_text[m_next] == '\t'))
      ++m_next;
  }

  // The next character that is not a blank; 0 at the end.
  char look()
  {
    skip_blanks();
    return m_next < m_text.size() ? m_text[m_next] : '\0';
  }

  // Reads the character if it is the next one behind blanks.
  bool take(char c)
  {
    if(look() != c)
      return false;
    ++m_next;
    return true;
  }

  // The same, where nothing else may follow.
  void expect(char c)
  {
    if(!take(c))
      complain(std::string("there is no '") + c + "'");
  }

  // The first character decides about the type. What begins like nothing else must be a word or a number. The level
  // bounds the depth of the recursion, whatever the text is.
  Json_value read_value(int level)
  {
    if(level > most_levels)
      complain("it has too many levels");
    switch(look())
    {
      case '{': return read_object(level);
      case '[': return read_array(level);
      case '"': return Json_value(read_text());
      default: break;
    }
    for(const std::string word : {"true", "false", "null"})
      if(m_text.compare(m_next, word.size(), word) == 0)
      {
        m_next += word.size();
        return Json_value::word(word);
      }
    return Json_value(read_number());
  }

  // Names are compared with all before, which takes quadratic time; objects of manifests have few members.
  Json_value read_object(int level)
  {
    Json_value object;
    expect('{');
    if(take('}'))
      return object;
    do
    {
      if(look() != '"')
        complain("a member has no name");
      const std::string name = read_text();
      expect(':');
      if(object.find(name) != nullptr)
        complain("there are two members '" + name + "'");
      object.add(name, read_value(level + 1));
    } while(take(','));
    expect('}');
    return object;
  }

  // Takes linear time; lists of sources are the long ones.
  Json_value read_array(int level)
  {
    std::vector<Json_value> elements;
    expect('[');
    if(!take(']'))
    {
      do
        elements.push_back(read_value(level + 1));
      while(take(','));
      expect(']');
    }
    return Json_value(std::move(elements));
  }

  // JSON has no leading zeros, no plus sign and no bare points. The stream is that of the standard library, in its own
  // language, as libc++ 14 has no std::from_chars() for numbers with a point. Short integers, of which lists of sources
  // are made, need no stream; they are exact.
  double read_number()
  {
    const std::size_t begin = m_next;
    m_next += m_next < m_text.size() && m_text[m_next] == '-' ? 1 : 0;
    const std::size_t digits = m_next;
    skip_digits();
    if(m_next == digits || (m_text[digits] == '0' && m_next > digits + 1))
      complain("there is no number");
    const bool is_short_integer = digits == begin && m_next - digits <= 15;
    double value = 0;
    for(std::size_t i = digits; is_short_integer && i < m_next; ++i)
      value = 10 * value + (m_text[i] - '0');
    if(skip_fraction_and_exponent() || !is_short_integer)
    {
      std::istringstream number(m_text.substr(begin, m_next - begin));
      number.imbue(std::locale::classic());
      if(!(number >> value) || !std::isfinite(value))
        complain("there is no number");
    }
    return value;
  }

  bool is_digit(std::size_t i) const { return i < m_text.size() && m_text[i] >= '0' && m_text[i] <= '9'; }

  void skip_digits()
  {
    while(is_digit(m_next))
      ++m_next;
  }

  // Returns whether there is a fraction or an exponent.
  bool skip_fraction_and_exponent()
  {
    const std::size_t begin = m_next;
    if(m_next < m_text.size() && m_text[m_next] == '.')
    {
      if(!is_digit(++m_next))
        complain("there is no number");
      skip_digits();
    }
    if(m_next < m_text.size() && (m_text[m_next] == 'e' || m_text[m_next] == 'E'))
    {
      ++m_next;
      if(m_next < m_text.size() && (m_text[m_next] == '+' || m_text[m_next] == '-'))
        ++m_next;
      if(!is_digit(m_next))
        complain("there is no number");
      skip_digits();
    }
    return m_next != begin;
  }

  // UTF-8 is not checked: it is the name of a file, and the system decides whether there is such a file.
  std::string read_text()
  {
    expect('"');
    std::string result;
    while(m_next < m_text.size() && m_text[m_next] != '"')
    {
      const char c = m_text[m_next++];
      if(static_cast<unsigned char>(c) < 0x20)
        complain("a text contains a control character");
      if(c == '\\')
        read_escape(result);
      else
        result += c;
    }
    if(m_next == m_text.size())
      complain("a text does not end");
    ++m_next;
    return result;
  }

  // Some writers escape all that is not ASCII; the result is UTF-8.
  void read_escape(std::string& result)
  {
    const std::string letters = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
    const char c = m_next < m_text.size() ? m_text[m_next++] : '\0';
    const std::size_t k = c == '\0' ? std::string::npos : letters.find(c);
    if(k != std::string::npos)
    {
      result += meanings[k];
      return;
    }
    if(c != 'u')
      complain("a text contains an unknown escape");
    unsigned int code = read_code_unit();
    if(code >= 0xd800 && code < 0xdc00) // the first one of two, which are 10 bits each
    {
      const bool has_second = m_text.compare(m_next, 2, "\\u") == 0;
      m_next += 2;
      const unsigned int second = has_second ? read_code_unit() : 0;
      if(second < 0xdc00 || second >= 0xe000)
        complain("a text contains half of a character");
      code = 0x10000 + ((code - 0xd800) << 10) + (second - 0xdc00);
    }
    else if(code >= 0xdc80 && code < 0xdd00) // a byte that is not UTF-8
    {
      result += static_cast<char>(code - 0xdc00);
      return;
    }
    else if(code >= 0xdc00 && code < 0xe000)
      complain("a text contains half of a character");
    append_utf8(result, code);
  }

  // The four digits behind \u.
  unsigned int read_code_unit()
  {
    unsigned int code = 0;
    const char* const begin = m_text.data() + m_next;
    if(m_next + 4 > m_text.size() || std::from_chars(begin, begin + 4, code, 16).ptr != begin + 4)
      complain("a text contains an unknown escape");
    m_next += 4;
    return code;
  }

  // Six bits in each byte but the first one, which tells the number of bytes.
  static void append_utf8(std::string& result, unsigned int code)
  {
    const unsigned int rest = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    const unsigned int marks[] = {0, 0xc0, 0xe0, 0xf0};
    result += static_cast<char>(marks[rest] | code >> (6 * rest));
    for(unsigned int k = rest; k-- > 0;)
      result += static_cast<char>(0x80 | (code >> (6 * k) & 0x3f));
  }

  const std::string& m_text;
  std::size_t m_next = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_JSON_VALUE_H
