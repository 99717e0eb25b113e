// The laws and error bounds in the comments of the predicates of numeric/ and window/. Random windows, some of them
// degenerate, are compared with the definitions in a hundred digits, with their mirror images, and with scaled windows.

#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Angle_sum.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_loops.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
using Window = internal::Window<double>;
using Frame = internal::Face_frame<double>;
using Rival = internal::Vertex_rival<double>;
using internal::Pair_outcome;

const double epsilon = std::numeric_limits<double>::epsilon();

// --- random windows --------------------------------------------------------------------------------------------------

// Returns a number whose mirror image 1 - x is exact. Some numbers occur repeatedly.
double dyadic(test_support::Random& random, double scale)
{
  return scale * static_cast<double>(random.index(33)) / 32;
}

template <typename FT>
void set_end_distances(internal::Window<FT>& w)
{
  w.begin_distance = w.distance_at(w.begin);
  w.end_distance = w.distance_at(w.end);
  w.key = internal::initial_window_key;
  w.root = 0;
  w.steps = 0;
}

// A window on an edge of the length 1. Some images lie on the edge, or above the end of an interval.
Window random_window(test_support::Random& random)
{
  Window w;
  w.begin = static_cast<double>(random.index(32)) / 32;
  w.end = w.begin + (1 - w.begin) * static_cast<double>(1 + random.index(4)) / 4;
  w.image_x = random.index(4) == 0 ? w.begin : dyadic(random, 3) - 1;
  w.image_depth = random.index(8) == 0 ? std::ldexp(1., -static_cast<int>(random.index(60)))
                                       : 1. / 64 + dyadic(random, 2);
  w.root_distance = random.index(2) == 0 ? 0 : random.uniform(0., 2.);
  set_end_distances(w);
  return w;
}

// The mirror image on an edge of the length 1.
Window mirrored(const Window& w)
{
  Window m = w;
  m.begin = 1 - w.end;
  m.end = 1 - w.begin;
  m.image_x = 1 - w.image_x;
  m.begin_distance = w.end_distance;
  m.end_distance = w.begin_distance;
  return m;
}

Window scaled(const Window& w, double factor)
{
  Window s = w;
  for(double* x : {&s.begin, &s.end, &s.image_x, &s.image_depth, &s.begin_distance, &s.end_distance, &s.root_distance})
  {
    *x *= factor;
  }
  return s;
}

bool are_same(const Window& a, const Window& b)
{
  return a.begin == b.begin && a.end == b.end && a.image_x == b.image_x && a.image_depth == b.image_depth
      && a.begin_distance == b.begin_distance && a.end_distance == b.end_distance && a.root_distance == b.root_distance;
}

Exact exact_distance(const Window& w, const Exact& x, const Exact& height = 0)
{
  const Exact dx = x - w.image_x, dy = height + w.image_depth;
  return w.root_distance + sqrt(dx * dx + dy * dy);
}

// Is a less than b by more than `factor` epsilon of b?
bool is_less_by(const Exact& a, const Exact& b, double factor)
{
  return a < b * (1 - factor * epsilon);
}

// --- one distance, two distances -------------------------------------------------------------------------------------

void distances_satisfy_their_error_bound(test_support::Random& random)
{
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const Window w = random_window(random);
    const double x = random.index(8) == 0 ? w.image_x : random.uniform(0., 1.);
    const Exact expected = exact_distance(w, x);
    CHECK(abs(Exact(w.distance_at(x)) - expected) <= expected * 2.0001 * epsilon);
    CHECK(w.minimum_distance() <= w.begin_distance && w.minimum_distance() <= w.end_distance);
    for(const double factor : {0x1p-100, 0x1p-1, 0x1p60})
    {
      CHECK_EQUAL(scaled(w, factor).distance_at(factor * x), factor * w.distance_at(x));
      CHECK_EQUAL(scaled(w, factor).minimum_distance(), factor * w.minimum_distance());
    }
    CHECK_EQUAL(mirrored(w).distance_at(1 - w.begin), w.begin_distance);
    CHECK_EQUAL(mirrored(w).minimum_distance(), w.minimum_distance());
  }
}

void comparison_is_a_strict_order(test_support::Random& random)
{
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const double a = random.uniform(0., 4.);
    std::array<double, 3> d{a, a * (1 + epsilon * double(random.index(12))),
                            a * (1 + epsilon * double(random.index(12)))};
    for(const double x : d)
    {
      CHECK(!internal::is_clearly_less(x, x));
      for(const double y : d)
      {
        const bool is_less = internal::is_clearly_less(x, y);
        CHECK(!is_less || x < y);
        CHECK(!is_less || !internal::is_clearly_less(y, x));
        CHECK_EQUAL(internal::is_clearly_less(0x1p-200 * x, 0x1p-200 * y), is_less);
        for(const double z : d)
        {
          CHECK(!is_less || !internal::is_clearly_less(y, z) || internal::is_clearly_less(x, z));
        }
      }
    }
  }
}

// --- pairs of windows ------------------------------------------------------------------------------------------------

// Applies the rule of Trimmed_pairs with exact distances. `factor` times epsilon is the margin of the comparison.
struct Exact_pair
{
  double left_end, right_begin;

  Exact_pair(const Window& left, const Window& right, double factor) : left_end(left.end), right_begin(right.begin)
  {
    const double first = (std::max)(left.begin, right.begin), last = (std::min)(left.end, right.end);
    if(is_less_by(exact_distance(right, first), exact_distance(left, first), factor))
    {
      left_end = first;
      return;
    }
    if(left.begin == first && is_less_by(exact_distance(left, first), exact_distance(right, first), factor))
    {
      right_begin = first;
    }
    if(is_less_by(exact_distance(left, last), exact_distance(right, last), factor))
    {
      right_begin = last;
    }
    else if(right.end == last && is_less_by(exact_distance(right, last), exact_distance(left, last), factor))
    {
      left_end = last;
    }
  }

  bool operator==(const Exact_pair& p) const { return left_end == p.left_end && right_begin == p.right_begin; }
};

// If, by the error bound, rounding cannot matter, the outcome is that of the definition.
void check_overlapping_pair(const Window& left, const Window& right, std::size_t& number_checked)
{
  const Exact_pair exact(left, right, 9);
  if(!(exact == Exact_pair(left, right, 0)))
  {
    return;
  }
  Window l = left, r = right;
  const Pair_outcome outcome = internal::prune_pair(l, r);
  CHECK_EQUAL(outcome == Pair_outcome::LEFT_IS_DOMINATED, exact.left_end <= left.begin);
  CHECK_EQUAL(outcome == Pair_outcome::RIGHT_IS_DOMINATED, exact.right_begin >= right.end);
  if(outcome == Pair_outcome::KEEP_BOTH)
  {
    CHECK_EQUAL(l.end, exact.left_end);
    CHECK_EQUAL(r.begin, exact.right_begin);
  }
  ++number_checked;
}

// The interval that remains is valid, and where two windows still overlap neither is clearly nearer on the wrong side.
void check_what_remains(const Window& l, const Window& r)
{
  CHECK(internal::is_valid(l, 1.) && internal::is_valid(r, 1.));
  if(r.begin < l.end && l.begin < r.end)
  {
    const double first = (std::max)(l.begin, r.begin), last = (std::min)(l.end, r.end);
    CHECK(!is_less_by(exact_distance(r, first), exact_distance(l, first), 9));
    CHECK(!is_less_by(exact_distance(l, last), exact_distance(r, last), 9));
  }
}

// A left window that is farther at the left end of the shared interval and nearer at the right end contradicts the
// order of keys. The rule then decides at the left end first, and its mirror image at the right end.
bool contradicts_order(const Window& left, const Window& right)
{
  const double first = (std::max)(left.begin, right.begin), last = (std::min)(left.end, right.end);
  return first < last && exact_distance(right, first) < exact_distance(left, first)
      && exact_distance(left, last) < exact_distance(right, last);
}

void check_symmetries_of_pair(const Window& left, const Window& right, Pair_outcome outcome, const Window& l,
                              const Window& r)
{
  for(const double factor : {0x1p-90, 0x1p7})
  {
    Window sl = scaled(left, factor), sr = scaled(right, factor);
    CHECK(internal::prune_pair(sl, sr) == outcome);
    CHECK(are_same(sl, scaled(l, factor)) && are_same(sr, scaled(r, factor)));
  }
  if(contradicts_order(left, right))
  {
    return;
  }
  Window ml = mirrored(right), mr = mirrored(left);
  const Pair_outcome expected = outcome == Pair_outcome::LEFT_IS_DOMINATED    ? Pair_outcome::RIGHT_IS_DOMINATED
                                : outcome == Pair_outcome::RIGHT_IS_DOMINATED ? Pair_outcome::LEFT_IS_DOMINATED
                                                                              : Pair_outcome::KEEP_BOTH;
  CHECK(internal::prune_pair(ml, mr) == expected);
  CHECK(are_same(ml, mirrored(r)) && are_same(mr, mirrored(l)));
}

// The exact distance of a window at a point of the path to (x,0), at the height -h.
Exact distance_below(const Window& w, double x, const Exact& h)
{
  return exact_distance(w, x + h * (Exact(w.image_x) - x) / w.image_depth, -h);
}

struct Numbers_of_crossings
{
  std::size_t below_edge = 0, near_image = 0, beyond_image = 0;
};

// The definition of the rule for crossed windows: the paths to left.begin and to right.end cross at the height -h.
void check_crossed_pair(const Window& left, const Window& right, Pair_outcome outcome, Numbers_of_crossings& numbers)
{
  if(!(left.image_depth > 0 && right.image_depth > 0))
    return;
  const Exact left_slope = (Exact(left.image_x) - left.begin) / left.image_depth,
              right_slope = (Exact(right.image_x) - right.end) / right.image_depth;
  const Exact approach = right_slope - left_slope;
  const Exact h = approach > 0 ? Exact((Exact(left.begin) - right.end) / approach) : Exact(0);
  if(!(h > 0))
    return;
  const Exact k = h / (std::min)(left.image_depth, right.image_depth);
  const Exact error_of_k = 4 * epsilon * (1 + (abs(left_slope) + abs(right_slope)) / approach);
  ++(k > 1 ? numbers.beyond_image : k > .999 ? numbers.near_image : numbers.below_edge);
  if(k > 1 + error_of_k)
  {
    CHECK(outcome == Pair_outcome::KEEP_BOTH);
    return;
  }
  const Exact at_left = distance_below(left, left.begin, h), at_right = distance_below(right, right.end, h);
  const Exact unit = epsilon * (std::max)(left.begin_distance, right.end_distance);
  if(outcome == Pair_outcome::LEFT_IS_DOMINATED)
    CHECK(at_right <= at_left + 8 * unit);
  if(outcome == Pair_outcome::RIGHT_IS_DOMINATED)
    CHECK(at_left <= at_right + 8 * unit);
  if(k <= 1 - error_of_k && abs(Exact(at_left - at_right)) > 13 * unit)
    CHECK(outcome == (at_left < at_right ? Pair_outcome::RIGHT_IS_DOMINATED : Pair_outcome::LEFT_IS_DOMINATED));
}

bool are_allowed(const Window& left, const Window& right)
{
  return !internal::is_too_close_to_trim(left, 1.) && !internal::is_too_close_to_trim(right, 1.);
}

// Two images that are close to each other: paths cross near them, or beyond them, where the rule keeps both windows.
void crossings_near_images_obey_definition(test_support::Random& random)
{
  Numbers_of_crossings numbers;
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const double distance = std::ldexp(1., -static_cast<int>(random.index(52)));
    Window left = random_window(random), right = left;
    left.begin = .5 + random.uniform(0., .3);
    left.end = left.begin + .1;
    right.end = .5 - random.uniform(0., .3) * std::ldexp(1., -static_cast<int>(random.index(8)));
    right.begin = right.end - .1;
    left.image_depth = random.uniform(.01, 1.);
    right.image_depth = left.image_depth + distance * random.uniform(0., .01);
    right.image_x = left.image_x + distance * random.uniform(-.5, 1.);
    right.root_distance = left.root_distance + random.uniform(0., 1e-3) * distance;
    set_end_distances(left);
    set_end_distances(right);
    Window l = left, r = right;
    check_crossed_pair(left, right, internal::prune_pair(l, r), numbers);
  }
  CHECK(numbers.below_edge > 100 && numbers.near_image > 100 && numbers.beyond_image > 100);
}

void pairs_obey_definition_and_symmetries(test_support::Random& random)
{
  std::size_t number_overlapping = 0;
  Numbers_of_crossings numbers;
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const Window left = random_window(random), right = random.index(8) == 0 ? left : random_window(random);
    if(!are_allowed(left, right))
      continue;
    Window l = left, r = right;
    const Pair_outcome outcome = internal::prune_pair(l, r);
    if(left.end <= right.begin)
    {
      CHECK(outcome == Pair_outcome::KEEP_BOTH);
    }
    else if(right.end <= left.begin)
    {
      check_crossed_pair(left, right, outcome, numbers);
      continue; // the rule moves neither window, and its mirror image rounds differently
    }
    else
    {
      check_overlapping_pair(left, right, number_overlapping);
      if(outcome == Pair_outcome::KEEP_BOTH)
      {
        check_what_remains(l, r);
      }
    }
    check_symmetries_of_pair(left, right, outcome, l, r);
  }
  CHECK(number_overlapping > 1000 && numbers.below_edge > 100 && numbers.beyond_image > 100);
}

void the_rule_of_pairs_never_removes_both(test_support::Random& random)
{
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const Window left = random_window(random), right = random_window(random);
    const internal::one_lane::Trimmed_pairs<double> pair(left, right, -1.);
    CHECK(!(pair.left_is_dominated && pair.right_is_dominated));
    const bool are_crossed = right.end <= left.begin && right.begin < left.end;
    CHECK_EQUAL(pair.is_undecided != 0, are_crossed || pair.left_is_dominated || pair.right_is_dominated);
    const internal::one_lane::Trimmed_pairs<double> close(left, right, 10.); // every image is treated as close
    CHECK(close.left_end == left.end && close.right_begin == right.begin);
  }
}

// An image on the edge, outside its interval, has no slope to divide by. The rule does not divide, and decides nothing.
void images_on_the_edge_keep_crossed_pairs(test_support::Random& random)
{
  std::size_t number_checked = 0;
  for(std::size_t i = 0; i < 20000; ++i)
  {
    Window left = random_window(random), right = random_window(random);
    const std::size_t flat = random.index(3); // the left one, the right one, or both
    for(Window* w : {flat != 1 ? &left : nullptr, flat != 0 ? &right : nullptr})
      if(w != nullptr)
      {
        w->image_depth = 0;
        set_end_distances(*w);
      }
    if(right.end > left.begin || !are_allowed(left, right))
      continue;
    CHECK(internal::is_valid(left, 1.) && internal::is_valid(right, 1.));
    Window l = left, r = right;
    std::feclearexcept(FE_ALL_EXCEPT);
    const Pair_outcome outcome = internal::prune_pair(l, r);
    CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID) == 0);
    CHECK(outcome == Pair_outcome::KEEP_BOTH && are_same(l, left) && are_same(r, right));
    ++number_checked;
  }
  CHECK(number_checked > 100);
}

// --- vertices --------------------------------------------------------------------------------------------------------

void the_vertex_rule_obeys_definition_and_symmetries(test_support::Random& random)
{
  std::size_t number_beaten = 0;
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const Window w = random_window(random);
    const Rival left(random.uniform(0., 3.), false), right(random.uniform(0., 3.), false);
    const bool is_beaten = internal::is_beaten_by_vertices(w, 1., left, right);
    const Exact by_left = Exact(left.distance) + w.end, by_right = Exact(right.distance) + (1 - w.begin);
    const bool expected = by_left < w.end_distance || by_right < w.begin_distance;
    const bool is_clear = is_less_by(by_left, w.end_distance, 6) || is_less_by(by_right, w.begin_distance, 6);
    CHECK(expected || !is_beaten); // no window is lost to a vertex that is not nearer
    CHECK(is_beaten || !is_clear);
    CHECK_EQUAL(internal::is_beaten_by_vertices(mirrored(w), 1., right, left), is_beaten);
    const double factor = 0x1p-60;
    CHECK_EQUAL(internal::is_beaten_by_vertices(scaled(w, factor), factor, Rival(factor * left.distance, false),
                                                Rival(factor * right.distance, false)),
                is_beaten);
    number_beaten += is_beaten ? 1 : 0;
  }
  CHECK(number_beaten > 1000);
}

// --- angles ----------------------------------------------------------------------------------------------------------

void sums_of_angles_satisfy_their_error_bound(test_support::Random& random)
{
  for(std::size_t n = 1; n < 600; n += 1 + n / 3)
  {
    internal::Angle_sum<double> sum, large;
    internal::Angle_sum<Exact> exact;
    for(std::size_t i = 0; i < n; ++i)
    {
      const double dot = random.uniform(-1., 1.), cross = random.uniform(0., 1.);
      sum.add(dot, cross);
      large.add(0x1p50 * dot, 0x1p50 * cross);
      exact.add(dot, cross);
    }
    const Exact turned = (sum.cosine * exact.sine - sum.sine * exact.cosine)
                       / sqrt((exact.cosine * exact.cosine + exact.sine * exact.sine)
                              * (Exact(sum.cosine) * sum.cosine + Exact(sum.sine) * sum.sine));
    CHECK(abs(turned) <= 2 * epsilon * double(n));
    CHECK(sum.cosine == large.cosine && sum.sine == large.sine && sum.turns == large.turns);
  }
}

// --- windows across faces --------------------------------------------------------------------------------------------

// The frame of the side `base` of a triangle whose other sides, counterclockwise, are `right` and `left`.
template <typename FT>
internal::Face_frame<FT> frame(double base, double right, double left)
{
  std::array<double, 3> s{base, right, left};
  unsigned int first = 0; // the side AB, after the shortest one has been moved to the front
  while(!(s[0] <= s[1] && s[0] <= s[2]))
  {
    std::rotate(s.begin(), s.begin() + 1, s.end());
    first = internal::previous_corner(first);
  }
  internal::Intrinsic_mesh<FT> mesh;
  mesh.reset(1);
  internal::Intrinsic_face<FT>& face = mesh.face(0);
  const auto triangle = internal::planar_triangle_from_lengths<FT>(s[0], s[1], s[2]);
  face.length = {FT(s[0]), FT(s[1]), FT(s[2])};
  face.apex_x = triangle.apex_x;
  face.apex_y = triangle.apex_y;
  face.vertex = {0, 1, 2};
  face.opposite = {internal::null_id, internal::null_id, internal::null_id};
  return mesh.face_frame(internal::halfedge_of(0, first));
}

// The child of a window across one face, on its left or its right edge.
template <typename FT>
internal::Window<FT> child(const internal::Window<FT>& w, const internal::Face_frame<FT>& c, bool is_left)
{
  internal::one_lane::Window_lanes<FT> lanes{{w.begin, w.end, w.image_x, w.image_depth, w.begin_distance,
                                              w.end_distance, w.root_distance}, w.key, w.history()};
  const FT t = internal::one_lane::apex_abscissa<FT>(lanes, c);
  if(is_left)
    internal::one_lane::Left_child<FT>{c}(lanes, t, c.length);
  else
    internal::one_lane::Right_child<FT>{c}(lanes, t, FT(0));
  internal::Window<FT> result;
  static_cast<internal::one_lane::Window_numbers<FT>&>(result) = lanes;
  result.key = lanes.key;
  result.set_history(lanes.history);
  return result;
}

template <typename FT>
bool goes_left(const internal::Window<FT>& w, const internal::Face_frame<FT>& c)
{
  return w.begin * (c.apex_y + w.image_depth) < w.image_x * c.apex_y + c.apex_x * w.image_depth;
}

template <typename FT>
internal::Window<FT> window_on_edge(double length, double begin, double image_x, double image_depth)
{
  internal::Window<FT> w;
  w.begin = begin * length;
  w.end = length;
  w.image_x = image_x;
  w.image_depth = image_depth;
  w.root_distance = 0;
  set_end_distances(w);
  return w;
}

// A ray through the beginning of the window runs through many triangles. The error of the image stays below the bound
// in Tolerance.h.
double errors_of_images(test_support::Random& random, std::size_t flatness)
{
  double length = 1, longest = 1, worst = 0;
  const double begin = random.uniform(.2, .8), image_x = random.uniform(-1., 2.), depth = random.uniform(.01, 1.);
  internal::Window<double> found = window_on_edge<double>(length, begin, image_x, depth);
  internal::Window<Exact> exact = window_on_edge<Exact>(length, begin, image_x, depth);
  for(int n = 1; n <= 100; ++n)
  {
    const double x = random.uniform(0., 1.),
                 y = std::ldexp(random.uniform(.5, 1.), -static_cast<int>(random.index(flatness)));
    const double left = length * std::hypot(x, y), right = length * std::hypot(1 - x, y);
    longest = (std::max)({longest, left, right});
    const internal::Face_frame<Exact> c = frame<Exact>(length, right, left);
    const bool is_left = goes_left(exact, c);
    exact = child(exact, c, is_left);
    found = child(found, frame<double>(length, right, left), is_left);
    length = is_left ? left : right;
    exact.end = length;
    found.end = length;
    found.begin = static_cast<double>(exact.begin);
    const double dx = static_cast<double>(exact.image_x - found.image_x),
                 dy = static_cast<double>(exact.image_depth - found.image_depth);
    const double d = static_cast<double>(sqrt((exact.begin - exact.image_x) * (exact.begin - exact.image_x)
                                              + exact.image_depth * exact.image_depth));
    worst = (std::max)(worst, std::hypot(dx, dy) / (n * epsilon * (d + longest)));
    if(length < 1e-3 || length > 1e3) // scales the next triangles to sides of about length 1
      break;
  }
  return worst;
}

void images_satisfy_their_error_bound(test_support::Random& random)
{
  double worst = 0;
  for(std::size_t i = 0; i < 300; ++i)
  {
    worst = (std::max)(worst, errors_of_images(random, i % 2 == 0 ? 1u : 20u));
  }
  std::cout << "error of images, over n epsilon (d + L): " << worst << std::endl;
  CHECK(worst <= 24);
}

Frame mirrored(const Frame& c)
{
  Frame m = c;
  std::swap(m.apex_x, m.apex_rest);
  std::swap(m.left_length, m.right_length);
  return m;
}

// Compares the children of a window with those of its mirror image and of the scaled window.
void children_obey_symmetries(test_support::Random& random)
{
  for(std::size_t i = 0; i < 5000; ++i)
  {
    const Window w = random_window(random);
    const double x = random.uniform(-.5, 1.5), y = random.uniform(.1, 1.);
    const Frame c = frame<double>(1., std::hypot(1 - x, y), std::hypot(x, y));
    for(const bool is_left : {true, false})
    {
      const Window found = child(w, c, is_left), mirror = child(mirrored(w), mirrored(c), !is_left);
      const double length = is_left ? c.left_length : c.right_length, size = 4;
      if(found.image_depth > 1e-9)
      {
        CHECK_NEAR(mirror.image_x, length - found.image_x, 48 * epsilon * size);
        CHECK_NEAR(mirror.image_depth, found.image_depth, 48 * epsilon * size);
      }
      const double f = 0x1p-40;
      Frame small = c;
      for(double* l : {&small.length, &small.apex_x, &small.apex_rest, &small.apex_y, &small.left_length,
                       &small.right_length})
        *l *= f;
      const Window scaled_child = child(scaled(w, f), small, is_left);
      CHECK(scaled_child.image_x == f * found.image_x && scaled_child.image_depth == f * found.image_depth);
      CHECK(scaled_child.key == found.key);
      CHECK(std::isnan(found.begin) || std::isnan(found.end)
            || (scaled_child.begin == f * found.begin && scaled_child.end == f * found.end));
    }
  }
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20261122));
  distances_satisfy_their_error_bound(random);
  comparison_is_a_strict_order(random);
  pairs_obey_definition_and_symmetries(random);
  crossings_near_images_obey_definition(random);
  the_rule_of_pairs_never_removes_both(random);
  images_on_the_edge_keep_crossed_pairs(random);
  the_vertex_rule_obeys_definition_and_symmetries(random);
  sums_of_angles_satisfy_their_error_bound(random);
  images_satisfy_their_error_bound(random);
  children_obey_symmetries(random);
  return test_support::test_result();
}
