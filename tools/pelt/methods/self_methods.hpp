#pragma once

/// The methods of `pelt bench` for a character against itself. `Method::collide` is called with the
/// same body twice, and finds the pairs of triangles that self_collide defines, without filters.

#include "skin/skinned_mesh.hpp"
#include "tools/pelt/methods/method.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace pelt::methods {

std::unique_ptr<Method> make_self();
std::unique_ptr<Method> make_boxes();
std::unique_ptr<Method> make_self_brute();

/// The public function self_collide.
inline constexpr MethodKind kSelf = {"self", Skins::with_boxes, make_self};

/// Skins all vertices and computes all boxes bottom-up, and finds nothing: the unit of comparison.
inline constexpr MethodKind kBoxes = {"boxes", Skins::with_boxes, make_boxes};

/// The oracle: tests all pairs whose extents overlap with the exact predicate, without a tree.
inline constexpr MethodKind kSelfBrute = {"brute", Skins::first, make_self_brute};

/// The methods of the command `pelt`.
inline constexpr std::array kSelfMethods = {kSelf, kBoxes, kSelfBrute};

/// Returns for each vertex the lowest vertex with an equal rest position and the same bits in
/// displacements.
std::vector<std::uint32_t> surface_vertices(const detail::SkinnedMesh& mesh);

}  // namespace pelt::methods
