// A pseudo-source emits windows exactly into the faces in which a shortest path may continue. No shortest path through
// the vertex enters a face that lies within half a turn of the direction of arrival, on either side of it. A vertex of
// a curve emits between the normals of the curve only.

#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Strip_front.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace test_meshes;

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using internal::Halfedge_id;
using internal::Vertex_id;
using Intrinsic_mesh = internal::Intrinsic_mesh<double>;
using Field = internal::Vertex_distance_field<double>;

// The faces into which a vertex has emitted windows, and the distance of the vertex at that time.
struct Emission
{
  Vertex_id vertex;
  internal::Face_id face;
  double distance;
  internal::Window<double> window;
};

// Receives all windows that are propagated. A window that has not crossed a face is new.
class Recorder
{
public:
  Recorder(const Intrinsic_mesh& mesh, std::vector<Emission>& emissions) : m_mesh(&mesh), m_emissions(&emissions) {}

  void keep(Halfedge_id h, const internal::Window_list<double>& list) const
  {
    for(std::size_t i = 0; i < list.size; ++i)
    {
      const internal::Window<double> w = list.columns.get(i);
      if(w.number_of_faces_crossed() == 0)
      {
        m_emissions->push_back(Emission{w.root, internal::face_of(m_mesh->opposite(h)), w.root_distance, w});
      }
    }
  }

  void advance(double) const {}

private:
  const Intrinsic_mesh* m_mesh;
  std::vector<Emission>* m_emissions;
};

// The angle at corner k of a face.
double angle_of_corner(const Intrinsic_mesh& mesh, Halfedge_id h)
{
  const auto corner = internal::angle_direction(mesh.face(internal::face_of(h)), internal::index_in_face(h));
  return std::atan2(corner.second, corner.first);
}

// The two angles between which a face lies, counterclockwise from the direction in which the path arrives at a vertex.
// The third number is the sum of all angles. Requires: the vertex is not on the border.
bool find_angles(const Intrinsic_mesh& mesh, const Field& field, Vertex_id v, internal::Face_id f,
                 std::array<double, 3>& angles)
{
  const Halfedge_id across = field.arrival[v].halfedge, first = internal::previous_halfedge(across);
  const internal::Face_frame<double> c = mesh.face_frame(across);
  const double x = field.arrival[v].abscissa;
  // the part of the face of arrival that follows counterclockwise
  const double dx = x - c.apex_x, dy = -c.apex_y, bx = c.length - c.apex_x, by = -c.apex_y;
  const double begin = std::atan2(dx * by - dy * bx, dx * bx + dy * by);
  double angle = begin;
  bool is_found = false;
  for(Halfedge_id h = mesh.next_around_source(first); h != first; h = mesh.next_around_source(h))
  {
    if(h == internal::null_id)
    {
      return false;
    }
    const double next = angle + angle_of_corner(mesh, h);
    if(internal::face_of(h) == f)
    {
      angles[0] = angle;
      angles[1] = next;
      is_found = true;
    }
    angle = next;
  }
  angles[2] = angle - begin + angle_of_corner(mesh, first);
  return is_found;
}

struct Counts
{
  std::size_t emissions = 0, hidden = 0, of_first_face = 0;
};

// Considers only windows that a vertex emits at its final distance. In rare cases a vertex emits windows once more,
// into all faces.
void look_at_emissions(const Indexed_mesh& indexed, std::size_t source, Counts& counts)
{
  const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(indexed));
  Field field;
  std::vector<Emission> emissions;
  internal::Distance_propagation<double, internal::All_pruning_rules, Recorder> propagation(mesh, field,
                                                                                            Recorder(mesh, emissions));
  propagation.add_source(static_cast<Vertex_id>(source % mesh.number_of_vertices()), 0.);
  CHECK(propagation.run([](std::size_t, double) { return true; }));
  const double half_turn = std::acos(-1.), margin = 1e-5;
  for(const Emission& e : emissions)
  {
    if(field.is_source(e.vertex) || e.distance != field.distance[e.vertex])
    {
      continue;
    }
    ++counts.emissions;
    std::array<double, 3> angles;
    if(e.face == internal::face_of(field.arrival[e.vertex].halfedge))
    {
      ++counts.of_first_face;
    }
    else if(find_angles(mesh, field, e.vertex, e.face, angles) &&
            (angles[1] < half_turn - margin || angles[2] - angles[0] < half_turn - margin))
    {
      ++counts.hidden;
    }
  }
}

void windows_start_where_paths_bend(std::uint64_t seed)
{
  Counts counts;
  for(const Indexed_mesh& indexed : {rough_terrain(12, .3, seed), noisy_sphere(3, .2, seed), saddle_patch(10),
                                     jittered(genus_2_polycube(), .05, seed)})
  {
    for(const std::size_t source : {std::size_t(0), std::size_t(17), std::size_t(40)})
    {
      look_at_emissions(indexed, source, counts);
    }
  }
  std::cout << counts.emissions << " windows of vertices where paths bend, " << counts.hidden + counts.of_first_face
            << " of them in hidden faces" << std::endl;
  CHECK(counts.emissions > 1000);
  CHECK(100 * counts.hidden <= counts.emissions);
  CHECK(100 * counts.of_first_face <= counts.emissions);
}

// --- curves ---

// A star of a vertex, with the angle of each halfedge from the first one. Requires: the vertex is not pinched.
struct Angles
{
  std::vector<Halfedge_id> halfedges; // that leave the vertex and have a face
  std::vector<double> angles;         // one more than halfedges: the last one is the sum of all angles
  bool is_closed;

  Angles(const Intrinsic_mesh& mesh, Vertex_id v) : angles(1, 0.)
  {
    const Halfedge_id first = mesh.halfedge(v);
    Halfedge_id h = first;
    for(; h != internal::null_id && (h != first || halfedges.empty()); h = mesh.next_around_source(h))
    {
      halfedges.push_back(h);
      angles.push_back(angles.back() + angle_of_corner(mesh, h));
    }
    is_closed = h != internal::null_id;
  }

  double difference(double a, double b) const
  {
    const double d = std::abs(a - b);
    return is_closed ? (std::min)(d, angles.back() - d) : d;
  }
};

using Edges = std::vector<internal::Source_edge<double>>;

// The angle of the first and of the last path of a window that its vertex has emitted, in the star of the vertex.
std::array<double, 2> angles_of_window(const Intrinsic_mesh& mesh, const Angles& star, const Emission& e)
{
  std::array<double, 2> angles{};
  for(std::size_t i = 0; i < star.halfedges.size(); ++i)
    if(internal::face_of(star.halfedges[i]) == e.face)
    {
      // The window is in the frame of ba; seen from v, b is on its left.
      const internal::Face_frame<double> c = mesh.face_frame(internal::next_halfedge(star.halfedges[i]));
      const auto angle_at = [&](double x)
      {
        const double ax = -c.apex_x, y = -c.apex_y, px = c.length - x - c.apex_x;
        return star.angles[i] + std::atan2(ax * y - y * px, ax * px + y * y);
      };
      angles = {angle_at(e.window.end), angle_at(e.window.begin)};
    }
  return angles;
}

// The smallest angle between an edge of the curves at a vertex and a path of a window that it has emitted.
double smallest_angle(const Intrinsic_mesh& mesh, const Edges& edges, const Emission& e)
{
  const Angles star(mesh, e.vertex);
  double smallest = Field::infinity();
  for(const double angle : angles_of_window(mesh, star, e))
    for(std::size_t k = 0; k < star.angles.size(); ++k)
      for(const auto& edge : edges)
      {
        const Halfedge_id h = k < star.halfedges.size() ? star.halfedges[k]
                                                        : internal::previous_halfedge(star.halfedges[k - 1]);
        if(h == edge.left || h == edge.right)
          smallest = (std::min)(smallest, star.difference(angle, star.angles[k]));
      }
  return smallest;
}

// The windows that vertices of curves emit.
std::vector<Emission> emissions_of_curves(const Intrinsic_mesh& mesh, const std::vector<Halfedge_id>& halfedges,
                                          Edges& edges)
{
  internal::Source_curves<double> curves;
  for(const Halfedge_id h : halfedges)
  {
    curves.edges.push_back(internal::Source_edge<double>{h, mesh.opposite(h), mesh.source(h), mesh.target(h),
                                                         mesh.length(h), 0, 0, 0, 0, 1});
    for(const Vertex_id v : {mesh.source(h), mesh.target(h)})
      curves.vertices.push_back(internal::Source_vertex<double>{v, 0, {0, 0, 0}});
  }
  edges = curves.edges;
  Field field;
  std::vector<Emission> emissions, of_curves;
  internal::Distance_propagation<double, internal::All_pruning_rules, Recorder, internal::Strip_front<double>>
    propagation(mesh, field, Recorder(mesh, emissions));
  propagation.restart();
  propagation.add_curves(curves);
  CHECK(propagation.run([](std::size_t, double) { return true; }));
  for(const Emission& e : emissions)
    if(e.distance == 0)
      of_curves.push_back(e);
  return of_curves;
}

void curves_emit_between_their_normals(std::uint64_t seed)
{
  test_support::Random random(seed);
  const double right_angle = std::acos(0.);
  std::size_t number = 0;
  for(const Indexed_mesh& indexed : {rough_terrain(12, .3, seed), noisy_sphere(3, .2, seed), saddle_patch(10),
                                     jittered(genus_2_polycube(), .05, seed)})
  {
    const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(indexed));
    std::vector<Halfedge_id> halfedges;
    for(int i = 0; i < 10; ++i)
      halfedges.push_back(internal::halfedge_of(static_cast<internal::Face_id>(random.index(mesh.number_of_faces())),
                                                static_cast<unsigned int>(random.index(3))));
    Edges edges;
    for(const Emission& e : emissions_of_curves(mesh, halfedges, edges))
    {
      ++number;
      CHECK(smallest_angle(mesh, edges, e) > right_angle - 1.001 / 1024);
    }
  }
  CHECK(number > 100);
}

// One or two spokes of a fan are curves. On each side of them, the center emits windows in the angle that is left
// between the normals, and a little beside them.
void spokes_leave_what_is_between_their_normals(const Indexed_mesh& indexed)
{
  const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(midpoint_subdivision(indexed)));
  const std::size_t n = indexed.faces.size();
  Vertex_id center = 0; // the mesh has numbers of its own
  while(Angles(mesh, center).halfedges.size() != n)
    ++center;
  const Angles star(mesh, center);
  const double half_turn = std::acos(-1.), beside = 2.001 / 1024;
  for(std::size_t k = 0; k < n; ++k)
  {
    std::vector<Halfedge_id> spokes{star.halfedges[0]};
    if(k > 0)
      spokes.push_back(star.halfedges[k]);
    double least = 0, most = 1e-12;
    for(const double side : {star.angles[k], star.angles[n] - star.angles[k]})
      if(side > half_turn + 1e-9)
      {
        least += side - half_turn;
        most += side - half_turn + beside;
      }
    Edges edges;
    double sum = 0;
    for(const Emission& e : emissions_of_curves(mesh, spokes, edges))
      if(e.vertex == center)
      {
        const std::array<double, 2> angles = angles_of_window(mesh, star, e);
        sum += angles[1] - angles[0];
      }
    CHECK(sum >= least - 1e-9);
    CHECK(sum <= most);
  }
}

// A square has no bend to the outside, seen from its inside: its border emits no window.
void straight_borders_emit_nothing()
{
  for(const std::size_t n : {4u, 7u})
  {
    const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(flat_patch(n, n, 0., false, 1)));
    std::vector<Halfedge_id> border;
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
      {
        const Halfedge_id h = internal::halfedge_of(static_cast<internal::Face_id>(f), k);
        if(mesh.opposite(h) == internal::null_id)
          border.push_back(h);
      }
    CHECK_EQUAL(border.size(), 4 * n);
    Edges edges;
    CHECK_EQUAL(emissions_of_curves(mesh, border, edges).size(), std::size_t(0));
  }
}

} // namespace

int main()
{
  windows_start_where_paths_bend(test_support::announce_seed(20261123));
  curves_emit_between_their_normals(20261126);
  spokes_leave_what_is_between_their_normals(fan("flat", 9, 0., 0.));
  spokes_leave_what_is_between_their_normals(fan("flat", 12, 0., 0.));
  spokes_leave_what_is_between_their_normals(cone_fan(11));
  spokes_leave_what_is_between_their_normals(fan("needle", 8, -5., -5.)); // 70 degrees in all
  spokes_leave_what_is_between_their_normals(saddle_fan(14));
  straight_borders_emit_nothing();
  return test_result();
}
