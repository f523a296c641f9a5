#include "evaluation/reproduce/figures.hpp"

#include "base/vec3.hpp"
#include "evaluation/reproduce/stage.hpp"
#include "skin/skin.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace pelt::reproduce {

using detail::Palette;
using detail::Vec3d;
using paper::Float4;
using tools::picture::pov_vector;
using tools::picture::PovCamera;
using tools::picture::StillFrame;
using tools::scene::PosedInstance;

std::vector<std::uint32_t> nodes_on_level(const paper::SphereTree& tree, std::uint32_t level) {
  std::vector<std::uint32_t> nodes = {0};
  for (std::uint32_t l = 1; l < level; ++l) {
    std::vector<std::uint32_t> below;
    for (const std::uint32_t n : nodes)
      for (std::uint32_t c = 0; c < tree.nodes[n].child_count; ++c)
        below.push_back(tree.nodes[n].first_child + c);
    nodes = std::move(below);
  }
  return nodes;
}

std::vector<Float4> all_refitted(const paper::SphereModel& model, const Palette& palette) {
  paper::Refit refit(model, static_cast<std::uint32_t>(palette.joints().size()));
  std::vector<Float4> spheres;
  for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n)
    spheres.push_back(refit.sphere(n, palette));
  return spheres;
}

AskedPair ask_on_demand(const detail::SkinnedMesh& mesh, const paper::SphereModel& model,
                        const std::array<Palette, 2>& palettes) {
  std::array<paper::OnDemandBody, 2> bodies = {paper::OnDemandBody(mesh, model),
                                               paper::OnDemandBody(mesh, model)};
  paper::Scratch scratch;
  std::vector<Contact> contacts;
  AskedPair pair;
  pair.work = collide(bodies[0], palettes[0], bodies[1], palettes[1], scratch, contacts,
                      std::numeric_limits<std::uint32_t>::max());
  for (std::size_t i = 0; i < 2; ++i) {
    pair.bodies[i].spheres = all_refitted(model, palettes[i]);
    for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n)
      pair.bodies[i].refitted.push_back(!bodies[i].is_stale(n));
  }
  return pair;
}

namespace {

/// Fraction of the distance to the stage: in front of everything on the stage.
constexpr double kDepth = 0.5;
/// Width of rings and lines over the half height of the picture.
constexpr double kLine = 0.006;

constexpr const char* kRimTexture = " texture {Rim} no_shadow}\n";

/// A ring that faces the camera.
std::string ring(const Vec3d& centre, double radius, double line, const View& view) {
  const auto numbers = [](const Vec3d& v) {
    const std::string text = pov_vector(v);
    return text.substr(1, text.size() - 2);
  };
  return "torus {" + std::to_string(radius) + ", " + std::to_string(line) + " matrix <" +
         numbers(view.right) + ", " + numbers(view.ahead) + ", " + numbers(view.up) + ", " +
         numbers(centre) + ">" + kRimTexture;
}

/// A cone, cut off at both ends, with the camera as its tip, so that its wall is invisible.
std::string funnel(const Vec3d& near, const Vec3d& far, double radius, const Vec3d& from,
                   const Vec3d& centre) {
  const double whole = length(centre - from);
  return "cone {" + pov_vector(near) + ", " + std::to_string(radius * length(near - from) / whole) +
         ", " + pov_vector(far) + ", " + std::to_string(radius * length(far - from) / whole) + "}";
}

}  // namespace

std::string magnified(const Lens& lens, const std::string& objects, const Vec3d& shift,
                      const PovCamera& camera) {
  const View view(camera);
  const double depth = kDepth * length(camera.at - camera.from);
  const double half = length(view.seen_at(0, 1, depth) - view.seen_at(0, 0, depth));
  const double radius = lens.radius * half, line = kLine * half;
  const Vec3d centre = view.seen_at(lens.x, lens.y, depth);
  const Vec3d along = unit(centre - camera.from);
  const Vec3d near = centre - (1.5 * radius) * along, far = centre + (1.5 * radius) * along;
  const Vec3d marked = camera.from + kDepth * (lens.focus - camera.from);
  const double mark = kDepth * lens.reach;
  const Vec3d way = unit(centre - marked);
  return "union {\n" + objects + "translate " + pov_vector(shift - lens.focus) + " scale " +
         std::to_string(radius / lens.reach) + " translate " + pov_vector(centre) +
         "\nclipped_by {" + funnel(near, far, radius, camera.from, centre) + "} no_shadow}\n" +
         "disc {" + pov_vector(far) + ", " + pov_vector(along) + ", " +
         std::to_string(radius * length(far - camera.from) / length(centre - camera.from)) +
         " texture {Backdrop} no_shadow}\n" + ring(centre, radius, line, view) +
         ring(marked, mark, 0.6 * line, view) + "cylinder {" + pov_vector(marked + mark * way) +
         ", " + pov_vector(centre - radius * way) + ", " + std::to_string(0.6 * line) + kRimTexture;
}

Vec3d densest_contact(const tools::picture::StillFrame& still, double reach) {
  std::vector<Vec3d> middles;
  for (std::size_t i = 0; i < still.instances.size(); ++i) {
    const tools::scene::PosedInstance& instance = still.instances[i];
    for (std::size_t t = 0; t < instance.triangles.size(); ++t) {
      if (!still.touching[i][t]) continue;
      Vec3d sum(0, 0, 0);
      for (const std::uint32_t v : instance.triangles[t]) sum = sum + Vec3d(instance.positions[v]);
      middles.push_back((1. / 3) * sum);
    }
  }
  Vec3d best(0, 0, 0);
  std::size_t most = 0;
  for (const Vec3d& middle : middles) {
    Vec3d sum(0, 0, 0);
    std::size_t count = 0;
    for (const Vec3d& other : middles) {
      if (squared_length(other - middle) > reach * reach) continue;
      sum = sum + other;
      ++count;
    }
    if (count <= most) continue;
    most = count;
    best = (1. / static_cast<double>(count)) * sum;
  }
  return best;
}

namespace {

// Draws characters as their triangles.

/// A ball; everything outside is left out.
struct Around {
  detail::Vec3d centre;
  double reach;
};

/// Some triangles of an instance, with a flag for those in contact.
struct Part {
  std::vector<Triangle> triangles;
  std::vector<bool> touching;
};

Part part_of(const PosedInstance& instance, const std::vector<bool>& touching,
             const Around& around) {
  Part part;
  for (std::size_t t = 0; t < instance.triangles.size(); ++t) {
    const Triangle& triangle = instance.triangles[t];
    const bool is_near = std::any_of(triangle.begin(), triangle.end(), [&](std::uint32_t v) {
      return squared_length(Vec3d(instance.positions[v]) - around.centre) <=
             around.reach * around.reach;
    });
    if (!is_near) continue;
    part.triangles.push_back(triangle);
    part.touching.push_back(touching[t]);
  }
  return part;
}

/// A three-sided prism along an edge, as the corners of its six triangles.
void append_prism(const Vec3d& from, const Vec3d& to, double radius, std::vector<Vec3d>& corners) {
  const Vec3d along = to - from;
  const Vec3d other = std::fabs(along.y) < std::fabs(along.x) ? Vec3d(0, 1, 0) : Vec3d(1, 0, 0);
  const Vec3d u = unit(cross(along, other)), v = unit(cross(along, u));
  const std::array<Vec3d, 3> ring = {radius * u, radius * (-0.5 * u + 0.866 * v),
                                     radius * (-0.5 * u - 0.866 * v)};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d &one = ring[i], &next = ring[(i + 1) % 3];
    for (const Vec3d& corner :
         {from + one, from + next, to + next, from + one, to + next, to + one})
      corners.push_back(corner);
  }
}

/// Draws each edge once, also if triangles share it. One mesh, because POV-Ray would test many
/// cylinders one after the other.
std::string edges(const PosedInstance& instance, const Part& part, double radius) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> all;
  for (const Triangle& triangle : part.triangles)
    for (std::size_t i = 0; i < 3; ++i) all.insert(std::minmax(triangle[i], triangle[(i + 1) % 3]));
  std::vector<Vec3d> corners;
  for (const auto& edge : all) {
    const Vec3d from(instance.positions[edge.first]), to(instance.positions[edge.second]);
    if (squared_length(to - from) > 0) append_prism(from, to, radius, corners);
  }
  std::string text = "mesh {\n";
  for (std::size_t i = 0; i < corners.size(); i += 3)
    text += "triangle {" + tools::picture::pov_vector(corners[i]) + ", " +
            tools::picture::pov_vector(corners[i + 1]) + ", " +
            tools::picture::pov_vector(corners[i + 2]) + "}\n";
  return corners.empty() ? "" : text + "texture {Edge} no_shadow}\n";
}

/// All triangles of a frame's characters that reach into `around`, flat, with dark edges of radius
/// `edge`. Triangles in contact glow.
std::string facets(const tools::picture::StillFrame& still, double edge, const Around& around) {
  std::string text;
  for (std::size_t i = 0; i < still.instances.size(); ++i) {
    const Part part = part_of(still.instances[i], still.touching[i], around);
    if (part.triangles.empty()) continue;
    const PosedInstance shown = {"", still.instances[i].positions, part.triangles};
    text += tools::picture::pov_mesh(shown, part.touching, skin_texture(i),
                                     tools::picture::Shading::flat) +
            edges(shown, part, edge);
  }
  return text;
}

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
