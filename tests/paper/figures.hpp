#pragma once

/// Figures 2 and 3 of Kavan & Zara 2005 as numbers, for the drawings in docs/figures and for the
/// test. Weights and intervals are from the paper. The paper gives no positions, so these are round
/// numbers in the plane z = 0.

#include "balls.hpp"

#include <array>
#include <vector>

namespace pelt::test {

/// A rotation in the plane about a point.
struct PlaneRotation {
  double cosine, sine;
  Vec3d about;

  Vec3d operator()(const Vec3d& v) const {
    const Vec3d d = v - about;
    return about + Vec3d(cosine * d.x - sine * d.y, sine * d.x + cosine * d.y, 0);
  }
  Ball operator()(const Ball& ball) const { return {(*this)(ball.centre), ball.radius}; }
};

/// Three vertices between two bones with a common start that diverge.
struct Figure2 {
  Ball sphere = {{0, 0, 0}, 1};
  std::array<Vec3d, 3> vertices = {Vec3d(-0.8, 0.6, 0), Vec3d(0, -1, 0), Vec3d(0.8, 0.6, 0)};
  std::array<std::array<double, 2>, 3> weights = {{{0.6, 0.4}, {0.5, 0.5}, {0.4, 0.6}}};
  Vec3d pivot = {0, -2.5, 0};
  std::array<PlaneRotation, 2> joints = {PlaneRotation{0.8, 0.6, pivot},
                                         PlaneRotation{0.8, -0.6, pivot}};

  Vec3d image(std::size_t joint, std::size_t vertex) const {
    return joints[joint](vertices[vertex]);
  }
  /// w C_j1 v_i + (1 - w) C_j2 v_i, a point of the line L_i.
  Vec3d blended(std::size_t vertex, double w) const {
    return w * image(0, vertex) + (1 - w) * image(1, vertex);
  }
  Vec3d posed(std::size_t vertex) const { return blended(vertex, weights[vertex][0]); }

  std::vector<paper::WeightInterval> intervals() const {
    std::vector<paper::WeightInterval> smallest(2);
    for (const auto& w : weights)
      for (std::size_t j = 0; j < 2; ++j) smallest[j].include(w[j]);
    return smallest;
  }
  /// BV_1 is the convex hull of these balls.
  std::vector<Ball> images_of_sphere() const { return {joints[0](sphere), joints[1](sphere)}; }
  /// BV_2 is the convex hull of these balls.
  std::vector<Ball> corners() const { return corner_balls(intervals(), images_of_sphere()); }
};

struct Figure3 {
  std::vector<Ball> spheres = {{{0, 3, 0}, 1}, {{-2.5, -1, 0}, 1}, {{2.5, -1, 0}, 1}};
  std::vector<paper::WeightInterval> intervals = {{0, 0.6}, {0, 1}, {0, 1}};

  /// R_1 ... R_4; their convex hull is CH_2.
  std::vector<Ball> corners() const { return corner_balls(intervals, spheres); }
};

}  // namespace pelt::test
