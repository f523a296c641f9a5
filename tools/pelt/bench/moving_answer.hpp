#pragma once

/// The answers of methods of `pelt bench --moving`, for comparison. Times nothing.

#include "scenes/scene.hpp"
#include "tools/pelt/bench/moving_runner.hpp"

#include <functional>
#include <optional>

namespace pelt::tools::bench {

/// A method, and its name.
struct MovingBenchMethod {
  std::string name;
  std::function<std::unique_ptr<methods::MovingMethod>()> make;
};

/// A scene whose steps are queried. Borrows its members.
struct MovingSubject {
  const scenes::Scene& scene;
  std::span<const scene::Collider> colliders;
  std::span<const Step> steps;
};

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

/// The answers [questions] of a method; nullopt to those that it does not answer.
Result<std::vector<std::optional<MovingAnswer>>> answer_moving(
    const MovingSubject& subject, const MovingBenchMethod& method,
    std::span<const MovingQuestion> questions);

/// Prefixes an error with its step.
Error in_step(const Step& step, const Error& error);

}  // namespace pelt::tools::bench
