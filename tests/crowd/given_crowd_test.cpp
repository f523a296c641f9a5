/// A crowd of instances that joints pose, some with offsets, and of instances with given vertices.

#include <pelt/self_motion.hpp>

#include "crowd/test_crowd.hpp"

#include <algorithm>

namespace pelt::test {
namespace {

using Points = std::vector<Vec3>;

Points posed(const Pose& pose) {
  Points points(pose.model().vertex_count());
  posed_vertices(pose, points);
  return points;
}

/// Instances of one model with caps, and the same as poses at both ends of a step.
class GivenCrowd {
 public:
  GivenCrowd(Random& random, std::uint32_t count) : random_(random), shape_(make_limb(16, 8, 4)) {
    const std::vector<float> caps(shape_.rest_positions.size(), 0.03f);
    SkinnedMeshView view = shape_.view();
    view.offset_caps = caps;
    const SkinnedModel model = *build_model(view);
    for (std::uint32_t i = 0; i < count; ++i) {
      EXPECT_EQ(crowd.add(model), i);
      from.emplace_back(model);
      to.emplace_back(model);
    }
    offsets_[0].resize(count);
    offsets_[1].resize(count);
  }

  /// Moves all instances but every sixth.
  void step() {
    crowd.begin_step();
    end_ = 1 - end_;
    for (std::uint32_t i = 0; i < to.size(); ++i) {
      if (i % 6 == 5) continue;
      std::swap(from[i], to[i]);
      move(i);
    }
  }

  std::vector<CrowdContact> expected(const SelfFilter& filter) {
    std::vector<CrowdContact> all;
    std::vector<Contact> contacts;
    for (std::uint32_t a = 0; a < to.size(); ++a)
      for (std::uint32_t b = a; b < to.size(); ++b) {
        contacts.clear();
        if (a == b)
          self_collide(to[a], filter, scratch_, contacts);
        else
          collide(to[a], to[b], scratch_, contacts);
        for (const Contact& c : contacts) all.push_back({a, b, c.triangle_a, c.triangle_b});
      }
    return all;
  }

  std::vector<CrowdMovingContact> expected_moving() {
    std::vector<CrowdMovingContact> all;
    std::vector<MovingContact> contacts;
    for (std::uint32_t a = 0; a < to.size(); ++a)
      for (std::uint32_t b = a + 1; b < to.size(); ++b) {
        contacts.clear();
        collide_moving({from[a], to[a]}, {from[b], to[b]}, scratch_, contacts);
        for (const MovingContact& contact : contacts) all.push_back({a, b, contact});
      }
    return all;
  }

  Crowd crowd;
  std::vector<Pose> from, to;

 private:
  /// Posed with offsets, given, or posed without offsets.
  void move(std::uint32_t i) {
    const auto palette = bend_limb(random_, 4, random_.uniform(-0.5, 0.5), random_.point(0.3));
    Pose bent(crowd.model(i));
    ASSERT_TRUE(bent.set_palette(palette));
    if (random_.index(3) == 0) {
      const Points points = posed(bent);
      ASSERT_TRUE(to[i].set_vertices(points));
      ASSERT_TRUE(crowd.set_vertices(i, points));
      return;
    }
    Points& offsets = offsets_[end_][i];
    offsets.clear();
    if (random_.index(2) == 0)
      for (std::size_t v = 0; v < shape_.rest_positions.size(); ++v)
        offsets.push_back(random_.point(0.04));
    ASSERT_TRUE(to[i].set_palette(palette));
    ASSERT_TRUE(to[i].set_offsets(offsets));
    ASSERT_TRUE(crowd.set_palette(i, palette));
    ASSERT_TRUE(crowd.set_offsets(i, offsets));
  }

  Random& random_;
  Shape shape_;
  std::vector<Points> offsets_[2];  // of both ends, because poses borrow them
  std::size_t end_ = 0;
  Scratch scratch_;
};

TEST(GivenCrowd, EqualsAllPairsOneByOneWithAnyNumberOfThreads) {
  Random random(1900);
  GivenCrowd crowd(random, 8);
  const SelfFilter filter = *build_self_filter(crowd.crowd.model(0), {.rings = 1});
  std::size_t contacts = 0, moving = 0;
  for (int round = 0; round < 3; ++round) {
    crowd.step();
    const auto expected = crowd.expected(filter);
    const auto expected_moving = crowd.expected_moving();
    for (const std::uint32_t threads : {1u, 3u}) {
      std::vector<CrowdContact> found;
      crowd.crowd.collide(
          found, {.threads = threads, .self_filter = [&](std::uint32_t) { return &filter; }});
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected) << "round " << round;
      std::vector<CrowdMovingContact> found_moving;
      crowd.crowd.collide_moving(found_moving, {.threads = threads});
      ASSERT_EQ(found_moving, expected_moving) << "round " << round;
    }
    contacts += expected.size();
    moving += expected_moving.size();
  }
  std::printf("%zu contacts, %zu moving contacts\n", contacts, moving);
  EXPECT_GT(contacts, 500u);
  EXPECT_GT(moving, 1000u);
}

TEST(GivenCrowd, RefusesWhatAPoseRefuses) {
  Random random(1901);
  const Shape shape = make_limb(16, 8, 4);
  Crowd crowd;
  const std::uint32_t instance = crowd.add(*build_model(shape.view()));
  const std::size_t bytes = crowd.memory_bytes();
  EXPECT_FALSE(crowd.set_vertices(instance, Points(3)));
  EXPECT_FALSE(crowd.set_offsets(instance, Points(shape.rest_positions.size())));
  EXPECT_EQ(crowd.memory_bytes(), bytes);
  EXPECT_TRUE(crowd.set_vertices(instance, shape.rest_positions));
  EXPECT_GT(crowd.memory_bytes(), bytes + 16 * shape.rest_positions.size());
}

}  // namespace
}  // namespace pelt::test
