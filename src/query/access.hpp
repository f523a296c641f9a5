#pragma once

#include <pelt/query.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {

/// Gives Pelt access to private members of public types.
struct Access {
  template <std::size_t kNumbers>
  static TreeLocation<kNumbers> location(const std::array<std::uint32_t, kNumbers>& numbers) {
    TreeLocation<kNumbers> location;
    location.numbers_ = numbers;
    return location;
  }

  template <std::size_t kNumbers>
  static const std::array<std::uint32_t, kNumbers>& numbers(
      const TreeLocation<kNumbers>& location) {
    return location.numbers_;
  }
};

}  // namespace pelt::detail
