#pragma once

/// Runs `pelt-lab bench --anytime` on scenes: builds models, compares the contacts of all complete
/// searches with those of `collide`, and measures what is known before the end.
///
/// First, every search runs to its end in small slices, which are not timed: what it knows after a
/// share of its work is counted and does not depend on the machine. Then the time of a share is
/// measured: the instances are posed anew, so that no box or vertex is computed yet, and a search
/// that starts from there runs without a break until that share of its work is done. The time of a
/// share is the median of the repetitions. The methods take turns at every case.

#include "evaluation/bench/anytime_figures.hpp"
#include "evaluation/methods/anytime_methods.hpp"
#include "scenes/scene.hpp"
#include "tools/pelt/bench/bench_scene.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"

#include <functional>
#include <optional>

namespace pelt::lab {

namespace scene = tools::scene;

/// A method, and its names.
struct AnytimeBenchMethod {
  std::string name, title;
  std::function<std::unique_ptr<AnytimeMethod>()> make;
};

AnytimeBenchMethod method_of(const AnytimeMethodKind& kind);

/// Two instances that are in contact in a frame.
struct AnytimeCase {
  std::uint32_t frame = 0, a = 0, b = 0;
  std::uint64_t contacts = 0;
};

class AnytimeRunner {
 public:
  /// `colliders` must outlive the runner.
  AnytimeRunner(std::span<const scene::Collider> colliders, const AnytimeBenchMethod& method);

  /// Poses both instances of a case, and starts a search of them. Error messages name the instance.
  Result<void> start(const AnytimeCase& of, const scene::Palettes& palettes);

  /// Poses both instances, so that nothing is refitted, and leaves the search to be restarted.
  Result<void> pose(const AnytimeCase& of, const scene::Palettes& palettes);

  AnytimeMethod& method() { return *method_; }

 private:
  std::span<const scene::Collider> colliders_;
  scene::InputSelection selection_;
  std::unique_ptr<AnytimeMethod> method_;
};

/// A scene whose frames are searched. Borrows its members.
struct AnytimeSubject {
  const scenes::Scene& scene;
  std::span<const scene::Collider> colliders;
  std::span<const std::uint32_t> frames;
};

/// The contacts of `collide` in the frames of a scene.
struct AnytimeTruth {
  std::vector<AnytimeCase> cases;
  std::uint64_t hash = 0;  ///< as in `pelt check`
};

Result<AnytimeTruth> find_cases(const AnytimeSubject& subject);

/// Runs a method to its end in each case. Times nothing.
Result<AnytimeRecord> record(const AnytimeSubject& subject, std::span<const AnytimeCase> cases,
                             const AnytimeBenchMethod& method);

/// Measures the times of all curves [methods] of `records`. Returns the time of `collide` for each
/// case, in microseconds. Calls `advance` after each case.
Result<std::vector<double>> measure_anytime(const AnytimeSubject& subject,
                                            std::span<const AnytimeCase> cases,
                                            std::span<const AnytimeBenchMethod> methods,
                                            std::uint32_t repetitions,
                                            std::span<AnytimeRecord> records,
                                            const std::function<void()>& advance);

struct AnytimeSettings {
  std::string program = "pelt-lab";         ///< for messages
  std::vector<AnytimeBenchMethod> methods;  ///< one of them has the name `contacts`
  std::uint32_t repetitions = tools::bench::kEnoughRepetitions;
  std::optional<tools::arguments::FrameRange> frames;  ///< nullopt: all frames of the scene
  tools::arguments::ModelArguments models;
};

/// Returns the scene's figures. If a complete search differs from `collide`, prints its name to
/// `errors`, measures nothing, and returns nullopt.
Result<std::optional<AnytimeSceneFigures>> bench_anytime(const scenes::Scene& scene,
                                                         const AnytimeSettings& settings,
                                                         std::ostream& errors);

/// An area of a method over that of the method `paper`; nullopt if `paper` was not measured, or
/// lists nothing in time.
std::optional<double> of_paper(const AnytimeSceneFigures& scene,
                               const AnytimeMethodFigures& figures,
                               double AnytimeMethodFigures::*area);

void print_figures(const AnytimeSceneFigures& scene, std::ostream& out);

/// A scene of --json.
tools::bench::Row scene_json(const AnytimeSceneFigures& scene);

}  // namespace pelt::lab
