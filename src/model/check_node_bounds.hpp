#pragma once

#include "base/problem.hpp"
#include "model/node_bounds.hpp"

#include <span>

namespace pelt::detail {

/// The first rule that bounds break which the boxes of nodes rely on, naming the array and the
/// index; empty when there is none: evaluating the bounds then stays inside the arrays, takes time
/// in proportion to their size and gives finite boxes on every palette. The bounds may come from a
/// hostile file; whether they enclose anything is not asked. Precondition: `check_structure` finds
/// nothing wrong with `tree`. O(size of the arrays).
Problem check_node_bounds(const NodeBounds& bounds, const Tree& tree);

/// Whether an affine bound is finite on every palette, whose joints throw no point of the mesh
/// beyond 2^60. Write R for the rest extent, no less than 2^-60 (palette.hpp), and q for the sum
/// over the joints of
///     |m_j| + R |g_j| + R_j + (|s_j| + S_j) / R,
/// with sums of absolute values for norms. Elements of a joint matrix are at most 2^60 / R, and the
/// shape lies within 4 R of the origin. Then |t_j| < 2^64 (1 + q), elements of A are less than
/// 2^65 (1 + q)^2 / R, and every sum of the bound less than 2^70 (1 + q)^2 but for A itself. So
///     (1 + q)^2 <= 2^56 min(1, R)
/// leaves them all below the largest float, which is almost 2^128. Fits of real meshes have a q of
/// some thousand at most.
bool stays_finite(std::span<const JointFit> fits, float margin, float rest_extent);

}  // namespace pelt::detail
