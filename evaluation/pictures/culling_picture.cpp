/// The frustum of a camera among creatures: inside, partly inside and outside.

#include "evaluation/pictures/frame.hpp"
#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"

#include <pelt/solid.hpp>

#include <array>
#include <cmath>
#include <span>

namespace pelt::pictures {
namespace {

/// A camera at the origin of its frame that looks along -z.
struct Eye {
  Vec3d place;
  double turn, half_width, half_height, near, far;  ///< radians about y; half sizes at depth 1

  Vec3d at(double x, double y, double depth) const {
    const double c = std::cos(turn), s = std::sin(turn);
    const double right = x * half_width * depth, up = y * half_height * depth;
    return place + Vec3d(c * right - s * depth, up, -s * right - c * depth);
  }

  Matrix4 view_projection() const {
    const double c = std::cos(turn), s = std::sin(turn);
    const double scale = (far + near) / (far - near), shift = 2 * far * near / (far - near);
    const Vec3d rows[4] = {(1 / half_width) * Vec3d(c, 0, -s), (1 / half_height) * Vec3d(0, 1, 0),
                           -scale * Vec3d(s, 0, c), -1.0 * Vec3d(s, 0, c)};
    Matrix4 matrix;
    for (int row = 0; row < 4; ++row) {
      const double last = -dot(rows[row], place) - (row == 2 ? shift : 0);
      const double numbers[] = {rows[row].x, rows[row].y, rows[row].z, last};
      for (int column = 0; column < 4; ++column)
        matrix.m[4 * column + row] = static_cast<float>(numbers[column]);
    }
    return matrix;
  }
};

std::string loop(std::span<const Vec3d> corners) {
  std::string text;
  for (std::size_t i = 0; i < corners.size(); ++i)
    text += line(corners[i], corners[(i + 1) % corners.size()], 0.012, Tone::question);
  return text;
}

/// The outline of the frustum down to the ground, where its lower face ends.
std::string outline(const Eye& eye) {
  const double landing = eye.place.y / eye.half_height;
  const auto on_ground = [&](double x, double depth) {
    return eye.at(x, -landing / depth, depth) + Vec3d(0, 0.01, 0);
  };
  std::string text = dot_at(eye.place, 0.07, Tone::question);
  for (const double x : {-1.0, 1.0}) {
    text += line(eye.place, eye.at(x, 1, eye.far), 0.012, Tone::question);
    text += line(eye.place, on_ground(x, landing), 0.012, Tone::question);
  }
  const double n = eye.near;
  text += loop(std::array{eye.at(-1, -1, n), eye.at(1, -1, n), eye.at(1, 1, n), eye.at(-1, 1, n)});
  text += loop(std::array{on_ground(-1, landing), on_ground(1, landing), on_ground(1, eye.far),
                          on_ground(-1, eye.far)});
  return text + loop(std::array{on_ground(-1, eye.far), on_ground(1, eye.far),
                                eye.at(1, 1, eye.far), eye.at(-1, 1, eye.far)});
}

std::string scene_text() {
  std::string instances;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 5; ++column) {
      const std::string place = "[" + std::to_string(1.35 * (column - 2) + 0.3 * (row % 2)) +
                                ", 0, " + std::to_string(1.45 * (1.5 - row)) + "]";
      instances += std::string(instances.empty() ? "" : ",") +
                   R"({"model": "c", "clip": "walk", "start": )" +
                   std::to_string(0.21 * (5 * row + column)) + R"(, "translation": )" + place +
                   R"(, "rotation": [0, )" + (column % 2 ? "0.6, 0, 0.8" : "0.28, 0, 0.96") + "]}";
    }
  return R"({"models": {"c": {"creature": {"triangles": 8000, "joints": 27, "seed": 2}}},
             "instances": [)" +
         instances + "]}";
}

}  // namespace

Picture culling_picture() {
  Cast cast(scene_text(), 0);
  const Eye eye = {{-1.2, 1.0, 5.4}, -0.2, 0.42, 0.36, 0.8, 7.6};
  const Region seen = make_frustum(eye.view_projection());
  Scratch scratch;
  std::string objects = outline(eye);
  for (Actor& actor : cast.actors) {
    Placement placement = Placement::outside;
    classify(actor.pose, seen, scratch, placement);
    switch (placement) {
      case Placement::outside:
        objects += painted(actor, paint({0.72F, 0.73F, 0.74F}), {});
        break;
      case Placement::partly:
        objects += painted(actor, paint({0.80F, 0.50F, 0.12F}), {});
        break;
      case Placement::inside:
        objects += painted(actor, paint({0.14F, 0.34F, 0.60F}), {});
        break;
    }
  }
  return framed("culling", {{3.6, 7.6, 11.4}, {-0.1, 0.35, 0.9}, 47, 16. / 9}, objects);
}

}  // namespace pelt::pictures
