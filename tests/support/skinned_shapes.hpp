#pragma once

/// Small skinned meshes and joint palettes to test with.

#include "support/random.hpp"

#include <pelt/mesh.hpp>

#include <cstdint>
#include <vector>

namespace pelt::test {

/// The arrays behind a SkinnedMeshView.
struct Shape {
  std::vector<Vec3> rest_positions;
  std::vector<Triangle> triangles;
  std::uint32_t influences_per_vertex = 4;
  std::vector<std::uint16_t> joints;
  std::vector<float> weights;
  std::uint32_t joint_count = 1;

  SkinnedMeshView view() const;
};

/// A closed tube along y with `joint_count` joints along it and smooth weights: a limb.
Shape make_limb(std::uint32_t rings, std::uint32_t sides, std::uint32_t joint_count);

enum class Weights {
  one_joint,    ///< each vertex follows one joint
  random,       ///< up to K joints with random weights
  adversarial,  ///< tiny weights, equal weights, weights off 1 by rounding, all mixed
};

/// A soup of triangles with shared vertices and random joints: no structure that a bound could rely
/// on. Every 16th triangle is degenerate.
Shape make_soup(Random& random, std::uint32_t triangle_count, std::uint32_t joint_count,
                std::uint32_t influences_per_vertex, Weights weights);

enum class Motion {
  rigid,      ///< rotations and translations, as in the paper
  affine,     ///< any scale, shear and reflection
  collapsed,  ///< singular matrices: everything falls on planes, lines, points
  far_away,   ///< rigid, 1e5 units from the origin
};

/// A random palette of the given kind; translations up to `spread`.
std::vector<Matrix4> make_palette(Random& random, std::uint32_t joint_count, Motion motion,
                                  double spread);

/// A palette that bends a limb: each joint turns by up to `angle` more than the one before, around
/// random axes. `placement` comes last.
std::vector<Matrix4> bend_limb(Random& random, std::uint32_t joint_count, double angle,
                               const Vec3& placement);

/// Rotation by `angle` around the direction `axis` through `centre`, then translation.
Matrix4 rotation_about(const Vec3& axis, double angle, const Vec3& centre, const Vec3& translation);

}  // namespace pelt::test
