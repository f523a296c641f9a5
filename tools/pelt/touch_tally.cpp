#include "tools/pelt/touch_tally.hpp"

#include "asset/message.hpp"
#include "scenes/names.hpp"

#include <algorithm>
#include <utility>

namespace pelt::tools {

Result<TouchTally> TouchTally::make(const scenes::Scene& scene,
                                    std::span<const Collider> colliders) {
  TouchTally tally(scene, colliders);
  for (const scenes::Character& character : scene.characters) {
    Result<scenes::TriangleLabels> labels = scenes::label_triangles(character.asset);
    if (!labels) return asset::prefixed(character.source, labels.error());
    tally.labels_.push_back(std::move(*labels));
  }
  return tally;
}

const scenes::TriangleLabels& TouchTally::labels_of(std::uint32_t instance) const {
  return labels_[scene_->instances[instance].character];
}

void TouchTally::add(std::uint32_t frame, const FrameContacts& found) {
  std::map<Places, std::uint64_t> contacts;
  for (const FrameContacts::Pair& pair : found.pairs) {
    const std::uint32_t a = colliders_[pair.a].instance, b = colliders_[pair.b].instance;
    const scenes::TriangleLabels &labels_a = labels_of(a), &labels_b = labels_of(b);
    for (const Contact& contact : found.of(pair)) {
      const std::uint32_t s = contact.triangle_a, t = contact.triangle_b;
      ++contacts[{TouchPlace{a, labels_a.part[s], labels_a.joint[s]},
                  TouchPlace{b, labels_b.part[t], labels_b.joint[t]}}];
    }
  }
  add_frame(frame, contacts);
}

void TouchTally::add_frame(std::uint32_t frame, const std::map<Places, std::uint64_t>& contacts) {
  for (const auto& [places, count] : contacts) {
    Touch& touch = touches_[places];
    touch.a = places.first;
    touch.b = places.second;
    touch.contacts += count;
    ++touch.frames;
    if (count <= touch.worst) continue;
    touch.worst = count;
    touch.worst_frame = frame;
  }
}

std::vector<Touch> TouchTally::touches() const {
  std::vector<Touch> touches;
  for (const auto& [places, touch] : touches_) touches.push_back(touch);
  std::stable_sort(touches.begin(), touches.end(),
                   [](const Touch& a, const Touch& b) { return a.contacts > b.contacts; });
  return touches;
}

std::vector<TouchTally::Row> TouchTally::joints(std::size_t most) const {
  return rows(&TouchPlace::joint, most, scenes::joint_name);
}

std::vector<TouchTally::Row> TouchTally::parts(std::size_t most) const {
  return rows(&TouchPlace::part, most, scenes::part_name);
}

std::vector<TouchTally::Row> TouchTally::rows(std::uint32_t TouchPlace::*index, std::size_t most,
                                              Name name) const {
  using Key = std::pair<std::uint32_t, std::uint32_t>;  // instance, part or joint
  std::map<std::pair<Key, Key>, std::uint64_t> counts;
  for (const auto& [places, touch] : touches_) {
    const auto& [a, b] = places;
    counts[{Key{a.instance, a.*index}, Key{b.instance, b.*index}}] += touch.contacts;
  }
  const auto full_name = [&](const Key& key) {
    const scenes::Character& character = scene_->characters[scene_->instances[key.first].character];
    return character.name + " " + std::to_string(key.first) + " " +
           name(character.asset, key.second);
  };
  std::vector<Row> rows;
  for (const auto& [keys, contacts] : counts) {
    rows.push_back({full_name(keys.first), full_name(keys.second), contacts});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.contacts > b.contacts; });
  if (rows.size() > most) rows.resize(most);
  return rows;
}

}  // namespace pelt::tools
