#include "model/joint_links.hpp"

#include "base/assert.hpp"
#include "base/vec3.hpp"
#include "model/intervals.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace pelt::detail {
namespace {

using Joints = std::pair<std::uint16_t, std::uint16_t>;  // ascending

bool is_before(const JointLink& link, const Joints& joints) { return joints_of(link) < joints; }

}  // namespace

std::vector<JointLink> find_joint_links(const Tree& tree) {
  std::map<Joints, Intervals3> boxes;
  for (std::size_t place = 0; place < tree.rest_positions.size(); ++place) {
    const auto begin = tree.joints.begin() + tree.influence_begin[place];
    const auto end = tree.joints.begin() + tree.influence_begin[place + 1];
    for (auto a = begin; a != end; ++a)
      for (auto b = a + 1; b != end; ++b)
        boxes[std::minmax(*a, *b)].include(Vec3d(tree.rest_positions[place]));
  }
  std::vector<JointLink> links;
  for (const auto& [joints, box] : boxes) {
    JointLink& link = links.emplace_back(JointLink{joints.first, joints.second});
    box.store(link.centre, link.half);
  }
  return links;
}

std::uint32_t link_of(std::span<const JointLink> links, std::uint16_t a, std::uint16_t b) {
  const Joints joints = std::minmax(a, b);
  const auto found = std::lower_bound(links.begin(), links.end(), joints, is_before);
  PELT_ASSERT(found != links.end() && joints_of(*found) == joints);
  return static_cast<std::uint32_t>(found - links.begin());
}

}  // namespace pelt::detail
