#pragma once

/// Query of `pelt distance --from` for one frame, its totals and its output.

#include "tools/pelt/query/distance_query.hpp"

#include <vector>

namespace pelt::tools::query {

/// Nearest point of a collider to a point.
struct Nearest {
  std::uint32_t collider = 0;
  ClosestPoint closest;
};

/// Nearest points on each collider, for each point: in the current frame, and over all frames.
class NearestQuery final : public FrameQuery {
 public:
  NearestQuery(const scene::StagedScene& staged, std::vector<Vec3> points,
               const DistanceSettings& settings);

  QueryStats ask(std::span<Pose> poses) override;
  void keep(std::uint32_t frame) override;

  const char* format() const override { return "pelt-distance"; }
  nlohmann::ordered_json options_json() const override;
  void write_frame(scene::JsonLine& line) const override;
  void write_totals(scene::JsonLine& line) const override;
  void print(std::size_t frames, std::ostream& words) const override;

 private:
  std::span<const Nearest> of_point(std::size_t point) const;
  nlohmann::ordered_json place_json(const Nearest& nearest) const;

  scene::StagedScene staged_;
  std::vector<Vec3> points_;
  DistanceSettings settings_;
  Scratch scratch_;
  std::vector<Nearest> found_;  // [points][colliders]
  std::vector<ClosestPoint> of_pose_;
  std::vector<Nearest> least_;  // [points]
  std::vector<std::uint32_t> least_frame_;
};

}  // namespace pelt::tools::query
