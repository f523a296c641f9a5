/// Compiled once for each instruction set.
#include "evaluation/rivals/touching.hpp"

#include "base/instruction_set.hpp"
#include "geometry/triangle_pair.hpp"
#include "geometry/triangle_triage.hpp"

namespace pelt::rivals {
inline namespace PELT_INSTRUCTION_SET {
namespace {

using detail::Float4;
using detail::TriangleCorners;

Float4 corner(const PosedMesh& mesh, std::uint32_t triangle, std::size_t k) {
  const Vec3& p = mesh.positions[mesh.triangles[triangle][k]];
  return {p.x, p.y, p.z, 0};
}

TriangleCorners corners(const PosedMesh& mesh, std::uint32_t triangle) {
  const Triangle& v = mesh.triangles[triangle];
  return {mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]};
}

template <typename TriangleAt>
void load(const PosedMesh& mesh, const TriangleAt& triangle, detail::Points8 (&points)[3]) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](std::uint32_t lane) { return corner(mesh, triangle(lane), k); };
    points[k] = detail::transpose8(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
  }
}

}  // namespace

Touching touching;

unsigned touching(const PosedMesh& a, const PosedMesh& b, const Contact* pairs,
                  std::uint32_t count) {
  detail::TrianglePairs8 lanes;
  load(
      a, [=](std::uint32_t lane) { return pairs[lane].triangle_a; }, lanes.a);
  load(
      b, [=](std::uint32_t lane) { return pairs[lane].triangle_b; }, lanes.b);
  const detail::Triage verdict = triage(lanes);
  unsigned found = verdict.intersecting;
  for (std::uint32_t lane = 0; lane < count; ++lane) {
    const bool decided = (verdict.intersecting | verdict.apart) >> lane & 1;
    if (!decided && detail::triangles_intersect(corners(a, pairs[lane].triangle_a),
                                                corners(b, pairs[lane].triangle_b)))
      found |= 1u << lane;
  }
  return found & ((1u << count) - 1);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::rivals
