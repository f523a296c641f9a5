#pragma once

#include <pelt/motion.hpp>

#include "query/stack.hpp"
#include "self/moving_neighbours.hpp"

namespace pelt::detail {

/// Tests two triangles of a moving surface that share a surface vertex, in double and then exactly.
/// Adds a contact if they intersect and the options ask for it.
void decide_neighbours(const MovingSurfaceTriangle& a, const MovingSurfaceTriangle& b,
                       const Contact& contact, const MovingOptions& options,
                       Stack<MovingContact>& contacts, MovingStats& work);

}  // namespace pelt::detail
