#pragma once

/// Runs tests on every instruction set that this machine supports.

#include <pelt/config.hpp>
#include "support/compiled.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::test {

inline bool runs_here(InstructionSet set) {
  const auto available = available_instruction_sets();
  return std::find(available.begin(), available.end(), set) != available.end();
}

/// The result of the scalar function. Expects the same from all others that run here.
template <typename Result, typename... Parameters, std::size_t count, typename... Arguments>
Result on_each_compiled(const Compiled<Result(Parameters...)> (&functions)[count],
                        const Arguments&... arguments) {
  const Result result = functions[0].call(arguments...);
  for (const auto& [set, call] : functions)
    if (runs_here(set)) {
      EXPECT_EQ(call(arguments...), result) << name_of(set);
    }
  return result;
}

/// Calls `body(set)` for each available instruction set, while queries use it.
template <typename Body>
void on_each_instruction_set(const Body& body) {
  const InstructionSet before = active_instruction_set();
  for (const InstructionSet set : available_instruction_sets()) {
    SCOPED_TRACE(name_of(set));
    ASSERT_TRUE(set_active_instruction_set(set));
    body(set);
  }
  set_active_instruction_set(before);
}

}  // namespace pelt::test
