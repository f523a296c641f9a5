#pragma once

/// An ablation of the query between frames: each node, cluster and triangle has one box for the
/// whole step, which encloses its boxes at both ends. Compiled once for each instruction set, like
/// the library.

#include "motion/moving_tree.hpp"
#include "query/scratch.hpp"

#include <pelt/motion.hpp>

namespace pelt::rivals {

/// As detail::collide_moving_trees.
using CollideUnited = MovingStats(const detail::MovingTree& a, const detail::MovingTree& b,
                                  detail::Scratch& scratch, const MovingOptions& options);

/// The function for the active instruction set.
CollideUnited* active_collide_united();

}  // namespace pelt::rivals
