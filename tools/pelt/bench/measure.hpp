#pragma once

/// The methods of `pelt bench`, and how they are measured on one scene.
///
/// A method is queried pair by pair, or instance by instance against itself, on one thread. The
/// method on_demand can also be queried as a crowd on any number of threads, which share palettes
/// and pairs. With several threads, the times of all methods of the run are wall times.
///
/// Each repetition of a frame first poses and queries the previous frame, untimed, so that the
/// timed part starts from the state that an animation leaves. The timed part then sets the new
/// palettes and queries all pairs. Scenes may loop, so the last frame comes before the first; a
/// single frame comes before itself. The time of the frame is the median of the repetitions.
/// Sampling the clips is not timed, nor are the palettes of methods whose update does not count.
/// Methods take turns at every frame, so that changes in the load of the machine affect all alike.
/// Time in which the system runs other programs is not counted (stopwatch.hpp).

#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::bench {

enum class Question {
  all,    ///< every contact
  first,  ///< whether there is a contact
};

enum class Asked {
  pairs,  ///< each pair of instances separately
  crowd,  ///< all pairs at once
  self,   ///< each instance against itself
  none,   ///< nothing, see methods::kBoxes
};

const char* name_of(Question question);
const char* name_of(Asked asked);
const char* name_of(Time time);

/// A method, and how it is queried.
struct BenchMethod {
  std::string name;
  std::function<scene::SceneQuery(std::span<const scene::Collider>)> make;
  Asked asked = Asked::pairs;
  std::uint32_t threads = 1;
};

BenchMethod method_of(methods::MethodKind method);

/// One of the methods for a character against itself.
BenchMethod self_method(methods::MethodKind method);

/// The method on_demand as a crowd.
BenchMethod crowd_method(std::uint32_t threads);

/// Kind of time of methods that are measured together.
Time time_of(std::span<const BenchMethod> methods);

/// A scene whose frames are queried. Borrows its members.
struct Subject {
  const scenes::Scene& scene;
  std::span<const scene::Collider> colliders;
  std::span<const std::uint32_t> frames;
};

/// The chosen frames, or all if nullopt. Returns an error if the scene has fewer frames.
Result<std::vector<std::uint32_t>> choose_frames(
    const scenes::Scene& scene, const std::optional<arguments::FrameRange>& chosen);

/// Returns an error if there is no pair of instances. `alternative` ends its message.
Result<void> require_two_instances(const scenes::Scene& scene, const std::string& alternative = "");

/// A method with the colliders of a scene.
class Runner {
 public:
  Runner(std::span<const scene::Collider> colliders, const BenchMethod& method)
      : query_(method.make(colliders)), threads_(method.threads) {}

  std::uint32_t threads() const { return threads_; }

  Result<void> pose(const scene::Palettes& palettes) { return query_.set_palettes(palettes); }
  bool update_counts() const { return query_.update_counts(); }

  void ask(Question question);

  /// Result of the last frame.
  const scene::FrameContacts& found() const { return found_; }
  QueryStats work() const { return query_.work(); }

 private:
  scene::SceneQuery query_;
  std::uint32_t threads_;
  scene::FrameContacts found_;
};

/// Prefixes an error with its frame.
Error in_frame(std::uint32_t frame, const Error& error);

/// Answers of a method to one query, with each frame queried once.
struct Answer {
  std::uint64_t hash = 0;  ///< all: of all contacts, see ContactHash; first: FNV-1a 64 over u32
                           ///< frame, a, b, whether they touch (0 or 1), of all pairs queried
  QueryStats work;         ///< work of posing and querying
  std::uint64_t frames_in_contact = 0;
  std::uint64_t contacts = 0;  ///< found in all frames
};

/// The answers [questions] of a method, for comparison with others. Times nothing.
Result<std::vector<Answer>> answer(const Subject& subject, const BenchMethod& method,
                                   std::span<const Question> questions);

/// The state of the caches in the timed part.
struct Cache {
  std::string name = "hot";  ///< hot: as the untimed part left them

  /// Called before the timed part with the number of threads of the method, unless empty.
  std::function<void(std::uint32_t threads)> prepare = {};

  /// Largest number of frames that are measured, evenly spaced.
  std::size_t most_frames = std::numeric_limits<std::size_t>::max();
};

/// A kind of measurement.
struct Variant {
  Question question = Question::all;
  Cache cache = {};
};

/// The time of a frame, and of that the time before its queries.
struct FrameTime {
  double all_us = 0, update_us = 0;
};

/// The medians of repetitions. `once` runs one repetition.
Result<FrameTime> median_time(std::uint32_t repetitions,
                              const std::function<Result<FrameTime>()>& once);

/// Times in microseconds per frame.
struct Times {
  double mean_us = 0, median_us = 0;  ///< over all frames ...
  double mean_contact_us = 0;         ///< ... over those in contact, 0 where there is none ...
  double p95_us = 0;                  ///< ... and the 95th percentile of all frames
  double mean_update_us = 0;  ///< the share of mean_us before the queries: palettes, and for eager
                              ///< methods skinning and boxes
  std::size_t frames = 0, frames_in_contact = 0;

  double mean_query_us() const { return mean_us - mean_update_us; }
};

/// The frames of one query to one method, one after the other.
class Series {
 public:
  void add(const FrameTime& time, bool is_in_contact);
  Times times() const;

 private:
  std::vector<double> all_, update_, in_contact_;
};

/// With fewer repetitions, `pelt bench` says that the measurement is rough.
inline constexpr std::uint32_t kEnoughRepetitions = 9;

/// Returns the times [methods][variants]. Calls `advance` after each frame of a method.
Result<std::vector<std::vector<Times>>> measure(const Subject& subject,
                                                std::span<const BenchMethod> methods,
                                                std::span<const Variant> variants,
                                                std::uint32_t repetitions,
                                                const std::function<void()>& advance);

/// The time to pose all vertices of all instances with the wide code, as a unit for comparing
/// methods.
struct Skinning {
  std::uint64_t vertices = 0;  ///< of all instances
  double mean_us = 0;          ///< per frame

  double ns_per_vertex() const { return 1000 * mean_us / static_cast<double>(vertices); }
};

/// The mean over the frames of the medians of the repetitions.
Result<Skinning> measure_skinning(const Subject& subject, std::uint32_t repetitions);

/// Measurements of instances that are queried against themselves.
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
