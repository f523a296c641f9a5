#pragma once

/// Rest-pose data of the bounds of models with dual quaternion skinning. A node's box is that of
/// linear blend skinning (node_bounds.hpp), moved by how far the two kinds of skinning differ.
///
/// Symbols, besides those of node_bounds.hpp:
///
///     q_j, T_j         unit quaternion of joint j, negated where the definition of a posed vertex
///                      (dual_skin.hpp) negates it; the rigid motion of joint j
///     p_j              T_j v, the image of the vertex under one joint
///     b, n             sum_j w_j q_j; |b|^2
///     D_jk, u_jk       scalar part (= q_j.q_k) and vector part of q_j q_k*, |u_jk|^2 = 1 - D_jk^2
///     s_jk             |q_j - q_k|, s_jk^2 = 2 (1 - D_jk)
///     E_j              sum_k w_k D_jk = b.q_j
///
/// Theorem. If the weights sum to one, then
///     v' = sum_j w_j p_j + (1 / n) sum_{j < k} w_j w_k ((E_j - E_k) (p_j - p_k)
///                                                       + (p_j - p_k) x u_jk).
/// The first sum is the vertex of linear blend skinning.
/// Proof. Let e_j be the dual part, so T_j v = q_j v q_j* + 2 vec(e_j q_j*) and p_j q_j = q_j v +
/// 2 e_j. With the sums b and e, n v' = vec(b v b* + 2 e b*) = vec(sum_j w_j p_j q_j b*) =
/// sum_jk w_j w_k vec(p_j (D_jk + u_jk)) = sum_jk w_j w_k (D_jk p_j + p_j x u_jk). Because u_kj =
/// -u_jk, the second terms of jk and kj make (p_j - p_k) x u_jk. The first terms sum to
/// sum_j w_j E_j p_j, and n = sum_k w_k E_k, so sum_j w_j (E_j - n) p_j = sum_jk w_j w_k (E_j -
/// E_k) p_j, of which jk and kj make (E_j - E_k) (p_j - p_k). QED
///
/// The swell. E_j - E_k = (w_j - w_k) (1 - D_jk) + sum_l w_l (D_lj - D_lk), over the other joints l
/// of the vertex. D_lj - D_lk is the product of q_l - (q_j + q_k) / 2, no longer than the largest s
/// of two joints of the vertex, and q_j - q_k. With s_max, the largest s of the node,
///     |E_j - E_k| <= s_jk s_max (|w_j - w_k| / 2 + sum_l w_l).
///
/// The bound. A pair of joints that share a vertex stores the box of the rest positions of the
/// vertices that follow both, and over these vertices the least and the most w_j w_k, and the most
/// w_j w_k (|w_j - w_k| / 2 + sum_l w_l), its skew. The images of the box under T_j - T_k enclose
/// p_j - p_k. The sum over pairs is bounded twice: by the sum over all pairs of the node, and by
/// the hull of zero and all pairs times the largest sum of products of a vertex. The smaller one is
/// used on each side. The sum is divided by n, which is at most one.
///
/// Links. What a pair needs of the palette is the same in all nodes and is computed once for the
/// joints of a link (JointLink), as are bounds of |(p_j - p_k) x u_jk| and s_jk |p_j - p_k| over
/// all rest positions of the mesh that follow both. Most nodes are far from a bent joint: the sum
/// of these bounds times the most w_j w_k is small beside their boxes and is used instead.
///
/// Signs. Most palettes negate no q (Palette::negates_none), and no D_jk of a link is negative.
/// Otherwise let joint 1 be the pivot of a vertex. D_1k is not negative by definition. D_jk of
/// other pairs can be negative, but is not if all |D| of the node are at least 1/2: q_1 is within
/// 60 degrees of q_j and q_k, so these are within 120 degrees, and if D_jk were negative, it would
/// be less than -1/2. Otherwise these pairs count with s^2 = 2 (1 + |D|), and with u of either
/// sign.
///
/// n is bounded from below by 1 - sum_{j < k} w_j w_k s_jk^2, which equals it, and by the square of
/// b.q_1 = w_1 + sum_k w_k D_1k >= 1 / K + (1 - 1 / K) min D_1k. As 1 - D = s^2 / 2, min D_1k is
/// taken from the largest s^2 where all signs are known.
///
/// Rounding, with u and M as in node_bounds.hpp, and R = 1 / sqrt(n). The blended b and e have
/// errors of K u and K u max |e_j|. These turn the rotation by 2 K u R, and move the translation by
/// K u R (R + 1) max |t_j|, together at most 2 K R u M, because R max |t_j| + sum |v_b| <= M. The
/// steps of the definition: with |r|, |a| <= |b|, the vector c has an error of 7.4 u |b| |v|, r x c
/// 10.9 u n |v|, and the other part 10.4 u |b| |e|. With five roundings of n, the quotient, the
/// product and sums, v' has 34 u |v| + 17 u R max |t_j| + u M, at most 35 u M. Rounded matrices of
/// the T_j, rotations that are not quite units, and dual parts that are not quite orthogonal to
/// them change v' by at most 12 u M. Sums of weights that are not one change weights by 2^-22, and
/// v' by 2^-21 M = 8 u M. Rotations increase no error of a displaced rest position. In units of M,
/// the margin is
///     (2.1 K R + 60) u.
/// The difference of two images has an error of 14 u M in each coordinate, and the product with u
/// (5 u) one of 40 u M; 64 u M is added to them. Relative errors of products, and those of sums,
/// are below 2^-16 for up to 200 pairs; more pairs use the hull only. The s^2 have errors of 16 u,
/// which are added. No coordinate exceeds M, except by rounding, and this limits the box as well.

#include <cstdint>

namespace pelt::detail {

/// Two joints that share a vertex of a node.
struct JointPair {
  float centre[4] = {0, 0, 0, 1}, half[4] = {};  ///< box of the vertices that follow both
  float least = 0, most = 0;                     ///< of the products of their weights
  float skew = 0;
  float pivot = 0;  ///< 1 if one of them is the pivot of each vertex that has both, otherwise 0
  std::uint32_t link = 0;   ///< into the tree's links
  std::uint32_t first = 0;  ///< number of the link's first joint among those of the node's bound
};

/// What a node's bound adds with dual quaternion skinning.
struct DualBound {
  std::uint32_t first_pair = 0;  ///< into joint_pairs
  std::uint32_t pair_count = 0;
  float product_sum = 0;  ///< largest sum of products of a vertex
  float skew_sum = 0;     ///< largest sum of skews of a vertex
};

}  // namespace pelt::detail
