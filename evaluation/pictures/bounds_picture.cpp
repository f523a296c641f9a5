/// Left: the guaranteed box and the exact box. Right: the exact boxes of the vertices of each
/// joint.

#include "evaluation/pictures/frame.hpp"
#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"

#include <pelt/bounds.hpp>

namespace pelt::pictures {
namespace {

constexpr std::string_view kScene = R"({
  "models": {"c": {"creature": {"triangles": 24000, "joints": 27, "seed": 1}}},
  "instances": [
    {"model": "c", "clip": "walk", "start": 0.62, "translation": [0, 0, -0.95]},
    {"model": "c", "clip": "walk", "start": 0.62, "translation": [0, 0, 1.15]}
  ]})";

std::string boxes_of_joints(const Actor& actor) {
  const VertexGroups groups = group_by_joint(actor.pose.model());
  std::string text;
  for (std::uint32_t g = 0; g < groups.count(); ++g)
    if (groups.vertex_count(g) > 0) {
      Box box;
      exact_group_bounds(actor.pose, groups, g, box);
      text += edges(box, 0.003, Tone::question);
    }
  return text;
}

}  // namespace

Picture bounds_picture() {
  Cast cast(kScene, 0);
  Actor &whole = cast.actors[0], &by_joint = cast.actors[1];
  std::string objects = painted(whole, 0) + painted(by_joint, 0);
  Bounds guaranteed, exact;
  bounds(whole.pose, guaranteed);
  exact_bounds(whole.pose, exact);
  objects += edges(guaranteed.box, 0.0045, Tone::quiet);
  objects += edges(exact.box, 0.007, Tone::question);
  objects += boxes_of_joints(by_joint);
  return framed("bounds", {{-5.4, 1.7, 0.9}, {0, 0.86, -0.08}, 43, 16. / 9}, objects);
}

}  // namespace pelt::pictures
