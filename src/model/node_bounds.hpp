#pragma once

/// What a node's bound needs of the rest pose. Two kinds of bound are known, and each node has the
/// one that was smaller on sample poses; node_box.hpp computes the boxes.
///
/// Notation: a vertex v of the node is posed to v' = sum_j w_j C_j v~ with v~ = (v, 1). The rest
/// box of the node's vertices has the centre c and the half extents e, and x = v - c.
///
/// Joint boxes, near the root where there are many joints. v' is a convex combination of the C_j v~
/// with w_j > 0, so it lies in the box around the images of the joints' own rest boxes, those of
/// the vertices that they move (Kavan & Zara 2005, eq. 2, with boxes and a body for each joint).
///
/// Affine, below. Approximate each weight by an affine function of the place,
///     w_j = m_j + g_j.x + r_j,       |r_j| <= R_j,
/// measure the joints against one of them, the reference: D_j = C_j - C_ref, t_j = D_j c~, and let
/// B = C_ref + sum m_j D_j, here and below summing over the other joints. If the weights sum to
/// one, v' = C_ref v~ + sum w_j D_j v~, so exactly
///     v' = B c~ + A x + sum D_j (w_j - m_j) x + sum r_j t_j,    A = B + sum t_j g_j^T,
/// where D_j and A act on x by their linear parts. With (w_j - m_j) x within s_j +- S_j on each
/// axis
///     centre        B c~ + sum D_j s_j
///     half extents  |A x| + sum |D_j| S_j + sum R_j |t_j|
/// and |A x| is bounded twice, by the rest box and by a box along the axes of the rest vertices;
/// the intersection of both counts. This is the paper's bound carried to first order: the weights'
/// slope is followed instead of enclosed, and a node whose weights are affine has no excess at all.
/// Any joint may be the reference. With C_ref moved to X, sum_all R_j |t_j - X c~| is least where X
/// is the median, weighted by the R_j; the joint with the largest R_j is near it.
///
/// Morph targets displace v by the sum of m_k d_k, which lies in a box with the centre d and the
/// half extents h, the sums of m_k and |m_k| times those of each target's displacements in the
/// node; a vertex that a target leaves alone counts with zero. So
///     v' = sum_j w_j C_j (v + d)~ + sum_j w_j A_j y,     |y| <= h.
/// A joint's rest box just moves by d and grows by h, of the vertices that follow that joint. An
/// affine bound, whose weights are functions of the place at rest, holds for the first sum with c +
/// d for c, and the second is a convex combination: half extents grow by max_j |A_j| h. Targets of
/// weight zero and those that displace nothing in the node are not looked at.
///
/// Rounding. With u = 2^-24 and M the palette's extent, sum_b |A_ab| |v_b| + |t_a| <= M for every
/// joint and every v whose coordinates sum to no more than the mesh's rest extent. Errors are
/// counted to first order; a 64th of the sum on top covers the rest. A float32 posed vertex of K
/// influences is within (K + 5) u M of the real one.
///
/// Joint boxes: weights that sum to 1 + e move a vertex by e M. A centre and a half extent,
/// together at most M, go through three roundings each, corners and margins add two. So the margin
/// is, in units of M,
///     (K + 12) u + e.
/// Affine: of n joints, let the others' |m_j| sum to W. |t_j| and |D_j x| are at most 2 M, and a
/// point under |C_ref| + sum |m_j| |D_j| at most (1 + 2 W) M. Weights that sum to 1 + e leave e M
/// over. D_j takes one rounding, t_j four, an element of B at most n + 1. Products with rest
/// coordinates and all sums make that at most n + 6 in the centre and n + 10 in B x, there L times,
/// because the box along the axes reaches out of the rest box, to y_b on axis b:
/// L = max(1, sum y_b / rest extent). The terms of t_j and D_j take at most n + 14. Corners and
/// margins add four. So the margin is
///     (K + 5) u + e + (2 n + 20) u (L (1 + 2 W) + 2 sum (|g_j|.y + R_j + max |w_j - m_j|)),
/// and the rounding of the fit itself, in double, is far below.
///
/// Morph targets, n of which are active and displace a vertex of the node: M counts what each
/// displaces, so that |v| + sum |m_k d_k| goes for |v| above. A displaced vertex has n + 1
/// roundings more, and so have d and h, which with c + d and the like make n + 2; |A_j| h has
/// three, and adding it to margin and corner two. So the margin is larger by
///     (2 n + 8) u.
///
/// Nothing overflows: M is at most kMaxExtent, joint boxes reach a few M, and an affine bound that
/// could reach too far is not used (stays_finite in check_node_bounds.hpp). M is at least 2^-100
/// times the rest extent, so that products of matrices which underflow (by 2^-150 each) are nothing
/// beside u M; those of translations or in the last steps are nothing beside 2^-120, which every
/// margin has on top.

#include "model/tree.hpp"
#include "skin/palette.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// Where one joint's own rest vertices lie in a node.
struct JointBox {
  float centre[4] = {0, 0, 0, 1};  ///< fourth component one: a matrix moves it
  float half[4] = {};              ///< fourth component zero
};

/// The rest shape of an affine bound. Fourth components are zero, but the centre's.
struct RestShape {
  float centre[4] = {0, 0, 0, 1};  ///< c~
  float half[4] = {};              ///< e
  float axes_centre[4] = {};       ///< of the box along the axes, relative to c
  float axes[3][4] = {};           ///< its half extents as vectors
};

/// One joint of an affine bound, but the reference.
struct JointFit {
  float line[4];    ///< g_j, m_j
  float shift[4];   ///< s_j, 0
  float spread[4];  ///< S_j, R_j

  float mean() const { return line[3]; }
  float rest() const { return spread[3]; }
};

/// Where the displacements by one target of a rest body's vertices lie, which are those of a joint
/// box or of a shape.
struct DisplacementBox {
  float centre[4] = {}, half[4] = {};  ///< fourth components zero
  std::uint32_t target = 0;
};

enum class BoundKind : std::uint8_t { joint_boxes, affine };

struct NodeBound {
  BoundKind kind = BoundKind::joint_boxes;
  std::uint8_t unused = 0;  ///< so that every byte of a file has a value
  std::uint16_t joint_count = 0;
  std::uint32_t first_joint = 0;   ///< into joints; the first is the reference, if affine
  std::uint32_t first_record = 0;  ///< into joint_boxes, or into fits
  std::uint32_t shape = 0;         ///< into shapes, if affine
  float margin = 0;                ///< in units of the palette's extent

  bool is_affine() const { return kind == BoundKind::affine; }

  /// Of joint boxes, or of fits.
  std::uint32_t record_count() const { return is_affine() ? joint_count - 1u : joint_count; }
};

struct NodeBounds {
  std::vector<NodeBound> nodes;  // [N], one for each node of the tree
  std::vector<std::uint16_t> joints;
  std::vector<JointBox> joint_boxes;
  std::vector<RestShape> shapes;
  std::vector<JointFit> fits;

  // By rest body, joint boxes first and then shapes; the targets of each body ascend.
  std::vector<std::uint32_t> displacement_begin;  // [bodies + 1]; empty if there are no targets
  std::vector<DisplacementBox> displacements;
};

/// Fits both kinds to every node and keeps the one that was smaller on the sample poses. Bounds
/// hold in any pose. O(P log P) for P vertices in pools.
NodeBounds fit_node_bounds(const Tree& tree, std::span<const Palette> samples);

/// The same for any sets of vertices, named by their places in the pools, a node for each. The
/// bound of no vertices is the box around nothing.
NodeBounds fit_set_bounds(const Tree& tree, std::span<const std::vector<std::uint32_t>> sets,
                          std::span<const Palette> samples);

}  // namespace pelt::detail
