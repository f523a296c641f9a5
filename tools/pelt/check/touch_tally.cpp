#include "tools/pelt/check/touch_tally.hpp"

#include "asset/message.hpp"
#include "asset/printable.hpp"
#include "scenes/names.hpp"
#include "scenes/takes.hpp"
#include "tools/pelt/check/touch_name.hpp"

#include <algorithm>
#include <string>
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

template <typename T>
std::pair<T, T> ascending(const T& a, const T& b) {
  return b < a ? std::pair(b, a) : std::pair(a, b);
}

}  // namespace

void TouchCounts::add(std::uint32_t frame, std::uint64_t found) {
  contacts += found;
  ++frames;
  if (found <= worst) return;
  worst = found;
  worst_frame = frame;
}

Result<TouchTally> TouchTally::make(const scene::StagedScene& staged) {
  TouchTally tally(staged);
  for (const scenes::Character& character : staged.scene.characters) {
    Result<scenes::TriangleLabels> labels = scenes::label_triangles(character.asset);
    if (!labels) return asset::prefixed(character.source, labels.error());
    unite_equal_names(scenes::part_names(character.asset), labels->part);
    unite_equal_names(scenes::joint_names(character.asset), labels->joint);
    tally.labels_.push_back(std::move(*labels));
  }
  return tally;
}

TouchTally::Places TouchTally::places_of(std::uint32_t collider) const {
  const std::uint32_t instance = staged_.colliders[collider].instance;
  return {instance, labels_[staged_.scene.instances[instance].character]};
}

/// Most contacts have the places of the contact before, whose count need not be searched again.
void TouchTally::count_pair(const scene::FrameContacts& found,
                            const scene::FrameContacts::Pair& pair, FrameCounts& touches) const {
  const Places of_a = places_of(pair.a), of_b = places_of(pair.b);
  TouchPlace last_a, last_b;
  std::uint64_t* count = nullptr;
  for (const Contact& contact : found.of(pair)) {
    const TouchPlace a = of_a.at(contact.triangle_a), b = of_b.at(contact.triangle_b);
    if (count == nullptr || a != last_a || b != last_b) {
      count = &touches[ascending(a, b)];
      last_a = a;
      last_b = b;
    }
    ++*count;
  }
}

void TouchTally::add(std::uint32_t frame, const scene::FrameContacts& found) {
  FrameCounts touches, joints, parts;
  for (const scene::FrameContacts::Pair& pair : found.pairs) count_pair(found, pair, touches);
  for (const auto& [places, count] : touches) {
    const auto& [a, b] = places;
    joints[ascending(TouchPlace{a.instance, 0, a.joint}, TouchPlace{b.instance, 0, b.joint})] +=
        count;
    parts[ascending(TouchPlace{a.instance, a.part, 0}, TouchPlace{b.instance, b.part, 0})] += count;
  }
  const std::uint32_t take = scenes::take_index(staged_.scene, frame);
  for (const auto& [places, count] : touches) touches_[{take, places}].add(frame, count);
  for (const auto& [places, count] : joints) joints_[{take, places}].add(frame, count);
  for (const auto& [places, count] : parts) parts_[{take, places}].add(frame, count);
}

std::vector<Touch> TouchTally::touches() const {
  std::vector<Touch> touches;
  for (const auto& [key, counts] : touches_)
    touches.push_back({counts, key.second.first, key.second.second, key.first});
  std::stable_sort(touches.begin(), touches.end(),
                   [](const Touch& a, const Touch& b) { return a.contacts > b.contacts; });
  return touches;
}

std::vector<TouchTally::Row> TouchTally::joints() const {
  return rows(joints_, &TouchPlace::joint, [&](std::uint32_t character, std::uint32_t joint) {
    return scenes::joint_name(staged_.scene.characters[character].asset, joint);
  });
}

std::vector<TouchTally::Row> TouchTally::parts() const {
  return rows(parts_, &TouchPlace::part, [&](std::uint32_t character, std::uint32_t part) {
    return staged_.names->part(character, part);
  });
}

std::vector<TouchTally::Row> TouchTally::rows(const std::map<Key, TouchCounts>& counts,
                                              std::uint32_t TouchPlace::*index,
                                              const NameOf& name_of) const {
  const auto name_in = [&](const TouchPlace& place) {
    const std::uint32_t character = staged_.scene.instances[place.instance].character;
    return asset::printable_name(name_of(character, place.*index));
  };
  const auto full_name = [&](const TouchPlace& place) {
    return instance_words(staged_, place.instance) + " " + name_in(place);
  };
  std::vector<Row> rows;
  const std::vector<scenes::Take>& takes = staged_.scene.takes;
  for (const auto& [key, of_places] : counts) {
    const auto& [take, places] = key;
    const auto& [a, b] = places;
    const bool is_itself = is_of_itself(staged_, a.instance, b.instance);
    rows.push_back({of_places, takes.empty() ? "" : asset::quoted(takes[take].clip), full_name(a),
                    is_itself ? kItself + name_in(b) : full_name(b)});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.contacts > b.contacts; });
  return rows;
}

}  // namespace pelt::tools::check
