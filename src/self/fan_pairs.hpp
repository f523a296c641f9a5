#pragma once

#include "base/instruction_set.hpp"
#include "pose/posed_tree.hpp"
#include "self/flat_fans.hpp"
#include "self/self_answer.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Finds the intersecting pairs of triangles that share a surface vertex, each once. Returns
/// whether it ended early, because the answer is full. Precondition: all nodes are open.
///
/// `slack`: of the closed and open fans, or null. Fans with slack are skipped; the others receive
/// new slack.
bool test_fans(const PosedTree& posed, const Fans& fans, Positions positions, float* slack,
               SelfAnswer& answer, QueryStats& work);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
