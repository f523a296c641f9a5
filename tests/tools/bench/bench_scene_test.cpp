/// The core of `pelt bench`, with methods that the command does not have.

#include "tools/pelt/bench/bench_scene.hpp"

#include "support/contains.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/scene/walkers.hpp"

#include <sstream>

namespace pelt::tools::bench {
namespace {

using test::walkers;

/// Passes everything on to another method.
class Forwarding : public methods::Method {
 public:
  explicit Forwarding(const methods::MethodKind& kind) : method_(kind.make()) {}

  void add(const SkinnedModel& model) override { method_->add(model); }
  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return method_->set_morph_weights(body, weights);
  }
  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return method_->set_palette(body, palette);
  }
  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    return method_->collide(a, b, contacts, limits);
  }
  QueryStats update_work() const override { return method_->update_work(); }

 private:
  std::unique_ptr<methods::Method> method_;
};

/// A method that omits the last contact of each query with contacts, or of every tenth one.
class Forgetful final : public Forwarding {
 public:
  Forgetful(const methods::MethodKind& kind, int every) : Forwarding(kind), every_(every) {}

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    const std::size_t before = contacts.size();
    const QueryStats work = Forwarding::collide(a, b, contacts, limits);
    if (contacts.size() > before && ++asked_ % every_ == 0) contacts.pop_back();
    return work;
  }

 private:
  int every_, asked_ = 0;
};

BenchMethod forgetful(int every) {
  return {"forgetful", [every](std::span<const scene::Collider> colliders) {
            return scene::SceneQuery(colliders,
                                     std::make_unique<Forgetful>(methods::kOnDemand, every));
          }};
}

BenchSettings settings_with(std::vector<BenchMethod> methods) {
  BenchSettings settings;
  settings.methods = std::move(methods);
  settings.questions = {Question::all};
  settings.repetitions = 1;
  return settings;
}

/// The figures, or the message that answers differ.
struct Outcome {
  std::optional<SceneFigures> figures;
  std::string errors;
};

Outcome run(const scenes::Scene& scene, const BenchSettings& settings) {
  std::ostringstream errors;
  auto figures = bench_scene(scene, settings, errors);
  EXPECT_TRUE(figures) << figures.error().message;
  EXPECT_EQ(errors.str().empty(), figures && *figures) << errors.str();
  return {figures ? std::move(*figures) : std::nullopt, errors.str()};
}

TEST(BenchScene, RefusesAMethodThatForgetsOneContact) {
  for (const int every : {1, 3}) {
    BenchSettings settings = settings_with({method_of(methods::kOnDemand), forgetful(every)});
    settings.program = "pelt-lab";
    const Outcome outcome = run(walkers(), settings);
    EXPECT_FALSE(outcome.figures);
    EXPECT_EQ(outcome.errors.find("pelt-lab: internal error: walkers: forgetful gives the hash "),
              0u)
        << outcome.errors;
  }
}

/// The paper has no bounds for it, so all pairs of triangles are the reference.
TEST(BenchScene, MeasuresDualQuaternionSkinning) {
  for (const bool forgets : {false, true}) {
    BenchSettings settings = settings_with({method_of(methods::kOnDemand)});
    if (forgets) settings.methods = {forgetful(3)};
    settings.models.skinning = "dual-quaternion";
    EXPECT_EQ(run(walkers(), settings).figures.has_value(), !forgets);
  }
}

TEST(BenchScene, RefusesAMethodThatDeniesThatAPairTouches) {
  BenchSettings settings = settings_with({forgetful(3)});
  settings.questions = {Question::first};
  EXPECT_FALSE(run(walkers(), settings).figures);
}

/// Records the z position of body 0 at every palette.
class Noting final : public Forwarding {
 public:
  explicit Noting(std::vector<float>& places) : Forwarding(methods::kOnDemand), places_(places) {}

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    if (body == 0) places_.push_back(palette[0].m[14]);
    return Forwarding::set_palette(body, palette);
  }

 private:
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
  ASSERT_TRUE(run(scene, settings_with({noting})).figures);
  ASSERT_EQ(places.size(), 9u) << "three frames are asked, then three are timed after others";
  const float first = places[0], second = places[1], last = places[2];
  EXPECT_NE(first, second);
  EXPECT_NE(second, last);
  EXPECT_EQ(std::vector<float>(places.begin() + 3, places.end()),
            (std::vector<float>{last, first, first, second, second, last}));
}

TEST(BenchScene, WaitsForAllThreadsOnlyWhereThereAreSeveral) {
  BenchSettings settings = settings_with({method_of(methods::kEager)});
  const Outcome one = run(walkers(), settings);
  settings.methods.push_back(crowd_method(2));
  const Outcome two = run(walkers(), settings);
  ASSERT_TRUE(one.figures && two.figures);
  EXPECT_EQ(one.figures->time, Time::thread);
  EXPECT_EQ(two.figures->time, Time::wall);
  EXPECT_EQ(two.figures->figures.at(1).threads, 2u);
  EXPECT_EQ(two.figures->figures[1].asked, Asked::crowd);
}

TEST(BenchScene, MeasuresEveryMethodQueryAndCache) {
  BenchSettings settings = settings_with({});
  for (const auto method : {methods::kPaper, methods::kEager, methods::kOnDemand})
    settings.methods.push_back(method_of(method));
  settings.questions = {Question::all, Question::first};
  std::uint32_t prepared = 0;
  settings.caches = {Cache(), {"cold", [&](std::uint32_t threads) { prepared += threads; }, 7}};
  const Outcome outcome = run(walkers(), settings);
  ASSERT_TRUE(outcome.figures);
  const SceneFigures& scene = *outcome.figures;
  EXPECT_EQ(prepared, 3u * 2 * 6) << "methods, queries and every second frame";
  EXPECT_EQ(scene.triangles, 2200u);
  EXPECT_EQ(scene.models.triangles, 2200u);
  EXPECT_GT(scene.models.bytes, 2200u);
  EXPECT_GT(scene.skinning.ns_per_vertex(), 0);
  ASSERT_EQ(scene.figures.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    const Figures& one = scene.figures[i];
    EXPECT_EQ(one.method, settings.methods[i % 3].name);
    EXPECT_EQ(one.question, i < 6 ? Question::all : Question::first);
    EXPECT_EQ(one.cache, i / 3 % 2 == 0 ? "hot" : "cold");
    EXPECT_EQ(one.answer.hash, scene.figures[i < 6 ? 0 : 6].answer.hash);
    EXPECT_EQ(one.times.frames, one.cache == "hot" ? 12u : 6u);
    EXPECT_GT(one.answer.frames_in_contact, 0u);
    EXPECT_LT(one.answer.frames_in_contact, 12u);
    EXPECT_GT(one.times.mean_us, 0);
  }
  EXPECT_NE(scene.figures[0].answer.hash, scene.figures[6].answer.hash);
}

TEST(BenchScene, AddsUpTheWorkOfTheFrames) {
  const auto displacements_in = [](const arguments::FrameRange& frames) {
    BenchSettings settings = settings_with({method_of(methods::kOnDemand)});
    settings.frames = frames;
    return run(test::talkers(1000), settings).figures.value().figures[0].answer.work.displacements;
  };
  const std::uint64_t first = displacements_in({3, 4, 1}), second = displacements_in({4, 5, 1});
  EXPECT_GT(first, 0u);
  EXPECT_EQ(displacements_in({3, 5, 1}), first + second);
}

/// A creature that touches itself in some frames of its walk.
scenes::Scene lone_walker() {
  scenes::Scene scene = walkers();
  scene.characters[0] = *scenes::generate_character(scenes::kCreature);
  scene.instances.resize(1);
  scene.fps = 30;
  scene.frame_count = 40;
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
  for (const auto method : methods::kSelfMethods) settings.methods.push_back(self_method(method));
  settings.questions = {Question::all, Question::first};
  const Outcome outcome = run(lone_walker(), settings);
  ASSERT_TRUE(outcome.figures);
  const SceneFigures& scene = *outcome.figures;
  ASSERT_TRUE(scene.self);
  EXPECT_GT(scene.self->filter_bytes, scene.models.triangles);
  EXPECT_GT(scene.self->tracked_us, 0);
  ASSERT_EQ(scene.figures.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const Figures& one = scene.figures[i];
    EXPECT_EQ(one.asked, one.method == "boxes" ? Asked::none : Asked::self);
    EXPECT_EQ(one.answer.hash, scene.figures[i < 3 ? 0 : 3].answer.hash);
    EXPECT_GT(one.answer.frames_in_contact, 0u);
    EXPECT_LT(one.answer.frames_in_contact, 5u);
    EXPECT_GT(one.times.mean_us, 0);
  }
  EXPECT_NE(scene.figures[0].answer.hash, scene.figures[3].answer.hash);
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
    const Outcome outcome = run(lone_walker(), settings);
    EXPECT_FALSE(outcome.figures);
    EXPECT_TRUE(test::contains(outcome.errors, "forgetful gives the hash "));
    EXPECT_TRUE(test::contains(outcome.errors, ", brute gives "));
  }
}

}  // namespace
}  // namespace pelt::tools::bench
