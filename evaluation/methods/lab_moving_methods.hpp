#pragma once

/// Methods of `bench --moving` that are used only for comparison.

#include "tools/pelt/methods/moving_methods.hpp"

namespace pelt::lab {

std::unique_ptr<methods::MovingMethod> make_moving_united();

/// An ablation of on_demand: prunes nodes and triangles by one box over the whole step, as is usual
/// in continuous collision detection, instead of by the boxes of both ends and the times at which
/// they overlap. The rest is the same. Finds no first contact.
inline constexpr methods::MovingMethodKind kMovingUnited = {"united", make_moving_united};

/// All methods of the program `pelt-lab`: the methods of the command, and these.
inline constexpr std::array kLabMovingMethods = {methods::kMovingOnDemand, methods::kMovingEager,
                                                 kMovingUnited, methods::kMovingBrute};

}  // namespace pelt::lab
