#pragma once

#include <pelt/pose.hpp>

#include "model/model.hpp"
#include "pose/posed_tree.hpp"

#include <utility>

namespace pelt::detail {

struct Pose {
  explicit Pose(SkinnedModel m) : model(std::move(m)), palette(rest_palette(model.detail().tree)) {}

  SkinnedModel model;
  Palette palette;
  Arena arena;
  RootBox root_box;
  OpenedNodes opened;

  PosedTree posed_tree() {
    const Model& data = model.detail();
    return {data.tree, data.bounds, palette, root_box, opened, arena};
  }

  /// Accepts any of the forms of Palette::set.
  template <typename Element>
  Result<void> set_palette(std::span<const Element> elements) {
    Result<void> set = palette.set(elements);
    if (set) close_all();
    return set;
  }

  /// Closes all nodes, because the palette has changed.
  void close_all() {
    arena.clear();
    opened = OpenedNodes();
    root_box.known = false;
  }

  /// Allocates one block; several blocks would waste memory at their ends.
  void reserve() {
    close_all();
    arena = Arena();
    arena.reserve(bytes_to_open(model.detail().tree));
  }
};

}  // namespace pelt::detail
