/// Two creatures with the segment between their closest points, and a point with its closest
/// surface point.

#include "evaluation/pictures/frame.hpp"
#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"

#include <pelt/distance.hpp>

namespace pelt::pictures {
namespace {

constexpr std::string_view kScene = R"({
  "models": {"a": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}},
             "b": {"creature": {"triangles": 24000, "joints": 56, "seed": 2}}},
  "instances": [
    {"model": "a", "clip": "walk", "start": 0.25, "translation": [0, 0, -0.8]},
    {"model": "b", "clip": "walk", "start": 0.75, "translation": [0.15, 0, 0.8],
     "rotation": [0, 1, 0, 0]}
  ]})";

/// A segment between two points, with a dot at each end.
std::string between(const Vec3d& from, const Vec3d& to) {
  return line(from, to, 0.010, Tone::answer) + dot_at(from, 0.026, Tone::answer) +
         dot_at(to, 0.026, Tone::answer);
}

}  // namespace

Picture distance_picture() {
  Cast cast(kScene, 0);
  Actor &a = cast.actors[0], &b = cast.actors[1];
  Scratch scratch;
  Distance between_them;
  distance(a.pose, b.pose, scratch, between_them);
  const Vec3 point = {-0.1f, 1.35f, 1.3f};
  ClosestPoint closest;
  closest_point(b.pose, point, scratch, closest);
  const std::string objects =
      painted(a, 0) + painted(b, 1) +
      between(Vec3d(between_them.a.position), Vec3d(between_them.b.position)) +
      line(Vec3d(point), Vec3d(closest.point.position), 0.007, Tone::question) +
      dot_at(Vec3d(point), 0.032, Tone::question) +
      dot_at(Vec3d(closest.point.position), 0.02, Tone::answer);
  return framed("distance", {{-4.2, 1.5, 0.4}, {0, 0.9, 0}, 44, 16. / 9}, objects);
}

}  // namespace pelt::pictures
