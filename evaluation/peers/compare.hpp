#pragma once

#include <pelt/collide.hpp>
#include <pelt/motion.hpp>

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

/// Difference between contacts of a step and the exact ones.
struct MovingDifference {
  std::size_t missing_at_start = 0;  ///< exact contacts that intersect at time 0, and are missing
  std::size_t missing_later = 0;     ///< exact contacts that first intersect later, and are missing
  std::size_t extra = 0;             ///< pairs that never intersect
  std::size_t early = 0;             ///< times that are earlier than the exact ones ...
  std::size_t late = 0;              ///< ... or later, by more than kTimeTolerance

  MovingDifference& operator+=(const MovingDifference& other);
  friend bool operator==(const MovingDifference&, const MovingDifference&) = default;
};

inline constexpr float kTimeTolerance = 1e-4f;

/// Compares sets. Times of contacts that intersect at time 0 are not compared. Precondition: both
/// are ascending.
MovingDifference compare_moving(std::span<const MovingContact> answer,
                                std::span<const MovingContact> exact);

}  // namespace pelt::peers
