/// Every peer does the work that it is measured for: it finds contacts, with the quality that
/// `Peer::answers` states.

#include "evaluation/peers/peers.hpp"

#include "evaluation/peers/peer_figures.hpp"
#include "scenes/creature.hpp"
#include "scenes/scene.hpp"
#include "tools/pelt/methods/brute_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::peers {
namespace {

using Contacts = std::vector<Contact>;
using Positions = std::vector<Vec3>;

constexpr std::uint32_t kFrames = 12;

/// A dwarf and a man that walk through each other, away from the origin, and end apart.
scenes::Scene two_walkers() {
  scenes::Scene scene;
  scene.frame_count = kFrames;
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

struct Frame {
  Positions positions[2];
  Contacts exact;
};

/// The queries of the peers and the answers of brute force.
class Peers : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const scenes::Scene scene = two_walkers();
    std::vector<Pose> poses;
    for (std::uint32_t body = 0; body < 2; ++body) {
      auto model = build_model(scene.characters[body].asset.mesh());
      ASSERT_TRUE(model);
      const std::span<const Triangle> triangles = scene.characters[body].asset.mesh().triangles;
      triangles_[body].assign(triangles.begin(), triangles.end());
      poses.emplace_back(*model);
    }
    asset::SampleScratch scratch;
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
      frames_.emplace_back();
      for (std::uint32_t body = 0; body < 2; ++body)
        pose(scene, frame, body, scratch, poses[body], frames_.back().positions[body]);
      methods::brute_force_collide(triangles_[0], frames_.back().positions[0], triangles_[1],
                                   frames_.back().positions[1], frames_.back().exact, kAll);
    }
  }

  static void TearDownTestSuite() { frames_.clear(); }

  static void pose(const scenes::Scene& scene, std::uint32_t frame, std::uint32_t body,
                   asset::SampleScratch& scratch, Pose& pose, Positions& positions) {
    std::vector<Matrix4> palette(pose.model().joint_count());
    scenes::instance_palette(scene, body, frame, scratch, palette);
    ASSERT_TRUE(pose.set_palette(palette));
    positions.resize(pose.model().vertex_count());
    posed_vertices(pose, positions);
  }

  /// A peer with the two bodies of the first frame.
  static std::unique_ptr<rivals::PosedMeshMethod> method_of(const Peer& peer) {
    auto method = make_peer(peer.name);
    for (std::uint32_t body = 0; body < 2; ++body)
      method->add(triangles_[body], frames_[0].positions[body]);
    return method;
  }

  static Contacts ask(rivals::PosedMeshMethod& method, const Frame& frame,
                      std::uint32_t max_contacts = kAll) {
    for (std::uint32_t body = 0; body < 2; ++body) method.update(body, frame.positions[body]);
    Contacts contacts;
    method.collide(0, 1, contacts, max_contacts);
    return contacts;
  }

  static constexpr std::uint32_t kAll = Limits().max_contacts;
  static inline std::vector<Triangle> triangles_[2];
  static inline std::vector<Frame> frames_;
};

TEST_F(Peers, AreQueriedInContactAndApart) {
  std::size_t touching = 0, contacts = 0;
  for (const Frame& frame : frames_) {
    touching += !frame.exact.empty();
    contacts += frame.exact.size();
  }
  std::printf("%zu of %zu frames touch, %zu contacts\n", touching, frames_.size(), contacts);
  EXPECT_GT(touching, kFrames / 3);
  EXPECT_LT(touching, kFrames);
  EXPECT_GT(contacts, 500u);
}

TEST_F(Peers, AnswerAsTheyAreSaidTo) {
  for (const Peer& peer : all_peers()) {
    SCOPED_TRACE(peer.name);
    const auto method = method_of(peer);
    Difference sum;
    std::size_t exact = 0;
    for (const Frame& frame : frames_) {
      sum += compare(ask(*method, frame), frame.exact);
      exact += frame.exact.size();
    }
    std::printf("%-12s %s %-8s %zu exact, %zu missing, %zu extra\n", std::string(peer.name).c_str(),
                peer.version.c_str(), std::string(name_of(peer.answers)).c_str(), exact,
                sum.missing, sum.extra);
    EXPECT_EQ(sum.repeated, 0u);
    switch (peer.answers) {
      case Answers::exact:
        EXPECT_EQ(sum.missing + sum.extra, 0u);
        break;
      case Answers::nearly:
        EXPECT_LT(sum.missing + sum.extra, exact / 50);
        break;
      case Answers::more:
        EXPECT_EQ(sum.missing, 0u);
        EXPECT_GT(sum.extra, 0u);
        EXPECT_LT(sum.extra, 2 * exact);
        break;
      case Answers::fewer:
        EXPECT_GT(sum.missing, 0u);
        EXPECT_LT(sum.missing, exact / 10);
        EXPECT_LT(sum.extra, exact / 50);
        break;
    }
  }
}

TEST_F(Peers, StopAtTheLimit) {
  for (const Peer& peer : all_peers()) {
    SCOPED_TRACE(peer.name);
    const auto method = method_of(peer);
    for (const Frame& frame : frames_) {
      Contacts all = ask(*method, frame);
      std::sort(all.begin(), all.end());
      for (const std::uint32_t limit : {0u, 1u, 2u}) {
        Contacts some = ask(*method, frame, limit);
        EXPECT_EQ(some.size(), std::min<std::size_t>(limit, all.size()));
        std::sort(some.begin(), some.end());
        EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
      }
    }
  }
}

TEST_F(Peers, SayWhenTheyWereCutShort) {
  for (const Peer& peer : all_peers()) {
    SCOPED_TRACE(peer.name);
    const auto method = method_of(peer);
    const Frame& frame = *std::max_element(
        frames_.begin(), frames_.end(),
        [](const Frame& a, const Frame& b) { return a.exact.size() < b.exact.size(); });
    ask(*method, frame);
    Contacts contacts;
    EXPECT_TRUE(method->collide(0, 1, contacts, 1).cut_short);
    EXPECT_FALSE(method->collide(0, 1, contacts, kAll).cut_short);
  }
}

TEST_F(Peers, ForgetTheFrameBefore) {
  for (const Peer& peer : all_peers()) {
    SCOPED_TRACE(peer.name);
    const auto forward = method_of(peer), backward = method_of(peer);
    std::vector<Contacts> answers;
    for (const Frame& frame : frames_) answers.push_back(ask(*forward, frame));
    for (std::size_t i = frames_.size(); i-- > 0;)
      EXPECT_EQ(compare(ask(*backward, frames_[i]), answers[i]), Difference{}) << "frame " << i;
  }
}

TEST_F(Peers, AppendAndKeepWhatWasThere) {
  for (const Peer& peer : all_peers()) {
    SCOPED_TRACE(peer.name);
    const auto method = method_of(peer);
    ask(*method, frames_[kFrames / 2]);
    Contacts contacts = {{7, 7}}, alone;
    method->collide(0, 1, contacts, kAll);
    method->collide(0, 1, alone, kAll);
    EXPECT_EQ(contacts[0], (Contact{7, 7}));
    EXPECT_EQ(contacts.size(), alone.size() + 1);
  }
}

TEST(PeerNames, AreDistinctAndKnown) {
  std::vector<std::string_view> names;
  for (const Peer& peer : all_peers()) {
    EXPECT_NE(make_peer(peer.name), nullptr);
    EXPECT_FALSE(peer.version.empty());
    names.push_back(peer.name);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  EXPECT_EQ(make_peer("pelt"), nullptr);
}

}  // namespace
}  // namespace pelt::peers
