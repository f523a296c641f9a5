#pragma once

/// The queries of `pelt-lab bench --moving`, and a method that answers them for a scene.

#include "evaluation/methods/moving_methods.hpp"
#include "scenes/scene.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"

#include <functional>
#include <span>
#include <string>

namespace pelt::lab {

namespace scene = tools::scene;

enum class MovingQuestion {
  collide,  ///< discrete: the contacts at the end of the step
  pairs,    ///< which triangles touch during the step
  times,    ///< the same with times and features
  first,    ///< the first contact of each pair of instances
  touch,    ///< whether each pair of instances touches during the step
};

inline constexpr std::array kMovingQuestions = {MovingQuestion::collide, MovingQuestion::pairs,
                                                MovingQuestion::times, MovingQuestion::first,
                                                MovingQuestion::touch};

const char* name_of(MovingQuestion question);

/// A step from one frame to the next.
struct Step {
  std::uint32_t before = 0;  ///< frame before `from`; `from` if none is before it in its take
  std::uint32_t from = 0, to = 0;
};

/// The steps that begin with the chosen frames, or with all if nullopt. The last frame of a scene,
/// or of a take, begins no step. Returns an error if there are none.
Result<std::vector<Step>> choose_steps(const scenes::Scene& scene,
                                       const std::optional<tools::arguments::FrameRange>& chosen);

/// Prefixes an error with its step.
Error in_step(const Step& step, const Error& error);

/// A scene whose steps are queried. Borrows its members.
struct MovingSubject {
  const scenes::Scene& scene;
  std::span<const scene::Collider> colliders;
  std::span<const Step> steps;
};

/// A method, and its name.
struct MovingBenchMethod {
  std::string name;
  std::function<std::unique_ptr<MovingMethod>()> make;
};

MovingBenchMethod method_of(const MovingMethodKind& kind);

/// The contacts of one step, pair after pair.
struct StepAnswer {
  /// Instances a < b, and their contacts: [begin, end) of `contacts`, not empty.
  struct Pair {
    std::uint32_t a = 0, b = 0;
    std::size_t begin = 0, end = 0;
  };

  std::vector<Pair> pairs;              ///< pairs in contact, ascending
  std::vector<MovingContact> contacts;  ///< of discrete contacts, only `contact` has a meaning
};

/// A method with the colliders of a scene.
class MovingRunner {
 public:
  /// `colliders` must outlive the runner.
  MovingRunner(std::span<const scene::Collider> colliders, const MovingBenchMethod& method);

  /// Begins a step that ends with these palettes. Error messages name the instance.
  Result<void> advance(const scene::Palettes& palettes);

  bool answers(MovingQuestion question) const {
    return question != MovingQuestion::first || method_->finds_first_contact();
  }

  /// Precondition: `answers(question)`.
  void ask(MovingQuestion question);

  /// Answer to the last question.
  const StepAnswer& found() const { return found_; }

  /// The work of all updates and queries so far.
  MovingStats work() const;

 private:
  void ask_pair(MovingQuestion question, std::uint32_t a, std::uint32_t b);

  std::span<const scene::Collider> colliders_;
  scene::PartedInstances parted_;
  scene::InputSelection selection_;
  std::unique_ptr<MovingMethod> method_;
  std::vector<Contact> discrete_;
  StepAnswer found_;
  MovingStats query_work_;
};

}  // namespace pelt::lab
