#pragma once

/// Tests eight boxes in motion against a region at once, in float. The vertices in a box move in
/// straight lines from the box at one end of a step to the box at the other end, so they are
/// outside of a face throughout if both boxes are. A box around both ends is apart from a capsule
/// only if all positions are.

#include "solid/place_boxes.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// One bit for each of eight boxes: certainly outside at all times, inside at time 0 or at time 1.
struct PlacedMovingBoxes {
  unsigned outside = 0, inside_from = 0, inside_to = 0;
};

inline PlacedMovingBoxes place_moving_boxes(const FacesRegion& region, const Boxes8& from,
                                            const Boxes8& to) {
  const Reaches8 reaches_from(from), reaches_to(to);
  PlacedMovingBoxes placed{0, 0xFF, 0xFF};
  for (std::uint32_t i = 0; i < region.count; ++i) {
    const OutsideFace first = outside_of(region.scaled[i], from, reaches_from);
    const OutsideFace last = outside_of(region.scaled[i], to, reaches_to);
    placed.outside |= ((first.error < first.closest) & (last.error < last.closest)).bits();
    placed.inside_from &= (first.farthest < Float8(0.0f) - first.error).bits();
    placed.inside_to &= (last.farthest < Float8(0.0f) - last.error).bits();
  }
  return placed;
}

inline PlacedMovingBoxes place_moving_boxes(const CapsuleRegion& region, const Boxes8& from,
                                            const Boxes8& to) {
  Boxes8 both = from;
  for (int axis = 0; axis < 3; ++axis) {
    both.low[axis] = min(from.low[axis], to.low[axis]);
    both.high[axis] = max(from.high[axis], to.high[axis]);
  }
  return {place_boxes(region, both).outside, place_boxes(region, from).inside,
          place_boxes(region, to).inside};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
