#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace pelt::paper {

/// Memory for descents, so that they allocate nothing after the first ones.
struct Scratch {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> node_pairs;
};

}  // namespace pelt::paper
