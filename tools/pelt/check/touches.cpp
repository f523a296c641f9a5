#include "tools/pelt/check/touches.hpp"

#include "scenes/names.hpp"
#include "scenes/takes.hpp"
#include "scenes/triangle_labels.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>

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

BodyName instance_name(const scene::StagedScene& staged, std::uint32_t instance) {
  const std::uint32_t character = staged.scene.instances[instance].character;
  return {scene::as_json_holds(staged.scene.characters[character].name),
          staged.names->copy(instance), ""};
}

const std::string& part_name(const scene::StagedScene& staged, std::uint32_t instance,
                             std::uint32_t part) {
  return staged.names->part(staged.scene.instances[instance].character, part);
}

std::string joint_name(const scene::StagedScene& staged, const TouchPlace& place) {
  const std::uint32_t character = staged.scene.instances[place.instance].character;
  return scenes::joint_name(staged.scene.characters[character].asset, place.joint);
}

/// "Cape Spine"
std::string words_in_instance(const scene::StagedScene& staged, const TouchPlace& place) {
  return text::printable_name(part_name(staged, place.instance, place.part)) + " " +
         text::printable_name(joint_name(staged, place));
}

}  // namespace

Result<TouchPlaces> TouchPlaces::make(const scene::StagedScene& staged) {
  TouchPlaces made;
  for (const scenes::Character& character : staged.scene.characters) {
    Result<scenes::TriangleLabels> labels = scenes::label_triangles(character.asset);
    if (!labels) return text::prefixed(character.source, labels.error());
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

void TouchCounts::add(std::uint32_t frame, std::uint64_t found) {
  contacts += found;
  ++frames;
  if (found <= worst) return;
  worst = found;
  worst_frame = frame;
}

std::uint32_t FrameTouches::add(std::uint32_t take, const TouchPlace& a, const TouchPlace& b) {
  touches_.push_back({{}, a, b, take});
  in_frame_.push_back(0);
  return static_cast<std::uint32_t>(touches_.size() - 1);
}

void FrameTouches::end_frame(std::uint32_t frame) {
  for (const std::uint32_t touch : counted_) {
    touches_[touch].add(frame, in_frame_[touch]);
    in_frame_[touch] = 0;
  }
  counted_.clear();
}

std::vector<Touch> FrameTouches::sorted() const {
  std::vector<Touch> touches = touches_;
  std::sort(touches.begin(), touches.end(), [](const Touch& x, const Touch& y) {
    return std::tie(y.contacts, x.take, x.a, x.b) < std::tie(x.contacts, y.take, y.a, y.b);
  });
  return touches;
}

Result<TouchTally> TouchTally::make(const scene::StagedScene& staged) {
  Result<TouchPlaces> places = TouchPlaces::make(staged);
  if (!places) return places.error();
  return TouchTally(staged, std::move(*places));
}

void TouchTally::add(std::uint32_t frame, const scene::FrameContacts& found) {
  start_take(scenes::take_index(staged_.scene, frame));
  for (const scene::FrameContacts::Pair& pair : found.pairs) count_pair(found, pair);
  for (const std::uint32_t touch : touches_.counted()) {
    joints_.touches.count(coarse_[touch].joints, touches_.in_frame(touch));
    parts_.touches.count(coarse_[touch].parts, touches_.in_frame(touch));
  }
  for (FrameTouches* const touches : {&touches_, &joints_.touches, &parts_.touches})
    touches->end_frame(frame);
}

void TouchTally::start_take(std::uint32_t take) {
  if (take == take_) return;
  take_ = take;
  in_take_.clear();
  joints_.in_take.clear();
  parts_.in_take.clear();
}

/// Most contacts are at the places of the contact before.
void TouchTally::count_pair(const scene::FrameContacts& found,
                            const scene::FrameContacts::Pair& pair) {
  const auto of_a = places_.of_instance(staged_.colliders[pair.a].instance);
  const auto of_b = places_.of_instance(staged_.colliders[pair.b].instance);
  std::uint32_t a = 0, b = 0;
  std::uint64_t contacts = 0;
  for (const Contact& contact : found.of(pair)) {
    const std::uint32_t next_a = of_a.number_at(contact.triangle_a);
    const std::uint32_t next_b = of_b.number_at(contact.triangle_b);
    if (contacts > 0 && (next_a != a || next_b != b)) count(a, b, std::exchange(contacts, 0));
    a = next_a;
    b = next_b;
    ++contacts;
  }
  if (contacts > 0) count(a, b, contacts);
}

/// Numbers of places ascend as the places do.
void TouchTally::count(std::uint32_t place, std::uint32_t other, std::uint64_t contacts) {
  const auto [a, b] = std::minmax(place, other);
  const auto [known, is_new] = in_take_.try_emplace(std::uint64_t{a} << 32 | b);
  if (is_new) known->second = add_touch(places_[a], places_[b]);
  touches_.count(known->second, contacts);
}

std::uint32_t TouchTally::add_touch(const TouchPlace& a, const TouchPlace& b) {
  coarse_.push_back({joints_.find_or_add(take_, {a.instance, 0, a.joint}, {b.instance, 0, b.joint}),
                     parts_.find_or_add(take_, {a.instance, a.part, 0}, {b.instance, b.part, 0})});
  return touches_.add(take_, a, b);
}

std::uint32_t TouchTally::CoarseTouches::find_or_add(std::uint32_t take, const TouchPlace& a,
                                                     const TouchPlace& b) {
  const auto places = std::minmax(a, b);
  const auto [known, is_new] = in_take.try_emplace(std::pair<TouchPlace, TouchPlace>(places));
  if (is_new) known->second = touches.add(take, places.first, places.second);
  return known->second;
}

std::vector<TouchTally::Row> TouchTally::joints() const {
  return rows(joints_.touches, &TouchPlace::joint,
              [&](std::uint32_t character, std::uint32_t joint) {
                return scenes::joint_name(staged_.scene.characters[character].asset, joint);
              });
}

std::vector<TouchTally::Row> TouchTally::parts() const {
  return rows(parts_.touches, &TouchPlace::part, [&](std::uint32_t character, std::uint32_t part) {
    return staged_.names->part(character, part);
  });
}

std::vector<TouchTally::Row> TouchTally::rows(const FrameTouches& touches,
                                              std::uint32_t TouchPlace::*index,
                                              const NameOf& name_of) const {
  const auto name_in = [&](const TouchPlace& place) {
    const std::uint32_t character = staged_.scene.instances[place.instance].character;
    return text::printable_name(name_of(character, place.*index));
  };
  const auto full_name = [&](const TouchPlace& place) {
    return instance_words(staged_, place.instance) + " " + name_in(place);
  };
  std::vector<Row> rows;
  const std::vector<scenes::Take>& takes = staged_.scene.takes;
  for (const Touch& touch : touches.sorted()) {
    const bool is_itself = is_of_itself(staged_, touch.a.instance, touch.b.instance);
    rows.push_back({touch, takes.empty() ? "" : text::quoted(takes[touch.take].clip),
                    full_name(touch.a),
                    is_itself ? kItself + name_in(touch.b) : full_name(touch.b)});
  }
  return rows;
}

std::optional<std::string> clip_name(const scenes::Scene& scene, std::uint32_t take) {
  if (scene.takes.empty()) return std::nullopt;
  return scene::as_json_holds(scene.takes[take].clip);
}

BodyName body_name(const scene::StagedScene& staged, const scene::Collider& collider) {
  BodyName name = instance_name(staged, collider.instance);
  if (collider.part)
    name.part = scene::as_json_holds(part_name(staged, collider.instance, *collider.part));
  return name;
}

TouchName touch_name(const scene::StagedScene& staged, const TouchPlace& place) {
  TouchName name = {instance_name(staged, place.instance),
                    scene::as_json_holds(joint_name(staged, place))};
  name.body.part = scene::as_json_holds(part_name(staged, place.instance, place.part));
  return name;
}

std::string instance_words(const scene::StagedScene& staged, std::uint32_t instance) {
  const std::uint32_t character = staged.scene.instances[instance].character;
  return text::printable_name(staged.scene.characters[character].name) + " " +
         std::to_string(instance);
}

bool is_of_itself(const scene::StagedScene& staged, std::uint32_t a, std::uint32_t b) {
  return a == b && !staged.colliders[0].part;
}

std::string in_words(const scene::StagedScene& staged, const TouchPlace& place) {
  return instance_words(staged, place.instance) + " " + words_in_instance(staged, place);
}

std::string touch_words(const scene::StagedScene& staged, const Touch& touch) {
  const bool is_itself = is_of_itself(staged, touch.a.instance, touch.b.instance);
  return in_words(staged, touch.a) + "  " +
         (is_itself ? kItself + words_in_instance(staged, touch.b) : in_words(staged, touch.b));
}

}  // namespace pelt::tools::check
