#pragma once

#include "base/problem.hpp"
#include "model/node_bounds.hpp"
#include "model/tree.hpp"
#include "pose/posed_tree.hpp"

namespace pelt::detail {

/// Validates the number of offsets. Returns an empty Problem if they are valid.
Problem check_offsets(const Tree& tree, std::span<const Vec3> offsets);

/// What poses the vertices of an instance, and what queries have computed from it.
struct Instance {
  /// The rest pose.
  explicit Instance(const Tree& tree) : palette(rest_palette(tree)) {}

  /// View of the instance for the thread that owns `arena`. `tree` and `bounds` are those of the
  /// instance's model.
  PosedTree posed_tree(const Tree& tree, const NodeBounds& bounds, Arena& arena) {
    return {tree, bounds, palette, given, root_box, opened, arena};
  }

  Palette palette;
  GivenVertices given;
  RootBox root_box;
  OpenedNodes opened;
};

}  // namespace pelt::detail
