#include "tools/pelt/scene/character_filters.hpp"

#include "asset/message.hpp"
#include "scenes/triangle_labels.hpp"

#include <algorithm>
#include <map>

namespace pelt::tools::scene {
namespace {

/// Returns bodies, pairs and zones as in the collider's model, with the numbers of its joints and
/// triangles.
NearJoints numbered_in_model(const NearJoints& near, const Collider& collider) {
  std::map<std::uint16_t, std::uint16_t> joints;  // a joint of each body
  NearJoints own;
  for (std::uint16_t j = 0; j < collider.model.joint_count() && !near.bodies.empty(); ++j) {
    own.bodies.push_back(near.bodies[collider.joint_in_asset(j)]);
    joints.try_emplace(own.bodies.back(), j);
  }
  const auto add = [&](const std::vector<IndexPair>& pairs, std::vector<IndexPair>& to) {
    for (const auto& [first, second] : pairs) {
      const auto a = joints.find(first), b = joints.find(second);
      if (a != joints.end() && b != joints.end()) to.push_back({a->second, b->second});
    }
  };
  add(near.joint_pairs, own.joint_pairs);
  add(near.joint_pairs_in_zones, own.joint_pairs_in_zones);
  const std::uint32_t first = collider.first_triangle, count = collider.model.triangle_count();
  for (const auto& [triangle, zone] : near.zones)
    if (triangle >= first && triangle - first < count)
      own.zones.push_back({triangle - first, zone});
  return own;
}

/// Returns the contacts of a collider with itself, numbered as in its model.
ContactList contacts_within(const ContactList& contacts, const Collider& collider) {
  const std::uint32_t begin = collider.first_triangle;
  const std::uint32_t end = begin + collider.model.triangle_count();
  const auto is_own = [&](std::uint32_t t) { return t >= begin && t < end; };
  ContactList own;
  for (const Contact& contact : contacts)
    if (is_own(contact.triangle_a) && is_own(contact.triangle_b))
      own.push_back(numbered_in_models(contact, collider, collider));
  return own;
}

Result<SelfFilter> filter_of(const Collider& collider, const SelfRules& rules,
                             const NearJoints& near, const ContactList& at_rest,
                             const ContactList& always) {
  const ContactList own_at_rest = contacts_within(at_rest, collider);
  const ContactList own_always = contacts_within(always, collider);
  const NearJoints own = numbered_in_model(near, collider);
  SelfFilterOptions options;
  options.rings = rules.rings;
  options.at_rest = own_at_rest;
  options.always = own_always;
  options.joint_bodies = own.bodies;
  options.joint_pairs = own.joint_pairs;
  options.joint_pairs_in_zones = own.joint_pairs_in_zones;
  options.zones = own.zones;
  return build_self_filter(collider.model, options);
}

}  // namespace

void sort_unique(ContactList& contacts) {
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
}

Result<CharacterFilters> CharacterFilters::make(const scenes::Character& character,
                                                std::span<const Collider> colliders,
                                                const SelfRules& rules) {
  CharacterFilters filters(character, colliders, rules);
  if (const auto prepared = filters.prepare(); !prepared)
    return asset::prefixed(character.source, prepared.error());
  return filters;
}

Result<void> CharacterFilters::prepare() {
  auto labels = scenes::label_triangles(character_->asset);
  if (!labels) return labels.error();
  labels_ = std::move(*labels);
  if (!colliders_[0].part) return {};
  ModelOptions options;
  options.off_weights = OffWeights::renormalise;  // the parts have been validated
  Result<SkinnedModel> model = build_model(character_->asset.mesh(), options);
  if (!model) return model.error();
  whole_ = Collider{0, std::nullopt, 0, std::move(*model), nullptr};
  return {};
}

Result<SelfFilters> CharacterFilters::build(const ContactList& at_rest,
                                            const ContactList& always) const {
  NearJoints near;
  if (rules_.drops_near_joints)
    near = scenes::near_joints(character_->asset, labels_.joint, at_rest);
  SelfFilters filters;
  const auto add = [&](const Collider& collider, std::vector<SelfFilter>& to) -> Result<void> {
    Result<SelfFilter> filter = filter_of(collider, rules_, near, at_rest, always);
    if (!filter) return asset::prefixed(character_->source, filter.error());
    to.push_back(std::move(*filter));
    return {};
  };
  for (const Collider& collider : colliders_)
    if (const auto added = add(collider, filters.of_colliders); !added) return added.error();
  if (whole_)
    if (const auto added = add(*whole_, filters.of_parts); !added) return added.error();
  return filters;
}

}  // namespace pelt::tools::scene
