#pragma once

/// The definition of the filters of self-collision, without regard to cost.

#include <pelt/self_filter.hpp>

#include "model/surface.hpp"
#include "self/self_brute_force.hpp"
#include "self/surface_shapes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace pelt::test {

/// The options with arrays behind them.
struct Options {
  std::uint32_t rings = 0;
  std::vector<std::uint8_t> takes_part;
  std::vector<Contact> at_rest, always;
  std::vector<std::uint16_t> joint_bodies, joint_parents;
  std::vector<IndexPair> joint_pairs, joint_pairs_in_zones;
  std::vector<TriangleZone> zones;
  std::vector<std::uint16_t> groups;
  std::vector<IndexPair> group_pairs;

  SelfFilterOptions view() const {
    return {.rings = rings,
            .takes_part = takes_part,
            .at_rest = at_rest,
            .always = always,
            .joint_bodies = joint_bodies,
            .joint_parents = joint_parents,
            .joint_pairs = joint_pairs,
            .joint_pairs_in_zones = joint_pairs_in_zones,
            .zones = zones,
            .groups = groups,
            .group_pairs = group_pairs};
  }
};

/// Decides which filter leaves out a pair, straight from the definitions.
class Classification {
 public:
  Classification(const Shape& shape, const Options& options) : options_(options) {
    const std::vector<std::uint32_t> surface = surface_vertices(shape);
    for (const Triangle& t : shape.triangles) {
      corners_.push_back({surface[t[0]], surface[t[1]], surface[t[2]]});
    }
    // If the sums of weights of two joints are nearly equal, rounding decides which one is the main
    // joint. The test therefore reads the main joints from the library.
    main_joints_ = build_model(shape.view())->surface().detail().joints;
    neighbours_.resize(corners_.size());
    for (std::uint32_t s = 0; s < corners_.size(); ++s)
      for (std::uint32_t t = 0; t < corners_.size(); ++t)
        if (share(s, t)) neighbours_[s].push_back(t);
  }

  LeftOutBy by(std::uint32_t s, std::uint32_t t) {
    const auto& o = options_;
    if (!o.takes_part.empty() && (o.takes_part[s] == 0 || o.takes_part[t] == 0))
      return LeftOutBy::takes_part;
    if (o.rings > 0 && steps_from(s)[t] <= o.rings) return LeftOutBy::rings;
    if (lists(o.at_rest, s, t)) return LeftOutBy::at_rest;
    if (lists(o.always, s, t)) return LeftOutBy::always;
    if (are_near(main_joints_[s], main_joints_[t], share_zone(s, t))) return LeftOutBy::joints;
    if (!o.groups.empty() && lists(o.group_pairs, o.groups[s], o.groups[t]))
      return LeftOutBy::groups;
    return LeftOutBy::none;
  }

 private:
  template <typename Pair>
  static bool lists(const std::vector<Pair>& pairs, std::uint32_t a, std::uint32_t b) {
    return std::any_of(pairs.begin(), pairs.end(), [&](const Pair& pair) {
      const auto& [first, second] = pair;
      return (first == a && second == b) || (first == b && second == a);
    });
  }

  bool share_zone(std::uint32_t s, std::uint32_t t) const {
    std::set<std::uint16_t> zones_of_s;
    for (const TriangleZone& z : options_.zones)
      if (z.triangle == s) zones_of_s.insert(z.zone);
    return std::any_of(options_.zones.begin(), options_.zones.end(), [&](const TriangleZone& z) {
      return z.triangle == t && zones_of_s.count(z.zone) > 0;
    });
  }

  /// Whether any joints of the two joints' bodies are near.
  bool are_near(std::uint16_t a, std::uint16_t b, bool in_zone) const {
    const auto& bodies = options_.joint_bodies;
    if (bodies.empty()) return are_near_alone(a, b, in_zone);
    for (std::uint16_t c = 0; c < bodies.size(); ++c)
      for (std::uint16_t d = 0; d < bodies.size(); ++d)
        if (bodies[c] == bodies[a] && bodies[d] == bodies[b] && are_near_alone(c, d, in_zone))
          return true;
    return false;
  }

  bool are_near_alone(std::uint16_t a, std::uint16_t b, bool in_zone) const {
    const auto& parents = options_.joint_parents;
    return lists(options_.joint_pairs, a, b) ||
           (in_zone && lists(options_.joint_pairs_in_zones, a, b)) ||
           (!parents.empty() && (a == b || parents[a] == b || parents[b] == a));
  }

  /// The number of steps to each triangle, from neighbour to neighbour.
  const std::vector<std::uint32_t>& steps_from(std::uint32_t s) {
    if (s == from_ && !steps_.empty()) return steps_;
    from_ = s;
    steps_.assign(corners_.size(), UINT32_MAX);
    steps_[s] = 0;
    std::vector<std::uint32_t> queue = {s};
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const std::uint32_t t : neighbours_[queue[i]])
        if (steps_[t] == UINT32_MAX) {
          steps_[t] = steps_[queue[i]] + 1;
          queue.push_back(t);
        }
    return steps_;
  }

  bool share(std::uint32_t s, std::uint32_t t) const {
    for (const std::uint32_t v : corners_[s])
      for (const std::uint32_t w : corners_[t])
        if (v == w) return true;
    return false;
  }

  const Options& options_;
  std::vector<std::array<std::uint32_t, 3>> corners_;
  std::vector<std::uint16_t> main_joints_;
  std::vector<std::vector<std::uint32_t>> neighbours_;
  std::uint32_t from_ = 0;
  std::vector<std::uint32_t> steps_;
};

}  // namespace pelt::test
