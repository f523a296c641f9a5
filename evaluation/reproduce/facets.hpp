#pragma once

/// Draws characters as their triangles.

#include "base/vec3.hpp"
#include "tools/pelt/picture/still.hpp"

#include <string>

namespace pelt::reproduce {

/// A ball; everything outside is left out.
struct Around {
  detail::Vec3d centre;
  double reach;
};

/// All triangles of a frame's characters that reach into `around`, flat, with dark edges of radius
/// `edge`. Triangles in contact glow.
std::string facets(const tools::picture::StillFrame& still, double edge, const Around& around);

}  // namespace pelt::reproduce
