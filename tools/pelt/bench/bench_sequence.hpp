#pragma once

#include "tools/pelt/bench/bench_method.hpp"

namespace pelt::tools::bench {

/// Self-collision of all instances while they play the frames in order, with and without a tracker
/// per instance. Means over the frames of the medians of the plays, in microseconds per frame.
struct SequenceFigures {
  double self_us = 0;     ///< self_collide
  double tracked_us = 0;  ///< with SelfTracker
};

/// Plays the frames once untimed, then `repetitions` times. The two queries take turns at every
/// frame. A tracker depends on the frames before, so frames are not repeated alone, as `measure`
/// does.
///
/// Returns an error if a tracker gives other contacts.
Result<SequenceFigures> measure_sequence(const Subject& subject, std::uint32_t repetitions);

}  // namespace pelt::tools::bench
