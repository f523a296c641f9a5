#pragma once

/// Describes a still picture of colliding characters for the ray tracer POV-Ray.

#include "tools/pelt/picture/still_frame.hpp"

#include <string>

namespace pelt::tools::picture {

/// Smooth skins on a dark ground in soft light, with the triangles in contact glowing. The camera
/// looks along -x at the middle of the instances. Precondition: there is an instance.
std::string describe_still(const StillFrame& still);

}  // namespace pelt::tools::picture
