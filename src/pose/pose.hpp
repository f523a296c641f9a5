#pragma once

#include <pelt/pose.hpp>

#include "model/model.hpp"
#include "pose/instance.hpp"

#include <cstdint>
#include <span>
#include <utility>

namespace pelt::detail {

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
