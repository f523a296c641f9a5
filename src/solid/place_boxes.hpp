#pragma once

/// Tests eight boxes against a region at once, in float: which boxes are certainly outside, and
/// which certainly inside. All others are undecided, including those that overflow, because
/// comparisons with NaN are false.
///
/// Faces. The vertex of a box that is farthest along the normal n decides whether the box is
/// inside, and the opposite vertex whether it is outside. Each term of n . (p - o) - d has at most
/// six roundings, so with u = 2^-24 the error is below 7 u (sum |n_a| (|p_a| + |o_a|) + |d|); 8 u
/// covers the error of this sum. Scaling a normal may lose 2^-150 of an element, times 2^62 at
/// most.
///
/// Capsule from a to a + e. For any direction d, every point p of the box has d . p >= d . m - |d|
/// . h, where m is its middle and h its half extents, and every point p of the segment has d . p <=
/// d . a + max(0, d . e). If the difference g of these bounds is positive, the distance is at least
/// g / |d|. The test uses the direction d from q to m, where q is the point of the segment closest
/// to m. If no vertex of the box is farther than r from q, the box is inside. m and q have an error
/// of a few u of the sum of the coordinates, and 16 u of that sum, along d, is subtracted. Squares
/// and products then have a relative error below 2^-20, or an error below the amounts that are
/// added for underflow.

#include "base/float8.hpp"
#include "query/slots.hpp"
#include "solid/prepared_region.hpp"

#include <cstddef>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// One bit for each of eight boxes.
struct PlacedBoxes {
  unsigned outside = 0, inside = 0;
};

/// Largest coordinate of each box on each axis.
struct Reaches8 {
  Float8 of[3];

  explicit Reaches8(const Boxes8& boxes) {
    for (int axis = 0; axis < 3; ++axis)
      of[axis] = max(abs(boxes.low[axis]), abs(boxes.high[axis]));
  }
};

/// Distances of the closest and the farthest corner of each box outside of a face, times the length
/// of its normal, with a bound of their error.
struct OutsideFace {
  Float8 closest, farthest, error;
};

inline OutsideFace outside_of(const FloatFace& face, const Boxes8& boxes, const Reaches8& reaches) {
  Float8 farthest = Float8(0.0f) - Float8(face.offset), closest = farthest, size = abs(farthest);
  for (int axis = 0; axis < 3; ++axis) {
    const Float8 normal(face.normal[axis]), origin(face.origin[axis]);
    const bool is_up = face.normal[axis] > 0;
    const Float8& far = is_up ? boxes.high[axis] : boxes.low[axis];
    const Float8& near = is_up ? boxes.low[axis] : boxes.high[axis];
    farthest = farthest + normal * (far - origin);
    closest = closest + normal * (near - origin);
    size = size + abs(normal) * (reaches.of[axis] + abs(origin));
  }
  return {closest, farthest, size * Float8(0x1p-21f) + Float8(0x1p-80f)};
}

inline PlacedBoxes place_boxes(const FacesRegion& region, const Boxes8& boxes) {
  const Reaches8 reaches(boxes);
  PlacedBoxes placed{0, 0xFF};
  for (std::uint32_t i = 0; i < region.count; ++i) {
    const OutsideFace outside = outside_of(region.scaled[i], boxes, reaches);
    placed.outside |= (outside.error < outside.closest).bits();
    placed.inside &= (outside.farthest < Float8(0.0f) - outside.error).bits();
  }
  return placed;
}

/// Distances of boxes from a capsule's segment: certainly more than `clear` along a direction,
/// times the length of the direction, and at most the root of `far`.
struct FromSegment {
  Float8 clear, squared_direction, far, size;
};

inline FromSegment from_segment(const Capsule& capsule, const Boxes8& boxes) {
  const float a[] = {capsule.a.x, capsule.a.y, capsule.a.z};
  const float e[] = {capsule.b.x - a[0], capsule.b.y - a[1], capsule.b.z - a[2]};
  const float length = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
  const float share = length > 0 ? 1 / length : 0;
  const Float8 zero(0.0f), one(1.0f), half(0.5f);

  Float8 middle[3], extent[3], along = zero;
  for (int axis = 0; axis < 3; ++axis) {
    middle[axis] = half * boxes.low[axis] + half * boxes.high[axis];
    extent[axis] = half * boxes.high[axis] - half * boxes.low[axis];
    along = along + (middle[axis] - Float8(a[axis])) * Float8(e[axis]);
  }
  const Float8 t = min(max(along * Float8(share), zero), one);

  Float8 gap = zero, turn = zero, slack = zero, squared = zero, far = zero, size = zero;
  for (int axis = 0; axis < 3; ++axis) {
    const Float8 from(a[axis]), edge(e[axis]);
    const Float8 closest = from + t * edge, direction = middle[axis] - closest;
    const Float8 coordinates = abs(middle[axis]) + extent[axis] + abs(from) + abs(edge);
    gap = gap + direction * (middle[axis] - from) - abs(direction) * extent[axis];
    turn = turn + direction * edge;
    slack = slack + abs(direction) * coordinates;
    squared = squared + direction * direction;
    const Float8 corner = abs(direction) + extent[axis];
    far = far + corner * corner;
    size = size + coordinates;
  }
  return {gap - max(turn, zero) - Float8(0x1p-20f) * slack, squared, far, size};
}

inline PlacedBoxes place_boxes(const CapsuleRegion& region, const Boxes8& boxes) {
  unsigned beyond = 0;
  for (int axis = 0; axis < 3; ++axis)
    beyond |= ((boxes.high[axis] < Float8(region.low[axis])) |
               (Float8(region.high[axis]) < boxes.low[axis]))
                  .bits();
  const FromSegment from = from_segment(region.capsule, boxes);
  const Float8 zero(0.0f), radius(region.capsule.radius);
  const Float8 squared_clear = from.clear * from.clear * Float8(1 - 0x1p-18f);
  const Float8 squared_radius = radius * radius + Float8(0x1p-120f);
  const Mask8 apart = (zero < from.clear) &
                      (squared_radius * from.squared_direction + Float8(0x1p-100f) < squared_clear);
  const Float8 within = radius - Float8(0x1p-20f) * from.size;
  const Mask8 enclosed =
      (zero < within) & (from.far * Float8(1 + 0x1p-18f) + Float8(0x1p-100f) < within * within);
  return {beyond | apart.bits(), enclosed.bits()};
}

// Tests eight boxes in motion against a region at once, in float. The vertices in a box move in
// straight lines from the box at one end of a step to the box at the other end, so they are
// outside of a face throughout if both boxes are. A box around both ends is apart from a capsule
// only if all positions are.

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
