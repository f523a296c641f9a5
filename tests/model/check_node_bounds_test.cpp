#include "model/check_tree.hpp"

#include "model/model.hpp"
#include "model/node_box.hpp"
#include "support/dual_shapes.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelt::detail {
namespace {

using test::Random;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Model sound_model() { return build_model(test::make_morphing_limb(40, 12, 5).view())->detail(); }

NodeBound& first_of(NodeBounds& bounds, BoundKind kind) {
  return *std::find_if(bounds.nodes.begin(), bounds.nodes.end(),
                       [=](const NodeBound& bound) { return bound.kind == kind; });
}

/// Gives a node the shape of a node whose vertices are displaced by more targets.
void share_a_shape(NodeBounds& b) {
  const auto displacements = [&](const NodeBound& bound) {
    const std::size_t body = b.joint_boxes.size() + bound.shape;
    return b.displacement_begin[body + 1] - b.displacement_begin[body];
  };
  for (NodeBound& one : b.nodes)
    for (const NodeBound& other : b.nodes)
      if (one.is_affine() && other.is_affine() && displacements(one) < displacements(other)) {
        one.shape = other.shape;
        return;
      }
}

struct Breach {
  const char* words;  ///< of the message
  void (*commit)(NodeBounds&);
};

const Breach kBreaches[] = {
    {"but the tree", [](NodeBounds& b) { b.nodes.pop_back(); }},
    {"kind is 2", [](NodeBounds& b) { b.nodes[1].kind = static_cast<BoundKind>(2); }},
    {"has no joints", [](NodeBounds& b) { b.nodes[1].joint_count = 0; }},
    {"beyond the end", [](NodeBounds& b) { b.nodes[1].joint_count = 0xFFFF; }},
    {"beyond the end", [](NodeBounds& b) { b.nodes[1].first_joint = 0xFFFFFFFF; }},
    {"beyond the end", [](NodeBounds& b) { b.nodes[1].first_record = 0xFFFFFFFF; }},
    {"beyond the end",
     [](NodeBounds& b) {
       first_of(b, BoundKind::affine).shape = static_cast<std::uint32_t>(b.shapes.size());
     }},
    {"margin is nan", [](NodeBounds& b) { b.nodes[1].margin = kNan; }},
    {"margin is -1", [](NodeBounds& b) { b.nodes[1].margin = -1; }},
    {"margin is 1e+30", [](NodeBounds& b) { b.nodes[1].margin = 1e30f; }},
    {"joints of", [](NodeBounds& b) { b.joints.push_back(0); }},
    {"joints of",  // nodes that share their joints would multiply the work
     [](NodeBounds& b) { b.nodes.front() = b.nodes.back(); }},
    {"joint_boxes of", [](NodeBounds& b) { b.joint_boxes.push_back({}); }},
    {"shapes of", [](NodeBounds& b) { b.shapes.push_back({}); }},
    {"fits of", [](NodeBounds& b) { b.fits.push_back({}); }},

    {"joints[0] is 5, but joint_count is 5", [](NodeBounds& b) { b.joints[0] = 5; }},
    {"joint_boxes[0] is not a box", [](NodeBounds& b) { b.joint_boxes[0].centre[1] = kNan; }},
    {"joint_boxes[0] is not a box", [](NodeBounds& b) { b.joint_boxes[0].centre[0] = 1e9f; }},
    {"joint_boxes[0] is not a box", [](NodeBounds& b) { b.joint_boxes[0].centre[3] = 0; }},
    {"joint_boxes[0] is not a box", [](NodeBounds& b) { b.joint_boxes[0].half[2] = -0.1f; }},
    {"joint_boxes[0] is not a box", [](NodeBounds& b) { b.joint_boxes[0].half[2] = HUGE_VALF; }},
    {"shapes[0] is not a shape", [](NodeBounds& b) { b.shapes[0].centre[0] = kNan; }},
    {"shapes[0] is not a shape", [](NodeBounds& b) { b.shapes[0].half[0] = -1; }},
    {"shapes[0] is not a shape", [](NodeBounds& b) { b.shapes[0].axes_centre[1] = 1e9f; }},
    {"shapes[0] is not a shape", [](NodeBounds& b) { b.shapes[0].axes[2][2] = kNan; }},
    {"fits[0] has a negative half extent", [](NodeBounds& b) { b.fits[0].spread[3] = -0.1f; }},
    {"fits[0] has a negative half extent", [](NodeBounds& b) { b.fits[0].spread[1] = -0.1f; }},
    {"fits[0] has a shift of four", [](NodeBounds& b) { b.fits[0].shift[3] = 1; }},
    {"can become infinite", [](NodeBounds& b) { b.fits[0].line[3] = kNan; }},
    {"can become infinite", [](NodeBounds& b) { b.fits[0].line[3] = 1e17f; }},
    {"can become infinite", [](NodeBounds& b) { b.fits[0].line[1] = -HUGE_VALF; }},
    {"can become infinite", [](NodeBounds& b) { b.fits[0].spread[3] = 1e30f; }},
    {"can become infinite", [](NodeBounds& b) { b.fits[0].shift[2] = kNan; }},
    {"can become infinite", [](NodeBounds& b) { b.fits[0].spread[0] = 3e38f; }},
    {"can become infinite",
     [](NodeBounds& b) { b.fits[0].shift[0] = 1e30f, b.fits[0].spread[0] = -1e30f; }},

    {"displacement_begin has 0", [](NodeBounds& b) { b.displacement_begin.clear(); }},
    {"displacement_begin does not ascend", [](NodeBounds& b) { b.displacements.pop_back(); }},
    {"displacement_begin does not ascend", [](NodeBounds& b) { b.displacement_begin[1] = 10000; }},
    {"displacements of",  // a body of two nodes would multiply the work
     [](NodeBounds& b) { share_a_shape(b); }},
    {"is of target 3", [](NodeBounds& b) { b.displacements.back().target = 3; }},
    {"out of order", [](NodeBounds& b) { b.displacements[1].target = b.displacements[0].target; }},
    {"displacements[0] is not a box", [](NodeBounds& b) { b.displacements[0].centre[0] = kNan; }},
    {"displacements[0] is not a box", [](NodeBounds& b) { b.displacements[0].centre[1] = 1; }},
    {"displacements[0] is not a box", [](NodeBounds& b) { b.displacements[0].half[2] = -1; }},
    {"displacements[0] is not a box", [](NodeBounds& b) { b.displacements[0].half[3] = 1; }},
};

struct DualBreach {
  const char* words;
  void (*commit)(Tree&, NodeBounds&);
};

const DualBreach kDualBreaches[] = {
    {"with linear blend skinning", [](Tree& t, NodeBounds&) { t.dual_influences = 0; }},
    {"links[0] has the joints", [](Tree& t, NodeBounds&) { t.links[0].second = 5; }},
    {"links[0] has the joints", [](Tree& t, NodeBounds&) { t.links[0].first = 4; }},
    {"links[1] does not ascend", [](Tree& t, NodeBounds&) { t.links[1] = t.links[0]; }},
    {"links[1] is not a box", [](Tree& t, NodeBounds&) { t.links[1].centre[0] = kNan; }},
    {"links[1] is not a box", [](Tree& t, NodeBounds&) { t.links[1].half[2] = -1; }},
    {"links[1] is not a box", [](Tree& t, NodeBounds&) { t.links[1].half[0] = 1e9f; }},

    {"dual_bounds has 0", [](Tree&, NodeBounds& b) { b.dual_bounds.clear(); }},
    {"other joint_pairs", [](Tree&, NodeBounds& b) { b.dual_bounds.front().first_pair = 0; }},
    {"other joint_pairs", [](Tree&, NodeBounds& b) { b.dual_bounds.front().pair_count = 10000; }},
    {"has sums of", [](Tree&, NodeBounds& b) { b.dual_bounds.back().product_sum = 0.6f; }},
    {"has sums of", [](Tree&, NodeBounds& b) { b.dual_bounds.back().skew_sum = kNan; }},
    {"of ", [](Tree&, NodeBounds& b) { b.joint_pairs.push_back(b.joint_pairs.back()); }},
    {"link is 7 of 7", [](Tree&, NodeBounds& b) { b.joint_pairs[0].link = 7; }},
    {"first is not", [](Tree&, NodeBounds& b) { b.joint_pairs[0].first = 0xFFFFFFFF; }},
    {"first is not", [](Tree&, NodeBounds& b) { b.joint_pairs.back().first ^= 1; }},
    {"impossible products", [](Tree&, NodeBounds& b) { b.joint_pairs[0].least = -1; }},
    {"impossible products", [](Tree&, NodeBounds& b) { b.joint_pairs[0].most = kNan; }},
    {"impossible products", [](Tree&, NodeBounds& b) { b.joint_pairs[0].skew = 1; }},
    {"pivot is 0.5", [](Tree&, NodeBounds& b) { b.joint_pairs[0].pivot = 0.5f; }},
    {"joint_pairs[0] is not a box", [](Tree&, NodeBounds& b) { b.joint_pairs[0].half[1] = -1; }},
};

TEST(CheckNodeBounds, FindsEveryBreachOfDualBounds) {
  const Model sound = build_model(test::make_limb(40, 12, 5).view(), test::kDual)->detail();
  ASSERT_EQ(sound.tree.links.size(), 7u);
  ASSERT_EQ(check_node_bounds(sound.bounds, sound.tree), "");
  for (const DualBreach& breach : kDualBreaches) {
    Model model = sound;
    breach.commit(model.tree, model.bounds);
    const Problem found = check_node_bounds(model.bounds, model.tree);
    EXPECT_NE(found.find(breach.words), std::string::npos)
        << "expected: " << breach.words << "\nfound:    " << found;
  }
}

TEST(CheckNodeBounds, FindsNothingInSoundBounds) {
  Random random(303);
  int affine = 0;
  for (const auto weights : {test::Weights::one_joint, test::Weights::adversarial})
    for (const double scale : {1e-30, 1e-18, 1e-3, 1.0, 1e6, 1e15}) {
      test::Shape shape = test::make_soup(random, 200, 6, 4, weights);
      const test::Shape limb = test::make_limb(20, 8, 3);
      if (random.chance(0.5)) shape = limb;
      for (Vec3& p : shape.rest_positions) {
        const auto s = static_cast<float>(scale);
        p = {p.x * s, p.y * s, p.z * s};
      }
      const SkinnedModel model = *build_model(shape.view());
      EXPECT_EQ(check_node_bounds(model.detail().bounds, model.detail().tree), "") << scale;
      affine += !model.detail().bounds.fits.empty();
    }
  EXPECT_GT(affine, 2);
}

TEST(CheckNodeBounds, FindsEveryBreach) {
  const Model sound = sound_model();
  ASSERT_FALSE(sound.bounds.fits.empty());
  ASSERT_FALSE(sound.bounds.joint_boxes.empty());
  for (const Breach& breach : kBreaches) {
    NodeBounds bounds = sound.bounds;
    breach.commit(bounds);
    const Problem found = check_node_bounds(bounds, sound.tree);
    EXPECT_NE(found.find(breach.words), std::string::npos)
        << "expected: " << breach.words << "\nfound:    " << found;
  }
}

bool is_finite(const Box4& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(box.low[axis]) || !std::isfinite(box.high[axis])) return false;
  return true;
}

/// Sets fits of each joint up to the limit `q` of check_node_bounds.cpp, in a mesh of this extent.
void forge(Random& random, double extent, double q, Model& model) {
  model.tree.rest_extent = static_cast<float>(extent);
  for (float& morph_extent : model.tree.morphs.extents) morph_extent = model.tree.rest_extent;
  for (DisplacementBox& box : model.bounds.displacements)
    for (float* v : {box.centre, box.half}) std::fill_n(v, 3, static_cast<float>(4 * extent));
  for (JointBox& box : model.bounds.joint_boxes) box = {};
  for (RestShape& shape : model.bounds.shapes) {
    shape = {};
    for (float* v :
         {shape.centre, shape.half, shape.axes_centre, shape.axes[0], shape.axes[1], shape.axes[2]})
      std::fill_n(v, 3, static_cast<float>(4 * extent));
  }
  for (JointFit& fit : model.bounds.fits) {
    const auto size = [&](double unit) {
      return static_cast<float>(std::min(unit * q * random.unit(), 0x1p127));
    };
    fit = {};
    fit.line[3] = size(1), fit.line[0] = -size(1 / extent), fit.spread[3] = size(1);
    fit.shift[1] = size(extent), fit.spread[2] = size(extent);
  }
}

/// Some joints scale, without cancellation, and others translate, each as far as allowed.
std::vector<Matrix4> largest_joints(Random& random, std::uint32_t joint_count, double extent) {
  std::vector<Matrix4> joints(joint_count);
  for (Matrix4& joint : joints) {
    const bool stretches = random.chance(0.7);
    const double size = random.chance(0.5) ? 0x1.FFFFp59 : -0x1.FFFFp59;
    for (const int e : {0, 1, 2, 4, 5, 6, 8, 9, 10})
      joint.m[e] = stretches ? static_cast<float>(size / extent) : 0;
    for (const int e : {12, 13, 14}) joint.m[e] = stretches ? 0 : static_cast<float>(size);
  }
  return joints;
}

/// The largest palettes, with bounds of random numbers up to the limits.
TEST(CheckNodeBounds, WhatPassesIsFiniteOnEveryPalette) {
  Random random(304);
  Model model = sound_model();
  int passed = 0, affine = 0, refused = 0;
  for (int round = 0; round < 4000; ++round) {
    const double extent = std::ldexp(1.0, static_cast<int>(random.index(122)) - 60);
    forge(random, extent, std::ldexp(1.0, static_cast<int>(random.index(62))), model);
    if (!check_node_bounds(model.bounds, model.tree).empty()) {
      ++refused;
      continue;
    }
    ++passed;
    Palette palette = rest_palette(model.tree);
    const Palette fresh = palette;
    const bool morphed = random.chance(0.5) && extent < 0x1p57;
    if (morphed) {
      ASSERT_TRUE(palette.set_morph_weights(std::vector<float>{1, 1, -1}));
    }
    ASSERT_TRUE(palette.set(
        largest_joints(random, model.tree.joint_count, morphed ? 4.01 * extent : extent)));
    for (std::uint32_t n = 0; n < model.bounds.nodes.size(); ++n) {
      ASSERT_TRUE(is_finite(node_box(model.bounds, n, fresh))) << "round " << round;
      ASSERT_TRUE(is_finite(node_box(model.bounds, n, palette))) << "round " << round;
      affine += model.bounds.nodes[n].kind == BoundKind::affine;
    }
  }
  EXPECT_GT(passed, 1000);
  EXPECT_GT(affine, 1000);
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace pelt::detail
