#pragma once

/// Finds the contacts of each collider with itself in one frame of a scene.

#include <pelt/self_collide.hpp>

#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <span>
#include <vector>

namespace pelt::tools::scene {

class SelfQuery {
 public:
  /// `filters`: one per collider. `colliders` must outlive the query.
  SelfQuery(std::span<const Collider> colliders, std::vector<SelfFilter> filters)
      : colliders_(colliders), filters_(std::move(filters)), posed_(colliders) {}

  /// Error messages name the instance.
  Result<void> set_palettes(const Palettes& palettes) { return posed_.set_palettes(palettes); }

  /// Adds the contacts of each collider with itself to `found`, as those of the pair a, a.
  void collide(const CollideOptions& options, FrameContacts& found);

  /// Number of contacts that each filter has left out of the latest frame.
  const LeftOut& left_out() const { return left_out_; }

  /// The work so far.
  QueryStats work() const { return work_; }

 private:
  void find(const CollideOptions& options);

  std::span<const Collider> colliders_;
  std::vector<SelfFilter> filters_;
  ScenePoses posed_;
  Scratch scratch_;
  FrameContacts own_;     // of the colliders with themselves
  FrameContacts merged_;  // working memory of `collide`
  LeftOut left_out_;
  QueryStats work_;
};

}  // namespace pelt::tools::scene
