/// The core of `pelt-lab bench --moving`, with a method that gives wrong answers.

#include "evaluation/bench/moving_bench.hpp"

#include "tools/scene/walkers.hpp"

#include <cmath>
#include <functional>
#include <sstream>

namespace pelt::lab {
namespace {

using Spoil = std::function<void(std::vector<MovingContact>&)>;

/// The method on_demand, with contacts spoilt wherever there are some.
class Spoilt final : public MovingMethod {
 public:
  explicit Spoilt(const Spoil& spoil) : spoil_(spoil) {}

  void add(const SkinnedModel& model) override { method_->add(model); }
  void begin_step() override { method_->begin_step(); }
  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return method_->set_morph_weights(body, weights);
  }
  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return method_->set_palette(body, palette);
  }
  QueryStats collide_at_end(std::uint32_t a, std::uint32_t b,
                            std::vector<Contact>& contacts) override {
    return method_->collide_at_end(a, b, contacts);
  }
  MovingStats collide_moving(std::uint32_t a, std::uint32_t b, std::vector<MovingContact>& contacts,
                             const MovingOptions& options) override {
    const MovingStats work = method_->collide_moving(a, b, contacts, options);
    if (!contacts.empty()) spoil_(contacts);
    return work;
  }
  MovingStats first_contact(std::uint32_t a, std::uint32_t b,
                            std::optional<MovingContact>& first) override {
    return method_->first_contact(a, b, first);
  }
  QueryStats update_work() const override { return method_->update_work(); }

 private:
  std::unique_ptr<MovingMethod> method_ = kMovingOnDemand.make();
  Spoil spoil_;
};

MovingSettings settings_of(std::vector<MovingBenchMethod> methods) {
  MovingSettings settings;
  settings.methods = std::move(methods);
  settings.repetitions = 1;
  return settings;
}

/// The figures, or the message that answers differ.
struct Outcome {
  std::optional<MovingSceneFigures> figures;
  std::string errors;
};

Outcome run(const MovingSettings& settings) {
  std::ostringstream errors;
  auto figures = bench_moving(test::walkers(), settings, errors);
  EXPECT_TRUE(figures) << figures.error().message;
  return {figures ? std::move(*figures) : std::nullopt, errors.str()};
}

TEST(BenchMoving, AllMethodsGiveTheSameAnswers) {
  MovingSettings settings = settings_of({});
  for (const auto& kind : kMovingMethods) settings.methods.push_back(method_of(kind));
  const Outcome outcome = run(settings);
  ASSERT_TRUE(outcome.figures) << outcome.errors;
  const MovingSceneFigures& scene = *outcome.figures;
  EXPECT_EQ(scene.steps, 11u);
  ASSERT_EQ(scene.figures.size(), 19u) << "united finds no first contact";
  std::size_t timed = 0;
  for (const MovingFigures& figures : scene.figures) {
    EXPECT_EQ(figures.times.frames, 11u);
    EXPECT_GT(figures.times.mean_us, figures.times.mean_update_us);
    EXPECT_GT(figures.answer.steps_in_contact, 3u);
    EXPECT_LT(figures.answer.steps_in_contact, 11u);
    EXPECT_LE(figures.answer.work.exact_pairs, figures.answer.work.double_pairs);
    for (const MovingFigures& other : scene.figures)
      EXPECT_EQ(figures.question == other.question, figures.answer.hash == other.answer.hash);
    if (figures.question == MovingQuestion::times) ++timed;
  }
  EXPECT_EQ(timed, 4u);
}

TEST(BenchMoving, UnitedBoxesTestMoreTriangles) {
  MovingSettings settings = settings_of({method_of(kMovingUnited), method_of(kMovingOnDemand)});
  settings.questions = {MovingQuestion::pairs};
  const Outcome outcome = run(settings);
  ASSERT_TRUE(outcome.figures) << outcome.errors;
  const auto& figures = outcome.figures->figures;
  EXPECT_GT(figures.at(0).answer.work.triangle_pairs,
            5 * figures.at(1).answer.work.triangle_pairs / 4);
}

TEST(BenchMoving, RefusesWrongContactsTimesAndFeatures) {
  const std::pair<const char*, Spoil> spoils[] = {
      {"pairs", [](auto& contacts) { contacts.pop_back(); }},
      {"times",
       [](auto& contacts) { contacts.back().time = std::nextafter(contacts.back().time, 2.0f); }},
      {"times", [](auto& contacts) { contacts.back().at_start = !contacts.back().at_start; }},
      {"times", [](auto& contacts) { ++contacts.back().b.number; }}};
  for (const auto& [query, spoil] : spoils) {
    const MovingBenchMethod spoilt = {"spoilt",
                                      [&spoil = spoil] { return std::make_unique<Spoilt>(spoil); }};
    MovingSettings settings = settings_of({method_of(kMovingOnDemand), spoilt});
    settings.program = "pelt-lab";
    const Outcome outcome = run(settings);
    EXPECT_FALSE(outcome.figures);
    EXPECT_EQ(outcome.errors.find("pelt-lab: internal error: walkers: spoilt gives the hash "), 0u)
        << outcome.errors;
    EXPECT_NE(outcome.errors.find(std::string(" to the query ") + query + ", brute gives "),
              std::string::npos)
        << outcome.errors;
  }
}

TEST(BenchMoving, RefusesAMethodThatMissesThatAPairTouches) {
  const MovingBenchMethod spoilt = {
      "spoilt", [] { return std::make_unique<Spoilt>([](auto& all) { all.clear(); }); }};
  MovingSettings settings = settings_of({spoilt});
  settings.questions = {MovingQuestion::touch};
  const Outcome outcome = run(settings);
  EXPECT_FALSE(outcome.figures);
}

TEST(BenchMoving, StepsStayWithinTheChosenFrames) {
  const scenes::Scene scene = test::walkers();
  EXPECT_EQ(choose_steps(scene, tools::arguments::FrameRange{9, 12, 1})->size(), 2u)
      << "no step begins with the last";
  EXPECT_EQ(choose_steps(scene, tools::arguments::FrameRange{0, 12, 3})->size(), 4u);
  const auto none = choose_steps(scene, tools::arguments::FrameRange{11, 12, 1});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message.find("--frames: no step begins with these frames"), 0u);
}

}  // namespace
}  // namespace pelt::lab
