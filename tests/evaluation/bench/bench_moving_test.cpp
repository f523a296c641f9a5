/// The core of `pelt bench --moving`, with methods that the command does not have.

#include "tools/pelt/bench/bench_moving.hpp"

#include "evaluation/methods/lab_moving_methods.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

namespace pelt::tools::bench {
namespace {

using Spoil = std::function<void(std::vector<MovingContact>&)>;

/// The method on_demand, with contacts spoilt wherever there are some.
class Spoilt final : public methods::MovingMethod {
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
  std::unique_ptr<methods::MovingMethod> method_ = methods::kMovingOnDemand.make();
  Spoil spoil_;
};

/// Two small creatures that walk through each other.
scenes::Scene walkers() {
  scenes::Scene scene;
  scene.name = "walkers";
  Result<scenes::Character> character = scenes::generate_character({1000, 24, 1});
  EXPECT_TRUE(character);
  scene.characters.push_back(std::move(*character));
  scene.fps = 12;
  scene.frame_count = 40;
  scene.instances.resize(2);
  for (const int i : {0, 1}) {
    scene.instances[i].clip = "walk";
    scene.instances[i].translation = {0.05 * i, 0, i == 0 ? -1.4 : 1.4};
    scene.instances[i].rotation = {0, double(i), 0, double(1 - i)};
    scene.instances[i].velocity = {0, 0, i == 0 ? 0.9 : -0.9};
  }
  return scene;
}

MovingSettings settings_of(std::vector<MovingBenchMethod> methods) {
  MovingSettings settings;
  settings.methods = std::move(methods);
  settings.repetitions = 1;
  return settings;
}

struct Outcome {
  arguments::ExitCode exit;
  std::vector<MovingSceneFigures> figures;
  std::string errors;
};

Outcome run(const scenes::Scene& scene, const MovingSettings& settings) {
  Outcome outcome = {};
  std::ostringstream errors;
  const auto exit = bench_moving(scene, settings, outcome.figures, errors);
  EXPECT_TRUE(exit);
  outcome.exit = *exit;
  outcome.errors = errors.str();
  return outcome;
}

TEST(BenchMoving, AllMethodsGiveTheSameAnswers) {
  MovingSettings settings = settings_of({});
  for (const auto& kind : lab::kLabMovingMethods)
    settings.methods.push_back(moving_method_of(kind));
  const Outcome outcome = run(walkers(), settings);
  ASSERT_EQ(outcome.exit, arguments::ExitCode::success) << outcome.errors;
  const MovingSceneFigures& scene = outcome.figures.at(0);
  EXPECT_EQ(scene.steps, 39u);
  ASSERT_EQ(scene.figures.size(), 19u) << "united finds no first contact";
  std::size_t timed = 0;
  for (const MovingFigures& figures : scene.figures) {
    EXPECT_EQ(figures.times.steps, 39u);
    EXPECT_GT(figures.times.mean_us, figures.times.mean_update_us);
    EXPECT_GT(figures.answer.steps_in_contact, 3u);
    EXPECT_LT(figures.answer.steps_in_contact, 39u);
    EXPECT_LE(figures.answer.work.exact_pairs, figures.answer.work.double_pairs);
    for (const MovingFigures& other : scene.figures)
      EXPECT_EQ(figures.question == other.question, figures.answer.hash == other.answer.hash);
    if (figures.question == MovingQuestion::times) ++timed;
  }
  EXPECT_EQ(timed, 4u);
}

TEST(BenchMoving, UnitedBoxesTestMoreTriangles) {
  MovingSettings settings = settings_of(
      {moving_method_of(lab::kMovingUnited), moving_method_of(methods::kMovingOnDemand)});
  settings.questions = {MovingQuestion::pairs};
  const Outcome outcome = run(walkers(), settings);
  ASSERT_EQ(outcome.exit, arguments::ExitCode::success) << outcome.errors;
  const auto& figures = outcome.figures.at(0).figures;
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
    MovingSettings settings = settings_of({moving_method_of(methods::kMovingOnDemand), spoilt});
    settings.program = "pelt-lab";
    const Outcome outcome = run(walkers(), settings);
    EXPECT_EQ(outcome.exit, arguments::ExitCode::internal);
    EXPECT_TRUE(outcome.figures.empty());
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
  const Outcome outcome = run(walkers(), settings);
  EXPECT_EQ(outcome.exit, arguments::ExitCode::internal);
  EXPECT_TRUE(outcome.figures.empty());
}

TEST(BenchMoving, StepsStayWithinTheChosenFrames) {
  MovingSettings settings = settings_of({moving_method_of(methods::kMovingEager)});
  settings.questions = {MovingQuestion::touch};
  settings.frames = arguments::FrameRange{37, 40, 1};
  EXPECT_EQ(run(walkers(), settings).figures.at(0).steps, 2u) << "no step begins with the last";
  settings.frames = arguments::FrameRange{0, 40, 10};
  EXPECT_EQ(run(walkers(), settings).figures.at(0).steps, 4u);
  std::vector<MovingSceneFigures> figures;
  std::ostringstream errors;
  settings.frames = arguments::FrameRange{39, 40, 1};
  const auto none = bench_moving(walkers(), settings, figures, errors);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message.find("--frames: no step begins with these frames"), 0u);
}

}  // namespace
}  // namespace pelt::tools::bench
