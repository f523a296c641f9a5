#include "model/node_bounds.hpp"

#include "compiled_node_box.hpp"
#include "meshes.hpp"
#include "model/bound_fit.hpp"
#include "model/check_node_bounds.hpp"
#include "model/model.hpp"
#include "model/tree_build.hpp"
#include "model/unpack.hpp"
#include "skin/skin.hpp"
#include "support/skinned_shapes.hpp"
#include "support/targets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace pelt {
namespace {

using detail::BoundKind;
using detail::NodeBounds;
using detail::Palette;
using detail::SkinnedMesh;
using detail::Tree;
using test::Motion;
using test::PlainBox;
using test::Random;
using test::Shape;
using test::Weights;

/// Sets of vertices, by their places in the pools, that are to be bounded.
using Places = std::vector<std::vector<std::uint32_t>>;

/// All that lies below each node, as the tree is; besides, each vertex as a node of its own, where
/// rounding has nothing to hide behind, and threes, which are flat and lie askew.
Places nodes_and_a_few(const Tree& tree) {
  Places places(tree.nodes.size());
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const detail::Node& node = tree.nodes[n];
    for (std::uint32_t v = 0; v < node.vertex_count; ++v)
      places[n].push_back(node.first_vertex + v);
    for (std::uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c)
      places[n].insert(places[n].end(), places[c].begin(), places[c].end());
  }
  const auto count = static_cast<std::uint32_t>(tree.rest_positions.size());
  for (std::uint32_t v = 0; v < count; ++v) places.push_back({v});
  for (std::uint32_t v = 2; v < count; ++v) places.push_back({v - 2, v - 1, v});
  return places;
}

/// Both kinds of bound for every set: joint boxes at 2 i, affine at 2 i + 1.
NodeBounds fit_both_kinds(const Tree& tree, const Places& sets) {
  const detail::WeightRounding rounding = weight_rounding(tree);
  detail::NodeVertices vertices(tree);
  NodeBounds bounds;
  const auto add_joints = [&](BoundKind kind, std::span<const std::uint16_t> joints,
                              std::size_t first_record, float margin) {
    bounds.nodes.push_back({.kind = kind,
                            .joint_count = static_cast<std::uint16_t>(joints.size()),
                            .first_joint = static_cast<std::uint32_t>(bounds.joints.size()),
                            .first_record = static_cast<std::uint32_t>(first_record),
                            .shape = static_cast<std::uint32_t>(bounds.shapes.size()),
                            .margin = margin});
    bounds.joints.insert(bounds.joints.end(), joints.begin(), joints.end());
  };
  for (const auto& set : sets) {
    vertices.assign(set);
    const detail::JointBoxesFit boxes = fit_joint_boxes(vertices, rounding);
    add_joints(BoundKind::joint_boxes, vertices.joints(), bounds.joint_boxes.size(), boxes.margin);
    bounds.joint_boxes.insert(bounds.joint_boxes.end(), boxes.boxes.begin(), boxes.boxes.end());
    const detail::AffineFit affine = fit_affine(vertices, rounding);
    add_joints(BoundKind::affine, affine.joints, bounds.fits.size(), affine.margin);
    bounds.fits.insert(bounds.fits.end(), affine.fits.begin(), affine.fits.end());
    bounds.shapes.push_back(affine.shape);
  }
  return bounds;
}

/// A mesh with both kinds of bound around sets of its vertices.
struct Bounded {
  explicit Bounded(const SkinnedMesh& mesh)
      : tree(build_tree(mesh, test::rest_only(mesh))),
        vertices(unpack_vertices(tree)),
        sets(nodes_and_a_few(tree)),
        bounds(fit_both_kinds(tree, sets)),
        bare(bounds) {
    for (detail::NodeBound& bound : bare.nodes) bound.margin = 0;
  }

  explicit Bounded(const Shape& shape) : Bounded(test::mesh_of(shape)) {}

  Tree tree;
  SkinnedMesh vertices;  // in the order of the pools
  Places sets;
  NodeBounds bounds, bare;  // with and without margins
};

PlainBox box_around(const std::vector<Vec3>& posed, const std::vector<std::uint32_t>& set) {
  PlainBox box = {{HUGE_VALF, HUGE_VALF, HUGE_VALF}, {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF}};
  for (const std::uint32_t place : set) {
    const float p[] = {posed[place].x, posed[place].y, posed[place].z};
    for (int a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], p[a]);
      box.high[a] = std::max(box.high[a], p[a]);
    }
  }
  return box;
}

bool encloses(const PlainBox& box, const PlainBox& exact) {
  for (int a = 0; a < 3; ++a)
    if (!(box.low[a] <= exact.low[a] && exact.high[a] <= box.high[a])) return false;
  return true;
}

/// How far `exact` sticks out of `box`.
double excess(const PlainBox& box, const PlainBox& exact) {
  double most = 0;
  for (int a = 0; a < 3; ++a) {
    most = std::max(most, double{box.low[a]} - double{exact.low[a]});
    most = std::max(most, double{exact.high[a]} - double{box.high[a]});
  }
  return most;
}

PlainBox node_box(const NodeBounds& bounds, std::uint32_t node, const Palette& palette) {
  return test::scalar::compiled_node_box(bounds, node, palette);
}

std::vector<Vec3> pose(const SkinnedMesh& vertices, const Palette& palette) {
  std::vector<Vec3> posed(vertices.rest_positions.size());
  for (std::uint32_t v = 0; v < posed.size(); ++v)
    posed[v] = scalar::posed_vertex(vertices, palette, v);
  return posed;
}

const char* name_of(BoundKind kind) { return kind == BoundKind::affine ? "affine" : "joint boxes"; }

/// What was checked, and how much of the margins was needed.
struct Tally {
  std::size_t boxes = 0;
  double largest_share = 0;  // of the margin that a vertex needed
  double units_needed = 0;   // in u M
};

/// How much of the margin the posed vertices need.
void add_margin_needed(const Bounded& bounded, std::uint32_t node, const Palette& palette,
                       const PlainBox& exact, Tally& tally) {
  const double need = excess(node_box(bounded.bare, node, palette), exact);
  const double margin{bounded.bounds.nodes[node].margin}, extent{palette.extent()};
  tally.largest_share = std::max(tally.largest_share, need / (margin * extent));
  tally.units_needed = std::max(tally.units_needed, need / (0x1p-24 * extent));
}

bool is_finite(const PlainBox& box) {
  return std::all_of(box.low, box.low + 3, [](float c) { return std::isfinite(c); }) &&
         std::all_of(box.high, box.high + 3, [](float c) { return std::isfinite(c); });
}

/// Whether a build could take this bound.
bool is_usable(const Bounded& bounded, const detail::NodeBound& bound) {
  return !bound.is_affine() ||
         detail::stays_finite(
             {bounded.bounds.fits.data() + bound.first_record, bound.record_count()}, bound.margin,
             bounded.tree.rest_extent);
}

/// Both kinds of bound around every set of vertices, on every target. Stops at the first failure.
void expect_enclosed(const Bounded& bounded, const Palette& palette, Tally& tally) {
  const std::vector<Vec3> posed = pose(bounded.vertices, palette);
  for (std::uint32_t node = 0; node < bounded.bounds.nodes.size(); ++node) {
    const auto& set = bounded.sets[node / 2];
    const PlainBox exact = box_around(posed, set);
    const PlainBox box = node_box(bounded.bounds, node, palette);
    ASSERT_TRUE(encloses(box, exact))
        << name_of(bounded.bounds.nodes[node].kind) << " around " << set.size()
        << " vertices leave out one by " << excess(box, exact);
    ASSERT_TRUE(is_finite(box) || !is_usable(bounded, bounded.bounds.nodes[node]));
    for (const test::CompiledNodeBox& compiled : test::kCompiledNodeBoxes) {
      if (!test::runs_here(compiled.target)) continue;
      ASSERT_EQ(compiled.node_box(bounded.bounds, node, palette), box)
          << pelt::name_of(compiled.target);
    }
    add_margin_needed(bounded, node, palette, exact, tally);
    ++tally.boxes;
  }
}

void expect_enclosed(const Bounded& bounded, const std::vector<Matrix4>& matrices, Tally& tally) {
  Palette palette(bounded.tree.joint_count, bounded.tree.rest_extent);
  const auto taken = palette.set(matrices);
  ASSERT_TRUE(taken) << taken.error().message;
  expect_enclosed(bounded, palette, tally);
}

Matrix4 scaled(Matrix4 joint, float x, float y, float z) {
  for (std::size_t row = 0; row < 3; ++row)
    joint.m[row] *= x, joint.m[4 + row] *= y, joint.m[8 + row] *= z;
  return joint;
}

/// Palettes of every kind: rigid, affine, collapsed, far away, mirrored, shrunk, blown up, joints
/// torn apart, all joints alike, the rest pose.
std::vector<std::vector<Matrix4>> palettes_of_all_kinds(Random& random, std::uint32_t joint_count) {
  std::vector<std::vector<Matrix4>> all;
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
    all.push_back(test::make_palette(random, joint_count, motion, 2));
  const auto rigid = [&] { return test::make_palette(random, joint_count, Motion::rigid, 2); };
  const auto add_scaled = [&](float x, float y, float z) {
    all.push_back(rigid());
    for (Matrix4& joint : all.back()) joint = scaled(joint, x, y, z);
  };
  add_scaled(-1, 1, 1);
  add_scaled(-3, -3, -3);
  add_scaled(1e-6f, 1e-6f, 1e-6f);
  add_scaled(1e6f, 1, 1e-6f);
  add_scaled(0, 0, 0);
  all.push_back(test::make_palette(random, joint_count, Motion::rigid, 1e5));
  all.push_back(test::make_palette(random, joint_count, Motion::affine, 1e5));
  all.push_back(std::vector<Matrix4>(joint_count, rigid()[0]));
  all.push_back(std::vector<Matrix4>(joint_count));
  return all;
}

void expect_enclosed_in_all_poses(Random& random, const Shape& shape, Tally& tally) {
  const Bounded bounded(shape);
  for (const auto& palette : palettes_of_all_kinds(random, shape.joint_count)) {
    expect_enclosed(bounded, palette, tally);
    if (testing::Test::HasFatalFailure()) return;
  }
}

void report(const Tally& tally) {
  std::printf("%zu boxes, at most %.2f u M of margin needed, %.3f of what there was\n", tally.boxes,
              tally.units_needed, tally.largest_share);
}

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

TEST(NodeBounds, HoldNearTheLimitsOfFloats) {
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

/// The largest float that `is_taken`, of which smaller ones are.
template <typename IsTaken>
float largest(const IsTaken& is_taken) {
  std::uint32_t taken = 0, refused = std::bit_cast<std::uint32_t>(HUGE_VALF);
  while (refused - taken > 1) {
    const std::uint32_t middle = taken + (refused - taken) / 2;
    (is_taken(std::bit_cast<float>(middle)) ? taken : refused) = middle;
  }
  return std::bit_cast<float>(taken);
}

/// Joints turned about and mirrored: those at even places stretch, the others go away.
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

TEST(NodeBounds, HoldOnTheLargestPalettesThatAreTaken) {
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
TEST(NodeBounds, HoldInTheRestPoseOfTheLargestMesh) {
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

TEST(NodeBounds, HoldWhereJointsAndTrianglesAreOfAllSizesAtOnce) {
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

/// The area of the bounds of all nodes, as a build chooses them, over that of the exact boxes: of a
/// limb of 9,678 triangles in twenty poses.
double looseness_of_bent_limb(Random& random, double angle) {
  const SkinnedModel model = *build_model(test::make_limb(120, 40, 6).view());
  const Tree& tree = model.detail().tree;
  const SkinnedMesh vertices = unpack_vertices(tree);
  const Places sets = nodes_and_a_few(tree);
  Palette palette(tree.joint_count, tree.rest_extent);
  double bounds = 0, exact = 0;
  for (int pose_number = 0; pose_number < 20; ++pose_number) {
    const auto matrices = test::bend_limb(random, 6, angle, {});
    EXPECT_TRUE(palette.set(matrices));
    const std::vector<Vec3> posed = pose(vertices, palette);
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
      bounds += half_area(node_box(model.detail().bounds, n, palette));
      exact += half_area(box_around(posed, sets[n]));
    }
  }
  return bounds / exact;
}

/// Counted, so that a change that makes them looser is seen, and one that makes them tighter may
/// lower the limits.
TEST(NodeBounds, AreLittleLargerThanExactBoxesOnABentLimb) {
  Random random(34);
  EXPECT_LT(looseness_of_bent_limb(random, 0), 1.002);
  EXPECT_LT(looseness_of_bent_limb(random, 0.1), 1.45);
  EXPECT_LT(looseness_of_bent_limb(random, 0.3), 2.0);
  EXPECT_LT(looseness_of_bent_limb(random, 0.6), 2.5);
}

}  // namespace
}  // namespace pelt
