#pragma once

/// The methods of `pelt bench` and their queries. A method is queried pair by pair, or instance by
/// instance against itself, on one thread. The method on_demand can also be queried as a crowd on
/// any number of threads, which share palettes and pairs. Times of several threads are wall times,
/// and so are then the times of all methods of the run.

#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <functional>
#include <optional>
#include <string>

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

/// A method of self_methods.hpp.
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

}  // namespace pelt::tools::bench
