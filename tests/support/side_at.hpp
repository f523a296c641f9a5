#pragma once

#include <pelt/inside.hpp>

#include <concepts>

namespace pelt::test {

/// What `side_of` says of a point, whether it returns the side or writes it.
template <typename AnyPose>
PointSide side_at(AnyPose& pose, const Surface& surface, const Vec3& point, Scratch& scratch) {
  if constexpr (requires {
                  { side_of(pose, surface, point, scratch) } -> std::same_as<PointSide>;
                }) {
    return side_of(pose, surface, point, scratch);
  } else {
    PointSide side;
    side_of(pose, surface, point, scratch, side);
    return side;
  }
}

}  // namespace pelt::test
