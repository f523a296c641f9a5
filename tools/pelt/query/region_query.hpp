#pragma once

/// Query of `pelt region` for one frame, its totals and its output.

#include <pelt/solid.hpp>

#include "tools/pelt/arguments/region_arguments.hpp"
#include "tools/pelt/query/frame_query.hpp"

#include <array>
#include <vector>

namespace pelt::tools::query {

struct RegionSettings {
  arguments::ChosenRegion region;
  scene::Granularity granularity = scene::Granularity::instance;
  bool finds_triangles = false;
  std::uint32_t stride = 1;  ///< of the frames
};

/// Placement of a collider in the current frame, and number of frames per placement.
struct Placed {
  Placement placement = Placement::outside;
  TrianglesInRegion triangles;
  std::array<std::uint32_t, 3> frames = {};       ///< by placement
  std::vector<std::uint32_t> frames_not_outside;  ///< frame numbers
};

class RegionQuery final : public FrameQuery {
 public:
  RegionQuery(const scene::StagedScene& staged, RegionSettings settings)
      : staged_(staged), settings_(std::move(settings)), placed_(staged.colliders.size()) {}

  QueryStats ask(std::span<Pose> poses) override;
  void keep(std::uint32_t frame) override;

  const char* format() const override { return "pelt-region"; }
  nlohmann::ordered_json options_json() const override;
  void write_frame(scene::JsonLine& line) const override;
  void write_totals(scene::JsonLine& line) const override;
  void print(std::size_t frames, std::ostream& words) const override;

 private:
  scene::StagedScene staged_;
  RegionSettings settings_;
  Scratch scratch_;
  std::vector<Placed> placed_;
};

}  // namespace pelt::tools::query
