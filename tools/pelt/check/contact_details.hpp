#pragma once

/// The geometry of the contacts of one frame: what `pelt check --contacts` adds to them.

#include <pelt/contact.hpp>

#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <span>
#include <vector>

namespace pelt::tools::check {

class ContactDetails {
 public:
  /// Both arguments must outlive this.
  explicit ContactDetails(const scene::StagedScene& staged);

  /// Replaces what is known by the geometry of contacts that were found in these palettes.
  Result<void> describe(const scene::Palettes& palettes, const scene::FrameContacts& found);

  /// Of one of the pairs that were found, by its place among them; triangles have their numbers in
  /// the colliders' own models.
  const ContactGeometry& of_pair(std::size_t pair) const { return geometry_[pair]; }

 private:
  std::span<const scene::Collider> colliders_;
  std::vector<Surface> surfaces_;  // of each collider; those of one model share
  scene::ScenePoses posed_;
  Scratch scratch_;
  std::vector<Contact> contacts_;
  std::vector<ContactGeometry> geometry_;  // of each pair; kept from frame to frame for its memory
};

}  // namespace pelt::tools::check
