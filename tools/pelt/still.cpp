#include "tools/pelt/still.hpp"

#include "base/vec3.hpp"
#include "tools/pelt/scene_glb.hpp"

#include <cstdio>

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

/// The middle of the box around the triangles in contact; of all triangles where there is none.
Vec3d middle_of_contact(std::span<const PosedInstance> instances,
                        const std::vector<std::vector<bool>>& touching) {
  Vec3d sum(0, 0, 0);
  double count = 0;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    for (std::size_t t = 0; t < instances[i].triangles.size(); ++t) {
      if (!touching[i][t]) continue;
      for (const std::uint32_t v : instances[i].triangles[t]) {
        sum = sum + Vec3d(instances[i].positions[v]);
        ++count;
      }
    }
  }
  return count > 0 ? (1 / count) * sum : Vec3d(0, 1, 0);
}

constexpr const char* kStage = R"(#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity {pretrace_start 0.08 pretrace_end 0.01 count 80 error_bound 0.7 recursion_limit 2 brightness 0.8}
}
background {rgb <0.80,0.83,0.87>}
sky_sphere {pigment {gradient y color_map {[0 rgb <0.86,0.86,0.85>] [0.6 rgb <0.42,0.53,0.66>]}}}
#macro Skin(Colour)
  pigment {Colour} finish {diffuse 0.75 specular 0.12 roughness 0.06 ambient 0}
#end
#declare Glow = texture {pigment {rgb <1,0.30,0.06>} finish {emission 1.1 diffuse 0.3}}
)";

std::string lights(const Vec3d& target) {
  return "light_source {" + vector(target + Vec3d(-3.5, 5, 3.5)) +
         " rgb <1.05,0.98,0.88> area_light <1.6,0,0>, <0,0,1.6>, 7, 7 adaptive 2 jitter circular "
         "orient}\n"
         "light_source {" +
         vector(target + Vec3d(4, 2.5, 1.5)) +
         " rgb <0.22,0.27,0.34> shadowless}\n"
         "plane {y, 0 pigment {rgb <0.58,0.57,0.55>} finish {diffuse 0.8}}\n";
}

std::string camera(const Vec3d& target) {
  return "camera {location " + vector(target + Vec3d(3.6, 0.45, 1.3)) + " look_at " +
         vector(Vec3d(target.x, 0.93, target.z)) + " right x*16/9 angle 46}\n";
}

}  // namespace

std::string describe_still(std::span<const PosedInstance> instances,
                           const std::vector<std::vector<bool>>& touching) {
  const Vec3d target = middle_of_contact(instances, touching);
  std::string text = kStage + camera(target) + lights(target);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    text += mesh(instances[i], touching[i], skin_colour(i));
  }
  return text;
}

}  // namespace pelt::tools
