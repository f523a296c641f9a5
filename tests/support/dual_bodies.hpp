#pragma once

/// Shapes and palettes of bodies with dual quaternion skinning: limbs and soups, with any number of
/// influences, with morph targets and with offsets.

#include "skin/palette.hpp"
#include "skin/palette_lanes.hpp"
#include "support/dual_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace pelt::test {

struct DualKind {
  Turns turns = Turns::small;
  std::uint32_t influences = 4;
  bool is_soup = false;
  bool has_morph_targets = false;
  bool has_offsets = false;
};

inline constexpr std::uint32_t kDualJoints = 9;

/// Lets each vertex of a limb follow the joints that are closest to it.
inline void follow_closest_joints(Shape& shape, std::uint32_t influences) {
  shape.influences_per_vertex = influences;
  shape.joints.clear(), shape.weights.clear();
  for (const Vec3& rest : shape.rest_positions) {
    const double at = double{rest.y} * (shape.joint_count - 1);
    std::vector<std::uint16_t> joints(shape.joint_count);
    std::iota(joints.begin(), joints.end(), std::uint16_t{0});
    std::stable_sort(joints.begin(), joints.end(), [&](std::uint16_t a, std::uint16_t b) {
      return std::fabs(at - a) < std::fabs(at - b);
    });
    joints.resize(influences);
    double sum = 0;
    const auto weight = [&](std::uint16_t j) { return 1 / (0.5 + std::fabs(at - j)); };
    for (const std::uint16_t j : joints) sum += weight(j);
    for (const std::uint16_t j : joints) {
      shape.joints.push_back(j);
      shape.weights.push_back(static_cast<float>(weight(j) / sum));
    }
  }
}

inline Shape make_dual_shape(Random& random, const DualKind& kind, std::uint32_t size) {
  if (kind.is_soup) {
    Shape soup = make_soup(random, 2 * size, kDualJoints, kind.influences,
                           random.chance(0.5) ? Weights::random : Weights::adversarial);
    if (kind.has_morph_targets) add_morph_targets(random, soup, 3, 0.3, 0.2);
    return soup;
  }
  Shape limb = kind.has_morph_targets ? make_morphing_limb(size / 4, 6, kDualJoints)
                                      : make_limb(size / 4, 6, kDualJoints);
  follow_closest_joints(limb, kind.influences);
  return limb;
}

/// A limb that bends, twists, or has each second joint turned by half a turn or nearly so, about
/// its own axis or another one.
inline std::vector<Matrix4> turn_limb(Random& random, Turns turns, const Vec3& at) {
  const double angle = random.uniform(-1, 1);
  switch (turns) {
    case Turns::small:
      return random.chance(0.5) ? twist_limb(kDualJoints, 4 * angle, at)
                                : bend_limb(random, kDualJoints, 0.3 * angle, at);
    case Turns::large:
      return random.chance(0.5) ? twist_limb(kDualJoints, 24 * angle, at)
                                : bend_limb(random, kDualJoints, 3 * angle, at);
    case Turns::far_away:
      return bend_limb(random, kDualJoints, 0.3 * angle, {at.x + 1e5f, at.y, at.z});
    case Turns::any:
      return random_rigid_palette(random, kDualJoints, turns, 0.2);
    case Turns::antipodal:
      break;
  }
  std::vector<Matrix4> palette;
  const Vec3 axis = random.chance(0.5) ? Vec3{0, 1, 0} : random.point(1);
  for (std::uint32_t j = 0; j < kDualJoints; ++j)
    palette.push_back(rotation_about(axis, j % 2 * (3.14159265358979 + 1e-3 * angle),
                                     {0, static_cast<float>(j) / (kDualJoints - 1), 0}, at));
  return palette;
}

/// The same motions as dual quaternions, of either sign.
inline std::vector<float> signed_dual_quaternions(Random& random,
                                                  const std::vector<Matrix4>& palette) {
  std::vector<detail::DualQuaternion> motions(palette.size());
  EXPECT_TRUE(detail::find_rigid_motions(detail::floats_of(palette).data(), palette.size(),
                                         motions.data()));
  std::vector<float> floats;
  for (const detail::DualQuaternion& motion : motions) {
    const float sign = random.chance(0.5) ? -1.0f : 1.0f;
    for (const float f : motion.real) floats.push_back(sign * f);
    for (const float f : motion.dual) floats.push_back(sign * f);
  }
  return floats;
}

/// A palette of such a body near `at`.
inline std::vector<Matrix4> dual_palette(Random& random, const DualKind& kind, const Vec3& at) {
  if (!kind.is_soup) return turn_limb(random, kind.turns, at);
  std::vector<Matrix4> palette = random_rigid_palette(random, kDualJoints, kind.turns, 0.3);
  for (Matrix4& m : palette) m.m[12] += at.x, m.m[13] += at.y, m.m[14] += at.z;
  return palette;
}

}  // namespace pelt::test
