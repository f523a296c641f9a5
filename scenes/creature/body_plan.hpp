#pragma once

#include "scenes/creature/flesh.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace pelt::scenes {

inline constexpr std::uint32_t kPlanJoints = 64;
inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// The proportions that the seed varies; 1 is the middle.
struct Proportions {
  double leg = 1, girth = 1, head = 1, snout = 1, ear = 1, arm = 1, tail = 1, hand = 1, foot = 1;
};

Proportions draw_proportions(std::uint32_t seed);

/// A joint. At rest, its frame has the axes of the world.
struct PlanJoint {
  std::string name;
  std::uint32_t parent = kNone;  ///< has a lower index
  Vec3d position;
};

/// Positions of the features of a face, in coordinates of the head: x to its left, y up, z
/// forwards.
struct HeadFrame {
  Vec3d origin;
  double scale = 1;
  double snout = 0;  ///< z of its tip, in the head's coordinates

  Vec3d at(double x, double y, double z) const { return origin + scale * Vec3d(x, y, z); }
};

/// The whole creature at rest: 1.8 units tall, y up, facing +z, arms half raised, feet on y = 0.
/// Names end in "_l" on the left, where x > 0, and in "_r" on the right.
struct BodyPlan {
  std::vector<PlanJoint> joints;  ///< [kPlanJoints], "hips" first
  Flesh flesh;                    ///< muscles refer to plan joints
  HeadFrame head;
};

BodyPlan make_body_plan(const Proportions& proportions);

/// Head, neck and ears of a plan, placed so that the neck starts on the ground. "neck_1" is the
/// first joint.
BodyPlan bust_of(const BodyPlan& plan);

/// Index of the joint. Precondition: the name exists.
std::uint32_t find_joint(const BodyPlan& plan, const std::string& name);

}  // namespace pelt::scenes
