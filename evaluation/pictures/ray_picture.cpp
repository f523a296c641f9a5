/// A fan of rays, their first hits, and the normals there.

#include "evaluation/pictures/frame.hpp"
#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"

#include <pelt/ray.hpp>

namespace pelt::pictures {
namespace {

constexpr std::string_view kScene = R"({
  "models": {"c": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}}},
  "instances": [{"model": "c", "clip": "walk", "start": 0.2, "translation": [0, 0, 0.75]}]})";

}  // namespace

Picture ray_picture() {
  Cast cast(kScene, 0);
  Actor& actor = cast.actors[0];
  const Vec3 eye = {-0.45f, 1.2f, 2.55f};
  std::string objects = painted(actor, 0) + dot_at(Vec3d(eye), 0.035, Tone::question);
  for (int i = 0; i < 9; ++i) {
    const Vec3 aim = {-0.25f + 0.05f * static_cast<float>(i), 0.1f + 0.21f * static_cast<float>(i),
                      0.1f};
    const Ray ray = segment(eye, aim);
    RayHit hit;
    pelt::cast(actor.pose, ray, hit);
    const Vec3d direction(ray.direction);
    if (!hit) {
      objects += line(Vec3d(eye), Vec3d(eye) + 1.3 * direction, 0.004, Tone::quiet);
      continue;
    }
    const Vec3d place = Vec3d(eye) + static_cast<double>(hit.t) * direction;
    objects += line(Vec3d(eye), place, 0.006, Tone::question) + dot_at(place, 0.022, Tone::answer) +
               arrow(place, place + 0.2 * Vec3d(hit.normal), 0.007, Tone::answer);
  }
  return framed("ray", {{-4.4, 1.5, 1.6}, {0, 0.9, 1.2}, 42, 16. / 9}, objects);
}

}  // namespace pelt::pictures
