#pragma once

/// The triangle test of all methods is the library's own: the certified float test
/// (geometry/triangle_triage.hpp) for eight pairs at a time, and the exact predicate for undecided
/// pairs. The comparison therefore shows how the pairs are found.

#include <pelt/collide.hpp>
#include <pelt/math.hpp>
#include <pelt/mesh.hpp>

namespace pelt::rivals {

/// A posed body as plain pointers, for code that is compiled for each instruction set.
struct PosedMesh {
  const Triangle* triangles = nullptr;
  const Vec3* positions = nullptr;
};

inline constexpr std::uint32_t kPairsAtOnce = 8;

/// Returns one bit for each of the first `count` pairs (1 to kPairsAtOnce): whether they intersect.
/// Reads all eight.
using Touching = unsigned(const PosedMesh& a, const PosedMesh& b, const Contact* pairs,
                          std::uint32_t count);

/// The function for the active target.
Touching* active_touching();

}  // namespace pelt::rivals
