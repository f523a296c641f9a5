#pragma once

#include <pelt/inside.hpp>

#include "support/closed_shapes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pelt::test {

/// A closed surface that a palette poses.
struct Body {
  explicit Body(const Shape& s) : shape(s), pose(*build_model(s.view())) {}

  void set(const std::vector<Matrix4>& palette) { ASSERT_TRUE(pose.set_palette(palette)); }
  void move(const Vec3& by) { set({rotation_about({0, 0, 1}, 0, {0, 0, 0}, by)}); }

  std::vector<Vec3> posed() const {
    std::vector<Vec3> positions(shape.rest_positions.size());
    posed_vertices(pose, positions);
    return positions;
  }

  Shape shape;
  Pose pose;
};

inline Volume volume_of(Body& body) {
  Volume result;
  volume(body.pose, result);
  return result;
}

inline Volume intersection_of(Body& a, Body& b) {
  Scratch scratch;
  Volume result;
  intersection_volume(a.pose, b.pose, scratch, result);
  return result;
}

inline Volume self_intersection_of(Body& body) {
  Scratch scratch;
  Volume result;
  self_intersection_volume(body.pose, scratch, result);
  return result;
}

}  // namespace pelt::test
