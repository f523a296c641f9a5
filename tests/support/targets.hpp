#pragma once

/// Tests that run on every target that this machine has.

#include <pelt/target.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::test {

inline bool runs_here(Target target) {
  const auto available = available_targets();
  return std::find(available.begin(), available.end(), target) != available.end();
}

/// Calls `body(target)` while queries use `target`, for each available one.
template <typename Body>
void on_each_target(const Body& body) {
  const Target before = active_target();
  for (const Target target : available_targets()) {
    SCOPED_TRACE(name_of(target));
    ASSERT_TRUE(set_active_target(target));
    body(target);
  }
  set_active_target(before);
}

}  // namespace pelt::test
