#include "tools/pelt/check/touch_tally.hpp"

#include "asset/printable.hpp"
#include "scenes/names.hpp"
#include "scenes/takes.hpp"
#include "tools/pelt/check/touch_name.hpp"

#include <algorithm>
#include <utility>

namespace pelt::tools::check {

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
    return asset::printable_name(name_of(character, place.*index));
  };
  const auto full_name = [&](const TouchPlace& place) {
    return instance_words(staged_, place.instance) + " " + name_in(place);
  };
  std::vector<Row> rows;
  const std::vector<scenes::Take>& takes = staged_.scene.takes;
  for (const Touch& touch : touches.sorted()) {
    const bool is_itself = is_of_itself(staged_, touch.a.instance, touch.b.instance);
    rows.push_back({touch, takes.empty() ? "" : asset::quoted(takes[touch.take].clip),
                    full_name(touch.a),
                    is_itself ? kItself + name_in(touch.b) : full_name(touch.b)});
  }
  return rows;
}

}  // namespace pelt::tools::check
