#pragma once

/// Query of `pelt distance` for one frame, its totals and its output.

#include <pelt/distance.hpp>

#include "tools/pelt/query/frame_query.hpp"
#include "tools/pelt/query/least_distances.hpp"

#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace pelt::tools::query {

struct DistanceSettings {
  scene::Granularity granularity = scene::Granularity::instance;
  double within = std::numeric_limits<double>::infinity();  ///< longer distances are skipped
};

/// Distances of all pairs of colliders. Memory: O(n) for n colliders, plus a bounded number of
/// pairs; with Lists::all also the pairs that were found.
class DistanceQuery final : public FrameQuery {
 public:
  enum class Lists { nearest, all };  ///< `all`: for `frame_json` and `totals_json`

  DistanceQuery(const scene::StagedScene& staged, const DistanceSettings& settings, Lists lists);

  QueryStats ask(std::span<Pose> poses) override;
  void keep(std::uint32_t frame) override;

  const char* format() const override { return "pelt-distance"; }
  nlohmann::ordered_json options_json() const override;
  nlohmann::ordered_json frame_json() const override;
  nlohmann::ordered_json totals_json() const override;
  void print(std::size_t frames, std::ostream& words) const override;

 private:
  void found(const PairDistance& pair);
  nlohmann::ordered_json pair_json(const PairDistance& pair) const;

  scene::StagedScene staged_;
  DistanceSettings settings_;
  Lists lists_;
  Scratch scratch_;
  std::vector<Distance> hints_;  // of the first pairs, from the previous frame
  LeastDistances nearest_now_, nearest_;
  std::vector<PairDistance> found_now_;  // if all are listed
  std::map<std::pair<std::uint32_t, std::uint32_t>, PairDistance> least_;
};

}  // namespace pelt::tools::query
