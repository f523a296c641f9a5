#pragma once

/// Small skinned meshes and joint palettes for tests.

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
  std::vector<std::uint32_t> morph_begin, morph_vertices;
  std::vector<Vec3> morph_displacements;

  std::uint32_t morph_target_count() const {
    return morph_begin.empty() ? 0 : static_cast<std::uint32_t>(morph_begin.size() - 1);
  }
  SkinnedMeshView view() const;
};

/// A closed tube along y with `joint_count` joints along it and smooth weights: a limb.
Shape make_limb(std::uint32_t rings, std::uint32_t sides, std::uint32_t joint_count);

enum class Weights {
  one_joint,    ///< each vertex follows one joint
  random,       ///< up to K joints with random weights
  adversarial,  ///< tiny weights, equal weights, weights off 1 by rounding, all mixed
};

/// A soup of triangles with shared vertices and random joints, without structure that a bound could
/// rely on. Every 16th triangle is degenerate.
Shape make_soup(Random& random, std::uint32_t triangle_count, std::uint32_t joint_count,
                std::uint32_t influences_per_vertex, Weights weights);

/// Adds morph targets that each displace a fraction of the vertices by up to `size` along each
/// axis: a contiguous run of vertices, as in a face, or any of them.
void add_morph_targets(Random& random, Shape& shape, std::uint32_t count, double share,
                       double size);

/// A limb with three morph targets: bumps at either end, and one with every third vertex.
Shape make_morphing_limb(std::uint32_t rings, std::uint32_t sides, std::uint32_t joint_count);

enum class Morphing {
  none,        ///< all weights zero
  one,         ///< one target active
  some,        ///< a third of the targets active, weights in [0, 1]
  all,         ///< weights in [-1, 2]
  huge,        ///< weights up to 1e4 of either sign
  cancelling,  ///< large weights, each of which nearly cancels the previous one
};

inline constexpr Morphing kAllMorphings[] = {Morphing::none, Morphing::one,  Morphing::some,
                                             Morphing::all,  Morphing::huge, Morphing::cancelling};

std::vector<float> make_morph_weights(Random& random, std::uint32_t count, Morphing morphing);

enum class Motion {
  rigid,      ///< rotations and translations, as in the paper
  affine,     ///< any scale, shear and reflection
  collapsed,  ///< singular matrices: everything is mapped to planes, lines, points
  far_away,   ///< rigid, 1e5 units from the origin
};

/// A random palette of the given kind, with translations up to `spread`.
std::vector<Matrix4> make_palette(Random& random, std::uint32_t joint_count, Motion motion,
                                  double spread);

/// A palette that bends a limb: each joint rotates by up to `angle` more than the previous one,
/// around random axes. `placement` is applied last.
std::vector<Matrix4> bend_limb(Random& random, std::uint32_t joint_count, double angle,
                               const Vec3& placement);

/// Rotation by `angle` about the axis through `centre` with the direction `axis`, then translation.
Matrix4 rotation_about(const Vec3& axis, double angle, const Vec3& centre, const Vec3& translation);

}  // namespace pelt::test
