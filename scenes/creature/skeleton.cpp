#include "scenes/creature/skeleton.hpp"

#include "base/assert.hpp"

#include <string>

namespace pelt::scenes {
namespace {

/// Joints beyond the first twenty, in the order in which larger skeletons add them. The last is
/// added alone, so that every count is possible.
struct Addition {
  const char* name;
  bool on_both_sides;
};
constexpr Addition kAdditions[] = {
    {"clavicle", true},  {"spine_2", false}, {"jaw", false},      {"tail_4", false},
    {"ear_1", true},     {"thumb_1", true},  {"index_1", true},   {"middle_1", true},
    {"little_1", true},  {"neck_2", false},  {"tail_6", false},   {"tail_2", false},
    {"thumb_2", true},   {"index_2", true},  {"middle_2", true},  {"tail_3", false},
    {"little_2", true},  {"tail_5", false},  {"toe_inner", true}, {"toe_middle", true},
    {"toe_outer", true}, {"ear_2", true},    {"index_3", true},   {"middle_3", true},
    {"little_3", true},  {"tail_7", false},  {"tail_8", false},
};

std::vector<std::uint32_t> joints_of(const Addition& addition, const BodyPlan& plan) {
  const std::string name = addition.name;
  if (!addition.on_both_sides) return {find_joint(plan, name)};
  return {find_joint(plan, name + "_l"), find_joint(plan, name + "_r")};
}

}  // namespace

std::vector<std::uint32_t> choose_joints(const BodyPlan& plan, std::uint32_t count) {
  PELT_ASSERT(count >= kBaseJoints && count <= kPlanJoints);
  std::vector<bool> kept(plan.joints.size(), true);
  std::uint32_t room = count - kBaseJoints;
  for (const Addition& addition : kAdditions) {
    const std::vector<std::uint32_t> joints = joints_of(addition, plan);
    const bool fits = joints.size() <= room;
    if (fits) room -= static_cast<std::uint32_t>(joints.size());
    for (std::uint32_t joint : joints) kept[joint] = fits;
  }
  PELT_ASSERT(room == 0);
  std::vector<std::uint32_t> stands_for(plan.joints.size());
  for (std::uint32_t j = 0; j < plan.joints.size(); ++j) {
    stands_for[j] = kept[j] ? j : stands_for[plan.joints[j].parent];
  }
  return stands_for;
}

}  // namespace pelt::scenes
