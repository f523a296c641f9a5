#pragma once

#include "tools/pelt/methods/moving_method.hpp"

#include <array>

namespace pelt::methods {

std::unique_ptr<MovingMethod> make_moving_on_demand();
std::unique_ptr<MovingMethod> make_moving_eager();
std::unique_ptr<MovingMethod> make_moving_brute();

/// The public functions: nodes are opened on demand at both ends of a step.
inline constexpr MovingMethodKind kMovingOnDemand = {"on_demand", make_moving_on_demand};

/// The same tree, wide code and query, but every new palette skins all vertices and computes all
/// boxes bottom-up. A step computes one end; the other is the end of the step before.
inline constexpr MovingMethodKind kMovingEager = {"eager", make_moving_eager};

/// The oracle: decides every pair of triangles whose extents during the step overlap, without a
/// tree and without the certified test in float.
inline constexpr MovingMethodKind kMovingBrute = {"brute", make_moving_brute};

/// The methods of the command `pelt`.
inline constexpr std::array kCommandMovingMethods = {kMovingOnDemand, kMovingEager, kMovingBrute};

}  // namespace pelt::methods
