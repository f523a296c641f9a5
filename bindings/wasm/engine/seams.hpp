#pragma once

#include <pelt/mesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt {
class Surface;
}

namespace pelt::wasm {

/// Returns for each vertex the representative of all bit-identical vertices: exporters split
/// vertices where a texture has a seam.
std::vector<std::uint32_t> find_seams(const Surface& surface, std::span<const Triangle> triangles,
                                      std::uint32_t vertex_count);

}  // namespace pelt::wasm
