#include "tools/pelt/picture/pov.hpp"

#include <algorithm>
#include <cstdio>

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

}  // namespace pelt::tools::picture
