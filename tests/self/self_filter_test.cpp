#include <pelt/self.hpp>
#include <pelt/self_filter.hpp>

#include "self/filter_definition.hpp"
#include "self/self_brute_force.hpp"
#include "self/surface_shapes.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace pelt::test {
namespace {

using Counts = std::array<std::uint64_t, 7>;

Counts counts_of(const LeftOut& left_out) {
  return {0,
          left_out.takes_part,
          left_out.rings,
          left_out.at_rest,
          left_out.always,
          left_out.joints,
          left_out.groups};
}

/// Shapes that intersect themselves, with their poses.
struct Body {
  Body(const Shape& s, const std::vector<Matrix4>& palette)
      : shape(s), pose(*build_model(s.view())), contacts(self_contacts(palette)) {}

  std::vector<Contact> self_contacts(const std::vector<Matrix4>& palette) {
    EXPECT_TRUE(pose.set_palette(palette));
    return brute_force_self(shape, pose);
  }

  Shape shape;
  Pose pose;
  std::vector<Contact> contacts;
};

Body folded_limb(Random& random) {
  return {make_limb(24, 8, 6), bend_limb(random, 6, random.uniform(0.8, 1.6), {})};
}

Body soup(Random& random) {
  return {make_soup(random, 150, 6, 4, Weights::random),
          make_palette(random, 6, Motion::affine, 0.3)};
}

Body grid_soup(Random& random) {
  return {make_grid_soup(random, 100, 4, 6), make_palette(random, 6, Motion::rigid, 0.3)};
}

constexpr Body (*kBodies[])(Random&) = {folded_limb, soup, grid_soup};

/// Checks `left_out_by` for all pairs, and what `self_collide` leaves out. Returns the number of
/// contacts by the filter that leaves them out.
Counts expect_filtered(Body& body, const Options& options) {
  const SelfFilter filter = *build_self_filter(body.pose.model(), options.view());
  Classification expected(body.shape, options);
  const auto count = static_cast<std::uint32_t>(body.shape.triangles.size());
  for (std::uint32_t s = 0; s < count; ++s)
    for (std::uint32_t t = s + 1; t < count; ++t) {
      const LeftOutBy by = expected.by(s, t);
      EXPECT_EQ(filter.left_out_by(s, t), by);
      EXPECT_EQ(filter.left_out_by(t, s), by);
    }
  std::vector<Contact> kept, found;
  Counts left_out{};
  for (const Contact& contact : body.contacts) {
    const LeftOutBy by = expected.by(contact.triangle_a, contact.triangle_b);
    if (by == LeftOutBy::none)
      kept.push_back(contact);
    else
      ++left_out[static_cast<std::size_t>(by)];
  }
  Scratch scratch;
  const SelfStats stats = self_collide(body.pose, filter, scratch, found);
  EXPECT_EQ(found, kept);
  EXPECT_EQ(counts_of(stats.left_out), left_out);
  EXPECT_EQ(stats.left_out.total(), body.contacts.size() - kept.size());
  EXPECT_EQ(self_intersects(body.pose, filter, scratch).answer, !kept.empty());
  left_out[0] = kept.size();
  return left_out;
}

/// Draws each option.
struct Draw {
  Random& random;
  const Body& body;

  std::uint32_t triangles() const {
    return static_cast<std::uint32_t>(body.shape.triangles.size());
  }

  std::uint16_t joint() const {
    return static_cast<std::uint16_t>(random.index(body.shape.joint_count));
  }

  void takes_part(Options& options) const {
    for (std::uint32_t t = 0; t < triangles(); ++t)
      options.takes_part.push_back(random.chance(0.8) ? static_cast<std::uint8_t>(1 + t % 255) : 0);
  }

  void rings(Options& options) const { options.rings = 1 + random.index(5); }

  /// Contacts and other pairs, in any order, some twice and in both directions.
  std::vector<Contact> pairs() const {
    std::vector<Contact> listed;
    for (int i = 0; i < 40; ++i) {
      Contact pair = {random.index(triangles()), random.index(triangles())};
      if (!body.contacts.empty() && random.chance(0.8))
        pair = body.contacts[random.index(static_cast<std::uint32_t>(body.contacts.size()))];
      if (random.chance(0.5)) std::swap(pair.triangle_a, pair.triangle_b);
      listed.insert(listed.end(), 1 + random.index(2), pair);
    }
    return listed;
  }

  void at_rest(Options& options) const { options.at_rest = pairs(); }
  void always(Options& options) const { options.always = pairs(); }

  void joint_parents(Options& options) const {
    for (std::uint32_t j = 0; j < body.shape.joint_count; ++j)
      options.joint_parents.push_back(random.chance(0.3) ? kNoJoint : joint());
  }

  std::vector<IndexPair> index_pairs() const {
    std::vector<IndexPair> pairs;
    for (int i = 0; i < 3; ++i) pairs.push_back({joint(), joint()});
    return pairs;
  }

  void joint_pairs(Options& options) const { options.joint_pairs = index_pairs(); }

  /// Each triangle is in none to three of three zones, some twice.
  void joint_pairs_in_zones(Options& options) const {
    for (int i = 0; i < 12; ++i) options.joint_pairs_in_zones.push_back({joint(), joint()});
    for (std::uint32_t i = 0; i < 2 * triangles(); ++i)
      options.zones.push_back(
          {random.index(triangles()), static_cast<std::uint16_t>(65533 + random.index(3))});
  }

  void joint_bodies(Options& options) const {
    for (std::uint32_t j = 0; j < body.shape.joint_count; ++j)
      options.joint_bodies.push_back(static_cast<std::uint16_t>(500 + random.index(3)));
    joint_pairs(options);
    if (random.chance(0.5)) joint_pairs_in_zones(options);
  }

  void groups(Options& options) const {
    for (std::uint32_t t = 0; t < triangles(); ++t) options.groups.push_back(joint());
    options.group_pairs = index_pairs();
  }
};

using DrawOption = void (Draw::*)(Options&) const;

struct Case {
  const char* name;
  DrawOption draw;
  LeftOutBy by;
};

constexpr Case kCases[] = {{"takes_part", &Draw::takes_part, LeftOutBy::takes_part},
                           {"rings", &Draw::rings, LeftOutBy::rings},
                           {"at_rest", &Draw::at_rest, LeftOutBy::at_rest},
                           {"always", &Draw::always, LeftOutBy::always},
                           {"joint_parents", &Draw::joint_parents, LeftOutBy::joints},
                           {"joint_pairs", &Draw::joint_pairs, LeftOutBy::joints},
                           {"joint_pairs_in_zones", &Draw::joint_pairs_in_zones, LeftOutBy::joints},
                           {"joint_bodies", &Draw::joint_bodies, LeftOutBy::joints},
                           {"groups", &Draw::groups, LeftOutBy::groups}};

class EachFilter : public testing::TestWithParam<Case> {};

TEST_P(EachFilter, LeavesOutWhatTheDefinitionSays) {
  Random random(1740);
  Counts sums{};
  for (int round = 0; round < 6; ++round)
    for (const auto make : kBodies) {
      Body body = make(random);
      Options options;
      (Draw{random, body}.*GetParam().draw)(options);
      const Counts counts = expect_filtered(body, options);
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += counts[i];
    }
  const auto by = static_cast<std::size_t>(GetParam().by);
  EXPECT_GT(sums[0], 100u) << "kept";
  EXPECT_GT(sums[by], 100u) << "left out";
  for (std::size_t i = 1; i < sums.size(); ++i) EXPECT_TRUE(i == by || sums[i] == 0) << i;
}

INSTANTIATE_TEST_SUITE_P(Options, EachFilter, testing::ValuesIn(kCases),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(SelfFilter, CountsAPairForTheFirstFilterThatLeavesItOut) {
  Random random(1741);
  Counts sums{};
  for (int round = 0; round < 5; ++round)
    for (const auto make : kBodies) {
      Body body = make(random);
      Options options;
      for (const Case& option : kCases)
        if (random.chance(0.8)) (Draw{random, body}.*option.draw)(options);
      const Counts counts = expect_filtered(body, options);
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += counts[i];
    }
  for (const std::uint64_t sum : sums) EXPECT_GT(sum, 20u);
}

TEST(SelfFilter, LeavesOutContactsOfOtherQueries) {
  Random random(1744);
  LeftOut sums;
  std::size_t kept = 0;
  Scratch scratch;
  for (int round = 0; round < 8; ++round)
    for (const auto make : kBodies) {
      Body body = make(random);
      const Draw draw{random, body};
      Options options;
      for (const Case& option : kCases)
        if (random.chance(0.5)) (draw.*option.draw)(options);
      const SelfFilter filter = *build_self_filter(body.pose.model(), options.view());
      std::vector<Contact> expected, contacts;
      LeftOut expected_out;
      Classification classification(body.shape, options);
      for (int i = 0; i < 60; ++i) {
        std::uint32_t s = random.index(draw.triangles()), t = random.index(draw.triangles());
        if (!options.at_rest.empty() && random.chance(0.3))
          std::tie(s, t) = std::pair(options.at_rest[0].triangle_a, options.at_rest[0].triangle_b);
        if (s == t) continue;
        contacts.push_back({s, t});
        const LeftOutBy by = classification.by(s, t);
        expected_out.rings += by == LeftOutBy::rings;
        expected_out.joints += by == LeftOutBy::joints;
        if (by == LeftOutBy::none) expected.push_back({std::min(s, t), std::max(s, t)});
      }
      const LeftOut left_out = leave_out(filter, scratch, contacts);
      EXPECT_EQ(contacts, expected);
      EXPECT_EQ(left_out.rings, expected_out.rings);
      EXPECT_EQ(left_out.joints, expected_out.joints);
      sums += left_out;
      kept += contacts.size();
    }
  EXPECT_GT(kept, 50u);
  for (const std::uint64_t sum : {sums.rings, sums.at_rest, sums.joints, sums.groups})
    EXPECT_GT(sum, 5u);
}

TEST(SelfFilter, RingsReachAcrossHubsAndEndAtTheBorder) {
  Random random(1742);
  Shape shape;
  shape.influences_per_vertex = 1;
  add_fan(random, shape, 60, false, {});
  add_fan(random, shape, 5, true, {9, 0, 0});
  shape.triangles.push_back({0, 0, 1});
  shape.triangles.push_back({0, 0, 0});
  Body body(shape, std::vector<Matrix4>(1));
  for (const std::uint32_t rings : {1u, 2u, 3u, 64u}) {
    Options options;
    options.rings = rings;
    expect_filtered(body, options);
  }
}

TEST(SelfFilter, HasAnyNumberOfZones) {
  constexpr std::uint32_t kCount = 70'000;  // more than 16 bits can number
  Shape shape = make_limb(kCount / 10, 5, 2);
  ASSERT_GE(shape.triangles.size(), kCount - 10);
  const auto triangles = static_cast<std::uint32_t>(shape.triangles.size());
  std::vector<TriangleZone> zones;  // a triangle is in the zones of the bits of its number
  for (std::uint32_t t = 0; t < triangles; ++t)
    for (std::uint16_t bit = 0; bit < 17; ++bit)
      if ((t >> bit & 1) != 0) zones.push_back({t, bit});
  const SkinnedModel model = *build_model(shape.view());
  const std::vector<IndexPair> all = {{0, 0}, {0, 1}, {1, 1}};
  const SelfFilter filter =
      *build_self_filter(model, {.joint_pairs_in_zones = all, .zones = zones});
  Random random(1745);
  std::uint32_t apart = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::uint32_t s = random.index(triangles);
    const std::uint32_t t = random.chance(0.5) ? random.index(triangles) : ~s & 0xFFFF;
    if (s == t || t >= triangles) continue;
    apart += (s & t) == 0;
    ASSERT_EQ(filter.left_out_by(s, t), (s & t) != 0 ? LeftOutBy::joints : LeftOutBy::none)
        << s << " " << t;
  }
  EXPECT_GT(apart, 1000u);
}

/// The message of the error, or nothing.
std::string message_of(const SkinnedModel& model, const SelfFilterOptions& options) {
  const Result<SelfFilter> filter = build_self_filter(model, options);
  if (filter) return "";
  EXPECT_EQ(filter.error().code, ErrorCode::invalid_argument);
  return filter.error().message;
}

TEST(SelfFilter, RefusesOptionsThatDoNotFitTheModel) {
  const Shape limb = make_limb(5, 4, 3);
  const SkinnedModel model = *build_model(limb.view());
  const auto triangles = static_cast<std::uint32_t>(limb.triangles.size());
  const std::vector<std::uint8_t> few(triangles - 1);
  const std::vector<std::uint16_t> many(triangles + 1), groups(triangles),
      parents = {kNoJoint, 0, 3};
  const std::vector<Contact> pairs = {{0, 1}, {triangles, 2}}, others = {{1, triangles + 1}};
  const std::vector<IndexPair> joints = {{0, 1}, {0, 3}};
  const std::string of_triangles = std::to_string(triangles);

  EXPECT_EQ(message_of(model, {}), "");
  EXPECT_EQ(message_of(model, {.rings = 64}), "");
  EXPECT_EQ(message_of(model, {.rings = 65}), "rings is 65, expected 0 to 64");
  EXPECT_EQ(message_of(model, {.takes_part = few}), "takes_part has " + std::to_string(few.size()) +
                                                        " elements, expected " + of_triangles +
                                                        " or none");
  EXPECT_EQ(message_of(model, {.groups = many}), "groups has " + std::to_string(many.size()) +
                                                     " elements, expected " + of_triangles +
                                                     " or none");
  EXPECT_EQ(message_of(model, {.joint_bodies = std::span(parents).first(1)}),
            "joint_bodies has 1 elements, expected 3 or none");
  EXPECT_EQ(message_of(model, {.joint_parents = std::span(parents).first(2)}),
            "joint_parents has 2 elements, expected 3 or none");
  EXPECT_EQ(message_of(model, {.joint_parents = parents}),
            "joint_parents[2] refers to joint 3, but the model has 3 joints");
  EXPECT_EQ(message_of(model, {.joint_pairs = joints}),
            "joint_pairs[1] refers to joint 3, but the model has 3 joints");
  EXPECT_EQ(message_of(model, {.joint_pairs_in_zones = joints}),
            "joint_pairs_in_zones[1] refers to joint 3, but the model has 3 joints");
  const std::vector<TriangleZone> zones = {{triangles - 1, 65535}, {triangles, 0}};
  EXPECT_EQ(message_of(model, {.zones = zones}), "zones[1] refers to triangle " + of_triangles +
                                                     ", but the model has " + of_triangles +
                                                     " triangles");
  EXPECT_EQ(message_of(model, {.at_rest = pairs}), "at_rest[1] refers to triangle " + of_triangles +
                                                       ", but the model has " + of_triangles +
                                                       " triangles");
  EXPECT_EQ(message_of(model, {.always = others}),
            "always[0] refers to triangle " + std::to_string(triangles + 1) +
                ", but the model has " + of_triangles + " triangles");
  EXPECT_EQ(message_of(model, {.group_pairs = joints}), "group_pairs needs groups");
  EXPECT_EQ(message_of(model, {.groups = groups, .group_pairs = joints}), "");
}

TEST(SelfFilter, CopiesTheArraysAndIsSharedByCopies) {
  Random random(1743);
  Body body = soup(random);
  Options options;
  for (const Case& option : kCases) (Draw{random, body}.*option.draw)(options);
  const SelfFilter filter = *build_self_filter(body.pose.model(), options.view());
  const SelfFilter copy = filter;
  const auto answers = [](const SelfFilter& of) {
    std::vector<LeftOutBy> by;
    for (std::uint32_t t = 1; t < 150; ++t) by.push_back(of.left_out_by(0, t));
    return by;
  };
  const auto before = answers(filter);
  options = {};
  EXPECT_EQ(answers(filter), before);
  EXPECT_EQ(answers(copy), before);
  EXPECT_EQ(&copy.detail(), &filter.detail());
}

TEST(SelfFilter, AddsCountsOfSeveralPoses) {
  LeftOut sum = {1, 2, 3, 4, 5, 6};
  sum += {10, 20, 30, 40, 50, 60};
  EXPECT_EQ(counts_of(sum), (Counts{0, 11, 22, 33, 44, 55, 66}));
  EXPECT_EQ(sum.total(), 231u);
}

TEST(ContactTally, CountsThePosesOfEachPair) {
  Random random(1744);
  ContactTally tally;
  EXPECT_EQ(tally.pose_count(), 0u);
  EXPECT_TRUE(tally.in_share_of_poses(0).empty());
  std::map<Contact, std::uint32_t> counts;
  for (std::uint32_t pose = 1; pose <= 100; ++pose) {
    std::set<Contact> contacts;
    for (std::uint32_t i = 0; i < 30; ++i)
      if (random.index(30) <= i) contacts.insert({i % 7, 10 + i});
    for (const Contact& contact : contacts) ++counts[contact];
    tally.add(std::vector<Contact>(contacts.begin(), contacts.end()));
    EXPECT_EQ(tally.pose_count(), pose);
    ContactTally moved = std::move(tally);
    tally = std::move(moved);
  }
  for (std::uint32_t hundredths = 0; hundredths <= 100; ++hundredths) {
    std::vector<Contact> expected;
    for (const auto& [contact, count] : counts)
      if (count >= hundredths) expected.push_back(contact);
    EXPECT_EQ(tally.in_share_of_poses(hundredths / 100.0), expected) << hundredths << " %";
  }
}

}  // namespace
}  // namespace pelt::test
