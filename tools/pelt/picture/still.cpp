#include "tools/pelt/picture/still.hpp"

#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/scene/scene_glb.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace pelt::tools::picture {
namespace {

using detail::Vec3d;

/// Significant digits of each coordinate.
std::string vector(const Vec3d& v, int digits) {
  char text[96];
  std::snprintf(text, sizeof text, "<%.*g,%.*g,%.*g>", digits, v.x, digits, v.y, digits, -v.z);
  return text;
}

std::string vectors(const char* kind, std::span<const Vec3> values, int digits) {
  std::string text = std::string("  ") + kind + " {" + std::to_string(values.size());
  for (const Vec3& value : values) text += ",\n" + vector(Vec3d(value), digits);
  return text + "}\n";
}

/// A face without a texture number has the texture of the mesh.
std::string faces(std::span<const Triangle> triangles, const std::vector<bool>& touching) {
  std::string text = "  face_indices {" + std::to_string(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle& v = triangles[t];
    text += ",\n<" + std::to_string(v[0]) + "," + std::to_string(v[1]) + "," +
            std::to_string(v[2]) + (touching[t] ? ">,0" : ">");
  }
  return text + "}\n";
}

using detail::Vec3d;

/// Point of the ground below the middle of the box around all instances.
Vec3d middle(const StillFrame& still) {
  Vec3 least = still.instances[0].positions[0], most = least;
  for (const scene::PosedInstance& instance : still.instances) {
    for (const Vec3& p : instance.positions) {
      least = {std::min(least.x, p.x), 0, std::min(least.z, p.z)};
      most = {std::max(most.x, p.x), 0, std::max(most.z, p.z)};
    }
  }
  return 0.5 * (Vec3d(least) + Vec3d(most));
}

/// Contacts light their surroundings: one small light in each cell of a grid that contains
/// contacts.
std::string glow_lights(const StillFrame& still) {
  constexpr double kCell = 0.13;
  struct Sum {
    Vec3d positions;
    double count = 0;
  };
  std::map<std::array<int, 3>, Sum> cells;
  const auto cell_of = [](double x) { return static_cast<int>(std::floor(x / kCell)); };
  for (std::size_t i = 0; i < still.instances.size(); ++i) {
    const scene::PosedInstance& instance = still.instances[i];
    for (std::size_t t = 0; t < instance.triangles.size(); ++t) {
      if (!still.touching[i][t]) continue;
      const Vec3d p(instance.positions[instance.triangles[t][0]]);
      Sum& sum = cells[{cell_of(p.x), cell_of(p.y), cell_of(p.z)}];
      sum.positions = sum.positions + p;
      ++sum.count;
    }
  }
  std::string text;
  for (const auto& [cell, sum] : cells) {
    text += "GlowLight(" + pov_vector((1 / sum.count) * sum.positions) + ")\n";
  }
  return text;
}

constexpr const char* kStage = R"(#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity {pretrace_start 0.08 pretrace_end 0.02 count 60 error_bound 0.9 recursion_limit 1 brightness 0.8}
}
sky_sphere {pigment {gradient y color_map {[0 rgb <0.045,0.05,0.065>] [0.7 rgb <0.16,0.19,0.24>]}}}
fog {fog_type 1 distance 12 rgb <0.045,0.05,0.065>}
plane {y, 0 pigment {rgb <0.10,0.11,0.13>} finish {diffuse 0.8 specular 0.05 roughness 0.1}}
#macro Skin(Colour)
  pigment {Colour * 1.25} finish {diffuse 0.8 specular 0.16 roughness 0.05 ambient 0}
#end
#declare Glow = texture {pigment {rgb <1,0.30,0.06>} finish {emission <1.5,0.5,0.1> diffuse 0.2}}
#macro GlowLight(Place)
  light_source {Place rgb <0.35,0.10,0.018> fade_distance 0.05 fade_power 2 shadowless}
#end
)";

/// Key, fill and rim.
std::string lights(const Vec3d& ground) {
  return "light_source {" + pov_vector(ground + Vec3d(-4.2, 4.6, 1.2)) +
         " rgb <1.7,1.6,1.4> area_light <1.6,0,0>, <0,0,1.6>, 5, 5 adaptive 1 circular orient}\n"
         "light_source {" +
         pov_vector(ground + Vec3d(-2, 2, 5)) + " rgb <0.22,0.28,0.38> shadowless}\n" +
         "light_source {" + pov_vector(ground + Vec3d(4, 3.5, -1.5)) +
         " rgb <0.55,0.65,0.85> shadowless}\n";
}

PovCamera camera(const Vec3d& ground) {
  return {ground + Vec3d(-4.1, 1.5, 0.8), ground + Vec3d(0, 0.89, 0), 44};
}

std::string skin(std::size_t instance) {
  return "Skin(" + pov_colour(scene::skin_colour(instance)) + ")";
}

}  // namespace

std::string pov_vector(const Vec3d& v) { return vector(v, 6); }

std::string pov_colour(const std::array<float, 3>& colour) {
  char text[96];
  std::snprintf(text, sizeof text, "rgb <%.4g,%.4g,%.4g>", static_cast<double>(colour[0]),
                static_cast<double>(colour[1]), static_cast<double>(colour[2]));
  return text;
}

std::string pov_camera(const PovCamera& camera) {
  char lens[64];
  std::snprintf(lens, sizeof lens, " right x*%.6g angle %.6g}\n", camera.aspect, camera.angle);
  return "camera {location " + pov_vector(camera.from) + " look_at " + pov_vector(camera.at) + lens;
}

std::string pov_mesh(const scene::PosedInstance& instance, const std::vector<bool>& touching,
                     const std::string& skin, Shading shading) {
  std::string normals;
  if (shading == Shading::smooth)
    normals = vectors("normal_vectors", scene::normals_of(instance), 3);
  return "mesh2 {\n" + vectors("vertex_vectors", instance.positions, 6) + normals +
         "  texture_list {1, texture {Glow}}\n" + faces(instance.triangles, touching) +
         "  texture {" + skin + "}\n}\n";
}

Result<StillFrame> take_still(const scenes::Scene& scene, std::uint32_t frame) {
  const auto colliders = scene::make_colliders(scene, scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  auto posed = scene::pose_instances(scene, frame, {});
  if (!posed) return posed.error();
  asset::SampleScratch scratch;
  scene::Palettes palettes;
  scene::sample_palettes(scene, frame, scratch, palettes);
  scene::SceneQuery query(*colliders, methods::kOnDemand);
  if (const auto set = query.set_palettes(palettes); !set) return set.error();
  scene::FrameContacts found;
  query.collide({}, found);
  auto touching = scene::touching_triangles(*posed, *colliders, found);
  return StillFrame{std::move(*posed), std::move(touching)};
}

std::string describe_still(const StillFrame& still) {
  const Vec3d ground = middle(still);
  std::string text = kStage + pov_camera(camera(ground)) + lights(ground) + glow_lights(still);
  for (std::size_t i = 0; i < still.instances.size(); ++i) {
    text += pov_mesh(still.instances[i], still.touching[i], skin(i));
  }
  return text;
}

}  // namespace pelt::tools::picture
