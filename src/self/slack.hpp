#pragma once

#include "base/instruction_set.hpp"
#include "pose/posed_tree.hpp"
#include "self/self_track.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Copies the posed vertices of all pools to one array, by place. Precondition: all nodes are open.
void write_positions(const PosedTree& posed, std::array<float, 4>* positions);

/// Begins a frame: writes the posed vertices and their largest coordinate to `track`, and reduces
/// all slack by the motion since the last frame (see self_track.hpp). Precondition: all nodes are
/// open.
void begin_frame(const PosedTree& posed, SelfTrack& track, QueryStats& work);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
