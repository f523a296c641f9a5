#pragma once

#include "scenes/creature/body_plan.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::scenes {

inline constexpr std::uint32_t kInfluences = 4;

/// A vertex's joints (plan joints; joint 0 if the weight is 0) and weights, which sum to 1.
struct VertexWeights {
  std::array<std::uint32_t, kInfluences> joints = {};
  std::array<double, kInfluences> weights = {};
};

/// Weights of points on the skin, for a skeleton of `choose_joints`.
///
/// Each joint divides its share of a point between its own muscles and the branches of its
/// children, by their distances; the shares multiply down the skeleton. Weights therefore change
/// smoothly along a limb, and a finger never follows a neighbouring finger, however near, only
/// their common parent.
class SkinWeights {
 public:
  SkinWeights(const BodyPlan& plan, std::span<const std::uint32_t> stands_for);

  VertexWeights at(const Vec3d& point);

 private:
  void measure_distances(const Vec3d& point, double rounding);
  void share_out(double width);
  void share_of(std::uint32_t joint, double width);

  const BodyPlan& plan_;
  std::vector<std::uint32_t> stands_for_;             // [plan joints]
  std::vector<std::uint32_t> joints_;                 // kept joints, parents first
  std::vector<std::vector<std::uint32_t>> children_;  // [plan joints] of the kept joints
  std::vector<std::uint32_t> parent_;                 // [plan joints] of the kept joints
  std::vector<double> own_;                           // [plan joints] distance to own muscles
  std::vector<double> branch_;                        // [plan joints] the same for the branch
  std::vector<double> reach_;                         // [plan joints] share that reaches it
  std::vector<double> weight_;                        // [plan joints] share that stays with it
};

}  // namespace pelt::scenes
