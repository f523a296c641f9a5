#include "model/node_bounds.hpp"

#include "base/vec3.hpp"
#include "model/bound_fit.hpp"
#include "model/check_tree.hpp"
#include "model/node_box.hpp"

#include <algorithm>

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

namespace {

/// Nodes with more joints than this get joint boxes without a fit: their weights are far from
/// affine, and the fit would take long.
constexpr std::size_t kMaxFittedJoints = 32;

/// An affine bound must be smaller than joint boxes by this factor, because it costs more.
constexpr double kAffineAdvantage = 0.95;

NodeBound add_joint_boxes(const JointBoxesFit& fit, std::span<const std::uint16_t> joints,
                          NodeBounds& bounds) {
  NodeBound bound{.kind = BoundKind::joint_boxes,
                  .unused = 0,
                  .joint_count = static_cast<std::uint16_t>(joints.size()),
                  .first_joint = static_cast<std::uint32_t>(bounds.joints.size()),
                  .first_record = static_cast<std::uint32_t>(bounds.joint_boxes.size()),
                  .shape = 0,
                  .margin = fit.margin};
  bounds.joints.insert(bounds.joints.end(), joints.begin(), joints.end());
  bounds.joint_boxes.insert(bounds.joint_boxes.end(), fit.boxes.begin(), fit.boxes.end());
  return bound;
}

NodeBound add_affine(const AffineFit& fit, NodeBounds& bounds) {
  NodeBound bound{.kind = BoundKind::affine,
                  .unused = 0,
                  .joint_count = static_cast<std::uint16_t>(fit.joints.size()),
                  .first_joint = static_cast<std::uint32_t>(bounds.joints.size()),
                  .first_record = static_cast<std::uint32_t>(bounds.fits.size()),
                  .shape = static_cast<std::uint32_t>(bounds.shapes.size()),
                  .margin = fit.margin};
  bounds.joints.insert(bounds.joints.end(), fit.joints.begin(), fit.joints.end());
  bounds.fits.insert(bounds.fits.end(), fit.fits.begin(), fit.fits.end());
  bounds.shapes.push_back(fit.shape);
  return bound;
}

bool is_affine_better(const NodeVertices& vertices, const JointBoxesFit& boxes,
                      const AffineFit& affine, std::span<const Palette> samples) {
  NodeBounds both;
  both.nodes = {add_joint_boxes(boxes, vertices.joints(), both), add_affine(affine, both)};
  double boxes_area = 0, affine_area = 0;
  for (const Palette& palette : samples) {
    boxes_area += half_area(linear_box(both, 0, palette));
    affine_area += half_area(linear_box(both, 1, palette));
  }
  return affine_area < kAffineAdvantage * boxes_area;
}

NodeBound fit_node(const NodeVertices& vertices, const WeightRounding& rounding,
                   std::span<const Palette> samples, NodeBounds& bounds) {
  const JointBoxesFit boxes = fit_joint_boxes(vertices, rounding);
  if (vertices.joints().size() > kMaxFittedJoints)
    return add_joint_boxes(boxes, vertices.joints(), bounds);
  const AffineFit affine = fit_affine(vertices, rounding);
  const bool is_finite = stays_finite(affine.fits, affine.margin, vertices.rest_extent());
  return is_finite && is_affine_better(vertices, boxes, affine, samples)
             ? add_affine(affine, bounds)
             : add_joint_boxes(boxes, vertices.joints(), bounds);
}

/// Precondition: the tree has offset caps.
float largest_cap(const Tree& tree, std::span<const std::uint32_t> places) {
  float largest = 0;
  for (const std::uint32_t place : places) largest = std::max(largest, tree.offset_caps[place]);
  return largest;
}

}  // namespace

void find_offset_caps(const Tree& tree, NodeBounds& bounds) {
  if (tree.offset_caps.empty()) return;
  bounds.offset_caps.assign(tree.nodes.size(), 0);
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const Node& node = tree.nodes[n];
    float& largest = bounds.offset_caps[n];
    for (std::uint32_t v = 0; v < node.vertex_count; ++v)
      largest = std::max(largest, tree.offset_caps[node.first_vertex + v]);
    for (std::uint32_t c = 0; c < node.child_count; ++c)
      largest = std::max(largest, bounds.offset_caps[node.first_child + c]);
  }
}

NodeBounds fit_set_bounds(const Tree& tree, std::span<const std::vector<std::uint32_t>> sets,
                          std::span<const Palette> samples) {
  NodeBounds bounds;
  const WeightRounding rounding = weight_rounding(tree);
  NodeVertices vertices(tree);
  for (const std::vector<std::uint32_t>& places : sets) {
    vertices.assign(places);
    bounds.nodes.push_back(places.empty() ? NodeBound{}
                                          : fit_node(vertices, rounding, samples, bounds));
    if (!tree.offset_caps.empty()) bounds.offset_caps.push_back(largest_cap(tree, places));
    if (vertices.is_dual())
      bounds.dual_bounds.push_back(
          add_dual(fit_dual(vertices), vertices.joints(), bounds.nodes.back(), bounds));
  }
  if (tree.morphs.extents.empty()) return bounds;
  DisplacementFit displacements(tree);
  for (std::size_t s = 0; s < sets.size(); ++s)
    if (!sets[s].empty()) displacements.add(bounds, bounds.nodes[s], sets[s]);
  displacements.finish(bounds);
  return bounds;
}

NodeBounds fit_node_bounds(const Tree& tree, std::span<const Palette> samples) {
  NodeBounds bounds;
  bounds.nodes.resize(tree.nodes.size());
  if (tree.dual_influences > 0) bounds.dual_bounds.resize(tree.nodes.size());
  const WeightRounding rounding = weight_rounding(tree);
  NodeVertices vertices(tree);
  each_subtree(tree, [&](std::uint32_t node, std::span<const std::uint32_t> places) {
    vertices.assign(places);
    bounds.nodes[node] = fit_node(vertices, rounding, samples, bounds);
    if (vertices.is_dual())
      bounds.dual_bounds[node] =
          add_dual(fit_dual(vertices), vertices.joints(), bounds.nodes[node], bounds);
  });
  find_offset_caps(tree, bounds);
  if (tree.morphs.extents.empty()) return bounds;
  DisplacementFit displacements(tree);
  each_subtree(tree, [&](std::uint32_t node, std::span<const std::uint32_t> places) {
    displacements.add(bounds, bounds.nodes[node], places);
  });
  displacements.finish(bounds);
  return bounds;
}

}  // namespace pelt::detail
