#include "self/pair_filters.hpp"

#include "model/model.hpp"
#include "model/unpack.hpp"
#include "skin/main_joint.hpp"

#include <algorithm>
#include <span>

namespace pelt::detail {
namespace {

IndexPair ordered(std::uint16_t a, std::uint16_t b) {
  return a < b ? IndexPair{a, b} : IndexPair{b, a};
}

Contact ordered(const Contact& c) {
  return c.triangle_a < c.triangle_b ? c : Contact{c.triangle_b, c.triangle_a};
}

IndexPair ordered(const IndexPair& pair) { return ordered(pair.first, pair.second); }

/// Sorts pairs and removes repetitions.
template <typename Pair>
std::vector<Pair> as_set(std::vector<Pair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  pairs.shrink_to_fit();
  return pairs;
}

template <typename Pair>
std::vector<Pair> ordered_set(std::span<const Pair> pairs) {
  std::vector<Pair> set;
  set.reserve(pairs.size());
  for (const Pair& pair : pairs) set.push_back(ordered(pair));
  return as_set(std::move(set));
}

template <typename Pair>
bool contains(const std::vector<Pair>& set, const Pair& pair) {
  return std::binary_search(set.begin(), set.end(), pair);
}

/// The listed pairs, each joint with itself, and each joint with its parent.
std::vector<IndexPair> near_joints(const SelfFilterOptions& options) {
  std::vector<IndexPair> pairs = ordered_set(options.joint_pairs);
  const auto& parents = options.joint_parents;
  for (std::size_t joint = 0; joint < parents.size(); ++joint) {
    const auto number = static_cast<std::uint16_t>(joint);
    pairs.push_back({number, number});
    if (parents[joint] != kNoJoint) pairs.push_back(ordered(number, parents[joint]));
  }
  return as_set(std::move(pairs));
}

std::vector<std::uint32_t> index_fans(const Fans& fans) {
  std::vector<std::uint32_t> fan_of_vertex;
  for (std::uint32_t fan = 0; fan < fans.count(); ++fan) {
    const std::uint32_t vertex = fans.vertex_of(fan);
    if (vertex >= fan_of_vertex.size()) fan_of_vertex.resize(vertex + 1);
    fan_of_vertex[vertex] = fan;
  }
  return fan_of_vertex;
}

using Corners = std::array<std::uint32_t, 3>;

bool has_corner(const Corners& triangle, std::uint32_t vertex) {
  return vertex == triangle[0] || vertex == triangle[1] || vertex == triangle[2];
}

/// Adds the corners that are not in the ring.
void add_corners(Stack<std::uint32_t>& ring, const Corners& triangle) {
  for (const std::uint32_t vertex : triangle)
    if (std::find(ring.begin(), ring.end(), vertex) == ring.end()) ring.push(vertex);
}

/// Whether any of the vertices is a corner of the triangle.
bool reaches(Stack<std::uint32_t>& vertices, const Corners& triangle) {
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](std::uint32_t vertex) { return has_corner(triangle, vertex); });
}

}  // namespace

PairFilters::PairFilters(const SkinnedModel& model, const Fans& fans,
                         const SelfFilterOptions& options)
    : rings(options.rings),
      takes_part(options.takes_part.begin(), options.takes_part.end()),
      at_rest(ordered_set(options.at_rest)),
      always(ordered_set(options.always)),
      joint_pairs(near_joints(options)),
      groups(options.groups.begin(), options.groups.end()),
      group_pairs(ordered_set(options.group_pairs)) {
  if (rings > 1) fan_of_vertex = index_fans(fans);
  if (!joint_pairs.empty()) joints = main_joints(unpack_mesh(model.detail().tree));
}

LeftOutBy PairFilters::left_out_by(const Tree& tree, const Fans& fans, Contact pair,
                                   Stack<std::uint32_t>& ring) const {
  pair = ordered(pair);
  const auto [s, t] = pair;
  if (!takes_part.empty() && !(takes_part[s] && takes_part[t])) return LeftOutBy::takes_part;
  if (rings > 0 && are_within_rings(tree, fans, pair, ring)) return LeftOutBy::rings;
  if (contains(at_rest, pair)) return LeftOutBy::at_rest;
  if (contains(always, pair)) return LeftOutBy::always;
  if (!joints.empty() && contains(joint_pairs, ordered(joints[s], joints[t])))
    return LeftOutBy::joints;
  if (!groups.empty() && contains(group_pairs, ordered(groups[s], groups[t])))
    return LeftOutBy::groups;
  return LeftOutBy::none;
}

/// `ring` first contains the corners of one triangle. Each round adds the corners of all triangles
/// around the vertices that the round before has added. Tests of repetition compare all vertices of
/// the ring, which are few: rings are meant for nearby triangles.
bool PairFilters::are_within_rings(const Tree& tree, const Fans& fans, Contact pair,
                                   Stack<std::uint32_t>& ring) const {
  const Corners& from = fans.corners[tree.triangle_places[pair.triangle_a]];
  const Corners& to = fans.corners[tree.triangle_places[pair.triangle_b]];
  ring.clear();
  add_corners(ring, from);
  std::size_t begin = 0;
  for (std::uint32_t round = 1;; ++round) {
    if (reaches(ring, to)) return true;
    if (round == rings) return false;
    const std::size_t end = ring.size();
    for (; begin < end; ++begin)
      for (const FanTriangle& t : fans[fan_of_vertex[ring.begin()[begin]]])
        add_corners(ring, fans.corners[t.place()]);
    if (ring.size() == end) return false;
  }
}

}  // namespace pelt::detail
