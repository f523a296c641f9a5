#include "skin/palette_lanes.hpp"

#include <pelt/config.hpp>

#include "base/vec3.hpp"
#include "skin/palette.hpp"
#include "support/dual_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace pelt {
namespace {

using detail::DualQuaternion;
using detail::Vec3d;
using test::Random;
using test::Turns;

class RigidMotions : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    before_ = active_instruction_set();
    ASSERT_TRUE(set_active_instruction_set(GetParam()));
  }
  void TearDown() override { set_active_instruction_set(before_); }

  InstructionSet before_;
};

INSTANTIATE_TEST_SUITE_P(All, RigidMotions, testing::ValuesIn(available_instruction_sets()),
                         [](const auto& set) { return std::string(name_of(set.param)); });

/// One motion at a time, in plain doubles. The order of operations is that of the definition.
DualQuaternion plain_motion(const Matrix4& matrix) {
  const auto column = [&](std::size_t c) {
    return Vec3d(Vec3{matrix.m[4 * c], matrix.m[4 * c + 1], matrix.m[4 * c + 2]});
  };
  const Vec3d x = column(0), y = column(1), z = column(2), t = column(3);
  const double squares[] = {1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z,
                            1 + x.x + y.y + z.z};
  const double rows[4][4] = {{squares[0], x.y + y.x, x.z + z.x, y.z - z.y},
                             {x.y + y.x, squares[1], y.z + z.y, z.x - x.z},
                             {x.z + z.x, y.z + z.y, squares[2], x.y - y.x},
                             {y.z - z.y, z.x - x.z, x.y - y.x, squares[3]}};
  const double* row = rows[std::max_element(squares, squares + 4) - squares];
  const double scale =
      1 / std::sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2] + row[3] * row[3]);
  const Vec3d r(scale * row[0], scale * row[1], scale * row[2]);
  const double w = scale * row[3];
  const Vec3d e = 0.5 * (w * t + cross(t, r));
  const Vec3 real = detail::to_float(r), dual = detail::to_float(e);
  return {{real.x, real.y, real.z, static_cast<float>(w)},
          {dual.x, dual.y, dual.z, static_cast<float>(0.5 * -detail::dot(t, r))}};
}

bool have_equal_bits(const DualQuaternion& a, const DualQuaternion& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST_P(RigidMotions, HaveTheBitsOfPlainDoublesForAnyCount) {
  Random random(71);
  for (const Turns turns : test::kAllTurns)
    for (std::uint32_t count = 1; count <= 9; ++count) {
      const auto palette = test::random_rigid_palette(random, count, turns, 2);
      std::vector<DualQuaternion> found(count + 1, {{7, 7, 7, 7}, {7, 7, 7, 7}});
      ASSERT_TRUE(
          detail::find_rigid_motions(detail::floats_of(palette).data(), count, found.data()));
      for (std::uint32_t i = 0; i < count; ++i)
        ASSERT_TRUE(have_equal_bits(found[i], plain_motion(palette[i]))) << count << ' ' << i;
      ASSERT_EQ(found[count].real[0], 7);  // nothing written beyond the end
    }
}

float farthest_translation(const std::vector<Matrix4>& matrices) {
  float farthest = 0;
  for (const Matrix4& matrix : matrices)
    for (std::size_t k = 12; k < 15; ++k) farthest = std::max(farthest, std::fabs(matrix.m[k]));
  return farthest;
}

TEST_P(RigidMotions, BecomeTheMatricesTheyWere) {
  Random random(72);
  for (const Turns turns : test::kAllTurns) {
    const auto palette = test::random_rigid_palette(random, 50, turns, 3);
    std::vector<DualQuaternion> motions(palette.size());
    ASSERT_TRUE(detail::find_rigid_motions(detail::floats_of(palette).data(), palette.size(),
                                           motions.data()));
    std::vector<Matrix4> matrices(palette.size());
    const float farthest = detail::find_matrices(motions.data(), motions.size(), matrices.data());
    EXPECT_EQ(farthest, farthest_translation(matrices));
    for (std::size_t i = 0; i < palette.size(); ++i)
      for (std::size_t k = 0; k < 16; ++k) {
        const float size = k < 12 ? 1 : 1 + farthest;
        ASSERT_NEAR(matrices[i].m[k], palette[i].m[k], 1e-6f * size) << i << ' ' << k;
        ASSERT_TRUE(k >= 12 || std::fabs(matrices[i].m[k]) <= 1);
      }
  }
}

TEST_P(RigidMotions, RefuseWhatIsNotRigidInAnyLane) {
  Random random(73);
  for (std::size_t bad = 0; bad < 6; ++bad) {
    auto palette = test::random_rigid_palette(random, 6, Turns::any, 1);
    std::vector<DualQuaternion> motions(6);
    const auto accepts = [&] {
      return detail::find_rigid_motions(detail::floats_of(palette).data(), 6, motions.data());
    };
    ASSERT_TRUE(accepts());
    for (std::size_t k = 0; k < 3; ++k) palette[bad].m[k] *= 1.01f;
    EXPECT_FALSE(accepts()) << "scaled " << bad;
    for (std::size_t k = 0; k < 3; ++k) palette[bad].m[k] *= -1 / 1.01f;
    EXPECT_FALSE(accepts()) << "mirrored " << bad;
  }
}

TEST_P(RigidMotions, RefuseDualsThatAreNotUnitInAnyLane) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (std::size_t bad = 0; bad < 6; ++bad)
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity})
      for (std::size_t element = 0; element < 8; ++element) {
        std::vector<float> floats(48, 0.0f);
        for (std::size_t i = 0; i < 6; ++i) floats[8 * i + 3] = 1;
        std::vector<DualQuaternion> motions(6);
        ASSERT_TRUE(detail::normalise_duals(floats.data(), 6, motions.data()));
        floats[8 * bad + element] = value;
        EXPECT_FALSE(detail::normalise_duals(floats.data(), 6, motions.data())) << value;
        EXPECT_FALSE(detail::find_not_unit(&floats[8 * bad], bad).empty());
      }
}

/// Duals of motions farther than any float overflow: the translation is then no number.
TEST_P(RigidMotions, ReportATranslationThatIsNotFinite) {
  for (std::size_t bad = 0; bad < 6; ++bad)
    for (const float value :
         {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
      std::vector<DualQuaternion> motions(6);
      motions[bad].dual[1] = value;
      std::vector<Matrix4> matrices(6);
      EXPECT_EQ(detail::find_matrices(motions.data(), 6, matrices.data()),
                std::numeric_limits<float>::infinity())
          << bad;
    }
}

}  // namespace
}  // namespace pelt
