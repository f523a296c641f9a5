#pragma once

/// Intersecting pairs of triangles that share a surface vertex, each once. Precondition of both
/// functions: all nodes are open. They return whether they ended early, because the sink is full.

#include "motion/moving_tree.hpp"
#include "pose/posed_tree.hpp"
#include "self/flat_fans.hpp"
#include "self/self_filter.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// In a pose. `slack`: of the closed and open fans, or null. Fans with slack are skipped; the
/// others receive new slack.
bool test_fans(const PosedTree& posed, const Fans& fans, Positions positions, float* slack,
               FilteredSink<Contact>& sink, QueryStats& work);

/// Posed vertices at both ends, by place, four floats each.
struct MovingPositions {
  Positions from, to;
};

/// At some time of a step.
bool test_moving_fans(const MovingTree& moving, const Fans& fans, const MovingPositions& positions,
                      const MovingOptions& options, FilteredSink<MovingContact>& sink,
                      MovingStats& work);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
