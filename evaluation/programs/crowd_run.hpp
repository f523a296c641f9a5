#pragma once

/// Times the frames of a crowd. A frame consists of setting all palettes and finding all contacts,
/// both with the same number of threads. Sampling the clips is not timed.

#include <pelt/crowd.hpp>

#include "base/workers.hpp"

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

}  // namespace pelt::programs
