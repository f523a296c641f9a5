#pragma once

#include "base/float4.hpp"

#include <pelt/mesh.hpp>

#include <span>
#include <vector>

namespace pelt::detail {

/// A box around a triangle, or around many, in one sample pose.
struct SampleBox {
  Float4 low, high;  ///< fourth lanes are meaningless
};

/// The box around nothing.
SampleBox empty_box();

inline void enclose(SampleBox& box, const SampleBox& other) {
  box.low = min(box.low, other.low);
  box.high = max(box.high, other.high);
}

/// Half the surface of a box. In double: extents of 2^61 do not overflow.
inline double half_area(const SampleBox& box) {
  const Float4 size = box.high - box.low;
  const double x = size[0], y = size[1], z = size[2];
  return x * y + y * z + z * x;
}

/// The boxes of all triangles in all sample poses.
class SampleBoxes {
 public:
  /// `samples` are the posed positions of all vertices in each pose, at least one. Precondition:
  /// finite.
  SampleBoxes(std::span<const Triangle> triangles, std::span<const std::vector<Vec3>> samples);

  std::uint32_t triangle_count() const { return triangle_count_; }
  std::uint32_t sample_count() const { return sample_count_; }

  /// One box for each sample pose.
  const SampleBox* of(std::uint32_t triangle) const {
    return boxes_.data() + std::size_t{triangle} * sample_count_;
  }

 private:
  std::uint32_t triangle_count_, sample_count_;
  std::vector<SampleBox> boxes_;  // [T][S]
};

}  // namespace pelt::detail
