// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_DISTANCE_CHECK_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_DISTANCE_CHECK_H

// Compares what a diagram states with the paths and the lower bound of a witness (Site_witness.h): at samples, and
// along arcs between them.
//
// At a sample, a path from each site that the diagram names is as long as stated, and the lower bound is not less. So
// no site is nearer.
//
// On an arc, each of its two sites has an image from which straight paths lead to all points of it, and no path of the
// lower bound is shorter (Face_paths.h). So between the samples, too, both sites are equally near, and no other one is
// nearer. An arc that crosses a face in which sites lie is divided, until each piece lies in a part of the face.
//
// This proves the diagram, if the cell on the side of an arc is that which samples there have: a site k that is nearest
// at a point x of another cell is so along the whole path from x to k. The path does not cross an arc, as nothing is
// nearer there than the sites of the arc. So k itself lies in the wrong cell, and sites are samples. Of a curve, a part
// lies there, which ends where another site is as near; so samples lie in each part along which no other site is
// (Site_witness::for_each_point_of_curves()).
//
// The steps of run():
// 1. check_samples() compares each sample with the bound and with a path from each site that it names.
// 2. find_pieces() divides arcs, and finds the images of both sites for each piece.
// 3. check_by_own_run() looks for what is missing, one site after the other.
// 4. check_pieces() compares each piece with the bound.
// 5. check_ties() checks the rule for sites that tie everywhere.
//
// Who is to blame: for a path that is too long, its site; for a bound that is too small, the site that is nearest; for
// a piece, the site with the longer path.
//
// Paths from a site that ties may be missing in the propagation from all sites. Where one is, or is longer than stated
// by more than two paths that tie, a second round has a propagation from that site alone.

#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_conditions.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_samples.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Site_witness.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Arc_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Face_paths.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Extents` has extent_around(sample or face of the mesh), the longest edge of a component, and gap(location,
// location), how far they are apart as a multiple of it. All objects are referred to. Requires: the witness has been
// proved.
template <typename Diagram, typename Witness, typename Extents>
class Diagram_distance_check
{
  using Graph_traits = boost::graph_traits<typename Diagram::Triangle_mesh>;
  using Face_location = typename Diagram::Face_location;
  using Samples = Diagram_samples<Diagram>;
  using Sample = typename Samples::Sample;
  using Point = Planar_point<double>;
  using Image = Additively_weighted_point<double>;
  using Paths = Face_paths<double>;

public:
  Diagram_distance_check(const Diagram& diagram, Witness& witness, const Extents& extents,
                         Diagram_violations& violations)
    : m_diagram(diagram), m_witness(witness), m_extents(extents), m_violations(violations), m_samples(diagram),
      m_largest_weight(largest_weight_of(diagram)), m_needs_run(diagram.number_of_sites(), 0)
  {
    witness.for_each_point_of_curves([&](std::size_t site, std::size_t segment, double t)
    { m_samples.add_point_of_curve(site, segment, t); });
    m_is_confirmed.assign(m_samples.sites().size(), 0);
  }

  // Takes time linear in the number of samples, times the number of windows of a face, and that of a propagation for
  // each site with a missing path.
  void run()
  {
    check_samples();
    find_pieces();
    for(std::size_t i = 0; i < m_needs_run.size(); ++i)
      if(m_needs_run[i] != 0)
        check_by_own_run(i);
    check_pieces();
    check_ties();
  }

private:
  static constexpr std::size_t no_site() { return Diagram_violation::no_site(); }
  static double infinity() { return std::numeric_limits<double>::infinity(); }

  // Makes a violation of a difference of two lengths in the user's unit.
  double relative(double difference, double distance, double extent) const
  {
    return violation_of_distance(difference, distance, extent, m_largest_weight);
  }

  // Does a violation show that a path is missing, and not only rounding? Then a run from its site alone looks for it.
  static bool is_doubtful(double violation) { return !(violation <= Tolerance<double>::tie()); }

  void record(Diagram_condition condition, double violation, std::size_t site)
  {
    m_violations[condition].record(violation, site);
  }

  // --- samples ---

  Witness_place place(const Sample& s) const
  {
    return s.vertex != Graph_traits::null_vertex() ? m_witness.place(s.vertex) : m_witness.place(s.location);
  }

  // Samples and pieces come sorted by face, mostly: arcs of a face, its points, its vertices.
  //
  // Reads both kinds of paths into a face, unless they are those of the last face.
  void read(Face_id f)
  {
    if(f == m_face)
      return;
    m_face = f;
    m_witness.read_paths(f, m_paths);
    m_witness.read_bound(f, m_bound);
  }

  // Compares each sample with the bound, and with a path from each site that it names.
  void check_samples()
  {
    for(const Sample& s : m_samples.samples())
    {
      const Witness_place at = place(s);
      read(at.face);
      check_nearest(s, at);
      for(std::size_t k = s.first_site; k < s.first_site + s.number_of_sites; ++k)
        check_claim(s, k, at, m_paths, false);
    }
  }

  // No site is nearer than stated. The site to blame is the nearest one. If a site reaches a point for which none is
  // stated, the violation is infinite; if a site is stated that does not reach it, check_claim() finds that.
  void check_nearest(const Sample& s, const Witness_place& at)
  {
    const std::size_t named = m_samples.sites()[s.first_site];
    const double bound = at.vertex != null_id ? m_witness.distance(at.vertex) : m_bound.at(at.point);
    double violation = 0;
    if(bound < infinity())
      violation = named == no_site() ? infinity()
                                     : relative(s.distance - m_witness.user_distance(bound),
                                                distance_without_weight(bound, named), m_extents.extent_around(s));
    const std::size_t nearest = violation <= 0 ? Paths::none : m_paths.nearest(at.point);
    record(DIAGRAM_NEAREST, violation, nearest == Paths::none ? no_site() : m_paths.site(nearest));
  }

  // The geodesic distance of the user, of which a violation is a part.
  double distance_without_weight(double d, std::size_t site) const
  {
    return m_witness.user_distance(d) + (site == no_site() ? 0. : CGAL::to_double(m_diagram.weight(site)));
  }

  // Claim k says that a site has the stated distance; `paths` are those into the face of the sample. If they do not
  // show it, the paths from the site alone have the last word.
  //
  // If no path is found, the difference is infinite or NaN, which counts as infinite.
  void check_claim(const Sample& s, std::size_t k, const Witness_place& at, const Paths& paths, bool is_last)
  {
    const std::size_t i = m_samples.sites()[k];
    if(i == no_site())
      return;
    const std::size_t family = paths.nearest(at.point, i);
    const double d = family == Paths::none ? infinity() : paths.families()[family].at(at.point);
    const double violation = relative(std::abs(m_witness.user_distance(d) - s.distance),
                                      distance_without_weight(d, i), m_extents.extent_around(s));
    m_is_confirmed[k] = is_last || !is_doubtful(violation) ? 1 : 0;
    if(m_is_confirmed[k] != 0)
      record(s.condition, violation, i);
    else
      m_needs_run[i] = 1;
  }

  // --- arcs between samples ---

  // An image of a site, in the layout of a face. The excess is by how much the paths from it are longer than stated, at
  // worst.
  struct Candidate
  {
    Image image{};
    double excess = infinity();
  };

  // A part of an arc in one face of the refined mesh; points and images are in its layout. `best` are the images of the
  // two sites of the arc. Another one of a site may be as good: where sites share a point, all images at it tie
  // (choose_images()).
  struct Piece
  {
    Face_id face;
    Point first, middle, last;
    std::array<double, 3> stated; // own distances at these points
    bool is_segment;
    std::array<std::size_t, 2> sites;
    double extent;
    std::array<Candidate, 2> best{}, other{};
  };

  // A point of an arc, and what is stated there: the distance is an own one, as those of the witness.
  struct End
  {
    double t;
    Face_location location;
    Witness_place place;
    double distance;
  };

  template <typename Arc>
  End end(const Arc& arc, double t) const
  {
    const Face_location l = arc.point(t);
    return End{t, l, m_witness.place(l), m_witness.own_distance(CGAL::to_double(arc.distance(t)))};
  }

  void find_pieces()
  {
    for(const auto& arc : m_diagram.arcs())
    {
      m_most_pieces = m_pieces.size() + most_pieces;
      m_divisions = 0;
      find_pieces(arc, end(arc, 0.), end(arc, 1.), 0);
    }
    for(const Piece& p : m_pieces)
      for(std::size_t side = 0; side < 2; ++side)
        if(is_doubtful(violation(p, side, p.best[side].excess)))
          m_needs_run[p.sites[side]] = 1;
  }

  // Halvings after which a piece is shorter than rounding, and the largest numbers of pieces of an arc and of
  // divisions. Without the last one, an arc on the edge of two parts would be divided down to rounding everywhere. An
  // arc with more pieces has lost the paths of a site; own runs find them, without more pieces.
  static constexpr int most_halvings = 48;
  static constexpr std::size_t most_pieces = 256;
  static constexpr std::size_t most_divisions = 4096;

  // Divides an arc until each piece is in one face of the refined mesh, and has an image of each site. One that changes
  // its image within rounding of its end is divided near there.
  template <typename Arc>
  void find_pieces(const Arc& arc, const End& a, const End& b, int depth)
  {
    const End m = end(arc, (a.t + b.t) / 2);
    Piece p{m.place.face, {}, m.place.point, {}, {{a.distance, m.distance, b.distance}}, arc.is_segment(),
            {{arc.sites().first, arc.sites().second}}, m_extents.extent_around(m.location.first)};
    const bool is_in_face
      = m_witness.find_in_face(a.place, p.face, p.first) && m_witness.find_in_face(b.place, p.face, p.last);
    bool is_found = is_in_face;
    if(is_in_face)
    {
      read(p.face);
      for(std::size_t side = 0; side < 2; ++side)
        is_found = find_image(p, side, m_paths) && is_found;
    }
    // Near the images of sites that almost coincide, all paths are longer than stated by more than ties allow. If such
    // pieces were divided, too, they would use up the pieces of the arc, and its other parts would not be divided.
    if(is_found || (is_in_face && (depth == most_halvings || m_pieces.size() >= m_most_pieces)))
      m_pieces.push_back(p);
    else if(++m_divisions > most_divisions)
      return; // the arc runs along an edge between two parts of a face: only its samples are compared
    else if(depth == most_halvings)
      record(DIAGRAM_CURVES, m_extents.gap(a.location, b.location), arc.sites().first);
    else
    {
      find_pieces(arc, a, m, depth + 1);
      find_pieces(arc, m, b, depth + 1);
    }
  }

  // Paths that lead around the end of an interval in the middle of the piece do so on all of it, as a rule; where they
  // do not, the excess at one of its ends tells, and the piece is divided.
  //
  // Finds the image of a site from which paths lead to the piece; of several that tie in its middle, the best one.
  // Returns whether the paths are as long as stated, or so nearly so that no division helps.
  //
  // The image is the end of an interval where paths bend there. Such an image is a point of the face, and needs no
  // interval.
  bool find_image(Piece& p, std::size_t side, const Paths& paths) const
  {
    const std::size_t site = p.sites[side], nearest = paths.nearest(p.middle, site);
    if(nearest == Paths::none)
      return false;
    // Beside a curve, distances are as small as the rounding of rays, and perhaps negative.
    const auto& best = paths.families()[nearest];
    const double at_middle = best.at(p.middle);
    const double tie = at_middle + Tolerance<double>::tie() * (std::abs(at_middle) + best.image().scale);
    for(std::size_t i = 0; i < paths.families().size(); ++i)
    {
      const auto& family = paths.families()[i];
      if(paths.site(i) != site || !(family.at(p.middle) <= tie))
        continue;
      const Image& image = family.image_at(p.middle);
      const double detour = &image == &family.image() ? paths.detour(i, p.first, p.last) : 0.;
      const double excess = detour + (std::max)({image.distance_to(p.first) - p.stated[0],
                                                 image.distance_to(p.middle) - p.stated[1],
                                                 image.distance_to(p.last) - p.stated[2]});
      add(p, side, Candidate{image, excess});
    }
    return is_right(p, side, p.best[side]);
  }

  // Are the paths from an image as long as stated all along the piece, up to what no division would make better? An
  // image that is not found yet has an infinite excess, and is not right.
  bool is_right(const Piece& p, std::size_t side, const Candidate& c) const
  {
    return violation(p, side, c.excess) <= Tolerance<double>::excess_of_pieces();
  }

  // Keeps a candidate if it is better than the best one, or another one that is right, too. The order of candidates
  // does not matter, unless three different ones are right: then one of them is lost.
  void add(Piece& p, std::size_t side, const Candidate& c) const
  {
    Candidate& best = p.best[side];
    const bool is_best = c.excess < best.excess;
    const Candidate& second = is_best ? best : c;
    if(is_right(p, side, second) && !are_same(best.image, c.image, p.stated[1]))
      p.other[side] = second;
    if(is_best)
      best = c;
  }

  // Are two images, at a distance from the piece, the same one up to rounding?
  static bool are_same(const Image& a, const Image& b, double distance)
  {
    const double rounding = Tolerance<double>::tie() * (std::abs(distance) + a.scale);
    const double shift = std::hypot(a.x - b.x, a.y - b.y) * (a.is_at_infinity() ? a.scale : 1.);
    return a.is_at_infinity() == b.is_at_infinity() && shift <= rounding && std::abs(a.weight - b.weight) <= rounding;
  }

  using Images = std::array<Candidate, 2>; // of both sites

  // If there is no bisector of the best images, others take their places, if there are any. (All of them are equally
  // far from the ends of the piece and from its middle. Two curves with a common focus have two points in common at
  // most, so that all bisectors are one.)
  void choose_images(Piece& p) const
  {
    if(p.is_segment || has_bisector(p, p.best))
      return;
    const Images best = p.best;
    for(const Candidate& left : {best[0], p.other[0]})
      for(const Candidate& right : {best[1], p.other[1]})
        if(left.excess < infinity() && right.excess < infinity() && has_bisector(p, {{left, right}}))
        {
          p.best = {{left, right}};
          return;
        }
  }

  // Is there a bisector beyond rounding? There is none where one image is on the way of all paths from the other one to
  // the piece.
  static bool has_bisector(const Piece& p, const Images& images)
  {
    return Weighted_bisector<double>(images[0].image, images[1].image, p.middle).is_valid();
  }

  // Makes a violation of an excess in the unit of the intrinsic mesh, for the site on one side.
  double violation(const Piece& p, std::size_t side, double excess) const
  {
    return relative(excess * m_witness.mesh().unit(), distance_without_weight(p.stated[1], p.sites[side]), p.extent);
  }

  // Both sites have images now, or never. The bound is compared along the whole piece, and the piece must not leave the
  // face, where neither the bound nor the paths are known. On a segment, both distances are compared, too; on a
  // bisector they are equal.
  void check_pieces()
  {
    for(Piece& p : m_pieces)
    {
      choose_images(p);
      double excess = (std::max)(p.best[0].excess, p.best[1].excess);
      if(excess < infinity())
      {
        read(p.face);
        excess = (std::max)(excess, excess_along(p));
      }
      const std::size_t side = p.best[1].excess > p.best[0].excess ? 1 : 0;
      record(DIAGRAM_CURVES, violation(p, side, excess), p.sites[side]);
    }
  }

  // By how much the bound is exceeded along a piece, the piece leaves the face, or both distances differ on it.
  //
  // Where rounding hides the bisector, the piece is straight as a rule: then its middle is on its chord. It may also
  // turn beside an image: then what is left of the bisector tells more.
  double excess_along(const Piece& p) const
  {
    const Image &left = p.best[0].image, &right = p.best[1].image;
    const Arc_piece<double> arc(p.first, p.last, left, right, p.is_segment);
    if(p.is_segment || has_bisector(p, p.best))
      return excess_along(arc);
    const double of_chord = (std::max)(excess_along(Arc_piece<double>(p.first, p.last, left, right, true)),
                                       distance_from_segment(p.middle, p.first, p.last));
    return arc.is_segment() ? of_chord : (std::min)(of_chord, excess_along(arc));
  }

  double excess_along(const Arc_piece<double>& arc) const
  {
    double excess = (std::max)(m_bound.excess_along(arc), m_bound.leaving(arc));
    arc.for_each_extremum_of_difference([&](const Point& x) { excess = (std::max)(excess, arc.difference(x)); });
    return excess;
  }

  // --- second round ---

  // The witness has one run at a time, so that all that needs the paths of a site is looked at together.
  //
  // Looks for the missing paths of site i: those of claims and of pieces. Claims are recorded, whatever is found.
  void check_by_own_run(std::size_t i)
  {
    m_witness.run_from(i);
    m_face = null_id;
    Paths paths;
    const auto read_own = [&](Face_id f)
    {
      if(f != m_face)
        m_witness.read_paths_from_one(f, paths);
      m_face = f;
    };
    for(const Sample& s : m_samples.samples())
      for(std::size_t k = s.first_site; k < s.first_site + s.number_of_sites; ++k)
        if(m_is_confirmed[k] == 0 && m_samples.sites()[k] == i)
        {
          const Witness_place at = place(s);
          read_own(at.face);
          check_claim(s, k, at, paths, true);
        }
    for(Piece& p : m_pieces)
      for(std::size_t side = 0; side < 2; ++side)
        if(p.sites[side] == i && is_doubtful(violation(p, side, p.best[side].excess)))
        {
          read_own(p.face);
          find_image(p, side, paths);
        }
    m_face = null_id;
  }

  // --- the rule for ties ---

  // A site that ties with an earlier one owns nothing: its cell has no boundary and no area, and nothing names it. The
  // distances alone cannot show that, as both sites are equally near. If rounding takes the cell of the earlier one,
  // at least one of both owns nothing.
  void check_ties()
  {
    std::vector<char> owns_something(m_diagram.number_of_sites(), 0);
    for(const std::size_t i : m_samples.sites())
      if(i != no_site())
        owns_something[i] = 1;
    const auto owns_nothing = [&](std::size_t i)
    {
      return owns_something[i] == 0 && m_diagram.boundary(i).empty() && CGAL::to_double(m_diagram.area(i)) == 0;
    };
    m_witness.for_each_tie([&](std::size_t i, std::size_t first, bool is_decided)
    { record(DIAGRAM_OWNERS, owns_nothing(i) || (!is_decided && owns_nothing(first)) ? 0 : infinity(), i); });
  }

  const Diagram& m_diagram;
  Witness& m_witness;
  const Extents& m_extents;
  Diagram_violations& m_violations;
  Samples m_samples;                // what the diagram states
  const double m_largest_weight;    // in absolute value
  std::vector<char> m_is_confirmed; // by claim: an entry of Diagram_samples::sites()
  std::vector<char> m_needs_run;    // by site
  std::vector<Piece> m_pieces;      // of all arcs
  std::size_t m_most_pieces = 0;    // for the arc that is divided
  std::size_t m_divisions = 0;      // the same
  Face_id m_face = null_id;         // of the paths below
  Paths m_paths, m_bound;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_DISTANCE_CHECK_H
