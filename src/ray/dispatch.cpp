/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "ray/ray_descent.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(first_hits)
PELT_DECLARE_VERSIONS(any_hits)
PELT_DECLARE_VERSIONS(all_hits)
PELT_DECLARE_VERSIONS(winding_number)

inline namespace PELT_INSTRUCTION_SET {

QueryStats first_hits(const PosedTree& posed, std::span<const Ray> rays, Facing facing,
                      std::span<RayHit> hits) {
  return PELT_CHOOSE(first_hits)(posed, rays, facing, hits);
}

QueryStats any_hits(const PosedTree& posed, std::span<const Ray> rays, Facing facing,
                    std::span<bool> hit) {
  return PELT_CHOOSE(any_hits)(posed, rays, facing, hit);
}

QueryStats all_hits(const PosedTree& posed, const Ray& ray, Facing facing, Stack<RayHit>& hits) {
  return PELT_CHOOSE(all_hits)(posed, ray, facing, hits);
}

QueryStats winding_number(const PosedTree& posed, const Vec3& point,
                          const GenericDirection& direction, int& winding) {
  return PELT_CHOOSE(winding_number)(posed, point, direction, winding);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
