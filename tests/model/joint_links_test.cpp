#include "model/bound_fit.hpp"

#include "model/model.hpp"
#include "support/dual_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace pelt {
namespace {

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
