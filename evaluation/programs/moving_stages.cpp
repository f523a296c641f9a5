/// Measures each stage of the test of two moving triangles on the pairs that the query between
/// frames tests in a scene: the time per pair, and the share of pairs that reach the stage.
///
/// Times are medians of several runs over all pairs of a step, added up over the steps. Few pairs
/// or none reach the exact stage, so its time is that of a sample of all pairs. Nothing is printed
/// if a stage contradicts the filtered test.

#include "evaluation/programs/moving_stage.hpp"
#include "evaluation/programs/program.hpp"
#include "motion/moving_tree.hpp"
#include "scenes/scene.hpp"
#include "text/format.hpp"
#include "tools/pelt/bench/figures.hpp"
#include "tools/pelt/output/statistics.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <pelt/config.hpp>

#include <cstdio>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace pelt::programs {

MovingStage active_moving_stage() {
#ifdef PELT_HAS_AVX2
  if (active_instruction_set() == InstructionSet::avx2) return avx2::kMovingStage;
#endif
#ifdef PELT_HAS_SIMD128
  if (active_instruction_set() == InstructionSet::simd128) return simd128::kMovingStage;
#endif
  return scalar::kMovingStage;
}

namespace {

namespace bench = tools::bench;

using detail::CertainAnswer;
using Answers = std::vector<CertainAnswer>;
using Candidates = std::span<const MovingCandidate>;

/// One of so many pairs is also given to the exact stage.
constexpr std::size_t kExactSample = 500;

struct Arguments {
  std::string scene;
  std::uint32_t first = 0, steps = UINT32_MAX, runs = 5;
};

detail::TriangleCorners corners(const PaddedCorners& padded) {
  detail::TriangleCorners result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = {padded[k][0], padded[k][1], padded[k][2]};
  return result;
}

detail::MovingTriangle triangle_a(const MovingCandidate& c) {
  return {corners(c.a_from), corners(c.a_to)};
}
detail::MovingTriangle triangle_b(const MovingCandidate& c) {
  return {corners(c.b_from), corners(c.b_to)};
}

/// Time and pairs of a stage over all steps.
struct StageTotal {
  double microseconds = 0;
  std::size_t pairs = 0, decided = 0;
};

/// The stages of one question.
struct QuestionTotals {
  StageTotal in_float, in_double;
};

class StageCosts {
 public:
  explicit StageCosts(std::uint32_t runs) : runs_(runs) {}

  /// Adds the pairs of a step. Returns false if a stage contradicts the filtered test.
  bool add(Candidates candidates) {
    if (candidates.empty()) return true;
    expected_.clear();
    MovingStats work;
    for (const MovingCandidate& c : candidates)
      expected_.push_back(intersect_while_moving(triangle_a(c), triangle_b(c), work));
    add_exact(candidates);
    return add_question(candidates, true, pairs_) && add_question(candidates, false, times_);
  }

  void print(const std::string& name) const {
    std::cout << name << ": " << pairs_.in_float.pairs << " pairs of triangles\n";
    constexpr bench::Column kColumns[] = {{"stage", "stage"},
                                          {"us", "us per pair", 3},
                                          {"tested", "pairs tested"},
                                          {"decided", "of these decided"}};
    const bench::Row rows[] = {
        row("float, pairs", pairs_.in_float), row("double, pairs", pairs_.in_double),
        row("float, times", times_.in_float), row("double, times", times_.in_double),
        row("exact, a sample", exact_)};
    bench::print_table(kColumns, rows, std::cout, {16, 17});
    std::cout.flush();
    const std::size_t pairs = pairs_.in_float.pairs;
    const auto exact_share = [&](const QuestionTotals& q) {
      const std::size_t left = q.in_double.pairs - q.in_double.decided;
      return pairs == 0 ? 0 : 100.0 * static_cast<double>(left) / static_cast<double>(pairs);
    };
    std::printf("exact stage: %.4f %% of the pairs, with times %.4f %%\n", exact_share(pairs_),
                exact_share(times_));
  }

 private:
  bench::Row row(const char* stage, const StageTotal& total) const {
    if (total.pairs == 0)
      return {{"stage", stage}, {"us", nullptr}, {"tested", nullptr}, {"decided", nullptr}};
    const auto per_cent = [](std::size_t part, std::size_t of, int decimals) {
      return text::fixed(100 * static_cast<double>(part) / static_cast<double>(of), decimals) +
             " %";
    };
    return {{"stage", stage},
            {"us", total.microseconds / static_cast<double>(total.pairs)},
            {"tested", per_cent(total.pairs, pairs_.in_float.pairs, 3)},
            {"decided", per_cent(total.decided, total.pairs, 2)}};
  }

  double time_of(const std::function<void()>& work) const {
    std::vector<double> times;
    for (std::uint32_t run = 0; run < runs_; ++run) times.push_back(microseconds(work));
    return tools::output::median(times);
  }

  bool add_question(Candidates candidates, bool finds_meetings, QuestionTotals& totals) {
    const MovingStage stage = active_moving_stage();
    Answers answers(candidates.size());
    totals.in_float.microseconds +=
        time_of([&] { stage.decide(candidates, finds_meetings, answers.data()); });
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (answers[i] == CertainAnswer::unknown)
        left.push_back(i);
      else if ((answers[i] == CertainAnswer::yes) != expected_[i])
        return false;
    }
    totals.in_float.pairs += candidates.size();
    totals.in_float.decided += candidates.size() - left.size();
    return add_double(candidates, left, finds_meetings, totals.in_double);
  }

  bool add_double(Candidates candidates, const std::vector<std::size_t>& left, bool finds_meetings,
                  StageTotal& total) {
    Answers answers(left.size());
    total.microseconds += time_of([&] {
      for (std::size_t i = 0; i < left.size(); ++i)
        answers[i] = answer_in_double(candidates[left[i]], finds_meetings);
    });
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (answers[i] == CertainAnswer::unknown) continue;
      if ((answers[i] == CertainAnswer::yes) != expected_[left[i]]) return false;
      ++total.decided;
    }
    total.pairs += left.size();
    return true;
  }

  static CertainAnswer answer_in_double(const MovingCandidate& c, bool finds_meetings) {
    if (finds_meetings) return certainly_intersect(triangle_a(c), triangle_b(c));
    std::optional<detail::FirstMeeting> meeting;
    if (!find_certain_first_meeting(triangle_a(c), triangle_b(c), meeting))
      return CertainAnswer::unknown;
    return meeting ? CertainAnswer::yes : CertainAnswer::no;
  }

  void add_exact(Candidates candidates) {
    for (std::size_t i = 0; i < candidates.size(); i += kExactSample) {
      exact_.microseconds += microseconds([&] {
        (void)detail::first_meeting(triangle_a(candidates[i]), triangle_b(candidates[i]));
      });
      ++exact_.pairs;
      ++exact_.decided;
    }
  }

  std::uint32_t runs_;
  std::vector<bool> expected_;
  QuestionTotals pairs_, times_;
  StageTotal exact_;
};

/// The poses of all instances at both ends of a step.
class SteppedScene {
 public:
  SteppedScene(const scenes::Scene& scene, const std::vector<tools::scene::Collider>& colliders)
      : scene_(scene) {
    for (const tools::scene::Collider& collider : colliders) {
      from_.emplace_back(collider.model);
      to_.emplace_back(collider.model);
    }
  }

  /// Calls visit(candidates) for each pair of instances. Returns false if a call does.
  template <typename Visit>
  Result<bool> visit_step(std::uint32_t frame, const Visit& visit) {
    for (auto [poses, end] : {std::pair{&from_, frame}, std::pair{&to_, frame + 1}}) {
      tools::scene::sample_palettes(scene_, end, sampling_, palettes_);
      for (std::size_t i = 0; i < poses->size(); ++i)
        if (const auto set = (*poses)[i].set_palette(palettes_[i]); !set) return set.error();
    }
    for (std::size_t a = 0; a < from_.size(); ++a)
      for (std::size_t b = a + 1; b < from_.size(); ++b) {
        const detail::Step step_a = detail::step_of({from_[a], to_[a]});
        const detail::Step step_b = detail::step_of({from_[b], to_[b]});
        candidates_.clear();
        active_moving_stage().collect(step_a.tree(), step_b.tree(), scratch_.detail(), candidates_);
        if (!visit(Candidates(candidates_.begin(), candidates_.size()))) return false;
      }
    return true;
  }

 private:
  const scenes::Scene& scene_;
  std::vector<Pose> from_, to_;
  asset::SampleScratch sampling_;
  tools::scene::Palettes palettes_;
  Scratch scratch_;
  detail::Stack<MovingCandidate> candidates_;
};

constexpr Program kProgram = {
    "moving_stages", "Measure the stages of the test of moving triangles on the steps of a scene"};

int run(const Arguments& arguments) {
  const Result<scenes::Scene> scene = scenes::load_scene(arguments.scene);
  if (!scene) return fail(kProgram, scene.error().message);
  const auto colliders =
      tools::scene::make_colliders(*scene, tools::scene::Granularity::instance, {});
  if (!colliders) return fail(kProgram, colliders.error().message);
  SteppedScene stepped(*scene, *colliders);
  StageCosts costs(arguments.runs);
  for (std::uint32_t frame = arguments.first;
       frame + 1 < scene->frame_count && frame - arguments.first < arguments.steps; ++frame) {
    const Result<bool> agrees =
        stepped.visit_step(frame, [&](Candidates candidates) { return costs.add(candidates); });
    if (!agrees) return fail(kProgram, agrees.error().message);
    if (!*agrees) return fail(kProgram, "the answers differ in frame " + std::to_string(frame));
  }
  costs.print(scene->name);
  return 0;
}

int parse_and_run(int argc, char** argv) {
  CLI::App app(kProgram.description);
  Arguments arguments;
  app.add_option("SCENE", arguments.scene, "A scene file (.json)")->required();
  app.add_option("--first", arguments.first, "Frame with which the first step begins");
  app.add_option("--steps", arguments.steps, "Number of steps (default: all)");
  app.add_option("--runs", arguments.runs, "Runs of each stage, of which the median counts");
  CLI11_PARSE(app, argc, argv);
  return run(arguments);
}

}  // namespace
}  // namespace pelt::programs

int main(int argc, char** argv) { return pelt::programs::parse_and_run(argc, argv); }
