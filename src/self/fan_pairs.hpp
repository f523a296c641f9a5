#pragma once

#include "base/instruction_set.hpp"
#include "pose/posed_tree.hpp"
#include "self/flat_fans.hpp"
#include "self/self_answer.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Finds the intersecting pairs of triangles that share a surface vertex, each once. Returns
/// whether it ended early, because the answer is full. Precondition: all nodes are open.
bool test_fans(const PosedTree& posed, const Fans& fans, Positions positions, SelfAnswer& answer,
               QueryStats& work);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
