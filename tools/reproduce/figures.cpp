#include "tools/reproduce/figures.hpp"

#include "skin/skin.hpp"
#include "tools/pelt/scene_query.hpp"
#include "tools/reproduce/level_spheres.hpp"
#include "tools/reproduce/stage.hpp"

namespace pelt::reproduce {
namespace {

using detail::Palette;
using detail::Vec3d;
using paper::Float4;
using tools::PovCamera;
using tools::StillFrame;

std::string ball(const Float4& sphere, const char* texture) {
  return reproduce::ball(Vec3d(sphere[0], sphere[1], sphere[2]), sphere[3], texture);
}

tools::PosedInstance posed(const detail::SkinnedMesh& mesh, const Palette& palette) {
  std::vector<Vec3> positions(mesh.vertex_count());
  detail::posed_vertices(mesh, palette, positions);
  return {"", std::move(positions), mesh.triangles};
}

std::vector<Float4> rest_spheres(const paper::SphereTree& tree) {
  std::vector<Float4> spheres;
  for (const paper::Node& node : tree.nodes) spheres.push_back(paper::make_ball(node.rest));
  return spheres;
}

/// From the front, a little from its left.
const PovCamera kLevelCamera = {{13.6, 4.6, 12.6}, {0, 1.86, 0}, 17.4, 1.25};
const Vec3d kLevelStep(1.19, 0, -1.28);

/// A character, then its spheres of levels 4 and 6, from left to right.
std::string row(const detail::SkinnedMesh& mesh, const Palette& palette,
                const paper::SphereTree& tree, std::span<const Float4> spheres) {
  const std::vector<bool> touching(mesh.triangles.size(), false);
  std::string text =
      moved(pedestal({}) + mesh_in_skin(posed(mesh, palette), touching, 0), -1 * kLevelStep);
  double steps = 0;
  for (const std::uint32_t level : {4, 6}) {
    std::string balls = pedestal({});
    for (const std::uint32_t n : nodes_on_level(tree, level)) balls += ball(spheres[n], kBlueBall);
    text += moved(balls, steps++ * kLevelStep);
  }
  return text;
}

/// Two instances of one character under their palettes.
Result<std::array<Palette, 2>> palettes_of(const scenes::Scene& scene, std::uint32_t frame,
                                           const detail::SkinnedMesh& mesh) {
  asset::SampleScratch scratch;
  tools::Palettes joints;
  tools::sample_palettes(scene, frame, scratch, joints);
  const Palette rest(mesh.joint_count, mesh.rest_extent);
  std::array<Palette, 2> palettes = {rest, rest};
  for (std::size_t i = 0; i < 2; ++i)
    if (const auto set = palettes[i].set(joints[i]); !set) return set.error();
  return palettes;
}

std::string spheres_of_both(const paper::SphereTree& tree, const AskedPair& pair,
                            std::uint32_t level) {
  std::string text;
  for (const AskedBody& body : pair.bodies)
    for (const std::uint32_t n : nodes_on_level(tree, level))
      text += ball(body.spheres[n], body.refitted[n] ? kBlueBall : kRedBall);
  return text;
}

}  // namespace

Picture level_picture(const Specimen& creature, const Palette& palette,
                      const Conditions& conditions) {
  constexpr double kRise = 2.2;
  const detail::SkinnedMesh& mesh = creature.mesh;
  const paper::SphereModel model = paper::build_sphere_model(mesh);
  const Palette rest(mesh.joint_count, mesh.rest_extent);
  const std::string objects =
      moved(row(mesh, rest, model.tree, rest_spheres(model.tree)), Vec3d(0, kRise, 0)) +
      row(mesh, palette, model.tree, all_refitted(model, palette)) +
      word("level 4", Vec3d(0, -0.36, 0), 0.13, kLevelCamera) +
      word("level 6", Vec3d(0, -0.36, 0) + kLevelStep, 0.13, kLevelCamera);
  return make_picture({"figure_4",
                       "Figure 4. Above: the creature at rest, with the spheres of levels 4 and 6 "
                       "of the tree. Below: walking, with the same spheres refitted on demand."},
                      kLevelCamera, objects, conditions);
}

Result<Picture> refit_picture(const scenes::Scene& scene, const Conditions& conditions) {
  constexpr double kApart = 1.05;
  const Result<Specimen> man = make_specimen(scene.characters[0].asset);
  if (!man) return man.error();
  const auto palettes = palettes_of(scene, kRefitFrame, man->mesh);
  if (!palettes) return palettes.error();
  const paper::SphereModel model = paper::build_sphere_model(man->mesh);
  const AskedPair pair = ask_on_demand(man->mesh, model, *palettes);
  const PovCamera camera = {{-11, 3.2, 0}, {0, 0.8, 0}, 22.5, 2.1};
  const std::string objects = white_floor() +
                              moved(spheres_of_both(model.tree, pair, 5), Vec3d(0, 0, -kApart)) +
                              moved(spheres_of_both(model.tree, pair, 6), Vec3d(0, 0, kApart)) +
                              word("level 5", Vec3d(-0.8, 0.04, -kApart), 0.12, camera) +
                              word("level 6", Vec3d(-0.8, 0.04, kApart), 0.12, camera);
  return make_picture({"figure_5",
                       "Figure 5. Two men meet, with the spheres of levels 5 and 6. The "
                       "query refitted the blue ones and never asked for the red ones; bottom-up "
                       "refit computes all."},
                      camera, objects, conditions);
}

Result<Picture> passing_picture(const scenes::Scene& scene, const Conditions& conditions) {
  constexpr std::array<std::uint32_t, 3> kFrames = {42, 60, 82};
  std::string objects = white_floor();
  double z = -2;
  for (const std::uint32_t frame : kFrames) {
    const Result<StillFrame> still = tools::take_still(scene, frame);
    if (!still) return still.error();
    objects += moved(characters(*still), Vec3d(0, 0, z));
    z += 2;
  }
  const PovCamera camera = {{-11, 2.4, 0}, {0, 0.88, 0}, 31, 2.7};
  return make_picture({"figure_6",
                       "Figure 6. The worst case: two creatures walk through each other. Triangles "
                       "in contact glow."},
                      camera, objects, conditions);
}

Result<Picture> dwarves_picture(const scenes::Scene& apart, const scenes::Scene& interfering,
                                const Conditions& conditions) {
  constexpr double kApart = 1.2;
  const Result<StillFrame> left = tools::take_still(apart, 0);
  if (!left) return left.error();
  const Result<StillFrame> right = tools::take_still(interfering, 0);
  if (!right) return right.error();
  const PovCamera camera = {{-11, 2.6, 0}, {0, 0.8, 0}, 24.5, 2.2};
  const std::string objects = white_floor() + moved(characters(*left), Vec3d(0, 0, -kApart)) +
                              moved(characters(*right), Vec3d(0, 0, kApart)) +
                              word("apart", Vec3d(-0.8, 0.04, -kApart), 0.12, camera) +
                              word("in each other", Vec3d(-0.8, 0.04, kApart), 0.12, camera);
  return make_picture({"figure_7",
                       "Figure 7. The dwarves whose triangles are subdivided, apart and in each "
                       "other. Triangles in contact glow."},
                      camera, objects, conditions);
}

Result<Picture> crowd_picture(const scenes::Scene& scene, const Conditions& conditions) {
  const Result<StillFrame> still = tools::take_still(scene, 0);
  if (!still) return still.error();
  const PovCamera camera = {{-1.6, 7.6, 12.8}, {3.55, 0.42, 2.5}, 41};
  return make_picture(
      {"figure_1", "Figure 1. The crowd of fifty creatures. Triangles in contact glow."}, camera,
      white_floor() + characters(*still), conditions);
}

}  // namespace pelt::reproduce
