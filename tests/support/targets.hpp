#pragma once

/// Runs tests on every target that this machine supports.

#include <pelt/target.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::test {

inline bool runs_here(Target target) {
  const auto available = available_targets();
  return std::find(available.begin(), available.end(), target) != available.end();
}

/// Calls `body(target)` for each available target, with queries set to use that target.
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
