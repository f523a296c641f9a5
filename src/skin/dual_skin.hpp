#pragma once

/// Definition of a posed vertex of a model with dual quaternion skinning (Kavan, Collins, Zara &
/// O'Sullivan 2007), in the place of eq. 1 of skin.hpp. Evaluated in float32 without fused
/// operations:
///
///     s_k = -1 if dot(q_1, q_k) < 0, otherwise 1
///           dot(q, q') = (x x' + z z') + (y y' + w w')
///     b   = 0 + s_1 w_1 Q_1 + s_2 w_2 Q_2 ...    entry by entry, summed from the left
///     n   = dot(r a, r a)                        where r a is the real part of b, and e i the dual
///     c   = r x v + a v
///     v'  = v + (2 / n) (r x c + ((a e - i r) + r x e))
///
/// Cross products are y z' - z y' and so on. Influence 1 has the largest weight of the vertex; of
/// equal weights, the lowest joint. The others follow in ascending order of their joints. Sums
/// begin with zero, so that an influence without weight changes no bit.
///
/// Q_k is the dual quaternion of the palette (Palette::set_dual_quaternions), which may be the
/// negative of what the caller passed. This changes no bit, except of vertices with a dot product
/// of exactly zero.
///
/// n is never near zero. All s_k q_k point to the side of q_1, so |b| >= w_1 >= 1 / K for K
/// influences, up to rounding.

#include <pelt/math.hpp>

#include "base/float8.hpp"
#include "base/problem.hpp"
#include "skin/skinned_mesh.hpp"

#include <cstddef>
#include <cstdint>

namespace pelt::detail {

/// A rigid motion as a unit dual quaternion: the rotation q, and q multiplied from the left by half
/// the translation as a quaternion without a real part. Elements are x, y, z, w.
struct alignas(32) DualQuaternion {
  float real[4] = {0, 0, 0, 1};
  float dual[4] = {0, 0, 0, 0};
};

/// Elements of A^T A - I up to this size are rounding by an exporter: A is normalised. The same
/// limit holds for the squared length of a quaternion.
inline constexpr double kRigidTolerance = 0x1p-10;

/// Describes why a finite affine matrix, of the joint with this number, is not rigid; empty if it
/// is.
Problem find_not_rigid(const float* matrix, std::size_t joint);

/// Describes why eight floats, of the joint with this number, are no unit dual quaternion; empty if
/// they are.
Problem find_not_unit(const float* dual, std::size_t joint);

}  // namespace pelt::detail

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// A dual quaternion of floats, or eight of them.
template <typename Number>
struct Dual {
  Number x, y, z, w;      // the real part
  Number ex, ey, ez, ew;  // the dual part
};

template <typename Number>
inline Number dot(const Dual<Number>& a, const Dual<Number>& b) {
  return (a.x * b.x + a.z * b.z) + (a.y * b.y + a.w * b.w);
}

template <typename Number>
inline void add(Dual<Number>& sum, const Number& weight, const Dual<Number>& dual) {
  sum.x = sum.x + weight * dual.x, sum.y = sum.y + weight * dual.y;
  sum.z = sum.z + weight * dual.z, sum.w = sum.w + weight * dual.w;
  sum.ex = sum.ex + weight * dual.ex, sum.ey = sum.ey + weight * dual.ey;
  sum.ez = sum.ez + weight * dual.ez, sum.ew = sum.ew + weight * dual.ew;
}

/// Moves the point x y z by the sum of an influence's dual quaternions.
template <typename Number>
inline void move_point(const Dual<Number>& b, Number& x, Number& y, Number& z) {
  const Number n = dot(b, b);
  const Number cx = (b.y * z - b.z * y) + b.w * x;
  const Number cy = (b.z * x - b.x * z) + b.w * y;
  const Number cz = (b.x * y - b.y * x) + b.w * z;
  const Number tx = (b.w * b.ex - b.ew * b.x) + (b.y * b.ez - b.z * b.ey);
  const Number ty = (b.w * b.ey - b.ew * b.y) + (b.z * b.ex - b.x * b.ez);
  const Number tz = (b.w * b.ez - b.ew * b.z) + (b.x * b.ey - b.y * b.ex);
  const Number scale = Number(2.0f) / n;
  x = x + scale * ((b.y * cz - b.z * cy) + tx);
  y = y + scale * ((b.z * cx - b.x * cz) + ty);
  z = z + scale * ((b.x * cy - b.y * cx) + tz);
}

inline Dual<float> dual_of(const DualQuaternion& q) {
  return {q.real[0], q.real[1], q.real[2], q.real[3], q.dual[0], q.dual[1], q.dual[2], q.dual[3]};
}

/// Returns the posed vertex for `influence(0)` to `influence(count - 1)` in the lanes x, y, z. Lane
/// 3 is meaningless.
template <typename InfluenceAt>
inline Float4 dual_posed_vertex4(const Vec3& rest, std::uint32_t count,
                                 const InfluenceAt& influence, const DualQuaternion* palette) {
  const Dual<float> pivot = dual_of(palette[influence(0).joint]);
  Dual<float> sum = {};
  for (std::uint32_t i = 0; i < count; ++i) {
    const Influence next = influence(i);
    const Dual<float> dual = dual_of(palette[next.joint]);
    add(sum, dot(pivot, dual) < 0 ? -next.weight : next.weight, dual);
  }
  float x = rest.x, y = rest.y, z = rest.z;
  move_point(sum, x, y, z);
  return {x, y, z, 0};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
