#pragma once

/// Checks of models from files, which may be hostile.

#include "base/problem.hpp"
#include "model/node_bounds.hpp"
#include "model/tree.hpp"

#include <span>

namespace pelt::detail {

/// Validates the structure of a tree that may come from a hostile file. Returns the first problem,
/// with array and index, or an empty Problem; queries are then safe. Uses no array before it is
/// validated. O(T + P).
Problem check_structure(const Tree& tree);

/// Like `check_structure`, and also checks that each vertex of the caller is at most once in a pool
/// and has the same bits in all pools. O(T + P log P).
Problem check_tree(const Tree& tree);

/// Validates the bounds of nodes, which may come from a hostile file. Returns the first problem,
/// with array and index, or an empty Problem. Evaluating valid bounds then stays inside the arrays,
/// takes time in proportion to their size, and gives finite boxes on every palette. Does not check
/// that bounds enclose anything. Precondition: `check_structure` finds no problem. O(size of the
/// arrays).
Problem check_node_bounds(const NodeBounds& bounds, const Tree& tree);

/// Whether an affine bound is finite on every palette, if its shape lies within 4 R of the origin
/// on each axis. Here R is the mesh's rest extent, no less than kLeastRestExtent, E = kMaxExtent,
/// and q the sum over the joints of
///     |m_j| + R |g_j| + R_j + (|s_j| + S_j) / R,
/// with sums of absolute values for norms. A joint's linear part L and translation t have
/// |L_ab| R + |t_a| <= E, so it throws the shape's points, whose coordinates sum to 12 R at most,
/// no farther than 12 E. Hence, in the notation of node_bounds.hpp,
///     |t_j| <= 24 E,   |A_ab| <= (E / R) (1 + 26 q),   |B c~| <= 12 E (1 + 2 q),
///     sum |D_j| (|s_j| + S_j) <= 2 E q,   sum R_j |t_j| <= 24 E q,
/// and A times each vector of the shape, four of which count together, is at most 12 E (1 + 26 q).
/// Sums of all that are less than 2^11 E (1 + q), and elements of A less than 2^5 E (1 + q) / R. So
///     1 + q <= min(2^54, 2^60 R)
/// leaves both below 2^127, half of the largest float. Fits of real meshes have a q of some
/// thousand at most. Morph targets change none of that: they displace c by no more than 4 times
/// what E has room for, as the shape's other points, and |A_j| h is at most 12 E.
bool stays_finite(std::span<const JointFit> fits, float margin, float rest_extent);

/// Validates the displacements of a tree's pools, which may come from a hostile file. Returns the
/// first problem, or an empty Problem. Precondition: the nodes are valid. O(N + D).
Problem check_pool_morphs(const Tree& tree);

}  // namespace pelt::detail
