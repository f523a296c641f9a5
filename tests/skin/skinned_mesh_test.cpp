#include "skin/skinned_mesh.hpp"

#include "model/model.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pelt {
namespace {

using detail::SkinnedMesh;
using test::Random;
using test::Shape;

/// One triangle, two influences per vertex, three joints.
Shape one_triangle() {
  Shape shape;
  shape.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  shape.triangles = {{0, 1, 2}};
  shape.influences_per_vertex = 2;
  shape.joints = {0, 1, 1, 2, 2, 0};
  shape.weights = {0.25f, 0.75f, 1, 0, 0.5f, 0.5f};
  shape.joint_count = 3;
  return shape;
}

std::string refusal(const Shape& shape) {
  const Result<SkinnedModel> model = build_model(shape.view());
  return model ? "accepted" : model.error().message;
}

SkinnedMesh mesh_of(const Shape& shape, BuildReport& report, const ModelOptions& options = {}) {
  Result<SkinnedMesh> mesh = detail::make_skinned_mesh(shape.view(), options, report);
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.error().message);
  return *std::move(mesh);
}

TEST(SkinnedMesh, KeepsNumbersAndDropsZeroWeights) {
  BuildReport report;
  const SkinnedMesh mesh = mesh_of(one_triangle(), report);
  EXPECT_EQ(mesh.vertex_count(), 3u);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(mesh.influences_of(0).size(), 2u);
  ASSERT_EQ(mesh.influences_of(1).size(), 1u);
  EXPECT_EQ(mesh.influences_of(1)[0].joint, 1u);
  EXPECT_EQ(mesh.influences_of(1)[0].weight, 1.0f);
  EXPECT_EQ(mesh.influences_of(2)[0].joint, 0u) << "joints ascend";
  EXPECT_EQ(report.renormalised_vertices, 0u);
  EXPECT_GE(mesh.rest_extent, 2.0f);
  EXPECT_LT(mesh.rest_extent, 2.0001f);
}

TEST(SkinnedMesh, SumsAJointNamedTwice) {
  Shape shape = one_triangle();
  shape.joints[0] = shape.joints[1] = 2;
  BuildReport report;
  const SkinnedMesh mesh = mesh_of(shape, report);
  ASSERT_EQ(mesh.influences_of(0).size(), 1u);
  EXPECT_EQ(mesh.influences_of(0)[0].weight, 1.0f);
  EXPECT_EQ(report.merged_influences, 1u);
}

TEST(SkinnedMesh, RenormalisesWhatIsNearOne) {
  Shape shape = one_triangle();
  shape.weights[0] = 0.2525f;  // sum 1.0025
  shape.weights[4] = 0.5f + 0x1p-20f;
  BuildReport report;
  const SkinnedMesh mesh = mesh_of(shape, report);
  EXPECT_NEAR(mesh.influences_of(0)[0].weight + mesh.influences_of(0)[1].weight, 1, 1e-7);
  EXPECT_EQ(report.renormalised_vertices, 1u) << "rounding noise is not reported";
}

TEST(SkinnedMesh, RefusesOrRenormalisesWhatIsFarFromOne) {
  Shape shape = one_triangle();
  shape.weights[0] = 0.3f;  // sum 1.05
  EXPECT_EQ(refusal(shape),
            "weights of vertex 0 sum to 1.05, expected 1 (off_weights = "
            "OffWeights::renormalise divides by the sum)");
  BuildReport report;
  const SkinnedMesh mesh = mesh_of(shape, report, {.off_weights = OffWeights::renormalise});
  EXPECT_NEAR(mesh.influences_of(0)[0].weight, 0.3 / 1.05, 1e-7);
  EXPECT_EQ(report.renormalised_vertices, 1u);
}

TEST(SkinnedMesh, RefusesASumThatOverflows) {
  Shape shape = one_triangle();
  shape.joints[0] = shape.joints[1] = 0;
  shape.weights[0] = shape.weights[1] = std::numeric_limits<float>::max();
  const auto model = build_model(shape.view(), {.off_weights = OffWeights::renormalise});
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().message, "weights of vertex 0 sum to inf, expected 1");
}

TEST(SkinnedMesh, TheLimitIsTwoToTheMinusSeven) {
  Shape shape = one_triangle();
  shape.weights[2] = 1 + 0x1p-7f;
  EXPECT_EQ(refusal(shape), "accepted");
  shape.weights[2] = 1 + 0x1p-7f + 0x1p-20f;
  EXPECT_NE(refusal(shape).find("weights of vertex 1 sum to 1.00781"), std::string::npos);
}

TEST(SkinnedMesh, NamesArrayIndexAndValueOfWhatItRefuses) {
  const auto refuse = [](auto change) {
    Shape shape = one_triangle();
    change(shape);
    return refusal(shape);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refuse([&](Shape& s) { s.rest_positions[1].y = nan; }),
            "rest_positions[1] has the coordinate nan, expected finite and within 2^60");
  EXPECT_EQ(refuse([&](Shape& s) { s.rest_positions[2].z = infinity; }),
            "rest_positions[2] has the coordinate inf, expected finite and within 2^60");
  EXPECT_EQ(refuse([&](Shape& s) { s.rest_positions[2].z = 0x1p61f; }),
            "rest_positions[2] has the coordinate 2.30584e+18, expected finite and within 2^60");
  EXPECT_EQ(refuse([](Shape& s) { s.triangles[0][1] = 3; }),
            "triangles[0] refers to vertex 3, but there are 3 rest_positions");
  EXPECT_EQ(refuse([](Shape& s) { s.joints[0] = 3; }),
            "joints[0] of vertex 0 is 3, but joint_count is 3");
  EXPECT_EQ(refuse([](Shape& s) { s.joints[3] = 7; }),
            "joints[3] of vertex 1 is 7, but joint_count is 3")
      << "also under a zero weight";
  EXPECT_EQ(refuse([](Shape& s) { s.weights[1] = -0.5f; }),
            "weights[1] of vertex 0 is -0.5, expected a finite number >= 0");
  EXPECT_EQ(refuse([&](Shape& s) { s.weights[5] = nan; }),
            "weights[5] of vertex 2 is nan, expected a finite number >= 0");
  EXPECT_EQ(refuse([&](Shape& s) { s.weights[5] = infinity; }),
            "weights[5] of vertex 2 is inf, expected a finite number >= 0");
  EXPECT_EQ(refuse([](Shape& s) { s.weights[2] = 0; }), "weights of vertex 1 sum to 0, expected 1");
  EXPECT_EQ(refuse([](Shape& s) { s.weights.pop_back(); }),
            "joints has 6 and weights has 5 elements, expected 6 (rest_positions x "
            "influences_per_vertex)");
  EXPECT_EQ(refuse([](Shape& s) { s.triangles.clear(); }), "triangles is empty");
  EXPECT_EQ(refuse([](Shape& s) { s.influences_per_vertex = 0; }), "influences_per_vertex is 0");
  EXPECT_EQ(refuse([](Shape& s) { s.influences_per_vertex = 0xFFFFFFFF; }),
            "rest_positions x influences_per_vertex is more than 2^32 - 1");
  EXPECT_EQ(refuse([](Shape& s) { s.joint_count = 0; }),
            "joint_count is 0, but joints has 6 and weights has 6 elements");
  EXPECT_EQ(refuse([](Shape& s) { s.joint_count = 65536; }),
            "joint_count is 65536, expected 0 to 65535");
  EXPECT_EQ(refuse([](Shape&) {}), "accepted");
}

TEST(SkinnedMesh, SeamVerticesThatListJointsInAnotherOrderAreTheSame) {
  Shape shape = one_triangle();
  shape.joints = {0, 2, 2, 0, 1, 1};
  shape.weights = {0.3f, 0.7f, 0.7f, 0.3f, 1, 0};
  BuildReport report;
  const SkinnedMesh mesh = mesh_of(shape, report);
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(mesh.influences_of(0)[k].joint, mesh.influences_of(1)[k].joint);
    EXPECT_EQ(mesh.influences_of(0)[k].weight, mesh.influences_of(1)[k].weight);
  }
}

TEST(SkinnedMesh, AnyNumberOfInfluences) {
  Random random(1);
  for (const std::uint32_t k : {1u, 2u, 3u, 5u, 8u, 9u, 12u}) {
    const Shape shape = test::make_soup(random, 64, 20, k, test::Weights::adversarial);
    BuildReport report;
    const SkinnedMesh mesh = mesh_of(shape, report);
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      double sum = 0;
      for (const auto& influence : mesh.influences_of(v)) {
        EXPECT_GT(influence.weight, 0);
        sum += static_cast<double>(influence.weight);
      }
      EXPECT_NEAR(sum, 1, 1e-6);
    }
  }
}

TEST(BuildModel, CountsAndReports) {
  Random random(2);
  const Shape shape = test::make_soup(random, 32, 5, 4, test::Weights::random);
  const Result<SkinnedModel> model = build_model(shape.view());
  ASSERT_TRUE(model);
  EXPECT_EQ(model->vertex_count(), shape.rest_positions.size());
  EXPECT_EQ(model->triangle_count(), 32u);
  EXPECT_EQ(model->joint_count(), 5u);
  EXPECT_GE(model->report().degenerate_triangles, 2u);
  const SkinnedModel copy = *model;
  EXPECT_EQ(&copy.detail(), &model->detail()) << "copies share";
}

}  // namespace
}  // namespace pelt
