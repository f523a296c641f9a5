#pragma once

/// Crowds for measuring: a crowd of any size of one character that walks on a plain, and the times
/// of its frames. A frame consists of setting all palettes and finding all contacts, both with the
/// same number of threads. Sampling the clips is not timed.

#include <pelt/crowd.hpp>
#include <pelt/model.hpp>

#include "base/workers.hpp"
#include "scenes/scene.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace pelt::programs {

/// The crowd to pose and query.
struct CrowdJob {
  std::vector<SkinnedModel> models;  ///< one per instance
  std::uint32_t frame_count = 0;
  std::function<void(std::uint32_t frame, std::vector<Matrix4>& palettes)> pose;
};

/// Wall times of a frame. Times are medians over the frames; counts are those of the last frame.
struct CrowdTiming {
  double palettes_ms = 0, frame_ms = 0;
  CrowdStats stats;
  std::size_t contacts = 0;
};

class CrowdRun {
 public:
  /// `job` must outlive the run.
  explicit CrowdRun(const CrowdJob& job);

  CrowdTiming run(std::uint32_t threads);

  /// The run with the least time per frame of `runs` runs, because other programs may use the
  /// machine.
  CrowdTiming best_of(std::uint32_t runs, std::uint32_t threads);

  /// Bytes of the crowd without its models.
  std::size_t memory_bytes() const { return crowd_.memory_bytes(); }

 private:
  CrowdTiming time_frame(std::uint32_t frame, std::uint32_t threads);
  void set_palettes(std::uint32_t threads);
  void set_palette(std::uint32_t instance);

  const CrowdJob& job_;
  Crowd crowd_;
  std::vector<std::size_t> firsts_;  // by instance: index into palettes_
  std::vector<Matrix4> palettes_;
  std::vector<CrowdContact> contacts_;
  detail::WorkShares shares_;
  detail::Workers threads_;
};

/// A clip in `count` phases, as palettes of an instance at the origin.
class WalkPhases {
 public:
  static constexpr std::uint32_t kCount = 64;

  explicit WalkPhases(const asset::Asset& asset);

  std::uint32_t joint_count() const { return joint_count_; }
  std::span<const Matrix4> operator[](std::uint32_t phase) const {
    return std::span(palettes_).subspan(std::size_t{phase} * joint_count_, joint_count_);
  }

  /// Six of the palettes, for build_model.
  std::vector<Matrix4> samples() const;

 private:
  std::uint32_t joint_count_;
  std::vector<Matrix4> palettes_;
};

/// Instances in rows, with as many rows as a row has walkers. They walk on the spot in different
/// directions, one phase later in each frame, so the crowd stays as sparse as at the start.
class WalkingCrowd {
 public:
  /// `metre` is in units of the character. `phases` must outlive the crowd.
  WalkingCrowd(const WalkPhases& phases, std::uint32_t count, double metre);

  std::uint32_t count() const { return static_cast<std::uint32_t>(walkers_.size()); }

  /// The palettes of all instances, concatenated.
  void pose(std::uint32_t frame, std::vector<Matrix4>& palettes) const;

 private:
  struct Walker {
    float x, z;
    float forward_x, forward_z;  // a unit vector
    std::uint32_t phase;
  };

  const WalkPhases& phases_;
  std::vector<Walker> walkers_;
};

}  // namespace pelt::programs
