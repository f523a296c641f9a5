#include "self/pair_filters.hpp"

#include "base/bytes_held.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace pelt::detail {

void sort_unique(std::vector<std::uint64_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

void PairSet::finish() {
  sort_unique(pairs_);
  pairs_.shrink_to_fit();
}

bool PairSet::contains(std::uint32_t a, std::uint32_t b) const {
  return std::binary_search(pairs_.begin(), pairs_.end(), packed(a, b));
}

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

namespace {

PairSet set_of(std::span<const Contact> pairs) {
  PairSet set;
  set.reserve(pairs.size());
  for (const Contact& pair : pairs) set.add(pair.triangle_a, pair.triangle_b);
  set.finish();
  return set;
}

PairSet set_of(std::span<const IndexPair> pairs) {
  PairSet set;
  for (const IndexPair& pair : pairs) set.add(pair.first, pair.second);
  set.finish();
  return set;
}

std::vector<std::uint32_t> index_fans(const Fans& fans) {
  std::vector<std::uint32_t> fan_of_vertex;
  for (std::uint32_t fan = 0; fan < fans.count(); ++fan) {
    const std::uint32_t vertex = fans.vertex_of(fan);
    if (vertex >= fan_of_vertex.size()) fan_of_vertex.resize(vertex + 1);
    fan_of_vertex[vertex] = fan;
  }
  fan_of_vertex.shrink_to_fit();
  return fan_of_vertex;
}

/// A set of surface vertices, in memory that is used for one set after the other: the number of
/// this set, for each vertex the number of the last set that contained it, and the vertices of this
/// set.
class VertexSet {
 public:
  /// `memory`: empty, or used for the last set of vertices below `vertex_count`.
  VertexSet(Stack<std::uint32_t>& memory, std::size_t vertex_count)
      : memory_(memory), first_(vertex_count + 1) {
    constexpr std::uint32_t kLastNumber = UINT32_MAX;
    if (memory.empty() || memory.begin()[0] == kLastNumber) {
      memory.clear();
      for (std::size_t i = 0; i < first_; ++i) memory.push(0);
    }
    memory.shrink(first_);
    number_ = ++memory.begin()[0];
  }

  std::size_t size() const { return memory_.size() - first_; }
  std::uint32_t operator[](std::size_t i) const { return memory_.begin()[first_ + i]; }

  void add(std::uint32_t vertex) {
    std::uint32_t& last_number = memory_.begin()[1 + vertex];
    if (last_number == number_) return;
    last_number = number_;
    memory_.push(vertex);
  }

 private:
  Stack<std::uint32_t>& memory_;
  std::size_t first_;
  std::uint32_t number_;
};

}  // namespace

PairFilters::PairFilters(const SkinnedModel& model, const Fans& fans,
                         const SelfFilterOptions& options)
    : rings(options.rings),
      takes_part(options.takes_part.begin(), options.takes_part.end()),
      at_rest(set_of(options.at_rest)),
      always(set_of(options.always)),
      joints(model, options),
      groups(options.groups.begin(), options.groups.end()),
      group_pairs(set_of(options.group_pairs)) {
  if (rings > 1) fan_of_vertex = index_fans(fans);
}

LeftOutBy PairFilters::left_out_by(const Tree& tree, const Fans& fans, Contact pair,
                                   Stack<std::uint32_t>& ring) const {
  const auto [s, t] = pair;
  if (!takes_part.empty() && !(takes_part[s] && takes_part[t])) return LeftOutBy::takes_part;
  if (rings > 0 && are_within_rings(tree, fans, pair, ring)) return LeftOutBy::rings;
  if (at_rest.contains(s, t)) return LeftOutBy::at_rest;
  if (always.contains(s, t)) return LeftOutBy::always;
  if (joints.leaves_out(s, t)) return LeftOutBy::joints;
  if (!groups.empty() && group_pairs.contains(groups[s], groups[t])) return LeftOutBy::groups;
  return LeftOutBy::none;
}

/// The set first contains the corners of one triangle. Each round adds the corners of all triangles
/// around the vertices that the round before has added.
bool PairFilters::are_within_rings(const Tree& tree, const Fans& fans, Contact pair,
                                   Stack<std::uint32_t>& ring) const {
  const SurfaceCorners& from = fans.corners[tree.triangle_places[pair.triangle_a]];
  const SurfaceCorners& to = fans.corners[tree.triangle_places[pair.triangle_b]];
  if (share_corner(from, to)) return true;
  if (rings == 1) return false;
  VertexSet near(ring, fan_of_vertex.size());
  for (const std::uint32_t vertex : from) near.add(vertex);
  std::size_t begin = 0;
  for (std::uint32_t round = 2; round <= rings && begin < near.size(); ++round)
    for (const std::size_t end = near.size(); begin < end; ++begin)
      for (const FanTriangle& t : fans[fan_of_vertex[near[begin]]])
        for (const std::uint32_t vertex : fans.corners[t.place()]) {
          if (has_corner(to, vertex)) return true;
          near.add(vertex);
        }
  return false;
}

}  // namespace pelt::detail
