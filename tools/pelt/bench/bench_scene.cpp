#include "tools/pelt/bench/bench_scene.hpp"

#include "asset/printable.hpp"
#include "tools/pelt/bench/bench_frames.hpp"
#include "tools/pelt/bench/bench_self.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/methods/self_methods.hpp"
#include "tools/pelt/output/progress.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <set>

namespace pelt::tools::bench {
namespace {

/// Whether the paper's method has bounds for a model.
bool suits_paper(const scene::Collider& collider) {
  return collider.model.skinning() == pelt::Skinning::linear &&
         collider.model.morph_target_count() == 0;
}

/// The reference for all answers; shares no tree with the fast methods.
BenchMethod reference_of(const Subject& subject, const BenchSettings& settings) {
  if (settings.is_self) return self_method(methods::kSelfBrute);
  const bool is_paper =
      std::all_of(subject.colliders.begin(), subject.colliders.end(), suits_paper);
  return method_of(is_paper ? methods::kPaper : methods::kBrute);
}

struct Prepared {
  std::vector<scene::Collider> colliders;
  ModelFigures models;
};

Result<Prepared> prepare(const scenes::Scene& scene, const arguments::ModelArguments& arguments) {
  Stopwatch watch;
  auto colliders = scene::make_colliders(scene, scene::Granularity::instance, arguments);
  if (!colliders) return colliders.error();
  watch.stop();
  Prepared prepared;
  prepared.colliders = std::move(*colliders);
  prepared.models.build_seconds = watch.microseconds() * 1e-6;
  std::set<const detail::Model*> counted;
  for (const scene::Collider& collider : prepared.colliders) {
    if (!counted.insert(&collider.model.detail()).second) continue;
    prepared.models.triangles += collider.model.triangle_count();
    prepared.models.bytes += collider.model.memory_bytes();
  }
  return prepared;
}

using Answers = std::vector<Answer>;  // [questions]

/// Whether a method gives the answers of the reference. Prints a message if not.
bool agrees(const std::string& where, const std::string& method, const Answers& answers,
            const std::string& reference_name, const Answers& reference, std::ostream& errors) {
  for (std::size_t q = 0; q < answers.size(); ++q) {
    if (answers[q].hash == reference[q].hash) continue;
    errors << where << ": " << method << " gives the hash " << output::hex16(answers[q].hash)
           << ", " << reference_name << " gives " << output::hex16(reference[q].hash)
           << ": please report this with the scene\n";
    return false;
  }
  return true;
}

/// The answers of the reference, with the work of a method that answers nothing: all figures of a
/// query have the same hash.
Answers with_work_of(const Answers& answers, Answers reference) {
  for (std::size_t q = 0; q < answers.size(); ++q) reference[q].work = answers[q].work;
  return reference;
}

/// Returns the answers [methods], or an empty list if methods disagree.
Result<std::vector<Answers>> ask_all(const Subject& subject, const BenchSettings& settings,
                                     std::ostream& errors) {
  const BenchMethod reference = reference_of(subject, settings);
  const std::string where =
      settings.program + ": internal error: " + asset::printable(subject.scene.name);
  const Result<Answers> expected = answer(subject, reference, settings.questions);
  if (!expected) return expected.error();
  std::vector<Answers> all;
  for (const BenchMethod& method : settings.methods) {
    const Result<Answers> answers =
        method.name == reference.name ? expected : answer(subject, method, settings.questions);
    if (!answers) return answers.error();
    if (method.asked == Asked::none) {
      all.push_back(with_work_of(*answers, *expected));
      continue;
    }
    if (!agrees(where, method.name, *answers, reference.name, *expected, errors)) {
      return std::vector<Answers>();
    }
    all.push_back(*answers);
  }
  return all;
}

std::vector<Variant> variants_of(const BenchSettings& settings) {
  std::vector<Variant> variants;
  for (const Question question : settings.questions)
    for (const Cache cache : settings.caches) variants.push_back({question, cache});
  return variants;
}

Result<std::vector<Figures>> measure_all(const Subject& subject, const BenchSettings& settings,
                                         const std::vector<Answers>& answers) {
  const std::vector<Variant> variants = variants_of(settings);
  output::Progress progress(subject.frames.size() * settings.methods.size());
  const auto times = measure(subject, settings.methods, variants, settings.repetitions,
                             [&] { progress.advance(); });
  if (!times) return times.error();
  std::vector<Figures> figures;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const std::size_t question = v / settings.caches.size();
    for (std::size_t e = 0; e < settings.methods.size(); ++e) {
      const BenchMethod& method = settings.methods[e];
      figures.push_back({method.name, method.asked, method.threads, variants[v],
                         answers[e][question], (*times)[e][v]});
    }
  }
  return figures;
}

/// Measures what only instances against themselves have.
Result<void> add_self_figures(const Subject& subject, SceneFigures& scene) {
  const auto filters = measure_self_filters(subject.colliders);
  if (!filters) return filters.error();
  const auto sequence = measure_sequence(subject, scene.repetitions);
  if (!sequence) return sequence.error();
  scene.self_filters = *filters;
  scene.sequence = *sequence;
  return {};
}

}  // namespace

Result<arguments::ExitCode> bench_scene(const scenes::Scene& scene, const BenchSettings& settings,
                                        std::vector<SceneFigures>& figures, std::ostream& errors) {
  if (!settings.is_self) {
    const auto checked =
        require_two_instances(scene, ", or measure each instance against itself with --self");
    if (!checked) return checked.error();
  }
  const auto frames = choose_frames(scene, settings.frames);
  if (!frames) return frames.error();
  const Result<Prepared> prepared = prepare(scene, settings.models);
  if (!prepared) return prepared.error();
  const Subject subject = {scene, prepared->colliders, *frames};
  const auto answers = ask_all(subject, settings, errors);
  if (!answers) return answers.error();
  if (answers->empty()) return arguments::ExitCode::internal;
  const auto measured = measure_all(subject, settings, *answers);
  if (!measured) return measured.error();
  const Result<Skinning> skinning = measure_skinning(subject, settings.repetitions);
  if (!skinning) return skinning.error();
  std::uint64_t triangles = 0;
  for (const scene::Collider& collider : prepared->colliders)
    triangles += collider.model.triangle_count();
  figures.push_back({scene.name,
                     triangles,
                     frames->size(),
                     settings.repetitions,
                     time_of(settings.methods),
                     prepared->models,
                     {},
                     *skinning,
                     {},
                     *measured});
  if (settings.is_self)
    if (const auto added = add_self_figures(subject, figures.back()); !added) return added.error();
  return arguments::ExitCode::success;
}

}  // namespace pelt::tools::bench
