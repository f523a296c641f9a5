#include "support/skinned_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

void append_influences(Shape& shape, std::vector<std::pair<std::uint32_t, double>> influences) {
  double sum = 0;
  for (const auto& influence : influences) sum += influence.second;
  influences.resize(shape.influences_per_vertex, {0, 0.0});
  for (const auto& [joint, weight] : influences) {
    shape.joints.push_back(static_cast<std::uint16_t>(joint));
    shape.weights.push_back(static_cast<float>(weight / sum));
  }
}

/// A vertex at height `y` of a limb of unit length between the joints at k / (joint_count - 1).
void append_limb_influences(Shape& shape, double y) {
  std::vector<std::pair<std::uint32_t, double>> influences;
  const double at = y * (shape.joint_count - 1);
  for (std::uint32_t j = 0; j < shape.joint_count && influences.size() < 4; ++j) {
    const double near = 1.5 - std::fabs(at - j);
    if (near > 0) influences.emplace_back(j, near * near);
  }
  append_influences(shape, influences);
}

double random_weight(Random& random, Weights weights) {
  if (weights == Weights::random) return random.uniform(0.01, 1);
  switch (random.index(4)) {
    case 0:
      return 1;
    case 1:
      return 1e-7;
    case 2:
      return 1.0 / 3;
    default:
      return random.unit() + 1e-30;
  }
}

void append_random_influences(Shape& shape, Random& random, Weights weights) {
  std::uint32_t count = 1;
  if (weights != Weights::one_joint) count += random.index(shape.influences_per_vertex);
  std::vector<std::pair<std::uint32_t, double>> influences;
  for (std::uint32_t k = 0; k < count; ++k)
    influences.emplace_back(random.index(shape.joint_count), random_weight(random, weights));
  append_influences(shape, influences);
}

/// Replaces the linear part of `m` by L times it.
Matrix4 linear_times(const double (&l)[3][3], const Matrix4& m) {
  Matrix4 product = m;
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t row = 0; row < 3; ++row) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += l[row][k] * static_cast<double>(m.m[4 * column + k]);
      product.m[4 * column + row] = static_cast<float>(sum);
    }
  return product;
}

Matrix4 random_joint(Random& random, Motion motion, double spread) {
  const double far = motion == Motion::far_away ? 1e5 : 0;
  Vec3 translation = random.point(spread);
  translation.x += static_cast<float>(far);
  Matrix4 joint = rotation_about(random.point(1), random.uniform(0, 2 * kPi), {}, translation);
  if (motion == Motion::affine) {
    double l[3][3];
    for (auto& row : l)
      for (double& entry : row) entry = random.uniform(-2, 2);
    joint = linear_times(l, joint);
  } else if (motion == Motion::collapsed) {
    const double l[3][3] = {{1, 0, 0}, {0, random.chance(0.5) ? 1.0 : 0.0, 0}, {0, 0, 0}};
    joint = linear_times(l, joint);
    if (random.chance(0.5)) joint.m[14] = 0;
  }
  return joint;
}

}  // namespace

SkinnedMeshView Shape::view() const {
  return {.rest_positions = rest_positions,
          .triangles = triangles,
          .influences_per_vertex = influences_per_vertex,
          .joints = joints,
          .weights = weights,
          .joint_count = joint_count,
          .morph_targets = {morph_begin, morph_vertices, morph_displacements}};
}

Shape make_limb(std::uint32_t rings, std::uint32_t sides, std::uint32_t joint_count) {
  Shape shape;
  shape.joint_count = joint_count;
  const auto add_vertex = [&](double x, double y, double z) {
    shape.rest_positions.push_back(
        {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    append_limb_influences(shape, y);
  };
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t s = 0; s < sides; ++s) {
      const double y = static_cast<double>(r) / (rings - 1);
      const double angle = 2 * kPi * s / sides;
      const double radius = 0.1 * std::sqrt(1 - 0.7 * (2 * y - 1) * (2 * y - 1));
      add_vertex(radius * std::cos(angle), y, radius * std::sin(angle));
    }
  const auto at = [&](std::uint32_t r, std::uint32_t s) { return r * sides + s % sides; };
  for (std::uint32_t r = 0; r + 1 < rings; ++r)
    for (std::uint32_t s = 0; s < sides; ++s) {
      shape.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
      shape.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
  for (std::uint32_t s = 1; s + 1 < sides; ++s) {
    shape.triangles.push_back({at(0, 0), at(0, s), at(0, s + 1)});
    shape.triangles.push_back({at(rings - 1, 0), at(rings - 1, s + 1), at(rings - 1, s)});
  }
  return shape;
}

Shape make_soup(Random& random, std::uint32_t triangle_count, std::uint32_t joint_count,
                std::uint32_t influences_per_vertex, Weights weights) {
  Shape shape;
  shape.joint_count = joint_count;
  shape.influences_per_vertex = influences_per_vertex;
  for (std::uint32_t t = 0; t < triangle_count; ++t) {
    const Vec3 centre = random.point(1);
    const auto first = static_cast<std::uint32_t>(shape.rest_positions.size());
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3 offset = random.point(0.2);
      shape.rest_positions.push_back(
          {centre.x + offset.x, centre.y + offset.y, centre.z + offset.z});
      append_random_influences(shape, random, weights);
    }
    Triangle triangle = {first, first + 1, first + 2};
    if (first > 0 && random.chance(0.3)) triangle[2] = random.index(first);
    if (t % 16 == 15) triangle[1] = triangle[0];
    shape.triangles.push_back(triangle);
  }
  return shape;
}

void add_morph_targets(Random& random, Shape& shape, std::uint32_t count, double share,
                       double size) {
  const auto vertices = static_cast<std::uint32_t>(shape.rest_positions.size());
  if (shape.morph_begin.empty()) shape.morph_begin.push_back(0);
  for (std::uint32_t m = 0; m < count; ++m) {
    const bool is_run = random.chance(0.5);
    const double first = random.uniform(0, 1 - share) * vertices;
    for (std::uint32_t v = 0; v < vertices; ++v)
      if (is_run ? v >= first && v <= first + share * vertices : random.chance(share)) {
        shape.morph_vertices.push_back(v);
        shape.morph_displacements.push_back(random.point(size));
      }
    shape.morph_begin.push_back(static_cast<std::uint32_t>(shape.morph_vertices.size()));
  }
}

Shape make_morphing_limb(std::uint32_t rings, std::uint32_t sides, std::uint32_t joint_count) {
  Shape shape = make_limb(rings, sides, joint_count);
  shape.morph_begin = {0};
  const auto add_target = [&](const Vec3& by, const auto& has) {
    for (std::uint32_t v = 0; v < shape.rest_positions.size(); ++v)
      if (has(v)) {
        shape.morph_vertices.push_back(v);
        shape.morph_displacements.push_back(by);
      }
    shape.morph_begin.push_back(static_cast<std::uint32_t>(shape.morph_vertices.size()));
  };
  add_target({0.1f, 0, 0.05f}, [&](std::uint32_t v) { return shape.rest_positions[v].y < 0.2f; });
  add_target({0, 0.02f, -0.1f}, [&](std::uint32_t v) { return shape.rest_positions[v].y > 0.8f; });
  add_target({0.01f, 0.01f, 0}, [](std::uint32_t v) { return v % 3 == 0; });
  return shape;
}

std::vector<float> make_morph_weights(Random& random, std::uint32_t count, Morphing morphing) {
  std::vector<float> weights(count);
  if (morphing == Morphing::none || count == 0) return weights;
  if (morphing == Morphing::one) {
    weights[random.index(count)] = random.uniformf(0.5, 1);
    return weights;
  }
  for (std::uint32_t m = 0; m < count; ++m) {
    float& weight = weights[m];
    if (morphing == Morphing::some) weight = random.chance(0.3) ? random.uniformf(0, 1) : 0;
    if (morphing == Morphing::all) weight = random.uniformf(-1, 2);
    if (morphing == Morphing::huge) weight = random.uniformf(-1e4, 1e4);
    if (morphing == Morphing::cancelling)
      weight = m % 2 == 0 ? random.uniformf(1, 1e4) : -weights[m - 1] * 0.999f;
  }
  return weights;
}

std::vector<Matrix4> make_palette(Random& random, std::uint32_t joint_count, Motion motion,
                                  double spread) {
  std::vector<Matrix4> palette;
  for (std::uint32_t j = 0; j < joint_count; ++j)
    palette.push_back(random_joint(random, motion, spread));
  return palette;
}

std::vector<Matrix4> bend_limb(Random& random, std::uint32_t joint_count, double angle,
                               const Vec3& placement) {
  const Vec3 axis = random.point(1);
  std::vector<Matrix4> palette;
  for (std::uint32_t j = 0; j < joint_count; ++j) {
    const float y = static_cast<float>(j) / static_cast<float>(std::max(1u, joint_count - 1));
    palette.push_back(rotation_about(axis, angle * j, {0, y, 0}, placement));
  }
  return palette;
}

Matrix4 rotation_about(const Vec3& axis, double angle, const Vec3& centre,
                       const Vec3& translation) {
  const double length = std::sqrt(static_cast<double>(axis.x) * static_cast<double>(axis.x) +
                                  static_cast<double>(axis.y) * static_cast<double>(axis.y) +
                                  static_cast<double>(axis.z) * static_cast<double>(axis.z));
  const double n[3] = {static_cast<double>(axis.x) / length, static_cast<double>(axis.y) / length,
                       static_cast<double>(axis.z) / length};
  const double c = std::cos(angle), s = std::sin(angle);
  const double r[3][3] = {{c + n[0] * n[0] * (1 - c), n[0] * n[1] * (1 - c) - n[2] * s,
                           n[0] * n[2] * (1 - c) + n[1] * s},
                          {n[1] * n[0] * (1 - c) + n[2] * s, c + n[1] * n[1] * (1 - c),
                           n[1] * n[2] * (1 - c) - n[0] * s},
                          {n[2] * n[0] * (1 - c) - n[1] * s, n[2] * n[1] * (1 - c) + n[0] * s,
                           c + n[2] * n[2] * (1 - c)}};
  const double p[3] = {static_cast<double>(centre.x), static_cast<double>(centre.y),
                       static_cast<double>(centre.z)};
  const double t[3] = {static_cast<double>(translation.x), static_cast<double>(translation.y),
                       static_cast<double>(translation.z)};
  Matrix4 m;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column)
      m.m[4 * column + row] = static_cast<float>(r[row][column]);
    m.m[12 + row] = static_cast<float>(p[row] + t[row] -
                                       (r[row][0] * p[0] + r[row][1] * p[1] + r[row][2] * p[2]));
  }
  return m;
}

}  // namespace pelt::test
