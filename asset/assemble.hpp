#pragma once

#include <pelt/asset.hpp>

namespace pelt::asset {

/// Moves the rest positions of unskinned parts from the frame of their node to their place in the
/// default pose, and sets the inverse matrices of their joints accordingly. Posed positions are the
/// same up to rounding. The rest pose then is the assembled character, with the sword in the hand
/// and not inside the shield, so bounding volumes built over it are tight.
///
/// Does not change parts whose node has the identity or a singular matrix in the default pose.
void assemble(Asset& asset);

}  // namespace pelt::asset
