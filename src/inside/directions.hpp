#pragma once

#include <pelt/math.hpp>

#include <array>
#include <cstdint>

namespace pelt::detail {

/// Not in one plane, and in no plane that people put triangles in.
inline constexpr std::array<Vec3, 3> kAxes = {
    {{0.8391f, 0.4772f, 0.2613f}, {-0.3178f, 0.8845f, 0.3417f}, {0.1239f, -0.4381f, 0.8903f}}};

/// An endless list of directions, the same each time.
class Directions {
 public:
  const Vec3& current() const { return current_; }

  void next() { current_ = {coordinate(), coordinate(), coordinate()}; }

 private:
  /// Between -1 and 1, never zero; by a linear congruential generator (Knuth's MMIX constants).
  float coordinate() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<float>(static_cast<std::int32_t>(state_ >> 32) | 1) * 0x1p-31f;
  }

  std::uint64_t state_ = 1;
  Vec3 current_ = kAxes[0];
};

}  // namespace pelt::detail
