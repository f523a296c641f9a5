#include "tools/pelt/scene/self_filters.hpp"

#include "scenes/triangle_labels.hpp"
#include "text/message.hpp"
#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace pelt::tools::scene {
namespace {

/// Contacts of a character, numbered as in the asset.
using ContactList = std::vector<Contact>;

void sort_unique(ContactList& contacts) {
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
}

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

/// The filters of one character's contacts with itself.
class CharacterFilters {
 public:
  /// `colliders`: of one instance. Character and colliders must outlive the object. Error messages
  /// name the file.
  static Result<CharacterFilters> make(const scenes::Character& character,
                                       std::span<const Collider> colliders, const SelfRules& rules);

  /// Builds the filters of an instance. `at_rest` and `always` are ascending.
  Result<SelfFilters> build(std::uint32_t instance, const ContactList& at_rest,
                            const ContactList& always) const;

 private:
  CharacterFilters(const scenes::Character& character, std::span<const Collider> colliders,
                   const SelfRules& rules)
      : character_(&character), colliders_(colliders), rules_(rules) {}

  Result<void> prepare();

  const scenes::Character* character_;
  std::span<const Collider> colliders_;
  SelfRules rules_;
  scenes::TriangleLabels labels_;
  std::shared_ptr<const Collider> whole_;  // null unless the colliders are parts
};

Result<CharacterFilters> CharacterFilters::make(const scenes::Character& character,
                                                std::span<const Collider> colliders,
                                                const SelfRules& rules) {
  CharacterFilters filters(character, colliders, rules);
  if (const auto prepared = filters.prepare(); !prepared)
    return text::prefixed(character.source, prepared.error());
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
  whole_ =
      std::make_shared<const Collider>(Collider{0, std::nullopt, 0, std::move(*model), nullptr});
  return {};
}

Result<SelfFilters> CharacterFilters::build(std::uint32_t instance, const ContactList& at_rest,
                                            const ContactList& always) const {
  NearJoints near;
  if (rules_.drops_near_joints)
    near = scenes::near_joints(character_->asset, labels_.joint, at_rest);
  const auto filter = [&](const Collider& collider) -> Result<SelfFilter> {
    Result<SelfFilter> made = filter_of(collider, rules_, near, at_rest, always);
    if (!made) return text::prefixed(character_->source, made.error());
    return made;
  };
  SelfFilters filters;
  for (const Collider& collider : colliders_) {
    Result<SelfFilter> made = filter(collider);
    if (!made) return made.error();
    filters.of_colliders.push_back(std::move(*made));
  }
  if (!whole_) return filters;
  Result<SelfFilter> made = filter(*whole_);
  if (!made) return made.error();
  filters.of_parts.emplace(instance, std::move(*made));
  return filters;
}

/// Divides colliders into those of each instance.
std::vector<std::span<const Collider>> by_instance(std::span<const Collider> colliders) {
  std::vector<std::span<const Collider>> instances;
  for (std::size_t begin = 0, end = 0; begin < colliders.size(); begin = end) {
    while (end < colliders.size() && colliders[end].instance == colliders[begin].instance) ++end;
    instances.push_back(colliders.subspan(begin, end - begin));
  }
  return instances;
}

/// Appends the contacts of one instance with itself that the filters of `query` do not leave out.
Result<void> append_contacts(SceneQuery& query, const Palettes& palettes, ContactList& contacts) {
  if (const auto posed = query.set_palettes(palettes); !posed) return posed;
  FrameContacts found;
  query.collide({}, found);
  contacts.insert(contacts.end(), found.contacts.begin(), found.contacts.end());
  return {};
}

/// Returns palettes that leave all instances in the rest poses of their files.
Palettes rest_poses(const scenes::Scene& scene) {
  Palettes palettes;
  for (const scenes::Instance& instance : scene.instances) {
    const asset::Asset& asset = scene.characters[instance.character].asset;
    palettes.joints.emplace_back(asset.joints.size(), Matrix4{});
    palettes.morphs.emplace_back(asset.morph_targets.size(), 0.0F);
  }
  return palettes;
}

/// Returns the palettes of the nodes' default poses, without placements.
Palettes default_poses(const scenes::Scene& scene) {
  Palettes palettes = rest_poses(scene);
  asset::SampleScratch scratch;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const asset::Asset& asset = scene.characters[scene.instances[i].character].asset;
    asset::sample_palette(asset, nullptr, 0, Matrix4{}, scratch, palettes.joints[i]);
    asset::sample_morph_weights(asset, nullptr, 0, palettes.morphs[i]);
  }
  return palettes;
}

/// Builds the filters of all characters of a scene.
class Builder {
 public:
  Builder(const StagedScene& staged, const SelfRules& rules) : staged_(staged), rules_(rules) {
    std::vector<std::optional<std::size_t>> known(staged.scene.characters.size());
    for (const std::span<const Collider> own : by_instance(staged.colliders)) {
      const std::uint32_t character = staged.scene.instances[own[0].instance].character;
      if (!known[character]) {
        known[character] = characters_.size();
        characters_.push_back({own, staged.scene.characters[character], {}, {}, {}});
      }
      instances_.push_back({own, *known[character]});
    }
  }

  /// Builds filters without lists of contacts.
  Result<void> start() {
    for (Member& member : characters_) {
      auto prepared = CharacterFilters::make(member.character, member.own, rules_);
      if (!prepared) return prepared.error();
      member.filters = std::move(*prepared);
    }
    return {};
  }

  Result<void> find_at_rest() {
    for (Member& member : characters_) {
      Result<SceneQuery> query = query_of(member, member.own);
      if (!query) return query.error();
      for (const Palettes& palettes : {rest_poses(staged_.scene), default_poses(staged_.scene)})
        if (const auto found = append_contacts(*query, palettes, member.at_rest); !found)
          return found;
      sort_unique(member.at_rest);
    }
    return {};
  }

  Result<void> find_always(double share, const arguments::FrameRange& frames) {
    std::vector<SceneQuery> queries;
    for (const auto& [own, character] : instances_) {
      Result<SceneQuery> query = query_of(characters_[character], own);
      if (!query) return query.error();
      queries.push_back(std::move(*query));
    }
    std::vector<ContactTally> tallies(characters_.size());
    const auto count = [&](const Palettes& palettes) -> Result<QueryStats> {
      for (std::size_t i = 0; i < queries.size(); ++i) {
        ContactList contacts;
        if (const auto found = append_contacts(queries[i], palettes, contacts); !found)
          return found.error();
        sort_unique(contacts);
        tallies[instances_[i].character].add(contacts);
      }
      return QueryStats{};
    };
    const auto nothing = [](std::uint32_t, const Palettes&) -> Result<void> { return {}; };
    const auto run = run_frames(staged_.scene, frames, {count, nothing});
    if (!run) return run.error();
    for (std::size_t c = 0; c < tallies.size(); ++c)
      characters_[c].always = tallies[c].in_share_of_poses(share);
    return {};
  }

  Result<SelfFilters> build() const {
    std::vector<SelfFilters> of_characters;
    for (const Member& member : characters_) {
      Result<SelfFilters> filters = filters_of(member, member.own[0].instance);
      if (!filters) return filters.error();
      of_characters.push_back(std::move(*filters));
    }
    SelfFilters all;
    for (const auto& [own, character] : instances_) {
      const auto& [of_colliders, of_parts] = of_characters[character];
      all.of_colliders.insert(all.of_colliders.end(), of_colliders.begin(), of_colliders.end());
      for (const auto& [instance, filter] : of_parts) all.of_parts.emplace(own[0].instance, filter);
    }
    return all;
  }

 private:
  struct Member {
    std::span<const Collider> own;  // of its first instance
    const scenes::Character& character;
    std::optional<CharacterFilters> filters;
    ContactList at_rest, always;
  };

  struct Placed {
    std::span<const Collider> own;
    std::size_t character;  // index into `characters_`
  };

  Result<SelfFilters> filters_of(const Member& member, std::uint32_t instance) const {
    return member.filters->build(instance, member.at_rest, member.always);
  }

  /// The query of the contacts of an instance with itself, of these colliders.
  Result<SceneQuery> query_of(const Member& member, std::span<const Collider> own) const {
    Result<SelfFilters> filters = filters_of(member, own[0].instance);
    if (!filters) return filters.error();
    return SceneQuery::as_crowd(own, 1, {.filters = std::move(*filters)});
  }

  StagedScene staged_;
  SelfRules rules_;
  std::vector<Member> characters_;
  std::vector<Placed> instances_;
};

}  // namespace

/// Parts are ordered by their triangles, so that the order of the triangles of a contact stays.
LeftOut SelfFilters::leave_out_between_parts(std::span<const Collider> colliders,
                                             const Limits& limits, Scratch& scratch,
                                             FrameContacts& found) const {
  LeftOut left_out;
  if (of_parts.empty()) return left_out;
  std::vector<Contact> kept;
  found.keep([&](const FrameContacts::Pair& pair, std::span<Contact> contacts) {
    if (pair.a == pair.b) return contacts.size();
    const std::uint32_t instance = colliders[pair.a].instance;
    kept.assign(contacts.begin(), contacts.end());
    if (colliders[pair.b].instance == instance)
      left_out += leave_out(of_parts.at(instance), scratch, kept);
    const std::size_t count = std::min<std::size_t>(kept.size(), limits.max_contacts);
    std::copy_n(kept.begin(), count, contacts.begin());
    return count;
  });
  return left_out;
}

CrowdOptions SelfTests::crowd_options() const {
  CrowdOptions options;
  if (!pairs) options.filter = [](std::uint32_t, std::uint32_t) { return false; };
  if (filters) options.self_filter = [this](std::uint32_t c) { return &filters->of_colliders[c]; };
  return options;
}

Result<SelfFilters> make_self_filters(const StagedScene& staged, const SelfRules& rules,
                                      const arguments::FrameRange& frames) {
  Builder builder(staged, rules);
  if (const auto started = builder.start(); !started) return started.error();
  if (rules.drops_at_rest)
    if (const auto found = builder.find_at_rest(); !found) return found.error();
  if (rules.always)
    if (const auto found = builder.find_always(*rules.always, frames); !found) return found.error();
  return builder.build();
}

}  // namespace pelt::tools::scene
