#pragma once

/// Channels of clips and their interpolation.

#include <pelt/asset.hpp>

#include <array>
#include <cstddef>

namespace pelt::asset {

/// Numbers in one value of a property other than weights: 4 for a rotation (x y z w), otherwise 3.
inline std::size_t value_size(Path path) { return path == Path::rotation ? 4 : 3; }

/// Returns the property at `seconds`, clamped to the first and last key. The fourth number is used
/// for rotations only. Source: glTF 2.0, appendix C. Precondition: the channel is valid as defined
/// at Channel, and does not animate weights.
std::array<double, 4> sample_channel(const Channel& channel, float seconds);

/// Writes the weights of a channel of weights, one per element of `out`, rounded to float.
void sample_weights(const Channel& channel, float seconds, std::span<float> out);

}  // namespace pelt::asset
