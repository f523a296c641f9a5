#pragma once

#include <pelt/collide.hpp>

#include <cstddef>
#include <span>

namespace pelt::peers {

/// Difference between an answer and the exact one.
struct Difference {
  std::size_t missing = 0;   ///< exact contacts that the answer lacks
  std::size_t extra = 0;     ///< pairs in the answer that do not intersect
  std::size_t repeated = 0;  ///< contacts that occur earlier in the answer

  Difference& operator+=(const Difference& other);
  friend bool operator==(const Difference&, const Difference&) = default;
};

/// Compares sets: the order of the contacts does not matter.
Difference compare(std::span<const Contact> answer, std::span<const Contact> exact);

}  // namespace pelt::peers
