#pragma once

#include <pelt/asset.hpp>

#include <array>
#include <cstddef>

namespace pelt::asset {

/// Numbers in one value of the property, but of weights: 4 for a rotation (x y z w), else 3.
inline std::size_t value_size(Path path) { return path == Path::rotation ? 4 : 3; }

/// The property at `seconds`, clamped to the first and last key; the fourth number counts for
/// rotations only. glTF 2.0, appendix C. Precondition: as stated at Channel,
/// and it is not one of weights.
std::array<double, 4> sample_channel(const Channel& channel, float seconds);

/// The same for a channel of weights, one for each element of `out`, rounded to float.
void sample_weights(const Channel& channel, float seconds, std::span<float> out);

}  // namespace pelt::asset
