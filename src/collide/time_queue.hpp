#pragma once

#include "collide/search_state.hpp"
#include "query/stack.hpp"

#include <cstddef>
#include <cstdint>

namespace pelt::detail {

/// Slots of a node of `a` and slots of a node of `b` whose triangles have not been compared yet.
/// The step `test` has one cluster of each.
struct TimedItem {
  float start, end;  ///< times outside which the triangles certainly do not intersect
  float depth;       ///< by which the boxes of the two nodes overlap at time 0
  std::uint32_t node_a, node_b;
  std::uint8_t slots_a, slots_b;  ///< one bit per slot
  ItemStep step;
  std::uint64_t birth;  ///< when the item was pushed
};

/// Open items. The item of the earliest start is next; of equal starts, the one that was pushed
/// last. Items that were pushed to be searched depth first come before all others. The functions
/// are compiled once, because code for several instruction sets calls them.
class TimeQueue {
 public:
  void clear();

  /// Makes room for `items` items, and for `depth_first` items to be searched depth first.
  void reserve(std::size_t items, std::size_t depth_first);

  bool is_empty() const { return by_start_.empty() && depth_first_.empty(); }
  std::size_t size() const { return by_start_.size() + depth_first_.size(); }

  void push(const TimedItem& item);
  void push_depth_first(const TimedItem& item);

  /// Precondition: not empty.
  TimedItem pop();

  /// Removes the next item as long as it starts after `latest`.
  void drop_after(float latest);

  /// The earliest start of any item; 1 if there is none.
  float earliest_start() const;

 private:
  Stack<TimedItem> by_start_;  // a heap
  Stack<TimedItem> depth_first_;
  std::uint64_t births_ = 0;
};

}  // namespace pelt::detail
