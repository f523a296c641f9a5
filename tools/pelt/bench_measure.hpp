#pragma once

/// How `pelt bench` asks and measures engines on one scene.
///
/// Each repetition of a frame first poses and queries the frame before it, untimed, so that the
/// timed part meets the state that an animation leaves, not its own; then the timed part takes the
/// new palettes and queries all pairs. The median of the repetitions stands for the frame. Sampling
/// of the clips is not timed, nor are the palettes of engines whose update does not count. Engines
/// take turns at every frame, so that all meet the same moods of the machine, and time in which the
/// system runs other programs is not counted (stopwatch.hpp). One thread.

#include "tools/pelt/scene_query.hpp"

#include <functional>
#include <string>

namespace pelt::tools {

enum class Question {
  all,    ///< every contact
  first,  ///< whether there is one
};

enum class Cache {
  hot,   ///< as the untimed part left it
  cold,  ///< 64 MB are read between the untimed and the timed part
};

/// What is measured of an engine.
struct Variant {
  Question question = Question::all;
  Cache cache = Cache::hot;
  std::uint32_t threads = 1;
};

struct Engine {
  std::string name;
  std::function<std::unique_ptr<bench::Method>()> make;
};

Engine engine_of(bench::MethodKind method);

/// What is run. Borrows.
struct Subject {
  const scenes::Scene& scene;
  std::span<const Collider> colliders;
  std::span<const std::uint32_t> frames;
};

/// What an engine says to one question, each frame asked once.
struct Answer {
  std::uint64_t hash = 0;  ///< of all contacts; for Question::first over u32 frame, a, b, hit
  QueryStats work;         ///< of posing and querying
  std::uint64_t frames_in_contact = 0;
};

/// The answers [questions].
Result<std::vector<Answer>> answer(const Subject& subject, const Engine& engine,
                                   std::span<const Question> questions);

/// Microseconds a frame.
struct Times {
  double mean_us = 0;          ///< over all frames ...
  double mean_contact_us = 0;  ///< ... over those in contact, 0 where there is none ...
  double p95_us = 0;           ///< ... and what 95 % of all frames do not exceed
  double mean_update_us = 0;   ///< the share of mean_us before the queries: palettes, and for eager
                               ///< engines skinning and boxes
  std::size_t frames = 0, frames_in_contact = 0;
};

/// With cold caches no more frames than this are measured, evenly over all.
inline constexpr std::size_t kMostColdFrames = 30;

/// The times [engines][variants]. `advance` is called after each frame of an engine.
Result<std::vector<std::vector<Times>>> measure(const Subject& subject,
                                                std::span<const Engine> engines,
                                                std::span<const Variant> variants,
                                                std::uint32_t repetitions,
                                                const std::function<void()>& advance);

}  // namespace pelt::tools
