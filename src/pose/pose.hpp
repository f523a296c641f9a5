#pragma once

/// An instance of a model: its palette or given vertices, and the boxes and nodes that queries have
/// computed.

#include <pelt/pose.hpp>

#include "base/problem.hpp"
#include "model/model.hpp"
#include "model/node_bounds.hpp"
#include "model/tree.hpp"
#include "pose/posed_tree.hpp"

#include <cstdint>
#include <span>
#include <utility>

namespace pelt::detail {

/// Validates the number of offsets. Returns an empty Problem if they are valid.
Problem check_offsets(const Tree& tree, std::span<const Vec3> offsets);

/// The palette or given vertices of an instance, and the boxes and nodes that queries have computed
/// from them.
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

struct Pose : Instance {
  explicit Pose(SkinnedModel m) : Instance(m.detail().tree), model(std::move(m)) {}

  SkinnedModel model;
  Arena arena;
  std::uint64_t stamp = 0;  ///< raised when opened nodes become invalid

  PosedTree posed_tree() {
    return Instance::posed_tree(model.detail().tree, model.detail().bounds, arena);
  }

  Result<void> set_vertices(std::span<const Vec3> vertices);
  Result<void> set_offsets(std::span<const Vec3> offsets);

  /// Closes all nodes, because the palette has changed. Also forgets given vertices.
  void close_all() {
    ++stamp;
    given = {};
    arena.clear();
    opened = OpenedNodes();
    root_box.known = false;
  }

  /// Allocates one block; several blocks would waste memory at their ends. Keeps given vertices.
  void reserve();
};

}  // namespace pelt::detail
