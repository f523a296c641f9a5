/// Contacts of a pose with itself, and their filters.

#include <pelt/self.hpp>

#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "scenes/triangle_labels.hpp"

#include <span>

namespace pelt::wasm {
namespace {

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

/// Arrays for a filter, in the order of self.mjs. `at_rest` and `always` have the character's
/// triangle numbers.
struct FilterArrays {
  std::span<const std::uint8_t> takes_part;
  std::span<const Contact> at_rest, always;
  std::span<const IndexPair> joint_pairs;
  std::span<const std::uint16_t> groups;
  std::span<const IndexPair> group_pairs;
};

Result<SelfFilter> make_filter(const Character& character, const Body& body, std::uint32_t rings,
                               bool has_near_joints, const FilterArrays& arrays) {
  NearJoints near;
  if (has_near_joints) {
    const auto labels = scenes::label_triangles(character.asset());
    if (!labels) return labels.error();
    near = scenes::near_joints(character.asset(), labels->joint, arrays.at_rest);
  }
  near.joint_pairs.insert(near.joint_pairs.end(), arrays.joint_pairs.begin(),
                          arrays.joint_pairs.end());
  SelfFilterOptions options;
  options.rings = rings;
  options.takes_part = arrays.takes_part;
  const std::vector<Contact> at_rest = pairs_in_model(arrays.at_rest, body);
  const std::vector<Contact> always = pairs_in_model(arrays.always, body);
  options.at_rest = at_rest;
  options.always = always;
  options.joint_bodies = near.bodies;
  options.joint_pairs = near.joint_pairs;
  options.joint_pairs_in_zones = near.joint_pairs_in_zones;
  const std::vector<TriangleZone> zones = zones_in_model(near.zones, body);
  options.zones = zones;
  options.groups = arrays.groups;
  options.group_pairs = arrays.group_pairs;
  return build_self_filter(body.model, options);
}

}  // namespace

Result<FilterHandle*> make_self_filter(
    const CharacterHandle& handle, std::uint32_t part, std::uint32_t rings, bool has_near_joints,
    std::span<const std::uint8_t> takes_part, std::span<const Contact> at_rest,
    std::span<const Contact> always, std::span<const IndexPair> joint_pairs,
    std::span<const std::uint16_t> groups, std::span<const IndexPair> group_pairs) {
  const Result<Body*> body = handle.character->body(part);
  if (!body) return body.error();
  Result<SelfFilter> filter =
      make_filter(*handle.character, **body, rings, has_near_joints,
                  {takes_part, at_rest, always, joint_pairs, groups, group_pairs});
  if (!filter) return filter.error();
  return new FilterHandle{handle.character, std::move(*filter)};
}
PELT_EXPORT(make_self_filter)

void delete_self_filter(FilterHandle* handle) { delete handle; }
PELT_EXPORT(delete_self_filter)

/// Precondition, also of the next function: the filter is of the pose's body.
SelfStats self_collide(PoseHandle& pose, const FilterHandle& filter, std::uint32_t most) {
  static std::vector<Contact> found;
  found.clear();
  const SelfStats stats = self_collide(pose.pose, filter.filter, scratch(), found, {most});
  answer_pairs(found, pose.body.first_triangle, pose.body.first_triangle);
  return stats;
}
PELT_EXPORT(self_collide)

YesNo self_intersects(PoseHandle& pose, const FilterHandle& filter) {
  return self_intersects(pose.pose, filter.filter, scratch());
}
PELT_EXPORT(self_intersects)

ContactTally* make_tally() { return new ContactTally; }
PELT_EXPORT(make_tally)

void delete_tally(ContactTally* tally) { delete tally; }
PELT_EXPORT(delete_tally)

/// Precondition: the pairs are ascending, without repetition.
void tally_add(ContactTally& tally, std::span<const Contact> pairs) { tally.add(pairs); }
PELT_EXPORT(tally_add)

std::uint32_t tally_pose_count(const ContactTally& tally) { return tally.pose_count(); }
PELT_EXPORT(tally_pose_count)

void tally_in_share(const ContactTally& tally, double share) {
  static std::vector<Contact> pairs;
  pairs = tally.in_share_of_poses(share);
  answer_arrays(pairs);
}
PELT_EXPORT(tally_in_share)

}  // namespace pelt::wasm
