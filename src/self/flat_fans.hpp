#pragma once

/// Certifies that no two triangles around a vertex intersect, apart from the vertex and the edges
/// that they share. The triangles around a vertex of a smooth surface can be projected onto a plane
/// such that they surround the vertex once, like the slices of a cake. One test of k triangles then
/// replaces tests of k (k - 1) / 2 pairs. Where this fails, most pairs are certified one by one.

#include "base/float8.hpp"
#include "query/triangle_batch.hpp"
#include "self/fans.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Posed vertices by place, four floats each.
using Positions = const std::array<float, 4>*;

/// Eight fans that were tested.
struct FlatFans {
  unsigned certified;     // one bit per fan
  Float8 least;           // determinant, less its error, of the certified ones
  Float8 squared_length;  // at least that of the longest spoke

  /// Slack of the certified ones (see self_track.hpp).
  Float8 slack() const;
};

/// The pairs of triangles of eight fans that need an exact test: bit i of row k, with i < k, for
/// the triangles i and k of a fan.
struct UndecidedPairs {
  std::uint32_t rows[kBatch][kMaxFan];
};

/// Tests at most eight fans of a run of closed or open fans. `numbers[i]` is the number of fan i.
/// Writes the undecided pairs of the fans that are not certified.
FlatFans test_flat_fans(const Fans& fans, const FanRun& run, const std::uint32_t* numbers,
                        std::uint32_t count, Positions positions, UndecidedPairs& undecided);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
