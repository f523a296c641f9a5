#include <pelt/pelt.hpp>

#include "model/model.hpp"
#include "model/unpack.hpp"
#include "pose/pose.hpp"
#include "skin/skin.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pelt {
namespace {

using detail::SkinnedMesh;
using test::Morphing;
using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A limb with two targets of three vertices each.
Shape morphing_limb() {
  Shape shape = test::make_limb(5, 4, 2);
  shape.morph_begin = {0, 3, 6};
  shape.morph_vertices = {0, 1, 5, 1, 5, 6};
  shape.morph_displacements.assign(6, {0.5f, 0, 0});
  return shape;
}

struct Breach {
  const char* words;  ///< of the message
  void (*commit)(Shape&);
};

const Breach kBreaches[] = {
    {"displacements has 5 elements, but vertices has 6",
     [](Shape& s) { s.morph_displacements.pop_back(); }},
    {"begin is empty", [](Shape& s) { s.morph_begin.clear(); }},
    {"begin goes from 1 to 6", [](Shape& s) { s.morph_begin[0] = 1; }},
    {"begin goes from 0 to 7, expected 0 to 6", [](Shape& s) { s.morph_begin[2] = 7; }},
    {"morph_targets.begin[2] is 6, less than",
     [](Shape& s) {
       s.morph_begin = {0, 9, 6};
     }},
    {"65536 morph targets", [](Shape& s) { s.morph_begin.resize(65537, 6); }},
    {"vertices[2] of target 0 is 99", [](Shape& s) { s.morph_vertices[2] = 99; }},
    {"vertices[4] of target 1 is 1, which does not ascend",
     [](Shape& s) { s.morph_vertices[4] = 1; }},
    {"displacements[3] of target 1 has the coordinate nan",
     [](Shape& s) { s.morph_displacements[3].z = kNan; }},
    {"displacements[0] of target 0 has the coordinate -2e+18",
     [](Shape& s) { s.morph_displacements[0].y = -2e18f; }},
};

TEST(MorphTargets, RefusesEveryBreach) {
  ASSERT_TRUE(build_model(morphing_limb().view()));
  for (const Breach& breach : kBreaches) {
    Shape shape = morphing_limb();
    breach.commit(shape);
    if (shape.morph_begin.size() == 65537) shape.morph_begin[0] = 0;
    const auto model = build_model(shape.view());
    ASSERT_FALSE(model) << breach.words;
    EXPECT_NE(model.error().message.find(breach.words), std::string::npos)
        << "expected: " << breach.words << "\nfound:    " << model.error().message;
  }
}

TEST(MorphTargets, AreCounted) {
  EXPECT_EQ(build_model(morphing_limb().view())->morph_target_count(), 2u);
  EXPECT_EQ(build_model(test::make_limb(5, 4, 2).view())->morph_target_count(), 0u);
}

std::vector<Vec3> posed(const Pose& pose) {
  std::vector<Vec3> positions(pose.model().vertex_count());
  posed_vertices(pose, positions);
  return positions;
}

TEST(MorphTargets, DisplaceByTheirWeights) {
  const Shape shape = morphing_limb();
  Pose pose(*build_model(shape.view()));
  ASSERT_TRUE(pose.set_morph_weights(std::vector<float>{2, -0.5f}));
  const std::vector<Vec3> positions = posed(pose);
  const float expected[] = {1, 0.75f, 0, 0, 0, 0.75f, -0.25f, 0};
  for (std::size_t v = 0; v < std::size(expected); ++v)
    EXPECT_NEAR(positions[v].x - shape.rest_positions[v].x, expected[v], 1e-6f) << v;
  ASSERT_TRUE(pose.set_morph_weights(std::vector<float>{0, 0}));
  EXPECT_EQ(posed(pose), shape.rest_positions);
}

struct BadWeights {
  const char* words;
  std::vector<float> weights;
};

TEST(MorphTargets, BadWeightsAreRefusedAndChangeNothing) {
  Pose pose(*build_model(morphing_limb().view()));
  ASSERT_TRUE(pose.set_morph_weights(std::vector<float>{0.25f, 1}));
  const std::vector<Vec3> before = posed(pose);
  for (const BadWeights& bad :
       {BadWeights{"has 1 elements, expected 2", {1}}, BadWeights{"has 0 elements, expected 2", {}},
        BadWeights{"morph_weights[1] is nan", {0, kNan}},
        BadWeights{"morph_weights[0] is -inf", {-HUGE_VALF, 0}},
        BadWeights{"morph_weights[1] of -3e+38", {1, -3e38f}}}) {
    const Result<void> taken = pose.set_morph_weights(bad.weights);
    ASSERT_FALSE(taken) << bad.words;
    EXPECT_NE(taken.error().message.find(bad.words), std::string::npos) << taken.error().message;
    EXPECT_EQ(posed(pose), before);
  }
}

/// A palette and weights that together move vertices too far are refused in either order.
TEST(MorphTargets, NothingLandsTooFarWhicheverIsSetFirst) {
  const SkinnedModel model = *build_model(morphing_limb().view());
  Matrix4 large;
  for (const int e : {0, 5, 10}) large.m[e] = 0x1p40f;
  const std::vector<Matrix4> palette = {Matrix4{}, large};
  const std::vector<float> weights = {0x1p30f, 0};
  Pose palette_first(model), weights_first(model);
  ASSERT_TRUE(palette_first.set_palette(palette));
  const auto refused = palette_first.set_morph_weights(weights);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("palette[1] can move a vertex beyond 2^60"),
            std::string::npos)
      << refused.error().message;
  ASSERT_TRUE(weights_first.set_morph_weights(weights));
  EXPECT_FALSE(weights_first.set_palette(palette));
  ASSERT_TRUE(weights_first.set_morph_weights(std::vector<float>{0, 0}));
  EXPECT_TRUE(weights_first.set_palette(palette));
}

/// A mesh at the limit of coordinates may be at rest, although no palette may move it there.
TEST(MorphTargets, ZeroWeightsAreNeverTooFar) {
  Shape shape = morphing_limb();
  shape.rest_positions[0] = {0x1p60f, 0x1p60f, 0x1p60f};
  Pose pose(*build_model(shape.view()));
  EXPECT_TRUE(pose.set_morph_weights(std::vector<float>{0, 0}));
  EXPECT_FALSE(pose.set_morph_weights(std::vector<float>{0x1p40f, 0}));
}

template <typename Check>
void for_each_kind(std::uint64_t seed, const Check& check) {
  Random random(seed);
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
    for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
      for (const Morphing morphing : test::kAllMorphings) {
        Shape shape = test::make_soup(random, 100, 7, 4, weights);
        test::add_morph_targets(random, shape, 11, 0.3, 0.5);
        Pose pose(*build_model(shape.view()));
        ASSERT_TRUE(pose.set_palette(test::make_palette(random, 7, motion, 2)));
        ASSERT_TRUE(pose.set_morph_weights(test::make_morph_weights(random, 11, morphing)));
        check(shape, pose);
      }
}

TEST(MorphTargets, AllWaysOfPosingHaveTheBitsOfTheScalarDefinition) {
  for_each_kind(34, [](const Shape&, const Pose& pose) {
    const SkinnedMesh mesh = detail::unpack_mesh(pose.model().detail().tree);
    const detail::Palette& palette = pose.detail().palette;
    std::vector<Vec3> definition, wide;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      definition.push_back(scalar::posed_vertex(mesh, palette, v));
      wide.push_back(detail::posed_vertex(mesh, palette, v));
    }
    EXPECT_EQ(wide, definition);
    test::on_each_instruction_set([&](InstructionSet) { EXPECT_EQ(posed(pose), definition); });
  });
}

/// Computed from the caller's arrays alone.
TEST(MorphTargets, TheDefinitionIsTheWeightedSumBeforeSkinning) {
  for_each_kind(35, [](const Shape& shape, const Pose& pose) {
    Shape displaced = shape;
    for (std::uint32_t m = 0; m < shape.morph_target_count(); ++m) {
      const float weight = pose.detail().palette.morphs()[m];
      for (std::uint32_t i = shape.morph_begin[m]; i < shape.morph_begin[m + 1]; ++i) {
        Vec3& v = displaced.rest_positions[shape.morph_vertices[i]];
        const Vec3& by = shape.morph_displacements[i];
        if (weight != 0) v = {v.x + weight * by.x, v.y + weight * by.y, v.z + weight * by.z};
      }
    }
    Pose plain(*build_model(displaced.view()));
    ASSERT_TRUE(plain.set_palette(pose.detail().palette.joints()));
    EXPECT_EQ(posed(pose), posed(plain));
  });
}

/// Vertices of a seam that a target separates are not welded.
TEST(MorphTargets, SeamsStayTornWhereDisplacementsDiffer) {
  Shape shape = morphing_limb();
  shape.rest_positions[6] = shape.rest_positions[5];
  for (std::uint32_t k = 0; k < 4; ++k) {
    shape.joints[24 + k] = shape.joints[20 + k];
    shape.weights[24 + k] = shape.weights[20 + k];
  }
  Pose pose(*build_model(shape.view()));
  ASSERT_TRUE(pose.set_morph_weights(std::vector<float>{1, 0}));
  EXPECT_EQ(posed(pose)[5].x, shape.rest_positions[5].x + 0.5f);
  EXPECT_EQ(posed(pose)[6], shape.rest_positions[6]);
}

TEST(MorphTargets, DisplacementsOfZeroAreForgotten) {
  Shape shape = morphing_limb();
  for (Vec3& by : shape.morph_displacements) by = {};
  const SkinnedModel model = *build_model(shape.view());
  EXPECT_EQ(model.morph_target_count(), 2u);
  EXPECT_TRUE(model.detail().tree.morphs.displacements.empty());
}

}  // namespace
}  // namespace pelt
