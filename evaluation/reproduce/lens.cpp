#include "evaluation/reproduce/lens.hpp"

#include "evaluation/reproduce/view.hpp"

#include <algorithm>

namespace pelt::reproduce {
namespace {

using detail::Vec3d;
using tools::picture::pov_vector;
using tools::picture::PovCamera;

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

}  // namespace pelt::reproduce
