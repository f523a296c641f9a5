#include "tools/pelt/bench/moving_measure.hpp"

#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"

namespace pelt::tools::bench {
namespace {

/// The palettes of a step and of the frame before it.
struct Scenery {
  scene::Palettes before, from, to;
};

struct StepTime {
  double all_us = 0, update_us = 0;
};

/// Runs one repetition: the step before untimed, then this step.
Result<StepTime> repeat_once(MovingRunner& runner, const Scenery& palettes,
                             MovingQuestion question) {
  for (const scene::Palettes* end : {&palettes.before, &palettes.from})
    if (const auto posed = runner.advance(*end); !posed) return posed.error();
  runner.ask(question);
  Stopwatch watch;
  if (const auto posed = runner.advance(palettes.to); !posed) return posed.error();
  watch.lap();
  runner.ask(question);
  watch.stop();
  return StepTime{watch.microseconds(), watch.lap_microseconds()};
}

Result<StepTime> median_time(MovingRunner& runner, const Scenery& palettes, MovingQuestion question,
                             std::uint32_t repetitions) {
  std::vector<double> all, update;
  for (std::uint32_t r = 0; r < repetitions; ++r) {
    const Result<StepTime> time = repeat_once(runner, palettes, question);
    if (!time) return time.error();
    all.push_back(time->all_us);
    update.push_back(time->update_us);
  }
  return StepTime{output::median(all), output::median(update)};
}

/// The steps of one question to one method, one after the other.
class MovingSeries {
 public:
  void add(const StepTime& time, bool is_in_contact) {
    all_.push_back(time.all_us);
    update_.push_back(time.update_us);
    if (is_in_contact) in_contact_.push_back(time.all_us);
  }

  MovingTimes times() const {
    if (all_.empty()) return {};
    return {output::mean(all_),        output::median(all_),
            output::mean(in_contact_), output::percentile(all_, 0.95),
            output::mean(update_),     all_.size(),
            in_contact_.size()};
  }

 private:
  std::vector<double> all_, update_, in_contact_;
};

}  // namespace

Result<std::vector<std::vector<MovingTimes>>> measure_moving(
    const MovingSubject& subject, std::span<const MovingBenchMethod> methods,
    std::span<const MovingQuestion> questions, std::uint32_t repetitions,
    const std::function<void()>& advance) {
  std::vector<MovingRunner> runners;
  for (const MovingBenchMethod& method : methods)
    runners.emplace_back(subject.colliders, method.make());
  std::vector series(methods.size(), std::vector<MovingSeries>(questions.size()));
  asset::SampleScratch scratch;
  Scenery palettes;
  for (const Step& step : subject.steps) {
    scene::sample_palettes(subject.scene, step.before, scratch, palettes.before);
    scene::sample_palettes(subject.scene, step.from, scratch, palettes.from);
    scene::sample_palettes(subject.scene, step.to, scratch, palettes.to);
    for (std::size_t m = 0; m < runners.size(); ++m) {
      for (std::size_t q = 0; q < questions.size(); ++q) {
        if (!runners[m].answers(questions[q])) continue;
        const auto time = median_time(runners[m], palettes, questions[q], repetitions);
        if (!time) return in_step(step, time.error());
        series[m][q].add(*time, !runners[m].found().contacts.empty());
      }
      advance();
    }
  }
  std::vector<std::vector<MovingTimes>> times;
  for (const auto& of_method : series) {
    times.emplace_back();
    for (const MovingSeries& of_question : of_method) times.back().push_back(of_question.times());
  }
  return times;
}

}  // namespace pelt::tools::bench
