#pragma once

/// Characters of files in poses of their clips, and tests of the shared models. Link pelt_asset.

#include <pelt/asset.hpp>
#include <pelt/model.hpp>
#include <pelt/pose.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pelt::test {

struct AnimatedCharacter {
  explicit AnimatedCharacter(asset::Asset file)
      : asset(std::move(file)),
        pose(*build_model(asset.mesh(), {.off_weights = OffWeights::renormalise})) {}

  const asset::Clip* first_clip() const { return asset.clips.empty() ? nullptr : &asset.clips[0]; }

  /// At a time of a clip; without a clip, at rest.
  std::vector<Matrix4> palette(const asset::Clip* clip, float seconds,
                               const Matrix4& placement = {}) {
    std::vector<Matrix4> matrices(asset.joints.size());
    sample_palette(asset, clip, seconds, placement, samples, matrices);
    return matrices;
  }

  void move(const asset::Clip* clip, float seconds) { move(pose, clip, seconds); }
  void move(Pose& at, const asset::Clip* clip, float seconds, const Matrix4& placement = {}) {
    ASSERT_TRUE(at.set_palette(palette(clip, seconds, placement)));
  }

  asset::Asset asset;
  Pose pose;
  asset::SampleScratch samples;
};

/// The name of a case: of a file, or of the file of its member `model`.
template <typename Case>
std::string shared_model_of(const Case& tested) {
  if constexpr (std::is_convertible_v<Case, std::string>)
    return tested;
  else
    return tested.model;
}

/// Names the test of a file by its stem.
constexpr auto kStemOfModel = [](const auto& instance) {
  return std::filesystem::path(shared_model_of(instance.param)).stem().string();
};

/// Tests of files in the folder `models` below PELT_SHARED_DIR; those that are missing are skipped.
template <typename Case = const char*>
class OfSharedModels : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    const auto path =
        std::filesystem::path(PELT_SHARED_DIR) / "models" / shared_model_of(this->GetParam());
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    Result<asset::Asset> file = asset::load_gltf(path);
    ASSERT_TRUE(file) << file.error().message;
    character.emplace(*std::move(file));
  }

  std::optional<AnimatedCharacter> character;
};

}  // namespace pelt::test
