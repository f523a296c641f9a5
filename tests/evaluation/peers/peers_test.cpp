/// Every peer does the work that it is measured for: it finds contacts, with the quality that
/// `Peer::answers` states.

#include "evaluation/peers/peers.hpp"

#include "evaluation/peers/peer_figures.hpp"
#include "scenes/creature.hpp"
#include "scenes/scene.hpp"
#include "self/neighbours.hpp"
#include "support/skinned_shapes.hpp"
#include "tools/pelt/methods/brute_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::peers {
namespace {

using test::Shape;

using Contacts = std::vector<Contact>;
using Positions = std::vector<Vec3>;

constexpr std::uint32_t kAll = Limits().max_contacts;

/// The posed vertices of each body, and the answer of brute force.
struct Frame {
  std::vector<Positions> positions;
  Contacts exact;
};

/// Bodies of which the first is queried against the last: two, or one against itself.
struct Stage {
  std::span<const Peer> peers;
  std::unique_ptr<rivals::PosedMeshMethod> (*make)(std::string_view name);

  /// The largest shares of contacts that a peer may miss and invent if `Peer::answers` says that it
  /// finds fewer contacts.
  double most_missing, most_extra;

  std::vector<std::vector<Triangle>> triangles = {};  ///< by body
  std::vector<Positions> rest = {};                   ///< by body
  std::vector<Frame> frames = {};

  std::unique_ptr<rivals::PosedMeshMethod> method_of(const Peer& peer) const {
    auto method = make(peer.name);
    for (std::size_t body = 0; body < rest.size(); ++body) method->add(triangles[body], rest[body]);
    return method;
  }

  QueryStats collide(rivals::PosedMeshMethod& method, Contacts& contacts,
                     std::uint32_t max_contacts = kAll) const {
    return method.collide(0, static_cast<std::uint32_t>(rest.size() - 1), contacts, max_contacts);
  }

  Contacts ask(rivals::PosedMeshMethod& method, const Frame& frame,
               std::uint32_t max_contacts = kAll) const {
    for (std::uint32_t body = 0; body < rest.size(); ++body)
      method.update(body, frame.positions[body]);
    Contacts contacts;
    collide(method, contacts, max_contacts);
    return contacts;
  }
};

Positions posed(Pose& pose, std::span<const Matrix4> palette) {
  EXPECT_TRUE(pose.set_palette(palette));
  Positions positions(pose.model().vertex_count());
  posed_vertices(pose, positions);
  return positions;
}

/// A dwarf and a man that walk through each other, away from the origin, and end apart.
scenes::Scene walkers() {
  scenes::Scene scene;
  scene.frame_count = 12;
  scene.fps = 6;
  for (const scenes::CreatureOptions& options : {scenes::kDwarf, scenes::kMan}) {
    auto character = scenes::generate_character(options);
    EXPECT_TRUE(character);
    scene.characters.push_back(std::move(*character));
  }
  scenes::Instance dwarf, man;
  dwarf.clip = man.clip = "walk";
  dwarf.translation = {10.1, 0, 4.6};
  man.translation = {10, 0, 5};
  man.character = 1;
  man.rotation = {0, 1, 0, 0};
  man.velocity = {0.1, 0, -0.9};
  dwarf.velocity = {0, 0, 0.9};
  scene.instances = {dwarf, man};
  return scene;
}

Stage make_pairs() {
  Stage stage = {all_peers(), make_peer, 0.1, 0.02};
  const scenes::Scene scene = walkers();
  std::vector<Pose> poses;
  for (const scenes::Character& character : scene.characters) {
    const std::span<const Triangle> triangles = character.asset.mesh().triangles;
    stage.triangles.emplace_back(triangles.begin(), triangles.end());
    poses.emplace_back(*build_model(character.asset.mesh()));
  }
  asset::SampleScratch scratch;
  for (std::uint32_t number = 0; number < scene.frame_count; ++number) {
    Frame& frame = stage.frames.emplace_back();
    for (std::uint32_t body = 0; body < 2; ++body) {
      std::vector<Matrix4> palette(poses[body].model().joint_count());
      scenes::instance_palette(scene, body, number, scratch, palette);
      frame.positions.push_back(posed(poses[body], palette));
    }
    methods::brute_force_collide(stage.triangles[0], frame.positions[0], stage.triangles[1],
                                 frame.positions[1], frame.exact, kAll);
  }
  stage.rest = stage.frames[0].positions;
  return stage;
}

/// All pairs by the exact predicate. The vertices of a limb have different rest positions, so each
/// is a surface vertex of its own.
Contacts all_pairs(const Shape& shape, const Positions& positions) {
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
Stage make_self() {
  Stage stage = {all_self_peers(), make_self_peer, 0.5, 0};
  const Shape limb = test::make_limb(30, 9, 6);
  stage.triangles = {limb.triangles};
  stage.rest = {limb.rest_positions};
  test::Random random(1790);
  Pose pose(*build_model(limb.view()));
  for (int i = 0; i < 12; ++i) {
    Frame& frame = stage.frames.emplace_back();
    frame.positions = {posed(pose, test::bend_limb(random, 6, random.uniform(0.5, 1.6), {}))};
    frame.exact = all_pairs(limb, frame.positions[0]);
  }
  return stage;
}

class Peers : public testing::TestWithParam<bool> {
 protected:
  const Stage& stage() const {
    static const Stage pairs = make_pairs(), self = make_self();
    return GetParam() ? self : pairs;
  }

  /// Calls test(peer, method) for each peer.
  template <typename Test>
  void for_each(const Test& test) const {
    for (const Peer& peer : stage().peers) {
      SCOPED_TRACE(peer.name);
      const auto method = stage().method_of(peer);
      test(peer, *method);
    }
  }
};

TEST_P(Peers, AreQueriedInContact) {
  std::size_t touching = 0, contacts = 0;
  for (const Frame& frame : stage().frames) {
    touching += !frame.exact.empty();
    contacts += frame.exact.size();
  }
  std::printf("%zu of %zu frames touch, %zu contacts\n", touching, stage().frames.size(), contacts);
  EXPECT_GT(touching, stage().frames.size() / 3);
  EXPECT_GT(contacts, 500u);
  if (!GetParam()) {
    EXPECT_LT(touching, stage().frames.size()) << "and apart";
  }
}

TEST_P(Peers, AnswerAsTheyAreSaidTo) {
  for_each([&](const Peer& peer, rivals::PosedMeshMethod& method) {
    Difference sum;
    std::size_t exact = 0;
    for (const Frame& frame : stage().frames) {
      sum += compare(stage().ask(method, frame), frame.exact);
      exact += frame.exact.size();
    }
    std::printf("%-16s %s %zu exact, %zu missing, %zu extra\n", std::string(peer.name).c_str(),
                peer.version.c_str(), exact, sum.missing, sum.extra);
    EXPECT_EQ(sum.repeated, 0u);
    const auto share_of_all = [&](std::size_t count) {
      return static_cast<double>(count) / static_cast<double>(exact);
    };
    switch (peer.answers) {
      case Answers::exact:
        EXPECT_EQ(sum.missing + sum.extra, 0u);
        break;
      case Answers::more:
        EXPECT_EQ(sum.missing, 0u);
        EXPECT_GT(sum.extra, 0u);
        EXPECT_LT(share_of_all(sum.extra), 2);
        break;
      case Answers::fewer:
        EXPECT_GT(sum.missing, 0u);
        EXPECT_LT(share_of_all(sum.missing), stage().most_missing);
        EXPECT_LE(share_of_all(sum.extra), stage().most_extra);
        break;
    }
  });
}

TEST_P(Peers, StopAtTheLimit) {
  for_each([&](const Peer&, rivals::PosedMeshMethod& method) {
    for (const Frame& frame : stage().frames) {
      Contacts all = stage().ask(method, frame);
      std::sort(all.begin(), all.end());
      for (const std::uint32_t limit : {0u, 1u, 2u}) {
        Contacts some = stage().ask(method, frame, limit);
        EXPECT_EQ(some.size(), std::min<std::size_t>(limit, all.size()));
        std::sort(some.begin(), some.end());
        EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
      }
    }
  });
}

TEST_P(Peers, SayWhenTheyWereCutShort) {
  const auto& frames = stage().frames;
  const Frame& frame = *std::max_element(
      frames.begin(), frames.end(),
      [](const Frame& a, const Frame& b) { return a.exact.size() < b.exact.size(); });
  for_each([&](const Peer&, rivals::PosedMeshMethod& method) {
    stage().ask(method, frame);
    Contacts contacts;
    EXPECT_TRUE(stage().collide(method, contacts, 1).cut_short);
    EXPECT_FALSE(stage().collide(method, contacts).cut_short);
  });
}

TEST_P(Peers, ForgetTheFrameBefore) {
  for_each([&](const Peer& peer, rivals::PosedMeshMethod& forward) {
    const auto backward = stage().method_of(peer);
    const auto& frames = stage().frames;
    std::vector<Contacts> answers;
    for (const Frame& frame : frames) answers.push_back(stage().ask(forward, frame));
    for (std::size_t i = frames.size(); i-- > 0;)
      EXPECT_EQ(compare(stage().ask(*backward, frames[i]), answers[i]), Difference{})
          << "frame " << i;
  });
}

TEST_P(Peers, AppendAndKeepWhatWasThere) {
  for_each([&](const Peer&, rivals::PosedMeshMethod& method) {
    stage().ask(method, stage().frames[6]);
    Contacts contacts = {{7, 7}}, alone;
    stage().collide(method, contacts);
    stage().collide(method, alone);
    EXPECT_EQ(contacts[0], (Contact{7, 7}));
    EXPECT_EQ(contacts.size(), alone.size() + 1);
  });
}

TEST_P(Peers, HaveNamesOfTheirOwn) {
  std::vector<std::string_view> names;
  for (const Peer& peer : stage().peers) {
    EXPECT_NE(stage().make(peer.name), nullptr);
    EXPECT_FALSE(peer.version.empty());
    names.push_back(peer.name);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  EXPECT_EQ(stage().make("pelt"), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Of, Peers, testing::Bool(),
                         [](const auto& is_self) { return is_self.param ? "Self" : "Pairs"; });

/// Two triangles that share two vertices, and a third that has collapsed and crosses them.
TEST(SelfPeersWithCollapsedTriangles, CgalLeavesThemOut) {
  const Positions positions = {{0, 0, 0}, {1, 0, 0},          {0, 1, 0},
                               {1, 1, 1}, {0.25f, 0.25f, -1}, {0.25f, 0.25f, 1}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {1, 3, 2}, {4, 5, 4}};
  for (const Peer& peer : all_self_peers()) {
    SCOPED_TRACE(peer.name);
    const auto method = make_self_peer(peer.name);
    method->add(triangles, positions);
    method->update(0, positions);
    Contacts contacts;
    method->collide(0, 0, contacts, kAll);
    const bool is_left_out = peer.narrow_phase == NarrowPhase::theirs;
    EXPECT_EQ(contacts, is_left_out ? Contacts{} : (Contacts{{0, 2}}));
  }
}

}  // namespace
}  // namespace pelt::peers
