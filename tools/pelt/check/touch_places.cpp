#include "tools/pelt/check/touch_places.hpp"

#include "asset/message.hpp"
#include "scenes/names.hpp"
#include "scenes/triangle_labels.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace pelt::tools::check {
namespace {

/// Replaces each index by the lowest index with the same name.
template <typename Index>
void unite_equal_names(const std::vector<std::string>& names, std::vector<Index>& indices) {
  std::map<std::string_view, Index> by_name;
  std::vector<Index> lowest;
  for (const std::string& name : names) {
    const auto index = static_cast<Index>(lowest.size());
    lowest.push_back(by_name.try_emplace(name, index).first->second);
  }
  for (Index& index : indices) index = lowest[index];
}

/// Keys ascend as places do.
std::uint64_t key_of(std::uint32_t part, std::uint16_t joint) {
  return std::uint64_t{part} << 16 | joint;
}

TouchPlace place_of(std::uint64_t key) {
  return {0, static_cast<std::uint32_t>(key >> 16), static_cast<std::uint32_t>(key & 0xFFFF)};
}

}  // namespace

Result<TouchPlaces> TouchPlaces::make(const scene::StagedScene& staged) {
  TouchPlaces made;
  for (const scenes::Character& character : staged.scene.characters) {
    Result<scenes::TriangleLabels> labels = scenes::label_triangles(character.asset);
    if (!labels) return asset::prefixed(character.source, labels.error());
    unite_equal_names(scenes::part_names(character.asset), labels->part);
    unite_equal_names(scenes::joint_names(character.asset), labels->joint);
    made.characters_.push_back(number_places(labels->part, labels->joint));
  }
  for (std::uint32_t i = 0; i < staged.scene.instances.size(); ++i) {
    const std::uint32_t character = staged.scene.instances[i].character;
    made.character_of_.push_back(character);
    made.first_of_.push_back(static_cast<std::uint32_t>(made.places_.size()));
    for (const TouchPlace& place : made.characters_[character].places)
      made.places_.push_back({i, place.part, place.joint});
  }
  return made;
}

TouchPlaces::CharacterPlaces TouchPlaces::number_places(std::span<const std::uint32_t> parts,
                                                        std::span<const std::uint16_t> joints) {
  std::vector<std::uint64_t> keys;
  for (std::size_t t = 0; t < parts.size(); ++t) keys.push_back(key_of(parts[t], joints[t]));
  std::vector<std::uint64_t> places = keys;
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  CharacterPlaces numbered;
  for (const std::uint64_t key : keys) {
    const auto place = std::lower_bound(places.begin(), places.end(), key);
    numbered.place_of.push_back(static_cast<std::uint32_t>(place - places.begin()));
  }
  for (const std::uint64_t key : places) numbered.places.push_back(place_of(key));
  return numbered;
}

}  // namespace pelt::tools::check
