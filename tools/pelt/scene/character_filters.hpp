#pragma once

/// The filters of one character's contacts with itself.

#include "scenes/scene.hpp"
#include "scenes/triangle_labels.hpp"
#include "tools/pelt/scene/self_filters.hpp"

#include <span>

namespace pelt::tools::scene {

/// Contacts of a character, numbered as in the asset.
using ContactList = std::vector<Contact>;

void sort_unique(ContactList& contacts);

class CharacterFilters {
 public:
  /// `colliders`: of one instance. Character and colliders must outlive the object. Error messages
  /// name the file.
  static Result<CharacterFilters> make(const scenes::Character& character,
                                       std::span<const Collider> colliders, const SelfRules& rules);

  /// Builds the filters of one instance. `at_rest` and `always` are ascending.
  Result<SelfFilters> build(const ContactList& at_rest, const ContactList& always) const;

 private:
  CharacterFilters(const scenes::Character& character, std::span<const Collider> colliders,
                   const SelfRules& rules)
      : character_(&character), colliders_(colliders), rules_(rules) {}

  Result<void> prepare();

  const scenes::Character* character_;
  std::span<const Collider> colliders_;
  SelfRules rules_;
  scenes::TriangleLabels labels_;
  std::optional<Collider> whole_;  // only if the colliders are parts
};

}  // namespace pelt::tools::scene
