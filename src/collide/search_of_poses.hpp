#pragma once

#include "collide/search_state.hpp"
#include "pose/pose.hpp"

namespace pelt::detail {

/// A search of two poses, which a caller may change.
struct SearchOfPoses {
  SearchOfPoses(Pose& first, Pose& second) : a(&first), b(&second) {}

  const Tree& tree_a() const { return a->model.detail().tree; }
  const Tree& tree_b() const { return b->model.detail().tree; }

  Pose *a, *b;
  std::uint64_t stamp_a = 0, stamp_b = 0;  ///< of the poses when the search was started
  SearchState state;
  QueryStats unreported;  ///< work of starting
};

}  // namespace pelt::detail
