#pragma once

#include <pelt/mesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt {
class Surface;
}

namespace pelt::wasm {

/// For each vertex, one that stands for all that are alike in every bit but the number: exporters
/// split vertices where a texture has a seam.
std::vector<std::uint32_t> find_seams(const Surface& surface, std::span<const Triangle> triangles,
                                      std::uint32_t vertex_count);

}  // namespace pelt::wasm
