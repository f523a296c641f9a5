#pragma once

/// How `pelt bench` measures engines on one scene.
///
/// Each repetition of a frame first poses and queries the frame before it, untimed, so that the
/// timed part meets the state that an animation leaves, not its own; then the timed part takes the
/// new palettes and queries all pairs. Scenes are taken to loop: the last frame stands before the
/// first, and where there is one frame only, it stands before itself. The median of the repetitions
/// stands for the frame. Sampling of the clips is not timed, nor are the palettes of engines whose
/// update does not count. Engines take turns at every frame, so that all meet the same moods of the
/// machine, and time in which the system runs other programs is not counted (stopwatch.hpp).

#include "tools/pelt/bench/bench_engine.hpp"

#include <functional>
#include <vector>

namespace pelt::tools {

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
                               ///< engines skinning and boxes
  std::size_t frames = 0, frames_in_contact = 0;
};

/// With fewer repetitions, `pelt bench` says that the measurement is rough.
inline constexpr std::uint32_t kEnoughRepetitions = 9;

/// Largest number of frames measured with cold caches, evenly spaced.
inline constexpr std::size_t kMostColdFrames = 30;

/// Returns the times [engines][variants]. Calls `advance` after each frame of an engine.
Result<std::vector<std::vector<Times>>> measure(const Subject& subject,
                                                std::span<const Engine> engines,
                                                std::span<const Variant> variants,
                                                std::uint32_t repetitions,
                                                const std::function<void()>& advance);

}  // namespace pelt::tools
