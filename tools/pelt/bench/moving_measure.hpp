#pragma once

/// Measures methods on the steps of a scene for `pelt bench --moving`.
///
/// Each repetition of a step first queries the step before it, untimed, so that the timed part
/// starts from the state that an animation leaves: the start of the step is the end of the step
/// before, with all nodes that its query opened. The timed part then sets the palettes of the end
/// and queries all pairs. The time of the step is the median of the repetitions. Methods take turns
/// at every step. Sampling the clips is not timed. Time in which the system runs other programs is
/// not counted (stopwatch.hpp).

#include "tools/pelt/bench/moving_answer.hpp"

#include <functional>

namespace pelt::tools::bench {

/// Times in microseconds per step.
struct MovingTimes {
  double mean_us = 0, median_us = 0;  ///< over all steps ...
  double mean_contact_us = 0;         ///< ... over those in contact, 0 where there is none ...
  double p95_us = 0;                  ///< ... and the 95th percentile of all steps
  double mean_update_us = 0;  ///< the share of mean_us before the queries: palettes, and for eager
                              ///< methods skinning and boxes
  std::size_t steps = 0, steps_in_contact = 0;
};

/// Returns the times [methods][questions]; those of questions that a method does not answer have 0
/// steps. Calls `advance` after each step of a method.
Result<std::vector<std::vector<MovingTimes>>> measure_moving(
    const MovingSubject& subject, std::span<const MovingBenchMethod> methods,
    std::span<const MovingQuestion> questions, std::uint32_t repetitions,
    const std::function<void()>& advance);

}  // namespace pelt::tools::bench
