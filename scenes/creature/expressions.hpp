#pragma once

#include "scenes/creature/body_plan.hpp"

#include <array>
#include <cstddef>

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

}  // namespace pelt::scenes
