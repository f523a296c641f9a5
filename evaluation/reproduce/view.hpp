#pragma once

/// Where things stand as a camera sees them.

#include "tools/pelt/picture/pov.hpp"

namespace pelt::reproduce {

double length(const detail::Vec3d& v);
detail::Vec3d unit(const detail::Vec3d& v);

/// What a camera calls right, up and ahead.
struct View {
  explicit View(const tools::picture::PovCamera& camera);

  /// The width of what the picture shows at the depth of that place.
  double width_at(const detail::Vec3d& place) const;

  /// The point that many units ahead of the camera which is seen at (x, y) from the middle of the
  /// picture, in halves of its height.
  detail::Vec3d seen_at(double x, double y, double depth) const;

  detail::Vec3d ahead, right, up;

 private:
  detail::Vec3d from_;
  double width_, height_;  // of the picture, one unit ahead
};

}  // namespace pelt::reproduce
