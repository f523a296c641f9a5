#pragma once

#include <pelt/motion.hpp>

#include "motion/moving_tree.hpp"

namespace pelt::detail {

/// Aborts unless both poses of the motion are of one model.
void require_step(const Motion& motion);

/// Aborts unless both motions are of one model each and have no pose
/// in common.
void require_steps(const Motion& a, const Motion& b);

/// Views of two motions.
class Steps {
 public:
  Steps(const Motion& a, const Motion& b);

  MovingTree a() const { return {a_from_, a_to_}; }
  MovingTree b() const { return {b_from_, b_to_}; }

 private:
  PosedTree a_from_, a_to_, b_from_, b_to_;
};

}  // namespace pelt::detail
