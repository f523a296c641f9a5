#include "evaluation/bench/moving_measure.hpp"

#include "base/hash.hpp"

#include <cstring>
#include <initializer_list>

namespace pelt::lab {
namespace {

using tools::bench::FrameTime;
using tools::bench::median_time;
using tools::bench::Series;
using tools::bench::Stopwatch;

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

}  // namespace pelt::lab
