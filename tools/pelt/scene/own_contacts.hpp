#pragma once

/// Finds the contacts of one instance with itself: of each of its colliders with itself, and of
/// every two.

#include "tools/pelt/scene/character_filters.hpp"
#include "tools/pelt/scene/self_query.hpp"

namespace pelt::tools::scene {

/// Divides colliders into those of each instance.
std::vector<std::span<const Collider>> by_instance(std::span<const Collider> colliders);

class OwnContacts {
 public:
  /// `colliders`: of one instance; they must outlive the object.
  OwnContacts(std::span<const Collider> colliders, SelfFilters filters);

  /// `palettes`: of all instances. Error messages name the instance.
  Result<void> set_palettes(const Palettes& palettes);

  /// Appends the contacts that the filters do not leave out.
  void append(ContactList& contacts);

 private:
  SceneQuery pairs_;
  SelfQuery self_;
  FrameContacts found_;
};

}  // namespace pelt::tools::scene
