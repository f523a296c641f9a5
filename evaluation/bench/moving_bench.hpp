#pragma once

/// Runs `pelt-lab bench --moving` on scenes: builds models, compares the answers of all methods
/// with those of brute force, and measures them.
///
/// Each repetition of a step first queries the step before it, untimed, so that the timed part
/// starts from the state that an animation leaves: the start of the step is the end of the step
/// before, with all nodes that its query opened. The timed part then sets the palettes of the end
/// and queries all pairs. The time of the step is the median of the repetitions. Methods take turns
/// at every step. Sampling the clips is not timed. Time in which the system runs other programs is
/// not counted (stopwatch.hpp).

#include "evaluation/methods/moving_methods.hpp"
#include "scenes/scene.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/bench/bench_scene.hpp"
#include "tools/pelt/bench/measure.hpp"
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

using tools::bench::Times;

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

/// The answers [questions] of a method, for comparison with others; nullopt to those that it does
/// not answer.
Result<std::vector<std::optional<MovingAnswer>>> answer_moving(
    const MovingSubject& subject, const MovingBenchMethod& method,
    std::span<const MovingQuestion> questions);

/// Returns the times [methods][questions]; those of questions that a method does not answer have 0
/// frames. A frame of these times is a step. Calls `advance` after each step of a method.
Result<std::vector<std::vector<Times>>> measure_moving(const MovingSubject& subject,
                                                       std::span<const MovingBenchMethod> methods,
                                                       std::span<const MovingQuestion> questions,
                                                       std::uint32_t repetitions,
                                                       const std::function<void()>& advance);

struct MovingSettings {
  std::string program = "pelt-lab";  ///< for messages
  std::vector<MovingBenchMethod> methods;
  std::vector<MovingQuestion> questions{kMovingQuestions.begin(), kMovingQuestions.end()};
  std::uint32_t repetitions = tools::bench::kEnoughRepetitions;
  std::optional<tools::arguments::FrameRange> frames;  ///< see `choose_steps`
  tools::arguments::ModelArguments models;
};

/// Figures of one question to one method.
struct MovingFigures {
  std::string method;
  MovingQuestion question = MovingQuestion::pairs;
  MovingAnswer answer;
  Times times;  ///< per step
};

struct MovingSceneFigures {
  std::string scene;
  std::uint64_t triangles = 0;  ///< of all instances
  std::uint64_t steps = 0;
  std::uint32_t repetitions = 0;
  tools::bench::Skinning skinning;     ///< at the ends of the steps
  std::vector<MovingFigures> figures;  ///< not empty; grouped by question
};

/// The ratios of the tables and of --against.
inline constexpr tools::bench::Yardstick kMovingYardsticks[] = {
    {"of_collide", "of collide", "on_demand", true, true, "collide"},
    {"of_on_demand", "of on_demand", "on_demand", true, true}};

/// Returns the scene's figures. If the answers of a method differ from those of brute force, prints
/// its name to `errors`, measures nothing, and returns nullopt.
Result<std::optional<MovingSceneFigures>> bench_moving(const scenes::Scene& scene,
                                                       const MovingSettings& settings,
                                                       std::ostream& errors);

void print_figures(const MovingSceneFigures& scene, std::ostream& out);

/// A scene of --json.
tools::bench::Row scene_json(const MovingSceneFigures& scene);

}  // namespace pelt::lab
