#pragma once

/// Query of `pelt bounds` for one frame, and its totals.

#include <pelt/bounds.hpp>
#include <pelt/groups.hpp>

#include "tools/pelt/query/bounds_scene.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace pelt::tools::query {

/// The box of nothing.
constexpr Box empty_box() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}

/// Something that has bounds: a collider, or what one of its joints moves.
struct Bounded {
  std::uint32_t collider = 0;
  std::optional<std::uint32_t> joint = std::nullopt;
  Box box = {};
  std::optional<Sphere> sphere = std::nullopt;  ///< joints have none
  Box all_frames = empty_box();
  float largest_radius = 0;
};

class BoundsQuery {
 public:
  BoundsQuery(std::span<const scene::Collider> colliders, const BoundsSettings& settings);

  QueryStats ask(std::span<Pose> poses);

  /// Keeps what all frames together need.
  void keep(std::uint32_t frame);

  std::span<const Bounded> answers() const { return bounded_; }

 private:
  void add_joints(std::uint32_t collider, const SkinnedModel& model);
  Box joint_box(const Pose& pose, const Groups& groups, std::uint32_t joint) const;

  BoundsKind kind_;
  std::vector<Groups> groups_;  // of each collider, by joint only
  std::vector<Bounded> bounded_;
};

}  // namespace pelt::tools::query
