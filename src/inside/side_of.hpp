#pragma once

#include <pelt/inside.hpp>
#include <pelt/shapes.hpp>

namespace pelt::detail {

/// Writes the side on which `point` lies, as `pelt::side_of` says.
QueryStats find_side(pelt::Pose& pose, const pelt::Surface& surface, const Vec3& point,
                     pelt::Scratch& scratch, PointSide& side);

/// Writes whether the surface of `pose` touches a box; `touches` is true too where the box lies in
/// no triangle but contains one.
QueryStats touches_box(pelt::Pose& pose, const Box& box, pelt::Scratch& scratch, bool& touches);

}  // namespace pelt::detail
