#pragma once

/// Eight pairs of triangles at a time: pairs wait in a Batch8 until there are eight, their corners
/// are gathered side by side, and the certified float test (triangle_triage.hpp) decides most of
/// them. The exact predicate decides the others.

#include "geometry/triangle_pair.hpp"
#include "geometry/triangle_triage.hpp"
#include "query/slots.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

inline constexpr std::uint32_t kBatch = 8;

/// Up to eight waiting items. The owner tests them when the batch is full, and at the end.
template <typename Item>
class Batch8 {
 public:
  void add(const Item& item) { items_[count_++] = item; }
  void clear() { count_ = 0; }

  std::uint32_t count() const { return count_; }
  bool is_full() const { return count_ == kBatch; }
  const Item& operator[](std::uint32_t i) const { return items_[i]; }

  /// Fills the unused lanes with the first item. Precondition: the batch is not empty.
  void pad() {
    for (std::uint32_t i = count_; i < kBatch; ++i) items_[i] = items_[0];
  }

 private:
  Item items_[kBatch];
  std::uint32_t count_ = 0;
};

/// Gathers eight points: `at(lane)` points to four floats.
template <typename At>
[[gnu::always_inline]] inline Points8 gather_points(const At& at_lane) {
  const auto at = [&](std::uint32_t lane) __attribute__((always_inline)) {
    return load4(at_lane(lane));
  };
  return transpose8(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
}

/// Gathers the corners of a triangle: `corner(k)` points to four floats.
template <typename Corner>
[[gnu::always_inline]] inline TriangleCorners corners_at(const Corner& corner) {
  TriangleCorners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const float* p = corner(k);
    corners[k] = {p[0], p[1], p[2]};
  }
  return corners;
}

/// Returns the lanes of `kept` that the float test leaves undecided and that intersect by the exact
/// predicate. `corners_a(lane)` and `corners_b(lane)` return the corners of a lane's triangles.
template <typename CornersA, typename CornersB>
[[gnu::always_inline]] inline unsigned decide_exactly(const Triage& verdict, unsigned kept,
                                                      const CornersA& corners_a,
                                                      const CornersB& corners_b) {
  unsigned intersecting = 0;
  for (SetBits lane(kept & ~(verdict.intersecting | verdict.apart)); lane; ++lane)
    if (triangles_intersect(corners_a(*lane), corners_b(*lane))) intersecting |= 1u << *lane;
  return intersecting;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
