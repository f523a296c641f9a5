/// Contacts of a pose with itself, and their filters.

#include <pelt/self.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "scenes/triangle_labels.hpp"

#include <array>
#include <span>

namespace pelt::wasm {
namespace {

/// Arrays that JavaScript writes before it makes a filter. Same order as in self.mjs.
enum FilterArray : std::uint32_t {
  kTakesPart,
  kAtRest,  // with the character's triangle numbers, like kAlways
  kAlways,
  kJointPairs,
  kGroups,
  kGroupPairs,
  kFilterArrays,
};

/// The memory of the arrays.
using FilterInput = std::array<std::vector<std::uint32_t>, kFilterArrays>;

FilterInput& filter_input() {
  static FilterInput input;
  return input;
}

/// The first number of an array is its size in bytes.
template <typename T>
std::span<T> elements(std::vector<std::uint32_t>& numbers) {
  if (numbers.empty()) return {};
  return {reinterpret_cast<T*>(numbers.data() + 1), numbers[0] / sizeof(T)};
}

/// Returns the pairs of two triangles of the body, numbered as in its model.
std::vector<Contact> pairs_in_model(std::span<const Contact> pairs, const Body& body) {
  const std::uint32_t begin = body.first_triangle;
  const std::uint32_t end = begin + body.model.triangle_count();
  const auto is_own = [&](std::uint32_t t) { return t >= begin && t < end; };
  std::vector<Contact> own;
  for (const auto& [a, b] : pairs)
    if (is_own(a) && is_own(b)) own.push_back({a - begin, b - begin});
  return own;
}

/// Returns the zones of the body's triangles, numbered as in its model.
std::vector<TriangleZone> zones_in_model(std::span<const TriangleZone> zones, const Body& body) {
  const std::uint32_t begin = body.first_triangle, count = body.model.triangle_count();
  std::vector<TriangleZone> own;
  for (const auto& [triangle, zone] : zones)
    if (triangle >= begin && triangle - begin < count) own.push_back({triangle - begin, zone});
  return own;
}

Result<SelfFilter> make_filter(const Character& character, const Body& body, std::uint32_t rings,
                               bool has_near_joints, FilterInput input) {
  const std::span<const IndexPair> listed = elements<IndexPair>(input[kJointPairs]);
  NearJoints near;
  if (has_near_joints) {
    const auto labels = scenes::label_triangles(character.asset());
    if (!labels) return labels.error();
    near = scenes::near_joints(character.asset(), labels->joint, elements<Contact>(input[kAtRest]));
  }
  near.joint_pairs.insert(near.joint_pairs.end(), listed.begin(), listed.end());
  SelfFilterOptions options;
  options.rings = rings;
  options.takes_part = elements<std::uint8_t>(input[kTakesPart]);
  const std::vector<Contact> at_rest = pairs_in_model(elements<Contact>(input[kAtRest]), body);
  const std::vector<Contact> always = pairs_in_model(elements<Contact>(input[kAlways]), body);
  options.at_rest = at_rest;
  options.always = always;
  options.joint_bodies = near.bodies;
  options.joint_pairs = near.joint_pairs;
  options.joint_pairs_in_zones = near.joint_pairs_in_zones;
  const std::vector<TriangleZone> zones = zones_in_model(near.zones, body);
  options.zones = zones;
  options.groups = elements<std::uint16_t>(input[kGroups]);
  options.group_pairs = elements<IndexPair>(input[kGroupPairs]);
  return build_self_filter(body.model, options);
}

}  // namespace

/// Returns where to write an array of `bytes`.
PELT_EXPORT void* pelt_self_filter_input(FilterArray array, std::uint32_t bytes) {
  std::vector<std::uint32_t>& numbers = filter_input()[array];
  numbers.assign(1 + (bytes + 3) / 4, bytes);
  return numbers.data() + 1;
}

/// Makes a filter from the arrays, which are released.
PELT_EXPORT std::uint32_t pelt_make_self_filter(const CharacterHandle* character,
                                                std::uint32_t part, std::uint32_t rings,
                                                std::uint32_t has_near_joints) {
  FilterInput input = std::exchange(filter_input(), {});
  const Result<Body*> body = character->character->body(part);
  if (!body) return refuse(body.error());
  Result<SelfFilter> filter =
      make_filter(*character->character, **body, rings, has_near_joints != 0, std::move(input));
  if (!filter) return refuse(filter.error());
  return address_of(new FilterHandle{character->character, std::move(*filter)});
}

PELT_EXPORT void pelt_delete_self_filter(FilterHandle* handle) { delete handle; }

/// Precondition, also of the next function: the filter is of the pose's body.
PELT_EXPORT void pelt_self_collide(PoseHandle* pose, const FilterHandle* filter,
                                   std::uint32_t most) {
  static std::vector<Contact> found;
  found.clear();
  const SelfStats stats = self_collide(pose->pose, filter->filter, scratch(), found, {most});
  answer_stats(stats);
  answer_left_out(stats.left_out);
  for (Contact& contact : found) {
    contact.triangle_a += pose->body.first_triangle;
    contact.triangle_b += pose->body.first_triangle;
  }
  answer_data<Contact>(found);
}

PELT_EXPORT std::uint32_t pelt_make_tally() { return address_of(new ContactTally); }
PELT_EXPORT void pelt_delete_tally(ContactTally* tally) { delete tally; }

/// Precondition: the pairs are ascending, without repetition.
PELT_EXPORT void pelt_tally_add(ContactTally* tally, const Contact* pairs, std::uint32_t count) {
  tally->add({pairs, count});
}

PELT_EXPORT std::uint32_t pelt_tally_pose_count(const ContactTally* tally) {
  return tally->pose_count();
}

PELT_EXPORT void pelt_tally_in_share(const ContactTally* tally, double share) {
  static std::vector<Contact> pairs;
  pairs = tally->in_share_of_poses(share);
  answer_data<Contact>(pairs);
}

PELT_EXPORT std::uint32_t pelt_self_intersects(PoseHandle* pose, const FilterHandle* filter) {
  return answer_yes_no(self_intersects(pose->pose, filter->filter, scratch()));
}

}  // namespace pelt::wasm
