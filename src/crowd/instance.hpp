#pragma once

#include <pelt/crowd.hpp>

#include "model/model.hpp"
#include "pose/posed_tree.hpp"

#include <utility>

namespace pelt::detail {

/// One instance of a crowd. `opened` is empty unless a query of this frame got near the instance.
struct CrowdInstance {
  CrowdInstance(SkinnedModel m, const CrowdGroups& g)
      : model(std::move(m)),
        groups(g),
        palette(model.detail().tree.joint_count, model.detail().tree.rest_extent) {}

  /// As the thread sees it whose arena this is.
  PosedTree posed_tree(Arena& arena) {
    return {model.detail().tree, model.detail().bounds, palette, opened, arena};
  }

  SkinnedModel model;
  CrowdGroups groups;
  Palette palette;
  RootBox box;            // of the palette
  bool has_moved = true;  // since the last query
  bool is_open = false;   // in the crowd's list of those that are
  OpenedNodes opened{0};
};

}  // namespace pelt::detail
