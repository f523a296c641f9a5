#include "model/sample_boxes.hpp"

#include "base/assert.hpp"

namespace pelt::detail {
namespace {

Box4 box_of(const Triangle& triangle, const std::vector<Vec3>& positions) {
  Box4 box = empty_box();
  for (const std::uint32_t v : triangle) {
    const Vec3& p = positions[v];
    const Float4 point(p.x, p.y, p.z, 0);
    box = unite(box, {point, point});
  }
  return box;
}

}  // namespace

SampleBoxes::SampleBoxes(std::span<const Triangle> triangles,
                         std::span<const std::vector<Vec3>> samples)
    : triangle_count_(static_cast<std::uint32_t>(triangles.size())),
      sample_count_(static_cast<std::uint32_t>(samples.size())) {
  PELT_ASSERT(!samples.empty());
  boxes_.reserve(triangles.size() * samples.size());
  for (const Triangle& triangle : triangles)
    for (const std::vector<Vec3>& positions : samples)
      boxes_.push_back(box_of(triangle, positions));
}

}  // namespace pelt::detail
