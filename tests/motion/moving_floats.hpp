#pragma once

/// Pairs of moving triangles in general position, without the distributions of the standard
/// library, which differ between implementations.

#include "base/vec3.hpp"
#include "motion/moving_determinants.hpp"
#include "moving_cases.hpp"

#include <cmath>
#include <cstddef>

namespace pelt::test {

/// From -1 to 1, a multiple of 2^-23: the same with every standard library.
inline float signed_unit(Random& random) {
  return static_cast<float>(random() >> 40) * 0x1p-23f - 1;
}

inline Vec3 near(Random& random, const Vec3& center, float radius) {
  return {center.x + radius * signed_unit(random), center.y + radius * signed_unit(random),
          center.z + radius * signed_unit(random)};
}

inline Vec3 operator+(const Vec3& p, const Vec3& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }

/// A triangle of about `size` near `center` that moves by about `step` and turns a little.
inline MovingTriangle moving_near(Random& random, const Vec3& center, float size, float step) {
  MovingTriangle triangle;
  const Vec3 shift = near(random, {}, step);
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.from[i] = near(random, center, size);
    triangle.to[i] = near(random, triangle.from[i] + shift, step / 4);
  }
  return triangle;
}

/// Triangles of about a centimetre that move by about a centimetre, one beside the other.
inline MovingPair close_at(Random& random, float distance) {
  const Vec3 center = near(random, {distance, distance, distance}, distance / 2);
  return {moving_near(random, center, 0.007f, 0.01f),
          moving_near(random, near(random, center, 0.012f), 0.007f, 0.01f)};
}

inline MovingPair close_at_1(Random& random) { return close_at(random, 1); }
inline MovingPair close_at_1000(Random& random) { return close_at(random, 1000); }

/// Triangles that move by a tenth of their size.
inline MovingPair slow(Random& random) {
  const Vec3 center = near(random, {}, 1);
  return {moving_near(random, center, 0.01f, 0.001f),
          moving_near(random, near(random, center, 0.01f), 0.01f, 0.001f)};
}

/// One stands still.
inline MovingPair beside_a_still_one(Random& random) {
  MovingPair pair = close_at_1(random);
  pair.a.to = pair.a.from;
  return pair;
}

template <int kExponent>
inline MovingPair of_size(Random& random) {
  const float radius = std::ldexp(0.5f, kExponent);
  return {moving_near(random, {}, radius, radius), moving_near(random, {}, radius, radius)};
}

/// How often the height of corner 0 of b over a's plane changes its sign at multiples of a 32nd of
/// the step.
inline int sign_changes(const MovingPair& pair) {
  int changes = 0;
  for (int k = 0, last = 0; k <= 32; ++k) {
    const auto at = [&](const Vec3& from, const Vec3& to) {
      return detail::between(k / 32.0, detail::Vec3d(from), detail::Vec3d(to));
    };
    const auto& [a, b] = pair;
    const detail::Vec3d p = at(a.from[0], a.to[0]), q = at(a.from[1], a.to[1]);
    const detail::Vec3d r = at(a.from[2], a.to[2]), s = at(b.from[0], b.to[0]);
    const int sign = dot(cross(q - p, r - p), s - p) > 0 ? 1 : -1;
    changes += sign == -last;
    last = sign;
  }
  return changes;
}

/// A corner of b passes three times through the inside of a, whose plane turns, and the other
/// corners of b stay far above.
inline MovingPair passing_three_times(Random& random) {
  MovingPair pair;
  do {
    pair = {{{{{300, -4, 120}, {-155, 373, -146}, {-76, -198, -62}}},
             {{{305, -127, -120}, {-92, 144, 23}, {-296, -142, 44}}}},
            {{{{27, -27, -17}, {-104, -56, 1919}, {135, 170, 1964}}},
             {{{16, 4, -26}, {84, 92, 2016}, {80, 200, 2027}}}}};
    for (detail::TriangleCorners* t : {&pair.a.from, &pair.a.to, &pair.b.from, &pair.b.to})
      for (Vec3& corner : *t) corner = near(random, corner, 5);
  } while (sign_changes(pair) < 3);
  return pair;
}

}  // namespace pelt::test
