#pragma once

/// How `pelt bench` asks and measures engines on one scene.
///
/// Each repetition of a frame first poses and queries the frame before it, untimed, so that the
/// timed part meets the state that an animation leaves, not its own; then the timed part takes the
/// new palettes and queries all pairs. The median of the repetitions stands for the frame. Sampling
/// of the clips is not timed, nor are the palettes of engines whose update does not count. Engines
/// take turns at every frame, so that all meet the same moods of the machine, and time in which the
/// system runs other programs is not counted (stopwatch.hpp).
///
/// On demand may also be asked as a crowd, on any number of threads, which share palettes and
/// pairs. What several threads take is wall time, and then so are the times of all engines beside
/// them.

#include "tools/pelt/scene_query.hpp"
#include "tools/pelt/stopwatch.hpp"

#include <functional>
#include <string>

namespace pelt::tools {

enum class Question {
  all,    ///< every contact
  first,  ///< whether there is one
};

enum class Cache {
  hot,   ///< as the untimed part left it
  cold,  ///< each thread reads 64 MB between the untimed and the timed part
};

/// What is measured of an engine.
struct Variant {
  Question question = Question::all;
  Cache cache = Cache::hot;
};

enum class Asked {
  pairs,  ///< each pair of instances by itself
  crowd,  ///< all at once
};

struct Engine {
  std::string name;
  std::function<SceneQuery(std::span<const Collider>)> make;
  Asked asked = Asked::pairs;
  std::uint32_t threads = 1;
};

Engine engine_of(bench::MethodKind method);

/// On demand.
Engine crowd_engine(std::uint32_t threads);

/// What the times of engines mean that are measured together.
Time time_of(std::span<const Engine> engines);

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
