#pragma once

/// Measures methods on one scene for `pelt bench`.
///
/// Each repetition of a frame first poses and queries the previous frame, untimed, so that the
/// timed part starts from the state that an animation leaves. The timed part then sets the new
/// palettes and queries all pairs. Scenes may loop, so the last frame comes before the first; a
/// single frame comes before itself. The time of the frame is the median of the repetitions.
/// Sampling the clips is not timed, nor are the palettes of methods whose update does not count.
/// Methods take turns at every frame, so that changes in the load of the machine affect all alike.
/// Time in which the system runs other programs is not counted (stopwatch.hpp).

#include "tools/pelt/bench/bench_method.hpp"

#include <functional>
#include <vector>

namespace pelt::tools::bench {

enum class Cache {
  hot,   ///< as left by the untimed part
  cold,  ///< each thread reads 64 MB between the untimed and the timed part
};

/// A kind of measurement: a query and a state of the caches.
struct Variant {
  Question question = Question::all;
  Cache cache = Cache::hot;
};

/// Times in microseconds per frame.
struct Times {
  double mean_us = 0;          ///< over all frames ...
  double mean_contact_us = 0;  ///< ... over those in contact, 0 where there is none ...
  double p95_us = 0;           ///< ... and the 95th percentile of all frames
  double mean_update_us = 0;   ///< the share of mean_us before the queries: palettes, and for eager
                               ///< methods skinning and boxes
  std::size_t frames = 0, frames_in_contact = 0;
};

/// With fewer repetitions, `pelt bench` says that the measurement is rough.
inline constexpr std::uint32_t kEnoughRepetitions = 9;

/// Largest number of frames measured with cold caches, evenly spaced.
inline constexpr std::size_t kMaxColdFrames = 30;

/// Returns the times [methods][variants]. Calls `advance` after each frame of a method.
Result<std::vector<std::vector<Times>>> measure(const Subject& subject,
                                                std::span<const BenchMethod> methods,
                                                std::span<const Variant> variants,
                                                std::uint32_t repetitions,
                                                const std::function<void()>& advance);

}  // namespace pelt::tools::bench
