/// Pictures of contacts that the filters of self-collision keep and drop. They keep those of an arm
/// through the belly. They drop those of a belt that rests on the waist, and of a crease of the
/// skin. Triangles in contact glow.

#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

namespace pelt::pictures {
namespace {

using tools::scene::SelfRules;

scenes::Scene scene_of(std::string_view text) {
  Result<scenes::Scene> scene = scenes::parse_scene(text, {});
  if (!scene) std::abort();
  return std::move(*scene);
}

std::set<Contact> contacts_by(const scenes::Scene& scene, const SelfRules& rules) {
  const auto colliders =
      tools::scene::make_colliders(scene, tools::scene::Granularity::instance, {});
  if (!colliders) std::abort();
  auto filters = tools::scene::make_self_filters({scene, *colliders}, rules, {0, 1, 1});
  if (!filters) std::abort();
  auto query = tools::scene::SceneQuery::as_crowd(*colliders, 0,
                                                  {.pairs = false, .filters = std::move(*filters)});
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  tools::scene::sample_palettes(scene, 0, scratch, palettes);
  if (!query.set_palettes(palettes)) std::abort();
  tools::scene::FrameContacts found;
  query.collide({}, found);
  return {found.contacts.begin(), found.contacts.end()};
}

std::vector<bool> triangles_of(const scenes::Scene& scene, const std::set<Contact>& contacts) {
  std::vector<bool> touching(scene.characters[0].asset.triangles.size());
  for (const auto& [a, b] : contacts) touching[a] = touching[b] = true;
  return touching;
}

/// Contacts that `more` counts and `fewer` does not.
std::set<Contact> difference(const scenes::Scene& scene, const SelfRules& more,
                             const SelfRules& fewer) {
  std::set<Contact> contacts = contacts_by(scene, more);
  for (const Contact& contact : contacts_by(scene, fewer)) contacts.erase(contact);
  return contacts;
}

asset::Node& node_named(asset::Asset& asset, const std::string& name) {
  for (asset::Node& node : asset.nodes)
    if (node.name == name) return node;
  std::fprintf(stderr, "no node %s\n", name.c_str());
  std::exit(1);
}

/// Turns a joint about the z axis.
void turn(asset::Asset& asset, const std::string& joint, double degrees) {
  const double half = degrees * 3.14159265358979 / 360;
  node_named(asset, joint).local.rotation = {0, 0, static_cast<float>(std::sin(half)),
                                             static_cast<float>(std::cos(half))};
}

constexpr double kPi = 3.14159265358979;
constexpr std::uint32_t kAround = 64, kSides = 10;  // segments of a belt

/// The distance of the skin from the axis of the body at a height, for each segment.
std::vector<double> girth(const asset::Asset& asset, double height) {
  std::vector<double> distances(kAround, 0);
  for (const Vec3& p : asset.rest_positions) {
    const double distance = std::hypot(p.x, p.z);
    if (std::fabs(p.y - height) > 0.03 || distance > 0.3) continue;
    const double turns = std::atan2(p.z, p.x) / (2 * kPi) + 1;
    double& most = distances[static_cast<std::size_t>(turns * kAround + 0.5) % kAround];
    most = std::max(most, distance);
  }
  for (std::uint32_t i = 0; i < kAround; ++i)
    if (distances[i] == 0) distances[i] = distances[(i + kAround - 1) % kAround];
  return distances;
}

/// Adds a vertex that follows one joint.
void add_vertex(asset::Asset& asset, const Vec3& position, std::uint16_t joint) {
  asset.rest_positions.push_back(position);
  for (std::uint32_t k = 0; k < asset.influences_per_vertex; ++k) {
    asset.joint_indices.push_back(joint);
    asset.weights.push_back(k == 0 ? 1.0F : 0.0F);
  }
}

/// Adds a belt that is half sunk into the skin.
void add_belt(asset::Asset& asset, std::uint16_t joint, double height) {
  constexpr double kThickness = 0.022;
  const auto first = static_cast<std::uint32_t>(asset.rest_positions.size());
  const std::vector<double> distances = girth(asset, height);
  for (std::uint32_t i = 0; i < kAround; ++i)
    for (std::uint32_t s = 0; s < kSides; ++s) {
      const double around = 2 * kPi * i / kAround, side = 2 * kPi * s / kSides;
      const double distance = distances[i] + kThickness * std::cos(side);
      add_vertex(asset,
                 {static_cast<float>(distance * std::cos(around)),
                  static_cast<float>(height + 1.6 * kThickness * std::sin(side)),
                  static_cast<float>(distance * std::sin(around))},
                 joint);
    }
  const auto vertex = [&](std::uint32_t i, std::uint32_t s) {
    return first + i % kAround * kSides + s % kSides;
  };
  const auto triangles = static_cast<std::uint32_t>(asset.triangles.size());
  for (std::uint32_t i = 0; i < kAround; ++i)
    for (std::uint32_t s = 0; s < kSides; ++s) {
      asset.triangles.push_back({vertex(i, s), vertex(i, s + 1), vertex(i + 1, s)});
      asset.triangles.push_back({vertex(i + 1, s), vertex(i, s + 1), vertex(i + 1, s + 1)});
    }
  asset::Part belt;
  belt.node = belt.mesh = "belt";
  belt.first_triangle = triangles;
  belt.triangle_count = 2 * kAround * kSides;
  belt.skinned = true;
  asset.parts.push_back(belt);
}

std::uint16_t joint_named(const asset::Asset& asset, std::string_view name) {
  std::uint16_t joint = 0;
  while (asset.joint_name(joint) != name) ++joint;
  return joint;
}

Picture drawn(const char* id, scenes::Scene&& scene, const std::set<Contact>& contacts,
              const tools::picture::PovCamera& camera) {
  const std::vector<bool> touching = triangles_of(scene, contacts);
  const Cast cast(std::move(scene), 0);
  return framed(id, camera, painted(cast.actors[0], reproduce::skin_texture(0), touching));
}

/// Rings, whether contacts at rest are dropped, the share of poses, and near joints.
const SelfRules kNeighbours = {1, false, {}, false}, kAll = {5, false, {}, false},
                kMoving = {5, true, {}, false}, kPosed = {5, false, {}, true};

}  // namespace

Picture through_picture() {
  scenes::Scene scene = scene_of(R"({
    "models": {"a": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}}},
    "instances": [{"model": "a"}]})");
  asset::Asset& asset = scene.characters[0].asset;
  turn(asset, "upper_arm_l", -28);
  turn(asset, "fore_arm_l", -84);
  return drawn("through", std::move(scene), contacts_by(scene, kPosed),
               {{0.9, 1.2, 2.6}, {0, 0.87, 0}, 30, 16. / 9});
}

Picture resting_picture() {
  scenes::Scene scene = scene_of(R"({
    "models": {"a": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}}},
    "instances": [{"model": "a", "clip": "walk", "start": 0.3}]})");
  asset::Asset& asset = scene.characters[0].asset;
  add_belt(asset, joint_named(asset, "spine_1"), 0.8);
  return drawn("resting", std::move(scene), difference(scene, kAll, kMoving),
               {{0.8, 1.25, 2.4}, {0, 0.82, 0}, 24, 16. / 9});
}

Picture crease_picture() {
  scenes::Scene scene = scene_of(R"({
    "models": {"a": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}}},
    "instances": [{"model": "a"}]})");
  turn(scene.characters[0].asset, "fore_arm_l", 128);
  return drawn("crease", std::move(scene), difference(scene, kNeighbours, kPosed),
               {{0.55, 1.15, 1.5}, {0.36, 0.97, 0}, 24, 16. / 9});
}

}  // namespace pelt::pictures
