#include "collide/time_queue.hpp"

#include <algorithm>

namespace pelt::detail {
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
