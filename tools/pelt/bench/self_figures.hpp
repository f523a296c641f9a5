#pragma once

/// What `pelt bench` measures only if instances are queried against themselves.

#include "tools/pelt/bench/runner.hpp"

namespace pelt::tools::bench {

struct SelfFigures {
  /// The filters of the method self, which are those of `build_self_filter` without options: one
  /// for each model.
  std::uint64_t filter_bytes = 0;
  double filter_build_seconds = 0;

  /// Self-collision of all instances while they play the frames in order, with and without a
  /// tracker per instance: means over the frames of the medians of the plays, in microseconds per
  /// frame.
  double self_us = 0;     ///< self_collide
  double tracked_us = 0;  ///< with SelfTracker
};

/// Plays the frames once untimed, then `repetitions` times. The two queries take turns at every
/// frame. A tracker depends on the frames before, so frames are not repeated alone, as `measure`
/// does.
///
/// Returns an error if a tracker gives other contacts.
Result<SelfFigures> measure_self(const Subject& subject, std::uint32_t repetitions);

}  // namespace pelt::tools::bench
