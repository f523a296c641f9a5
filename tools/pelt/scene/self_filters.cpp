#include "tools/pelt/scene/self_filters.hpp"

#include "asset/message.hpp"
#include "scenes/near_joints.hpp"
#include "tools/pelt/scene/self_query.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace pelt::tools::scene {
namespace {

/// Returns the pairs of near joints, numbered as in the collider's model.
std::vector<IndexPair> near_joints(const asset::Asset& asset, const Collider& collider) {
  std::map<std::uint16_t, std::uint16_t> numbers;
  for (std::uint32_t j = 0; j < collider.model.joint_count(); ++j) {
    const auto joint = static_cast<std::uint16_t>(j);
    numbers[collider.joint_in_asset(joint)] = joint;
  }
  std::vector<IndexPair> pairs;
  for (const auto& [first, second] : scenes::near_joints(asset)) {
    const auto a = numbers.find(first), b = numbers.find(second);
    if (a != numbers.end() && b != numbers.end()) pairs.push_back({a->second, b->second});
  }
  return pairs;
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

/// Contacts of a model, numbered as in the model.
using ContactList = std::vector<Contact>;

void sort_unique(ContactList& contacts) {
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
}

/// Builds the filters of the models of a scene.
class Builder {
 public:
  Builder(const StagedScene& staged, const SelfRules& rules) : staged_(staged), rules_(rules) {
    std::map<std::pair<std::uint32_t, std::optional<std::uint32_t>>, std::size_t> known;
    for (std::uint32_t c = 0; c < staged.colliders.size(); ++c) {
      const auto key = std::pair(staged.character_of(c), staged.colliders[c].part);
      const auto [model, is_new] = known.try_emplace(key, models_.size());
      if (is_new) models_.push_back({c, {}, {}});
      model_of_.push_back(model->second);
    }
  }

  Result<void> find_at_rest() {
    const auto filters = build();
    if (!filters) return filters.error();
    SelfQuery query(staged_.colliders, *filters);
    for (const Palettes& palettes : {rest_poses(staged_.scene), default_poses(staged_.scene)}) {
      FrameContacts found;
      if (const auto posed = query.set_palettes(palettes); !posed) return posed.error();
      query.collide({}, found);
      for (const FrameContacts::Pair& pair : found.pairs)
        if (Model& model = models_[model_of_[pair.a]]; model.collider == pair.a)
          for (const Contact& contact : found.of(pair))
            model.at_rest.push_back(numbered(contact, pair.a));
    }
    for (Model& model : models_) sort_unique(model.at_rest);
    return {};
  }

  Result<void> find_always(double share, const arguments::FrameRange& frames) {
    const auto filters = build();
    if (!filters) return filters.error();
    SelfQuery query(staged_.colliders, *filters);
    std::vector<ContactTally> tallies(models_.size());
    FrameContacts found;
    const auto ask = [&](const Palettes& palettes) -> Result<QueryStats> {
      if (const auto posed = query.set_palettes(palettes); !posed) return posed.error();
      found = {};
      query.collide({}, found);
      return QueryStats{};
    };
    const auto count = [&](std::uint32_t, const Palettes&) -> Result<void> {
      tally(found, tallies);
      return {};
    };
    const auto run = run_frames(staged_.scene, frames, {ask, count});
    if (!run) return run.error();
    for (std::size_t m = 0; m < models_.size(); ++m)
      models_[m].always = tallies[m].in_share_of_poses(share);
    return {};
  }

  Result<std::vector<SelfFilter>> build() const {
    std::vector<SelfFilter> of_models;
    for (const Model& model : models_) {
      Result<SelfFilter> filter = build_one(model);
      if (!filter)
        return asset::prefixed(
            staged_.scene.characters[staged_.character_of(model.collider)].source, filter.error());
      of_models.push_back(std::move(*filter));
    }
    std::vector<SelfFilter> filters;
    for (const std::size_t model : model_of_) filters.push_back(of_models[model]);
    return filters;
  }

 private:
  struct Model {
    std::uint32_t collider = 0;  // the first one with this model
    ContactList at_rest, always;
  };

  Contact numbered(const Contact& contact, std::uint32_t collider) const {
    const Collider& own = staged_.colliders[collider];
    return numbered_in_models(contact, own, own);
  }

  void tally(const FrameContacts& found, std::vector<ContactTally>& tallies) const {
    std::vector<ContactList> of_colliders(staged_.colliders.size());
    for (const FrameContacts::Pair& pair : found.pairs)
      for (const Contact& contact : found.of(pair))
        of_colliders[pair.a].push_back(numbered(contact, pair.a));
    for (std::size_t c = 0; c < of_colliders.size(); ++c)
      tallies[model_of_[c]].add(of_colliders[c]);
  }

  Result<SelfFilter> build_one(const Model& model) const {
    const Collider& collider = staged_.colliders[model.collider];
    SelfFilterOptions options;
    options.rings = rules_.rings;
    options.at_rest = model.at_rest;
    options.always = model.always;
    std::vector<IndexPair> joint_pairs;
    if (rules_.drops_near_joints)
      joint_pairs = near_joints(staged_.asset_of(model.collider), collider);
    options.joint_pairs = joint_pairs;
    return build_self_filter(collider.model, options);
  }

  StagedScene staged_;
  SelfRules rules_;
  std::vector<Model> models_;
  std::vector<std::size_t> model_of_;  // each collider's index into `models_`
};

}  // namespace

Result<std::vector<SelfFilter>> make_self_filters(const StagedScene& staged, const SelfRules& rules,
                                                  const arguments::FrameRange& frames) {
  Builder builder(staged, rules);
  if (rules.drops_at_rest)
    if (const auto found = builder.find_at_rest(); !found) return found.error();
  if (rules.always)
    if (const auto found = builder.find_always(*rules.always, frames); !found) return found.error();
  return builder.build();
}

}  // namespace pelt::tools::scene
