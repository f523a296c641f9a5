#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pelt::detail {

/// Work of a search, in units.
struct SearchWork {
  std::uint64_t granted = 0, done = 0, longest_step = 0;

  bool is_left() const { return done < granted; }

  /// The work of starting counts as granted.
  void start(std::uint64_t work) {
    granted = done = work;
    longest_step = 0;
  }

  void grant(std::uint64_t work) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    granted = work <= kMost - granted ? granted + work : kMost;
  }

  /// `total`: work of all steps so far.
  void end_step(std::uint64_t total) {
    longest_step = std::max(longest_step, total - done);
    done = total;
  }
};

}  // namespace pelt::detail
