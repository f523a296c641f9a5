#pragma once

#include <pelt/result.hpp>

#include <cstdio>
#include <string>
#include <vector>

namespace pelt::programs {

/// Calls `measure` for each character, or for the generated one, whose name is "". Returns the exit
/// code of `program`. Prints the first failure to standard error.
template <typename Measure>
int measure_each(const char* program, std::vector<std::string> characters, const Measure& measure) {
  if (characters.empty()) characters.emplace_back();
  for (const std::string& character : characters) {
    const Result<void> measured = measure(character);
    if (measured) continue;
    std::fprintf(stderr, "%s: %s\n", program, measured.error().message.c_str());
    return 1;
  }
  return 0;
}

}  // namespace pelt::programs
