/// A moving character against a height field, against the exact test of all pairs of triangles.

#include "collide/moving_bodies.hpp"
#include "fields.hpp"

namespace pelt::test {
namespace {

std::vector<MovingContact> contacts_of(Body& body, const HeightField& field,
                                       const MovingOptions& options = {}) {
  Scratch scratch;
  std::vector<MovingContact> contacts;
  collide(body.step(), field, scratch, contacts, options);
  return contacts;
}

/// A bending limb that moves over hills, into them or through them.
struct Hike {
  explicit Hike(Random& random) {
    const float spacing = random.uniformf(0.05, 0.3);
    field =
        make_hills(random, 12, 12, {-6 * spacing, 0.1f, -6 * spacing}, spacing, 0.4, 0.05).build();
    const auto palette = [&] {
      const double angle = random.uniform(-0.4, 0.4);
      return bend_limb(random, 3, angle, random.point(0.35));
    };
    const auto from = palette(), to = palette();
    limb.move(from, to);
  }

  Body limb = Body(make_limb(10, 6, 3));
  HeightField field = make_plain(2, 2, {}, 1).build();
};

TEST(MovingField, HasTheOptionsOfTwoMotions) {
  Random random(1852);
  std::size_t all_count = 0;
  int touching = 0, apart = 0;
  for (int round = 0; round < 30; ++round) {
    Hike hike(random);
    const auto all = contacts_of(hike.limb, hike.field);
    std::vector<MovingContact> rest;
    for (const MovingContact& c : all)
      if (!c.at_start) rest.push_back(c);
    EXPECT_EQ(contacts_of(hike.limb, hike.field, {.leave_out_start = true}), rest);
    EXPECT_EQ(contacts_of(hike.limb, hike.field, {.times = false}).size(), all.size());
    const std::size_t some = std::min<std::size_t>(all.size(), 7);
    EXPECT_EQ(contacts_of(hike.limb, hike.field, {.max_contacts = 7}).size(), some);
    Scratch scratch;
    EXPECT_EQ(intersects(hike.limb.step(), hike.field, scratch).answer, !all.empty());
    all_count += all.size();
    ++(all.empty() ? apart : touching);
  }
  EXPECT_GT(all_count, 1000u);
  EXPECT_GT(touching, 10);
  EXPECT_GT(apart, 1);
}

/// A foot that goes through a thin bridge from one frame to the next.
TEST(MovingField, FindsWhatNoEndOfTheStepShows) {
  Body limb(make_limb(10, 6, 3));
  const auto at_height = [](float y) {
    std::vector<Matrix4> palette(3);
    for (Matrix4& m : palette) m.m[13] = y;
    return palette;
  };
  limb.move(at_height(0.5f), at_height(-2));
  const HeightField field = make_plain(6, 6, {-1, 0, -1}, 0.4f).build();
  Scratch scratch;
  EXPECT_FALSE(intersects(limb.from, field, scratch));
  EXPECT_FALSE(intersects(limb.to, field, scratch));
  EXPECT_GT(contacts_of(limb, field).size(), 10u);
}

}  // namespace
}  // namespace pelt::test
