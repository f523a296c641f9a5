/// Compares posed vertices with the formula of dual_skin.hpp in rational numbers.

#include "model/unpack.hpp"
#include "pose/pose.hpp"
#include "skin/skin.hpp"
#include "support/dual_shapes.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pelt {
namespace {

using detail::DualQuaternion;
using detail::Palette;
using detail::SkinnedMesh;
using test::Random;
using test::Turns;
using test::Weights;

using Rational3 = std::array<mpq_class, 3>;

struct RationalQuaternion {
  Rational3 r;
  mpq_class w;

  void add(const mpq_class& factor, const float* q) {
    for (std::size_t i = 0; i < 3; ++i) r[i] += factor * mpq_class(double{q[i]});
    w += factor * mpq_class(double{q[3]});
  }
};

Rational3 cross(const Rational3& a, const Rational3& b) {
  Rational3 c;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    c[i] = a[j] * b[k] - a[k] * b[j];
  }
  return c;
}

mpq_class squared_length(const RationalQuaternion& q) {
  return q.r[0] * q.r[0] + q.r[1] * q.r[1] + q.r[2] * q.r[2] + q.w * q.w;
}

/// Signs are those of float32, by definition.
float float_dot(const float* a, const float* b) {
  return (a[0] * b[0] + a[2] * b[2]) + (a[1] * b[1] + a[3] * b[3]);
}

struct Exact {
  Rational3 vertex;
  double n;
};

Exact exact_vertex(const SkinnedMesh& mesh, const Palette& palette, std::uint32_t vertex) {
  RationalQuaternion b, e;
  const auto influences = mesh.influences_of(vertex);
  const DualQuaternion& pivot = palette.duals()[influences[0].joint];
  for (const auto& influence : influences) {
    const DualQuaternion& q = palette.duals()[influence.joint];
    const mpq_class weight(double{influence.weight});
    const mpq_class factor = float_dot(pivot.real, q.real) < 0 ? mpq_class(-weight) : weight;
    b.add(factor, q.real);
    e.add(factor, q.dual);
  }
  const Vec3& rest = mesh.rest_positions[vertex];
  Exact exact;
  exact.vertex = {mpq_class(double{rest.x}), mpq_class(double{rest.y}), mpq_class(double{rest.z})};
  const mpq_class n = squared_length(b);
  Rational3 c = cross(b.r, exact.vertex);
  for (std::size_t i = 0; i < 3; ++i) c[i] += b.w * exact.vertex[i];
  const Rational3 turned = cross(b.r, c), moved = cross(b.r, e.r);
  for (std::size_t i = 0; i < 3; ++i)
    exact.vertex[i] += 2 * (turned[i] + moved[i] + b.w * e.r[i] - e.w * b.r[i]) / n;
  exact.n = n.get_d();
  return exact;
}

/// The margin that node_bounds.hpp derives also covers other errors, hence 33 for its 60.
TEST(DualSkinExact, PosedVerticesAreWithinTheProvedRounding) {
  Random random(70);
  double worst = 0;
  std::size_t vertices = 0, ill = 0;
  for (const Turns turns : test::kAllTurns)
    for (const Weights weights : {Weights::random, Weights::adversarial})
      for (const std::uint32_t influences : {1u, 2u, 4u, 16u}) {
        const test::Shape soup = test::make_soup(random, 150, 20, influences, weights);
        const SkinnedModel model = *build_model(soup.view(), test::kDual);
        const SkinnedMesh mesh = detail::unpack_mesh(model.detail().tree);
        Palette palette = rest_palette(model.detail().tree);
        ASSERT_TRUE(palette.set(test::random_rigid_palette(random, 20, turns, 2)));
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
          const Exact exact = exact_vertex(mesh, palette, v);
          const Vec3 p = pelt::scalar::posed_vertex(mesh, palette, v);
          const double k = static_cast<double>(mesh.influences_of(v).size());
          ASSERT_GE(exact.n, 0.999 / (k * k));
          const double unit = 0x1p-24 * double{palette.extent()};
          const double bound = (2.1 * k / std::sqrt(exact.n) + 33) * unit;
          const double got[] = {double{p.x}, double{p.y}, double{p.z}};
          for (std::size_t a = 0; a < 3; ++a) {
            ASSERT_LE(std::fabs(exact.vertex[a].get_d()), 1.0001 * double{palette.extent()});
            const mpq_class difference = exact.vertex[a] - mpq_class(got[a]);
            const double error = std::fabs(difference.get_d());
            ASSERT_LE(error, bound);
            worst = std::max(worst, error / unit);
          }
          ++vertices;
          ill += exact.n < 0.25;
        }
      }
  EXPECT_GT(vertices, 2000u);
  EXPECT_GT(ill, 50u);
  EXPECT_GT(worst, 0.2) << "the test must see rounding at all";
}

}  // namespace
}  // namespace pelt
