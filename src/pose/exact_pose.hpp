#pragma once

/// A pose whose nodes are all open, with exact boxes: what methods without refit on demand have.

#include <pelt/query.hpp>

#include "pose/posed_tree.hpp"

#include <span>

namespace pelt::detail {

class ExactPose {
 public:
  /// The rest pose, with no node open yet. `tree` must outlive this.
  explicit ExactPose(const Tree& tree);

  /// Takes the weights of morph targets for the palette set next, or refuses them.
  Result<void> set_morph_weights(std::span<const float> weights);

  /// Takes a joint palette, or refuses it and stays as it was. No node is open after it.
  Result<void> set_palette(std::span<const Matrix4> palette);

  /// Skins all vertices and computes the exact boxes bottom-up, that of the root included, so that
  /// queries compute no bound.
  QueryStats open_all();

  /// What queries take. Precondition: all nodes are open.
  PosedTree posed_tree();

 private:
  void close_all();

  const Tree& tree_;
  NodeBounds no_bounds_;
  Palette palette_;
  Arena arena_;
  RootBox root_box_;
  OpenedNodes opened_;
};

}  // namespace pelt::detail
