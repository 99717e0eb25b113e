#ifndef SURFACE_MESH_GEODESICS_UNUSUAL_ARGUMENTS_H
#define SURFACE_MESH_GEODESICS_UNUSUAL_ARGUMENTS_H

// Types of arguments that are unusual: models of what the concepts ask for, and of no more.

#include "test_meshes.h"

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace unusual {

using test_meshes::Mesh;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

// A FaceGraph that does not know its number of faces.
struct Face_graph : Mesh
{
  explicit Face_graph(const Mesh& mesh) : Mesh(mesh) {}
};
void num_faces(const Face_graph&) = delete;

// A range whose begin() and end() are functions.
template <typename Element>
struct Range
{
  std::vector<Element> elements;
};

template <typename Element>
const Element* begin(const Range<Element>& r)
{
  return r.elements.data();
}

template <typename Element>
const Element* end(const Range<Element>& r)
{
  return r.elements.data() + r.elements.size();
}

// A map that gives references to constants, and has a put() of its own.
struct Counting_map : boost::put_get_helper<const double&, Counting_map>
{
  using key_type = Vertex;
  using value_type = double;
  using reference = const double&;
  using category = boost::read_write_property_map_tag;

  std::vector<double>* distances = nullptr;
  std::size_t* number_of_puts = nullptr;

  const double& operator[](Vertex v) const { return (*distances)[v]; }

  friend void put(const Counting_map& m, Vertex v, double d)
  {
    (*m.distances)[v] = d;
    ++*m.number_of_puts;
  }
};

// A number type that doubles convert to explicitly only.
struct Number
{
  double value = 0;
  Number() = default;
  explicit Number(double v) : value(v) {}
};

// An output iterator with a template that takes one type only.
template <typename Value>
struct Counting_output
{
  std::size_t* number;
  Counting_output& operator*() { return *this; }
  Counting_output& operator++() { return *this; }
  Counting_output& operator++(int) { return *this; }
  template <typename Other, typename = std::enable_if_t<std::is_same<std::decay_t<Other>, Value>::value>>
  Counting_output& operator=(Other&&)
  {
    ++*number;
    return *this;
  }
};

} // namespace unusual

namespace boost {

template <>
struct graph_traits<unusual::Face_graph> : graph_traits<unusual::Mesh>
{};

template <typename Tag>
struct property_map<unusual::Face_graph, Tag> : property_map<unusual::Mesh, Tag>
{};

} // namespace boost

namespace CGAL {

template <>
struct graph_has_property<unusual::Face_graph, boost::vertex_point_t> : CGAL::Tag_true
{};

} // namespace CGAL

#endif // SURFACE_MESH_GEODESICS_UNUSUAL_ARGUMENTS_H
