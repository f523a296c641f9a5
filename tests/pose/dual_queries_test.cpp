/// Every query of poses with dual quaternion skinning answers as if the posed vertices were given,
/// so that no answer depends on the bounds.

#include "pose/dual_bodies.hpp"
#include "pose/every_query.hpp"
#include "support/instruction_sets.hpp"

#include <map>

namespace pelt {
namespace {

using test::DualBody;
using test::Random;
using test::Stage;
using test::Turns;

/// Two bodies, whose poses the stage takes.
struct DualStage {
  DualStage(Random& random, const test::DualKind& kind)
      : a(random, kind, 80), b(random, kind, 60), stage(make(random)) {}

  Stage make(Random& random) {
    a.move(random, 0.15);
    b.move(random, 0.15);
    return {std::move(a.from), std::move(a.to), std::move(b.from), std::move(b.to)};
  }

  DualBody a, b;
  Stage stage;
};

Pose given(const Pose& pose) {
  std::vector<Vec3> posed(pose.model().vertex_count());
  posed_vertices(pose, posed);
  Pose same(pose.model());
  EXPECT_TRUE(same.set_vertices(posed));
  return same;
}

Stage given(const Stage& stage) {
  return {given(stage.a_from), given(stage.a), given(stage.b_from), given(stage.b)};
}

void close_all_nodes(Stage& stage) {
  for (Pose* pose : {&stage.a_from, &stage.a, &stage.b_from, &stage.b}) pose->reserve();
}

using Counts = std::map<std::string, std::uint64_t>;

void expect_same_answers(DualStage& bodies, Counts& found) {
  Scratch scratch;
  Stage vertices = given(bodies.stage);
  const test::Answers expected = test::ask_every_query(vertices, scratch);
  test::on_each_instruction_set([&](InstructionSet) {
    close_all_nodes(bodies.stage);
    const test::Answers answers = test::ask_every_query(bodies.stage, scratch);
    for (const auto& [query, hash] : expected.hashes)
      EXPECT_EQ(answers.hashes.at(query), hash) << query;
    EXPECT_EQ(check_bounds(bodies.stage.a), "");
    EXPECT_EQ(check_bounds(bodies.stage.b_from), "");
  });
  for (const auto& [query, count] : expected.found) found[query] += count;
}

class DualQueries : public testing::TestWithParam<Turns> {};

TEST_P(DualQueries, AnswerAsIfVerticesWereGiven) {
  Random random(140 + static_cast<std::uint64_t>(GetParam()));
  Counts found;
  for (const test::DualKind& kind : test::dual_kinds(GetParam())) {
    SCOPED_TRACE(kind.influences);
    DualStage bodies(random, kind);
    expect_same_answers(bodies, found);
  }
  for (const auto& [query, count] : found) {
    std::printf("%s: %llu\n", query.c_str(), static_cast<unsigned long long>(count));
    if (GetParam() == Turns::far_away) continue;  // from the fixed points, rays and regions
    EXPECT_GT(count, 0u) << query;
  }
  EXPECT_GT(found["collide"], 100u);
  EXPECT_GT(found["self"], 100u);
  EXPECT_GT(found["motion"], 1000u);
}

std::string name_of(const testing::TestParamInfo<Turns>& turns) {
  constexpr const char* kNames[] = {"Small", "Large", "Any", "Antipodal", "FarAway"};
  return kNames[static_cast<std::size_t>(turns.param)];
}

INSTANTIATE_TEST_SUITE_P(All, DualQueries, testing::ValuesIn(test::kAllTurns), name_of);

}  // namespace
}  // namespace pelt
