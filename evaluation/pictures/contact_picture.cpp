/// The curves in which two creatures intersect, and the normal of each patch.

#include "evaluation/pictures/frame.hpp"
#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"

#include <pelt/collide.hpp>
#include <pelt/surface.hpp>

namespace pelt::pictures {
namespace {

constexpr std::string_view kScene = R"({
  "models": {"a": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}},
             "b": {"creature": {"triangles": 24000, "joints": 56, "seed": 2}}},
  "instances": [
    {"model": "a", "clip": "walk", "start": 1.3, "translation": [-0.1, 0, -0.19]},
    {"model": "b", "clip": "walk", "start": 1.95, "translation": [0.1, 0, 0.19],
     "rotation": [0, 1, 0, 0]}
  ]})";

std::string curves(const ContactGeometry& geometry) {
  std::string text;
  for (const ContactTrace& trace : geometry.traces)
    if (trace.kind == ContactKind::segment)
      text += line(Vec3d(trace.from), Vec3d(trace.to), 0.009, Tone::answer) +
              dot_at(Vec3d(trace.from), 0.009, Tone::answer) +
              dot_at(Vec3d(trace.to), 0.009, Tone::answer);
  return text;
}

}  // namespace

Picture contact_picture() {
  Cast cast(kScene, 0);
  Actor &a = cast.actors[0], &b = cast.actors[1];
  Scratch scratch;
  std::vector<Contact> contacts;
  collide(a.pose, b.pose, scratch, contacts);
  ContactGeometry geometry;
  describe_contacts(a.pose, b.pose, contacts, scratch, geometry);
  std::string objects = unshadowed(painted(a, glass({0.26F, 0.40F, 0.55F}, 0.45), {})) +
                        painted(b, 1) + curves(geometry);
  for (const ContactPatch& patch : geometry.patches)
    objects += arrow(Vec3d(patch.point), Vec3d(patch.point) + 0.35 * Vec3d(patch.normal), 0.011,
                     Tone::question);
  return framed("contact", {{-4.3, 1.45, -0.9}, {0, 0.87, 0}, 44, 16. / 9}, objects);
}

}  // namespace pelt::pictures
