#pragma once

/// A magnifying glass in front of the stage, for details that are too small to see.

#include "tools/pelt/picture/still.hpp"

namespace pelt::reproduce {

struct Lens {
  detail::Vec3d focus;  ///< on the stage
  double reach;         ///< radius of the magnified ball around the focus
  double x, y, radius;  ///< in the picture, from its middle, in half heights
};

/// The magnified part of `objects`, translated by `shift`, and a ring around that part on the stage
/// with a line to the lens.
std::string magnified(const Lens& lens, const std::string& objects, const detail::Vec3d& shift,
                      const tools::picture::PovCamera& camera);

/// The middle of the triangles in contact within `reach` of the triangle with most such neighbours;
/// the origin if nothing touches.
detail::Vec3d densest_contact(const tools::picture::StillFrame& still, double reach);

}  // namespace pelt::reproduce
