#include "model/sample_boxes.hpp"

#include "base/assert.hpp"

#include <limits>

namespace pelt::detail {
namespace {

SampleBox box_of(const Triangle& triangle, const std::vector<Vec3>& positions) {
  SampleBox box = empty_box();
  for (const std::uint32_t v : triangle) {
    const Vec3& p = positions[v];
    const Float4 point(p.x, p.y, p.z, 0);
    enclose(box, {point, point});
  }
  return box;
}

}  // namespace

SampleBox empty_box() {
  const float infinity = std::numeric_limits<float>::infinity();
  return {Float4(infinity), Float4(-infinity)};
}

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
