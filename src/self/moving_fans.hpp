#pragma once

#include <pelt/motion.hpp>

#include "motion/moving_tree.hpp"
#include "self/fans.hpp"
#include "self/self_answer.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Posed vertices at both ends, by place, four floats each.
struct MovingPositions {
  const std::array<float, 4>*from, *to;
};

/// Finds the pairs of triangles that share a surface vertex and intersect at some time of a step,
/// each once. Returns whether it ended early, because the answer is full. Precondition: all nodes
/// are open in both poses.
bool test_moving_fans(const MovingTree& moving, const Fans& fans, const MovingPositions& positions,
                      const MovingOptions& options, SelfAnswerOf<MovingContact>& answer,
                      MovingStats& work);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
