#pragma once

/// A pose whose nodes are all open, with exact boxes: what methods without refit on demand have.

#include "distance/pair_search.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

#include <span>
#include <vector>

namespace pelt::rivals {

class ExactPose {
 public:
  /// The rest pose, with nothing open yet. `tree` must outlive this.
  explicit ExactPose(const detail::Tree& tree);

  /// Takes the weights of morph targets for the palette set next, or refuses them.
  Result<void> set_morph_weights(std::span<const float> weights);

  /// Takes a joint palette, or refuses it and stays as it was. Nothing is open after it.
  Result<void> set_palette(std::span<const Matrix4> palette);

  /// Skins all vertices and takes the exact boxes bottom-up, that of the root included, so that
  /// queries compute no bound.
  QueryStats open_all();

 private:
  friend QueryStats collide(ExactPose& a, ExactPose& b, detail::Scratch& scratch,
                            std::vector<Contact>& contacts, const CollideOptions& options);
  friend QueryStats distance(ExactPose& a, ExactPose& b, detail::Scratch& scratch,
                             detail::TriangleGap& nearest);

  void close_all();
  detail::PosedTree posed_tree();

  const detail::Tree& tree_;
  detail::NodeBounds no_bounds_;
  detail::Palette palette_;
  detail::Arena arena_;
  detail::RootBox root_box_;
  detail::OpenedNodes opened_;
};

/// Appends the contacts, ascending. Precondition: all is open in both.
QueryStats collide(ExactPose& a, ExactPose& b, detail::Scratch& scratch,
                   std::vector<Contact>& contacts, const CollideOptions& options);

/// The nearest triangles. Preconditions: all is open in both, which touch nowhere.
QueryStats distance(ExactPose& a, ExactPose& b, detail::Scratch& scratch,
                    detail::TriangleGap& nearest);

}  // namespace pelt::rivals
