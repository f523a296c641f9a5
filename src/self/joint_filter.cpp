#include "self/joint_filter.hpp"

#include "base/bytes_held.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "skin/main_joint.hpp"

#include <map>
#include <utility>

namespace pelt::detail {
namespace {

constexpr std::uint32_t kLowBits = 16;

/// Returns the number of a joint's body.
std::uint16_t body_of(const SelfFilterOptions& options, std::uint16_t joint) {
  return options.joint_bodies.empty() ? joint : options.joint_bodies[joint];
}

void add_pairs(std::span<const IndexPair> pairs, const SelfFilterOptions& options, PairSet& set) {
  for (const auto& [a, b] : pairs) set.add(body_of(options, a), body_of(options, b));
}

/// Adds each joint with itself, and each joint with its parent.
void add_hierarchy(const SelfFilterOptions& options, PairSet& set) {
  const auto& parents = options.joint_parents;
  for (std::size_t j = 0; j < parents.size(); ++j) {
    const std::uint16_t body = body_of(options, static_cast<std::uint16_t>(j));
    set.add(body, body);
    if (parents[j] != kNoJoint) set.add(body, body_of(options, parents[j]));
  }
}

/// Returns triangle and zone as one number each, ascending, without repetition.
std::vector<std::uint64_t> sorted(std::span<const TriangleZone> zones) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(zones.size());
  for (const auto& [triangle, zone] : zones)
    numbers.push_back(std::uint64_t{triangle} << kLowBits | zone);
  sort_unique(numbers);
  return numbers;
}

}  // namespace

JointFilter::JointFilter(const SkinnedModel& model, const SelfFilterOptions& options) {
  add_pairs(options.joint_pairs, options, pairs_);
  add_hierarchy(options, pairs_);
  pairs_.finish();
  add_pairs(options.joint_pairs_in_zones, options, pairs_in_zones_);
  pairs_in_zones_.finish();
  if (pairs_.empty() && pairs_in_zones_.empty()) return;
  std::vector<std::uint16_t> bodies = main_joints(unpack_mesh(model.detail().tree));
  for (std::uint16_t& joint : bodies) joint = body_of(options, joint);
  find_kinds(bodies, options.zones);
}

bool JointFilter::leaves_out(std::uint32_t s, std::uint32_t t) const {
  if (low_.empty()) return false;
  const Kind &a = kind_of(s), &b = kind_of(t);
  if (pairs_.contains(a.body, b.body)) return true;
  return share_zone(a, b) && pairs_in_zones_.contains(a.body, b.body);
}

std::size_t JointFilter::memory_bytes() const {
  return bytes_held(pairs_, pairs_in_zones_, low_, high_, kinds_, zones_);
}

void JointFilter::find_kinds(std::span<const std::uint16_t> bodies,
                             std::span<const TriangleZone> zones) {
  const std::vector<std::uint64_t> of_triangles = sorted(zones);
  std::map<std::pair<std::uint16_t, std::vector<std::uint16_t>>, std::uint32_t> numbers;
  low_.reserve(bodies.size());
  std::size_t next = 0;
  for (std::uint32_t t = 0; t < bodies.size(); ++t) {
    std::vector<std::uint16_t> own;
    for (; next < of_triangles.size() && of_triangles[next] >> kLowBits == t; ++next)
      own.push_back(static_cast<std::uint16_t>(of_triangles[next]));
    const auto count = static_cast<std::uint32_t>(kinds_.size());
    const auto [kind, is_new] = numbers.try_emplace({bodies[t], std::move(own)}, count);
    if (is_new) {
      const auto begin = static_cast<std::uint32_t>(zones_.size());
      zones_.insert(zones_.end(), kind->first.second.begin(), kind->first.second.end());
      kinds_.push_back({bodies[t], begin, static_cast<std::uint32_t>(zones_.size())});
    }
    low_.push_back(static_cast<std::uint16_t>(kind->second));
    if (kind->second >> kLowBits != 0) high_.resize(bodies.size());
    if (!high_.empty()) high_[t] = static_cast<std::uint16_t>(kind->second >> kLowBits);
  }
  kinds_.shrink_to_fit();
  zones_.shrink_to_fit();
}

const JointFilter::Kind& JointFilter::kind_of(std::uint32_t triangle) const {
  const std::uint32_t high = high_.empty() ? 0 : high_[triangle];
  return kinds_[high << kLowBits | low_[triangle]];
}

bool JointFilter::share_zone(const Kind& a, const Kind& b) const {
  std::uint32_t i = a.zones_begin, j = b.zones_begin;
  while (i < a.zones_end && j < b.zones_end) {
    if (zones_[i] == zones_[j]) return true;
    ++(zones_[i] < zones_[j] ? i : j);
  }
  return false;
}

}  // namespace pelt::detail
