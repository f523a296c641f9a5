/// Certified fans have no contact, and in the others each contact is among the undecided pairs:
/// every pair of triangles is tested exactly.

#include "self/flat_fans.hpp"

#include "fan_lanes.hpp"
#include "model/model.hpp"
#include "self/neighbours.hpp"
#include "support/instruction_sets.hpp"
#include "surface_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace pelt::test {
namespace {

using detail::FanKind;
using detail::Fans;
using detail::kMaxFan;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr std::uint32_t kLanes = 8;

/// Eight closed and eight open fans of each size.
Shape all_fans(Random& random) {
  Shape shape;
  shape.influences_per_vertex = 1;
  for (std::uint32_t size = 1; size <= kMaxFan; ++size)
    for (std::uint32_t copy = 0; copy < kLanes; ++copy)
      for (const bool is_closed : {false, true})
        if (size >= 3 || !is_closed)
          add_fan(random, shape, size, is_closed,
                  {static_cast<float>(3 * size), static_cast<float>(3 * copy),
                   is_closed ? 3.0f : 0.0f});
  return shape;
}

/// Spokes of a fan with `count` spokes: points relative to the fan's vertex.
using Spokes = std::vector<std::array<double, 3>>;
using MakeSpokes = Spokes (*)(Random& random, std::uint32_t count, bool is_closed);

/// The angle of each spoke, for wedges of random sizes that make `turns` in all.
std::vector<double> random_angles(Random& random, std::uint32_t count, bool is_closed,
                                  double turns) {
  std::vector<double> sums = {0};
  const std::uint32_t wedges = is_closed ? count : count - 1;
  for (std::uint32_t i = 0; i < wedges; ++i) sums.push_back(sums.back() + random.uniform(0.5, 1));
  std::vector<double> angles;
  for (std::uint32_t i = 0; i < count; ++i) angles.push_back(sums[i] / sums.back() * kTurn * turns);
  return angles;
}

/// Spokes around the z axis.
template <typename Height>
Spokes around_axis(Random& random, const std::vector<double>& angles, const Height& height) {
  Spokes spokes;
  for (const double angle : angles) {
    const double length = random.uniform(0.3, 2);
    spokes.push_back({length * std::cos(angle), length * std::sin(angle), height(angle) * length});
  }
  return spokes;
}

/// Spokes of a smooth surface. Most of these fans must be certified.
Spokes smooth(Random& random, std::uint32_t count, bool is_closed) {
  const double turns = is_closed ? 1 : random.uniform(0.1, 0.9), slope = random.uniform(-1, 1);
  return around_axis(random, random_angles(random, count, is_closed, turns),
                     [&](double) { return slope + random.uniform(-0.1, 0.1); });
}

Spokes saddle(Random& random, std::uint32_t count, bool is_closed) {
  const double turns = is_closed ? 1 : random.uniform(0.3, 0.99), depth = random.uniform(0, 6);
  return around_axis(random, random_angles(random, count, is_closed, turns),
                     [&](double angle) { return depth * std::cos(3 * angle); });
}

Spokes winding_twice(Random& random, std::uint32_t count, bool is_closed) {
  const double turns = is_closed ? 2 + random.index(2) : random.uniform(1, 2.5);
  const double rise = random.uniform(-1, 1);
  return around_axis(random, random_angles(random, count, is_closed, turns), [&](double angle) {
    return rise * (is_closed ? std::sin(angle / 2) : angle);
  });
}

/// Open fans that make one turn up to a few roundings, or a little more.
Spokes one_turn(Random& random, std::uint32_t count, bool is_closed) {
  const double turns =
      is_closed ? 1 : 1 + std::ldexp(random.uniform(-1, 1), -int(random.index(30)));
  return around_axis(random, random_angles(random, count, is_closed, turns),
                     [&](double) { return 0.0; });
}

/// A smooth fan with one spoke turned back over its neighbours.
Spokes folded(Random& random, std::uint32_t count, bool is_closed) {
  Spokes spokes = smooth(random, count, is_closed);
  const std::uint32_t which = random.index(count);
  const auto& other = spokes[(which + 1 + random.index(3)) % count];
  const double length = std::ldexp(1.0, static_cast<int>(random.index(3)) - 1);
  for (std::size_t axis = 0; axis < 3; ++axis) spokes[which][axis] = length * other[axis];
  return spokes;
}

Spokes spiked(Random& random, std::uint32_t count, bool is_closed) {
  Spokes spokes = smooth(random, count, is_closed);
  auto& spoke = spokes[random.index(count)];
  const double length = std::ldexp(1.0, static_cast<int>(random.index(20)));
  if (random.chance(0.5))
    spoke = {0, 0, random.chance(0.5) ? length : -length};
  else
    for (double& coordinate : spoke) coordinate *= length;
  return spokes;
}

/// Points of a small grid: spokes of length zero, on one line, in one plane.
Spokes on_grid(Random& random, std::uint32_t count, bool) {
  Spokes spokes(count);
  const std::uint32_t size = 2 + random.index(3);
  for (auto& spoke : spokes)
    for (double& coordinate : spoke)
      coordinate = static_cast<double>(random.index(2 * size + 1)) - size;
  return spokes;
}

/// A smooth fan whose spokes are moved almost to one plane through the axis, or one line.
Spokes squashed(Random& random, std::uint32_t count, bool is_closed) {
  Spokes spokes = smooth(random, count, is_closed);
  const double x = std::ldexp(1.0, -static_cast<int>(random.index(40)));
  const double z = random.chance(0.5) ? 1 : std::ldexp(1.0, -static_cast<int>(random.index(40)));
  for (auto& spoke : spokes) spoke[0] *= x, spoke[2] *= z;
  return spokes;
}

Spokes anywhere(Random& random, std::uint32_t count, bool) {
  Spokes spokes(count);
  for (auto& spoke : spokes)
    for (double& coordinate : spoke) coordinate = random.uniform(-1, 1);
  return spokes;
}

struct Case {
  const char* name;
  MakeSpokes make;
  double least_certified;  ///< share of the fans at ordinary coordinates
  double least_touching;   ///< share of the fans that have a contact
  double least_apart;      ///< share of the pairs of ordinary fans without certificate
};

constexpr Case kCases[] = {
    {"smooth", smooth, 0.9, 0, 0.6},
    {"saddles", saddle, 0.2, 0, 0.5},
    {"winding_twice", winding_twice, 0.03, 0.3, 0.6},
    {"one_turn", one_turn, 0.3, 0.1, 0.05},
    {"folded", folded, 0.005, 0.3, 0.6},
    {"spiked", spiked, 0.1, 0.02, 0.15},
    {"on_grid", on_grid, 0.01, 0.5, 0.4},
    {"squashed", squashed, 0.2, 0, 0.15},
    {"anywhere", anywhere, 0.01, 0.3, 0.5},
};

/// Where fans are, and their size: they are certified relative to their own size only if the
/// coordinates have enough digits.
struct Placement {
  double distance;
  int exponent;
  bool is_ordinary;
};

constexpr Placement kPlacements[] = {
    {0, 0, true},      {1, 0, true},     {0, 58, true},   {0, -40, true},      {100, -7, false},
    {1e5, -10, false}, {0, -148, false}, {0, -75, false}, {0x1p58, 55, false},
};

class FlatFans : public testing::TestWithParam<Case> {
 protected:
  FlatFans()
      : random_(1710),
        shape_(all_fans(random_)),
        model_(*build_model(shape_.view())),
        tree_(model_.detail().tree),
        fans_(tree_),
        positions_(tree_.rest_positions.size()) {}

  /// Gives a fan new spokes. Its vertices belong to no other fan.
  void place(std::uint32_t fan, FanKind kind, const Placement& placement) {
    const auto triangles = fans_[fan];
    const auto size = static_cast<std::uint32_t>(triangles.size());
    const bool is_closed = kind == FanKind::closed;
    const Spokes spokes = GetParam().make(random_, is_closed ? size : size + 1, is_closed);
    const Matrix4 turn = rotation_about(random_.point(1), random_.uniform(0, 6), {}, {});
    const Vec3 centre = random_.point(placement.distance);
    const auto put = [&](std::uint32_t triangle, std::uint32_t step,
                         const std::array<double, 3>& p) {
      const auto& t = triangles[triangle];
      auto& out = positions_[fans_.corners[t.place()][(t.corner() + step) % 3]];
      for (std::size_t row = 0; row < 3; ++row) {
        const double at = double{turn.m[row]} * p[0] + double{turn.m[4 + row]} * p[1] +
                          double{turn.m[8 + row]} * p[2];
        out[row] = static_cast<float>((&centre.x)[row] +
                                      std::ldexp(keeps_grid() ? p[row] : at, placement.exponent));
      }
    };
    put(0, 0, {0, 0, 0});
    for (std::uint32_t i = 0; i < size; ++i) put(i, 1, spokes[i]);
    if (!is_closed) put(size - 1, 2, spokes[size]);
  }

  detail::SurfaceTriangle triangle(std::uint32_t place) const {
    detail::SurfaceTriangle result;
    result.vertices = fans_.corners[place];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = positions_[result.vertices[k]];
      result.corners[k] = {p[0], p[1], p[2]};
    }
    return result;
  }

  bool intersect(std::uint32_t fan, std::size_t i, std::size_t k) const {
    const auto triangles = fans_[fan];
    return surface_triangles_intersect(triangle(triangles[i].place()),
                                       triangle(triangles[k].place()));
  }

  /// The result, which must be the same with each instruction set.
  TestedFans test(const detail::FanRun& run, std::uint32_t first, std::uint32_t count) const {
    constexpr Compiled<TestFans> kTestFans[] = PELT_ALL_COMPILED(test_fans);
    return on_each_compiled(kTestFans, fans_, run, first, count, positions_);
  }

  void check(const detail::FanRun& run, std::uint32_t first, std::uint32_t count,
             const Placement& placement) {
    for (std::uint32_t fan = first; fan < first + count; ++fan) place(fan, run.kind, placement);
    const TestedFans tested = test(run, first, count);
    ASSERT_EQ(tested.certified >> count, 0u);
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const bool is_flat = tested.certified >> lane & 1;
      check_pairs(first + lane, tested.undecided[lane], is_flat, placement);
      if (run.size >= 3 && placement.is_ordinary) ++ordinary_, certified_ += is_flat;
    }
  }

  /// `rows`: the undecided pairs, none if the fan is flat.
  void check_pairs(std::uint32_t fan, const std::array<std::uint32_t, kMaxFan>& rows, bool is_flat,
                   const Placement& placement) {
    bool touches = false;
    const std::size_t size = fans_[fan].size();
    for (std::size_t k = 0; k < size; ++k)
      for (std::size_t i = 0; i < k; ++i) {
        const bool is_undecided = rows[k] >> i & 1, meet = intersect(fan, i, k);
        ASSERT_FALSE(meet && !is_undecided)
            << "triangles " << i << " and " << k << " of fan " << fan << " of " << size
            << " triangles, distance " << placement.distance << ", exponent " << placement.exponent;
        touches |= meet;
        if (!is_flat && placement.is_ordinary) ++pairs_, apart_ += !is_undecided;
      }
    if (size >= 3) ++fans_tested_, touching_ += touches;
  }

  Random random_;
  Shape shape_;
  SkinnedModel model_;
  const detail::Tree& tree_;
  Fans fans_;
  FanPositions positions_;
  double fans_tested_ = 0, ordinary_ = 0, touching_ = 0, certified_ = 0;
  double pairs_ = 0, apart_ = 0;  // of ordinary fans without certificate

 private:
  static bool keeps_grid() { return GetParam().make == on_grid; }
};

TEST_P(FlatFans, HaveNoContact) {
  ASSERT_EQ(fans_.flat_count(), fans_.count());
  for (int round = 0; round < 3; ++round)
    for (const Placement& placement : kPlacements)
      for (const detail::FanRun& run : fans_.runs)
        for (std::uint32_t fan = run.first_fan; fan < run.end && !HasFatalFailure();) {
          const std::uint32_t count = std::min(1 + random_.index(kLanes), run.end - fan);
          check(run, fan, count, placement);
          fan += count;
        }
  EXPECT_GE(certified_ / ordinary_, GetParam().least_certified);
  EXPECT_GE(touching_ / fans_tested_, GetParam().least_touching);
  EXPECT_GE(apart_ / pairs_, GetParam().least_apart);
}

INSTANTIATE_TEST_SUITE_P(Spokes, FlatFans, testing::ValuesIn(kCases),
                         [](const auto& param_info) { return param_info.param.name; });

}  // namespace
}  // namespace pelt::test
