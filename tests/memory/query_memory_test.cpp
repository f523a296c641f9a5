/// Allocation failures while models are built, posed and queried.

#include <pelt/pelt.hpp>

#include "support/failing_allocation.hpp"
#include "support/sanitizers.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <new>
#include <optional>
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
  std::printf("%zu allocations failed\n", failures);
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

/// Two poses for queries, with an answer to compare.
template <typename Answer>
class Question {
 public:
  using Ask = std::function<Answer(Pose& a, Pose& b, Scratch& scratch)>;

  Question(const Vec3& offset, Ask ask)
      : Question(offset, *build_model(limb().view()), std::move(ask)) {}

  Question(const Vec3& offset, const SkinnedModel& model, Ask ask)
      : model_(model), ask_(std::move(ask)) {
    Random random(7);
    palette_a_ = bend_limb(random, 3, 0.3, {0, 0, 0});
    palette_b_ = bend_limb(random, 3, 0.3, offset);
  }

  /// The poses and the scratch survive each failure, and are queried again at once and after a
  /// move.
  void check() const {
    const std::ptrdiff_t before = live_allocations();
    {
      Fresh fresh = make();
      const Answer expected = ask(fresh);
      std::size_t failures = 0;
      fresh = make();
      const auto repeat = [&] {
        ++failures;
        EXPECT_EQ(ask(fresh), expected);
        fresh = make();
      };
      fail_each_allocation([&] { EXPECT_EQ(ask(fresh), expected); }, repeat);
      EXPECT_GT(failures, 1u);
    }
    EXPECT_EQ(live_allocations(), before);
  }

 private:
  struct Fresh {
    Pose a, b;
    Scratch scratch;
  };

  Fresh make() const {
    Fresh fresh = {Pose(model_), Pose(model_), Scratch()};
    EXPECT_TRUE(fresh.a.set_palette(palette_a_));
    EXPECT_TRUE(fresh.b.set_palette(palette_b_));
    return fresh;
  }

  Answer ask(Fresh& fresh) const { return ask_(fresh.a, fresh.b, fresh.scratch); }

  SkinnedModel model_;
  std::vector<Matrix4> palette_a_, palette_b_;
  Ask ask_;
};

TEST(Memory, EndsWhilePosesCollide) {
  Question<std::vector<Contact>>({0.1f, 0.05f, 0}, [](Pose& a, Pose& b, Scratch& scratch) {
    std::vector<Contact> contacts;
    collide(a, b, scratch, contacts);
    EXPECT_GT(contacts.size(), 10u);
    return contacts;
  }).check();
}

TEST(Memory, EndsWhileAPoseCollidesWithItself) {
  const SkinnedModel model = *build_model(limb().view());
  const std::vector<std::uint16_t> parents = {kNoJoint, 0, 1};
  const std::vector<Contact> pairs = {{0, 1}, {5, 3}};
  fail_and_leak_nothing([&] {
    EXPECT_TRUE(build_self_filter(
        model, {.rings = 2, .at_rest = pairs, .always = pairs, .joint_parents = parents}));
  });
  const SelfFilter filter = *build_self_filter(model),
                   left_out = *build_self_filter(model, {.rings = 1});
  Question<std::vector<Contact>>({}, model, [&](Pose& a, Pose&, Scratch& scratch) {
    Matrix4 flat;
    flat.m[0] = 0;
    EXPECT_TRUE(a.set_palette(std::vector<Matrix4>(3, flat)));
    std::vector<Contact> contacts, others;
    self_collide(a, filter, scratch, contacts);
    self_collide(a, left_out, scratch, others);
    EXPECT_GT(others.size(), 10u);
    EXPECT_GT(contacts.size(), others.size());
    return contacts;
  }).check();
}

TEST(Memory, EndsWhileContactsAreTallied) {
  const std::vector<Contact> contacts = {{1, 2}, {3, 4}};
  fail_and_leak_nothing([&] {
    ContactTally tally;
    for (int pose = 0; pose < 3; ++pose) tally.add(contacts);
    EXPECT_EQ(tally.in_share_of_poses(1), contacts);
  });
}

TEST(Memory, EndsWhileDistancesAreMeasured) {
  Question<double>({2, 0.5f, 0}, [](Pose& a, Pose& b, Scratch& scratch) {
    Distance closest;
    distance(a, b, scratch, closest);
    EXPECT_GT(closest.distance, 0.5);
    return closest.distance;
  }).check();
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

TEST(Memory, EndsWhileNearPairsAreFound) {
  const FreshPose a({}), b({0.1f, 0.05f, 0});
  fail_and_append_nothing(std::tuple(std::vector<Contact>(1)), [&](auto& lists) {
    Pose pose_a = a.make(), pose_b = b.make();
    Scratch scratch;
    clearance(pose_a, pose_b, 0.01, scratch, std::get<0>(lists));
  });
}

TEST(Memory, EndsWhileAFieldIsMadeOrHit) {
  const std::vector<float> heights(9 * 9, 0.3f);
  const HeightGrid grid = {.heights = heights, .columns = 9, .rows = 9, .origin = {-4, 0, -4}};
  fail_and_leak_nothing([&] { EXPECT_TRUE(build_height_field(grid)); });
  const HeightField field = *build_height_field(grid);
  const FreshPose limb({});
  fail_and_append_nothing(std::tuple(std::vector<Contact>(1)), [&](auto& lists) {
    Pose pose = limb.make();
    Scratch scratch;
    collide(pose, field, scratch, std::get<0>(lists));
  });
}

TEST(Memory, EndsWhileASolidOrAGroupIsMeasured) {
  fail_and_leak_nothing([&] {
    const VertexGroups groups = group_by_joint(FreshPose::model());
    const FreshPose limb({});
    Pose pose = limb.make();
    Box box;
    exact_group_bounds(pose, groups, 1, box);
    EXPECT_LT(box.low.y, box.high.y);
  });
  Question<double>({2, 0.5f, 0}, [](Pose& a, Pose&, Scratch& scratch) {
    SolidDistance closest;
    distance(a, Sphere{{0, 0, 5}, 1}, scratch, closest);
    EXPECT_GT(closest.distance, 1);
    return closest.distance;
  }).check();
}

TEST(Memory, EndsWhileContactsAreDescribed) {
  const SkinnedModel model = *build_model(limb().view());
  EXPECT_TRUE(model.surface().is_closed());
  Pose a(model), b(model);
  Random random(7);
  ASSERT_TRUE(a.set_palette(bend_limb(random, 3, 0.3, {0, 0, 0})));
  ASSERT_TRUE(b.set_palette(bend_limb(random, 3, 0.3, {0.1f, 0.05f, 0})));
  Scratch scratch;
  std::vector<Contact> contacts;
  collide(a, b, scratch, contacts);
  ContactGeometry expected;
  describe_contacts(a, b, contacts, scratch, expected);
  ASSERT_GT(expected.curves.size(), 0u);
  fail_and_leak_nothing([&] {
    ContactGeometry geometry;
    describe_contacts(a, b, contacts, scratch, geometry);
    EXPECT_EQ(geometry.members, expected.members);
  });
}

TEST(Memory, EndsWhereTheBytesToReserveExceedAnAddress) {
  if (kHasSanitizer) GTEST_SKIP() << "sanitizers abort";
  Scratch scratch;
  for (const std::size_t contacts : {SIZE_MAX / 4, SIZE_MAX / 8 + 1, SIZE_MAX})
    EXPECT_THROW(scratch.reserve(contacts), std::bad_alloc) << contacts;
}

TEST(Memory, EndsWhileVerticesAreInside) {
  const SkinnedModel model = *build_model(limb().view());
  EXPECT_TRUE(model.surface().is_closed());
  Random random(7);
  const std::vector<Matrix4> palette_a = bend_limb(random, 3, 0.3, {0, 0, 0});
  const std::vector<Matrix4> palette_b = bend_limb(random, 3, 0.3, {0.1f, 0.05f, 0});
  std::optional<std::uint32_t> expected;
  fail_and_leak_nothing([&] {
    Pose a(model), b(model);
    ASSERT_TRUE(a.set_palette(palette_a));
    ASSERT_TRUE(b.set_palette(palette_b));
    Scratch scratch;
    Penetration deepest;
    deepest_vertex(a, b, scratch, deepest);
    if (!expected) expected = deepest.vertex;
    EXPECT_EQ(deepest.vertex, *expected);
    EXPECT_NE(deepest.vertex, kNoVertex);
  });
}

}  // namespace
}  // namespace pelt::test
