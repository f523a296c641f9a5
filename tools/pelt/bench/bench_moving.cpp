#include "tools/pelt/bench/bench_moving.hpp"

#include "asset/printable.hpp"
#include "scenes/takes.hpp"
#include "tools/pelt/bench/bench_frames.hpp"
#include "tools/pelt/bench/bench_skinning.hpp"
#include "tools/pelt/methods/moving_methods.hpp"
#include "tools/pelt/output/progress.hpp"
#include "tools/pelt/output/text.hpp"

namespace pelt::tools::bench {
namespace {

using MovingAnswers = std::vector<std::optional<MovingAnswer>>;  // [questions]

bool is_step(const scenes::Scene& scene, std::uint32_t from) {
  return from + 1 < scene.frame_count &&
         scenes::take_index(scene, from) == scenes::take_index(scene, from + 1);
}

/// Whether a method gives the answers of brute force. Prints a message if not.
bool agrees(const std::string& where, const std::string& method, const MovingSettings& settings,
            const MovingAnswers& answers, const MovingAnswers& expected, std::ostream& errors) {
  for (std::size_t q = 0; q < answers.size(); ++q) {
    if (!answers[q] || answers[q]->hash == expected[q]->hash) continue;
    errors << where << ": " << method << " gives the hash " << output::hex16(answers[q]->hash)
           << " to the query " << name_of(settings.questions[q]) << ", "
           << methods::kMovingBrute.name << " gives " << output::hex16(expected[q]->hash)
           << ": please report this with the scene\n";
    return false;
  }
  return true;
}

/// Returns the answers [methods], or an empty list if methods disagree.
Result<std::vector<MovingAnswers>> ask_all(const MovingSubject& subject,
                                           const MovingSettings& settings, std::ostream& errors) {
  const std::string where =
      settings.program + ": internal error: " + asset::printable(subject.scene.name);
  const MovingBenchMethod reference = moving_method_of(methods::kMovingBrute);
  const Result<MovingAnswers> expected = answer_moving(subject, reference, settings.questions);
  if (!expected) return expected.error();
  std::vector<MovingAnswers> all;
  for (const MovingBenchMethod& method : settings.methods) {
    const Result<MovingAnswers> answers = method.name == reference.name
                                              ? expected
                                              : answer_moving(subject, method, settings.questions);
    if (!answers) return answers.error();
    if (!agrees(where, method.name, settings, *answers, *expected, errors))
      return std::vector<MovingAnswers>();
    all.push_back(*answers);
  }
  return all;
}

Result<std::vector<MovingFigures>> measure_all(const MovingSubject& subject,
                                               const MovingSettings& settings,
                                               const std::vector<MovingAnswers>& answers) {
  output::Progress progress(subject.steps.size() * settings.methods.size());
  const auto times = measure_moving(subject, settings.methods, settings.questions,
                                    settings.repetitions, [&] { progress.advance(); });
  if (!times) return times.error();
  std::vector<MovingFigures> figures;
  for (std::size_t q = 0; q < settings.questions.size(); ++q)
    for (std::size_t m = 0; m < settings.methods.size(); ++m)
      if (answers[m][q])
        figures.push_back(
            {settings.methods[m].name, settings.questions[q], *answers[m][q], (*times)[m][q]});
  return figures;
}

/// The time to skin all vertices at the ends of the steps.
Result<Skinning> measure_skinning_of(const MovingSubject& subject, std::uint32_t repetitions) {
  std::vector<std::uint32_t> ends;
  for (const Step& step : subject.steps) ends.push_back(step.to);
  return measure_skinning({subject.scene, subject.colliders, ends}, repetitions);
}

}  // namespace

Result<std::vector<Step>> choose_steps(const scenes::Scene& scene,
                                       const std::optional<arguments::FrameRange>& chosen) {
  const auto frames = choose_frames(scene, chosen);
  if (!frames) return frames.error();
  std::vector<Step> steps;
  for (const std::uint32_t from : *frames)
    if (is_step(scene, from))
      steps.push_back({from > 0 && is_step(scene, from - 1) ? from - 1 : from, from, from + 1});
  if (steps.empty())
    return output::bad_argument("--frames", "no step begins with these frames",
                                "choose a frame that has a next one");
  return steps;
}

MovingBenchMethod moving_method_of(const methods::MovingMethodKind& kind) {
  return {std::string(kind.name), kind.make};
}

Result<arguments::ExitCode> bench_moving(const scenes::Scene& scene, const MovingSettings& settings,
                                         std::vector<MovingSceneFigures>& figures,
                                         std::ostream& errors) {
  if (const auto checked = require_two_instances(scene); !checked) return checked.error();
  const auto steps = choose_steps(scene, settings.frames);
  if (!steps) return steps.error();
  const auto colliders =
      scene::make_colliders(scene, scene::Granularity::instance, settings.models);
  if (!colliders) return colliders.error();
  const MovingSubject subject = {scene, *colliders, *steps};
  const auto answers = ask_all(subject, settings, errors);
  if (!answers) return answers.error();
  if (answers->empty()) return arguments::ExitCode::internal;
  const auto measured = measure_all(subject, settings, *answers);
  if (!measured) return measured.error();
  const Result<Skinning> skinning = measure_skinning_of(subject, settings.repetitions);
  if (!skinning) return skinning.error();
  std::uint64_t triangles = 0;
  for (const scene::Collider& collider : *colliders) triangles += collider.model.triangle_count();
  figures.push_back({scene.name, triangles, skinning->vertices, steps->size(), settings.repetitions,
                     skinning->mean_us, *measured});
  return arguments::ExitCode::success;
}

}  // namespace pelt::tools::bench
