#pragma once

/// Positions as a camera sees them.

#include "tools/pelt/picture/still.hpp"

namespace pelt::reproduce {

double length(const detail::Vec3d& v);
detail::Vec3d unit(const detail::Vec3d& v);

/// The right, up and forward directions of a camera.
struct View {
  explicit View(const tools::picture::PovCamera& camera);

  /// The width of the visible area at the depth of `place`.
  double width_at(const detail::Vec3d& place) const;

  /// The point `depth` units ahead of the camera that appears at (x, y) from the middle of the
  /// picture, in half heights.
  detail::Vec3d seen_at(double x, double y, double depth) const;

  detail::Vec3d ahead, right, up;

 private:
  detail::Vec3d from_;
  double width_, height_;  // of the visible area at depth 1
};

}  // namespace pelt::reproduce
