/// Poses with offsets: any offset is clamped to its cap, and boxes that are widened by the caps
/// enclose the result.

#include <pelt/pelt.hpp>

#include "pose/pose.hpp"
#include "skin/skin.hpp"
#include "support/allocation_count.hpp"
#include "support/brute_force.hpp"
#include "support/instruction_sets.hpp"
#include "support/random_offsets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace pelt {
namespace {

using test::Caps;
using test::Random;
using test::random_caps;
using test::random_offsets;
using test::Shape;

using Matrices = std::vector<Matrix4>;
using Points = std::vector<Vec3>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Result<SkinnedModel> build_capped(const Shape& shape, const Caps& caps,
                                  const ModelOptions& options = {}) {
  SkinnedMeshView view = shape.view();
  view.offset_caps = caps;
  return build_model(view, options);
}

Points posed(const Pose& pose) {
  Points points(pose.model().vertex_count());
  posed_vertices(pose, points);
  return points;
}

bool have_equal_bits(const Points& a, const Points& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

/// The definition, in its own words.
float moved(float v, float offset, float cap) {
  if (std::isnan(offset) || offset == 0 || cap == 0) return v;
  return v + std::min(std::max(offset, -cap), cap);
}

Points moved(const Points& points, const Points& offsets, const Caps& caps) {
  Points result;
  for (std::size_t v = 0; v < points.size(); ++v)
    result.push_back({moved(points[v].x, offsets[v].x, caps[v]),
                      moved(points[v].y, offsets[v].y, caps[v]),
                      moved(points[v].z, offsets[v].z, caps[v])});
  return result;
}

std::uint32_t count_clamped(const Points& offsets, const Caps& caps) {
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < offsets.size(); ++v) {
    bool is_clamped = false;
    for (const float o : {offsets[v].x, offsets[v].y, offsets[v].z})
      is_clamped |= std::isnan(o) || std::fabs(o) > caps[v];
    count += is_clamped;
  }
  return count;
}

/// Two bodies whose offsets live as long as they.
struct OffsetBodies {
  OffsetBodies(Random& random, bool is_soup)
      : shape(is_soup ? test::make_soup(random, 40, 5, 4, test::Weights::adversarial)
                      : test::make_morphing_limb(20, 10, 5)),
        caps(random_caps(random, shape.rest_positions.size(), is_soup ? 0.2 : 0.02)),
        model(*build_capped(shape, caps)),
        offsets{random_offsets(random, caps), random_offsets(random, caps)},
        a(model),
        b(model) {
    for (Pose* pose : {&a, &b})
      EXPECT_TRUE(pose->set_palette(is_soup
                                        ? test::make_palette(random, 5, test::Motion::affine, 0.5)
                                        : test::bend_limb(random, 5, 0.5, random.point(0.15))));
    EXPECT_TRUE(a.set_offsets(offsets[0]) && b.set_offsets(offsets[1]));
  }

  Shape shape;
  Caps caps;
  SkinnedModel model;
  std::array<Points, 2> offsets;
  Pose a, b;
};

TEST(SetOffsets, FindsTheContactsOfBruteForceAndCountsWhatItClamps) {
  Random random(131);
  std::size_t contacts = 0;
  std::uint64_t clamped = 0;
  for (int round = 0; round < 20; ++round) {
    OffsetBodies bodies(random, round % 2 == 0);
    Pose &a = bodies.a, &b = bodies.b;
    const std::vector<Contact> expected = test::brute_force(bodies.shape, a, bodies.shape, b);
    EXPECT_EQ(check_offsets(a), count_clamped(bodies.offsets[0], bodies.caps));
    QueryStats first;
    test::on_each_instruction_set([&](InstructionSet set) {
      ASSERT_TRUE(a.set_offsets(bodies.offsets[0]));
      ASSERT_TRUE(b.set_offsets(bodies.offsets[1]));
      Scratch scratch;
      std::vector<Contact> found;
      const QueryStats work = collide(a, b, scratch, found);
      EXPECT_EQ(found, expected);
      if (set == available_instruction_sets().front()) first = work;
      EXPECT_EQ(work.clamped_offsets, first.clamped_offsets);
      EXPECT_EQ(work.node_pairs, first.node_pairs);
    });
    contacts += expected.size();
    clamped += first.clamped_offsets;
  }
  EXPECT_GT(contacts, 500u);
  EXPECT_GT(clamped, 1000u);
}

TEST(SetOffsets, PosedVerticesHaveTheBitsOfTheDefinition) {
  Random random(132);
  for (int round = 0; round < 20; ++round) {
    OffsetBodies bodies(random, round % 2 == 0);
    Pose& pose = bodies.a;
    const Points with = posed(pose);
    const std::span<const Vec3> none = std::span(bodies.offsets[0]).first(0);  // not null
    ASSERT_TRUE(pose.set_offsets(none));
    const Points expected = moved(posed(pose), bodies.offsets[0], bodies.caps);
    test::on_each_instruction_set([&](InstructionSet) {
      ASSERT_TRUE(pose.set_offsets(bodies.offsets[0]));
      EXPECT_TRUE(have_equal_bits(posed(pose), expected));
    });
    EXPECT_TRUE(have_equal_bits(with, expected));
  }
}

TEST(SetOffsets, CapsOfZeroChangeNoBit) {
  Random random(133);
  const Shape shape = test::make_morphing_limb(20, 10, 5);
  const Caps none(shape.rest_positions.size(), 0.0f);
  Matrices palette = test::bend_limb(random, 5, 0.3, {});
  palette[0].m[0] = palette[0].m[4] = palette[0].m[8] = palette[0].m[12] = -0.0f;
  const Points offsets = random_offsets(random, Caps(none.size(), 1.0f));
  const SkinnedModel model = *build_model(shape.view());
  const SkinnedModel capped = *build_capped(shape, none);
  Pose plain(model), offset(capped);
  ASSERT_TRUE(plain.set_palette(palette) && offset.set_palette(palette));
  ASSERT_TRUE(offset.set_offsets(offsets));
  EXPECT_TRUE(have_equal_bits(posed(offset), posed(plain)));
}

TEST(SetOffsets, BoundsEncloseEveryOffsetWithinTheCaps) {
  Random random(134);
  for (int round = 0; round < 20; ++round) {
    OffsetBodies bodies(random, round % 2 == 0);
    Pose& pose = bodies.a;
    Points corners(bodies.caps.size());
    for (Vec3& corner : corners) {
      const auto end = [&] { return random.chance(0.5) ? kInfinity : -kInfinity; };
      corner = {end(), end(), end()};
    }
    ASSERT_TRUE(pose.set_offsets(corners));
    Bounds around;
    bounds(pose, around);
    const VertexGroups groups = group_by_joint(pose.model());
    for (std::uint32_t g = 0; g < groups.count(); ++g) {
      Box exact, bound;
      exact_group_bounds(pose, groups, g, exact);
      group_bounds(pose, groups, g, bound);
      EXPECT_LE(bound.low.x, exact.low.x);
      EXPECT_GE(bound.high.z, exact.high.z);
    }
    for (const Triangle& triangle : bodies.shape.triangles)
      for (const std::uint32_t v : triangle) {
        const Vec3 p = posed(pose)[v], c = around.sphere.centre;
        const double x = double{p.x} - double{c.x}, y = double{p.y} - double{c.y},
                     z = double{p.z} - double{c.z};
        ASSERT_LE(std::sqrt(x * x + y * y + z * z), double{around.sphere.radius});
        ASSERT_LE(around.box.low.y, p.y);
        ASSERT_GE(around.box.high.y, p.y);
        if (round > 2) break;
      }
    EXPECT_EQ(check_bounds(pose), "");
  }
}

TEST(SetOffsets, EndsGivenVerticesAndOutlivesPalettes) {
  Random random(135);
  OffsetBodies bodies(random, false);
  Pose& pose = bodies.a;
  const Points with = posed(pose);
  const Matrices palette(pose.detail().palette.joints().begin(),
                         pose.detail().palette.joints().end());
  ASSERT_TRUE(pose.set_vertices(Points(with.size())));
  EXPECT_EQ(posed(pose), Points(with.size()));
  ASSERT_TRUE(pose.set_offsets(bodies.offsets[0]));
  EXPECT_TRUE(have_equal_bits(posed(pose), with));
  ASSERT_TRUE(pose.set_palette(palette));
  EXPECT_TRUE(have_equal_bits(posed(pose), with));
  ASSERT_TRUE(pose.set_offsets({}));
  EXPECT_EQ(check_offsets(pose), 0u);
}

TEST(SetOffsets, RefusesAWrongNumberAndModelsWithoutCaps) {
  Random random(136);
  OffsetBodies bodies(random, false);
  Pose& pose = bodies.a;
  const Points with = posed(pose);
  const Points few(3);
  EXPECT_EQ(pose.set_offsets(few).error().message,
            "offsets has 3 elements, expected none or one for each of the 200 vertices");
  EXPECT_TRUE(have_equal_bits(posed(pose), with));
  Pose plain(*build_model(bodies.shape.view()));
  EXPECT_EQ(plain.set_offsets(bodies.offsets[0]).error().message,
            "the model has no caps for offsets: set SkinnedMeshView::offset_caps");
  EXPECT_TRUE(plain.set_offsets({}));
}

TEST(SetOffsets, CapsAreFiniteAndNotNegative) {
  const Shape shape = test::make_limb(4, 4, 2);
  const auto refusal = [&](auto change) {
    Caps caps(shape.rest_positions.size(), 1.0f);
    change(caps);
    const Result<SkinnedModel> model = build_capped(shape, caps);
    return model ? "accepted" : model.error().message;
  };
  EXPECT_EQ(refusal([](Caps& c) { c[3] = -1; }), "offset_caps[3] is -1, expected 0 to 2^60");
  EXPECT_EQ(refusal([](Caps& c) { c[3] = kNan; }), "offset_caps[3] is nan, expected 0 to 2^60");
  EXPECT_EQ(refusal([](Caps& c) { c[0] = 0x1p61f; }),
            "offset_caps[0] is 2.30584e+18, expected 0 to 2^60");
  EXPECT_EQ(refusal([](Caps& c) { c.pop_back(); }),
            "offset_caps has 15 elements for 16 rest_positions");
  EXPECT_EQ(refusal([](Caps& c) { c[1] = 0x1p60f; }), "accepted");
}

TEST(SetOffsets, PreparedModelsKeepTheCaps) {
  Random random(137);
  OffsetBodies bodies(random, true);
  Pose& pose = bodies.a;
  Pose loaded(*load_model(save_model(bodies.model)));
  ASSERT_TRUE(loaded.set_palette(pose.detail().palette.joints()));
  ASSERT_TRUE(loaded.set_offsets(bodies.offsets[0]));
  EXPECT_TRUE(have_equal_bits(posed(loaded), posed(pose)));
  EXPECT_EQ(check_bounds(loaded), "");
  EXPECT_EQ(save_model(loaded.model()), save_model(bodies.model));
}

TEST(SetOffsets, EqualVerticesWithCapsMayPart) {
  Shape shape;
  shape.influences_per_vertex = 1;
  shape.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  shape.triangles = {{0, 1, 2}, {3, 4, 5}};
  shape.joints.resize(6, 0);
  shape.weights.resize(6, 1);
  Pose pose(*build_capped(shape, {0, 0.5f, 0, 0.5f, 0, 0}));
  Points offsets(6);
  offsets[3] = {0, 0, 0.25f};
  ASSERT_TRUE(pose.set_offsets(offsets));
  const Points expected = moved(shape.rest_positions, offsets, {0, 0.5f, 0, 0.5f, 0, 0});
  EXPECT_EQ(posed(pose), expected);
  Pose other(pose.model());
  Scratch scratch;
  EXPECT_EQ(test::contacts_of(pose, other, scratch), test::brute_force(shape, pose, shape, other));
}

TEST(SetOffsets, HugeOffsetsAreExact) {
  Random random(139);
  Scratch scratch;
  const Shape shape = test::make_soup(random, 60, 3, 2, test::Weights::random);
  const Caps caps(shape.rest_positions.size(), 0x1p60f);
  const SkinnedModel model = *build_capped(shape, caps);
  Matrices huge(3);
  for (Matrix4& joint : huge) joint.m[0] = joint.m[5] = joint.m[10] = 0x1p57f;
  std::size_t contacts = 0;
  for (int round = 0; round < 5; ++round) {
    Points offsets[2];
    for (Points& points : offsets)
      for (std::size_t v = 0; v < caps.size(); ++v) {
        const auto step = [&] { return 0x1p61f * (static_cast<float>(random.index(3)) - 1); };
        const float x = step(), y = step(), z = step();
        points.push_back({x, y, z});
      }
    Pose a(model), b(model);
    ASSERT_TRUE(a.set_palette(huge) && b.set_palette(huge));
    ASSERT_TRUE(a.set_offsets(offsets[0]) && b.set_offsets(offsets[1]));
    const std::vector<Contact> found = test::contacts_of(a, b, scratch);
    EXPECT_EQ(found, test::brute_force(shape, a, shape, b));
    Distance nearest;
    distance(a, b, scratch, nearest);
    EXPECT_TRUE(std::isfinite(nearest.distance));
    contacts += found.size();
  }
  EXPECT_GT(contacts, 100u);
}

TEST(SetOffsets, OpensOnlyWhatAQueryNeeds) {
  Random random(138);
  const Shape shape = test::make_limb(200, 24, 5);
  const SkinnedModel model = *build_capped(shape, Caps(shape.rest_positions.size(), 0.01f));
  const Points offsets = random_offsets(random, Caps(shape.rest_positions.size(), 0.01f));
  Pose a(model), b(model);
  a.reserve(), b.reserve();
  Scratch scratch;
  scratch.reserve(1 << 12);
  std::vector<Contact> contacts;
  contacts.reserve(1 << 12);
  ASSERT_TRUE(b.set_palette(test::bend_limb(random, 5, 0, {0, 1.05f, 0})));
  const std::size_t before = test::allocation_count();
  ASSERT_TRUE(a.set_offsets(offsets));
  ASSERT_TRUE(b.set_offsets(offsets));
  const QueryStats work = collide(a, b, scratch, contacts);
  EXPECT_EQ(test::allocation_count(), before);
  EXPECT_LT(work.posed_vertices, shape.rest_positions.size() / 2);
}

}  // namespace
}  // namespace pelt
