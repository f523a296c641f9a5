#include "tools/pelt/arguments/model_arguments.hpp"

#include <gtest/gtest.h>

namespace pelt::tools::arguments {
namespace {

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
