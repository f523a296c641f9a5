#include "skin/skin.hpp"

#include "model/unpack.hpp"
#include "pose/pose.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pelt {
namespace {

using detail::Palette;
using detail::SkinnedMesh;
using test::Motion;
using test::Random;
using test::Weights;

struct Posed {
  SkinnedModel model;
  SkinnedMesh unpacked;
  Pose pose;

  Posed(const test::Shape& shape, const std::vector<Matrix4>& palette)
      : model(*build_model(shape.view())),
        unpacked(detail::unpack_mesh(model.detail().tree)),
        pose(model) {
    EXPECT_TRUE(pose.set_palette(palette));
  }

  const SkinnedMesh& mesh() const { return unpacked; }
  const Palette& palette() const { return pose.detail().palette; }
};

template <typename Check>
void for_each_kind(std::uint64_t seed, Check check) {
  Random random(seed);
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
    for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
      for (const std::uint32_t influences : {1u, 4u, 9u})
        check(Posed(test::make_soup(random, 100, 7, influences, weights),
                    test::make_palette(random, 7, motion, 2)));
}

TEST(Skin, WideCodeHasTheBitsOfTheScalarDefinition) {
  for_each_kind(6, [](const Posed& posed) {
    for (std::uint32_t v = 0; v < posed.mesh().vertex_count(); ++v)
      ASSERT_EQ(detail::posed_vertex(posed.mesh(), posed.palette(), v),
                scalar::posed_vertex(posed.mesh(), posed.palette(), v));
  });
}

TEST(Skin, AllVerticesAtOnceHaveTheSameBits) {
  for_each_kind(7, [](const Posed& posed) {
    std::vector<Vec3> all(posed.mesh().vertex_count());
    posed_vertices(posed.pose, all);
    for (std::uint32_t v = 0; v < posed.mesh().vertex_count(); ++v)
      ASSERT_EQ(all[v], detail::posed_vertex(posed.mesh(), posed.palette(), v));
  });
}

/// Eq. 1 in double, and the sum of the absolute values of its terms along each axis.
struct Reference {
  double value[3] = {}, magnitude[3] = {};
};

Reference equation_1(const SkinnedMesh& mesh, const Palette& palette, std::uint32_t vertex) {
  Reference r;
  const Vec3& v = mesh.rest_positions[vertex];
  const double x[4] = {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z),
                       1};
  for (const auto& influence : mesh.influences_of(vertex))
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t column = 0; column < 4; ++column) {
        const double term = static_cast<double>(influence.weight) *
                            static_cast<double>(palette[influence.joint].m[4 * column + a]) *
                            x[column];
        r.value[a] += term;
        r.magnitude[a] += std::fabs(term);
      }
  return r;
}

TEST(Skin, IsEquationOneWithinTheProvedRounding) {
  double worst = 0;
  for_each_kind(8, [&](const Posed& posed) {
    for (std::uint32_t v = 0; v < posed.mesh().vertex_count(); ++v) {
      const Vec3 p = detail::posed_vertex(posed.mesh(), posed.palette(), v);
      const Reference r = equation_1(posed.mesh(), posed.palette(), v);
      const double n = static_cast<double>(posed.mesh().influences_of(v).size());
      const double got[3] = {static_cast<double>(p.x), static_cast<double>(p.y),
                             static_cast<double>(p.z)};
      for (int a = 0; a < 3; ++a) {
        const double error = std::fabs(got[a] - r.value[a]);
        ASSERT_LE(error, (n + 4) * 0x1p-24 * r.magnitude[a] * 1.001 + 1e-40);
        if (r.magnitude[a] > 0) worst = std::max(worst, error / (0x1p-24 * r.magnitude[a]));
      }
    }
  });
  EXPECT_GT(worst, 0.5) << "the test must see rounding at all";
}

TEST(Skin, OneJointAloneIsItsMatrixTimesTheVertex) {
  Random random(9);
  const Posed posed(test::make_soup(random, 100, 7, 1, Weights::one_joint),
                    test::make_palette(random, 7, Motion::affine, 2));
  for (std::uint32_t v = 0; v < posed.mesh().vertex_count(); ++v) {
    const auto influences = posed.mesh().influences_of(v);
    ASSERT_EQ(influences.size(), 1u);
    ASSERT_EQ(influences[0].weight, 1.0f);
    const auto& m = posed.palette()[influences[0].joint].m;
    const Vec3& r = posed.mesh().rest_positions[v];
    EXPECT_EQ(detail::posed_vertex(posed.mesh(), posed.palette(), v),
              (Vec3{(m[0] * r.x + m[8] * r.z) + (m[4] * r.y + m[12]),
                    (m[1] * r.x + m[9] * r.z) + (m[5] * r.y + m[13]),
                    (m[2] * r.x + m[10] * r.z) + (m[6] * r.y + m[14])}));
  }
}

}  // namespace
}  // namespace pelt
