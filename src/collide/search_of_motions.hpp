#pragma once

#include <pelt/motion.hpp>

#include "collide/first_contact_state.hpp"
#include "pose/pose.hpp"

#include <array>
#include <cstdint>

namespace pelt::detail {

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
