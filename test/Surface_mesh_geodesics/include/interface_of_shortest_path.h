#ifndef SURFACE_MESH_GEODESICS_INTERFACE_OF_SHORTEST_PATH_H
#define SURFACE_MESH_GEODESICS_INTERFACE_OF_SHORTEST_PATH_H

// All public types, constructors, members and static members of Surface_mesh_shortest_path, by name and by type, as in
// CGAL 5.5 to 6.2: has_interface_of_shortest_path<Class, Traits, AABB_traits>() does not compile if the class lacks one
// of them. Nothing is called.

#include <CGAL/AABB_tree.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <iterator>
#include <list>
#include <type_traits>
#include <utility>
#include <vector>

namespace interface_of_shortest_path {

template <class A, class B>
constexpr void same()
{
  static_assert(std::is_same<A, B>::value, "the types differ");
}

// Tells whether there is an overload with this type.
template <class Function>
constexpr void has(Function)
{}

template <class Paths, class Traits>
constexpr void has_types()
{
  using Mesh = typename Traits::Triangle_mesh;
  using Graph_traits = boost::graph_traits<Mesh>;
  same<typename Paths::Triangle_mesh, Mesh>();
  same<typename Paths::Graph_traits, Graph_traits>();
  same<typename Paths::vertex_descriptor, typename Graph_traits::vertex_descriptor>();
  same<typename Paths::halfedge_descriptor, typename Graph_traits::halfedge_descriptor>();
  same<typename Paths::face_descriptor, typename Graph_traits::face_descriptor>();
  same<typename Paths::Vertex_index_map, typename boost::property_map<Mesh, boost::vertex_index_t>::const_type>();
  same<typename Paths::Halfedge_index_map, typename boost::property_map<Mesh, boost::halfedge_index_t>::const_type>();
  same<typename Paths::Face_index_map, typename boost::property_map<Mesh, boost::face_index_t>::const_type>();
  same<typename Paths::Vertex_point_map, typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type>();
  same<typename Paths::FT, typename Traits::FT>();
  same<typename Paths::Point_3, typename Traits::Point_3>();
  same<typename Paths::Barycentric_coordinates, typename Traits::Barycentric_coordinates>();
#ifndef CGAL_NO_DEPRECATED_CODE
  same<typename Paths::Barycentric_coordinate, typename Traits::Barycentric_coordinates>();
#endif
  same<typename Paths::Face_location,
       std::pair<typename Paths::face_descriptor, typename Paths::Barycentric_coordinates>>();
  same<typename Paths::Shortest_path_result, std::pair<typename Paths::FT, typename Paths::Source_point_iterator>>();
}

template <class Paths>
constexpr void has_iterator()
{
  using Iterator = typename Paths::Source_point_iterator;
  using Location = typename Paths::Face_location;
  same<typename Iterator::iterator_category, std::bidirectional_iterator_tag>();
  same<typename Iterator::value_type, Location>();
  same<std::remove_const_t<std::remove_pointer_t<typename Iterator::pointer>>, Location>();
  same<std::remove_const_t<std::remove_reference_t<typename Iterator::reference>>, Location>();
  static_assert(std::is_default_constructible<Iterator>::value, "");
  static_assert(std::is_copy_constructible<Iterator>::value && std::is_copy_assignable<Iterator>::value, "");
  has<const Location& (Iterator::*)() const>(&Iterator::operator*);
  has<const Location* (Iterator::*)() const>(&Iterator::operator->);
  has<Iterator& (Iterator::*)()>(&Iterator::operator++);
  has<Iterator (Iterator::*)(int)>(&Iterator::operator++);
  has<Iterator& (Iterator::*)()>(&Iterator::operator--);
  has<Iterator (Iterator::*)(int)>(&Iterator::operator--);
  has<bool (Iterator::*)(const Iterator&) const>(&Iterator::operator==);
  has<bool (Iterator::*)(const Iterator&) const>(&Iterator::operator!=);
}

template <class Paths, class Traits>
constexpr void has_constructors()
{
  using Mesh = const typename Paths::Triangle_mesh&;
  using VIM = typename Paths::Vertex_index_map;
  using HIM = typename Paths::Halfedge_index_map;
  using FIM = typename Paths::Face_index_map;
  using VPM = typename Paths::Vertex_point_map;
  static_assert(std::is_convertible<Mesh, Paths>::value, ""); // not explicit
  static_assert(std::is_constructible<Paths, Mesh, const Traits&>::value, "");
  static_assert(std::is_constructible<Paths, Mesh, VIM, HIM, FIM, VPM>::value, "");
  static_assert(std::is_constructible<Paths, Mesh, VIM, HIM, FIM, VPM, const Traits&>::value, "");
  static_assert(std::is_destructible<Paths>::value, "");
}

template <class Paths>
constexpr void has_source_points()
{
  using Iterator = typename Paths::Source_point_iterator;
  using Vertex = typename Paths::vertex_descriptor;
  using Face = typename Paths::face_descriptor;
  using Coordinates = typename Paths::Barycentric_coordinates;
  using Location = typename Paths::Face_location;
  using Vertices = typename std::vector<Vertex>::const_iterator;
  using Locations = typename std::list<Location>::iterator;
  has<Iterator (Paths::*)(Vertex)>(&Paths::add_source_point);
  has<Iterator (Paths::*)(Face, const Coordinates&)>(&Paths::add_source_point);
  has<Iterator (Paths::*)(const Location&)>(&Paths::add_source_point);
  has<Iterator (Paths::*)(Vertices, Vertices)>(&Paths::template add_source_points<Vertices>);
  has<Iterator (Paths::*)(Locations, Locations)>(&Paths::template add_source_points<Locations>);
  has<void (Paths::*)(Iterator)>(&Paths::remove_source_point);
  has<void (Paths::*)()>(&Paths::remove_all_source_points);
  has<void (Paths::*)()>(&Paths::build_sequence_tree);
  has<void (Paths::*)()>(&Paths::clear);
  has<Iterator (Paths::*)() const>(&Paths::source_points_begin);
  has<Iterator (Paths::*)() const>(&Paths::source_points_end);
  has<std::size_t (Paths::*)() const>(&Paths::number_of_source_points);
  has<bool (Paths::*)() const>(&Paths::changed_since_last_build);
}

template <class Paths, class Visitor>
constexpr void has_queries()
{
  using Result = typename Paths::Shortest_path_result;
  using Vertex = typename Paths::vertex_descriptor;
  using Face = typename Paths::face_descriptor;
  using Coordinates = typename Paths::Barycentric_coordinates;
  using Output = std::back_insert_iterator<std::vector<typename Paths::Point_3>>;
  has<Result (Paths::*)(Vertex)>(&Paths::shortest_distance_to_source_points);
  has<Result (Paths::*)(Face, const Coordinates&)>(&Paths::shortest_distance_to_source_points);
  has<Result (Paths::*)(Vertex, Visitor&)>(&Paths::template shortest_path_sequence_to_source_points<Visitor>);
  has<Result (Paths::*)(Face, const Coordinates&, Visitor&)>(
    &Paths::template shortest_path_sequence_to_source_points<Visitor>);
  has<Result (Paths::*)(Vertex, Output)>(&Paths::template shortest_path_points_to_source_points<Output>);
  has<Result (Paths::*)(Face, const Coordinates&, Output)>(
    &Paths::template shortest_path_points_to_source_points<Output>);
}

template <class Paths, class Traits>
constexpr void has_points_and_locations()
{
  using Mesh = typename Paths::Triangle_mesh;
  using VPM = typename Paths::Vertex_point_map;
  using FT = typename Paths::FT;
  using Point = typename Paths::Point_3;
  using Vertex = typename Paths::vertex_descriptor;
  using Halfedge = typename Paths::halfedge_descriptor;
  using Face = typename Paths::face_descriptor;
  using Coordinates = typename Paths::Barycentric_coordinates;
  using Location = typename Paths::Face_location;
  using Vertex_point = decltype(get(std::declval<const VPM&>(), std::declval<Vertex>()));
  has<Point (Paths::*)(Face, const Coordinates&) const>(&Paths::point);
  has<Point (*)(Face, const Coordinates&, const Mesh&, const Traits&)>(&Paths::point);
  has<Point (*)(Face, const Coordinates&, const Mesh&, VPM, const Traits&)>(&Paths::point);
  has<Point (Paths::*)(Halfedge, FT) const>(&Paths::point);
  has<Point (*)(Halfedge, FT, const Mesh&, const Traits&)>(&Paths::point);
  has<Point (*)(Halfedge, FT, const Mesh&, VPM, const Traits&)>(&Paths::point);
  has<Vertex_point (Paths::*)(Vertex) const>(&Paths::point);
  has<Vertex_point (*)(Vertex, const Mesh&)>(&Paths::point);
  has<Location (Paths::*)(Vertex) const>(&Paths::face_location);
  has<Location (*)(Vertex, const Mesh&, const Traits&)>(&Paths::face_location);
  has<Location (Paths::*)(Halfedge, FT) const>(&Paths::face_location);
  has<Location (*)(Halfedge, FT, const Mesh&, const Traits&)>(&Paths::face_location);
}

template <class Paths, class Traits, class AABB_traits, class Query>
constexpr void has_locate()
{
  using Mesh = typename Paths::Triangle_mesh;
  using VPM = typename Paths::Vertex_point_map;
  using Location = typename Paths::Face_location;
  using Tree = CGAL::AABB_tree<AABB_traits>;
  has<Location (Paths::*)(const Query&) const>(&Paths::template locate<AABB_traits>);
  has<Location (*)(const Query&, const Mesh&, VPM, const Traits&)>(&Paths::template locate<AABB_traits>);
  has<Location (Paths::*)(const Query&, const Tree&) const>(&Paths::template locate<AABB_traits>);
  has<Location (*)(const Query&, const Tree&, const Mesh&, VPM, const Traits&)>(&Paths::template locate<AABB_traits>);
}

template <class Paths, class AABB_traits>
constexpr void has_tree()
{
  using Mesh = typename Paths::Triangle_mesh;
  using VPM = typename Paths::Vertex_point_map;
  using Tree = CGAL::AABB_tree<AABB_traits>;
  has<void (Paths::*)(Tree&) const>(&Paths::template build_aabb_tree<AABB_traits>);
  has<void (Paths::*)(Tree&, VPM) const>(&Paths::template build_aabb_tree<AABB_traits>);
  has<void (*)(const Mesh&, Tree&, VPM)>(&Paths::template build_aabb_tree<AABB_traits>);
}

// The traits of a static member are optional: the type of a function does not tell.
template <class Paths, class AABB_traits, class Ray>
auto static_members_without_traits(const typename Paths::Triangle_mesh& tm, typename Paths::Vertex_point_map vpm,
                                   typename Paths::vertex_descriptor v, typename Paths::halfedge_descriptor h,
                                   const typename Paths::Face_location& l, const typename Paths::FT& t,
                                   const CGAL::AABB_tree<AABB_traits>& tree, const typename Paths::Point_3& p,
                                   const Ray& ray)
  -> decltype(Paths::point(l.first, l.second, tm), Paths::point(l.first, l.second, tm, vpm), Paths::point(h, t, tm),
              Paths::point(h, t, tm, vpm), Paths::face_location(v, tm), Paths::face_location(h, t, tm),
              Paths::template locate<AABB_traits>(p, tm, vpm), Paths::locate(p, tree, tm, vpm),
              Paths::template locate<AABB_traits>(ray, tm, vpm), Paths::locate(ray, tree, tm, vpm));

template <class Paths, class Traits, class AABB_traits, class Visitor>
constexpr bool has_interface_of_shortest_path()
{
  has_types<Paths, Traits>();
  has_iterator<Paths>();
  has_constructors<Paths, Traits>();
  has_source_points<Paths>();
  has_queries<Paths, Visitor>();
  has_points_and_locations<Paths, Traits>();
  has_locate<Paths, Traits, AABB_traits, typename Paths::Point_3>();
  has_locate<Paths, Traits, AABB_traits, typename Traits::Ray_3>();
  has_tree<Paths, AABB_traits>();
  has(&static_members_without_traits<Paths, AABB_traits, typename Traits::Ray_3>);
  return true;
}

} // namespace interface_of_shortest_path

#endif // SURFACE_MESH_GEODESICS_INTERFACE_OF_SHORTEST_PATH_H
