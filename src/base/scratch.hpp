#pragma once

#include <pelt/collide.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace pelt::detail {

/// Memory lent to queries; every user clears what it takes.
struct Scratch {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> node_pairs;
  std::vector<Contact> contacts;
};

}  // namespace pelt::detail
