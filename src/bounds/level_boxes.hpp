#pragma once

/// Boxes of one level of the tree in a pose, with what queries have done with them (Kavan & Zara
/// 2005, figure 5). For visualisation only.

#include "pose/pose.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

enum class BoxState : std::uint8_t {
  untouched,  ///< no query has needed the box
  refitted,   ///< the box was computed with its siblings, and no query needed more
  opened,     ///< the node was opened
};

struct LevelBoxes {
  std::vector<float> boxes;      ///< [N][6] low x y z, high x y z
  std::vector<BoxState> states;  ///< [N]
};

/// The root is level 0; the clusters of the deepest nodes are the last level.
std::uint32_t level_count(const Tree& tree);

/// Returns the number of nodes that queries have opened since the palette was set.
std::uint32_t opened_node_count(const Pose& pose);

/// Copies the palette of `pose` to `whole`, a pose of the same model, and computes all bounds of
/// `whole`. Given vertices are borrowed from `pose`.
void copy_with_all_bounds(const Pose& pose, Pose& whole);

/// Replaces the content of `out` with the boxes of `level` in `whole` (see `copy_with_all_bounds`)
/// and their states in `pose`. A branch that ends above the level contributes its last box, so the
/// boxes of each level enclose the whole surface. Opens nothing in `pose`.
void level_boxes(const Pose& pose, const Pose& whole, std::uint32_t level, LevelBoxes& out);

}  // namespace pelt::detail
