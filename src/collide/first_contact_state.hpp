#pragma once

/// The state of a search for the first contact: the earliest contact so far, and open items. Its
/// functions are compiled once, because code for several instruction sets calls them.

#include <pelt/motion.hpp>

#include "collide/needed_nodes.hpp"
#include "collide/search_work.hpp"
#include "collide/time_queue.hpp"
#include "motion/earliest_pair.hpp"

#include <cstdint>
#include <optional>

namespace pelt::detail {

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

}  // namespace pelt::detail
