#pragma once

#include <pelt/pose.hpp>

#include "model/model.hpp"
#include "pose/posed_tree.hpp"

namespace pelt::detail {

struct Pose {
  SkinnedModel model;
  Palette palette;
  OpenedNodes opened;
  Arena arena;

  PosedTree posed_tree() {
    const Model& data = model.detail();
    return {data.tree, data.bounds, palette, opened, arena};
  }

  /// The palette has changed.
  void close_all() {
    opened.clear();
    arena.clear();
  }
};

}  // namespace pelt::detail
