#include "tools/pelt/ignored_pairs.hpp"

#include "asset/message.hpp"
#include "scenes/names.hpp"
#include "scenes/nearest_name.hpp"
#include "tools/pelt/name_pattern.hpp"

#include <algorithm>
#include <string>

namespace pelt::tools {
namespace {

using Name = std::string (*)(const asset::Asset&, std::uint32_t index);

/// Which of `count` parts or joints of a character a pattern means.
std::vector<bool> named(std::string_view pattern, const scenes::Character& character,
                        std::size_t count, Name name) {
  std::vector<bool> result;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string text = name(character.asset, i);
    result.push_back(matches(pattern, text) || matches(pattern, character.name + "/" + text));
  }
  return result;
}

/// Each once, in their order.
std::vector<std::string> all_names(const scenes::Scene& scene) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const scenes::Character& character : scene.characters) {
    for (std::uint32_t p = 0; p < character.asset.parts.size(); ++p)
      add(scenes::part_name(character.asset, p));
    for (std::uint32_t j = 0; j < character.asset.joints.size(); ++j)
      add(scenes::joint_name(character.asset, j));
  }
  return names;
}

Error unknown_name(const scenes::Scene& scene, std::string_view name) {
  const std::vector<std::string> names = all_names(scene);
  const std::vector<std::string_view> known(names.begin(), names.end());
  return {ErrorCode::invalid_argument, "ignore: no part and no joint is named " +
                                           asset::quoted(name) + scenes::suggestion(name, known)};
}

}  // namespace

Result<IgnoredPairs> IgnoredPairs::make(const scenes::Scene& scene,
                                        std::span<const Collider> colliders,
                                        std::span<const scenes::NamePair> pairs) {
  IgnoredPairs ignored(scene, colliders);
  if (pairs.empty()) return ignored;
  std::vector<TriangleLabels> labels;
  for (const scenes::Character& character : scene.characters)
    labels.push_back(label_triangles(character.asset));
  for (const scenes::NamePair& pair : pairs) {
    for (const std::string& name : {pair.a, pair.b}) {
      if (!ignored.add(name, labels)) return unknown_name(scene, name);
    }
  }
  return ignored;
}

/// False if nothing has this name.
bool IgnoredPairs::add(std::string_view name, std::span<const TriangleLabels> labels) {
  bool is_known = false;
  Meant& of_characters = meant_.emplace_back();
  for (std::size_t c = 0; c < labels.size(); ++c) {
    const scenes::Character& character = scene_->characters[c];
    const auto parts = named(name, character, character.asset.parts.size(), scenes::part_name);
    const auto joints = named(name, character, character.asset.joints.size(), scenes::joint_name);
    const auto is_meant = [](bool x) { return x; };
    is_known |= std::any_of(parts.begin(), parts.end(), is_meant) ||
                std::any_of(joints.begin(), joints.end(), is_meant);
    std::vector<bool>& triangles = of_characters.emplace_back();
    for (std::size_t t = 0; t < labels[c].part.size(); ++t)
      triangles.push_back(parts[labels[c].part[t]] || joints[labels[c].joint[t]]);
  }
  return is_known;
}

bool IgnoredPairs::is_ignored(std::uint32_t character_a, std::uint32_t character_b,
                              const Contact& contact) const {
  const std::uint32_t s = contact.triangle_a, t = contact.triangle_b;
  for (std::size_t i = 0; i < meant_.size(); i += 2) {
    const Meant &x = meant_[i], &y = meant_[i + 1];
    if ((x[character_a][s] && y[character_b][t]) || (y[character_a][s] && x[character_b][t]))
      return true;
  }
  return false;
}

std::uint64_t IgnoredPairs::take_out(FrameContacts& found) const {
  if (meant_.empty()) return 0;
  const std::size_t before = found.contacts.size();
  std::size_t end = 0;
  for (FrameContacts::Pair& pair : found.pairs) {
    const std::uint32_t a = scene_->instances[colliders_[pair.a].instance].character;
    const std::uint32_t b = scene_->instances[colliders_[pair.b].instance].character;
    const std::size_t begin = end;
    for (std::size_t i = pair.begin; i < pair.end; ++i) {
      if (!is_ignored(a, b, found.contacts[i])) found.contacts[end++] = found.contacts[i];
    }
    pair.begin = begin;
    pair.end = end;
  }
  found.contacts.resize(end);
  std::erase_if(found.pairs, [](const FrameContacts::Pair& p) { return p.begin == p.end; });
  return before - end;
}

}  // namespace pelt::tools
