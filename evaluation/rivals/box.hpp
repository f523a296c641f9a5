#pragma once

#include "geometry/box4.hpp"

#include <pelt/mesh.hpp>

#include <cstdint>
#include <cstring>
#include <span>

namespace pelt::rivals {

using detail::Box4;
using detail::Float4;

/// Posed vertices, four floats at a time.
class Points {
 public:
  Points() = default;
  explicit Points(std::span<const Vec3> positions)
      : positions_(positions.data()), last_(static_cast<std::uint32_t>(positions.size() - 1)) {}

  /// Lanes x, y, z; lane 3 is meaningless.
  Float4 operator[](std::uint32_t v) const {
    const Vec3& p = positions_[v];
    return v < last_ ? detail::load4(&p.x) : Float4(p.x, p.y, p.z, 0);
  }

  Box4 box_of(const Triangle& triangle) const {
    const Points& p = *this;
    const Float4 a = p[triangle[0]], b = p[triangle[1]], c = p[triangle[2]];
    return {min(min(a, b), c), max(max(a, b), c)};
  }

  const Vec3* data() const { return positions_; }

 private:
  const Vec3* positions_ = nullptr;
  std::uint32_t last_ = 0;
};

/// The box of the first `count` points.
inline Box4 box_of(const Points& points, std::uint32_t count) {
  Box4 box = detail::empty_box();
  for (std::uint32_t v = 0; v < count; ++v)
    box = {min(box.low, points[v]), max(box.high, points[v])};
  return box;
}

/// Boxes that touch overlap.
inline bool overlap(const Box4& a, const Box4& b) {
  constexpr unsigned kThreeLanes = 7;
  return ((a.low <= b.high) & (b.low <= a.high)).bits() % 8 == kThreeLanes;
}

/// A box and two numbers in half a cache line.
struct alignas(32) NumberedBox {
  float low[3];
  std::uint32_t first;
  float high[3];
  std::uint32_t count;

  Box4 box() const {
    Box4 box;  // the numbers are stored in its unused lanes
    std::memcpy(&box.low, this, sizeof box.low);
    std::memcpy(&box.high, reinterpret_cast<const char*>(this) + 16, sizeof box.high);
    return box;
  }

  void set_box(const Box4& box) {
    const std::uint32_t numbers[] = {first, count};
    std::memcpy(static_cast<void*>(this), &box.low, sizeof box.low);
    std::memcpy(reinterpret_cast<char*>(this) + 16, &box.high, sizeof box.high);
    first = numbers[0], count = numbers[1];
  }
};

}  // namespace pelt::rivals
