#pragma once

#include <pelt/asset.hpp>

namespace pelt::asset {

/// Moves the rest positions of unskinned parts from their node's frame to where the default pose
/// has them, and gives their joints the inverse matrix. Posed positions are the same up to
/// rounding. But the rest pose is now the assembled character, with the sword in the hand and not
/// inside the shield, and a bounding volume tree built over it fits.
///
/// Parts on a node whose default matrix is the identity, or cannot be inverted, stay as they are.
void assemble(Asset& asset);

}  // namespace pelt::asset
