#pragma once

/// How `pelt bench` measures one method on one scene.
///
/// Each repetition of a frame first poses and queries the frame before it, untimed, so that the
/// timed part meets the state that an animation leaves, not its own; then the timed part takes the
/// new palettes and queries all pairs. The median of the repetitions stands for the frame. Sampling
/// of the clips is not timed. One thread.

#include "tools/pelt/frame_range.hpp"
#include "tools/pelt/scene_query.hpp"

#include <functional>
#include <optional>

namespace pelt::tools {

enum class Question {
  all,    ///< every contact
  first,  ///< whether there is one
};

enum class Cache {
  hot,   ///< as the untimed part left it
  cold,  ///< 64 MB are read between the untimed and the timed part
};

struct BenchSettings {
  Question question = Question::all;
  Cache cache = Cache::hot;
  std::uint32_t repetitions = 9;
  std::optional<FrameRange> frames;  ///< nothing: all of the scene
};

struct Measurement {
  std::uint64_t hash = 0;      ///< of all contacts; for Question::first over u32 frame, a, b, hit
  QueryStats work;             ///< of posing and querying each frame once
  double mean_us = 0;          ///< microseconds a frame over all frames ...
  double mean_contact_us = 0;  ///< ... over those in contact, 0 where there is none ...
  double p95_us = 0;           ///< ... and what 95 % of all frames do not exceed
  double mean_update_us = 0;   ///< the share of mean_us before the queries: palettes, and for eager
                               ///< methods skinning and refit
  std::uint64_t frames = 0, frames_in_contact = 0;
};

/// The answer alone, each frame once: hash, work and counts of frames.
Result<Measurement> answer_once(const scenes::Scene& scene, std::span<const Collider> colliders,
                                bench::MethodKind method, const FrameRange& frames,
                                Question question);

/// Adds the times to what `answer_once` found. `advance` is called after each frame.
Result<void> measure(const scenes::Scene& scene, std::span<const Collider> colliders,
                     bench::MethodKind method, const FrameRange& frames,
                     const BenchSettings& settings, const std::function<void()>& advance,
                     Measurement& measurement);

}  // namespace pelt::tools
