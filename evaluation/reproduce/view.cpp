#include "evaluation/reproduce/view.hpp"

#include <cmath>

namespace pelt::reproduce {

using detail::Vec3d;

namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

double length(const Vec3d& v) { return std::sqrt(squared_length(v)); }

Vec3d unit(const Vec3d& v) { return (1 / length(v)) * v; }

View::View(const tools::picture::PovCamera& camera)
    : ahead(unit(camera.at - camera.from)),
      right(unit(cross(ahead, Vec3d(0, 1, 0)))),
      up(cross(right, ahead)),
      from_(camera.from),
      width_(2 * std::tan(camera.angle * kPi / 360)),
      height_(width_ / camera.aspect) {}

double View::width_at(const Vec3d& place) const { return width_ * dot(place - from_, ahead); }

Vec3d View::seen_at(double x, double y, double depth) const {
  const double half = 0.5 * height_ * depth;
  return from_ + depth * ahead + (x * half) * right + (y * half) * up;
}

}  // namespace pelt::reproduce
