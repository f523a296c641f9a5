/// Allocation failures while models and operands are made, in queries with several lists, and in
/// each row of the table in support/contract.

#include <pelt/pelt.hpp>

#include "support/contract/query.hpp"
#include "support/failing_allocation.hpp"
#include "support/sanitizers.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <new>
#include <tuple>
#include <utility>
#include <vector>

namespace pelt::test {
namespace {

/// Runs an operation that leaves nothing allocated, failing each of its allocations.
void fail_and_leak_nothing(const std::function<void()>& operation) {
  operation();  // allocates what is never freed
  const std::ptrdiff_t before = live_allocations();
  const std::size_t failures =
      fail_each_allocation(operation, [&] { EXPECT_EQ(live_allocations(), before); });
  EXPECT_EQ(live_allocations(), before);
  EXPECT_GE(failures, 1u);
}

const Shape& limb() {
  static const Shape shape = make_morphing_limb(10, 6, 3);
  return shape;
}

TEST(Memory, EndsWhileAModelIsBuilt) {
  fail_and_leak_nothing([] {
    const Result<SkinnedModel> model = build_model(limb().view());
    EXPECT_TRUE(model);
  });
}

TEST(Memory, EndsWhileAModelIsSavedOrLoaded) {
  const SkinnedModel model = *build_model(limb().view());
  const std::vector<std::byte> saved = save_model(model);
  fail_and_leak_nothing([&] { EXPECT_EQ(save_model(model), saved); });
  fail_and_leak_nothing([&] { EXPECT_TRUE(load_model(saved)); });
}

TEST(Memory, EndsWhileAPoseIsMade) {
  const SkinnedModel model = *build_model(limb().view());
  fail_and_leak_nothing([&] {
    Pose pose(model);
    pose.reserve();
  });
}

TEST(Memory, EndsWhileTheSurfaceOfAModelIsMade) {
  const std::vector<std::byte> saved = save_model(*build_model(limb().view()));
  fail_and_leak_nothing([&] { EXPECT_TRUE(load_model(saved)->surface().is_closed()); });
}

TEST(Memory, EndsWhileAFilterGroupsOrAFieldAreMade) {
  const SkinnedModel model = *build_model(limb().view());
  const std::vector<std::uint16_t> parents = {kNoJoint, 0, 1};
  const std::vector<Contact> pairs = {{0, 1}, {5, 3}};
  fail_and_leak_nothing([&] {
    EXPECT_TRUE(build_self_filter(
        model, {.rings = 2, .at_rest = pairs, .always = pairs, .joint_parents = parents}));
  });
  fail_and_leak_nothing([&] { EXPECT_GT(group_by_joint(model).count(), 1u); });
  const std::vector<float> heights(9 * 9, 0.3f);
  const HeightGrid grid = {.heights = heights, .columns = 9, .rows = 9, .origin = {-4, 0, -4}};
  fail_and_leak_nothing([&] { EXPECT_TRUE(build_height_field(grid)); });
}

TEST(Memory, EndsWhileContactsAreTallied) {
  const std::vector<Contact> contacts = {{1, 2}, {3, 4}};
  fail_and_leak_nothing([&] {
    ContactTally tally;
    for (int pose = 0; pose < 3; ++pose) tally.add(contacts);
    EXPECT_EQ(tally.in_share_of_poses(1), contacts);
  });
}

/// Appends to lists that already have elements, failing each allocation. A failed query must leave
/// the lists as they were.
template <typename Lists, typename Append>
void fail_and_append_nothing(const Lists& before, const Append& append) {
  Lists expected = before;
  append(expected);
  ASSERT_NE(expected, before);
  Lists lists = before;
  const auto fresh = [&] {
    lists = before;
    std::apply([](auto&... list) { (list.shrink_to_fit(), ...); }, lists);
  };
  fresh();
  const std::size_t failures = fail_each_allocation(
      [&] {
        fresh();
        append(lists);
        EXPECT_EQ(lists, expected);
      },
      [&] { EXPECT_EQ(lists, before); });
  EXPECT_GT(failures, std::tuple_size_v<Lists>);
}

/// The posed limb of a query, made anew for each attempt.
class FreshPose {
 public:
  explicit FreshPose(const Vec3& offset) {
    Random random(7);
    palette_ = bend_limb(random, 3, 0.3, offset);
  }

  Pose make() const {
    Pose pose(model());
    EXPECT_TRUE(pose.set_palette(palette_));
    return pose;
  }

  static const SkinnedModel& model() {
    static const SkinnedModel model = *build_model(limb().view());
    return model;
  }

 private:
  std::vector<Matrix4> palette_;
};

TEST(Memory, EndsWhileTrianglesOfARegionAreFound) {
  using Triangles = std::vector<std::uint32_t>;
  const FreshPose limb({});
  const Region region = Box{{-5, -5, -5}, {5, 0.5f, 5}};
  fail_and_append_nothing(std::tuple(Triangles{7}, Triangles{8}), [&](auto& lists) {
    Pose pose = limb.make();
    Scratch scratch;
    TrianglesInRegion triangles = {std::move(std::get<0>(lists)), std::move(std::get<1>(lists))};
    const auto give_back = [&] {
      std::get<0>(lists) = std::move(triangles.intersecting);
      std::get<1>(lists) = std::move(triangles.inside);
    };
    try {
      find_triangles(pose, region, scratch, triangles);
    } catch (...) {
      give_back();
      throw;
    }
    give_back();
  });
  fail_and_append_nothing(std::tuple(Triangles{7}), [&](auto& lists) {
    Pose pose = limb.make();
    Scratch scratch;
    collide(pose, region, scratch, std::get<0>(lists));
  });
}

TEST(Memory, EndsWhileRaysAreCast) {
  const FreshPose limb({});
  const Ray ray = {.origin = {0.01f, -5, 0.02f}, .direction = {0, 1, 0}};
  fail_and_append_nothing(std::tuple(std::vector<RayHit>(1)), [&](auto& lists) {
    Pose pose = limb.make();
    Scratch scratch;
    cast_all(pose, ray, scratch, std::get<0>(lists));
  });
  Pose pose = limb.make();
  RayHit hit;
  cast(pose, {.origin = {-5, 0.5f, 0.02f}, .direction = {1, 0, 0}}, hit);
  ASSERT_TRUE(hit);
  std::vector<JointShare> shares;
  influences_at(FreshPose::model(), hit, shares);
  EXPECT_GT(shares.size(), 1u);
  fail_and_append_nothing(std::tuple(std::vector<JointShare>{{9, 0.5f}}), [&](auto& lists) {
    const Pose allocates(FreshPose::model());  // so that several attempts fail
    influences_at(FreshPose::model(), hit, std::get<0>(lists));
  });
}

TEST(Memory, EndsWhereTheBytesToReserveExceedAnAddress) {
  if (kHasSanitizer) GTEST_SKIP() << "sanitizers abort";
  Scratch scratch;
  for (const std::size_t contacts : {SIZE_MAX / 4, SIZE_MAX / 8 + 1, SIZE_MAX})
    EXPECT_THROW(scratch.reserve(contacts), std::bad_alloc) << contacts;
}

}  // namespace
}  // namespace pelt::test

// Allocation failures in each row of the table of queries in support/contract.
namespace pelt::contract {
namespace {

class EachQueryInMemory : public testing::TestWithParam<std::size_t> {};

/// The poses and the scratch survive each failure, and are queried again. A failed query leaves its
/// list as it was. Uses the first kind of bodies that gives the query a result.
TEST_P(EachQueryInMemory, EndsAndAnswersAsBeforeWhenMemoryIsBack) {
  Query& query = *queries()[GetParam()];
  // Crowds append as they go, and this row asks for one ray after the other.
  const bool appends_at_once =
      query.is_list() && !query.traits.has_threads && query.name != "CastAll";
  Random random(12000);
  std::size_t failures = 0;
  for (const Kind& kind : kinds()) {
    Stage stage(random, kind, 0.1);
    if (!query.preparation.applies(stage)) continue;
    query.preparation.arrange(stage);
    const auto renew = [&] {
      stage.close(false);
      query.preparation.make(stage);
    };
    const auto ask = [&] {
      query.reserve(0);
      query.ask(stage);
    };
    renew();
    ask();
    if (query.hits() == 0) continue;
    const Numbers answer = query.numbers();
    renew();
    failures = test::fail_each_allocation(ask, [&] {
      if (appends_at_once) {
        EXPECT_EQ(query.hits(), 0u);
      }
      ask();
      EXPECT_EQ(query.numbers(), answer);
      renew();
    });
    EXPECT_EQ(query.numbers(), answer);
    break;
  }
  query.forget();
  // These two allocate when they are prepared, and not when they are asked.
  if (query.name != "FirstContactSearch" && query.name != "GroupBounds") {
    EXPECT_GT(failures, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Queries, EachQueryInMemory,
                         testing::Range(std::size_t{0}, queries().size()),
                         [](const auto& row) { return queries()[row.param]->name; });

}  // namespace
}  // namespace pelt::contract
