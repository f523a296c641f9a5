/// The operations that section 4.2 of Kavan & Zara 2005 counts: its refit written down once more
/// with numbers that count what is done with them, its total sum_i (18 p_i + 11 m_i + 8 p_i m_i -
/// 2) checked, and its spheres compared with those of paper/refit.

#include "paper/on_demand.hpp"
#include "posed_mesh.hpp"

#include <gtest/gtest.h>

namespace pelt::paper {
namespace {

using test::Motion;
using test::Random;
using test::Weights;

int flops = 0;

/// A number whose every operation is a flop.
struct Counted {
  double value = 0;
};

Counted counted(double value) {
  ++flops;
  return {value};
}

Counted operator+(Counted a, Counted b) { return counted(a.value + b.value); }
Counted operator-(Counted a, Counted b) { return counted(a.value - b.value); }
Counted operator*(Counted a, Counted b) { return counted(a.value * b.value); }
bool operator>(Counted a, Counted b) { return counted(a.value - b.value).value > 0; }
Counted root(Counted a) { return counted(std::sqrt(a.value)); }
Counted larger(Counted a, Counted b) {
  const bool first = a > b;
  return counted((first ? a : b).value);  // the selection
}

struct CountedSphere {
  std::array<Counted, 3> centre;
  Counted radius;
};

Counted constant(float value) { return {static_cast<double>(value)}; }

/// C_j S: the centre transformed, the radius kept. 18 flops.
CountedSphere transformed(const Matrix4& c, const CountedSphere& s) {
  CountedSphere image = s;
  for (std::size_t row = 0; row < 3; ++row)
    image.centre[row] = constant(c.m[row]) * s.centre[0] + constant(c.m[4 + row]) * s.centre[1] +
                        constant(c.m[8 + row]) * s.centre[2] + constant(c.m[12 + row]);
  return image;
}

/// R_a of eq. 5: four coordinates of p products and p - 1 sums each, 8 p - 4 flops.
CountedSphere blend(const float* corner, const std::vector<CountedSphere>& images) {
  const auto blend_coordinate = [&](auto coordinate) {
    Counted sum = constant(corner[0]) * coordinate(images[0]);
    for (std::size_t j = 1; j < images.size(); ++j)
      sum = sum + constant(corner[j]) * coordinate(images[j]);
    return sum;
  };
  CountedSphere blended;
  for (std::size_t axis = 0; axis < 3; ++axis)
    blended.centre[axis] = blend_coordinate([&](const CountedSphere& s) { return s.centre[axis]; });
  blended.radius = blend_coordinate([](const CountedSphere& s) { return s.radius; });
  return blended;
}

/// |R - c| + r: 3 differences, 3 products, 2 sums, a root, a sum: 10 flops.
Counted reach(const CountedSphere& s, const std::array<Counted, 3>& centre) {
  const Counted x = s.centre[0] - centre[0], y = s.centre[1] - centre[1],
                z = s.centre[2] - centre[2];
  return root(x * x + y * y + z * z) + s.radius;
}

/// Around the average of the centres: 3 (m - 1) sums and 3 products (1 / m is a constant); m
/// distances; m - 1 comparisons and as many selections: 15 m - 2 flops.
CountedSphere enclose(const std::vector<CountedSphere>& spheres) {
  std::array<Counted, 3> centre = spheres[0].centre;
  const Counted share{1 / static_cast<double>(spheres.size())};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t a = 1; a < spheres.size(); ++a)
      centre[axis] = centre[axis] + spheres[a].centre[axis];
    centre[axis] = centre[axis] * share;
  }
  Counted radius = reach(spheres[0], centre);
  for (std::size_t a = 1; a < spheres.size(); ++a)
    radius = larger(radius, reach(spheres[a], centre));
  return {centre, radius};
}

struct CountedRefit {
  CountedSphere sphere;
  int transforms = 0, blends = 0, enclosing = 0;

  int total() const { return transforms + blends + enclosing; }
};

/// Flops since the last call.
int taken_flops() { return std::exchange(flops, 0); }

/// The refit of section 4.2, step by step.
CountedRefit refit_as_written(const SphereModel& model, std::uint32_t node,
                              const Palette& palette) {
  const Sphere& rest = model.tree.nodes[node].rest;
  const CountedSphere s = {
      {constant(rest.centre.x), constant(rest.centre.y), constant(rest.centre.z)},
      constant(rest.radius)};
  CountedRefit result;
  std::vector<CountedSphere> blended;
  taken_flops();
  for (const JointSet& set : model.bounds.sets_of(node)) {
    std::vector<CountedSphere> images;
    for (std::uint32_t j = 0; j < set.joint_count; ++j)
      images.push_back(transformed(palette[model.bounds.joints[set.first_joint + j]], s));
    result.transforms += taken_flops();
    for (std::uint32_t a = 0; a < set.corner_count; ++a)
      blended.push_back(
          blend(model.bounds.corners.data() + set.first_corner + a * set.joint_count, images));
    result.blends += taken_flops();
  }
  result.sphere = enclose(blended);
  result.enclosing = taken_flops();
  return result;
}

struct Formula {
  int transforms = 0, blends = 0, enclosing = 0, total = 0;
};

/// The terms of the paper, summed over the joint sets.
Formula formula(std::span<const JointSet> sets) {
  Formula sum;
  for (const JointSet& set : sets) {
    const int p = set.joint_count, m = set.corner_count;
    sum.transforms += 18 * p;
    sum.blends += 8 * p * m - 4 * m;
    sum.enclosing += 15 * m - 2;
    sum.total += 18 * p + 11 * m + 8 * p * m - 2;
  }
  return sum;
}

/// Shapes with one, a few and many joint sets in a node, of 1 to 8 joints.
std::vector<test::Shape> make_shapes(Random& random) {
  std::vector<test::Shape> shapes = {test::make_limb(16, 8, 5), test::make_limb(24, 6, 9)};
  for (const std::uint32_t influences : {1, 2, 4, 8})
    shapes.push_back(make_soup(random, 60, 9, influences, Weights::random));
  return shapes;
}

TEST(Flops, CountedOperationsAreTheFormula) {
  Random random(1);
  int nodes_of_one_set = 0, nodes_of_several_sets = 0;
  for (const test::Shape& shape : make_shapes(random)) {
    const SkinnedMesh mesh = test::checked_mesh(shape);
    const SphereModel model = build_sphere_model(mesh);
    const Palette palette =
        test::checked_palette(mesh, make_palette(random, mesh.joint_count, Motion::rigid, 1));
    for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
      const CountedRefit counted = refit_as_written(model, n, palette);
      const Formula expected = formula(model.bounds.sets_of(n));
      const auto set_count = static_cast<int>(model.bounds.sets_of(n).size());
      // One sphere is put around the corners of all sets together: the formula's "- 2" of m - 1
      // comparisons and selections is there once, not once for each set.
      const int joined = 2 * (set_count - 1);
      ASSERT_EQ(counted.transforms, expected.transforms);
      ASSERT_EQ(counted.blends, expected.blends);
      ASSERT_EQ(counted.enclosing, expected.enclosing + joined);
      ASSERT_EQ(counted.total(), expected.total + joined);
      ++(set_count == 1 ? nodes_of_one_set : nodes_of_several_sets);
    }
  }
  EXPECT_GT(nodes_of_one_set, 100);
  EXPECT_GT(nodes_of_several_sets, 100);
}

TEST(Flops, TheCountedRefitGivesTheSphereOfThePapersRefit) {
  Random random(2);
  for (const test::Shape& shape : make_shapes(random)) {
    const SkinnedMesh mesh = test::checked_mesh(shape);
    const SphereModel model = build_sphere_model(mesh);
    const Palette palette =
        test::checked_palette(mesh, make_palette(random, mesh.joint_count, Motion::rigid, 1));
    Refit refit(model, mesh.joint_count);
    for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
      const CountedSphere expected = refit_as_written(model, n, palette).sphere;
      const Float4 sphere = refit.sphere(n, palette);
      const double room = test::rounding_room(model, palette, expected.radius.value);
      for (std::size_t axis = 0; axis < 3; ++axis)
        ASSERT_NEAR(sphere[static_cast<int>(axis)], expected.centre[axis].value, room);
      ASSERT_GE(sphere[3], expected.radius.value);
      ASSERT_LE(sphere[3], expected.radius.value + room);
    }
  }
}

}  // namespace
}  // namespace pelt::paper
