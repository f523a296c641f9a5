#pragma once

/// The boxes of one level of the tree in a pose, and what queries have done with them: Kavan & Zara
/// 2005, figure 5. To be looked at; no query needs it.

#include "pose/pose.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

enum class BoxState : std::uint8_t {
  untouched,  ///< no query has asked for the box
  refitted,   ///< the box was computed with its siblings, and that was enough
  opened,     ///< what is inside has been asked for
};

struct LevelBoxes {
  std::vector<float> boxes;      ///< [N][6] low x y z, high x y z
  std::vector<BoxState> states;  ///< [N]
};

/// The root is level 0; the clusters of the deepest nodes are the last level.
std::uint32_t level_count(const Tree& tree);

/// How many nodes queries have opened since the palette was set.
std::uint32_t opened_node_count(const Pose& pose);

/// Gives `whole`, a pose of the same model, the palette of `pose`, and opens all its nodes.
void open_whole(const Pose& pose, Pose& whole);

/// Replaces what is in `out` by the boxes of `level`, as `whole` has them (see `open_whole`), in
/// the states that they have in `pose`. Where a branch ends above the level its end is there, so
/// that the boxes of each level enclose the whole surface. Opens nothing in `pose`.
void level_boxes(const Pose& pose, const Pose& whole, std::uint32_t level, LevelBoxes& out);

}  // namespace pelt::detail
