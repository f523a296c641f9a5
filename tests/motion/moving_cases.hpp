#pragma once

/// Pairs of moving triangles that meet in special ways, from integers: exact in float32.

#include "exact/finite_floats.hpp"
#include "geometry/triangle_cases.hpp"
#include "motion/moving_polynomials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace pelt::test {

using detail::MovingTriangle;

struct MovingPair {
  MovingTriangle a, b;
};

/// Positions of two triangles at both ends of the step.
struct MovingIntegers {
  IntegerPair from, to;
};

inline std::array<Point*, 6> corners_of(IntegerPair& pair) {
  return {&pair.a[0], &pair.a[1], &pair.a[2], &pair.b[0], &pair.b[1], &pair.b[2]};
}

/// Calls visit(from, to) for each corner.
template <typename Visit>
void for_each_corner(MovingIntegers& motion, const Visit& visit) {
  const auto from = corners_of(motion.from), to = corners_of(motion.to);
  for (std::size_t i = 0; i < 6; ++i) visit(*from[i], *to[i]);
}

inline MovingIntegers grid_motion(Random& random, std::int64_t limit) {
  MovingIntegers motion;
  for_each_corner(motion, [&](Point& from, Point& to) {
    from = uniform_point(random, 0, limit);
    to = uniform_point(random, 0, limit);
  });
  return motion;
}

inline MovingIntegers on_small_grid(Random& random) { return grid_motion(random, 3); }
inline MovingIntegers on_medium_grid(Random& random) { return grid_motion(random, 40); }
inline MovingIntegers on_large_grid(Random& random) { return grid_motion(random, kLimit); }

/// All corners stay in one sloping plane.
inline MovingIntegers in_still_plane(Random& random) {
  MovingIntegers motion = grid_motion(random, 9);
  for_each_corner(motion, [](Point& from, Point& to) {
    from[2] = 2 * from[0] - 3 * from[1];
    to[2] = 2 * to[0] - 3 * to[1];
  });
  return motion;
}

/// All corners stay in one plane, which turns: x and y are constant, z is a linear function of them
/// that changes.
inline MovingIntegers in_turning_plane(Random& random) {
  MovingIntegers motion = grid_motion(random, 6);
  const std::int64_t x0 = uniform(random, -2, 2), y0 = uniform(random, -2, 2);
  const std::int64_t x1 = uniform(random, -2, 2), y1 = uniform(random, -2, 2);
  const bool is_wandering = random() % 2 != 0;  // in a plane that is then parallel to an axis
  for_each_corner(motion, [&](Point& from, Point& to) {
    if (is_wandering) {
      from[1] = to[1] = 0;
      from = {from[0], x0 * from[2], y0 * from[2]};
      to = {to[0], x0 * to[2], y0 * to[2]};
      return;
    }
    to = from;
    from[2] = x0 * from[0] + y0 * from[1];
    to[2] = x1 * to[0] + y1 * to[1];
  });
  return motion;
}

inline MovingIntegers with_still_corners(Random& random) {
  MovingIntegers motion = grid_motion(random, 4);
  for_each_corner(motion, [&](Point& from, Point& to) {
    if (random() % 2) to = from;
  });
  return motion;
}

/// One triangle is a segment or a point at all times, and in every other pair the other one too.
inline MovingIntegers always_collapsed(Random& random) {
  MovingIntegers motion = grid_motion(random, 4);
  const auto collapse_both = [&](IntegerCorners& from, IntegerCorners& to) {
    const auto way = random() % 3;
    for (IntegerCorners* t : {&from, &to}) {
      auto& [p, q, r] = *t;
      if (way == 0) q = r = p;
      if (way == 1) r = q;
      if (way == 2) q = 2 * r - p;
    }
  };
  collapse_both(motion.from.a, motion.to.a);
  if (random() % 2) collapse_both(motion.from.b, motion.to.b);
  return motion;
}

/// All corners stay on one line.
inline MovingIntegers on_line(Random& random) {
  const Point direction = uniform_point(random, -2, 2), start = uniform_point(random, -2, 2);
  MovingIntegers motion;
  for_each_corner(motion, [&](Point& from, Point& to) {
    from = start + uniform(random, 0, 60) * direction;
    to = start + uniform(random, 0, 60) * direction;
  });
  // Triangle b is short, so that it does not always meet a.
  for (IntegerPair* pair : {&motion.from, &motion.to})
    for (std::size_t i = 1; i < 3; ++i)
      pair->b[i] = pair->b[0] + static_cast<std::int64_t>(i) * direction;
  return motion;
}

/// Triangle b moves without turning, often along a's plane.
inline MovingIntegers sliding(Random& random) {
  MovingIntegers motion = grid_motion(random, 4);
  const auto& [p, q, r] = motion.from.a;
  const Point shift = uniform(random, -2, 2) * (q - p) + uniform(random, -2, 2) * (r - p);
  if (random() % 2)
    for (Point& corner : motion.from.b)
      corner = p + uniform(random, -1, 3) * (q - p) + uniform(random, -1, 3) * (r - p);
  motion.to = motion.from;
  for (Point& corner : motion.to.b) corner = corner + shift;
  return motion;
}

/// Two corners of b change places, so that it collapses at half time.
inline MovingIntegers swapping(Random& random) {
  MovingIntegers motion = grid_motion(random, 5);
  motion.to.a = motion.from.a;
  motion.to.b = motion.from.b;
  std::swap(motion.to.b[0], motion.to.b[1]);
  if (random() % 4) motion.to.b[2] = uniform_point(random, 0, 5);
  if (random() % 4) motion.to.a[0] = uniform_point(random, 0, 5);
  return motion;
}

/// In sixteenths of the step: where the corner is then, times 16.
inline Point at_sixteenth(const Point& from, const Point& to, std::int64_t k) {
  return (16 - k) * from + k * to;
}

/// A corner of b is on a's plane, on an edge or on a corner of a at a multiple of a 16th of the
/// step, up to one unit. Elsewhere it is on any side.
inline MovingIntegers nearly_meeting(Random& random) {
  MovingIntegers motion = grid_motion(random, 1'000);
  const std::int64_t k = uniform(random, 1, 16);
  const std::int64_t u = uniform(random, 0, 4), v = uniform(random, 0, 4 - u);
  std::array<Point, 3> a;
  for (std::size_t i = 0; i < 3; ++i) {
    for (Point* p : {&motion.from.a[i], &motion.to.a[i]}) *p = 16 * *p;
    a[i] = at_sixteenth(motion.from.a[i], motion.to.a[i], k);  // a multiple of 256
  }
  Point meeting = (4 - u - v) * a[0] + u * a[1] + v * a[2];
  for (std::int64_t& x : meeting) x /= 64;  // 64 / 16 of the sum of weights, exact
  const Point velocity = uniform_point(random, -500, 500);
  Point& from = motion.from.b[0];
  Point& to = motion.to.b[0];
  from = meeting - k * velocity;
  to = meeting + (16 - k) * velocity;
  const std::size_t axis = random() % 3;
  if (random() % 3) (random() % 2 ? from : to)[axis] += uniform(random, -1, 1);
  return motion;
}

/// Two corners of b reach the inside of a at the same multiple of a 16th of the step, up to one
/// unit in some pairs.
inline MovingIntegers landing_on_an_edge(Random& random) {
  MovingIntegers motion = grid_motion(random, 1'000);
  for_each_corner(motion, [](Point& from, Point& to) { from = 16 * from, to = 16 * to; });
  const std::int64_t k = uniform(random, 1, 16);
  const std::size_t first = random() % 3;
  for (std::size_t corner = 0; corner < 2; ++corner) {
    Point meeting = {};
    for (std::size_t i = 0; i < 3; ++i)
      meeting = meeting + (i == (first + corner) % 3 ? 2 : 1) *
                              at_sixteenth(motion.from.a[i], motion.to.a[i], k);
    for (std::int64_t& x : meeting) x /= 64;  // 64 / 16 of the sum of weights, exact
    const Point velocity = uniform_point(random, -500, 500);
    motion.from.b[corner] = meeting - k * velocity;
    motion.to.b[corner] = meeting + (16 - k) * velocity;
  }
  const std::size_t axis = random() % 3;
  if (random() % 2) motion.from.b[0][axis] += uniform(random, -1, 1);
  return motion;
}

/// Edge 0 of a keeps still. Seen from it, edge 0 of b has the direction (0, 16 t - k, s) and the
/// offset (0, d, 16 t - k), so that the determinant of the four ends has a double root at k / 16 if
/// s d is zero. If d is zero, edge 0 of b then crosses that of a, and pierces the plane z = 0 at
/// other times at y = -(16 t - k)^2 / s. In every other pair, the triangles lie on different sides
/// of there, and touch for one instant only.
inline MovingIntegers grazing(Random& random) {
  const bool is_for_one_instant = random() % 2 != 0;
  const std::int64_t k = uniform(random, 0, 16);
  const std::int64_t s = is_for_one_instant ? 1 : uniform(random, -1, 1);
  const std::int64_t d = is_for_one_instant ? 0 : uniform(random, -1, 1);
  const std::int64_t length = uniform(random, 1, 4);
  const std::int64_t back = uniform(random, 0, 2), x = uniform(random, -2, 2);
  MovingIntegers motion = grid_motion(random, 8);
  for (const std::int64_t time : {std::int64_t{0}, std::int64_t{16}}) {
    auto& [a, b] = time == 0 ? motion.from : motion.to;
    a[0] = {-length, 0, 0};
    a[1] = {length, 0, 0};
    a[2][1] += 4;
    if (is_for_one_instant) a[2][2] = 0;
    const Point direction = {x, time - k, s}, offset = {0, d, time - k};
    b[0] = offset - back * direction;
    b[1] = offset + 2 * direction;
    if (is_for_one_instant) b[2] = {uniform(random, -5, 5), -60, uniform(random, -5, 5)};
  }
  return motion;
}

/// Maps all points by a matrix with determinant 1, permutes corners, and swaps triangles.
inline void disguise(Random& random, MovingIntegers& motion) {
  const std::size_t to_axis = random() % 3, from_axis = (to_axis + 1 + random() % 2) % 3;
  const std::int64_t factor = uniform(random, -1, 1);
  for_each_corner(motion, [&](Point& from, Point& to) {
    from[to_axis] += factor * from[from_axis];
    to[to_axis] += factor * to[from_axis];
  });
  const std::size_t i = random() % 3, k = random() % 3;
  std::swap(motion.from.a[0], motion.from.a[i]), std::swap(motion.to.a[0], motion.to.a[i]);
  std::swap(motion.from.b[1], motion.from.b[k]), std::swap(motion.to.b[1], motion.to.b[k]);
  if (random() % 2) {
    std::swap(motion.from.a, motion.from.b);
    std::swap(motion.to.a, motion.to.b);
  }
}

template <MovingIntegers (*make)(Random&)>
MovingPair moving_integers(Random& random) {
  MovingIntegers motion = make(random);
  if (make != on_large_grid) disguise(random, motion);
  constexpr std::array kExponents = {-149, -20, 0, 30};
  const int exponent = kExponents[random() % kExponents.size()];
  return {{scaled(motion.from.a, exponent), scaled(motion.to.a, exponent)},
          {scaled(motion.from.b, exponent), scaled(motion.to.b, exponent)}};
}

/// A pair of `nearly_meeting`, with one coordinate moved to a neighbouring float.
inline MovingPair one_ulp_from_meeting(Random& random) {
  MovingPair pair = moving_integers<nearly_meeting>(random);
  const std::array ends = {&pair.a.from, &pair.a.to, &pair.b.from, &pair.b.to};
  const auto end = random() % ends.size(), corner = random() % 3, axis = random() % 3;
  Vec3& p = (*ends[end])[corner];
  float& x = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  x = std::nextafter(x, random() % 2 ? 0x1p60f : -0x1p60f);
  return pair;
}

/// Two points that pass each other, and in every other pair are at one position at time p / q. The
/// time at which a coordinate is equal rounds differently on each axis.
inline MovingPair points_passing(Random& random) {
  const std::int64_t p = uniform(random, 1, 9), q = p + uniform(random, 1, 9);
  const bool is_missing = random() % 2 != 0;
  Point from, to;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t unit = uniform(random, 1, (1 << 24) / std::max(p, q - p));
    const std::int64_t sign = random() % 2 ? 1 : -1;
    from[axis] = sign * p * unit;
    to[axis] = -sign * (q - p) * unit;
  }
  if (is_missing) from[0] -= from[0] < 0 ? -1 : 1;
  const IntegerCorners start = {from, from, from}, end = {to, to, to};
  const detail::TriangleCorners still = {};
  return {{still, still}, {scaled(start, 0), scaled(end, 0)}};
}

/// Any finite bit pattern up to 2^60.
inline float float_within_limit(Random& random) {
  while (true) {
    const float value = random() % 2 ? any_finite_float(random) : one_of_few_floats(random);
    if (std::fabs(value) <= 0x1p60f) return value;
  }
}

inline MovingPair of_all_magnitudes(Random& random) {
  const auto corners = [&] { return corners_of(random, float_within_limit); };
  MovingPair pair = {{corners(), corners()}, {corners(), corners()}};
  if (random() % 2) pair.b.to = pair.a.from;
  if (random() % 4 == 0) pair.a.to = pair.a.from;
  return pair;
}

struct MovingFamily {
  const char* name;
  MovingPair (*make)(Random&);
  double least_hits = 0.05,
         most_hits = 0.95;  ///< shares: of pairs that meet later, of all that meet
};

inline constexpr MovingFamily kMovingFamilies[] = {
    {"SmallGrid", moving_integers<on_small_grid>},
    {"MediumGrid", moving_integers<on_medium_grid>},
    {"LargeGrid", moving_integers<on_large_grid>},
    {"StillPlane", moving_integers<in_still_plane>, 0.05, 0.99},
    {"TurningPlane", moving_integers<in_turning_plane>},
    {"StillCorners", moving_integers<with_still_corners>},
    {"AlwaysCollapsed", moving_integers<always_collapsed>},
    {"OnLine", moving_integers<on_line>, 0.05, 0.99},
    {"Sliding", moving_integers<sliding>},
    {"Swapping", moving_integers<swapping>},
    {"NearlyMeeting", moving_integers<nearly_meeting>},
    {"OneUlpFromMeeting", one_ulp_from_meeting},
    {"LandingOnAnEdge", moving_integers<landing_on_an_edge>, 0.05, 1},
    {"Grazing", moving_integers<grazing>, 0.05, 1},
    {"PointsPassing", points_passing},
    {"AllMagnitudes", of_all_magnitudes},
};

inline std::string to_text(const MovingPair& pair) {
  return "a " + to_text(pair.a.from) + " to " + to_text(pair.a.to) + ", b " + to_text(pair.b.from) +
         " to " + to_text(pair.b.to);
}

}  // namespace pelt::test
