// The checks behind a certificate of distances from curves do not trust the strips of a propagation: wrong ones and
// missing ones are found, whatever the distances are.

#include "curve_cases.h"
#include "run_from_curves.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Chunk_team.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Component_extents.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;

namespace {

namespace SMGI = SMG::internal;
using Strips = SMGI::Edge_strip_field<double>;
using Function = SMGI::Lower_bound_function<double>;

// What a certificate reads, and what it finds.
struct Witness : Run_from_curves
{
  Witness(const Mesh& tm, const std::vector<Curve>& curves)
    : Run_from_curves(tm, curves), extents(SMGI::extents_of_components(surface.mesh()))
  {}

  // The violation of the condition between points of a face, with the given strips.
  double violation(const Strips* strips) const
  {
    Function function(surface.mesh(), field.distance, windows, strips);
    return prove(function);
  }

  double prove(Function& function) const
  {
    return SMGI::prove_lower_bounds(SMGI::Chunk_team<SMGI::Calling_thread>(), function, extents, [] { return true; })
      .size;
  }

  // How far the function exceeds an offset on the edges of the curves.
  double excess_on_edges(const Function& function, double offset) const
  {
    SMGI::Worst_violation<double> worst;
    for(const auto& e : arrivals.curves.edges)
      SMGI::record_excess_on_edge(function, e.left != SMGI::null_id ? e.left : e.right, offset, extents, worst);
    CHECK(worst.number_of_checks >= 2 * arrivals.curves.edges.size());
    return worst.size;
  }

  // Calls change(strip) for a copy of strip number i, and returns all strips with the changed one.
  template <typename Change>
  Strips changed(std::size_t i, const Change& change) const
  {
    Strips result;
    result.reset(surface.mesh().number_of_faces());
    for(SMGI::Face_id f = 0; f < surface.mesh().number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
        arrivals.strips.for_each_numbered_strip(SMGI::halfedge_of(f, k),
                                                [&](std::size_t number, const SMGI::Strip<double>& strip)
        {
          SMGI::Strip<double> copy = strip;
          if(number == i)
            change(copy);
          result.keep(SMGI::halfedge_of(f, k), copy);
        });
    return result;
  }

  std::vector<double> extents;
};

// The violation of the condition between samples of points on different sides of each face: a lower bound of that
// between all points.
double sampled_violation(const Witness& witness, const Strips& strips)
{
  constexpr int n = 48;
  const auto& mesh = witness.surface.mesh();
  Function function(mesh, witness.field.distance, witness.windows, &strips);
  function.make(SMGI::Chunk_team<SMGI::Calling_thread>(), [] { return true; });
  double worst = 0;
  std::vector<SMGI::Distance_piece<double>> pieces;
  for(SMGI::Face_id f = 0; f < mesh.number_of_faces(); ++f)
  {
    const auto& face = mesh.face(f);
    const auto corner = SMGI::layout_of_face(face);
    struct Sample
    {
      unsigned int side;
      double x, y, value;
    };
    std::vector<Sample> samples;
    for(unsigned int k = 0; k < 3; ++k)
    {
      function.read(SMGI::halfedge_of(f, k), false, pieces);
      const auto &a = corner[k], &b = corner[(k + 1) % 3];
      std::size_t i = 0;
      for(int j = 0; j <= n && !pieces.empty(); ++j)
      {
        const double t = face.length[k] * j / n;
        while(i + 1 < pieces.size() && pieces[i].end < t)
          ++i;
        samples.push_back({k, a.x + (b.x - a.x) * j / n, a.y + (b.y - a.y) * j / n, pieces[i].at(t)});
      }
    }
    for(const Sample& p : samples)
      for(const Sample& q : samples)
        if(p.side != q.side)
          worst = (std::max)(worst, (p.value - q.value - std::hypot(p.x - q.x, p.y - q.y))
                                      / (p.value + SMGI::longest_side(face)));
  }
  return worst;
}

// Nothing is left of the strips but those of the curves themselves, or those on every other halfedge.
void violations_between_samples_are_found(const Indexed_mesh& indexed)
{
  const test_support::Scope scope(indexed.name + ", samples");
  test_support::Random random(5);
  const Mesh tm = to_face_graph(indexed);
  const Witness witness(tm, {Curve(tm, random_locations(tm, 5, random))});
  std::size_t number_of_large = 0;
  const auto check = [&](const std::function<bool(SMGI::Halfedge_id, const SMGI::Strip<double>&)>& is_left)
  {
    Strips strips;
    strips.reset(witness.surface.mesh().number_of_faces());
    for(SMGI::Face_id f = 0; f < witness.surface.mesh().number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
        witness.arrivals.strips.for_each_strip(SMGI::halfedge_of(f, k), [&](const SMGI::Strip<double>& s)
        {
          if(is_left(SMGI::halfedge_of(f, k), s))
            strips.keep(SMGI::halfedge_of(f, k), s);
        });
    const double expected = sampled_violation(witness, strips), found = witness.violation(&strips);
    CHECK(found >= expected - 1e-14 && found <= 1.1 * expected + 1e-14);
    number_of_large += expected > 1e-2 ? 1 : 0;
  };
  check([](SMGI::Halfedge_id, const SMGI::Strip<double>& s) { return s.faces_crossed == 0; });
  check([](SMGI::Halfedge_id, const SMGI::Strip<double>& s) { return s.faces_crossed <= 1; });
  check([](SMGI::Halfedge_id h, const SMGI::Strip<double>&) { return h % 2 == 0; });
  CHECK(number_of_large > 0);
}

void wrong_strips_are_found(const Indexed_mesh& indexed)
{
  const test_support::Scope scope(indexed.name);
  test_support::Random random(1);
  const Mesh tm = to_face_graph(indexed);
  const Witness witness(tm, {Curve(tm, random_locations(tm, 5, random)),
                             Curve(tm, random_vertices_along_edges(tm, 3, random))});
  const Strips& strips = witness.arrivals.strips;
  CHECK(witness.violation(&strips) < 1e-14);
  CHECK(witness.violation(nullptr) > 1e-3); // all strips are missing
  std::size_t number_of_turned = 0;
  for(std::size_t i = 0; i < strips.size(); i += 1 + strips.size() / 200)
  {
    const Strips nearer = witness.changed(i, [](SMGI::Strip<double>& s) { s.distance -= 1; });
    CHECK(witness.violation(&nearer) > 1e-3);
    // A direction that is not of length 1 means nothing. If it is believed, the condition is checked for another
    // function than that of the rays.
    const Strips longer = witness.changed(i, [](SMGI::Strip<double>& s) { s.direction_x *= 2; s.direction_y *= 2; });
    CHECK(witness.violation(&longer) < 1e-14);
    // Nor does a direction away from the face.
    const Strips down = witness.changed(i, [](SMGI::Strip<double>& s) { s.direction_y *= -1; });
    CHECK(witness.violation(&down) < 1e-14);
    const Strips turned = witness.changed(i, [](SMGI::Strip<double>& s)
    {
      const double x = s.direction_x, y = s.direction_y, t = s.direction_x > 0 ? .1 : -.1;
      s.direction_x = x * std::cos(t) - y * std::sin(t);
      s.direction_y = y * std::cos(t) + x * std::sin(t);
    });
    number_of_turned += witness.violation(&turned) > 1e-5;
  }
  CHECK(number_of_turned > 5);
}

// The distances from the ends of the edges alone satisfy all conditions but one: they are too long inside of the edges.
void distances_from_ends_are_no_bounds()
{
  const test_support::Scope scope("ends of edges");
  test_support::Random random(2);
  const Mesh tm = to_face_graph(saddle_patch(6));
  Witness witness(tm, {Curve(tm, random_locations(tm, 5, random))});
  {
    Function function(witness.surface.mesh(), witness.field.distance, witness.windows, &witness.arrivals.strips);
    CHECK(witness.prove(function) < 1e-14 && witness.excess_on_edges(function, 0) == 0);
    CHECK(witness.excess_on_edges(function, .125) == 0);
    CHECK(witness.excess_on_edges(function, -.125) > .01);
  }
  witness.windows.reset(witness.surface.mesh().number_of_faces());
  SMGI::Distance_propagation<double, SMGI::All_pruning_rules, SMGI::Window_keeper<double>> propagation(
    witness.surface.mesh(), witness.field, SMGI::Window_keeper<double>(witness.windows));
  for(const auto& v : witness.arrivals.curves.vertices)
    propagation.add_source(v.vertex, 0.);
  propagation.run([](std::size_t, double) { return true; });
  Function function(witness.surface.mesh(), witness.field.distance, witness.windows);
  CHECK(witness.prove(function) < 1e-14);
  CHECK(witness.excess_on_edges(function, 0) > .01);
}

// The least value of a function on an edge, whether it has been made or not, and whichever way the edge is named.
void least_values_are_those_of_the_edge()
{
  const test_support::Scope scope("least value");
  test_support::Random random(3);
  const Mesh tm = to_face_graph(saddle_patch(4));
  const Witness witness(tm, {Curve(tm, random_locations(tm, 4, random))});
  const auto& mesh = witness.surface.mesh();
  Function function(mesh, witness.field.distance, witness.windows, &witness.arrivals.strips);
  CHECK(witness.prove(function) < 1e-14);
  SMGI::Edge_distance_function<double> on_edge;
  std::vector<SMGI::Distance_piece<double>> pieces;
  std::size_t number_inside = 0;
  for(SMGI::Face_id f = 0; f < mesh.number_of_faces(); ++f)
    for(unsigned int k = 0; k < 3; ++k)
    {
      const SMGI::Halfedge_id h = SMGI::halfedge_of(f, k);
      function.read(h, false, pieces);
      double sampled = infinity;
      for(const auto& p : pieces)
        for(int i = 0; i <= 1000; ++i)
          sampled = (std::min)(sampled, p.at(p.begin + (p.end - p.begin) * i / 1000));
      const double least = function.least_value(h, on_edge);
      CHECK(least <= sampled + 1e-14 && least >= sampled - 1e-3);
      number_inside += least < (std::min)(pieces.front().at(0), pieces.back().at(mesh.length(h))) - 1e-3;
    }
  CHECK(number_inside > 0);
}

// A function on an edge is the least of distances from images and along rays, at all points of the edge: it is compared
// with the pieces that it was made of. The other way around it is the same.
void functions_are_minima()
{
  const test_support::Scope scope("minimum");
  using Piece = SMGI::Distance_piece<double>;
  test_support::Random random(4);
  SMGI::Edge_distance_function<double> function;
  std::size_t number_of_changes = 0;
  for(int i = 0; i < 500; ++i)
  {
    std::vector<Piece> pieces;
    function.restart(2.);
    for(std::size_t n = 2 + random.index(4); n > 0; --n)
    {
      const double angle = random.uniform(.01, 3.13), depth = random.index(4) == 0 ? 0. : random.uniform(0., 1.);
      const bool is_linear = random.index(2) == 0;
      pieces.push_back(is_linear
                         ? Piece{0., 2., std::cos(angle), std::sin(angle), random.uniform(.5, 1.5), true}
                         : Piece{0., 2., random.uniform(-.5, 2.5), depth, random.uniform(0., 1.), false});
      function.add(pieces.back());
    }
    number_of_changes += function.pieces().size() - 1;
    for(const Piece& p : function.pieces())
      for(int k = 0; k <= 50; ++k)
      {
        const double t = p.begin + (p.end - p.begin) * k / 50;
        double least = infinity;
        for(const Piece& q : pieces)
          least = (std::min)(least, q.at(t));
        CHECK_NEAR(p.at(t), least, 1e-14);
        CHECK_NEAR(p.backward(2.).at(2 - t), p.at(t), 1e-14);
        CHECK(p.at(p.nearest()) <= p.at(t) + 1e-15);
      }
  }
  CHECK(number_of_changes > 100);
}

} // namespace

int main()
{
  functions_are_minima();
  violations_between_samples_are_found(saddle_patch(4));
  violations_between_samples_are_found(icosphere(1));
  wrong_strips_are_found(saddle_patch(4));
  wrong_strips_are_found(icosphere(1));
  distances_from_ends_are_no_bounds();
  least_values_are_those_of_the_edge();
  return test_result();
}
