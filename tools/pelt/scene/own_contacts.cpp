#include "tools/pelt/scene/own_contacts.hpp"

#include <utility>

namespace pelt::tools::scene {

std::vector<std::span<const Collider>> by_instance(std::span<const Collider> colliders) {
  std::vector<std::span<const Collider>> instances;
  for (std::size_t begin = 0, end = 0; begin < colliders.size(); begin = end) {
    while (end < colliders.size() && colliders[end].instance == colliders[begin].instance) ++end;
    instances.push_back(colliders.subspan(begin, end - begin));
  }
  return instances;
}

OwnContacts::OwnContacts(std::span<const Collider> colliders, SelfFilters filters)
    : pairs_(SceneQuery::as_crowd(colliders, 1)), self_(colliders, std::move(filters)) {}

Result<void> OwnContacts::set_palettes(const Palettes& palettes) {
  if (const auto posed = pairs_.set_palettes(palettes); !posed) return posed;
  return self_.set_palettes(palettes);
}

void OwnContacts::append(ContactList& contacts) {
  pairs_.collide({}, found_);
  self_.collide({}, found_);
  contacts.insert(contacts.end(), found_.contacts.begin(), found_.contacts.end());
}

}  // namespace pelt::tools::scene
