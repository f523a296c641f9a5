/// Bodies whose boxes only touch, or overlap at one instant only.

#include <pelt/motion.hpp>

#include "moving_bodies.hpp"
#include "support/closed_shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

namespace pelt::test {
namespace {

std::vector<Matrix4> moved_by(const Vec3& shift) {
  return {rotation_about({0, 0, 1}, 0, {}, shift)};
}

/// Corner 0 of a is its rightmost and highest, and that of b its leftmost and lowest. b comes from
/// the right and leaves upwards, so that the boxes overlap at time p / q only, when these two
/// corners are at one position. The quotients of gaps that give this time round differently on both
/// axes.
TEST(TouchingSteps, FindCornersThatPassAtOneInstant) {
  Random random(1861);
  Body a(make_rigid({{0, 0, 0}, {-0x1p26f, -0x1p25f, 1}, {-0x1p25f, -0x1p26f, -1}}, {{0, 1, 2}}));
  Body b(make_rigid({{0, 0, 0}, {0x1p26f, 0x1p25f, 1}, {0x1p25f, 0x1p26f, -1}}, {{0, 1, 2}}));
  a.move(moved_by({}), moved_by({}));
  Scratch scratch;
  for (int round = 0; round < 300; ++round) {
    const std::uint32_t p = 1 + random.index(9), q = p + 1 + random.index(9);
    const std::uint32_t most = (1u << 24) / std::max(p, q - p);
    const std::uint32_t m = 1 + random.index(most), n = 1 + random.index(most);
    const auto place = [](std::uint32_t x, std::uint32_t y) {
      return Vec3{static_cast<float>(x), -static_cast<float>(y), 0};
    };
    const Vec3 from = place(p * m, p * n), to = place((q - p) * m, (q - p) * n);
    b.move(moved_by(from), moved_by({-to.x, -to.y, 0}));
    const auto contacts = contacts_of(a, b);
    ASSERT_EQ(contacts.size(), 1u) << "round " << round;
    const MovingContact& contact = contacts.front();
    EXPECT_TRUE(q * double{contact.time} <= p && p < q * double{std::nextafter(contact.time, 2.f)});
    EXPECT_TRUE(contact.a.kind == FeatureKind::corner && contact.b.kind == FeatureKind::corner);
    EXPECT_TRUE(intersects(a.step(), b.step(), scratch).answer);
    std::optional<MovingContact> first;
    first_contact(a.step(), b.step(), scratch, first);
    EXPECT_EQ(first, contact);
  }
}

/// A square of 14 x 14 units in the plane z = 0, with two triangles per unit.
Shape make_sheet() {
  constexpr std::uint32_t kUnits = 14, kRow = kUnits + 1;
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  for (std::uint32_t y = 0; y < kRow; ++y)
    for (std::uint32_t x = 0; x < kRow; ++x) {
      positions.push_back({static_cast<float>(x), static_cast<float>(y), 0});
      const std::uint32_t i = y * kRow + x;
      if (x == kUnits || y == kUnits) continue;
      triangles.push_back({i, i + 1, i + kRow + 1});
      triangles.push_back({i, i + kRow + 1, i + kRow});
    }
  return make_rigid(std::move(positions), std::move(triangles));
}

/// Their borders or corners touch at all times, or they touch at one end of the step.
TEST(TouchingSteps, FindSheetsThatOnlyTouch) {
  Body a(make_sheet()), b(make_sheet());
  a.move(moved_by({}), moved_by({}));
  constexpr std::array<std::pair<Vec3, Vec3>, 6> kSteps = {{{{14, -2, 0}, {14, 3, 0}},
                                                            {{14, 14, 0}, {14, 14, 0}},
                                                            {{-3, -14, 0}, {2, -14, 0}},
                                                            {{-14, 13, 0}, {-14, 15, 0}},
                                                            {{13, 13, 1}, {13, 13, 0}},
                                                            {{-13, 12, 0}, {-13, 12, -2}}}};
  for (const auto& [from, to] : kSteps) {
    b.move(moved_by(from), moved_by(to));
    const auto expected = brute_force(a, b);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(contacts_of(a, b), expected);
  }
}

}  // namespace
}  // namespace pelt::test
