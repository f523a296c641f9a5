#pragma once

/// Models with dual quaternion skinning, and palettes of rigid joints, for tests.

#include "support/random.hpp"
#include "support/skinned_shapes.hpp"

#include <pelt/model.hpp>

#include <cstdint>
#include <vector>

namespace pelt::test {

inline constexpr ModelOptions kDual = {.skinning = Skinning::dual_quaternion};

enum class Turns {
  small,      ///< joints within 60 degrees of each other
  large,      ///< within 179 degrees
  any,        ///< anything, with quaternions of either sign
  antipodal,  ///< half turns about random axes, so that quaternions are nearly orthogonal
  far_away,   ///< any, 1e5 units from the origin
};

inline constexpr Turns kAllTurns[] = {Turns::small, Turns::large, Turns::any, Turns::antipodal,
                                      Turns::far_away};

inline Matrix4 random_rigid(Random& random, Turns turns, double spread) {
  constexpr double kDegree = 3.14159265358979 / 180;
  Vec3 translation = random.point(spread);
  double angle = random.uniform(0, 720) * kDegree;
  if (turns == Turns::small) angle = random.uniform(0, 30) * kDegree;
  if (turns == Turns::large) angle = random.uniform(0, 89.5) * kDegree;
  if (turns == Turns::antipodal)
    angle = random.chance(0.5) ? 0 : (180 + random.uniform(-1e-3, 1e-3)) * kDegree;
  if (turns == Turns::far_away) translation.x += 1e5f;
  return rotation_about(random.point(1), angle, random.point(1), translation);
}

inline std::vector<Matrix4> random_rigid_palette(Random& random, std::uint32_t joint_count,
                                                 Turns turns, double spread) {
  std::vector<Matrix4> palette;
  for (std::uint32_t j = 0; j < joint_count; ++j)
    palette.push_back(random_rigid(random, turns, spread));
  return palette;
}

/// A palette that twists a limb about its own axis, by up to `angle` over its length.
inline std::vector<Matrix4> twist_limb(std::uint32_t joint_count, double angle,
                                       const Vec3& placement) {
  std::vector<Matrix4> palette;
  for (std::uint32_t j = 0; j < joint_count; ++j)
    palette.push_back(
        rotation_about({0, 1, 0}, angle * j / std::max(1u, joint_count - 1), {}, placement));
  return palette;
}

}  // namespace pelt::test
