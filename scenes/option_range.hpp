#pragma once

#include <cstdint>
#include <string>

namespace pelt::scenes {

/// "creature: triangles is 3, expected 1000 to 1000000", or nothing if `value` is in the range.
inline std::string check_range(const char* what, const char* name, std::uint32_t value,
                               std::uint32_t low, std::uint32_t high) {
  if (value >= low && value <= high) return {};
  return std::string(what) + ": " + name + " is " + std::to_string(value) + ", expected " +
         std::to_string(low) + " to " + std::to_string(high);
}

}  // namespace pelt::scenes
