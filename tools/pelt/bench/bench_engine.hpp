#pragma once

/// What `pelt bench` compares: engines, and what they are asked about a scene. An engine is a
/// method, asked pair by pair on one thread, or on_demand asked as a crowd, on any number of
/// threads, which share palettes and pairs. What several threads take is wall time, and then so are
/// the times of all engines beside them.

#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <functional>
#include <string>

namespace pelt::tools {

enum class Question {
  all,    ///< every contact
  first,  ///< whether there is one
};

enum class Asked {
  pairs,  ///< each pair of instances by itself
  crowd,  ///< all at once
};

struct Engine {
  std::string name;
  std::function<scene::SceneQuery(std::span<const scene::Collider>)> make;
  Asked asked = Asked::pairs;
  std::uint32_t threads = 1;
};

Engine engine_of(methods::MethodKind method);

/// On demand.
Engine crowd_engine(std::uint32_t threads);

/// Kind of times of engines that are measured together.
Time time_of(std::span<const Engine> engines);

/// What to run. Borrows its members.
struct Subject {
  const scenes::Scene& scene;
  std::span<const scene::Collider> colliders;
  std::span<const std::uint32_t> frames;
};

/// An engine with the colliders of a scene.
class Runner {
 public:
  Runner(std::span<const scene::Collider> colliders, const Engine& engine)
      : query_(engine.make(colliders)), threads_(engine.threads) {}

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

}  // namespace pelt::tools
