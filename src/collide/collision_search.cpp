#include <pelt/search.hpp>

#include "base/assert.hpp"
#include "base/require.hpp"
#include "collide/search_answers.hpp"
#include "collide/search_of_poses.hpp"
#include "collide/search_steps.hpp"
#include "model/clusters.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"

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
