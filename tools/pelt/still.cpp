#include "tools/pelt/still.hpp"

#include "base/vec3.hpp"
#include "tools/pelt/scene_glb.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace pelt::tools {
namespace {

using detail::Vec3d;

/// POV-Ray's axes are left-handed: z is turned round wherever a point or direction is written.
std::string vector(const Vec3d& v) {
  char text[96];
  std::snprintf(text, sizeof text, "<%.6g,%.6g,%.6g>", v.x, v.y, -v.z);
  return text;
}

std::string colour(const std::array<float, 3>& c) {
  char text[96];
  std::snprintf(text, sizeof text, "rgb <%.4g,%.4g,%.4g>", static_cast<double>(c[0]),
                static_cast<double>(c[1]), static_cast<double>(c[2]));
  return text;
}

std::string vectors(const char* kind, std::span<const Vec3> values) {
  std::string text = std::string("  ") + kind + " {" + std::to_string(values.size());
  for (const Vec3& value : values) text += ",\n" + vector(Vec3d(value));
  return text + "}\n";
}

/// Texture 0 is the skin, 1 the glow.
std::string faces(std::span<const Triangle> triangles, const std::vector<bool>& touching) {
  std::string text = "  face_indices {" + std::to_string(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle& v = triangles[t];
    text += ",\n<" + std::to_string(v[0]) + "," + std::to_string(v[1]) + "," +
            std::to_string(v[2]) + ">," + (touching[t] ? "1" : "0");
  }
  return text + "}\n";
}

std::string mesh(const PosedInstance& instance, const std::vector<bool>& touching,
                 const std::array<float, 3>& skin) {
  const std::vector<Vec3> normals = smooth_normals(instance.positions, instance.triangles);
  return "mesh2 {\n" + vectors("vertex_vectors", instance.positions) +
         vectors("normal_vectors", normals) + "  texture_list {2, texture {Skin(" + colour(skin) +
         ")}, texture {Glow}}\n" + faces(instance.triangles, touching) + "}\n";
}

/// Where the ground is below the middle of the box around all instances.
Vec3d middle(std::span<const PosedInstance> instances) {
  Vec3 least = instances[0].positions[0], most = least;
  for (const PosedInstance& instance : instances) {
    for (const Vec3& p : instance.positions) {
      least = {std::min(least.x, p.x), 0, std::min(least.z, p.z)};
      most = {std::max(most.x, p.x), 0, std::max(most.z, p.z)};
    }
  }
  return 0.5 * (Vec3d(least) + Vec3d(most));
}

/// Contacts light their surroundings: one small light in each cell of a grid that has any.
std::string glow_lights(std::span<const PosedInstance> instances,
                        const std::vector<std::vector<bool>>& touching) {
  constexpr double kCell = 0.09;
  struct Sum {
    Vec3d positions;
    double count = 0;
  };
  std::map<std::array<int, 3>, Sum> cells;
  const auto cell_of = [](double x) { return static_cast<int>(std::floor(x / kCell)); };
  for (std::size_t i = 0; i < instances.size(); ++i) {
    for (std::size_t t = 0; t < instances[i].triangles.size(); ++t) {
      if (!touching[i][t]) continue;
      const Vec3d p(instances[i].positions[instances[i].triangles[t][0]]);
      Sum& sum = cells[{cell_of(p.x), cell_of(p.y), cell_of(p.z)}];
      sum.positions = sum.positions + p;
      ++sum.count;
    }
  }
  std::string text;
  for (const auto& [cell, sum] : cells) {
    text += "GlowLight(" + vector((1 / sum.count) * sum.positions) + ")\n";
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
  return "light_source {" + vector(ground + Vec3d(-4.2, 4.6, 1.2)) +
         " rgb <1.7,1.6,1.4> area_light <1.6,0,0>, <0,0,1.6>, 9, 9 adaptive 1 circular orient}\n"
         "light_source {" +
         vector(ground + Vec3d(-2, 2, 5)) + " rgb <0.22,0.28,0.38> shadowless}\n" +
         "light_source {" + vector(ground + Vec3d(4, 3.5, -1.5)) +
         " rgb <0.55,0.65,0.85> shadowless}\n";
}

std::string camera(const Vec3d& ground) {
  return "camera {location " + vector(ground + Vec3d(-4.1, 1.5, 0.8)) + " look_at " +
         vector(ground + Vec3d(0, 0.89, 0)) + " right x*16/9 angle 44}\n";
}

}  // namespace

std::string describe_still(std::span<const PosedInstance> instances,
                           const std::vector<std::vector<bool>>& touching) {
  const Vec3d ground = middle(instances);
  std::string text = kStage + camera(ground) + lights(ground) + glow_lights(instances, touching);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    text += mesh(instances[i], touching[i], skin_colour(i));
  }
  return text;
}

}  // namespace pelt::tools
