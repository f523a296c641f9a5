#pragma once

/// Query of `pelt bounds` for one frame, its totals and its output.

#include <pelt/bounds.hpp>

#include "tools/pelt/query/frame_query.hpp"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace pelt::tools::query {

enum class BoundsBy { instance, part, joint };

enum class BoundsKind {
  guaranteed,  ///< computed without posing vertices
  exact,       ///< the smallest box
};

struct BoundsSettings {
  BoundsBy by = BoundsBy::instance;
  BoundsKind kind = BoundsKind::guaranteed;
};

/// The box of nothing.
constexpr Box empty_box() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}

/// Something with bounds: a collider, or the vertices of one of its joints.
struct Bounded {
  std::uint32_t collider = 0;
  std::optional<std::uint32_t> joint = std::nullopt;
  Box box = {};
  std::optional<Sphere> sphere = std::nullopt;  ///< joints have none
  Box all_frames = empty_box();
  float largest_radius = 0;
};

class BoundsQuery final : public FrameQuery {
 public:
  BoundsQuery(const scene::StagedScene& staged, const BoundsSettings& settings);

  QueryStats ask(std::span<Pose> poses) override;
  void keep(std::uint32_t frame) override;

  const char* format() const override { return "pelt-bounds"; }
  nlohmann::ordered_json options_json() const override;
  void write_frame(scene::JsonLine& line) const override;
  void write_totals(scene::JsonLine& line) const override;
  void print(std::size_t frames, std::ostream& words) const override;

 private:
  void add_joints(std::uint32_t collider, const SkinnedModel& model);
  QueryStats find_joint_box(const Pose& pose, const VertexGroups& groups, std::uint32_t joint,
                            Box& box) const;
  std::string joint_of(const Bounded& bounded) const;
  std::string name_of(const Bounded& bounded) const;
  nlohmann::ordered_json named_json(const Bounded& bounded) const;
  void print_boxes(std::ostream& words) const;

  scene::StagedScene staged_;
  BoundsSettings settings_;
  std::vector<VertexGroups> groups_;  // of each collider, by joint only
  std::vector<Bounded> bounded_;
};

}  // namespace pelt::tools::query
