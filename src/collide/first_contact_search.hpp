#pragma once

/// The state of a search for the first contact: the earliest contact so far, and open items. Its
/// functions are compiled once, because code for several instruction sets calls them.

#include <pelt/motion.hpp>

#include "base/instruction_set.hpp"
#include "collide/search.hpp"
#include "collide/search_work.hpp"
#include "motion/meeting_order.hpp"
#include "motion/moving_tree.hpp"
#include "pose/pose.hpp"
#include "query/stack.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

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
/// last. Items that were pushed to be searched depth first come before all others.
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

/// The nodes of a motion that a search has needed so far, in each pose.
struct NeededNodes {
  NodeSet from, to;
};

struct FirstContactState {
  bool leave_out_start = false;
  std::uint32_t max_open = 0;
  TimeQueue open;
  std::optional<Contact> at_start;  ///< the lowest pair that intersects at time 0
  EarliestPair after_start;
  NeededNodes needed_a, needed_b;
  SearchWork work;

  /// Forgets all contacts, items and work. For trees of two motions.
  void clear(const Tree& a, const Tree& b);

  /// No later time matters.
  float latest() const;

  std::optional<MovingContact> earliest() const;
};

inline namespace PELT_INSTRUCTION_SET {

/// Starts a search: compares the root boxes, and adds the first item if they may overlap.
/// Precondition: the state is clear.
MovingStats start_first_contact(const MovingTree& a, const MovingTree& b, FirstContactState& state);

/// Makes steps until the granted work is done or nothing is open. Precondition: the state was
/// started with the same poses, which have not changed since.
MovingStats advance_first_contact(const MovingTree& a, const MovingTree& b,
                                  FirstContactState& state);

}  // namespace PELT_INSTRUCTION_SET

/// A search of two motions, whose poses a caller may change.
struct SearchOfMotions {
  SearchOfMotions(const Motion& a, const Motion& b)
      : poses{&a.from.detail(), &a.to.detail(), &b.from.detail(), &b.to.detail()} {}

  std::array<std::uint64_t, 4> current_stamps() const {
    return {poses[0]->stamp, poses[1]->stamp, poses[2]->stamp, poses[3]->stamp};
  }

  std::array<Pose*, 4> poses;                ///< both poses of `a`, then those of `b`
  std::array<std::uint64_t, 4> stamps = {};  ///< of the poses when the search was started
  FirstContactState state;
  MovingStats unreported;  ///< work of starting
};

}  // namespace pelt::detail
