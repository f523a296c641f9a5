#pragma once

#include "exact/exact_number.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "volume/surface_winding.hpp"

namespace pelt::detail {

/// Returns the flux of w through a surface, where w is its own winding number just in front of it.
/// Divided by six, this is the integral of w (w - 1) / 2: from the front to the back of the
/// surface, where w becomes w + 1, this function grows by w. Opens all nodes. Precondition: the
/// surface is closed.
Rounded self_flux(const PosedTree& posed, const Surface& surface, Scratch& scratch,
                  QueryStats& work);

}  // namespace pelt::detail
