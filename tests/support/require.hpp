#pragma once

#include <cstdio>
#include <cstdlib>

namespace pelt::test {

/// Ends the program with a message if a condition does not hold. For fuzzers, which do not use
/// GoogleTest.
inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

}  // namespace pelt::test
