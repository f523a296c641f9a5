#pragma once

/// The geometry of the contacts of one frame, for `pelt check --contacts`.

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

  /// Replaces the geometry by that of contacts that were found with these palettes.
  Result<void> describe(const scene::Palettes& palettes, const scene::FrameContacts& found);

  /// The geometry of one of the found pairs, by its index. Triangle numbers are those of the
  /// colliders' own models.
  const ContactGeometry& of_pair(std::size_t pair) const { return geometry_[pair]; }

 private:
  std::span<const scene::Collider> colliders_;
  std::vector<Surface> surfaces_;  // of each collider; shared if the model is
  scene::ScenePoses posed_;
  Scratch scratch_;
  std::vector<Contact> contacts_;
  std::vector<ContactGeometry> geometry_;  // of each pair; reused from frame to frame
};

}  // namespace pelt::tools::check
