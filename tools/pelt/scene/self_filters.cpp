#include "tools/pelt/scene/self_filters.hpp"

#include "asset/message.hpp"
#include "tools/pelt/scene/character_filters.hpp"
#include "tools/pelt/scene/own_contacts.hpp"
#include "tools/pelt/scene/scene_poses.hpp"

#include <utility>

namespace pelt::tools::scene {
namespace {

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
      Result<OwnContacts> query = query_of(member, member.own);
      if (!query) return query.error();
      for (const Palettes& palettes : {rest_poses(staged_.scene), default_poses(staged_.scene)}) {
        if (const auto posed = query->set_palettes(palettes); !posed) return posed.error();
        query->append(member.at_rest);
      }
      sort_unique(member.at_rest);
    }
    return {};
  }

  Result<void> find_always(double share, const arguments::FrameRange& frames) {
    std::vector<OwnContacts> queries;
    for (const auto& [own, character] : instances_) {
      Result<OwnContacts> query = query_of(characters_[character], own);
      if (!query) return query.error();
      queries.push_back(std::move(*query));
    }
    std::vector<ContactTally> tallies(characters_.size());
    const auto count = [&](const Palettes& palettes) -> Result<QueryStats> {
      for (std::size_t i = 0; i < queries.size(); ++i) {
        if (const auto posed = queries[i].set_palettes(palettes); !posed) return posed.error();
        ContactList found;
        queries[i].append(found);
        sort_unique(found);
        tallies[instances_[i].character].add(found);
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
      Result<SelfFilters> filters = filters_of(member);
      if (!filters) return filters.error();
      of_characters.push_back(std::move(*filters));
    }
    SelfFilters all;
    all.of_parts.reserve(instances_.size());
    for (const auto& [own, character] : instances_) {
      const auto& [of_colliders, of_parts] = of_characters[character];
      all.of_colliders.insert(all.of_colliders.end(), of_colliders.begin(), of_colliders.end());
      all.of_parts.insert(all.of_parts.end(), of_parts.begin(), of_parts.end());
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

  Result<SelfFilters> filters_of(const Member& member) const {
    return member.filters->build(member.at_rest, member.always);
  }

  Result<OwnContacts> query_of(const Member& member, std::span<const Collider> own) const {
    Result<SelfFilters> filters = filters_of(member);
    if (!filters) return filters.error();
    return OwnContacts(own, std::move(*filters));
  }

  StagedScene staged_;
  SelfRules rules_;
  std::vector<Member> characters_;
  std::vector<Placed> instances_;
};

}  // namespace

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
