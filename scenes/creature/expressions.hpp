#pragma once

/// Expressions of a face, and the clip in which it talks.

#include <pelt/asset.hpp>

#include "scenes/creature/body_plan.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pelt::scenes {

/// The morph targets of a face, in this order.
enum Expression : std::size_t {
  kJawOpen,
  kSmile,
  kBlinkLeft,
  kBlinkRight,
  kBrowsUp,
  kCheeksPuffed,
  kExpressions,
};

inline constexpr std::array<const char*, kExpressions> kExpressionNames = {
    "jaw_open", "smile", "blink_l", "blink_r", "brows_up", "cheeks_puffed"};

/// Displacements of the skin of a bust in each expression.
class Expressions {
 public:
  explicit Expressions(const BodyPlan& bust);

  /// Displacement of a point on the skin; exactly zero beyond the reach of the expression.
  Vec3d displacement(Expression expression, const Vec3d& point) const;

 private:
  Vec3d open_jaw(const Vec3d& point) const;

  const BodyPlan& bust_;
  std::uint32_t jaw_;  ///< index of the joint
};

/// The clip "talk" of a bust whose plan joints have these nodes, kNone for omitted joints. Node 0
/// has the morph targets.
asset::Clip talk_clip(const BodyPlan& bust, std::span<const std::uint32_t> nodes);

}  // namespace pelt::scenes
