#include "evaluation/reproduce/figures.hpp"

#include "evaluation/reproduce/facets.hpp"
#include "evaluation/reproduce/lens.hpp"
#include "evaluation/reproduce/level_spheres.hpp"
#include "evaluation/reproduce/stage.hpp"
#include "evaluation/reproduce/view.hpp"
#include "skin/skin.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <cmath>

namespace pelt::reproduce {
namespace {

using detail::Palette;
using detail::Vec3d;
using paper::Float4;
using tools::picture::PovCamera;
using tools::picture::StillFrame;

std::string ball(const Float4& sphere, const char* texture) {
  return reproduce::ball(Vec3d(sphere[0], sphere[1], sphere[2]), sphere[3], texture);
}

tools::scene::PosedInstance posed(const detail::SkinnedMesh& mesh, const Palette& palette) {
  std::vector<Vec3> positions(mesh.vertex_count());
  detail::posed_vertices(mesh, palette, positions);
  return {"", std::move(positions), mesh.triangles};
}

std::vector<Float4> rest_spheres(const paper::SphereTree& tree) {
  std::vector<Float4> spheres;
  for (const paper::Node& node : tree.nodes) spheres.push_back(paper::make_ball(node.rest));
  return spheres;
}

/// From the front, slightly from the character's left.
const PovCamera kLevelCamera = {{13.3, 4.6, 12.9}, {-0.3, 1.86, 0.3}, 20.6, 1.5};
const Vec3d kLevelStep(1.19, 0, -1.28);

/// In front of the character in the middle, for cameras that look along x.
const Vec3d kFloorWord(-0.9, 0.04, 0);

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
  tools::scene::Palettes joints;
  tools::scene::sample_palettes(scene, frame, scratch, joints);
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
  const Vec3d below(0, -0.36, 0);
  const Vec3d beside = Vec3d(0, 0.9, 0) - 1.66 * kLevelStep;
  const std::string objects =
      moved(row(mesh, rest, model.tree, rest_spheres(model.tree)), Vec3d(0, kRise, 0)) +
      row(mesh, palette, model.tree, all_refitted(model, palette)) +
      word("mesh", below - kLevelStep, kLevelCamera) + word("level 4", below, kLevelCamera) +
      word("level 6", below + kLevelStep, kLevelCamera) +
      word("at rest", beside + Vec3d(0, kRise, 0), kLevelCamera) +
      word("walking", beside, kLevelCamera);
  return make_picture({"figure_4",
                       "Figure 4. Above: the creature at rest, with the spheres of levels 4 and 6 "
                       "of the tree. Below: walking, with the same spheres refitted on demand."},
                      kLevelCamera, objects, conditions);
}

Result<Picture> refit_picture(const scenes::Scene& scene, const Conditions& conditions) {
  const Result<Specimen> man = make_specimen(scene.characters[0].asset);
  if (!man) return man.error();
  const auto palettes = palettes_of(scene, kRefitFrame, man->mesh);
  if (!palettes) return palettes.error();
  const Result<StillFrame> still = tools::picture::take_still(scene, kRefitFrame);
  if (!still) return still.error();
  const paper::SphereModel model = paper::build_sphere_model(man->mesh);
  const AskedPair pair = ask_on_demand(man->mesh, model, *palettes);
  const PovCamera camera = {{-11, 3.2, 0}, {0, 0.8, 0}, 31, 2.9};
  const Vec3d step(0, 0, 2);
  const std::string objects =
      white_floor() + moved(characters(*still), -1 * step) + spheres_of_both(model.tree, pair, 5) +
      moved(spheres_of_both(model.tree, pair, 6), step) + word("mesh", kFloorWord - step, camera) +
      word("level 5", kFloorWord, camera) + word("level 6", kFloorWord + step, camera);
  return make_picture({"figure_5",
                       "Figure 5. Two instances of the generated man, which has horns and a tail "
                       "like the creature, meet: triangles in contact glow. Beside them the "
                       "spheres of levels 5 and 6. The query refitted the blue ones and never "
                       "needed the red ones; a bottom-up refit computes all."},
                      camera, objects, conditions);
}

Result<Picture> passing_picture(const scenes::Scene& scene, const Conditions& conditions) {
  constexpr std::array<std::uint32_t, 3> kFrames = {42, 60, 82};
  const PovCamera camera = {{-11, 2.4, 0}, {0, 0.8, 0}, 31, 2.7};
  std::string objects = white_floor();
  Vec3d place(0, 0, -2);
  for (const std::uint32_t frame : kFrames) {
    const Result<StillFrame> still = tools::picture::take_still(scene, frame);
    if (!still) return still.error();
    objects += moved(characters(*still), place) +
               word("frame " + std::to_string(frame), kFloorWord + place, camera);
    place = place + Vec3d(0, 0, 2);
  }
  return make_picture({"figure_6",
                       "Figure 6. The worst case: two creatures walk through each other. Triangles "
                       "in contact glow."},
                      camera, objects, conditions);
}

Result<Picture> dwarves_picture(const scenes::Scene& apart, const scenes::Scene& interfering,
                                const scenes::Scene& subdivided, const Conditions& conditions) {
  constexpr double kEdge = 0.0022, kReach = 0.11;
  const Around all = {Vec3d(0, 0, 0), HUGE_VAL};
  const PovCamera camera = {{-11, 2.6, 0}, {0, 0.8, 0}, 36, 3.05};
  const View view(camera);
  const Vec3d left(0, 0, -2.4), right(0, 0, -0.15);
  std::array<StillFrame, 3> stills;
  for (const auto& [scene, still] :
       {std::pair(&apart, &stills[0]), std::pair(&interfering, &stills[1]),
        std::pair(&subdivided, &stills[2])}) {
    Result<StillFrame> taken = tools::picture::take_still(*scene, 0);
    if (!taken) return taken.error();
    *still = std::move(*taken);
  }
  const Vec3d focus = densest_contact(stills[1], kReach);
  const Around near = {focus, 3 * kReach};
  const auto lens = [&](double x, const StillFrame& still) {
    return magnified({focus + right, kReach, x, 0.12, 0.52}, facets(still, kEdge / 4, near), right,
                     camera);
  };
  const std::string objects = white_floor() + moved(facets(stills[0], kEdge, all), left) +
                              moved(facets(stills[1], kEdge, all), right) + lens(1.35, stills[1]) +
                              lens(2.46, stills[2]) + word("apart", kFloorWord + left, camera) +
                              word("intersecting", kFloorWord + right, camera) +
                              word("not subdivided", view.seen_at(1.35, -0.56, 6), camera) +
                              word("subdivided twice", view.seen_at(2.46, -0.56, 6), camera);
  return make_picture({"figure_7",
                       "Figure 7. The dwarves, apart and intersecting, with a close-up of the "
                       "contact: not subdivided, and subdivided twice. Triangles in contact glow."},
                      camera, objects, conditions);
}

Result<Picture> crowd_picture(const scenes::Scene& scene, const Conditions& conditions) {
  constexpr double kReach = 0.3;
  const Result<StillFrame> still = tools::picture::take_still(scene, 0);
  if (!still) return still.error();
  const PovCamera camera = {{-1.6, 7.6, 12.8}, {3.55, 0.42, 2.5}, 43};
  const Vec3d focus = densest_contact(*still, kReach);
  const std::string near = facets(*still, 0.0006, {focus, 2 * kReach});
  const Lens lens = {focus, kReach, 1.27, -0.52, 0.42};
  return make_picture(
      {"figure_1", "Figure 1. The crowd of fifty creatures. Triangles in contact glow."}, camera,
      white_floor() + characters(*still) + magnified(lens, near, Vec3d(0, 0, 0), camera),
      conditions);
}

}  // namespace pelt::reproduce
