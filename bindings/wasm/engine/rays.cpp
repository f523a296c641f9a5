/// Rays and their hits.

#include <pelt/ray.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"

namespace pelt::wasm {
namespace {

/// Numbers of a hit: triangle, t, the three weights, the normal.
constexpr std::size_t kHitNumbers = 8;

/// `first` is the number of the pose's first triangle in the character.
void push(const RayHit& hit, std::uint32_t first, std::vector<double>& rows) {
  const auto& [u, v, w] = hit.barycentrics;
  const auto& [x, y, z] = hit.normal;
  rows.insert(rows.end(), {static_cast<double>(first + hit.triangle), hit.t, u, v, w, x, y, z});
}

/// The answer is the hits, `kHitNumbers` each.
void answer_hits(std::span<const RayHit> hits, const PoseHandle& handle) {
  static std::vector<double> rows;
  rows.clear();
  rows.reserve(kHitNumbers * hits.size());
  for (const RayHit& hit : hits) push(hit, handle.body.first_triangle, rows);
  answer_data<double>(rows);
}

}  // namespace

/// Returns memory where JavaScript writes a ray: origin, direction, least t and greatest t.
PELT_EXPORT Ray* pelt_ray() {
  static_assert(sizeof(Ray) == 8 * sizeof(float), "JavaScript writes 8 numbers");
  static Ray ray;
  return &ray;
}

/// Answers with the first hit.
PELT_EXPORT std::uint32_t pelt_cast(PoseHandle* handle, Facing facing) {
  RayHit hit;
  answer_stats(cast(handle->pose, *pelt_ray(), hit, facing));
  answer_hits({&hit, 1}, *handle);
  return hit ? 1 : 0;
}

PELT_EXPORT std::uint32_t pelt_cast_any(PoseHandle* handle, Facing facing) {
  bool hit = false;
  answer_stats(cast_any(handle->pose, {pelt_ray(), 1}, {&hit, 1}, facing));
  return hit ? 1 : 0;
}

PELT_EXPORT void pelt_cast_all(PoseHandle* handle, Facing facing) {
  static std::vector<RayHit> hits;
  hits.clear();
  answer_stats(cast_all(handle->pose, *pelt_ray(), scratch(), hits, facing));
  answer_hits(hits, *handle);
}

}  // namespace pelt::wasm
