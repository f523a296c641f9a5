#include "model/node_bounds.hpp"

#include "bounded.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace pelt {
namespace {

using detail::NodeBounds;
using detail::Palette;
using detail::SkinnedMesh;
using detail::Tree;
using test::Bounded;
using test::box_around;
using test::expect_enclosed;
using test::expect_enclosed_in_all_poses;
using test::Motion;
using test::PlainBox;
using test::Random;
using test::Shape;
using test::Tally;
using test::Weights;

TEST(NodeBounds, BothKindsEncloseSoupsOfAnyWeightsInAnyPose) {
  Random random(30);
  Tally tally;
  for (const std::uint32_t influences : {1u, 4u, 12u, 40u})
    for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
      for (const std::uint32_t joints : {1u, 3u, 50u}) {
        SCOPED_TRACE(joints);
        const Shape soup = test::make_soup(random, 40, joints, influences, weights);
        expect_enclosed_in_all_poses(random, soup, tally);
        if (HasFatalFailure()) return;
      }
  report(tally);
  EXPECT_GT(tally.boxes, 200000u);
  EXPECT_GT(tally.units_needed, 2) << "rounding must be seen";
  EXPECT_GT(tally.largest_share, 0.1) << "not a margin to be proud of";
}

TEST(NodeBounds, BothKindsEncloseLimbsInAnyPose) {
  Random random(31);
  Tally tally;
  for (const std::uint32_t joints : {2u, 5u, 40u}) {
    expect_enclosed_in_all_poses(random, test::make_limb(20, 8, joints), tally);
    if (HasFatalFailure()) return;
  }
  report(tally);
  EXPECT_GT(tally.boxes, 20000u);
}

/// Each joint's linear part times `linear`, its translation times `translation`.
std::vector<Matrix4> stretched(std::vector<Matrix4> palette, float linear, float translation) {
  for (Matrix4& joint : palette)
    for (std::size_t column = 0; column < 4; ++column)
      for (std::size_t row = 0; row < 3; ++row)
        joint.m[4 * column + row] *= column == 3 ? translation : linear;
  return palette;
}

TEST(NodeBounds, EncloseVerticesNearTheLimitsOfFloats) {
  Random random(32);
  Tally tally;
  for (const float size : {0x1p-140f, 0x1p-125f, 0x1p-90f, 0x1p-60f, 0x1p-30f, 0x1p30f, 0x1p56f})
    for (const bool is_soup : {false, true}) {
      Shape shape = is_soup ? test::make_soup(random, 40, 9, 12, Weights::adversarial)
                            : test::make_limb(12, 7, 4);
      for (Vec3& p : shape.rest_positions) p = {size * p.x, size * p.y, size * p.z};
      const Bounded bounded(shape);
      const float largest = 0x1p56f / std::max(size, 0x1p-60f);
      for (const float linear : {0.0f, 0x1p-147f, 0x1p-128f, 0x1p-100f, 1.0f, largest})
        for (const float translation : {0.0f, 0x1p-147f, 0x1p-70f, 1.0f, 0x1p57f}) {
          SCOPED_TRACE(testing::Message() << "size " << size << ", linear part " << linear
                                          << ", translation " << translation);
          const auto rigid = test::make_palette(random, shape.joint_count, Motion::rigid, 1);
          expect_enclosed(bounded, stretched(rigid, std::min(linear, largest), translation), tally);
          if (HasFatalFailure()) return;
        }
    }
  report(tally);
  EXPECT_GT(tally.boxes, 150000u);
}

/// The largest float for which `is_taken` is true; it must be true for smaller ones.
template <typename IsTaken>
float largest(const IsTaken& is_taken) {
  std::uint32_t taken = 0, refused = std::bit_cast<std::uint32_t>(HUGE_VALF);
  while (refused - taken > 1) {
    const std::uint32_t middle = taken + (refused - taken) / 2;
    (is_taken(std::bit_cast<float>(middle)) ? taken : refused) = middle;
  }
  return std::bit_cast<float>(taken);
}

/// Rotated and mirrored joints: even joints scale, odd joints translate.
std::vector<Matrix4> stretching_and_going(Random& random, std::uint32_t joint_count, float linear,
                                          float translation) {
  std::vector<Matrix4> joints(joint_count);
  for (std::uint32_t j = 0; j < joint_count; ++j) {
    const auto signed_value = [&](float value) { return random.chance(0.5) ? value : -value; };
    for (const int e : {0, 1, 2, 4, 5, 6, 8, 9, 10})
      joints[j].m[e] = j % 2 == 0 ? signed_value(linear) : 0;
    for (const int e : {12, 13, 14}) joints[j].m[e] = j % 2 == 0 ? 0 : signed_value(translation);
  }
  return joints;
}

TEST(NodeBounds, EncloseVerticesUnderTheLargestValidPalettes) {
  Random random(35);
  Tally tally;
  for (const float size : {0x1p-80f, 0x1p-60f, 1.0f, 0x1p56f})
    for (const Weights weights : {Weights::random, Weights::adversarial}) {
      SCOPED_TRACE(size);
      Shape soup = test::make_soup(random, 40, 6, 4, weights);
      for (Vec3& p : soup.rest_positions) p = {size * p.x, size * p.y, size * p.z};
      const Bounded bounded(soup);
      Palette palette(6, bounded.tree.rest_extent);
      const auto take = [&](float linear, float translation) {
        return bool{palette.set(stretching_and_going(random, 6, linear, translation))};
      };
      const float linear = largest([&](float value) { return take(value, 0); });
      const float translation = largest([&](float value) { return take(0, value); });
      EXPECT_FALSE(take(std::nextafter(linear, HUGE_VALF), translation));
      EXPECT_FALSE(take(linear, std::nextafter(translation, HUGE_VALF)));
      ASSERT_TRUE(take(linear, translation));
      EXPECT_GT(palette.extent(), 0x1.FFFFp60f) << "each alone may have 2^60";
      EXPECT_LT(palette.extent(), detail::kMaxExtent);
      expect_enclosed(bounded, palette, tally);
      if (HasFatalFailure()) return;
    }
  report(tally);
  EXPECT_GT(tally.boxes, 1000u);
}

/// A new palette has a larger extent than one that can be set.
TEST(NodeBounds, EncloseTheRestPoseOfTheLargestMesh) {
  Random random(36);
  Tally tally;
  Shape soup = test::make_soup(random, 40, 6, 4, Weights::adversarial);
  for (Vec3& p : soup.rest_positions)
    p = {std::copysign(0x1p60f, p.x), 0x1p60f * p.y / 8, std::copysign(0x1p60f, p.z)};
  soup.rest_positions[0].y = -0x1p60f;
  const Bounded bounded(soup);
  const Palette palette(6, bounded.tree.rest_extent);
  EXPECT_GT(palette.extent(), 3 * 0x1p60f);
  EXPECT_LT(palette.extent(), detail::kMaxExtent);
  expect_enclosed(bounded, palette, tally);
  report(tally);
}

TEST(NodeBounds, EncloseVerticesIfJointsAndTrianglesDifferInSize) {
  Random random(33);
  const auto power = [&](int low, int high) {
    return std::ldexp(1.0f,
                      low + static_cast<int>(random.index(static_cast<unsigned>(high - low))));
  };
  Tally tally;
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    Shape soup = test::make_soup(random, 60, 12, 5, Weights::adversarial);
    for (std::size_t v = 0; v < soup.rest_positions.size(); v += 3) {
      const float size = power(-75, 1);
      for (std::size_t k = v; k < v + 3; ++k) {
        Vec3& p = soup.rest_positions[k];
        p = {size * p.x, size * p.y, size * p.z};
      }
    }
    auto palette = test::make_palette(random, 12, Motion::affine, 1);
    for (std::uint32_t j = 0; j < 12; ++j)
      palette[j] = stretched({palette[j]}, power(-149, 55), power(-149, 58))[0];
    expect_enclosed(Bounded(soup), palette, tally);
    if (HasFatalFailure()) return;
  }
  report(tally);
  EXPECT_GT(tally.boxes, 10000u);
}

double half_area(const PlainBox& box) {
  double size[3];
  for (int a = 0; a < 3; ++a) size[a] = double{box.high[a]} - double{box.low[a]};
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

/// The area of the bounds of all nodes, as a build chooses them, over the area of the exact boxes,
/// for a limb of 9,678 triangles in twenty poses.
double looseness_of_bent_limb(Random& random, double angle) {
  const SkinnedModel model = *build_model(test::make_limb(120, 40, 6).view());
  const Tree& tree = model.detail().tree;
  const SkinnedMesh vertices = unpack_vertices(tree);
  const test::VertexSets sets = test::nodes_and_a_few(tree);
  Palette palette(tree.joint_count, tree.rest_extent);
  double bounds = 0, exact = 0;
  for (int pose_number = 0; pose_number < 20; ++pose_number) {
    const auto matrices = test::bend_limb(random, 6, angle, {});
    EXPECT_TRUE(palette.set(matrices));
    const std::vector<Vec3> posed = test::pose(vertices, palette);
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
      bounds += half_area(test::node_box(model.detail().bounds, n, palette));
      exact += half_area(box_around(posed, sets[n]));
    }
  }
  return bounds / exact;
}

/// Limits on the looseness, so that a change that loosens the bounds is noticed. A change that
/// tightens them may lower the limits.
TEST(NodeBounds, AreLittleLargerThanExactBoxesOnABentLimb) {
  Random random(34);
  EXPECT_LT(looseness_of_bent_limb(random, 0), 1.002);
  EXPECT_LT(looseness_of_bent_limb(random, 0.1), 1.45);
  EXPECT_LT(looseness_of_bent_limb(random, 0.3), 2.0);
  EXPECT_LT(looseness_of_bent_limb(random, 0.6), 2.5);
}

}  // namespace
}  // namespace pelt
