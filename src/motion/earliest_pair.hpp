#pragma once

#include <pelt/motion.hpp>

#include "motion/meeting_order.hpp"

#include <optional>

namespace pelt::detail {

/// The pair of triangles that intersects first, of those added; of equal times, the lowest. Pairs
/// that intersect at time 0 are left out.
class EarliestPair {
 public:
  void add(const Contact& contact, const MovingTriangle& a, const MovingTriangle& b,
           MovingStats& work);

  /// Adds a pair that first meets after time 0. Returns whether the order of two equal times was
  /// certain without exact arithmetic, which takes as long as two pairs in exact arithmetic.
  bool add(const Contact& contact, const MeetingPair& pair);

  /// No time after this one is earlier than or equal to that of the earliest pair.
  float latest() const;

  /// Empty if no pair was added that intersects.
  std::optional<MovingContact> contact() const;

 private:
  Contact contact_;
  std::optional<MeetingPair> pair_;
};

}  // namespace pelt::detail
