#pragma once

/// A still picture of characters that collide, described for the ray tracer POV-Ray.

#include "tools/pelt/posed_instances.hpp"

#include <string>
#include <vector>

namespace pelt::tools {

/// Smooth skins on a dark ground under soft light, with the triangles in contact glowing; the
/// camera looks along -x at the middle of the instances. Precondition: there is an instance.
std::string describe_still(std::span<const PosedInstance> instances,
                           const std::vector<std::vector<bool>>& touching);

}  // namespace pelt::tools
