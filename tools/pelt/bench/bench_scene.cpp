#include "tools/pelt/bench/bench_scene.hpp"

#include "text/format.hpp"
#include "text/printable.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/output/progress.hpp"

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

/// The answers of the reference, with the work of a method that answers nothing: all figures of a
/// query have the same hash.
Answers with_work_of(const Answers& answers, Answers reference) {
  for (std::size_t q = 0; q < answers.size(); ++q) reference[q].work = answers[q].work;
  return reference;
}

/// The first question to which a method gives another answer than the reference, or the number of
/// questions.
std::size_t first_difference(const Answers& answers, const Answers& expected) {
  const auto is_same = [](const Answer& a, const Answer& b) { return a.hash == b.hash; };
  return static_cast<std::size_t>(
      std::mismatch(answers.begin(), answers.end(), expected.begin(), is_same).first -
      answers.begin());
}

/// Returns the answers [methods], or an empty list if methods disagree.
Result<std::vector<Answers>> ask_all(const Subject& subject, const BenchSettings& settings,
                                     std::ostream& errors) {
  const BenchMethod reference = reference_of(subject, settings);
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
    const std::size_t q = first_difference(*answers, *expected);
    if (q < answers->size()) {
      print_disagreement(settings.program, subject.scene, method.name, (*answers)[q].hash, "",
                         reference.name, (*expected)[q].hash, errors);
      return std::vector<Answers>();
    }
    all.push_back(*answers);
  }
  return all;
}

std::vector<Variant> variants_of(const BenchSettings& settings) {
  std::vector<Variant> variants;
  for (const Question question : settings.questions)
    for (const Cache& cache : settings.caches) variants.push_back({question, cache});
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
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const BenchMethod& method = settings.methods[m];
      figures.push_back({method.name, method.asked, method.threads, variants[v].question,
                         variants[v].cache.name, answers[m][question], (*times)[m][v]});
    }
  }
  return figures;
}

}  // namespace

Result<std::optional<SceneFigures>> bench_scene(const scenes::Scene& scene,
                                                const BenchSettings& settings,
                                                std::ostream& errors) {
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
  if (answers->empty()) return std::optional<SceneFigures>();
  SceneFigures figures = {scene.name,
                          0,
                          frames->size(),
                          settings.repetitions,
                          time_of(settings.methods),
                          prepared->models,
                          {},
                          {},
                          {}};
  for (const scene::Collider& collider : prepared->colliders)
    figures.triangles += collider.model.triangle_count();
  auto measured = measure_all(subject, settings, *answers);
  if (!measured) return measured.error();
  figures.figures = std::move(*measured);
  const Result<Skinning> skinning = measure_skinning(subject, settings.repetitions);
  if (!skinning) return skinning.error();
  figures.skinning = *skinning;
  if (settings.is_self) {
    const Result<SelfFigures> self = measure_self(subject, settings.repetitions);
    if (!self) return self.error();
    figures.self = *self;
  }
  return std::optional(std::move(figures));
}

void print_disagreement(const std::string& program, const scenes::Scene& scene,
                        const std::string& method, std::uint64_t hash, const std::string& question,
                        const std::string& reference, std::uint64_t expected,
                        std::ostream& errors) {
  errors << program << ": internal error: " << text::printable(scene.name) << ": " << method
         << " gives the hash " << text::hex16(hash) << question << ", " << reference << " gives "
         << text::hex16(expected) << ": please report this with the scene\n";
}

}  // namespace pelt::tools::bench
