#include "collide/search.hpp"

#include <pelt/search.hpp>

#include "base/assert.hpp"
#include "model/clusters.hpp"
#include "model/triangle_places.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pelt {
namespace {

/// Beyond `max_open`, the search is a depth-first descent (query/scratch.cpp), in which each step
/// adds at most one item for each slot of both nodes.
constexpr std::size_t kMostBeyond =
    std::size_t{3} * detail::kMaxClusterTreeDepth * 2 * detail::kMaxSlots;

}  // namespace

CollisionSearch::CollisionSearch(Pose& a, Pose& b, SearchOrder order, std::uint32_t max_open) {
  detail::require(&a != &b, "CollisionSearch: `a` and `b` are the same pose; give two poses");
  search_ = std::make_unique<detail::SearchOfPoses>(a.detail(), b.detail());
  search_->state.order = order;
  search_->state.max_open = max_open;
  restart();
}

CollisionSearch::CollisionSearch(CollisionSearch&&) noexcept = default;
CollisionSearch& CollisionSearch::operator=(CollisionSearch&&) noexcept = default;
CollisionSearch::~CollisionSearch() = default;

void CollisionSearch::reserve(std::size_t contacts) {
  search_->state.items.pool.reserve(search_->state.max_open + kMostBeyond);
  search_->state.found.reserve(contacts);
}

void CollisionSearch::restart() {
  detail::SearchOfPoses& s = *search_;
  s.unreported = start_search(s.a->posed_tree(), s.b->posed_tree(), s.state);
  s.stamp_a = s.a->stamp;
  s.stamp_b = s.b->stamp;
}

QueryStats CollisionSearch::advance(std::uint64_t work, Scratch& scratch) {
  PELT_ASSERT(!is_stale());
  detail::SearchOfPoses& s = *search_;
  QueryStats stats = std::exchange(s.unreported, {});
  if (is_complete() || is_stale()) return stats;
  s.state.work.grant(work);
  stats += advance_search(s.a->posed_tree(), s.b->posed_tree(), s.state);
  if (is_complete()) detail::sort_contacts(s.state.found, scratch.detail().sorting);
  stats.cut_short = !is_complete();
  return stats;
}

bool CollisionSearch::is_complete() const { return search_->state.items.count == 0; }

bool CollisionSearch::is_stale() const {
  return search_->stamp_a != search_->a->stamp || search_->stamp_b != search_->b->stamp;
}

Verdict CollisionSearch::verdict() const { return verdict_of(search_->state); }

std::span<const Contact> CollisionSearch::contacts() const {
  return {search_->state.found.begin(), search_->state.found.size()};
}

std::uint64_t CollisionSearch::undecided_pairs() const {
  return detail::undecided_pairs(search_->state, search_->tree_a(), search_->tree_b());
}

double CollisionSearch::resolution() const { return resolution_of(search_->state); }
double CollisionSearch::distance_bound() const { return detail::distance_bound(search_->state); }
std::uint64_t CollisionSearch::work_done() const { return search_->state.work.done; }
std::uint64_t CollisionSearch::longest_step() const { return search_->state.work.longest_step; }

void CollisionSearch::open_regions(std::vector<OpenRegion>& regions) const {
  append_open_regions(search_->state, search_->tree_a(), search_->tree_b(), regions);
}

}  // namespace pelt

namespace pelt::detail {
namespace {

std::uint64_t triangles_in(const Tree& tree, std::uint32_t index, unsigned slots) {
  const Node& node = tree.nodes[index];
  std::uint64_t count = 0;
  for (unsigned slot = 0; slot < unsigned{node.cluster_count} + node.child_count; ++slot)
    if (slots >> slot & 1) count += triangles_below(tree, node, slot);
  return count;
}

std::uint64_t pairs_of(const OpenItem& item, const Tree& a, const Tree& b) {
  return triangles_in(a, item.node_a, item.slots_a) * triangles_in(b, item.node_b, item.slots_b);
}

double longest_side(const OpenItem& item) {
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis)
    longest = std::max(longest, static_cast<double>(item.high[axis]) - item.low[axis]);
  return longest;
}

}  // namespace

Verdict verdict_of(const SearchState& state) {
  if (!state.found.empty()) return Verdict::touching;
  return state.items.count == 0 ? Verdict::apart : Verdict::unknown;
}

std::uint64_t undecided_pairs(const SearchState& state, const Tree& a, const Tree& b) {
  std::uint64_t pairs = 0;
  each_open(state.items, [&](const OpenItem& item) { pairs += pairs_of(item, a, b); });
  return pairs;
}

double resolution_of(const SearchState& state) {
  double longest = 0;
  each_open(state.items,
            [&](const OpenItem& item) { longest = std::max(longest, longest_side(item)); });
  return longest;
}

/// The squared distance was computed from rounded differences.
double distance_bound(const SearchState& state) {
  return state.found.empty() ? std::sqrt(state.squared_reach) * (1 + 0x1p-20) : 0;
}

void append_open_regions(const SearchState& state, const Tree& a, const Tree& b,
                         std::vector<OpenRegion>& regions) {
  each_open(state.items, [&](const OpenItem& item) {
    const Box region = {{item.low[0], item.low[1], item.low[2]},
                        {item.high[0], item.high[1], item.high[2]}};
    regions.push_back({region, item.depth, pairs_of(item, a, b)});
  });
}

}  // namespace pelt::detail
