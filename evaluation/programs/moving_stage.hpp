#pragma once

/// The pairs of triangles that a query between frames tests, and the first stage of the test: eight
/// pairs at once in float. Compiled once for each instruction set, like the library.

#include "motion/moving_filter.hpp"
#include "motion/moving_tree.hpp"
#include "query/scratch.hpp"

#include <array>
#include <span>

namespace pelt::programs {

/// The corners of a triangle at one end of a step, padded as in a pool.
using PaddedCorners = std::array<std::array<float, 4>, 3>;

struct MovingCandidate {
  PaddedCorners a_from, a_to, b_from, b_to;
};

/// The functions for one instruction set.
struct MovingStage {
  /// Appends the pairs that `collide` of motions tests in the step of two trees.
  void (*collect)(const detail::MovingTree& a, const detail::MovingTree& b,
                  detail::Scratch& scratch, detail::Stack<MovingCandidate>& candidates);

  /// Writes the answer of the stage in float for each pair. Without `finds_meetings`, as for a
  /// query of times, it only finds pairs that are apart.
  void (*decide)(std::span<const MovingCandidate> candidates, bool finds_meetings,
                 detail::CertainAnswer* answers);
};

/// The functions for the active instruction set.
MovingStage active_moving_stage();

namespace scalar {
extern const MovingStage kMovingStage;
}
namespace simd128 {
extern const MovingStage kMovingStage;
}
namespace avx2 {
extern const MovingStage kMovingStage;
}

}  // namespace pelt::programs
