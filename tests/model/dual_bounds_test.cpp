/// Node boxes of models with dual quaternion skinning enclose every posed vertex, for each
/// instruction set.

#include "model/bound_fit.hpp"
#include "model/bounded.hpp"
#include "model/model.hpp"
#include "model/node_bounds.hpp"
#include "support/dual_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace pelt {
namespace {

using detail::NodeBounds;
using detail::Palette;
using test::box_around;
using test::encloses;
using test::excess;
using test::kCompiledNodeBoxes;
using test::PlainBox;
using test::Random;
using test::runs_here;
using test::Shape;
using test::Turns;
using test::VertexSets;
using test::Weights;

/// A model with bounds around sets of its vertices, and without the shift of linear skinning.
struct DualBounded {
  explicit DualBounded(const Shape& shape)
      : model(*build_model(shape.view(), test::kDual)),
        tree(model.detail().tree),
        vertices(unpack_vertices(tree)),
        sets(test::nodes_and_a_few(tree)),
        bounds(fit_set_bounds(tree, sets, detail::invent_sample_poses(vertices))),
        unshifted(bounds) {
    for (detail::DualBound& dual : unshifted.dual_bounds) dual.pair_count = 0;
  }

  SkinnedModel model;
  const detail::Tree& tree;
  detail::SkinnedMesh vertices;
  VertexSets sets;
  NodeBounds bounds, unshifted;
};

struct Tally {
  std::size_t boxes = 0, affine = 0, shifted = 0, tightened = 0;
};

/// By the boxes of the links alone, and by those of the node's pairs.
constexpr float kByLinks = 0x1p60f, kByPairs = -1;

void expect_enclosed(const DualBounded& bounded, const Palette& palette, Tally& tally) {
  const std::vector<Vec3> posed = test::pose(bounded.vertices, palette);
  for (std::uint32_t node = 0; node < bounded.sets.size(); ++node) {
    const PlainBox exact = box_around(posed, bounded.sets[node]);
    const PlainBox box = test::node_box(bounded.bounds, node, palette);
    ASSERT_TRUE(encloses(box, exact)) << bounded.sets[node].size() << " vertices leave out one by "
                                      << excess(box, exact) << " of " << palette.extent();
    ASSERT_TRUE(test::is_finite(box));
    for (const auto& compiled : kCompiledNodeBoxes)
      if (runs_here(compiled.set)) {
        ASSERT_EQ(compiled.call(bounded.bounds, node, palette), box);
      }
    const auto box_by = [&](float tolerance) {
      return test::scalar::compiled_dual_box(bounded.bounds, node, palette, tolerance);
    };
    const PlainBox by_links = box_by(kByLinks), by_pairs = box_by(kByPairs);
    ASSERT_TRUE(encloses(by_links, exact)) << excess(by_links, exact);
    ASSERT_TRUE(encloses(by_pairs, exact)) << excess(by_pairs, exact);
    ++tally.boxes;
    tally.tightened += by_links != by_pairs;
    tally.affine += bounded.bounds.nodes[node].is_affine();
    tally.shifted += !encloses(test::node_box(bounded.unshifted, node, palette), exact);
  }
}

TEST(DualBounds, EncloseSoupsOfAnyWeightsInAnyPose) {
  Random random(80);
  Tally tally;
  for (const std::uint32_t influences : {1u, 2u, 3u, 4u, 16u})
    for (const Weights weights : {Weights::random, Weights::adversarial})
      for (const std::uint32_t joints : {2u, 4u, 40u}) {
        const DualBounded bounded(test::make_soup(random, 40, joints, influences, weights));
        for (const Turns turns : test::kAllTurns)
          for (const double spread : {0.0, 2.0, 1e4}) {
            Palette palette = rest_palette(bounded.tree);
            ASSERT_TRUE(palette.set(test::random_rigid_palette(random, joints, turns, spread)));
            expect_enclosed(bounded, palette, tally);
            if (HasFatalFailure()) return;
          }
      }
  std::printf("%zu boxes, %zu affine, %zu wrong without the shift, %zu tighter by pairs\n",
              tally.boxes, tally.affine, tally.shifted, tally.tightened);
  EXPECT_GT(tally.boxes, 50000u);
  EXPECT_GT(tally.shifted, 1000u);
  EXPECT_GT(tally.tightened, 1000u);
}

TEST(DualBounds, EncloseBentAndTwistedLimbs) {
  Random random(81);
  Tally tally;
  for (const std::uint32_t joints : {2u, 5u, 30u}) {
    const DualBounded bounded(test::make_limb(40, 10, joints));
    for (const double angle : {0.1, 0.6, 1.5, 3.0}) {
      Palette palette = rest_palette(bounded.tree);
      ASSERT_TRUE(palette.set(test::bend_limb(random, joints, angle, {1, 0, 0})));
      expect_enclosed(bounded, palette, tally);
      ASSERT_TRUE(palette.set(test::twist_limb(joints, angle, {1, 0, 0})));
      expect_enclosed(bounded, palette, tally);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(tally.affine, 1000u);
  EXPECT_GT(tally.shifted, 100u);
}

TEST(DualBounds, EncloseMorphedVertices) {
  Random random(82);
  Tally tally;
  for (int round = 0; round < 6; ++round) {
    Shape shape = round % 2 == 0 ? test::make_morphing_limb(24, 8, 4)
                                 : test::make_soup(random, 60, 6, 4, Weights::random);
    if (round % 2 != 0) test::add_morph_targets(random, shape, 5, 0.3, 0.5);
    const DualBounded bounded(shape);
    for (const test::Morphing morphing : test::kAllMorphings) {
      Palette palette = rest_palette(bounded.tree);
      ASSERT_TRUE(palette.set_morph_weights(
          test::make_morph_weights(random, shape.morph_target_count(), morphing)));
      for (const Turns turns : test::kAllTurns) {
        ASSERT_TRUE(palette.set(test::random_rigid_palette(random, shape.joint_count, turns, 2)));
        expect_enclosed(bounded, palette, tally);
        if (HasFatalFailure()) return;
      }
    }
  }
  EXPECT_GT(tally.boxes, 5000u);
}

TEST(DualBounds, EncloseVerticesOfAnySize) {
  Random random(83);
  Tally tally;
  for (const float size : {0x1p-140f, 0x1p-90f, 0x1p-30f, 0x1p30f, 0x1p50f}) {
    Shape shape = test::make_soup(random, 40, 6, 4, Weights::adversarial);
    for (Vec3& p : shape.rest_positions) p = {size * p.x, size * p.y, size * p.z};
    const DualBounded bounded(shape);
    for (const Turns turns : test::kAllTurns)
      for (const double spread : {0.0, 0x1p-130, 1.0, 0x1p50}) {
        Palette palette = rest_palette(bounded.tree);
        ASSERT_TRUE(palette.set(test::random_rigid_palette(random, 6, turns, spread)));
        expect_enclosed(bounded, palette, tally);
        if (HasFatalFailure()) return;
      }
  }
}

using detail::JointLink;
using detail::Tree;

using Joints = std::pair<std::uint16_t, std::uint16_t>;

/// Calls `visit(place, joints)` for every two joints of every vertex.
template <typename Visit>
void each_pair(const Tree& tree, const Visit& visit) {
  for (std::size_t place = 0; place < tree.rest_positions.size(); ++place)
    for (std::uint32_t a = tree.influence_begin[place]; a < tree.influence_begin[place + 1]; ++a)
      for (std::uint32_t b = tree.influence_begin[place]; b < tree.influence_begin[place + 1]; ++b)
        if (tree.joints[a] < tree.joints[b]) visit(place, Joints(tree.joints[a], tree.joints[b]));
}

bool contains(const JointLink& link, const Vec3& p) {
  const float v[] = {p.x, p.y, p.z};
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::fabs(double{v[axis]} - double{link.centre[axis]}) <= double{link.half[axis]}))
      return false;
  return true;
}

TEST(JointLinks, EncloseTheVerticesThatFollowBothJoints) {
  test::Random random(90);
  for (const std::uint32_t joints : {2u, 5u, 40u}) {
    const auto model = build_model(
        test::make_soup(random, 200, joints, 4, test::Weights::random).view(), test::kDual);
    ASSERT_TRUE(model);
    const Tree& tree = model->detail().tree;
    std::set<Joints> expected;
    each_pair(tree, [&](std::size_t place, const Joints& pair) {
      expected.insert(pair);
      const JointLink& link = tree.links[detail::link_of(tree.links, pair.second, pair.first)];
      EXPECT_EQ(joints_of(link), pair);
      EXPECT_TRUE(contains(link, tree.rest_positions[place]));
    });
    std::vector<Joints> found;
    for (const JointLink& link : tree.links) found.push_back(joints_of(link));
    EXPECT_EQ(found, std::vector<Joints>(expected.begin(), expected.end()));
    EXPECT_GE(found.size(), joints - 1);
  }
}

TEST(JointLinks, ModelsWithLinearBlendSkinningHaveNone) {
  test::Random random(91);
  const auto model = build_model(test::make_soup(random, 40, 5, 4, test::Weights::random).view());
  ASSERT_TRUE(model);
  EXPECT_TRUE(model->detail().tree.links.empty());
}

}  // namespace
}  // namespace pelt
