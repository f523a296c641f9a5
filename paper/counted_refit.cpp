#include "paper/counted_refit.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace pelt::paper {
namespace {

/// A number whose every operation counts as a flop, also operations with constants.
struct Counted {
  double value = 0;
  int* flops = nullptr;
};

Counted counted(Counted operand, double value) {
  ++*operand.flops;
  return {value, operand.flops};
}

Counted operator+(Counted a, Counted b) { return counted(a, a.value + b.value); }
Counted operator-(Counted a, Counted b) { return counted(a, a.value - b.value); }
Counted operator*(Counted a, Counted b) { return counted(a, a.value * b.value); }
Counted operator+(Counted a, double b) { return counted(a, a.value + b); }
Counted operator*(double a, Counted b) { return counted(b, a * b.value); }
bool operator>(Counted a, Counted b) { return counted(a, a.value - b.value).value > 0; }
Counted root(Counted a) { return counted(a, std::sqrt(a.value)); }
Counted larger(Counted a, Counted b) {
  const bool first = a > b;
  return counted(a, (first ? a : b).value);  // the selection
}

struct CountedSphere {
  std::array<Counted, 3> centre;
  Counted radius;
};

CountedSphere counted_sphere(const Sphere& sphere, int& flops) {
  const auto number = [&](float value) { return Counted{static_cast<double>(value), &flops}; };
  const Vec3& c = sphere.centre;
  return {{number(c.x), number(c.y), number(c.z)}, number(sphere.radius)};
}

/// C_j S: transforms the centre and copies the radius. 18 flops.
CountedSphere transformed(const Matrix4& c, const CountedSphere& s) {
  const auto entry = [&](std::size_t i) { return static_cast<double>(c.m[i]); };
  CountedSphere image = s;
  for (std::size_t row = 0; row < 3; ++row)
    image.centre[row] = entry(row) * s.centre[0] + entry(4 + row) * s.centre[1] +
                        entry(8 + row) * s.centre[2] + entry(12 + row);
  return image;
}

/// R_a of eq. 5: four coordinates of p products and p - 1 sums each, 8 p - 4 flops.
CountedSphere blend(const float* corner, const std::vector<CountedSphere>& images) {
  const auto weight = [&](std::size_t j) { return static_cast<double>(corner[j]); };
  const auto blend_coordinate = [&](auto coordinate) {
    Counted sum = weight(0) * coordinate(images[0]);
    for (std::size_t j = 1; j < images.size(); ++j) sum = sum + weight(j) * coordinate(images[j]);
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

/// Encloses the spheres by a ball around the average of their centres: 3 (m - 1) sums and 3
/// products (1 / m is a constant); m distances; m - 1 comparisons and as many selections: 15 m - 2
/// flops.
CountedSphere enclose(const std::vector<CountedSphere>& spheres) {
  std::array<Counted, 3> centre = spheres[0].centre;
  const double share = 1 / static_cast<double>(spheres.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t a = 1; a < spheres.size(); ++a)
      centre[axis] = centre[axis] + spheres[a].centre[axis];
    centre[axis] = share * centre[axis];
  }
  Counted radius = reach(spheres[0], centre);
  for (std::size_t a = 1; a < spheres.size(); ++a)
    radius = larger(radius, reach(spheres[a], centre));
  return {centre, radius};
}

}  // namespace

CountedRefit counted_refit(const SphereModel& model, std::uint32_t node, const Palette& palette) {
  int flops = 0;
  const auto taken_flops = [&] { return std::exchange(flops, 0); };
  const WeightBounds& bounds = model.bounds;
  const CountedSphere rest = counted_sphere(model.tree.nodes[node].rest, flops);
  CountedRefit result;
  std::vector<CountedSphere> blended;
  for (const JointSet& set : bounds.sets_of(node)) {
    std::vector<CountedSphere> images;
    for (std::uint32_t j = 0; j < set.joint_count; ++j)
      images.push_back(transformed(palette[bounds.joints[set.first_joint + j]], rest));
    result.flops.transforms += taken_flops();
    for (std::uint32_t a = 0; a < set.corner_count; ++a)
      blended.push_back(blend(
          bounds.corners.data() + set.first_corner + std::size_t{a} * set.joint_count, images));
    result.flops.blends += taken_flops();
  }
  const CountedSphere sphere = enclose(blended);
  result.flops.enclosing = taken_flops();
  for (std::size_t axis = 0; axis < 3; ++axis) result.centre[axis] = sphere.centre[axis].value;
  result.radius = sphere.radius.value;
  return result;
}

RefitFlops stated_flops(std::span<const JointSet> sets) {
  RefitFlops sum;
  for (const JointSet& set : sets) {
    const int p = set.joint_count, m = set.corner_count;
    sum.transforms += 18 * p;
    sum.blends += 8 * p * m - 4 * m;
    sum.enclosing += 15 * m - 2;
  }
  return sum;
}

}  // namespace pelt::paper
