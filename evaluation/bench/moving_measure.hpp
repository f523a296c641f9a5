#pragma once

/// Asks and measures methods on the steps of a scene for `pelt-lab bench --moving`.
///
/// Each repetition of a step first queries the step before it, untimed, so that the timed part
/// starts from the state that an animation leaves: the start of the step is the end of the step
/// before, with all nodes that its query opened. The timed part then sets the palettes of the end
/// and queries all pairs. The time of the step is the median of the repetitions. Methods take turns
/// at every step. Sampling the clips is not timed. Time in which the system runs other programs is
/// not counted (stopwatch.hpp).

#include "evaluation/bench/moving_runner.hpp"
#include "tools/pelt/bench/measure.hpp"

namespace pelt::lab {

using tools::bench::Times;

/// Answers of a method to one question, with each step queried once.
struct MovingAnswer {
  /// FNV-1a 64 over little-endian u32. touch: `from`, a, b of each pair of instances that touches.
  /// Other questions: `from`, a, b, triangle_a, triangle_b of each contact; times and first append
  /// the bits of the time, at_start, and kind and number of both features. For collide, `to`
  /// replaces `from`, as in `pelt check`.
  std::uint64_t hash = 0;
  MovingStats work;  ///< of posing and querying
  std::uint64_t steps_in_contact = 0;
  std::uint64_t contacts = 0;  ///< found in all steps
};

/// The answers [questions] of a method, for comparison with others; nullopt to those that it does
/// not answer.
Result<std::vector<std::optional<MovingAnswer>>> answer_moving(
    const MovingSubject& subject, const MovingBenchMethod& method,
    std::span<const MovingQuestion> questions);

/// Returns the times [methods][questions]; those of questions that a method does not answer have 0
/// frames. A frame of these times is a step. Calls `advance` after each step of a method.
Result<std::vector<std::vector<Times>>> measure_moving(const MovingSubject& subject,
                                                       std::span<const MovingBenchMethod> methods,
                                                       std::span<const MovingQuestion> questions,
                                                       std::uint32_t repetitions,
                                                       const std::function<void()>& advance);

}  // namespace pelt::lab
