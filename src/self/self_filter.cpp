#include "self/self_filter.hpp"

#include "base/assert.hpp"
#include "base/bytes_held.hpp"
#include "base/problem.hpp"
#include "query/scratch.hpp"
#include "self/grid_boxes.hpp"

#include <algorithm>
#include <utility>

namespace pelt {
namespace detail {
namespace {

Problem check_size(const char* name, std::size_t size, std::size_t expected) {
  if (size == 0 || size == expected) return {};
  return problem("%s has %zu elements, expected %zu or none", name, size, expected);
}

Problem check_pairs(const char* name, std::span<const Contact> pairs, std::uint32_t count) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [s, t] = pairs[i];
    if (s >= count || t >= count)
      return problem("%s[%zu] refers to triangle %u, but the model has %u triangles", name, i,
                     s >= count ? s : t, count);
  }
  return {};
}

Problem check_joint(const char* name, std::size_t i, std::uint32_t joint, std::uint32_t count) {
  if (joint < count) return {};
  return problem("%s[%zu] refers to joint %u, but the model has %u joints", name, i, joint, count);
}

Problem check_joint_pairs(const char* name, std::span<const IndexPair> pairs, std::uint32_t count) {
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (const std::uint16_t joint : {pairs[i].first, pairs[i].second})
      if (Problem found = check_joint(name, i, joint, count); !found.empty()) return found;
  return {};
}

Problem check_joints(const SelfFilterOptions& options, std::uint32_t count) {
  for (std::size_t i = 0; i < options.joint_parents.size(); ++i)
    if (const std::uint16_t parent = options.joint_parents[i]; parent != kNoJoint)
      if (Problem found = check_joint("joint_parents", i, parent, count); !found.empty())
        return found;
  Problem found = check_joint_pairs("joint_pairs", options.joint_pairs, count);
  if (!found.empty()) return found;
  return check_joint_pairs("joint_pairs_in_zones", options.joint_pairs_in_zones, count);
}

Problem check_zones(std::span<const TriangleZone> zones, std::uint32_t count) {
  for (std::size_t i = 0; i < zones.size(); ++i)
    if (zones[i].triangle >= count)
      return problem("zones[%zu] refers to triangle %u, but the model has %u triangles", i,
                     zones[i].triangle, count);
  return {};
}

Problem check_options(const SkinnedModel& model, const SelfFilterOptions& options) {
  const std::uint32_t triangles = model.triangle_count(), joints = model.joint_count();
  if (triangles > kMaxFanTriangles)
    return problem("the model has %u triangles; self-collision supports at most 2^28", triangles);
  if (options.rings > kMaxRings)
    return problem("rings is %u, expected 0 to %u", options.rings, kMaxRings);
  if (options.groups.empty() && !options.group_pairs.empty())
    return problem("group_pairs needs groups");
  Problem found = check_size("takes_part", options.takes_part.size(), triangles);
  if (found.empty()) found = check_size("groups", options.groups.size(), triangles);
  if (found.empty()) found = check_size("joint_bodies", options.joint_bodies.size(), joints);
  if (found.empty()) found = check_size("joint_parents", options.joint_parents.size(), joints);
  if (found.empty()) found = check_pairs("at_rest", options.at_rest, triangles);
  if (found.empty()) found = check_pairs("always", options.always, triangles);
  if (found.empty()) found = check_zones(options.zones, triangles);
  if (found.empty()) found = check_joints(options, joints);
  return found;
}

std::uint64_t& counter_of(LeftOut& left_out, LeftOutBy by) {
  switch (by) {
    case LeftOutBy::takes_part:
      return left_out.takes_part;
    case LeftOutBy::rings:
      return left_out.rings;
    case LeftOutBy::at_rest:
      return left_out.at_rest;
    case LeftOutBy::always:
      return left_out.always;
    case LeftOutBy::joints:
      return left_out.joints;
    case LeftOutBy::groups:
    case LeftOutBy::none:
      break;
  }
  return left_out.groups;
}

/// Returns false, and counts the pair, if the filter leaves it out.
bool keeps_pair(const SelfFilter& filter, const Contact& pair, Stack<std::uint32_t>& ring,
                LeftOut& left_out) {
  const LeftOutBy by = filter.filters.left_out_by(filter.tree(), filter.fans, pair, ring);
  if (by != LeftOutBy::none) ++counter_of(left_out, by);
  return by == LeftOutBy::none;
}

}  // namespace

bool keeps(const SelfFilter& filter, Contact& contact, Stack<std::uint32_t>& ring,
           LeftOut& left_out) {
  if (contact.triangle_b < contact.triangle_a) std::swap(contact.triangle_a, contact.triangle_b);
  return keeps_pair(filter, contact, ring, left_out);
}

bool keeps(const SelfFilter& filter, const MovingContact& contact, Stack<std::uint32_t>& ring,
           LeftOut& left_out) {
  PELT_ASSERT(contact.contact.triangle_a < contact.contact.triangle_b);
  return keeps_pair(filter, contact.contact, ring, left_out);
}

}  // namespace detail

LeftOut& LeftOut::operator+=(const LeftOut& other) {
  takes_part += other.takes_part;
  rings += other.rings;
  at_rest += other.at_rest;
  always += other.always;
  joints += other.joints;
  groups += other.groups;
  return *this;
}

SelfFilter::SelfFilter(std::shared_ptr<const detail::SelfFilter> filter)
    : filter_(std::move(filter)) {}

const SkinnedModel& SelfFilter::model() const { return filter_->model; }

LeftOutBy SelfFilter::left_out_by(std::uint32_t s, std::uint32_t t) const {
  PELT_ASSERT(s != t && s < model().triangle_count() && t < model().triangle_count());
  detail::Stack<std::uint32_t> ring;
  return filter_->filters.left_out_by(filter_->tree(), filter_->fans, {s, t}, ring);
}

SelfScratchSize SelfFilter::scratch_size() const {
  const detail::Tree& tree = filter_->tree();
  return {tree.rest_positions.size(), detail::grid_box_bytes(tree.clusters.size()),
          tree.triangle_count()};
}

std::size_t SelfFilter::memory_bytes() const {
  const auto& [model, fans, masks, filters] = *filter_;
  return sizeof(detail::SelfFilter) +
         detail::bytes_held(fans.corners, fans.runs, fans.triangles, masks.begin, masks.masks,
                            masks.others, masks.cluster_nodes, masks.has_hub) +
         detail::bytes_held(masks.near_begin, masks.near_nodes, masks.near_slots) +
         detail::bytes_held(filters.fan_of_vertex, filters.at_rest, filters.always, filters.groups,
                            filters.group_pairs) +
         filters.joints.memory_bytes() + filters.takes_part.capacity() / 8;
}

LeftOut leave_out(const SelfFilter& filter, Scratch& scratch, std::vector<Contact>& contacts) {
  detail::Stack<std::uint32_t>& ring = scratch.detail().ring;
  ring.clear();
  LeftOut left_out;
  std::size_t kept = 0;
  for (Contact contact : contacts)
    if (keeps(filter.detail(), contact, ring, left_out)) contacts[kept++] = contact;
  contacts.resize(kept);
  return left_out;
}

Result<SelfFilter> build_self_filter(const SkinnedModel& model, const SelfFilterOptions& options) {
  if (detail::Problem found = detail::check_options(model, options); !found.empty())
    return detail::invalid_argument(std::move(found));
  return SelfFilter(std::make_shared<const detail::SelfFilter>(model, options));
}

struct ContactTally::Tally {
  struct Count {
    Contact pair;
    std::uint32_t poses;
  };

  std::vector<Count> counts, merged;  // ascending by pair
  std::uint32_t pose_count = 0;
};

ContactTally::ContactTally() : tally_(std::make_unique<Tally>()) {}
ContactTally::ContactTally(ContactTally&&) noexcept = default;
ContactTally& ContactTally::operator=(ContactTally&&) noexcept = default;
ContactTally::~ContactTally() = default;

void ContactTally::add(std::span<const Contact> contacts) {
  PELT_ASSERT(std::is_sorted(contacts.begin(), contacts.end()));
  auto& [counts, merged, pose_count] = *tally_;
  merged.clear();
  merged.reserve(counts.size() + contacts.size());
  auto known = counts.begin();
  for (const Contact& contact : contacts) {
    for (; known != counts.end() && known->pair < contact; ++known) merged.push_back(*known);
    const bool is_known = known != counts.end() && known->pair == contact;
    merged.push_back({contact, is_known ? (known++)->poses + 1 : 1});
  }
  merged.insert(merged.end(), known, counts.end());
  std::swap(counts, merged);
  ++pose_count;
}

std::uint32_t ContactTally::pose_count() const { return tally_->pose_count; }

std::vector<Contact> ContactTally::in_share_of_poses(double share) const {
  std::vector<Contact> pairs;
  const double pose_count = tally_->pose_count;
  // A quotient is rounded like the literal: 55 of 100 poses are a share of 0.55.
  for (const Tally::Count& count : tally_->counts)
    if (count.poses / pose_count >= share) pairs.push_back(count.pair);
  return pairs;
}

}  // namespace pelt
