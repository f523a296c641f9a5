#include "tools/pelt/triangle_labels.hpp"

#include <algorithm>

namespace pelt::tools {
namespace {

/// `weight_of_joint` is all zero before and after: memory lent by the caller.
std::uint32_t dominant_joint(const asset::Asset& asset, const Triangle& triangle,
                             std::vector<float>& weight_of_joint) {
  const std::uint32_t influences = asset.influences_per_vertex;
  const auto for_each_influence = [&](const auto& visit) {
    for (const std::uint32_t v : triangle) {
      for (std::size_t i = std::size_t{v} * influences; i < (v + std::size_t{1}) * influences; ++i)
        visit(asset.joint_indices[i], asset.weights[i]);
    }
  };
  std::uint32_t dominant = 0;
  float most = 0;
  for_each_influence([&](std::uint32_t joint, float weight) {
    const float sum = weight_of_joint[joint] += weight;
    if (sum > most || (sum == most && joint < dominant)) {
      most = sum;
      dominant = joint;
    }
  });
  for_each_influence([&](std::uint32_t joint, float) { weight_of_joint[joint] = 0; });
  return dominant;
}

}  // namespace

TriangleLabels label_triangles(const asset::Asset& asset) {
  TriangleLabels labels;
  std::vector<float> weight_of_joint(asset.joints.size());
  for (const Triangle& triangle : asset.triangles) {
    labels.joint.push_back(dominant_joint(asset, triangle, weight_of_joint));
  }
  labels.part.resize(asset.triangles.size());
  for (std::uint32_t p = 0; p < asset.parts.size(); ++p) {
    const asset::Part& part = asset.parts[p];
    std::fill_n(labels.part.begin() + part.first_triangle, part.triangle_count, p);
  }
  return labels;
}

}  // namespace pelt::tools
