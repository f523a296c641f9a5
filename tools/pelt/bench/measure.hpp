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

#include "tools/pelt/bench/runner.hpp"

#include <limits>
#include <vector>

namespace pelt::tools::bench {

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

}  // namespace pelt::tools::bench
