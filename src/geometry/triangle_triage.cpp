/// Tests eight pairs of triangles at once in float32. Decides a pair only if rounding cannot have
/// changed a sign.
///
/// Ten determinants. With the origin in vertex a0, a pair is given by five vectors: u = a1 - a0, v
/// = a0 - a2 and w_j = b_j - a0. All signs of the exact test (triangle_pair.cpp) are signs of sums
/// of the ten determinants of three of these vectors. With m_j = w_j x w_{j+1}, indices modulo 3,
///   b_j over a's plane:  h_j = (v x u) . w_j,
///   a0 over b's plane:   o = -w_0 . m_1,
///   a1 and a2:           o + sum_j u . m_j  and  o - sum_j v . m_j,  as b's normal is sum_j m_j,
///   orient3d of an edge of a and edge j of b, b_j to b_{j+1}:  u . m_j for a0 to a1, v . m_j for
///   a2 to a0, and h_{j+1} - h_j minus these two for a1 to a2, because the three edges of a sum to
///   h_{j+1} - h_j.
///
/// Intervals. Assume that no vertex is on the other's plane, and that neither triangle is wholly in
/// front of the other's plane or behind it. Then each triangle has one edge that goes down through
/// the other's plane, from its front to its back, and one that goes up. Seen against n1 with n2
/// pointing up, D = n1 x n2 points left, and a counter-clockwise triangle goes down on its left.
/// Along D, the first triangle's interval on the planes' common line therefore ends at its down
/// edge and, by n2 x n1 = -D, the second's begins at its down edge. orient3d of two down edges, or
/// of two up edges, is positive if the second's crossing comes after the first's (proof in
/// triangle_pair.cpp). The triangles therefore intersect if orient3d is negative for the down edges
/// and positive for the up edges, and they are disjoint if either sign is certainly the opposite.
///
/// Rounding. Let e = 2^-24, and X, Y, Z the largest computed |x|, |y|, |z| of the five vectors.
/// Each determinant is a sum of six products, each at most V = XYZ. A product has at most 8
/// relative errors e: three differences, two multiplications, three sums. The error of the
/// determinant is therefore at most 6 * 8.1 e V < 49 e V. For four determinants, none above 6.1 V,
/// the three partial sums are below 13 V, 19 V and 25 V, which gives at most 4 * 49 e V + 57 e V =
/// 253 e V; 256 e V = 2^-16 V covers this and the rounding of V itself.
///   Underflow: sums do not underflow. A product has an additional error of at most 2^-150, which
/// is multiplied by at most one difference, and differences are below 2^61.1. Six of the nine
/// products of a determinant are multiplied: less than 7 * 2^-89, and less than 2^-84 for four
/// determinants.
///   Overflow: cross products are below 2^124. If 64 V is finite, no other value exceeds 25 V.
/// Otherwise the bound is infinite or NaN, no comparison with it holds, and the lane remains
/// undecided.
#include "geometry/triangle_triage.hpp"

#include "geometry/points8.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

Float8 largest(const Float8& u, const Float8& v, const Float8& w0, const Float8& w1,
               const Float8& w2) {
  return max(max(max(abs(u), abs(v)), max(abs(w0), abs(w1))), abs(w2));
}

/// A bound of the error of a determinant, and of a sum of up to four.
Float8 error_bound(const Points8& u, const Points8& v, const Points8 (&w)[3]) {
  const Float8 x = largest(u.x, v.x, w[0].x, w[1].x, w[2].x);
  const Float8 y = largest(u.y, v.y, w[0].y, w[1].y, w[2].y);
  const Float8 z = largest(u.z, v.z, w[0].z, w[1].z, w[2].z);
  return Float8(64.0f) * x * y * z * Float8(0x1p-22f) + Float8(0x1p-84f);
}

}  // namespace

Triage triage(const TrianglePairs8& pairs) {
  const Points8& origin = pairs.a[0];
  const Points8 u = pairs.a[1] - origin, v = origin - pairs.a[2];
  const Points8 w[3] = {pairs.b[0] - origin, pairs.b[1] - origin, pairs.b[2] - origin};
  const Certainty certainly(error_bound(u, v, w));

  const Points8 normal = cross(v, u);
  const Three heights_b = {dot(normal, w[0]), dot(normal, w[1]), dot(normal, w[2])};
  const Mask8 b_aside = certainly.all_one_sign(heights_b);
  if (b_aside.bits() == kAllLanes) return {kAllLanes, 0};

  const Points8 m[3] = {cross(w[0], w[1]), cross(w[1], w[2]), cross(w[2], w[0])};
  const Three along_u = {dot(u, m[0]), dot(u, m[1]), dot(u, m[2])};
  const Three along_v = {dot(v, m[0]), dot(v, m[1]), dot(v, m[2])};
  const Float8 o = Float8(0.0f) - dot(w[0], m[1]);
  const Three heights_a = {o, o + sum(along_u), o - sum(along_v)};
  const unsigned aside = (b_aside | certainly.all_one_sign(heights_a)).bits();
  const Mask8 all_known = certainly.all_some_sign(heights_a) & certainly.all_some_sign(heights_b);
  const unsigned crossing = all_known.bits() & ~aside;
  if (crossing == 0) return {aside, 0};

  const Three along_all = {heights_b[1] - heights_b[0], heights_b[2] - heights_b[1],
                           heights_b[0] - heights_b[2]};
  const auto order = [&](const Edge& edge_a, const Edge& edge_b) {
    const Float8 on_u = edge_b.of(along_u), on_v = edge_b.of(along_v);
    return edge_a.of({on_u, edge_b.of(along_all) - on_u - on_v, on_v});
  };
  const Float8 down = order(certainly.edge_down(heights_a), certainly.edge_down(heights_b));
  const Float8 up = order(certainly.edge_up(heights_a), certainly.edge_up(heights_b));
  const unsigned overlap = (certainly.negative(down) & certainly.positive(up)).bits();
  const unsigned disjoint = (certainly.positive(down) | certainly.negative(up)).bits();
  return {aside | (crossing & disjoint), crossing & overlap};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
