#pragma once

/// The triangle test of all methods is the library's own: the certified float test
/// (geometry/triangle_triage.hpp) for eight pairs at a time, and the exact predicate for undecided
/// pairs. The comparison therefore shows how the pairs are found.

#include "evaluation/rivals/posed_mesh.hpp"

#include <pelt/collide.hpp>

namespace pelt::rivals {

inline constexpr std::uint32_t kPairsAtOnce = 8;

/// Returns one bit for each of the first `count` pairs (1 to kPairsAtOnce): whether they intersect.
/// Reads all eight.
using Touching = unsigned(const PosedMesh& a, const PosedMesh& b, const Contact* pairs,
                          std::uint32_t count);

/// The function for the active target.
Touching* active_touching();

}  // namespace pelt::rivals
