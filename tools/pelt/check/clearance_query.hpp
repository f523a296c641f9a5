#pragma once

/// Finds all pairs of triangles within a distance in one frame of a scene. `pelt check --clearance`
/// uses it instead of a SceneQuery.

#include <pelt/distance.hpp>

#include "tools/pelt/scene/near_pairs.hpp"
#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <span>

namespace pelt::tools::check {

class ClearanceQuery {
 public:
  /// `colliders` must outlive the query.
  ClearanceQuery(std::span<const scene::Collider> colliders, double tolerance)
      : colliders_(colliders), posed_(colliders), tolerance_(tolerance) {}

  /// Error messages name the instance.
  Result<void> set_palettes(const scene::Palettes& palettes) {
    return posed_.set_palettes(palettes);
  }

  /// Replaces `found` by the pairs of triangles of every pair of colliders.
  void collide(const Limits& limits, scene::FrameContacts& found);

  /// The work so far.
  QueryStats work() const { return work_; }

 private:
  std::span<const scene::Collider> colliders_;
  scene::ScenePoses posed_;
  double tolerance_;
  scene::NearPairs near_pairs_;
  Scratch scratch_;
  std::vector<Contact> near_;
  QueryStats work_;
};

}  // namespace pelt::tools::check
