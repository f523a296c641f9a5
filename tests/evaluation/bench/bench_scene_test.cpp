/// The core of `pelt bench`, with methods that the command does not have.

#include "tools/pelt/bench/bench_scene.hpp"

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/methods/lab_self_methods.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace pelt::tools::bench {
namespace {

/// A method that omits the last contact of each query with contacts, or of every tenth one.
class Forgetful final : public methods::Method {
 public:
  Forgetful(const methods::MethodKind& kind, int every) : method_(kind.make()), every_(every) {}

  void add(const SkinnedModel& model) override { method_->add(model); }
  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return method_->set_morph_weights(body, weights);
  }
  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return method_->set_palette(body, palette);
  }
  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    const std::size_t before = contacts.size();
    const QueryStats work = method_->collide(a, b, contacts, limits);
    if (contacts.size() > before && ++asked_ % every_ == 0) contacts.pop_back();
    return work;
  }
  QueryStats update_work() const override { return method_->update_work(); }

 private:
  std::unique_ptr<methods::Method> method_;
  int every_, asked_ = 0;
};

BenchMethod forgetful(int every) {
  return {"forgetful", [every](std::span<const scene::Collider> colliders) {
            return scene::SceneQuery(colliders,
                                     std::make_unique<Forgetful>(methods::kOnDemand, every));
          }};
}

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

BenchSettings settings_with(std::vector<BenchMethod> methods) {
  BenchSettings settings;
  settings.methods = std::move(methods);
  settings.questions = {Question::all};
  settings.caches = {Cache::hot};
  settings.repetitions = 1;
  return settings;
}

TEST(BenchScene, RefusesAMethodThatForgetsOneContact) {
  for (const int every : {1, 10}) {
    std::vector<SceneFigures> figures;
    std::ostringstream errors;
    BenchSettings settings = settings_with({method_of(methods::kOnDemand), forgetful(every)});
    settings.program = "pelt-lab";
    const Result<arguments::ExitCode> exit = bench_scene(walkers(), settings, figures, errors);
    ASSERT_TRUE(exit);
    EXPECT_EQ(*exit, arguments::ExitCode::internal);
    EXPECT_TRUE(figures.empty());
    EXPECT_EQ(errors.str().find("pelt-lab: internal error: walkers: forgetful gives the hash "), 0u)
        << errors.str();
  }
}

/// The paper has no bounds for it, so all pairs of triangles are the reference.
TEST(BenchScene, MeasuresDualQuaternionSkinning) {
  for (const bool forgets : {false, true}) {
    BenchSettings settings = settings_with({method_of(methods::kOnDemand)});
    if (forgets) settings.methods = {forgetful(10)};
    settings.models.skinning = "dual-quaternion";
    std::vector<SceneFigures> figures;
    std::ostringstream errors;
    const Result<arguments::ExitCode> exit = bench_scene(walkers(), settings, figures, errors);
    ASSERT_TRUE(exit) << exit.error().message;
    EXPECT_EQ(*exit, forgets ? arguments::ExitCode::internal : arguments::ExitCode::success);
    EXPECT_EQ(figures.empty(), forgets);
  }
}

TEST(BenchScene, RefusesAMethodThatDeniesThatAPairTouches) {
  BenchSettings settings = settings_with({forgetful(10)});
  settings.questions = {Question::first};
  std::vector<SceneFigures> figures;
  std::ostringstream errors;
  const Result<arguments::ExitCode> exit = bench_scene(walkers(), settings, figures, errors);
  ASSERT_TRUE(exit);
  EXPECT_EQ(*exit, arguments::ExitCode::internal);
  EXPECT_TRUE(figures.empty());
}

/// Records the z position of body 0 at every palette.
class Noting final : public methods::Method {
 public:
  explicit Noting(std::vector<float>& places) : places_(places) {}

  void add(const SkinnedModel& model) override { method_->add(model); }
  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return method_->set_morph_weights(body, weights);
  }
  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    if (body == 0) places_.push_back(palette[0].m[14]);
    return method_->set_palette(body, palette);
  }
  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    return method_->collide(a, b, contacts, limits);
  }
  QueryStats update_work() const override { return method_->update_work(); }

 private:
  std::unique_ptr<methods::Method> method_ = methods::kOnDemand.make();
  std::vector<float>& places_;
};

TEST(BenchScene, RunsTheFrameBeforeEachAndTheLastBeforeTheFirst) {
  scenes::Scene scene = walkers();
  scene.frame_count = 3;
  std::vector<float> places;
  const BenchMethod noting = {"noting", [&](std::span<const scene::Collider> colliders) {
                                return scene::SceneQuery(colliders,
                                                         std::make_unique<Noting>(places));
                              }};
  std::vector<SceneFigures> figures;
  std::ostringstream errors;
  ASSERT_TRUE(bench_scene(scene, settings_with({noting}), figures, errors));
  ASSERT_EQ(places.size(), 9u) << "three frames are asked, then three are timed after others";
  const float first = places[0], second = places[1], last = places[2];
  EXPECT_NE(first, second);
  EXPECT_NE(second, last);
  EXPECT_EQ(std::vector<float>(places.begin() + 3, places.end()),
            (std::vector<float>{last, first, first, second, second, last}));
}

TEST(BenchScene, WaitsForAllThreadsOnlyWhereThereAreSeveral) {
  BenchSettings settings = settings_with({method_of(methods::kEager)});
  std::vector<SceneFigures> figures;
  std::ostringstream errors;
  ASSERT_TRUE(bench_scene(walkers(), settings, figures, errors));
  settings.methods.push_back(crowd_method(2));
  ASSERT_TRUE(bench_scene(walkers(), settings, figures, errors));
  ASSERT_EQ(figures.size(), 2u) << errors.str();
  EXPECT_EQ(figures[0].time, Time::thread);
  EXPECT_EQ(figures[1].time, Time::wall);
  EXPECT_EQ(figures[1].figures.at(1).threads, 2u);
  EXPECT_EQ(figures[1].figures[1].asked, Asked::crowd);
}

TEST(BenchScene, MeasuresEveryMethodQueryAndCache) {
  BenchSettings settings = settings_with({});
  for (const auto method : {methods::kPaper, methods::kEager, methods::kOnDemand, lab::kRigid}) {
    settings.methods.push_back(method_of(method));
  }
  settings.questions = {Question::all, Question::first};
  settings.caches = {Cache::hot, Cache::cold};
  std::vector<SceneFigures> figures;
  std::ostringstream errors;
  const Result<arguments::ExitCode> exit = bench_scene(walkers(), settings, figures, errors);
  ASSERT_TRUE(exit);
  ASSERT_EQ(*exit, arguments::ExitCode::success) << errors.str();
  const SceneFigures& scene = figures.at(0);
  EXPECT_EQ(scene.triangles, 2000u);
  EXPECT_EQ(scene.models.triangles, 1000u);
  EXPECT_GT(scene.models.bytes, 1000u);
  EXPECT_GT(scene.skinning.ns_per_vertex(), 0);
  ASSERT_EQ(scene.figures.size(), 16u);
  for (std::size_t i = 0; i < 16; ++i) {
    const Figures& one = scene.figures[i];
    EXPECT_EQ(one.method, settings.methods[i % 4].name);
    EXPECT_EQ(one.variant.question, i < 8 ? Question::all : Question::first);
    EXPECT_EQ(one.variant.cache, i / 4 % 2 == 0 ? Cache::hot : Cache::cold);
    EXPECT_EQ(one.answer.hash, scene.figures[i < 8 ? 0 : 8].answer.hash);
    EXPECT_EQ(one.times.frames, one.variant.cache == Cache::hot ? 40u : 20u);
    EXPECT_GT(one.answer.frames_in_contact, 0u);
    EXPECT_LT(one.answer.frames_in_contact, 40u);
    EXPECT_GT(one.times.mean_us, 0);
  }
  EXPECT_NE(scene.figures[0].answer.hash, scene.figures[8].answer.hash);
}

/// A creature that touches itself in some frames of its walk.
scenes::Scene lone_walker() {
  scenes::Scene scene = walkers();
  scene.characters[0] = *scenes::generate_character(scenes::kCreature);
  scene.instances.resize(1);
  scene.fps = 30;
  return scene;
}

BenchSettings self_settings(std::vector<BenchMethod> methods) {
  BenchSettings settings = settings_with(std::move(methods));
  settings.is_self = true;
  settings.frames = arguments::FrameRange{0, 40, 8};
  return settings;
}

TEST(BenchScene, MeasuresACharacterAgainstItself) {
  BenchSettings settings = self_settings({});
  for (const auto method : {methods::kBoxes, methods::kSelf, lab::kSelfEager, methods::kSelfBrute})
    settings.methods.push_back(self_method(method));
  settings.questions = {Question::all, Question::first};
  std::vector<SceneFigures> figures;
  std::ostringstream errors;
  const Result<arguments::ExitCode> exit = bench_scene(lone_walker(), settings, figures, errors);
  ASSERT_TRUE(exit);
  ASSERT_EQ(*exit, arguments::ExitCode::success) << errors.str();
  const SceneFigures& scene = figures.at(0);
  ASSERT_TRUE(scene.self_filters);
  EXPECT_GT(scene.self_filters->bytes, scene.models.triangles);
  ASSERT_TRUE(scene.sequence);
  EXPECT_GT(scene.sequence->tracked_us, 0);
  ASSERT_EQ(scene.figures.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const Figures& one = scene.figures[i];
    EXPECT_EQ(one.asked, i % 4 == 0 ? Asked::none : Asked::self);
    EXPECT_EQ(one.answer.hash, scene.figures[i < 4 ? 0 : 4].answer.hash);
    EXPECT_GT(one.answer.frames_in_contact, 0u);
    EXPECT_LT(one.answer.frames_in_contact, 5u);
    EXPECT_GT(one.times.mean_us, 0);
  }
  EXPECT_NE(scene.figures[0].answer.hash, scene.figures[4].answer.hash);
}

TEST(BenchScene, RefusesASelfCollisionThatForgetsOneContact) {
  const BenchMethod forgetful = {"forgetful",
                                 [](std::span<const scene::Collider> colliders) {
                                   return scene::SceneQuery::of_each(
                                       colliders, std::make_unique<Forgetful>(methods::kSelf, 1));
                                 },
                                 Asked::self};
  for (const Question question : {Question::all, Question::first}) {
    BenchSettings settings = self_settings({self_method(methods::kSelf), forgetful});
    settings.questions = {question};
    std::vector<SceneFigures> figures;
    std::ostringstream errors;
    const Result<arguments::ExitCode> exit = bench_scene(lone_walker(), settings, figures, errors);
    ASSERT_TRUE(exit);
    EXPECT_EQ(*exit, arguments::ExitCode::internal);
    EXPECT_TRUE(figures.empty());
    EXPECT_NE(errors.str().find("forgetful gives the hash "), std::string::npos);
    EXPECT_NE(errors.str().find(", brute gives "), std::string::npos) << errors.str();
  }
}

/// The update of rigid bodies counts neither as their time nor as their work.
TEST(BenchScene, UpdatesOfRigidBodiesCostNothing) {
  const auto settings = settings_with({method_of(methods::kEager), method_of(lab::kRigid)});
  std::vector<SceneFigures> figures;
  std::ostringstream errors;
  const Result<arguments::ExitCode> exit = bench_scene(walkers(), settings, figures, errors);
  ASSERT_TRUE(exit);
  const Figures &eager = figures.at(0).figures.at(0), &rigid = figures[0].figures.at(1);
  EXPECT_GT(eager.answer.work.posed_vertices, 0u);
  EXPECT_EQ(rigid.answer.work.posed_vertices + rigid.answer.work.refits, 0u);
  EXPECT_LE(rigid.times.mean_update_us, rigid.times.mean_us);
}

}  // namespace
}  // namespace pelt::tools::bench
