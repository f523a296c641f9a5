#pragma once

/// Code of rivals, ablations and experiments that is compiled once for each instruction set, like
/// the library: the test of triangles, stages of queries on Pelt's tree that the library does not
/// offer alone, and the query between frames with one box for a whole step.

#include <pelt/collide.hpp>
#include <pelt/math.hpp>
#include <pelt/mesh.hpp>
#include <pelt/motion.hpp>

#include "motion/moving_tree.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "self/pair_masks.hpp"

namespace pelt::rivals {

/// A posed body as plain pointers, for code that is compiled for each instruction set.
struct PosedMesh {
  const Triangle* triangles = nullptr;
  const Vec3* positions = nullptr;
};

inline constexpr std::uint32_t kPairsAtOnce = 8;

/// The test of triangles of all methods is the library's own: the certified float test
/// (geometry/triangle_triage.hpp) for eight pairs at a time, and the exact predicate for undecided
/// pairs. The comparison therefore shows how the pairs are found.
///
/// Returns one bit for each of the first `count` pairs (1 to kPairsAtOnce): whether they intersect.
/// Reads all eight.
using Touching = unsigned(const PosedMesh& a, const PosedMesh& b, const Contact* pairs,
                          std::uint32_t count);

/// Descends a tree against itself and returns the number of pairs of clusters whose boxes overlap
/// and that are no neighbours. Precondition: all nodes are open.
using DescendSelf = std::uint64_t(const detail::PosedTree& posed, const detail::PairMasks& masks);

/// Computes the boxes of all triangles on the grid of self-collision. Preconditions: all nodes are
/// open, and the root box is known.
using BoxAllTriangles = void(const detail::PosedTree& posed, const detail::PairMasks& masks,
                             detail::Scratch& scratch);

/// An ablation of detail::collide_moving_trees: each node, cluster and triangle has one box for the
/// whole step, which encloses its boxes at both ends.
using CollideUnited = MovingStats(const detail::MovingTree& a, const detail::MovingTree& b,
                                  detail::Scratch& scratch, const MovingOptions& options);

/// The functions for the active instruction set.
Touching* active_touching();
DescendSelf* active_descend_self();
BoxAllTriangles* active_box_all_triangles();
CollideUnited* active_collide_united();

}  // namespace pelt::rivals
