/// The core of `pelt bench --anytime`.

#include "tools/pelt/bench/bench_anytime.hpp"

#include "tools/pelt/bench/anytime_chart.hpp"
#include "tools/pelt/bench/anytime_report.hpp"
#include "tools/pelt/methods/anytime_methods.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace pelt::tools::bench {
namespace {

/// The order `contacts`, which loses the contact that it has found last.
class Spoilt final : public methods::AnytimeMethod {
 public:
  void add(const SkinnedModel& model) override { method_->add(model); }
  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return method_->set_morph_weights(body, weights);
  }
  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return method_->set_palette(body, palette);
  }
  void select(std::uint32_t a, std::uint32_t b) override { method_->select(a, b); }
  void restart() override { method_->restart(); }
  void advance_to(std::uint64_t work) override { method_->advance_to(work); }
  bool is_complete() const override { return method_->is_complete(); }
  std::uint64_t work_done() const override { return method_->work_done(); }
  std::uint64_t longest_step() const override { return method_->longest_step(); }
  methods::Known known() const override { return method_->known(); }
  std::span<const Contact> contacts() const override {
    const std::span<const Contact> all = method_->contacts();
    return all.first(all.size() - 1);
  }

 private:
  std::unique_ptr<methods::AnytimeMethod> method_ = methods::make_anytime_contacts();
};

/// Two small creatures that stand in each other.
scenes::Scene creatures() {
  scenes::Scene scene;
  scene.name = "creatures";
  Result<scenes::Character> character = scenes::generate_character({2000, 24, 1});
  EXPECT_TRUE(character);
  scene.characters.push_back(std::move(*character));
  scene.fps = 12;
  scene.frame_count = 3;
  scene.instances.resize(2);
  for (const int i : {0, 1}) {
    scene.instances[i].clip = "walk";
    scene.instances[i].translation = {0.1 * i, 0, 0.1 * i};
    scene.instances[i].rotation = {0, double(i), 0, double(1 - i)};
  }
  return scene;
}

AnytimeSettings all_methods() {
  AnytimeSettings settings;
  for (const auto& kind : methods::kCommandAnytimeMethods)
    settings.methods.push_back(anytime_method_of(kind));
  settings.repetitions = 1;
  return settings;
}

AnytimeSceneFigures figures_of(const AnytimeSettings& settings) {
  std::vector<AnytimeSceneFigures> figures;
  std::ostringstream errors;
  const auto exit = bench_anytime(creatures(), settings, figures, errors);
  EXPECT_TRUE(exit && *exit == arguments::ExitCode::success) << errors.str();
  return figures.at(0);
}

TEST(BenchAnytime, KnowledgeGrowsWithWorkAndTime) {
  const AnytimeSceneFigures scene = figures_of(all_methods());
  EXPECT_EQ(scene.pairs, 3u);
  EXPECT_EQ(scene.frames, 3u);
  EXPECT_GT(scene.contacts, 100u);
  ASSERT_EQ(scene.methods.size(), 4u);
  for (const AnytimeMethodFigures& method : scene.methods) {
    for (const auto& rungs : {method.over_work, method.over_time, method.course})
      for (std::size_t i = 1; i < rungs.size(); ++i) {
        EXPECT_GE(rungs[i].known.listed, rungs[i - 1].known.listed);
        EXPECT_LE(rungs[i].known.undecided, rungs[i - 1].known.undecided);
      }
    for (const AnytimeRung& end : {method.over_work.back(), method.course.back()}) {
      EXPECT_NEAR(end.known.listed, 1, 1e-9) << method.method;
      EXPECT_EQ(end.known.undecided, 0);
      EXPECT_EQ(end.known.resolution, 0);
    }
    EXPECT_LT(method.over_work[0].known.undecided, 1);
    EXPECT_GT(method.area_over_work, 0.05);
    EXPECT_LT(method.area_over_work, 0.95);
    EXPECT_GT(method.longest_step, 1u);
    EXPECT_GT(method.work, 20 * method.longest_step);
  }
  EXPECT_DOUBLE_EQ(scene.methods[0].over_work.back().time, 1) << "times are relative to this";
}

/// The counts of work depend on nothing that a machine measures.
TEST(BenchAnytime, AreaOverWorkIsTheSameInEveryRun) {
  const AnytimeSceneFigures once = figures_of(all_methods()), again = figures_of(all_methods());
  for (std::size_t m = 0; m < once.methods.size(); ++m) {
    EXPECT_EQ(once.methods[m].area_over_work, again.methods[m].area_over_work);
    EXPECT_EQ(once.methods[m].work, again.methods[m].work);
  }
}

TEST(BenchAnytime, OrdersKeepWhatTheyAreFor) {
  const AnytimeSceneFigures scene = figures_of(all_methods());
  const AnytimeMethodFigures &contacts = *find_method(scene, "contacts"),
                             &resolution = *find_method(scene, "resolution"),
                             &paper = *find_method(scene, "paper");
  EXPECT_GT(contacts.area_over_work, 1.2 * paper.area_over_work);
  const std::size_t half = 5;
  EXPECT_DOUBLE_EQ(resolution.over_work[half].share, 0.5);
  EXPECT_LT(resolution.over_work[half].known.resolution,
            0.7 * contacts.over_work[half].known.resolution);
  EXPECT_NEAR(*of_paper(scene, contacts, &AnytimeMethodFigures::area_over_work),
              contacts.area_over_work / paper.area_over_work, 1e-12);
  EXPECT_EQ(find_method(scene, "paperr"), nullptr);
}

TEST(BenchAnytime, RefusesASearchThatEndsWithOtherContacts) {
  AnytimeSettings settings = all_methods();
  settings.program = "pelt-lab";
  settings.methods.push_back({"spoilt", "", [] { return std::make_unique<Spoilt>(); }});
  std::vector<AnytimeSceneFigures> figures;
  std::ostringstream errors;
  const auto exit = bench_anytime(creatures(), settings, figures, errors);
  ASSERT_TRUE(exit);
  EXPECT_EQ(*exit, arguments::ExitCode::internal);
  EXPECT_TRUE(figures.empty());
  EXPECT_EQ(errors.str().find("pelt-lab: internal error: creatures: spoilt gives the hash "), 0u)
      << errors.str();
}

TEST(BenchAnytime, ChartHasALineForEachMethodInEachPanel) {
  AnytimeSettings settings = all_methods();
  settings.methods.pop_back();
  AnytimeSceneFigures scene = figures_of(settings);
  EXPECT_FALSE(of_paper(scene, scene.methods[0], &AnytimeMethodFigures::area_over_work));
  scene.scene = "<creatures & co>";
  const std::string svg = anytime_chart({scene, scene});
  std::size_t lines = 0;
  for (std::size_t at = 0; (at = svg.find("<polyline", at)) != std::string::npos; ++at) ++lines;
  EXPECT_EQ(lines, 2u * 3 * 3);
  EXPECT_NE(svg.find("&lt;creatures &amp; co>: 3 pairs"), std::string::npos);
  EXPECT_EQ(svg.find("<creatures"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace pelt::tools::bench
