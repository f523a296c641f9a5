#pragma once

#include "geometry/box4.hpp"

#include <pelt/mesh.hpp>

#include <span>
#include <vector>

namespace pelt::detail {

/// The boxes of all triangles in all sample poses.
class SampleBoxes {
 public:
  /// `samples`: posed positions of all vertices in each pose. Precondition: at least one pose, and
  /// all positions are finite.
  SampleBoxes(std::span<const Triangle> triangles, std::span<const std::vector<Vec3>> samples);

  std::uint32_t triangle_count() const { return triangle_count_; }
  std::uint32_t sample_count() const { return sample_count_; }

  /// One box for each sample pose.
  const Box4* of(std::uint32_t triangle) const {
    return boxes_.data() + std::size_t{triangle} * sample_count_;
  }

 private:
  std::uint32_t triangle_count_, sample_count_;
  std::vector<Box4> boxes_;  // [T][S]
};

}  // namespace pelt::detail
