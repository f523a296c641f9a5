/// A crowd of instances that joints pose, some with offsets, and of instances with given vertices.

#include "crowd/posed_crowd.hpp"

#include <utility>

namespace pelt::test {
namespace {

using Points = std::vector<Vec3>;

Points posed(const Pose& pose) {
  Points points(pose.model().vertex_count());
  posed_vertices(pose, points);
  return points;
}

/// Instances of one model with caps.
class GivenCrowd final : public PosedCrowd {
 public:
  GivenCrowd(Random& random, const Shape& shape, std::uint32_t count)
      : PosedCrowd(model_of(shape), count, 6), random_(random) {}

 private:
  static std::vector<SkinnedModel> model_of(const Shape& shape) {
    const std::vector<float> caps(shape.rest_positions.size(), 0.03f);
    SkinnedMeshView view = shape.view();
    view.offset_caps = caps;
    return {*build_model(view)};
  }

  /// Posed with offsets, given, or posed without offsets.
  void move(std::uint32_t i) override {
    const auto palette = bend_limb(random_, 4, random_.uniform(-0.5, 0.5), random_.point(0.3));
    if (random_.index(3) == 0) {
      Pose bent(crowd.model(i));
      ASSERT_TRUE(bent.set_palette(palette));
      const Points points = posed(bent);
      ASSERT_TRUE(to[i].set_vertices(points));
      ASSERT_TRUE(crowd.set_vertices(i, points));
      return;
    }
    Points offsets;
    if (random_.index(2) == 0)
      for (std::uint32_t v = 0; v < crowd.model(i).vertex_count(); ++v)
        offsets.push_back(random_.point(0.04));
    ASSERT_TRUE(to[i].set_palette(palette));
    ASSERT_TRUE(crowd.set_palette(i, palette));
    set_offsets(i, std::move(offsets));
  }

  Random& random_;
};

TEST(GivenCrowd, EqualsAllPairsOneByOneWithAnyNumberOfThreads) {
  Random random(1900);
  GivenCrowd crowd(random, make_limb(16, 8, 4), 8);
  for (int round = 0; round < 3; ++round) {
    crowd.step();
    crowd.expect_all_pairs();
    if (HasFatalFailure()) return;
  }
  std::printf("%zu contacts, %zu moving contacts\n", crowd.contacts, crowd.moving);
  EXPECT_GT(crowd.contacts, 500u);
  EXPECT_GT(crowd.moving, 1000u);
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
