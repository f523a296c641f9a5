#pragma once

/// Query of `pelt distance` for one frame, its totals and its output.

#include <pelt/distance.hpp>

#include "tools/pelt/query/frame_query.hpp"
#include "tools/pelt/query/pair_list.hpp"
#include "tools/pelt/scene/scene_poses.hpp"

#include <limits>
#include <vector>

namespace pelt::tools::query {

struct DistanceSettings {
  /// Largest value of `rows_listed`: each pair of a frame is searched for among the rows.
  static constexpr std::uint32_t kMostRows = 1000;

  scene::Granularity granularity = scene::Granularity::instance;
  double within = std::numeric_limits<double>::infinity();  ///< longer distances are skipped
  std::uint32_t rows_listed = 10;  ///< most rows of the list of the summary
};

/// Distances of all pairs of colliders, or, if `within` is given, of those that are near each
/// other. Memory: O(n) for n colliders, plus the pairs that NearPairs finds and a bounded number of
/// others. With Lists::all, the pairs beyond that number are stored in temporary files.
class DistanceQuery final : public FrameQuery {
 public:
  enum class Lists { closest, all };  ///< `all`: for `write_frame` and `write_totals`

  /// Number of pairs of a frame in memory. They are the hints of the next frame: later pairs have
  /// none. A hint saves time and does not change the answer.
  static constexpr std::size_t kMostHints = 1 << 18;

  DistanceQuery(const scene::StagedScene& staged, const DistanceSettings& settings, Lists lists,
                std::size_t most_hints = kMostHints)
      : staged_(staged), settings_(settings), lists_(lists), most_hints_(most_hints) {}

  QueryStats ask(std::span<Pose> poses) override;
  void keep(std::uint32_t frame) override;
  Result<void> status() const override;

  const char* format() const override { return "pelt-distance"; }
  nlohmann::ordered_json options_json() const override;
  void write_frame(scene::JsonLine& line) const override;
  void write_totals(scene::JsonLine& line) const override;
  void print(const arguments::FrameRange& frames, std::ostream& words) const override;

 private:
  QueryStats ask_pair(std::span<Pose> poses, std::uint32_t a, std::uint32_t b);
  const Distance* find_hint(const PairDistance& pair);
  void set_pair(const PairDistance& pair, nlohmann::ordered_json& entry) const;

  scene::StagedScene staged_;
  DistanceSettings settings_;
  Lists lists_;
  std::size_t most_hints_;
  Scratch scratch_;
  scene::NearPairs near_pairs_;
  std::vector<PairDistance> hints_;  // the first pairs of the frame before
  std::size_t next_hint_ = 0;
  LeastDistances closest_now_{settings_.rows_listed}, closest_{settings_.rows_listed};
  PairList found_{most_hints_};  // in this frame; if not all are listed, those of the next hints
  PairList least_{most_hints_ / 4}, merged_{most_hints_ / 4};  // of all frames, if all are listed
};

}  // namespace pelt::tools::query
