#include "skin/main_joint.hpp"

#include <algorithm>

namespace pelt::detail {
namespace {

/// `sums` is working memory of the caller.
std::uint32_t main_joint(const SkinnedMesh& mesh, const Triangle& corners,
                         std::vector<Influence>& sums) {
  sums.clear();
  for (const std::uint32_t vertex : corners)
    for (const Influence& influence : mesh.influences_of(vertex)) {
      const auto same = [&](const Influence& sum) { return sum.joint == influence.joint; };
      const auto known = std::find_if(sums.begin(), sums.end(), same);
      if (known == sums.end())
        sums.push_back(influence);
      else
        known->weight += influence.weight;
    }
  const auto less = [](const Influence& a, const Influence& b) {
    return a.weight < b.weight || (a.weight == b.weight && a.joint > b.joint);
  };
  return std::max_element(sums.begin(), sums.end(), less)->joint;
}

}  // namespace

std::vector<std::uint16_t> main_joints(const SkinnedMesh& mesh) {
  std::vector<std::uint16_t> joints;
  joints.reserve(mesh.triangles.size());
  std::vector<Influence> sums;
  for (const Triangle& triangle : mesh.triangles)
    joints.push_back(static_cast<std::uint16_t>(main_joint(mesh, triangle, sums)));
  return joints;
}

}  // namespace pelt::detail
