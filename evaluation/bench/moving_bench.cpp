#include "evaluation/bench/moving_bench.hpp"

#include "base/hash.hpp"
#include "scenes/takes.hpp"
#include "text/message.hpp"
#include "tools/pelt/bench/measure.hpp"
#include "tools/pelt/output/progress.hpp"

#include <algorithm>
#include <cstring>
#include <initializer_list>

namespace pelt::lab {
namespace {

namespace bench = tools::bench;
namespace output = tools::output;
using tools::bench::FrameTime;
using tools::bench::median_time;
using tools::bench::Series;
using tools::bench::Stopwatch;

bool is_step(const scenes::Scene& scene, std::uint32_t from) {
  return from + 1 < scene.frame_count &&
         scenes::take_index(scene, from) == scenes::take_index(scene, from + 1);
}

}  // namespace

const char* name_of(MovingQuestion question) {
  constexpr std::array kNames = {"collide", "pairs", "times", "first", "touch"};
  return kNames[static_cast<std::size_t>(question)];
}

Result<std::vector<Step>> choose_steps(const scenes::Scene& scene,
                                       const std::optional<tools::arguments::FrameRange>& chosen) {
  const auto frames = tools::bench::choose_frames(scene, chosen);
  if (!frames) return frames.error();
  std::vector<Step> steps;
  for (const std::uint32_t from : *frames)
    if (is_step(scene, from))
      steps.push_back({from > 0 && is_step(scene, from - 1) ? from - 1 : from, from, from + 1});
  if (steps.empty())
    return text::bad_argument("--frames", "no step begins with these frames",
                              "choose a frame that has a next one");
  return steps;
}

Error in_step(const Step& step, const Error& error) {
  return text::prefixed(
      "step from frame " + std::to_string(step.from) + " to " + std::to_string(step.to), error);
}

MovingBenchMethod method_of(const MovingMethodKind& kind) {
  return {std::string(kind.name), kind.make};
}

MovingRunner::MovingRunner(std::span<const scene::Collider> colliders,
                           const MovingBenchMethod& method)
    : colliders_(colliders), parted_(colliders), method_(method.make()) {
  for (const scene::Collider& collider : colliders_) method_->add(collider.model);
}

Result<void> MovingRunner::advance(const scene::Palettes& palettes) {
  if (Result<void> checked = parted_.check(palettes); !checked) return checked;
  method_->begin_step();
  for (std::uint32_t c = 0; c < colliders_.size(); ++c) {
    const auto posed = scene::set_pose(selection_.select(palettes, colliders_[c]), *method_, c);
    if (!posed) return scene::in_instance(colliders_[c].instance, posed.error());
  }
  return {};
}

void MovingRunner::ask(MovingQuestion question) {
  found_.pairs.clear();
  found_.contacts.clear();
  const auto count = static_cast<std::uint32_t>(colliders_.size());
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = a + 1; b < count; ++b) {
      const std::size_t begin = found_.contacts.size();
      ask_pair(question, a, b);
      if (const std::size_t end = found_.contacts.size(); end > begin)
        found_.pairs.push_back({a, b, begin, end});
    }
}

void MovingRunner::ask_pair(MovingQuestion question, std::uint32_t a, std::uint32_t b) {
  MovingOptions options;
  options.times = question == MovingQuestion::times;
  if (question == MovingQuestion::touch) options.max_contacts = 1;
  if (question == MovingQuestion::collide) {
    discrete_.clear();
    query_work_.QueryStats::operator+=(method_->collide_at_end(a, b, discrete_));
    for (const Contact& contact : discrete_) found_.contacts.push_back({contact, 0, false, {}, {}});
  } else if (question == MovingQuestion::first) {
    std::optional<MovingContact> first;
    query_work_ += method_->first_contact(a, b, first);
    if (first) found_.contacts.push_back(*first);
  } else {
    query_work_ += method_->collide_moving(a, b, found_.contacts, options);
  }
}

MovingStats MovingRunner::work() const {
  MovingStats work = query_work_;
  work.QueryStats::operator+=(method_->update_work());
  return work;
}

namespace {

std::uint32_t bits_of(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// The answer of the steps added so far.
class MovingAnswerSoFar {
 public:
  explicit MovingAnswerSoFar(MovingQuestion question) : question_(question) {}

  void add(const Step& step, const StepAnswer& found, const MovingStats& work) {
    const std::uint32_t frame = question_ == MovingQuestion::collide ? step.to : step.from;
    for (const StepAnswer::Pair& pair : found.pairs) {
      if (question_ == MovingQuestion::touch) {
        add_words({frame, pair.a, pair.b});
        continue;
      }
      for (std::size_t i = pair.begin; i < pair.end; ++i) {
        const Contact& contact = found.contacts[i].contact;
        add_words({frame, pair.a, pair.b, contact.triangle_a, contact.triangle_b});
        if (has_times()) add_time(found.contacts[i]);
      }
    }
    answer_.work += work;
    answer_.steps_in_contact += !found.contacts.empty();
    answer_.contacts += found.contacts.size();
  }

  MovingAnswer answer() const {
    MovingAnswer answer = answer_;
    answer.hash = hash_.value();
    return answer;
  }

 private:
  bool has_times() const {
    return question_ == MovingQuestion::times || question_ == MovingQuestion::first;
  }

  void add_words(std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t word : words) hash_.add_u32(word);
  }

  void add_time(const MovingContact& c) {
    add_words({bits_of(c.time), std::uint32_t{c.at_start}});
    for (const Feature& feature : {c.a, c.b})
      add_words({static_cast<std::uint32_t>(feature.kind), std::uint32_t{feature.number}});
  }

  MovingQuestion question_;
  detail::Fnv1a64 hash_;
  MovingAnswer answer_;
};

MovingStats difference(MovingStats after, const MovingStats& before) {
  after.node_pairs -= before.node_pairs;
  after.refits -= before.refits;
  after.posed_vertices -= before.posed_vertices;
  after.triangle_pairs -= before.triangle_pairs;
  after.double_pairs -= before.double_pairs;
  after.exact_pairs -= before.exact_pairs;
  return after;
}

/// The palettes of the ends of a step.
struct StepPalettes {
  StepPalettes(const scenes::Scene& scene, const Step& step, asset::SampleScratch& scratch) {
    scene::sample_palettes(scene, step.from, scratch, from);
    scene::sample_palettes(scene, step.to, scratch, to);
  }

  Result<void> pose(MovingRunner& runner) const {
    if (Result<void> posed = runner.advance(from); !posed) return posed;
    return runner.advance(to);
  }

  scene::Palettes from, to;
};

/// The palettes of a step and of the frame before it.
struct Scenery {
  scene::Palettes before, from, to;
};

/// Runs one repetition: the step before untimed, then this step.
Result<FrameTime> repeat_once(MovingRunner& runner, const Scenery& palettes,
                              MovingQuestion question) {
  for (const scene::Palettes* end : {&palettes.before, &palettes.from})
    if (const auto posed = runner.advance(*end); !posed) return posed.error();
  runner.ask(question);
  Stopwatch watch;
  if (const auto posed = runner.advance(palettes.to); !posed) return posed.error();
  watch.lap();
  runner.ask(question);
  watch.stop();
  return FrameTime{watch.microseconds(), watch.lap_microseconds()};
}

}  // namespace

Result<std::vector<std::optional<MovingAnswer>>> answer_moving(
    const MovingSubject& subject, const MovingBenchMethod& method,
    std::span<const MovingQuestion> questions) {
  MovingRunner runner(subject.colliders, method);
  std::vector<MovingAnswerSoFar> answers(questions.begin(), questions.end());
  asset::SampleScratch scratch;
  for (const Step& step : subject.steps) {
    const StepPalettes palettes(subject.scene, step, scratch);
    for (std::size_t q = 0; q < questions.size(); ++q) {
      if (!runner.answers(questions[q])) continue;
      const MovingStats before = runner.work();
      if (const auto posed = palettes.pose(runner); !posed) return in_step(step, posed.error());
      runner.ask(questions[q]);
      answers[q].add(step, runner.found(), difference(runner.work(), before));
    }
  }
  std::vector<std::optional<MovingAnswer>> results;
  for (std::size_t q = 0; q < questions.size(); ++q)
    results.push_back(runner.answers(questions[q]) ? std::optional(answers[q].answer())
                                                   : std::nullopt);
  return results;
}

Result<std::vector<std::vector<Times>>> measure_moving(const MovingSubject& subject,
                                                       std::span<const MovingBenchMethod> methods,
                                                       std::span<const MovingQuestion> questions,
                                                       std::uint32_t repetitions,
                                                       const std::function<void()>& advance) {
  std::vector<MovingRunner> runners;
  for (const MovingBenchMethod& method : methods) runners.emplace_back(subject.colliders, method);
  std::vector series(methods.size(), std::vector<Series>(questions.size()));
  asset::SampleScratch scratch;
  Scenery palettes;
  for (const Step& step : subject.steps) {
    scene::sample_palettes(subject.scene, step.before, scratch, palettes.before);
    scene::sample_palettes(subject.scene, step.from, scratch, palettes.from);
    scene::sample_palettes(subject.scene, step.to, scratch, palettes.to);
    for (std::size_t m = 0; m < runners.size(); ++m) {
      for (std::size_t q = 0; q < questions.size(); ++q) {
        if (!runners[m].answers(questions[q])) continue;
        const auto time = median_time(
            repetitions, [&] { return repeat_once(runners[m], palettes, questions[q]); });
        if (!time) return in_step(step, time.error());
        series[m][q].add(*time, !runners[m].found().contacts.empty());
      }
      advance();
    }
  }
  std::vector<std::vector<Times>> times;
  for (const auto& of_method : series) {
    times.emplace_back();
    for (const Series& of_question : of_method) times.back().push_back(of_question.times());
  }
  return times;
}

namespace {

using MovingAnswers = std::vector<std::optional<MovingAnswer>>;  // [questions]

/// The first question to which a method gives another answer than brute force, or the number of
/// questions.
std::size_t first_difference(const MovingAnswers& answers, const MovingAnswers& expected) {
  std::size_t q = 0;
  while (q < answers.size() && (!answers[q] || answers[q]->hash == expected[q]->hash)) ++q;
  return q;
}

/// Returns the answers [methods], or an empty list if methods disagree.
Result<std::vector<MovingAnswers>> ask_all(const MovingSubject& subject,
                                           const MovingSettings& settings, std::ostream& errors) {
  const MovingBenchMethod reference = method_of(kMovingBrute);
  const Result<MovingAnswers> expected = answer_moving(subject, reference, settings.questions);
  if (!expected) return expected.error();
  std::vector<MovingAnswers> all;
  for (const MovingBenchMethod& method : settings.methods) {
    const Result<MovingAnswers> answers = method.name == reference.name
                                              ? expected
                                              : answer_moving(subject, method, settings.questions);
    if (!answers) return answers.error();
    const std::size_t q = first_difference(*answers, *expected);
    if (q < answers->size()) {
      bench::print_disagreement(settings.program, subject.scene, method.name, (*answers)[q]->hash,
                                std::string(" to the query ") + name_of(settings.questions[q]),
                                reference.name, (*expected)[q]->hash, errors);
      return std::vector<MovingAnswers>();
    }
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

}  // namespace

Result<std::optional<MovingSceneFigures>> bench_moving(const scenes::Scene& scene,
                                                       const MovingSettings& settings,
                                                       std::ostream& errors) {
  if (const auto checked = bench::require_two_instances(scene); !checked) return checked.error();
  const auto steps = choose_steps(scene, settings.frames);
  if (!steps) return steps.error();
  const auto colliders =
      scene::make_colliders(scene, scene::Granularity::instance, settings.models);
  if (!colliders) return colliders.error();
  const MovingSubject subject = {scene, *colliders, *steps};
  const auto answers = ask_all(subject, settings, errors);
  if (!answers) return answers.error();
  if (answers->empty()) return std::optional<MovingSceneFigures>();
  auto measured = measure_all(subject, settings, *answers);
  if (!measured) return measured.error();
  std::vector<std::uint32_t> ends;
  for (const Step& step : *steps) ends.push_back(step.to);
  const auto skinning = bench::measure_skinning({scene, *colliders, ends}, settings.repetitions);
  if (!skinning) return skinning.error();
  MovingSceneFigures figures = {scene.name,           0,         steps->size(),
                                settings.repetitions, *skinning, std::move(*measured)};
  for (const scene::Collider& collider : *colliders)
    figures.triangles += collider.model.triangle_count();
  return std::optional(std::move(figures));
}

}  // namespace pelt::lab
