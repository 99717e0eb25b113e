// For benchmark_flat_vertices: removes the flat vertices of a mesh that has been made by subdividing each triangle of a
// coarse mesh in the same way. Straight lines of edges through flat vertices lead from each other vertex to the next
// one. They are the edges of the coarse mesh, and their lengths are sums: no polygon is divided, and no error adds up
// from round to round. All other meshes are left alone.

#ifndef STRAIGHT_LINE_REMOVAL_H
#define STRAIGHT_LINE_REMOVAL_H

#include "flat_vertex_removal.h"

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/mesh_invariants.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace Flat_vertices {

using namespace CGAL::Surface_mesh_geodesics::internal;

// A sum of angles as a complex number. Its size does not matter.
template <typename FT>
struct Direction
{
  FT x = 1, y = 0;

  void turn(const Intrinsic_face<FT>& face, unsigned int corner)
  {
    using std::abs;
    const std::pair<FT, FT> d = angle_direction(face, corner);
    const FT size = FT(abs(d.first)) + d.second;
    if(!(size > 0))
      return;
    const FT c = d.first / size, s = d.second / size, turned = x * c - y * s;
    y = x * s + y * c;
    x = turned;
  }

  bool is_near(int sign, const FT& tolerance) const
  {
    using std::abs;
    return sign * x > 0 && abs(y) <= tolerance * abs(x);
  }
};

template <typename FT>
class Straight_line_removal
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Face = Intrinsic_face<FT>;

  // Removes the flat vertices of a mesh, except pseudo-sources and those in `kept`, and tells where they are. Returns
  // false, and leaves the mesh as it is, unless the lines divide the mesh into triangles. Takes linear time.
  static bool run(Mesh& mesh, const std::vector<Vertex_id>& kept, Fine_vertices<FT>& fine)
  {
    Straight_line_removal removal(mesh, fine);
    removal.number_vertices(kept);
    if(!removal.make_faces() || !removal.locate())
      return false;
    removal.replace_mesh();
    return true;
  }

private:
  // Wider than for the other experiment: the new lengths do not depend on the angles.
  static FT flat_angle() { return 4096 * Tolerance<FT>::epsilon(); }
  static FT straight_angle() { return FT(1e-9); } // a bend changes the length by its square

  enum Mark : unsigned char { ON_LINE = 1, FIRST_OF_SIDE = 2 };

  Straight_line_removal(Mesh& mesh, Fine_vertices<FT>& fine)
    : m_mesh(mesh), m_fine(fine), m_mark(4 * mesh.number_of_faces(), 0), m_coarse(4 * mesh.number_of_faces(), null_id)
  {}

  bool is_kept(Vertex_id v) const { return m_fine.entry[v] != null_id; }

  // Numbers the vertices that stay; the others have no entry yet.
  void number_vertices(const std::vector<Vertex_id>& kept)
  {
    std::vector<Direction<FT>> angle(m_mesh.number_of_vertices());
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
        angle[m_mesh.face(f).vertex[k]].turn(m_mesh.face(f), k);
    m_fine.entry.assign(m_mesh.number_of_vertices(), null_id);
    for(const Vertex_id v : kept)
      m_fine.entry[v] = 0;
    for(Vertex_id v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(is_kept(v) || m_mesh.halfedge(v) == null_id || m_mesh.kind(v) != 0
         || !angle[v].is_near(m_mesh.opposite(m_mesh.halfedge(v)) == null_id ? -1 : 1, flat_angle()))
      {
        m_fine.entry[v] = static_cast<std::uint32_t>(m_kept.size());
        m_kept.push_back(v);
      }
    m_fine.number_of_coarse = static_cast<std::uint32_t>(m_kept.size());
  }

  // Makes the coarse face on the left of each line that starts at a vertex that stays. Returns false if one is no
  // triangle.
  bool make_faces()
  {
    bool is_done = true;
    for(const Vertex_id v : m_kept)
      m_mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
      { is_done = is_done && ((m_mark[h] & FIRST_OF_SIDE) != 0 || make_face(h)); });
    return is_done;
  }

  bool make_face(Halfedge_id start)
  {
    std::array<FT, 3> length;
    std::array<Halfedge_id, 3> first, outer;
    Halfedge_id h = start;
    for(unsigned int k = 0; k < 3; ++k)
    {
      first[k] = h;
      if(!follow_line(h, length[k]))
        return false;
      outer[k] = m_mesh.opposite(h);
      const Halfedge_id twin = outer[k] == null_id ? null_id : m_coarse[outer[k]];
      if(twin != null_id) // the same bits on both sides, whatever the order of the sum
        length[k] = m_faces[face_of(twin)].length[index_in_face(twin)];
      h = next_halfedge(h);
    }
    if(h != start)
      return false;
    unsigned int shift = length[1] < length[0] ? 1 : 0;
    shift = length[2] < length[shift] ? 2 : shift;
    Face face;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const unsigned int j = corner_after(k, shift);
      face.vertex[k] = m_fine.entry[m_mesh.source(first[j])];
      face.length[k] = length[j];
      face.opposite[k] = outer[j]; // a halfedge of the fine mesh until replace_mesh()
      m_coarse[first[j]] = halfedge_of(static_cast<Face_id>(m_faces.size()), k);
    }
    const Planar_triangle<FT> t = planar_triangle_from_lengths<FT>(face.length[0], face.length[1], face.length[2]);
    face.apex_x = t.apex_x;
    face.apex_y = t.apex_y;
    m_faces.push_back(face);
    m_first.push_back(first[shift]);
    return true;
  }

  // Moves h along its line to the last halfedge, which leads to a vertex that stays; measures and marks the line.
  bool follow_line(Halfedge_id& h, FT& length)
  {
    m_mark[h] |= FIRST_OF_SIDE;
    for(length = 0;; h = straight_on(h))
    {
      if(h == null_id)
        return false;
      m_mark[h] |= ON_LINE;
      length += m_mesh.length(h);
      if(is_kept(m_mesh.target(h)))
        return true;
    }
  }

  // Returns the halfedge that continues h at an angle of pi on its left; null_id if there is none.
  Halfedge_id straight_on(Halfedge_id h) const
  {
    Direction<FT> angle;
    Halfedge_id g = next_halfedge(h);
    while(g != null_id)
    {
      angle.turn(m_mesh.face(face_of(g)), index_in_face(g));
      if(angle.is_near(-1, straight_angle()))
        return g;
      g = angle.y < 0 ? null_id : m_mesh.previous_around_source(g);
    }
    return null_id;
  }

  // A halfedge of a fine face, and the positions of its ends in the layout of the coarse face.
  struct Placed_halfedge
  {
    Halfedge_id halfedge;
    Planar_point<FT> source, target;
  };

  // Lays out the fine faces of each coarse face, and makes points of their vertices. Returns whether all are covered.
  bool locate()
  {
    std::size_t number_of_faces = 0;
    for(Face_id f = 0; f < m_faces.size(); ++f)
    {
      const Halfedge_id h = m_first[f];
      const Planar_point<FT> end{m_mesh.length(h), FT(0)};
      m_fine.first_point.push_back(static_cast<std::uint32_t>(m_fine.point.size()));
      add_point(m_mesh.target(h), end);
      m_stack.push_back(Placed_halfedge{h, Planar_point<FT>(), end});
      while(!m_stack.empty())
        number_of_faces += lay_out_next();
    }
    m_fine.first_point.push_back(static_cast<std::uint32_t>(m_fine.point.size()));
    return number_of_faces == m_mesh.number_of_faces()
        && m_fine.point.size() + m_kept.size() == m_mesh.number_of_vertices();
  }

  // Lays out the face of the last halfedge of the stack, and stacks those behind its other edges. Returns 0 if the face
  // has been laid out before.
  std::size_t lay_out_next()
  {
    const Placed_halfedge e = m_stack.back();
    m_stack.pop_back();
    unsigned char& is_laid_out = m_mark[halfedge_of(face_of(e.halfedge), 3)]; // no halfedge has this number
    if(is_laid_out != 0)
      return 0;
    is_laid_out = 1;
    const Face_frame<FT> c = m_mesh.face_frame(e.halfedge);
    const FT x = (e.target.x - e.source.x) / c.length, y = (e.target.y - e.source.y) / c.length;
    const Planar_point<FT> apex{FT(e.source.x + x * c.apex_x - y * c.apex_y),
                                FT(e.source.y + y * c.apex_x + x * c.apex_y)};
    add_point(c.apex, apex);
    if(c.right != null_id && ((m_mark[next_halfedge(e.halfedge)] | m_mark[c.right]) & ON_LINE) == 0)
      m_stack.push_back(Placed_halfedge{c.right, apex, e.target});
    if(c.left != null_id && ((m_mark[previous_halfedge(e.halfedge)] | m_mark[c.left]) & ON_LINE) == 0)
      m_stack.push_back(Placed_halfedge{c.left, e.source, apex});
    return 1;
  }

  void add_point(Vertex_id v, const Planar_point<FT>& p)
  {
    if(is_kept(v))
      return;
    m_fine.entry[v] = m_fine.number_of_coarse + static_cast<std::uint32_t>(m_fine.point.size());
    m_fine.point.push_back(Planar_point<FT>{p.x, (std::max)(FT(0), p.y)});
  }

  void replace_mesh()
  {
    std::vector<unsigned char> kinds;
    for(const Vertex_id v : m_kept)
      kinds.push_back(static_cast<unsigned char>(m_mesh.kind(v) & (Mesh::PSEUDO_SOURCE | Mesh::DEGENERATE)));
    m_mesh.reset(m_faces.size());
    for(Face_id f = 0; f < m_faces.size(); ++f)
    {
      for(Halfedge_id& o : m_faces[f].opposite)
        o = o == null_id ? null_id : m_coarse[o];
      m_mesh.face(f) = m_faces[f];
    }
    m_mesh.finish(kinds.size());
    for(Vertex_id v = 0; v < kinds.size(); ++v)
      m_mesh.set_kind(v, static_cast<unsigned char>(m_mesh.kind(v) | kinds[v]));
    m_mesh.bound_faces_crossed_by_lengths(); // see Flat_vertex_compaction
    CGAL_expensive_assertion(are_invariants_kept(m_mesh));
  }

  Mesh& m_mesh;
  Fine_vertices<FT>& m_fine;
  std::vector<Vertex_id> m_kept;
  std::vector<unsigned char> m_mark; // by halfedge of the fine mesh
  std::vector<Halfedge_id> m_coarse; // by the first halfedge of a line: the halfedge of the coarse mesh
  std::vector<Face> m_faces;         // of the coarse mesh
  std::vector<Halfedge_id> m_first;  // by coarse face: the first halfedge of its side 0
  std::vector<Placed_halfedge> m_stack;
};

} // namespace Flat_vertices

#endif // STRAIGHT_LINE_REMOVAL_H
