/// The core of `pelt-lab bench --anytime`.

#include "evaluation/bench/anytime_bench.hpp"
#include "evaluation/bench/anytime_figures.hpp"
#include "tools/scene/walkers.hpp"

#include <sstream>

namespace pelt::lab {
namespace {

/// The order `contacts`, which loses the contact that it has found last.
class Spoilt final : public AnytimeMethod {
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
  Known known() const override { return method_->known(); }
  std::span<const Contact> contacts() const override {
    const std::span<const Contact> all = method_->contacts();
    return all.first(all.size() - 1);
  }

 private:
  std::unique_ptr<AnytimeMethod> method_ = make_anytime_contacts();
};

/// Two small creatures that stand in each other.
scenes::Scene creatures() {
  scenes::Scene scene = test::walkers();
  scene.name = "creatures";
  scene.frame_count = 3;
  scene.instances[0].translation = {};
  scene.instances[1].translation = {0.1, 0, 0.1};
  for (scenes::Instance& instance : scene.instances) instance.velocity = {};
  return scene;
}

AnytimeSettings all_methods() {
  AnytimeSettings settings;
  for (const auto& kind : kAnytimeMethods) settings.methods.push_back(method_of(kind));
  settings.repetitions = 1;
  return settings;
}

AnytimeSceneFigures figures_of(const AnytimeSettings& settings) {
  std::ostringstream errors;
  const auto figures = bench_anytime(creatures(), settings, errors);
  EXPECT_TRUE(figures && *figures) << errors.str();
  return **figures;
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
  std::ostringstream errors;
  const auto figures = bench_anytime(creatures(), settings, errors);
  ASSERT_TRUE(figures);
  EXPECT_FALSE(*figures);
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

// --- curves of single pairs

/// Lists contacts from `first` to the end at an even rate; time grows as `us` for all work.
AnytimeCurve even_curve(double first, double us) {
  AnytimeCurve curve;
  for (std::size_t i = 0; i <= kAnytimeSlices; ++i) {
    const double share = static_cast<double>(i) / kAnytimeSlices;
    curve.points[i] = {share <= first ? 0 : (share - first) / (1 - first), 1 - share, 2 - share};
  }
  for (std::size_t i = 0; i < kTimedShares.size(); ++i) curve.times_us[i] = us * kTimedShares[i];
  return curve;
}

TEST(AnytimeCurve, AreaIsOneHalfForAnEvenRateAndLessForALateStart) {
  EXPECT_NEAR(area_over_work(even_curve(0, 10)), 0.5, 1e-9);
  EXPECT_NEAR(area_over_work(even_curve(0.5, 10)), 0.25, 1e-9);
  AnytimeCurve at_once = even_curve(0, 10);
  for (std::size_t i = 1; i <= kAnytimeSlices; ++i) at_once.points[i].listed = 1;
  EXPECT_NEAR(area_over_work(at_once), 1, 1 / double{kAnytimeSlices});
}

TEST(AnytimeCurve, AreaOverTimeEndsAtTheGivenTime) {
  const AnytimeCurve curve = even_curve(0, 10);
  EXPECT_NEAR(area_over_time(curve, 10), 0.5, 1e-9);
  EXPECT_NEAR(area_over_time(curve, 5), 0.25, 1e-9) << "half of the contacts in 5 us";
  EXPECT_NEAR(area_over_time(curve, 20), 0.75, 1e-9) << "nothing changes after the end";
}

TEST(AnytimeCurve, InterpolatesBetweenMeasuredTimes) {
  AnytimeCurve curve = even_curve(0, 10);
  curve.times_us[1] = 2;  // 1 % of the work
  EXPECT_NEAR(curve.time_us(0.005), 1, 1e-9);
  EXPECT_NEAR(curve.time_us(0.75), 7.5, 1e-9);
  EXPECT_NEAR(curve.time_us(1), 10, 1e-9);
  EXPECT_NEAR(curve.at_time(7.5).listed, 0.75, 1e-9);
  EXPECT_NEAR(curve.at_time(7.5).undecided, 0.25, 1e-9);
  EXPECT_NEAR(curve.at_time(7.5).resolution, 1.25, 1e-9);
  EXPECT_EQ(curve.at_time(100).listed, 1);
}

/// Rounding must not take away what is known.
TEST(AnytimeCurve, KeepsWhatIsKnownBetweenMeasuredTimes) {
  AnytimeCurve curve = even_curve(0, 0.7);
  for (AnytimePoint& point : curve.points) point = {1, 0.3, 0.1};
  for (int i = 0; i < 1000; ++i) {
    const AnytimePoint point = curve.at_time(0.0007 * i);
    EXPECT_EQ(point.listed, 1);
    EXPECT_EQ(point.undecided, 0.3);
    EXPECT_EQ(point.resolution, 0.1);
  }
}

TEST(AnytimeCurve, KnowsNothingBeforeTheStart) {
  AnytimeCurve curve = even_curve(0, 10);
  curve.times_us[0] = 0.05;
  EXPECT_EQ(curve.at_time(0.01).listed, 0);
  EXPECT_EQ(curve.at_time(0.01).undecided, 1);
}

}  // namespace
}  // namespace pelt::lab
