#include "bounded.hpp"
#include "model/model.hpp"

#include <pelt/pelt.hpp>

namespace pelt {
namespace {

using detail::Palette;
using test::Bounded;
using test::Morphing;
using test::Motion;
using test::Random;
using test::Shape;
using test::Tally;
using test::Weights;

/// Every kind of morph weights on every kind of palette.
void expect_enclosed_morphed(Random& random, const Shape& shape, Tally& tally) {
  const Bounded bounded(shape);
  for (const auto& joints : test::palettes_of_all_kinds(random, shape.joint_count))
    for (const Morphing morphing : test::kAllMorphings) {
      Palette palette = rest_palette(bounded.tree);
      ASSERT_TRUE(palette.set(joints));
      ASSERT_TRUE(palette.set_morph_weights(
          test::make_morph_weights(random, shape.morph_target_count(), morphing)));
      test::expect_enclosed(bounded, palette, tally);
      if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(MorphBounds, BothKindsEncloseWhatIsDisplaced) {
  Random random(330);
  Tally tally;
  for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
    for (const double size : {1e-3, 1.0, 1e3}) {
      Shape soup = test::make_soup(random, 30, 6, 4, weights);
      test::add_morph_targets(random, soup, 9, 0.4, size);
      expect_enclosed_morphed(random, soup, tally);
      if (HasFatalFailure()) return;
    }
  Shape limb = test::make_limb(20, 8, 4);
  test::add_morph_targets(random, limb, 12, 0.2, 0.1);
  expect_enclosed_morphed(random, limb, tally);
  test::report(tally);
  EXPECT_GT(tally.boxes, 100'000u);
}

/// Each of many targets adds a rounding error: displacements in one direction on a single vertex.
TEST(MorphBounds, HundredsOfTargetsOnOneVertexAreEnclosed) {
  Random random(331);
  Tally tally;
  for (int round = 0; round < 20; ++round) {
    Shape soup = test::make_soup(random, 4, 3, 4, Weights::random);
    test::add_morph_targets(random, soup, 400, 0.9, 1);
    const Bounded bounded(soup);
    Palette palette = rest_palette(bounded.tree);
    ASSERT_TRUE(palette.set(test::make_palette(random, 3, Motion::rigid, 1)));
    std::vector<float> weights(400);
    for (float& weight : weights) weight = random.uniformf(-1, 1);
    ASSERT_TRUE(palette.set_morph_weights(weights));
    test::expect_enclosed(bounded, palette, tally);
    if (HasFatalFailure()) return;
  }
  test::report(tally);
}

/// Targets of weight zero do not widen the boxes.
TEST(MorphBounds, InactiveTargetsChangeNoBit) {
  Random random(332);
  Shape limb = test::make_limb(40, 12, 5);
  const SkinnedModel bare = *build_model(limb.view());
  test::add_morph_targets(random, limb, 20, 0.3, 1);
  const SkinnedModel model = *build_model(limb.view());
  Palette palette = rest_palette(model.detail().tree);
  Palette bare_palette = rest_palette(bare.detail().tree);
  const auto joints = test::bend_limb(random, 5, 0.4, {});
  ASSERT_TRUE(palette.set(joints));
  ASSERT_TRUE(bare_palette.set(joints));
  ASSERT_TRUE(palette.set_morph_weights(std::vector<float>(20)));
  ASSERT_EQ(model.detail().bounds.nodes.size(), bare.detail().bounds.nodes.size());
  for (std::uint32_t n = 0; n < bare.detail().bounds.nodes.size(); ++n)
    EXPECT_EQ(test::node_box(model.detail().bounds, n, palette),
              test::node_box(bare.detail().bounds, n, bare_palette));
}

/// A bump at one end of a limb does not change the boxes at the other end, except for margins.
TEST(MorphBounds, ATargetWidensOnlyWhatItDisplaces) {
  Shape limb = test::make_limb(60, 12, 6);
  limb.morph_begin = {0};
  for (std::uint32_t v = 0; v < limb.rest_positions.size(); ++v)
    if (limb.rest_positions[v].y > 0.9f) {
      limb.morph_vertices.push_back(v);
      limb.morph_displacements.push_back({0, 0, 1});
    }
  limb.morph_begin.push_back(static_cast<std::uint32_t>(limb.morph_vertices.size()));
  const SkinnedModel model = *build_model(limb.view());
  const detail::NodeBounds& bounds = model.detail().bounds;
  Palette rest = rest_palette(model.detail().tree), morphed = rest;
  ASSERT_TRUE(morphed.set_morph_weights(std::vector<float>{1}));
  int same = 0, wider = 0;
  for (std::uint32_t n = 0; n < bounds.nodes.size(); ++n) {
    const auto before = test::node_box(bounds, n, rest), after = test::node_box(bounds, n, morphed);
    const float grown = after.high[2] - before.high[2];
    if (after.high[1] < 0.85f) {
      EXPECT_LT(grown, 1e-5f);
    }
    same += grown < 1e-5f;
    wider += grown > 0.9f;
  }
  EXPECT_GT(same, 3);
  EXPECT_GT(wider, 1);
}

/// On every target and after any earlier query, the bounds of opened nodes are those of the current
/// weights.
TEST(MorphBounds, QueriesSeeTheWeightsSetLast) {
  Random random(333);
  Shape limb = test::make_limb(50, 16, 5);
  test::add_morph_targets(random, limb, 16, 0.2, 0.2);
  const SkinnedModel model = *build_model(limb.view());
  Pose a(model), b(model);
  Scratch scratch;
  int touching = 0;
  test::on_each_instruction_set([&](InstructionSet) {
    for (int round = 0; round < 12; ++round) {
      ASSERT_TRUE(a.set_palette(test::bend_limb(random, 5, 0.3, {})));
      ASSERT_TRUE(b.set_morph_weights(
          test::make_morph_weights(random, 16, test::kAllMorphings[round % 4])));
      ASSERT_TRUE(b.set_palette(test::bend_limb(random, 5, 0.3, {0.2f, 0, 0})));
      ASSERT_TRUE(a.set_morph_weights(
          test::make_morph_weights(random, 16, test::kAllMorphings[(round + 1) % 4])));
      touching += intersects(a, b, scratch).answer;
      ASSERT_EQ(check_bounds(a), "");
      ASSERT_EQ(check_bounds(b), "");
    }
  });
  EXPECT_GT(touching, 5);
}

}  // namespace
}  // namespace pelt
