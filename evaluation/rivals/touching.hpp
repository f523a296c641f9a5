#pragma once

/// The test that every method ends in: the library's own, eight pairs of triangles at a time by the
/// certified float test (geometry/triangle_triage.hpp) and the exact predicate for what it leaves
/// undecided. What is compared is then how the pairs were found.

#include "evaluation/rivals/posed_mesh.hpp"

#include <pelt/collide.hpp>

namespace pelt::rivals {

inline constexpr std::uint32_t kPairsAtOnce = 8;

/// Which of the first `count` pairs, 1 to kPairsAtOnce, intersect: one bit each. All eight are
/// read.
using Touching = unsigned(const PosedMesh& a, const PosedMesh& b, const Contact* pairs,
                          std::uint32_t count);

/// That of the active target.
Touching* active_touching();

}  // namespace pelt::rivals
