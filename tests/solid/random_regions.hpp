#pragma once

#include "support/skinned_shapes.hpp"

#include <pelt/solid.hpp>

#include <array>
#include <cstddef>

namespace pelt::test {

/// Regions of all kinds near a position and of about a given size.
class RandomRegions {
 public:
  explicit RandomRegions(Random& random) : random_(random) {}

  Region next(const Vec3& about, double size) {
    about_ = about;
    size_ = size;
    switch (random_.index(6)) {
      case 0:
        return half_space();
      case 1:
        return box();
      case 2:
        return oriented_box();
      case 3:
        return polyhedron();
      case 4:
        return Sphere{point(), length()};
      default:
        return Capsule{point(), point(), length()};
    }
  }

 private:
  Vec3 point() {
    const Vec3 away = random_.point(size_);
    return {about_.x + away.x, about_.y + away.y, about_.z + away.z};
  }

  float length() { return random_.chance(0.1) ? 0 : random_.uniformf(0, size_); }

  HalfSpace half_space() {
    const Vec3 normal = random_.point(2), on_plane = point();
    return {normal, normal.x * on_plane.x + normal.y * on_plane.y + normal.z * on_plane.z};
  }

  Region box() {
    const Vec3 centre = point(), half = {length(), length(), length()};
    return Box{{centre.x - half.x, centre.y - half.y, centre.z - half.z},
               {centre.x + half.x, centre.y + half.y, centre.z + half.z}};
  }

  Region oriented_box() {
    const Matrix4 turn = rotation_about(random_.point(1), random_.uniform(0, 3), {}, {});
    OrientedBox box{point(), {}, {length(), length(), length()}};
    for (std::size_t i = 0; i < 3; ++i)
      box.axes[i] = {turn.m[4 * i], turn.m[4 * i + 1], turn.m[4 * i + 2]};
    return box;
  }

  Region polyhedron() {
    for (HalfSpace& face : faces_) {
      face = half_space();
      if (random_.chance(0.7)) face.offset += random_.uniformf(0, size_);
    }
    return ConvexPolyhedron{faces_};
  }

  Random& random_;
  Vec3 about_;
  double size_ = 0;
  std::array<HalfSpace, 8> faces_;  // of the last polyhedron
};

}  // namespace pelt::test
