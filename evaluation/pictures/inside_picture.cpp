/// The vertex of one creature that is deepest in another, and the segment to the nearest surface
/// point.

#include "evaluation/pictures/frame.hpp"
#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"

#include <pelt/inside.hpp>

namespace pelt::pictures {
namespace {

constexpr std::string_view kScene = R"({
  "models": {"a": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}},
             "b": {"creature": {"triangles": 24000, "joints": 56, "seed": 2}}},
  "instances": [
    {"model": "a", "clip": "walk", "start": 0.3, "translation": [0.05, 0, -0.32]},
    {"model": "b", "clip": "idle", "translation": [0, 0, 0.22], "rotation": [0, 1, 0, 0]}
  ]})";

}  // namespace

Picture inside_picture() {
  Cast cast(kScene, 0);
  Actor &a = cast.actors[0], &b = cast.actors[1];
  Scratch scratch;
  Penetration deepest;
  deepest_vertex(a.pose, b.pose, scratch, deepest);
  const Vec3d vertex(deepest.position), surface(deepest.closest.position);
  const std::string objects = unshadowed(painted(a, glass({0.26F, 0.40F, 0.55F}, 0.35), {})) +
                              unshadowed(painted(b, glass({0.66F, 0.57F, 0.42F}, 0.45), {})) +
                              line(vertex, surface, 0.010, Tone::answer) +
                              dot_at(vertex, 0.022, Tone::answer) +
                              dot_at(surface, 0.022, Tone::answer);
  return framed("inside", {{-3.0, 1.75, 0.5}, {0, 1.32, -0.03}, 34, 16. / 9}, objects);
}

}  // namespace pelt::pictures
