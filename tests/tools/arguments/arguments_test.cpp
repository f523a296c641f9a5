#include "tools/pelt/arguments/model_arguments.hpp"

#include "support/contains.hpp"
#include "tools/pelt/arguments/values.hpp"

#include <gtest/gtest.h>

namespace pelt::tools::arguments {
namespace {

TEST(FrameRange, IsHalfOpen) {
  const Result<FrameRange> range = parse_frame_range("3:6");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->frames(), (std::vector<std::uint32_t>{3, 4, 5}));
}

TEST(FrameRange, AcceptsAStride) {
  const Result<FrameRange> range = parse_frame_range("1:8:3");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->frames(), (std::vector<std::uint32_t>{1, 4, 7}));
}

TEST(FrameRange, DoesNotRunOverTheEndOfItsNumbers) {
  const Result<FrameRange> range = parse_frame_range("4294967290:4294967295:4");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->frames(), (std::vector<std::uint32_t>{4294967290, 4294967294}));
}

TEST(FrameRange, RefusesWhatIsNone) {
  for (const char* text : {"", "3", "3:", ":3", "3:3", "4:3", "-1:3", "0:3:0", "0:3:1:1", "a:b",
                           "0:3 ", "0:4294967296", "0.5:3"}) {
    const Result<FrameRange> range = parse_frame_range(text);
    ASSERT_FALSE(range) << text;
    EXPECT_TRUE(test::contains(range.error().message, "--frames"));
    EXPECT_TRUE(test::contains(range.error().message, text));
  }
}

/// A clip may move the model out of range at times that no frame uses.
TEST(BuildNamedModel, PassesOverSamplesThatAModelCannotTake) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const std::vector<std::uint16_t> joints(3);
  const std::vector<float> weights(3, 1);
  const SkinnedMeshView mesh = {positions, triangles, 1, joints, weights, 1};
  std::vector<Matrix4> far(1);
  far[0].m[12] = 0x1p100f;
  ModelOptions options;
  options.sample_palettes = far;
  ASSERT_FALSE(build_model(mesh, options));
  const scenes::Character character = {"a", "a.glb", 0, {}};
  EXPECT_TRUE(build_named_model(character, mesh, {}, far));
}

TEST(SkinningOf, IsTheOptionOrElseTheScene) {
  ModelArguments arguments;
  scenes::Character character = {"a", "a.glb", 0, {}};
  EXPECT_EQ(arguments.skinning_of(character), Skinning::linear);
  character.skinning = Skinning::dual_quaternion;
  EXPECT_EQ(arguments.skinning_of(character), Skinning::dual_quaternion);
  arguments.skinning = "linear";
  EXPECT_EQ(arguments.skinning_of(character), Skinning::linear);
  arguments.skinning = "dual-quaternion";
  character.skinning = Skinning::linear;
  EXPECT_EQ(arguments.skinning_of(character), Skinning::dual_quaternion);
}

}  // namespace
}  // namespace pelt::tools::arguments
