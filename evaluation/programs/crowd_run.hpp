#pragma once

/// The frames of a crowd, timed. A frame is all palettes set, by as many threads as then ask for
/// the contacts, and all contacts found; sampling the clips is not counted.

#include <pelt/crowd.hpp>

#include "base/work_shares.hpp"
#include "base/workers.hpp"

#include <functional>
#include <vector>

namespace pelt::programs {

/// What is posed and asked.
struct CrowdJob {
  std::vector<SkinnedModel> models;  ///< of each instance
  std::uint32_t frame_count = 0;
  std::function<void(std::uint32_t frame, std::vector<Matrix4>& palettes)> pose;
};

/// Of a frame in wall time; times are medians over the frames, counts those of the last one.
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

  /// The one of so many runs with the least time of a frame, for others may use the machine too.
  CrowdTiming best_of(std::uint32_t runs, std::uint32_t threads);

  /// Bytes of the crowd, without its models.
  std::size_t memory_bytes() const { return crowd_.memory_bytes(); }

 private:
  CrowdTiming time_frame(std::uint32_t frame, std::uint32_t threads);
  void set_palettes(std::uint32_t threads);
  void set_palette(std::uint32_t instance);

  const CrowdJob& job_;
  Crowd crowd_;
  std::vector<std::size_t> firsts_;  // of each instance, into palettes_
  std::vector<Matrix4> palettes_;
  std::vector<CrowdContact> contacts_;
  detail::WorkShares shares_;
  detail::Workers threads_;
};

}  // namespace pelt::programs
