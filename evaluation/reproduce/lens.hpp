#pragma once

/// A magnifying glass in front of the stage, for what is too small to be seen on it.

#include "tools/pelt/picture/pov.hpp"
#include "tools/pelt/picture/still_frame.hpp"

namespace pelt::reproduce {

struct Lens {
  detail::Vec3d focus;  ///< on the stage
  double reach;         ///< of what it shows around the focus
  double x, y, radius;  ///< on the picture, from its middle, in halves of its height
};

/// What the lens shows of `objects`, which stand where `shift` moves them, and a ring around that
/// place on the stage with a line to the lens.
std::string magnified(const Lens& lens, const std::string& objects, const detail::Vec3d& shift,
                      const tools::picture::PovCamera& camera);

/// The middle of the triangles in contact within `reach` of the one that has most of them there;
/// the origin where nothing touches.
detail::Vec3d densest_contact(const tools::picture::StillFrame& still, double reach);

}  // namespace pelt::reproduce
