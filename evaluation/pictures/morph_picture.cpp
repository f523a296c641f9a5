/// A face at rest and with three expressions; the displaced triangles are highlighted.

#include "evaluation/pictures/frame.hpp"
#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"

namespace pelt::pictures {
namespace {

constexpr std::string_view kScene = R"({
  "models": {"f": {"face": {"triangles": 24000, "seed": 1}}},
  "instances": [
    {"model": "f", "translation": [-1.35, 0, 0]},
    {"model": "f", "translation": [-0.45, 0, 0], "morph_weights": {"jaw_open": 1}},
    {"model": "f", "translation": [0.45, 0, 0], "morph_weights": {"smile": 1, "brows_up": 1}},
    {"model": "f", "translation": [1.35, 0, 0],
     "morph_weights": {"blink_l": 1, "blink_r": 1, "cheeks_puffed": 1}}
  ]})";

/// Marks the triangles of an instance that have a vertex at another position, relative to the
/// instance, than in the first instance.
std::vector<bool> displaced(const Actor& actor, const Actor& at_rest, float shift) {
  std::vector<bool> moved;
  for (const Triangle& triangle : actor.posed.triangles) {
    bool any = false;
    for (const std::uint32_t v : triangle) {
      const Vec3d way = Vec3d(actor.posed.positions[v]) - Vec3d(at_rest.posed.positions[v]) -
                        Vec3d(Vec3{shift, 0, 0});
      any |= squared_length(way) > 1e-6;
    }
    moved.push_back(any);
  }
  return moved;
}

}  // namespace

Picture morph_picture() {
  Cast cast(kScene, 0);
  std::string objects = "#declare Glow = texture {" + paint({0.80F, 0.50F, 0.12F}) + "}\n";
  for (std::size_t i = 0; i < cast.actors.size(); ++i)
    objects += painted(cast.actors[i], paint({0.26F, 0.40F, 0.55F}),
                       displaced(cast.actors[i], cast.actors[0], 0.9f * static_cast<float>(i)));
  return framed("morphs", {{0.5, 0.85, 4.2}, {0.08, 0.25, 0}, 45, 2.9}, objects);
}

}  // namespace pelt::pictures
