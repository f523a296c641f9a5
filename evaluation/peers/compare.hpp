#pragma once

#include <pelt/collide.hpp>

#include <cstddef>
#include <span>

namespace pelt::peers {

/// How an answer differs from the exact one.
struct Difference {
  std::size_t missing = 0;   ///< exact contacts that the answer has not
  std::size_t extra = 0;     ///< pairs in the answer that do not intersect
  std::size_t repeated = 0;  ///< contacts that the answer has told before

  Difference& operator+=(const Difference& other);
  friend bool operator==(const Difference&, const Difference&) = default;
};

/// As sets: the order of the contacts means nothing.
Difference compare(std::span<const Contact> answer, std::span<const Contact> exact);

}  // namespace pelt::peers
