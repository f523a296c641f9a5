#pragma once

#include "base/instruction_set.hpp"
#include "pose/given_vertices.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Whether no coordinate is NaN or beyond kMaxCoordinate.
bool are_within(std::span<const Vec3> vertices);

/// Copies the caller's vertices [V] to `arena` and computes the boxes of all nodes bottom-up.
/// Precondition: `check_vertices` finds no problem. O(P).
GivenVertices refit_given(const Tree& tree, std::span<const Vec3> vertices, Arena& arena);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
