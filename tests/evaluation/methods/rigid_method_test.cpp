/// Rigid bodies are built again for each palette, in whatever order palettes are set.

#include "evaluation/methods/lab_methods.hpp"

#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

namespace pelt::methods {
namespace {

using test::Random;

constexpr std::uint32_t kJoints = 5;

TEST(RigidMethod, AnswersForTheLastPaletteInAnyOrder) {
  Random random(1);
  const auto limb = build_model(test::make_limb(12, 8, kJoints).view());
  ASSERT_TRUE(limb);
  std::vector<std::vector<Matrix4>> palettes;
  for (int i = 0; i < 4; ++i)
    palettes.push_back(bend_limb(random, kJoints, 0.6, random.point(0.2)));
  const auto rigid = lab::make_rigid(), brute = make_brute();
  for (const auto& method : {rigid.get(), brute.get()}) {
    method->add(*limb);
    method->add(*limb);
  }
  int touching = 0;
  for (int step = 0; step < 60; ++step) {
    const auto body = static_cast<std::uint32_t>(random.index(2));
    const std::vector<Matrix4>& palette = palettes[random.index(4)];
    std::vector<Contact> found, expected;
    ASSERT_TRUE(rigid->set_palette(body, palette));
    ASSERT_TRUE(brute->set_palette(body, palette));
    rigid->collide(0, 1, found, {});
    brute->collide(0, 1, expected, {});
    ASSERT_EQ(found, expected) << step;
    touching += !found.empty();
  }
  std::printf("%d of 60 steps touch\n", touching);
  EXPECT_GT(touching, 20);
}

}  // namespace
}  // namespace pelt::methods
