// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_TOLERANCE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_TOLERANCE_H

// Every tolerance of the computation, room by room, so that they can be compared with each other. Three kinds of
// numbers stand elsewhere: the default tolerances of the certificates, which are part of their public classes; bounds
// of the size of a computation or of its input (Path_search::maximum_effort, Intrinsic_mesh::largest_faces_crossed,
// Surface_locations::largest_size, largest_extent() and its neighbors); and numbers that change the time but no result
// beyond rounding (Batch_threshold).
//
// No tolerance is absolute. The comment of each one names the quantity that it multiplies ("relative to a distance")
// and the reason for its size. Most are a power of two times epsilon(), so that multiplying by them is exact.
// "The error of images" is the error that the images of pseudo-sources accumulate from face to face; see distance().

// Flags that take the ground away from all of this.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || defined(_M_FP_FAST)     \
  || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error Surface_mesh_geodesics relies on infinities, NaN and the order of operations: compile without -ffast-math
#endif
#if (defined(__GNUC__) && !defined(__EXCEPTIONS)) || (defined(_MSC_VER) && !defined(_CPPUNWIND))
#error Surface_mesh_geodesics reports invalid input by exceptions: compile without -fno-exceptions
#endif

#include <cmath>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
struct Tolerance
{
  // --- Rounding ------------------------------------------------------------------------------------------------------

  // Machine epsilon: the distance from 1 to the next number. It is 2 u, where u, the unit roundoff of the literature,
  // is the largest relative error of one operation. Error bounds are derived in u and stated in epsilon().
  static FT epsilon() { return std::numeric_limits<FT>::epsilon(); }

  // The user's numbers are doubles, whatever the precision of the computation.
  static FT input_epsilon() { return FT(std::numeric_limits<double>::epsilon()); }

  // Relative to a distance: four times the largest relative error of a conversion to float (2^-24), so that bounds in
  // single precision hold in every rounding mode (Single_precision).
  static constexpr double conversion_to_float() { return 0x1p-22; }

  // --- Input: interface/ and surface/ --------------------------------------------------------------------------------

  // Relative to 1: a smaller barycentric coordinate is taken for zero, so that a location with rounded coordinates is
  // the vertex or the point of an edge that the user means. This moves a source by at most this part of the longest
  // side of its face.
  static FT barycentric() { return 64 * input_epsilon(); }

  // Relative to 1: coordinates whose sum differs from 1 by more, or one of which is less than zero by more, are not
  // barycentric coordinates. Large enough for coordinates with ordinary rounding errors, small enough to detect a
  // mistake.
  static FT location()
  {
    using std::sqrt;
    return sqrt(input_epsilon()) / 16;
  }

  // Relative to barycentric coordinates: the error of a position that is computed from coordinates in a part of a face.
  // Each coordinate is the difference of two rounded numbers, divided by a third one.
  static FT placement() { return 4 * input_epsilon(); }

  // Relative to 1: an edge between two parts of a face is flipped only if the sine of the sum of the angles opposite to
  // it is negative by more than flip(), and if the sines of the angles at its ends are larger than angle_of_flip().
  // Large enough that rounding decides nothing. The angles may be small: the ends of an edge may be far away from a
  // cluster of sources.
  static FT flip() { return FT(1) / 1024; }
  static FT angle_of_flip()
  {
    using std::sqrt;
    return sqrt(input_epsilon());
  }

  // Relative to the way along two sides that the new edge is the sum of: a flip makes no shorter edge. It would lose
  // more than six bits of its length.
  static FT shortest_flip() { return FT(1) / 64; }

  // Relative to 1: if each barycentric coordinate errs by at most a quarter, the largest of the three, at least 1/3, is
  // not zero. Coordinates that err by more mean nothing.
  static FT known_coordinate() { return FT(1) / 4; }

  // Relative to 1: if the coordinates of a point in a part of a face err by more, the point belongs to another part,
  // which may have it outside by rounding. Coordinates err by less in a cluster of sources 10^-9 times the size of the
  // face.
  static FT narrow_part() { return FT(1) / 1024; }

  // Relative to the longest side: the amount by which it may exceed the sum of the two others. Lengths that are
  // computed from coordinates err by a few epsilon.
  static FT triangle_inequality() { return 64 * input_epsilon(); }

  // --- Faces and vertices: surface/ ----------------------------------------------------------------------------------

  // Relative to the extent of the mesh: the ends of shorter edges are pseudo-sources, whatever their angles. The
  // direction of a path from a point so near to a vertex is known with an error of epsilon / length only, and the path
  // is longer by the square of this error; a path through the vertex itself is longer by the length. At this length
  // both errors are about the same. If the edge vanished in the rounding of distances altogether, paths could run
  // around it without growing.
  static FT length()
  {
    using std::sqrt;
    return sqrt(epsilon()) / 1024;
  }

  // Relative to the extent of the mesh: the largest offset of a source. With a larger one, distances that differ by the
  // 1024th part of the extent would tie (distance()), and paths could run around many edges without growing. It is
  // 2^40 for double.
  static FT largest_offset() { return 1 / (4096 * epsilon()); }

  // Relative to the longest side L: a face with a smaller height h has degenerate corners. A path across it may miss a
  // corner by h, and is then about h^2 / L shorter than the path through that corner. This is less than 16 epsilon() L
  // here, and images err by as much. So the comparison with the corner may remove the window of the shortest path, and
  // only a corner that sends windows everywhere carries the path on. (This is for faces of the first mesh. Parts of a
  // face have pseudo-sources at all corners, and may be narrow beside a source that is near an edge.)
  static FT narrow_face()
  {
    using std::sqrt;
    return 4 * sqrt(epsilon());
  }

  // Relative to pi: the excess of a vertex angle above which shortest paths bend at the vertex. Larger than the
  // rounding of a sum of angles, so that flat vertices stay flat; smaller than the angles of all faces that have a
  // height by length(), so that no face is hidden behind a vertex.
  static FT angle() { return 1024 * epsilon(); }

  // Relative to 1 (an angle at a vertex): two directions that differ by less count as one where windows leave a
  // pseudo-source. Larger than the excess of a vertex angle that angle() ignores.
  static FT direction() { return 8 * angle(); }

  // A slope: how far the windows of a vertex of a curve reach beyond the normals of the curve. There, paths from the
  // vertex are longer than rays beside it by the square of the angle only, and both have to be known where arcs of a
  // diagram run along a normal. Far above what rounding turns directions by in slivers; wider windows cost next to
  // nothing.
  static FT beside_normal() { return FT(1) / 1024; }

  // Relative to the length of an edge: the depth of an image that lies on the edge itself (the apex of a triangle
  // without area). Its square vanishes beside the square of the length.
  static FT depth()
  {
    using std::sqrt;
    const FT e = epsilon();
    return e * e;
  }

  // Relative to the longest side, where the user gives lengths: in a face with a smaller height h, the bound |e| / h on
  // the faces crossed for each edge e runs to millions, which no computation reaches in practice, and the square of
  // this ratio, below 2^-48, is near the rounding of double.
  static constexpr double lost_face() { return 0x1p-24; }

  // Relative to the longest side: if a mesh has lost faces, only faces with a larger height count for the bound, which
  // is then a few thousand faces for each edge. The geometric mean of lost_face() and 1.
  static constexpr double thick_face() { return 0x1p-12; }

  // --- Windows: window/ and propagation/ -----------------------------------------------------------------------------

  // Relative to a distance: windows whose distances differ by less count as equal when the longer one would be pruned.
  // This covers the rounding of one comparison: two distances that err by two epsilon each
  // (Window_numbers::distance_at()). With u = epsilon() / 2, is_clearly_less(a, b) implies A < B (1 + u) for the exact
  // distances A and B that the stored images have.
  //
  // The error of images. The stored image is not the exact one: it is unfolded face by face. To first order, crossing a
  // face adds, with r the distance from the image to the farthest corner of the face:
  // - 9 u r for the arithmetic of the child (lanes/window_splitting.h);
  // - 16 u r for the direction of the new edge: the apex of a face that is given by its lengths errs by less than
  //   8 epsilon() = 16 u of either side that ends there (set_apex());
  // - 16 u L for the position of the apex, where L is the longest side met so far.
  // If the face is given by points, 19.5 u take the place of 16 u (set_shape_from_sides()), and the lengths by which
  // the image is turned err by 2.5 u. Rotations do not amplify earlier errors, and needles do not either, because
  // apexes err relative to the nearest side. As r <= d + L, where d is the distance from the image along the window, a
  // face adds 41 u or 50.5 u of d + L. So an image that has crossed n faces errs by 26 n epsilon() (d + L) at most, and
  // so does each of its distances; 24 in place of 26 suffices if lengths are given. test_predicate_laws measures less
  // than 2. The sizes of tolerances below follow from this measured factor: the proved one lets all rounding errors
  // have the worst size and sign.
  //
  // The lengths of the pieces of a path that bends at pseudo-sources add up, and so do their errors. The ends of an
  // interval err by the same amount across the rays, so that a path may pass a vertex on the wrong side by this much;
  // the path around the vertex is longer by no more than that.
  //
  // What is known, and what is not. Where two windows differ by less than their errors of images, pruning may remove
  // the shorter one. It never removes both, and the other one is a path on the surface, longer by at most the sum of
  // the two errors. No bound is proved for many such losses along one path; their number is at most n, which gives n
  // times the bound above. The certificate does not rest on any of this: it checks the final distances against a lower
  // bound (certificate/Lower_bound_check.h), with the largest violation that it finds.
  static FT distance() { return 4 * epsilon(); }

  // Relative to the length of an edge: narrower intervals come from rounding (a ray that meets a vertex) and are
  // dropped. No path is lost: distances are also measured along paths that bend at the end of an interval, and a
  // lateral shift of this size makes them longer only by its square.
  static FT interval() { return 512 * epsilon(); }

  // Relative to the extent of a component: how far rounding may move the end of a strip along its edge. Not relative to
  // that edge, which may be much shorter than the way of the strip.
  static FT end_of_strip() { return 64 * epsilon(); }

  // Relative to the length of an edge: if an image is nearer to its interval, the rounding of the ends of the interval
  // turns its rays by more than their length can tell. Such a window must not be trimmed.
  static FT closeness()
  {
    using std::sqrt;
    return sqrt(epsilon()) / 16;
  }

  // --- Paths: paths/ and certificate/ --------------------------------------------------------------------------------

  // Relative to the extent of a component: nearer points of a path are one point.
  static FT gap() { return 8 * epsilon(); }

  // Relative to the distance of an image, or the longest side of the face if that is longer: a path that passes a
  // vertex at a smaller distance may pass it on either side, or run through it. Bounds the error of images across a
  // hundred faces by the measured factor 2 (with d + L at most twice this length), and across 9 faces by the proved
  // one.
  static FT sideways() { return 512 * epsilon(); }

  // Relative to the same lengths: the effect of the rounding of one image and one frame on a distance.
  static FT lengthwise() { return 8 * epsilon(); }

  // Relative to a distance: a path whose length differs by more is not the path that is looked for. Bounds the error of
  // images across a thousand faces by the measured factor 2, and across 78 by the proved one, if no side is longer than
  // the distance.
  static FT path() { return 4096 * epsilon(); }

  // Relative to a distance: the error of a path through few faces. The search for a path begins with it, so that it
  // does not stop at a path that is longer than necessary.
  static FT path_through_few_faces() { return path() / 64; }

  // Relative to a distance, and to the lengths of the mesh: the search for a path ends with their sum. Wider than the
  // error of any path that the tests know, which is the sum of the errors of its pieces. No bound is known; a path that
  // is longer still is reported as hidden by rounding.
  static FT path_of_many_pieces() { return 64 * path(); }
  static FT lengthwise_of_many_pieces() { return 8 * lengthwise(); }

  // Relative to the length of an edge: how exactly the crossings of isolines are found.
  static FT isoline() { return 4096 * epsilon(); }

  // Relative to the value of an isoline: a distance that differs by less is at the value. Larger than the errors of the
  // distances along one edge, which come through different windows: an edge along the line is on one side of it then.
  static FT isoline_value() { return 1024 * epsilon(); }

  // Relative to the length of an edge: two crossings of one isoline that are nearer to each other may be missed.
  // Halving down to here takes 14 steps where the isoline comes near an edge without crossing it; the manual promises
  // 1e-4.
  static FT isoline_touching() { return FT(1) / 16384; }

  // --- Diagrams: Voronoi/ and the bisectors in numeric/ --------------------------------------------------------------

  // Relative to a distance: an image counts as nearer than another one if it is nearer by more than this. Each distance
  // errs by distance(), and each image by its rounding in the frame of the face.
  static FT nearer() { return 4 * distance(); }

  // Relative to a distance: an image may follow another one of the same site, where the interval of that one ends, if
  // it is not farther by more. Also the margin by which the wavefront has to pass a bound before a region is left
  // behind.
  static FT succession() { return 16 * distance(); }

  // Relative to a distance: two images of one site tie, each of which has the error of images.
  static FT tie() { return 64 * distance(); }

  // Relative to a distance: paths to a piece of an arc that are longer by less do not become shorter if it is divided.
  // A multiple of tie(), as the images behind faces between sites that almost coincide are off by more than others.
  static FT excess_of_pieces() { return 16 * tie(); }

  // Relative to the extent of a component: two sources that are so near to each other tie everywhere in it.
  static FT equal_sources() { return tie(); }

  // Relative to the size of a face: the position at which a curve touches a line is known up to the square root of
  // rounding.
  static FT touching() { return 64 * closeness(); }

  // Relative to the length of an edge: if two distances tie up to rounding along a part that is not longer, and one is
  // nearer behind it, that one has the part as well. Where they part slowly, the position at which they touch is known
  // less exactly than touching().
  static FT tied_part() { return FT(1) / 1024; }

  // Relative to the size of a face: ends of curves that are nearer to each other may be meant to be one point. A
  // question for a more careful look only: no result depends on its size.
  static FT near_end() { return FT(1) / 1024; }

  // Relative to the parameter of a curve (Front_tracer.h), or to the way from one point of a face to another
  // (Cell_locator.h): how far to look ahead in order to see which side or which cell comes next. Far above rounding,
  // and far below the size of what is looked at.
  static FT look_ahead() { return FT(1) / 1024; }

  // Relative to the size of a face: a trace that has not moved by more stands still.
  static FT standstill() { return 16 * epsilon(); }

  // Relative to the distances of two sites: the rounding of their bisector.
  static FT bisector() { return 16 * distance(); }

  // Relative to the distance of a point of a bisector from its focus: farther away, the parameter has lost 20 of the 52
  // bits of a double.
  static FT precise_reach() { return FT(1 << 20); }

  // Relative to 1, the tangent of half an angle: about 150 degrees around the focus of a bisector. Beyond half a turn,
  // the parameter would change its sign.
  static FT half_turn() { return FT(4); }

  // Relative to the squared distance of two sites: a bisector that is described by a smaller number is a ray
  // (Weighted_bisector.h). Relative to the distance of a point of a bisector: if the weights differ by less, the
  // bisector is a straight line (Arc_curve.h).
  static FT curvature() { return 4 * distance(); }

  // Relative to the sum of the absolute terms of a quadratic polynomial: the rounding of its value.
  static FT polynomial() { return 16 * epsilon(); }

  // Relative to the sum of the squares of the sides: a triangle with a smaller area has none.
  static FT area() { return 4 * epsilon(); }

  // Relative to the square of the extent of the mesh: the sum of a smaller area has lost 20 bits in the layouts of
  // faces, and is taken relative to a point of the cell.
  static FT tiny_area() { return FT(1) / (1 << 20); }

  // Relative to what is integrated along a curve, if its chord were all of it: if halving an interval changes less, it
  // is not halved any more.
  static FT quadrature() { return 512 * epsilon(); }

  // Relative to the distance of two points from the origin: the error of their distance. Each coordinate is a sum of
  // three products with weights that sum up to 1: it errs by less than 4 epsilon of its size, and the difference of two
  // of them by less than 8 epsilon. (Certificates compute in double.)
  static FT points_in_space() { return 8 * input_epsilon(); }

  // Relative to the coordinates of a face: a point that is this near to a side lies on it. It has been computed in
  // space (points_in_space()), then moved to the face and turned into coordinates, each of which adds as much again.
  static FT place_in_space() { return 64 * input_epsilon(); }

  // Relative to the size of a face: Newton's method refines points that are known up to rounding, or up to the square
  // root of rounding where curves touch. A longer step leads to another point.
  static FT newton_step() { return FT(1) / (1 << 20); }

  // Relative to 1, the sine of an angle: where two curves meet at a smaller angle, rounding hides their common point.
  static FT slope() { return 1024 * epsilon(); }
};

// Is a < b beyond the rounding of two distances? The result is false if a and b tie.
//
// Laws, for distances that are not negative: a and b are never clearly less than each other, nor is a than itself;
// multiplying both by a power of two does not change the answer if nothing underflows or overflows.
template <typename FT>
bool is_clearly_less(const FT& a, const FT& b)
{
  return a < b * (1 - Tolerance<FT>::distance());
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_TOLERANCE_H
