#include "collide/first_contact_search.hpp"

#include <pelt/search.hpp>

#include "base/assert.hpp"
#include "model/clusters.hpp"
#include "motion/moving_tree.hpp"

#include <algorithm>
#include <utility>

namespace pelt {
namespace {

/// Beyond `max_open`, the search is a depth-first descent (query/scratch.cpp), in which each step
/// adds at most one item for each pair of slots.
constexpr std::size_t kMostDepthFirst =
    std::size_t{3} * detail::kMaxClusterTreeDepth * detail::kMaxSlots * detail::kMaxSlots;

/// Calls `run(a, b)` with views of both motions.
template <typename Run>
MovingStats with_views(const detail::SearchOfMotions& search, const Run& run) {
  const auto view = [&](std::size_t i) { return search.poses[i]->posed_tree(); };
  const detail::PosedTree from_a = view(0), to_a = view(1), from_b = view(2), to_b = view(3);
  return run(detail::MovingTree(from_a, to_a), detail::MovingTree(from_b, to_b));
}

}  // namespace

FirstContactSearch::FirstContactSearch(const Motion& a, const Motion& b,
                                       const MovingOptions& options, std::uint32_t max_open) {
  detail::require_steps(a, b);
  search_ = std::make_unique<detail::SearchOfMotions>(a, b);
  search_->state.leave_out_start = options.leave_out_start;
  search_->state.max_open = max_open;
  restart();
}

FirstContactSearch::FirstContactSearch(FirstContactSearch&&) noexcept = default;
FirstContactSearch& FirstContactSearch::operator=(FirstContactSearch&&) noexcept = default;
FirstContactSearch::~FirstContactSearch() = default;

void FirstContactSearch::reserve() {
  search_->state.open.reserve(search_->state.max_open, kMostDepthFirst);
}

void FirstContactSearch::restart() {
  detail::SearchOfMotions& s = *search_;
  s.state.clear(s.poses[0]->model.detail().tree, s.poses[2]->model.detail().tree);
  s.unreported = with_views(s, [&](const detail::MovingTree& a, const detail::MovingTree& b) {
    return start_first_contact(a, b, s.state);
  });
  s.stamps = s.current_stamps();
}

MovingStats FirstContactSearch::advance(std::uint64_t work) {
  PELT_ASSERT(!is_stale());
  detail::SearchOfMotions& s = *search_;
  MovingStats stats = std::exchange(s.unreported, {});
  if (is_complete() || is_stale()) return stats;
  s.state.work.grant(work);
  stats += with_views(s, [&](const detail::MovingTree& a, const detail::MovingTree& b) {
    return advance_first_contact(a, b, s.state);
  });
  stats.cut_short = !is_complete();
  return stats;
}

bool FirstContactSearch::is_complete() const { return search_->state.open.is_empty(); }

bool FirstContactSearch::is_stale() const { return search_->stamps != search_->current_stamps(); }

Verdict FirstContactSearch::verdict() const {
  if (earliest()) return Verdict::touching;
  return is_complete() ? Verdict::apart : Verdict::unknown;
}

float FirstContactSearch::apart_until() const {
  const float start = search_->state.open.earliest_start();
  const std::optional<MovingContact> first = earliest();
  return first ? std::min(start, first->time) : start;
}

std::optional<MovingContact> FirstContactSearch::earliest() const {
  return search_->state.earliest();
}

std::uint64_t FirstContactSearch::work_done() const { return search_->state.work.done; }
std::uint64_t FirstContactSearch::longest_step() const { return search_->state.work.longest_step; }

}  // namespace pelt

namespace pelt::detail {

void FirstContactState::clear(const Tree& a, const Tree& b) {
  open.clear();
  at_start.reset();
  after_start = {};
  work = {};
  clear_needed(needed_a.from, a);
  clear_needed(needed_a.to, a);
  clear_needed(needed_b.from, b);
  clear_needed(needed_b.to, b);
}

float FirstContactState::latest() const { return at_start ? 0 : after_start.latest(); }

std::optional<MovingContact> FirstContactState::earliest() const {
  if (at_start) return MovingContact{*at_start, 0, true, {}, {}};
  return after_start.contact();
}

namespace {

/// Whether `a` is searched after `b`. No two items are equal.
bool is_later(const TimedItem& a, const TimedItem& b) {
  return a.start != b.start ? a.start > b.start : a.birth < b.birth;
}

}  // namespace

void TimeQueue::clear() {
  by_start_.clear();
  depth_first_.clear();
  births_ = 0;
}

void TimeQueue::reserve(std::size_t items, std::size_t depth_first) {
  by_start_.reserve(items);
  depth_first_.reserve(depth_first);
}

void TimeQueue::push(const TimedItem& item) {
  by_start_.push(item);
  by_start_.end()[-1].birth = births_++;
  std::push_heap(by_start_.begin(), by_start_.end(), is_later);
}

void TimeQueue::push_depth_first(const TimedItem& item) { depth_first_.push(item); }

TimedItem TimeQueue::pop() {
  if (!depth_first_.empty()) return depth_first_.pop();
  std::pop_heap(by_start_.begin(), by_start_.end(), is_later);
  return by_start_.pop();
}

void TimeQueue::drop_after(float latest) {
  while (!depth_first_.empty() && depth_first_.end()[-1].start > latest) depth_first_.pop();
  if (depth_first_.empty() && !by_start_.empty() && by_start_.begin()->start > latest)
    by_start_.clear();
}

float TimeQueue::earliest_start() const {
  float earliest = by_start_.empty() ? 1 : by_start_.begin()->start;
  for (const TimedItem& item : depth_first_) earliest = std::min(earliest, item.start);
  return earliest;
}

}  // namespace pelt::detail
