#pragma once

/// Rest-pose data of the bounds of nodes with linear blend skinning, and, further below, what dual
/// quaternion skinning adds. There are two kinds of bounds. The build stores for each node the kind
/// that is smaller on sample poses; node_box.hpp evaluates them on a palette.
///
/// Symbols (a ~ appends a fourth component: 1 to points, 0 to differences):
///
///     v, v'            rest position and posed position of a vertex of the node
///     w_j, C_j         weight and matrix of joint j; v' = sum_j w_j C_j v~
///     c +- h           box of the node's rest positions: centre and half extents; x = v - c
///     m_j + g_j.x      affine approximation of w_j; its error is within +- R_j
///     D_j, t_j         C_j - C_ref, for a reference joint ref; D_j c~
///     s_j +- S_j       interval of (w_j - m_j) x on each axis
///     mu_k, d_k        weight of morph target k, and its displacement of v
///     d +- q           box of sum_k mu_k d_k
///     u, M, K, n, p    2^-24; extent of the palette; influences of a vertex; joints of the node;
///                      active targets that displace a vertex of the node
///     eps              largest error of a vertex's sum of weights: the sum is 1 +- eps
///
/// Joint boxes, used near the root, where many joints move a node. v' is a convex combination of
/// the C_j v~ with w_j > 0. Hence v' lies in the box around the images of the rest boxes of the
/// joints, where the rest box of a joint encloses the vertices that the joint moves (Kavan & Zara
/// 2005, eq. 2, with boxes and one body for each joint).
///
/// Affine bounds, used below. Approximate each weight by an affine function of the rest position,
///     w_j = m_j + g_j.x + r_j,       |r_j| <= R_j,
/// and let B = C_ref + sum m_j D_j, here and below summing over all joints but the reference. If
/// the weights sum to one, v' = C_ref v~ + sum w_j D_j v~, so exactly
///     v' = B c~ + A x + sum D_j (w_j - m_j) x + sum r_j t_j,    A = B + sum t_j g_j^T,
/// where D_j and A act on x by their linear parts. Hence v' lies in the box with
///     centre        B c~ + sum D_j s_j
///     half extents  |A x| + sum |D_j| S_j + sum R_j |t_j|
/// |A x| is bounded twice, by the rest box and by a box along the principal axes of the rest
/// vertices; the smaller value is used on each axis. This is the paper's bound carried to first
/// order: the bound follows the slope of the weights instead of enclosing it, and a node whose
/// weights are affine has no excess at all.
///
/// Any joint may be the reference. For an arbitrary matrix X in place of C_ref, the sum over all
/// joints of R_j |C_j c~ - X c~| is least if X c~ is the median of the C_j c~, weighted by the R_j.
/// The joint with the largest R_j is near this median and is chosen.
///
/// Morph targets displace v by sum_k mu_k d_k. The box d +- q of this sum has the sums of mu_k and
/// |mu_k| times the centres and half extents of each target's displacements in the node, where a
/// vertex that a target does not displace counts as displaced by zero. So
///     v' = sum_j w_j C_j (v + d)~ + sum_j w_j A_j z,     |z| <= q,
/// where A_j is the linear part of C_j. The rest box of a joint moves by d and grows by q, computed
/// for the vertices that follow this joint. The weights of an affine bound are functions of the
/// rest position; the bound holds for the first sum with c + d in place of c. The second sum is a
/// convex combination, so the half extents grow by max_j |A_j| q. Targets with weight zero and
/// targets that displace nothing in the node are skipped.
///
/// Rounding. sum_b |A_ab| |v_b| + |t_a| <= M holds for every joint matrix (A | t) and every v whose
/// coordinates sum to at most the mesh's rest extent. Errors are counted to first order; adding a
/// 64th of the sum covers the higher orders. A float32 posed vertex of K influences differs from
/// the real one by at most (K + 5) u M.
///
/// Joint boxes: weights that sum to 1 +- eps move a vertex by at most eps M. A centre and a half
/// extent, together at most M, go through three roundings each; corners and margins add two. In
/// units of M the margin is
///     (K + 12) u + eps.
/// Example: K = 4, eps = 0 and M = 2 (a person of 2 m near the origin) give a margin of
/// 16 x 2^-24 x 2 = 1.9e-6, or 2 micrometres.
///
/// Affine bounds: let W be the sum of |m_j| over all joints but the reference. |t_j| and |D_j x|
/// are at most 2 M, and the image of a point under |C_ref| + sum |m_j| |D_j| is at most (1 + 2 W)
/// M. Weights that sum to 1 +- eps leave eps M. D_j takes one rounding, t_j four, an element of B
/// at most n + 1. Products with rest coordinates and all sums increase this to at most n + 6 in the
/// centre and n + 10 in B x. The latter counts L times, because the box along the principal axes
/// reaches out of the rest box, to y_b on axis b: L = max(1, sum y_b / rest extent). The terms of
/// t_j and D_j take at most n + 14. Corners and margins add four. In units of M the margin is
///     (K + 5) u + eps
///       + (2 n + 20) u (L (1 + 2 W) + 2 sum (|g_j|.y + R_j + max |w_j - m_j|)).
/// The rounding of the fit itself, in double, is far below this.
///
/// Morph targets: M includes the displacements, so that |v| + sum |mu_k d_k| replaces |v| above. A
/// displaced vertex has p + 1 additional roundings, and so have d and q, which with c + d and the
/// like make p + 2. |A_j| q has three, and adding it to margin and corner two. In units of M the
/// margin grows by
///     (2 p + 8) u.
///
/// Offsets. Let a posed vertex without offset be in [low, high] on an axis, with both ends floats,
/// and let c be the largest offset cap of the vertices below the node. Its offset is clamped to
/// [-c, c], and rounding to nearest is monotone, so the float sum of vertex and offset lies in
/// [fl(low - c), fl(high + c)]. The widened box needs no further margin.
///
/// Nothing overflows: M is at most kMaxExtent, joint boxes reach a few M, and an affine bound that
/// could reach too far is rejected (stays_finite in check_tree.hpp). M is at least 2^-100
/// times the rest extent, so products of matrices that underflow (by 2^-150 each) are negligible
/// beside u M. Underflow of translations and in the last steps is negligible beside 2^-120, which
/// every margin includes.

#include "model/tree.hpp"
#include "skin/palette.hpp"
#include "skin/skinned_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// Box of the rest positions of a node's vertices that follow one joint.
struct JointBox {
  float centre[4] = {0, 0, 0, 1};  ///< fourth component one, so that a matrix translates it
  float half[4] = {};              ///< fourth component zero
};

/// The rest shape of an affine bound. Fourth components are zero, except that of the centre.
struct RestShape {
  float centre[4] = {0, 0, 0, 1};  ///< c~
  float half[4] = {};              ///< h
  float axes_centre[4] = {};       ///< centre of the box along the principal axes, relative to c
  float axes[3][4] = {};           ///< half extents of that box, as vectors
};

/// One joint of an affine bound, other than the reference.
struct JointFit {
  float line[4];    ///< g_j, m_j
  float shift[4];   ///< s_j, 0
  float spread[4];  ///< S_j, R_j

  float mean() const { return line[3]; }
  float residual() const { return spread[3]; }
};

/// Box of the displacements by one morph target of the vertices of a rest body. A rest body is a
/// joint box or a shape.
struct DisplacementBox {
  float centre[4] = {}, half[4] = {};  ///< fourth components zero
  std::uint32_t target = 0;
};

enum class BoundKind : std::uint8_t { joint_boxes, affine };

struct NodeBound {
  BoundKind kind = BoundKind::joint_boxes;
  std::uint8_t unused = 0;  ///< padding, so that every byte of a file is defined
  std::uint16_t joint_count = 0;
  std::uint32_t first_joint = 0;   ///< into joints; if affine, the first joint is the reference
  std::uint32_t first_record = 0;  ///< into joint_boxes, or into fits
  std::uint32_t shape = 0;         ///< into shapes, if affine
  float margin = 0;                ///< in units of the palette's extent

  bool is_affine() const { return kind == BoundKind::affine; }

  /// Number of joint boxes or of fits.
  std::uint32_t record_count() const { return is_affine() ? joint_count - 1u : joint_count; }
};

// With dual quaternion skinning, a node's box is that of linear blend skinning, moved by how far
// the two kinds of skinning differ.
//
// Symbols, besides those above:
//
//     q_j, T_j         unit quaternion of joint j, negated where the definition of a posed vertex
//                      (dual_skin.hpp) negates it; the rigid motion of joint j
//     p_j              T_j v, the image of the vertex under one joint
//     b, n             sum_j w_j q_j; |b|^2
//     D_jk, u_jk       scalar part (= q_j.q_k) and vector part of q_j q_k*, |u_jk|^2 = 1 - D_jk^2
//     s_jk             |q_j - q_k|, s_jk^2 = 2 (1 - D_jk)
//     E_j              sum_k w_k D_jk = b.q_j
//
// Theorem. If the weights sum to one, then
//     v' = sum_j w_j p_j + (1 / n) sum_{j < k} w_j w_k ((E_j - E_k) (p_j - p_k)
//                                                       + (p_j - p_k) x u_jk).
// The first sum is the vertex of linear blend skinning.
// Proof. Let e_j be the dual part, so T_j v = q_j v q_j* + 2 vec(e_j q_j*) and p_j q_j = q_j v +
// 2 e_j. With the sums b and e, n v' = vec(b v b* + 2 e b*) = vec(sum_j w_j p_j q_j b*) =
// sum_jk w_j w_k vec(p_j (D_jk + u_jk)) = sum_jk w_j w_k (D_jk p_j + p_j x u_jk). Because u_kj =
// -u_jk, the second terms of jk and kj make (p_j - p_k) x u_jk. The first terms sum to
// sum_j w_j E_j p_j, and n = sum_k w_k E_k, so sum_j w_j (E_j - n) p_j = sum_jk w_j w_k (E_j -
// E_k) p_j, of which jk and kj make (E_j - E_k) (p_j - p_k). QED
//
// The swell. E_j - E_k = (w_j - w_k) (1 - D_jk) + sum_l w_l (D_lj - D_lk), over the other joints l
// of the vertex. D_lj - D_lk is the product of q_l - (q_j + q_k) / 2, no longer than the largest s
// of two joints of the vertex, and q_j - q_k. With s_max, the largest s of the node,
//     |E_j - E_k| <= s_jk s_max (|w_j - w_k| / 2 + sum_l w_l).
//
// The bound. A pair of joints that share a vertex stores the box of the rest positions of the
// vertices that follow both, and over these vertices the least and the most w_j w_k, and the most
// w_j w_k (|w_j - w_k| / 2 + sum_l w_l), its skew. The images of the box under T_j - T_k enclose
// p_j - p_k. The sum over pairs is bounded twice: by the sum over all pairs of the node, and by
// the hull of zero and all pairs times the largest sum of products of a vertex. The smaller one is
// used on each side. The sum is divided by n, which is at most one.
//
// Links. What a pair needs of the palette is the same in all nodes and is computed once for the
// joints of a link (JointLink), as are bounds of |(p_j - p_k) x u_jk| and s_jk |p_j - p_k| over
// all rest positions of the mesh that follow both. Most nodes are far from a bent joint: the sum
// of these bounds times the most w_j w_k is small beside their boxes and is used instead.
//
// Signs. Most palettes negate no q (Palette::negates_none), and no D_jk of a link is negative.
// Otherwise let joint 1 be the pivot of a vertex. D_1k is not negative by definition. D_jk of
// other pairs can be negative, but is not if all |D| of the node are at least 1/2: q_1 is within
// 60 degrees of q_j and q_k, so these are within 120 degrees, and if D_jk were negative, it would
// be less than -1/2. Otherwise these pairs count with s^2 = 2 (1 + |D|), and with u of either
// sign.
//
// n is bounded from below by 1 - sum_{j < k} w_j w_k s_jk^2, which equals it, and by the square of
// b.q_1 = w_1 + sum_k w_k D_1k >= 1 / K + (1 - 1 / K) min D_1k. As 1 - D = s^2 / 2, min D_1k is
// taken from the largest s^2 where all signs are known.
//
// Rounding, with u and M as above, and R = 1 / sqrt(n). The blended b and e have
// errors of K u and K u max |e_j|. These turn the rotation by 2 K u R, and move the translation by
// K u R (R + 1) max |t_j|, together at most 2 K R u M, because R max |t_j| + sum |v_b| <= M. The
// steps of the definition: with |r|, |a| <= |b|, the vector c has an error of 7.4 u |b| |v|, r x c
// 10.9 u n |v|, and the other part 10.4 u |b| |e|. With five roundings of n, the quotient, the
// product and sums, v' has 34 u |v| + 17 u R max |t_j| + u M, at most 35 u M. Rounded matrices of
// the T_j, rotations that are not quite units, and dual parts that are not quite orthogonal to
// them change v' by at most 12 u M. Sums of weights that are not one change weights by 2^-22, and
// v' by 2^-21 M = 8 u M. Rotations increase no error of a displaced rest position. In units of M,
// the margin is
//     (2.1 K R + 60) u.
// The difference of two images has an error of 14 u M in each coordinate, and the product with u
// (5 u) one of 40 u M; 64 u M is added to them. Relative errors of products, and those of sums,
// are below 2^-16 for up to 200 pairs; more pairs use the hull only. The s^2 have errors of 16 u,
// which are added. No coordinate exceeds M, except by rounding, and this limits the box as well.

/// Two joints that share a vertex of a node.
struct JointPair {
  float centre[4] = {0, 0, 0, 1}, half[4] = {};  ///< box of the vertices that follow both
  float least = 0, most = 0;                     ///< of the products of their weights
  float skew = 0;
  float pivot = 0;  ///< 1 if one of them is the pivot of each vertex that has both, otherwise 0
  std::uint32_t link = 0;   ///< into the tree's links
  std::uint32_t first = 0;  ///< number of the link's first joint among those of the node's bound
};

/// The addition to a node's bound with dual quaternion skinning.
struct DualBound {
  std::uint32_t first_pair = 0;  ///< into joint_pairs
  std::uint32_t pair_count = 0;
  float product_sum = 0;  ///< largest sum of products of a vertex
  float skew_sum = 0;     ///< largest sum of skews of a vertex
};

struct NodeBounds {
  std::vector<NodeBound> nodes;  // [N], one for each node of the tree
  std::vector<std::uint16_t> joints;
  std::vector<JointBox> joint_boxes;
  std::vector<RestShape> shapes;
  std::vector<JointFit> fits;

  // Displacement boxes by rest body: joint boxes first, then shapes. Targets of a body ascend.
  std::vector<std::uint32_t> displacement_begin;  // [bodies + 1]; empty if there are no targets
  std::vector<DisplacementBox> displacements;

  // Empty without dual quaternion skinning.
  std::vector<DualBound> dual_bounds;  // [N]
  std::vector<JointPair> joint_pairs;

  std::vector<float> offset_caps;  // [N] largest below; empty if there are none; not in files
};

/// Computes NodeBounds::offset_caps for all nodes of the tree. O(P).
void find_offset_caps(const Tree& tree, NodeBounds& bounds);

/// Generates palettes for choosing bounds if the caller gives none: each joint rotates about the
/// middle of the vertices that it moves, by up to 45 degrees. Real skeletons move differently, but
/// bounds that are tight here are tight there, too. The palettes are the same on every machine.
std::vector<Palette> invent_sample_poses(const SkinnedMesh& mesh);

/// Fits both kinds of bounds to every node and stores the kind that is smaller on the sample poses.
/// The bounds hold in any pose. O(P log P) for P vertices in pools.
NodeBounds fit_node_bounds(const Tree& tree, std::span<const Palette> samples);

/// The same for arbitrary sets of vertices, given by their positions in the pools, with one node
/// per set. The bound of an empty set is the empty box.
NodeBounds fit_set_bounds(const Tree& tree, std::span<const std::vector<std::uint32_t>> sets,
                          std::span<const Palette> samples);

}  // namespace pelt::detail
