#pragma once

/// Query of `pelt distance --from` for one frame, its totals and its output.

#include "tools/pelt/query/distance_query.hpp"

#include <vector>

namespace pelt::tools::query {

/// The closest point of a collider to a given point.
struct PointOnCollider {
  std::uint32_t collider = 0;
  ClosestPoint closest;
};

/// Closest points on each collider, for each point: in the current frame, and over all frames.
class ClosestQuery final : public FrameQuery {
 public:
  ClosestQuery(const scene::StagedScene& staged, std::vector<Vec3> points,
               const DistanceSettings& settings);

  QueryStats ask(std::span<Pose> poses) override;
  void keep(std::uint32_t frame) override;

  const char* format() const override { return "pelt-distance"; }
  nlohmann::ordered_json options_json() const override;
  void write_frame(scene::JsonLine& line) const override;
  void write_totals(scene::JsonLine& line) const override;
  void print(std::size_t frames, std::ostream& words) const override;

 private:
  std::span<const PointOnCollider> of_point(std::size_t point) const;
  nlohmann::ordered_json point_json(const PointOnCollider& point) const;

  scene::StagedScene staged_;
  std::vector<Vec3> points_;
  DistanceSettings settings_;
  Scratch scratch_;
  std::vector<PointOnCollider> found_;  // [points][colliders]
  std::vector<ClosestPoint> of_pose_;
  std::vector<PointOnCollider> least_;  // [points]
  std::vector<std::uint32_t> least_frame_;
};

}  // namespace pelt::tools::query
