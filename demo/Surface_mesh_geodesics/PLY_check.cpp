#include "PLY_check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace geodesics_demo {

namespace {

// A number type: its size in bytes, 0 for an unknown type.
struct Number_type
{
  std::size_t bytes = 0;
  bool is_signed = false;
  bool is_integer = true;
};

Number_type type_with_name(const std::string& name)
{
  static const std::map<std::string, Number_type> types{
    {"char", {1, true, true}},    {"int8", {1, true, true}},     {"uchar", {1, false, true}},
    {"uint8", {1, false, true}},  {"short", {2, true, true}},    {"int16", {2, true, true}},
    {"ushort", {2, false, true}}, {"uint16", {2, false, true}},  {"int", {4, true, true}},
    {"int32", {4, true, true}},   {"uint", {4, false, true}},    {"uint32", {4, false, true}},
    {"float", {4, true, false}},  {"float32", {4, true, false}}, {"double", {8, true, false}},
    {"float64", {8, true, false}}};
  const auto found = types.find(name);
  return found == types.end() ? Number_type() : found->second;
}

struct Property
{
  bool is_list = false;
  Number_type size, value; // `size` is the type of the length of a list
};

struct Element
{
  double count = 0;
  std::vector<Property> properties;
};

enum class Format { ASCII, LITTLE_ENDIAN_BYTES, BIG_ENDIAN_BYTES };

class PLY_file
{
public:
  explicit PLY_file(const std::string& file_name)
    : m_in(file_name, std::ios::binary), m_size(static_cast<double>(std::filesystem::file_size(file_name)))
  {}

  bool is_in_order() { return read_header() && has_room_for_elements(); }

private:
  bool read_header()
  {
    std::string line;
    for(bool is_first = true; std::getline(m_in, line); is_first = false)
    {
      std::istringstream words(line);
      std::string word;
      words >> word;
      if(word == "end_header")
        return true;
      if(is_first ? word != "ply" : !read_line(word, words))
        return false;
    }
    return false;
  }

  bool read_line(const std::string& keyword, std::istringstream& words)
  {
    std::string word;
    if(keyword == "format")
    {
      words >> word;
      m_format = word == "ascii"                ? Format::ASCII
               : word == "binary_little_endian" ? Format::LITTLE_ENDIAN_BYTES
                                                : Format::BIG_ENDIAN_BYTES;
      return word == "ascii" || word == "binary_little_endian" || word == "binary_big_endian";
    }
    if(keyword == "element")
    {
      m_elements.emplace_back();
      words >> word >> m_elements.back().count;
      return !words.fail() && m_elements.back().count >= 0 && m_elements.back().count <= m_size;
    }
    return keyword == "property" ? read_property(words) : keyword == "comment" || keyword == "obj_info";
  }

  bool read_property(std::istringstream& words)
  {
    if(m_elements.empty())
      return false;
    Property p;
    std::string word;
    words >> word;
    p.is_list = word == "list";
    if(p.is_list)
    {
      words >> word;
      p.size = type_with_name(word);
      words >> word;
    }
    p.value = type_with_name(word);
    m_elements.back().properties.push_back(p);
    return !words.fail() && p.value.bytes > 0 && (!p.is_list || (p.size.bytes > 0 && p.size.is_integer));
  }

  bool has_room_for_elements()
  {
    for(const Element& e : m_elements)
      for(double i = 0; i < e.count; ++i)
        for(const Property& p : e.properties)
        {
          const double entries = p.is_list ? read_size(p.size) : 1;
          if(!(entries >= 0) || !skip(entries, p.value))
            return false;
        }
    return true;
  }

  // The length of a list; NaN if it cannot be read.
  double read_size(const Number_type& type)
  {
    if(m_format == Format::ASCII)
    {
      std::string word;
      m_in >> word;
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      return m_in.fail() || *end != 0 ? std::nan("") : number;
    }
    unsigned char bytes[8];
    m_in.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(type.bytes));
    if(m_in.fail())
      return std::nan("");
    if(m_format == Format::LITTLE_ENDIAN_BYTES)
      std::reverse(bytes, bytes + type.bytes);
    std::uint32_t number = 0;
    for(std::size_t k = 0; k < type.bytes; ++k)
      number = (number << 8) | bytes[k];
    const bool is_negative = type.is_signed && (bytes[0] & 0x80) != 0;
    return is_negative ? -1. : static_cast<double>(number);
  }

  bool skip(double entries, const Number_type& type)
  {
    if(entries > m_size)
      return false;
    if(m_format != Format::ASCII)
    {
      const double left = m_size - static_cast<double>(m_in.tellg());
      if(entries * static_cast<double>(type.bytes) > left)
        return false;
      m_in.seekg(static_cast<std::streamoff>(entries * static_cast<double>(type.bytes)), std::ios::cur);
      return true;
    }
    std::string word;
    for(double k = 0; k < entries; ++k)
      if(!(m_in >> word))
        return false;
    return true;
  }

  std::ifstream m_in;
  double m_size; // of the file, in bytes
  Format m_format = Format::ASCII;
  std::vector<Element> m_elements;
};

} // namespace

bool may_read_PLY(const std::string& file_name)
{
  return !std::filesystem::is_regular_file(file_name) || PLY_file(file_name).is_in_order();
}

} // namespace geodesics_demo
