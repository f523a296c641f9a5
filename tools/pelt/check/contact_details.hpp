#pragma once

/// The geometry of the contacts of one frame, for `pelt check --contacts`.

#include <pelt/surface.hpp>

#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <span>
#include <vector>

namespace pelt::tools::check {

class ContactDetails {
 public:
  /// `staged` must outlive this.
  explicit ContactDetails(const scene::StagedScene& staged);

  /// Replaces the geometry by that of contacts that were found with these palettes.
  Result<void> describe(const scene::Palettes& palettes, const scene::FrameContacts& found);

  /// Returns the geometry of a pair, given by its index in `found.pairs`. Triangles are numbered as
  /// in the colliders' own models, and joints as in the assets.
  const ContactGeometry& of_pair(std::size_t pair) const { return geometry_[pair]; }

 private:
  void describe_pair(std::uint32_t a, std::uint32_t b, ContactGeometry& geometry);

  std::span<const scene::Collider> colliders_;
  scene::ScenePoses posed_;
  Scratch scratch_;
  std::vector<Contact> contacts_;
  std::vector<ContactGeometry> geometry_;  // of each pair; reused from frame to frame
};

}  // namespace pelt::tools::check
