#include "Byte_scanner.h"
#include "Mesh_readers.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace geodesics_demo {

namespace {

// --- the header -----------------------------------------------------------------------------------------------------

enum class Number_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT, DOUBLE, NONE };

Number_type type_with_name(std::string_view name)
{
  static const std::map<std::string_view, Number_type> types{
    {"char", Number_type::INT8},     {"int8", Number_type::INT8},      {"uchar", Number_type::UINT8},
    {"uint8", Number_type::UINT8},   {"short", Number_type::INT16},    {"int16", Number_type::INT16},
    {"ushort", Number_type::UINT16}, {"uint16", Number_type::UINT16},  {"int", Number_type::INT32},
    {"int32", Number_type::INT32},   {"uint", Number_type::UINT32},    {"uint32", Number_type::UINT32},
    {"float", Number_type::FLOAT},   {"float32", Number_type::FLOAT},  {"double", Number_type::DOUBLE},
    {"float64", Number_type::DOUBLE}};
  const auto found = types.find(name);
  return found == types.end() ? Number_type::NONE : found->second;
}

bool is_integer(Number_type type)
{
  return type != Number_type::FLOAT && type != Number_type::DOUBLE;
}

// What a property is for. All but coordinates, indices and marks are read past.
enum class Use { NOTHING, X, Y, Z, INDICES, MARK };

struct Property
{
  std::string name;
  Use use = Use::NOTHING;
  bool is_list = false;
  Number_type size = Number_type::NONE, value = Number_type::NONE; // `size` is the type of the length of a list
};

enum class Content { VERTICES, FACES, STRIPS, OTHER };

struct Element
{
  Content content = Content::OTHER;
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Format { NONE, TEXT, LOWEST_FIRST, HIGHEST_FIRST };

struct Header
{
  Format format = Format::NONE;
  std::vector<Element> elements;
};

Element element_of(Text_scanner& in)
{
  Element element;
  element.name = std::string(in.word());
  element.content = element.name == "vertex"    ? Content::VERTICES
                  : element.name == "face"      ? Content::FACES
                  : element.name == "tristrips" ? Content::STRIPS
                                                : Content::OTHER;
  element.count = static_cast<std::size_t>(in.integer("a number of elements", 0, most_points));
  return element;
}

Number_type next_type(Text_scanner& in)
{
  const std::string_view word = in.word();
  const Number_type type = type_with_name(word);
  if(type == Number_type::NONE)
    in.complain_of(word, "is not a type of numbers, such as int or float");
  return type;
}

Property property_of(Text_scanner& in, Content content)
{
  Property property;
  property.is_list = in.peek_word() == "list";
  if(property.is_list)
  {
    in.word();
    property.size = next_type(in);
    if(!is_integer(property.size))
      in.complain("the length of a list is not of a type of whole numbers");
  }
  property.value = next_type(in);
  const std::string_view name = in.word();
  property.name = std::string(name);
  if(content == Content::VERTICES && !property.is_list && name.size() == 1)
    property.use = name == "x" ? Use::X : name == "y" ? Use::Y : name == "z" ? Use::Z : Use::NOTHING;
  else if(content != Content::VERTICES && property.is_list && (name == "vertex_indices" || name == "vertex_index"))
  {
    if(!is_integer(property.value))
      in.complain("the indices of vertices are not of a type of whole numbers");
    property.use = Use::INDICES;
  }
  return property;
}

Format format_of(Text_scanner& in)
{
  const std::string_view word = in.word();
  if(word != "ascii" && word != "binary_little_endian" && word != "binary_big_endian")
    in.complain_of(word, "is not a format: ascii, binary_little_endian or binary_big_endian is needed");
  return word == "ascii" ? Format::TEXT : word == "binary_little_endian" ? Format::LOWEST_FIRST : Format::HIGHEST_FIRST;
}

// Vertices have three coordinates, and precede everything that refers to them.
void check(const Header& header, const Text_scanner& in)
{
  bool has_vertices = false;
  if(header.format == Format::NONE)
    in.complain("the header has no format");
  for(const Element& e : header.elements)
  {
    const auto has = [&](Use use)
    { return std::any_of(e.properties.begin(), e.properties.end(), [&](const Property& p) { return p.use == use; }); };
    if(e.content == Content::VERTICES && !(has(Use::X) && has(Use::Y) && has(Use::Z)))
      in.complain("the vertices have no coordinates x, y and z");
    has_vertices = has_vertices || e.content == Content::VERTICES;
    if((e.content == Content::FACES || e.content == Content::STRIPS) && !has_vertices)
      in.complain("the faces precede the vertices");
  }
}

Header read_header(Text_scanner& in)
{
  Header header;
  if(!in.find_line() || in.word() != "ply")
    in.complain("the first word of a PLY file is 'ply'");
  in.skip_line();
  while(in.find_line())
  {
    const std::string_view keyword = in.word();
    if(keyword == "end_header")
    {
      check(header, in);
      in.skip_line();
      return header;
    }
    if(keyword == "format")
      header.format = format_of(in);
    else if(keyword == "element")
      header.elements.push_back(element_of(in));
    else if(keyword == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(property_of(in, header.elements.back().content));
    else if(keyword != "comment" && keyword != "obj_info")
      in.complain_of(keyword, keyword == "property" ? "precedes the first element"
                                                    : "is not a line of the header of a PLY file");
    in.skip_line();
  }
  in.complain("the file ends within its header");
}

// Makes a property of faces the one that marks them. Throws a Command_error with the names of those that could.
void choose_mark(const std::string& file_name, const std::string& name, Header& header)
{
  std::string others;
  std::size_t found = 0;
  for(Element& e : header.elements)
  {
    if(e.content == Content::STRIPS)
      reject_file(file_name, "the faces are strips of triangles, which have no properties of their own");
    for(Property& p : e.properties)
    {
      if(e.content != Content::FACES || (p.is_list && p.name != name))
        continue;
      others += (others.empty() ? "" : ", ") + p.name;
      if(p.name != name)
        continue;
      if(p.is_list)
        reject_file(file_name, "the property '" + name + "' of faces is a list, but a number is needed");
      p.use = Use::MARK;
      ++found;
    }
  }
  if(found > 1)
    reject_file(file_name, "there are several properties '" + name + "' of faces");
  if(found == 0)
    reject_file(file_name, "the faces have no property '" + name + "'"
                             + (others.empty() ? ", and none that is a number" : "; they have: " + others));
}

// --- the data -------------------------------------------------------------------------------------------------------

// The items of a file are numbers and lists of numbers. A source of numbers has the members
//   double number(Number_type); std::int64_t integer(Number_type); void skip(Number_type);
//   std::size_t rest(): the bytes that are left; std::uint32_t line(): 0 for binary files.
class Text_numbers
{
public:
  explicit Text_numbers(Text_scanner& in) : m_in(in) {}

  // The type says how many digits of a text mean something.
  double number(Number_type type)
  {
    find_word();
    const double x = m_in.number("a number");
    return type == Number_type::FLOAT ? double(static_cast<float>(x)) : x;
  }

  std::int64_t integer(Number_type)
  {
    find_word();
    return m_in.integer("a whole number", -0x80000000ll, 0xffffffffll);
  }

  void skip(Number_type)
  {
    find_word();
    m_in.word();
  }

  std::size_t rest() const { return m_in.rest(); }
  std::uint32_t line() const { return m_in.line(); }
  [[noreturn]] void complain(const std::string& what) const { m_in.complain(what); }

private:
  void find_word()
  {
    if(!m_in.find_line())
      m_in.complain("the file ends too early");
  }

  Text_scanner& m_in;
};

class Binary_numbers
{
public:
  Binary_numbers(const std::string& file_name, std::string_view bytes, Byte_order order)
    : m_file_name(file_name), m_in(file_name, bytes, order)
  {}

  double number(Number_type type)
  {
    return type == Number_type::FLOAT    ? double(m_in.next<float>())
         : type == Number_type::DOUBLE   ? m_in.next<double>()
                                         : static_cast<double>(integer(type));
  }

  std::int64_t integer(Number_type type)
  {
    switch(type)
    {
    case Number_type::INT8: return m_in.next<std::int8_t>();
    case Number_type::UINT8: return m_in.next<std::uint8_t>();
    case Number_type::INT16: return m_in.next<std::int16_t>();
    case Number_type::UINT16: return m_in.next<std::uint16_t>();
    case Number_type::INT32: return m_in.next<std::int32_t>();
    default: return m_in.next<std::uint32_t>();
    }
  }

  void skip(Number_type type) { number(type); }
  std::size_t rest() const { return m_in.rest(); }
  std::uint32_t line() const { return 0; }
  [[noreturn]] void complain(const std::string& what) const { reject_file(m_file_name, what); }

private:
  std::string m_file_name;
  Byte_scanner m_in;
};

// Reads all elements, in the order of the header.
template <typename Numbers>
class PLY_data_reader
{
public:
  explicit PLY_data_reader(Numbers& in) : m_in(in) {}

  Polygon_soup read(const Header& header)
  {
    for(const Element& e : header.elements)
      for(m_item = 0; m_item < e.count && !e.properties.empty(); ++m_item)
        read_item(e);
    return std::move(m_soup);
  }

private:
  void read_item(const Element& element)
  {
    double x = 0, y = 0, z = 0;
    for(const Property& p : element.properties)
      switch(p.use)
      {
      case Use::X: x = m_in.number(p.value); break;
      case Use::Y: y = m_in.number(p.value); break;
      case Use::Z: z = m_in.number(p.value); break;
      case Use::INDICES: read_indices(element, p); break;
      case Use::MARK: m_soup.is_marked.push_back(is_not_0(p)); break;
      case Use::NOTHING: skip(p); break;
      }
    if(element.content == Content::VERTICES)
      m_soup.points.emplace_back(x, y, z);
  }

  bool is_not_0(const Property& p)
  {
    if(is_integer(p.value))
      return m_in.integer(p.value) != 0;
    const double x = m_in.number(p.value);
    if(std::isnan(x))
      m_in.complain("the property '" + p.name + "' of face " + std::to_string(m_item) + " is not a number");
    return x != 0;
  }

  std::size_t length(const Property& p)
  {
    const std::int64_t n = m_in.integer(p.size);
    if(n < 0 || static_cast<std::size_t>(n) > m_in.rest()) // each entry has a byte at least
      m_in.complain("a list has the length " + std::to_string(n) + ", which is not that of a list in this file");
    return static_cast<std::size_t>(n);
  }

  void skip(const Property& p)
  {
    for(std::size_t n = p.is_list ? length(p) : 1; n > 0; --n)
      m_in.skip(p.value);
  }

  void read_indices(const Element& element, const Property& p)
  {
    const std::size_t n = length(p);
    if(element.content == Content::STRIPS)
      read_strip(n, p);
    else if(element.content == Content::FACES)
    {
      add_line();
      for(std::size_t k = 0; k < n; ++k)
        m_soup.corners.push_back(index(element, m_in.integer(p.value)));
      m_soup.end_face();
    }
    else
      for(std::size_t k = 0; k < n; ++k)
        m_in.skip(p.value);
  }

  // Each index adds a triangle with the two indices before it; every second triangle is turned over. -1 begins a strip.
  void read_strip(std::size_t n, const Property& p)
  {
    const Element element{Content::STRIPS, "tristrips", 0, {}};
    std::size_t length_of_strip = 0;
    Polygon_soup::Index last = 0, last_but_one = 0;
    for(std::size_t k = 0; k < n; ++k)
    {
      const std::int64_t i = m_in.integer(p.value);
      if(i == -1 || (i == 0xffffffffll && p.value == Number_type::UINT32))
      {
        length_of_strip = 0;
        continue;
      }
      const Polygon_soup::Index v = index(element, i);
      const bool is_degenerate = v == last || v == last_but_one || last == last_but_one; // joins two strips
      if(++length_of_strip > 2 && !is_degenerate)
      {
        add_line();
        length_of_strip % 2 == 1 ? m_soup.add_triangle(last_but_one, last, v)
                                 : m_soup.add_triangle(last, last_but_one, v);
      }
      last_but_one = last;
      last = v;
    }
  }

  Polygon_soup::Index index(const Element& element, std::int64_t i) const
  {
    if(i < 0 || static_cast<std::size_t>(i) >= m_soup.points.size())
      m_in.complain(element.name + " " + std::to_string(m_item) + " has the vertex " + std::to_string(i)
                    + ", but there are only " + std::to_string(m_soup.points.size()) + " vertices");
    return static_cast<Polygon_soup::Index>(i);
  }

  void add_line()
  {
    if(m_in.line() > 0)
      m_soup.lines.push_back(m_in.line());
  }

  Numbers& m_in;
  Polygon_soup m_soup;
  std::size_t m_item = 0;
};

// The data behind a header.
Polygon_soup contents_of(const std::string& file_name, Text_scanner& in, const Header& header)
{
  if(header.format == Format::TEXT)
  {
    Text_numbers numbers(in);
    return PLY_data_reader<Text_numbers>(numbers).read(header);
  }
  Binary_numbers numbers(file_name, std::string_view(in.position(), in.rest()),
                         header.format == Format::LOWEST_FIRST ? Byte_order::LOWEST_FIRST : Byte_order::HIGHEST_FIRST);
  return PLY_data_reader<Binary_numbers>(numbers).read(header);
}

} // namespace

Polygon_soup read_PLY(const std::string& file_name, std::string_view bytes, const std::string& mark)
{
  Text_scanner in(file_name, bytes, 0);
  Header header = read_header(in);
  if(!mark.empty())
    choose_mark(file_name, mark, header);
  Polygon_soup soup = contents_of(file_name, in, header);
  if(!mark.empty() && soup.is_marked.size() != soup.number_of_faces())
    reject_file(file_name, "there is not one property '" + mark + "' for each face");
  return soup;
}

} // namespace geodesics_demo
