#pragma once

/// A pose with all nodes open and with exact boxes, as in methods without refitting on demand.

#include <pelt/query.hpp>

#include "pose/pose.hpp"

#include <span>

namespace pelt::detail {

class EagerPose {
 public:
  /// The rest pose, with no node open yet. `tree` must outlive this.
  explicit EagerPose(const Tree& tree);

  /// Copies what poses the vertices of an instance of the same tree, and closes all nodes. Borrows
  /// its given vertices.
  void copy(const Instance& posed);

  /// Copies the morph weights for the next palette, or returns an error if they are invalid.
  Result<void> set_morph_weights(std::span<const float> weights);

  /// Copies the joint palette and closes all nodes. If it is invalid, returns an error and changes
  /// nothing.
  Result<void> set_palette(std::span<const Matrix4> palette);

  /// Skins all vertices and computes all exact boxes bottom-up, including that of the root, so that
  /// queries compute no bound.
  QueryStats open_all();

  /// Returns the view that queries use. Precondition: all nodes are open.
  PosedTree posed_tree();

 private:
  void close_all();

  const Tree& tree_;
  NodeBounds no_bounds_;
  Instance instance_;
  Arena arena_;
};

}  // namespace pelt::detail
