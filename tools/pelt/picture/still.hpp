#pragma once

/// A still picture of characters that collide, described for the ray tracer POV-Ray.

#include "tools/pelt/picture/still_frame.hpp"

#include <string>

namespace pelt::tools::picture {

/// Smooth skins on a dark ground under soft light, with the triangles in contact glowing; the
/// camera looks along -x at the middle of the instances. Precondition: there is an instance.
std::string describe_still(const StillFrame& still);

}  // namespace pelt::tools::picture
