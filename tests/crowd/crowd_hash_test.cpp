/// Whole scenes as a crowd, frame by frame: the hash of the contacts is the same with any number of
/// threads, and equals the hash that `pelt check` prints. With contacts of instances with
/// themselves, it equals the hash of tests/wasm/self.test.mjs.

#include <pelt/crowd.hpp>

#include "base/hash.hpp"
#include "crowd/test_crowd.hpp"
#include "scenes/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace pelt {
namespace {

struct Golden {
  const char* folder;
  const char* scene;
  std::size_t contacts;
  std::uint64_t hash;
  bool with_self = false;
};

class CrowdHash : public testing::TestWithParam<Golden> {};

/// The crowd of a scene on a number of threads, and the hash of its contacts so far.
class AskedCrowd {
 public:
  /// `filters`: those of the models, or none if instances are not tested against themselves.
  AskedCrowd(const scenes::Scene& scene, std::span<const SkinnedModel> models,
             std::span<const SelfFilter> filters, std::uint32_t threads) {
    options_.threads = threads;
    for (const scenes::Instance& instance : scene.instances) crowd_.add(models[instance.character]);
    if (!filters.empty())
      options_.self_filter = [&scene, filters](std::uint32_t i) {
        return &filters[scene.instances[i].character];
      };
  }

  void set_palette(std::uint32_t instance, std::span<const Matrix4> palette) {
    ASSERT_TRUE(crowd_.set_palette(instance, palette));
  }

  void ask(std::uint32_t frame) {
    found_.clear();
    crowd_.collide(found_, options_);
    EXPECT_TRUE(std::is_sorted(found_.begin(), found_.end()));
    contacts_ += found_.size();
    for (const auto& [a, b, triangle_a, triangle_b] : found_)
      for (const std::uint32_t value : {frame, a, b, triangle_a, triangle_b}) hash_.add_u32(value);
  }

  std::uint32_t threads() const { return options_.threads; }
  std::size_t contacts() const { return contacts_; }
  std::uint64_t hash() const { return hash_.value(); }

 private:
  Crowd crowd_;
  CrowdOptions options_;
  std::vector<CrowdContact> found_;
  std::size_t contacts_ = 0;
  detail::Fnv1a64 hash_;
};

std::vector<SkinnedModel> build_models(const scenes::Scene& scene) {
  std::vector<SkinnedModel> models;
  for (const scenes::Character& character : scene.characters) {
    const auto model =
        build_model(character.asset.mesh(), {.off_weights = OffWeights::renormalise});
    EXPECT_TRUE(model) << model.error().message;
    models.push_back(*model);
  }
  return models;
}

TEST_P(CrowdHash, IsTheSameOnAnyNumberOfThreads) {
  const Golden& golden = GetParam();
  if (!std::filesystem::exists(golden.folder)) GTEST_SKIP() << golden.folder << " is not there";
  const auto scene = scenes::load_scene(golden.folder + std::string("/") + golden.scene + ".json");
  ASSERT_TRUE(scene) << scene.error().message;
  const std::vector<SkinnedModel> models = build_models(*scene);
  std::vector<SelfFilter> filters;
  if (golden.with_self)
    for (const SkinnedModel& model : models) filters.push_back(*build_self_filter(model));
  std::vector<AskedCrowd> crowds;
  for (const std::uint32_t threads : test::kThreadCounts)
    crowds.emplace_back(*scene, models, filters, threads);

  asset::SampleScratch scratch;
  for (std::uint32_t frame = 0; frame < 30; ++frame) {
    for (std::uint32_t i = 0; i < scene->instances.size(); ++i) {
      std::vector<Matrix4> palette(models[scene->instances[i].character].joint_count());
      scenes::instance_palette(*scene, i, frame, scratch, palette);
      for (AskedCrowd& crowd : crowds) crowd.set_palette(i, palette);
    }
    for (AskedCrowd& crowd : crowds) crowd.ask(frame);
  }
  for (const AskedCrowd& crowd : crowds) {
    EXPECT_EQ(crowd.contacts(), golden.contacts) << crowd.threads() << " threads";
    EXPECT_EQ(crowd.hash(), golden.hash) << crowd.threads() << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, CrowdHash,
    testing::Values(Golden{PELT_SCENES_DIR, "crowd", 142896, 0xf8c731fea98d6a36},
                    Golden{PELT_SHARED_DIR "/scenes", "crowd50", 152545, 0x7c803b38920623de},
                    Golden{PELT_SCENES_DIR, "passing_through", 769, 0xb69179c7a678acb4, true}),
    [](const auto& golden) {
      return golden.param.scene + std::string(golden.param.with_self ? "_with_self" : "");
    });

}  // namespace
}  // namespace pelt
