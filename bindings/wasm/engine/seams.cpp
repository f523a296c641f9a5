#include "bindings/wasm/engine/seams.hpp"

#include <pelt/surface.hpp>

#include "model/surface.hpp"

#include <numeric>

namespace pelt::wasm {

std::vector<std::uint32_t> find_seams(const Surface& surface, std::span<const Triangle> triangles,
                                      std::uint32_t vertex_count) {
  constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::vector<std::uint32_t> first(vertex_count, kNone);  // by the surface's vertex number
  std::vector<std::uint32_t> seams(vertex_count);
  std::iota(seams.begin(), seams.end(), 0u);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t& known = first[surface.detail().corners[t][c]];
      if (known == kNone) known = triangles[t][c];
      seams[triangles[t][c]] = known;
    }
  return seams;
}

}  // namespace pelt::wasm
