/// Peers that are asked about a body against itself give the answers that `Peer::answers` states.

#include "evaluation/peers/peer_figures.hpp"
#include "evaluation/peers/peers.hpp"
#include "self/neighbours.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::peers {
namespace {

using test::Shape;
using Contacts = std::vector<Contact>;

constexpr std::uint32_t kAllOfSelf = Limits().max_contacts;

struct Folded {
  std::vector<Vec3> positions;
  Contacts exact;
};

/// All pairs by the exact predicate. The vertices of a limb have different rest positions, so each
/// is a surface vertex of its own.
Contacts all_pairs(const Shape& shape, const std::vector<Vec3>& positions) {
  std::vector<detail::SurfaceTriangle> triangles;
  for (const Triangle& t : shape.triangles)
    triangles.push_back({{positions[t[0]], positions[t[1]], positions[t[2]]}, {t[0], t[1], t[2]}});
  Contacts contacts;
  for (std::uint32_t s = 0; s < triangles.size(); ++s)
    for (std::uint32_t t = s + 1; t < triangles.size(); ++t)
      if (surface_triangles_intersect(triangles[s], triangles[t])) contacts.push_back({s, t});
  return contacts;
}

/// A limb that is bent until it passes through itself.
class SelfPeers : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    test::Random random(1790);
    Pose pose(*build_model(limb_.view()));
    for (int i = 0; i < 12; ++i) {
      ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 6, random.uniform(0.5, 1.6), {})));
      Folded& folded = poses_.emplace_back();
      folded.positions.resize(limb_.rest_positions.size());
      posed_vertices(pose, folded.positions);
      folded.exact = all_pairs(limb_, folded.positions);
    }
  }

  static std::unique_ptr<rivals::PosedMeshMethod> method_of(const Peer& peer) {
    auto method = make_self_peer(peer.name);
    method->add(limb_.triangles, limb_.rest_positions);
    return method;
  }

  static Contacts ask(rivals::PosedMeshMethod& method, const Folded& folded,
                      std::uint32_t max_contacts = kAllOfSelf) {
    method.update(0, folded.positions);
    Contacts contacts;
    method.collide(0, 0, contacts, max_contacts);
    return contacts;
  }

  static inline const Shape limb_ = test::make_limb(30, 9, 6);
  static inline std::vector<Folded> poses_;
};

TEST_F(SelfPeers, AnswerAsTheyAreSaidTo) {
  for (const Peer& peer : all_self_peers()) {
    SCOPED_TRACE(peer.name);
    const auto method = method_of(peer);
    Difference sum;
    std::size_t exact = 0;
    for (const Folded& folded : poses_) {
      sum += compare(ask(*method, folded), folded.exact);
      exact += folded.exact.size();
    }
    EXPECT_GT(exact, 500u);
    EXPECT_EQ(sum.extra + sum.repeated, 0u);
    EXPECT_EQ(sum.missing > 0, peer.answers == Answers::fewer) << sum.missing;
    EXPECT_LT(sum.missing, exact / 2);
  }
}

TEST_F(SelfPeers, StopAtTheLimit) {
  for (const Peer& peer : all_self_peers()) {
    SCOPED_TRACE(peer.name);
    const auto method = method_of(peer);
    for (const Folded& folded : poses_) {
      Contacts all = ask(*method, folded);
      std::sort(all.begin(), all.end());
      for (const std::uint32_t limit : {0u, 1u, 2u}) {
        Contacts some = ask(*method, folded, limit);
        EXPECT_EQ(some.size(), std::min<std::size_t>(limit, all.size()));
        std::sort(some.begin(), some.end());
        EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
      }
    }
  }
}

/// Two triangles that share two vertices, and a third that has collapsed and crosses them.
TEST(SelfPeersWithCollapsedTriangles, CgalLeavesThemOut) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0},          {0, 1, 0},
                                       {1, 1, 1}, {0.25f, 0.25f, -1}, {0.25f, 0.25f, 1}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {1, 3, 2}, {4, 5, 4}};
  for (const Peer& peer : all_self_peers()) {
    SCOPED_TRACE(peer.name);
    const auto method = make_self_peer(peer.name);
    method->add(triangles, positions);
    method->update(0, positions);
    Contacts contacts;
    method->collide(0, 0, contacts, kAllOfSelf);
    const bool is_left_out = peer.narrow_phase == NarrowPhase::theirs;
    EXPECT_EQ(contacts, is_left_out ? Contacts{} : (Contacts{{0, 2}}));
  }
}

TEST(SelfPeerNames, AreDistinctAndKnown) {
  std::vector<std::string_view> names;
  for (const Peer& peer : all_self_peers()) {
    EXPECT_NE(make_self_peer(peer.name), nullptr);
    EXPECT_FALSE(peer.version.empty());
    names.push_back(peer.name);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  EXPECT_EQ(make_self_peer("pelt"), nullptr);
}

}  // namespace
}  // namespace pelt::peers
