#pragma once

#include <pelt/motion.hpp>

#include <cstdint>
#include <vector>

namespace pelt::wasm {

/// Times and features of moving contacts, in the order of motion.mjs.
struct MovingColumns {
  std::vector<float> times;
  std::vector<std::uint8_t> at_start;
  std::vector<std::uint8_t> features;  ///< [N][4] kind and number of a, then of b

  /// Adds time and features, with zeros for what has no meaning.
  void add(const MovingContact& moving);
};

}  // namespace pelt::wasm
