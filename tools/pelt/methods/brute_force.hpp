#pragma once

/// The oracles: test every triangle of one body against every triangle of the other, or of the same
/// body, with the exact predicate. They use no tree, and only skip triangles outside the other
/// body's box, and pairs whose boxes do not overlap.

#include <pelt/mesh.hpp>
#include <pelt/query.hpp>

#include "skin/skinned_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::methods {

/// Appends the contacts of two posed meshes, ascending.
QueryStats brute_force_collide(std::span<const Triangle> triangles_a,
                               std::span<const Vec3> positions_a,
                               std::span<const Triangle> triangles_b,
                               std::span<const Vec3> positions_b, std::vector<Contact>& contacts,
                               std::uint32_t max_contacts);

/// Returns for each vertex the lowest vertex with an equal rest position and the same bits in
/// displacements.
std::vector<std::uint32_t> surface_vertices(const detail::SkinnedMesh& mesh);

}  // namespace pelt::methods
