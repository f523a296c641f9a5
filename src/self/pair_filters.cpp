#include "self/pair_filters.hpp"

#include <algorithm>
#include <span>

namespace pelt::detail {
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
