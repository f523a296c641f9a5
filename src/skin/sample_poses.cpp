#include "skin/sample_poses.hpp"

#include "base/vec3.hpp"

namespace pelt::detail {
namespace {

constexpr std::uint32_t kPoseCount = 4;

/// Knuth's 64-bit linear congruential generator, which is good enough here.
class Noise {
 public:
  /// Returns a number in [-1, 1).
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
  }

 private:
  std::uint64_t state_ = 1;
};

/// Returns for each joint the weighted mean position of the vertices that it moves.
std::vector<Vec3d> joint_middles(const SkinnedMesh& mesh) {
  std::vector<Vec3d> middles(mesh.joint_count);
  std::vector<double> weights(mesh.joint_count);
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
    for (const Influence& influence : mesh.influences_of(v)) {
      const double weight = static_cast<double>(influence.weight);
      middles[influence.joint] = middles[influence.joint] + weight * Vec3d(mesh.rest_positions[v]);
      weights[influence.joint] += weight;
    }
  for (std::uint32_t j = 0; j < mesh.joint_count; ++j)
    if (weights[j] > 0) middles[j] = (1 / weights[j]) * middles[j];
  return middles;
}

/// Returns the rotation about `middle` by the unit quaternion parallel to (1, x, y, z).
Matrix4 turn_about(const Vec3d& middle, double x, double y, double z) {
  const double s = 2 / (1 + x * x + y * y + z * z);
  const Vec3d columns[] = {{1 - s * (y * y + z * z), s * (x * y + z), s * (x * z - y)},
                           {s * (x * y - z), 1 - s * (x * x + z * z), s * (y * z + x)},
                           {s * (x * z + y), s * (y * z - x), 1 - s * (x * x + y * y)}};
  const Vec3d moved = middle.x * columns[0] + middle.y * columns[1] + middle.z * columns[2];
  const Vec3d all[] = {columns[0], columns[1], columns[2], middle - moved};
  Matrix4 matrix;
  for (std::size_t column = 0; column < 4; ++column) {
    const Vec3 v = to_float(all[column]);
    matrix.m[4 * column] = v.x, matrix.m[4 * column + 1] = v.y, matrix.m[4 * column + 2] = v.z;
  }
  return matrix;
}

}  // namespace

std::vector<Palette> invent_sample_poses(const SkinnedMesh& mesh) {
  constexpr double kLargestTangent = 0.24;  // of half an angle, per axis: 45 degrees in total
  const std::vector<Vec3d> middles = joint_middles(mesh);
  std::vector<Palette> poses(kPoseCount,
                             Palette(mesh.joint_count, mesh.rest_extent, {}, mesh.dual_influences));
  std::vector<Matrix4> matrices(mesh.joint_count);
  Noise noise;
  for (Palette& pose : poses) {
    for (std::uint32_t j = 0; j < mesh.joint_count; ++j) {
      const double x = noise.next(), y = noise.next(), z = noise.next();
      matrices[j] =
          turn_about(middles[j], kLargestTangent * x, kLargestTangent * y, kLargestTangent * z);
    }
    // Rotation can move a mesh beyond the limit of coordinates; the pose then stays the rest pose.
    (void)pose.set(matrices);
  }
  return poses;
}

}  // namespace pelt::detail
