#include "evaluation/reproduce/facets.hpp"

#include "evaluation/reproduce/stage.hpp"
#include "evaluation/reproduce/view.hpp"
#include "tools/pelt/picture/still.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace pelt::reproduce {
namespace {

using detail::Vec3d;
using tools::scene::PosedInstance;

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

}  // namespace

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

}  // namespace pelt::reproduce
