/// --self-near-joints drops creases at a joint, and no contacts far from the joint.

#include "check_self.hpp"
#include "support/gltf_builder.hpp"
#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <cmath>

namespace pelt::test {
namespace {

constexpr int kRings = 200, kSides = 12;

/// An arm along x from -2 to 2, of radius 0.1, with the elbow at 0. The clips "bend" and "fold"
/// turn the forearm by 100 and 174 degrees in a second.
GltfBuilder build_arm() {
  std::vector<float> positions, weights;
  std::vector<std::uint16_t> joints;
  std::vector<std::uint32_t> indices;
  for (int ring = 0; ring <= kRings; ++ring)
    for (int side = 0; side < kSides; ++side) {
      const double angle = 6.283185307179586 * side / kSides;
      positions.insert(positions.end(), {static_cast<float>(4.0 * ring / kRings - 2),
                                         static_cast<float>(0.1 * std::cos(angle)),
                                         static_cast<float>(0.1 * std::sin(angle))});
      const std::uint16_t joint = 2 * ring > kRings ? 1 : 0;
      joints.insert(joints.end(), {joint, 0, 0, 0});
      weights.insert(weights.end(), {1, 0, 0, 0});
      if (ring == kRings) continue;
      const auto at = [&](int r, int s) {
        return static_cast<std::uint32_t>(r * kSides + s % kSides);
      };
      indices.insert(indices.end(), {at(ring, side), at(ring + 1, side), at(ring + 1, side + 1),
                                     at(ring, side), at(ring + 1, side + 1), at(ring, side + 1)});
    }
  GltfBuilder builder;
  const json attributes = {{"POSITION", builder.add_accessor(positions, "VEC3")},
                           {"JOINTS_0", builder.add_accessor(joints, "VEC4")},
                           {"WEIGHTS_0", builder.add_accessor(weights, "VEC4")}};
  const json primitive = {{"attributes", attributes},
                          {"indices", builder.add_accessor(indices, "SCALAR")}};
  builder.add("meshes", {{"primitives", {primitive}}});
  builder.add("nodes", {{"name", "upper arm"}, {"children", {1}}});
  builder.add("nodes", {{"name", "forearm"}});
  builder.add("nodes", {{"mesh", 0}, {"skin", 0}});
  builder.add("skins", {{"joints", {0, 1}}});
  builder.add("scenes", {{"nodes", {0, 2}}});
  const std::size_t times = builder.add_accessor(std::vector<float>{0, 1}, "SCALAR");
  for (const auto& [name, degrees] : {std::pair{"bend", 100}, std::pair{"fold", 174}}) {
    const double half = degrees * 3.141592653589793 / 360;
    const std::vector<float> turns = {
        0, 0, 0, 1, 0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))};
    const json sampler = {{"input", times}, {"output", builder.add_accessor(turns, "VEC4")}};
    const json channel = {{"sampler", 0}, {"target", {{"node", 1}, {"path", "rotation"}}}};
    builder.add("animations", {{"name", name}, {"channels", {channel}}, {"samplers", {sampler}}});
  }
  return builder;
}

/// The distance of a triangle from the elbow at rest.
double distance_from_elbow(std::uint32_t triangle) {
  const int ring = static_cast<int>(triangle) / (2 * kSides);
  return std::min(std::fabs(4.0 * ring / kRings - 2), std::fabs(4.0 * (ring + 1) / kRings - 2));
}

TEST(CheckSelfNearJoints, DropTheCreaseOfABentElbow) {
  const TestFolder folder;
  write_bytes(folder / "arm.glb", build_arm().glb());
  const Words bend = {"arm.glb", "--clip", "bend", "--frames", "0:31"};
  const CheckFile file = check_pairs(folder, 0, bend);
  EXPECT_GT(file.totals["totals"]["left_out"]["near_joints"], 10u);
  check_pairs(folder, 1, joined(bend, {"--self-near-joints", "keep"}));
}

TEST(CheckSelfNearJoints, KeepContactsFarFromTheElbow) {
  const TestFolder folder;
  write_bytes(folder / "arm.glb", build_arm().glb());
  for (const char* by : {"instance", "part"}) {
    const Words fold = {"arm.glb", "--clip", "fold", "--frames", "20:31", "--self", "--by", by};
    const CheckFile file = check_pairs(folder, 1, fold);
    EXPECT_GT(file.totals["totals"]["left_out"]["near_joints"], 10u);
    std::size_t contacts = 0;
    for (const json& line : file.frames)
      for (const json& pair : triangles_of(line, 0, 0)) {
        ++contacts;
        EXPECT_GT(std::max(distance_from_elbow(pair[0]), distance_from_elbow(pair[1])), 0.22)
            << pair << ": 2.5 radii are 0.25 from the centre of the border";
      }
    EXPECT_GT(contacts, 50u);
  }
}

}  // namespace
}  // namespace pelt::test
