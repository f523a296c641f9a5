/// The same twisted forearm with linear blend skinning and with dual quaternions; the forearm is
/// highlighted.

#include "evaluation/pictures/frame.hpp"
#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"
#include "scenes/creature.hpp"
#include "scenes/twisted_arm.hpp"

#include <cstdlib>

namespace pelt::pictures {
namespace {

constexpr std::string_view kScene = R"({
  "models": {"c": {"creature": {"triangles": 60000, "joints": 27, "seed": 6}}},
  "instances": [{"model": "c"}]})";

/// Poses the only actor of the cast, moved along x.
void twist(Actor& actor, const asset::Asset& asset, Skinning skinning, float shift) {
  const auto model = build_model(asset.mesh(), {.skinning = skinning});
  if (!model) std::abort();
  actor.pose = Pose(*model);
  if (!actor.pose.set_palette(scenes::twisted_arm(asset, 0.47))) std::abort();
  posed_vertices(actor.pose, actor.posed.positions);
  for (Vec3& v : actor.posed.positions) v.x += shift;
}

/// Marks the triangles of which all vertices move.
std::vector<bool> twisted(const asset::Asset& asset, const Actor& actor, float shift) {
  std::vector<bool> marked;
  for (const Triangle& triangle : asset.triangles) {
    bool all = true;
    for (const std::uint32_t v : triangle) {
      const Vec3d rest(asset.rest_positions[v]), now(actor.posed.positions[v]);
      all &= squared_length(now - rest - Vec3d(Vec3{shift, 0, 0})) > 1e-7;
    }
    marked.push_back(all);
  }
  return marked;
}

}  // namespace

Picture skinning_picture() {
  const asset::Asset asset = *scenes::make_creature({60000, 27, 6});
  std::string objects = "#declare Glow = texture {" + paint({0.80F, 0.50F, 0.12F}) + "}\n";
  for (const bool is_dual : {false, true}) {
    Cast cast(kScene, 0);
    const float shift = is_dual ? 0.28f : -0.28f;
    Actor& actor = cast.actors[0];
    twist(actor, asset, is_dual ? Skinning::dual_quaternion : Skinning::linear, shift);
    objects += painted(actor, paint({0.26F, 0.40F, 0.55F}), twisted(asset, actor, shift));
  }
  return framed("skinning", {{0.5, 1.25, 3.2}, {0.42, 1.05, 0}, 17, 2.2}, objects);
}

}  // namespace pelt::pictures
