#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"
#include "scenes/creature.hpp"
#include "scenes/demo.hpp"

#include <cmath>
#include <cstdlib>
#include <string_view>

namespace pelt::pictures {
namespace {

// A face at rest and with three expressions; the displaced triangles are highlighted.

constexpr std::string_view kMorphScene = R"({
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
  Cast cast(kMorphScene, 0);
  std::string objects = "#declare Glow = texture {" + paint({0.80F, 0.50F, 0.12F}) + "}\n";
  for (std::size_t i = 0; i < cast.actors.size(); ++i)
    objects += painted(cast.actors[i], paint({0.26F, 0.40F, 0.55F}),
                       displaced(cast.actors[i], cast.actors[0], 0.9f * static_cast<float>(i)));
  return framed("morphs", {{0.5, 0.85, 4.2}, {0.08, 0.25, 0}, 45, 2.9}, objects);
}

namespace {

// An arm at rest, and with its forearm twisted by nearly half a turn: with linear blend skinning,
// and with dual quaternions. Stripes that are straight at rest show the twist.

constexpr double kTurns = 0.47;
constexpr int kStripes = 9;

Vec3d rest_place(const asset::Asset& asset, std::string_view name) {
  for (std::uint32_t j = 0; j < asset.joints.size(); ++j)
    if (asset.joint_name(j) == name) {
      const auto& m = asset.joints[j].inverse_bind.m;
      return {-double{m[12]}, -double{m[13]}, -double{m[14]}};
    }
  std::abort();
}

Vec3d unit(const Vec3d& v) { return 1 / std::sqrt(squared_length(v)) * v; }

/// Coordinates with the elbow at the origin and the forearm along x.
class ArmFrame {
 public:
  explicit ArmFrame(const asset::Asset& asset)
      : elbow_(rest_place(asset, "fore_arm_l")),
        x_(unit(rest_place(asset, "hand_l") - elbow_)),
        y_(unit(cross(Vec3d(0, 0, 1), x_))),
        z_(cross(x_, y_)) {}

  Vec3d operator()(const Vec3& p) const {
    const Vec3d v = Vec3d(p) - elbow_;
    return {dot(v, x_), dot(v, y_), dot(v, z_)};
  }

 private:
  Vec3d elbow_, x_, y_, z_;
};

/// Whether a place is between the upper arm and the tips of the fingers, without the chest.
bool is_of_arm(const Vec3d& p) {
  const double radius = p.x < 0 ? 0.1 : 0.15;
  return p.x > -0.11 && p.y * p.y + p.z * p.z < radius * radius;
}

/// The triangles of the arm, and whether each is in a stripe.
struct Arm {
  explicit Arm(const asset::Asset& asset) : frame(asset) {
    for (const Triangle& t : asset.triangles) {
      Vec3d middle;
      bool is_inside = true;
      for (const std::uint32_t v : t) {
        const Vec3d corner = frame(asset.rest_positions[v]);
        is_inside &= is_of_arm(corner);
        middle = middle + corner;
      }
      if (!is_inside) continue;
      triangles.push_back(t);
      const double turns = std::atan2(middle.y, middle.z) / (2 * 3.14159265358979323846) + 1;
      in_stripe.push_back(static_cast<int>(turns * 2 * kStripes) % 2 == 0);
    }
  }

  ArmFrame frame;
  std::vector<Triangle> triangles;
  std::vector<bool> in_stripe;
};

/// Draws the arm at this height.
std::string drawn_arm(const asset::Asset& asset, const Arm& arm, Skinning skinning, double turns,
                      double height) {
  const auto model = build_model(asset.mesh(), {.skinning = skinning});
  if (!model) std::abort();
  Actor actor = {Pose(*model), {"arm", {}, arm.triangles}};
  if (!actor.pose.set_palette(scenes::twisted_arm(asset, turns))) std::abort();
  actor.posed.positions.resize(asset.rest_positions.size());
  posed_vertices(actor.pose, actor.posed.positions);
  for (Vec3& v : actor.posed.positions) v = to_float(arm.frame(v) + Vec3d(0, height, 0));
  return painted(actor, paint({0.26F, 0.40F, 0.55F}), arm.in_stripe);
}

}  // namespace

Picture skinning_picture() {
  const asset::Asset asset = *scenes::make_creature({300000, 27, 6});
  const Arm arm(asset);
  std::string objects = "#declare Glow = texture {" + paint({0.80F, 0.50F, 0.12F}) + "}\n";
  objects += drawn_arm(asset, arm, Skinning::linear, 0, 1.165);
  objects += drawn_arm(asset, arm, Skinning::linear, kTurns, 1.0);
  objects += drawn_arm(asset, arm, Skinning::dual_quaternion, kTurns, 0.835);
  return framed("skinning", {{0.22, 1, 3}, {0.22, 1, 0}, 15.2, 1.6}, objects);
}

}  // namespace pelt::pictures
