#include "scenes/near_joints.hpp"

#include "scenes/joint_zones.hpp"
#include "scenes/rigid_nodes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <utility>

namespace pelt::scenes {
namespace {

using Body = std::uint16_t;  // its lowest joint

/// The rigid bodies of a character in their hierarchy.
class Bodies {
 public:
  Bodies(const asset::Asset& asset, std::span<const std::uint16_t> main_joints)
      : asset_(asset), highest_(rigid_nodes(asset)), at_node_(asset.nodes.size()) {
    for (std::size_t j = asset.joints.size(); j-- > 0;)
      at_node_[highest_node(j)] = static_cast<Body>(j);
    of_joint_.reserve(asset.joints.size());
    for (std::size_t j = 0; j < asset.joints.size(); ++j)
      of_joint_.push_back(*at_node_[highest_node(j)]);
    has_triangles_.resize(asset.joints.size());
    for (const std::uint16_t joint : main_joints) has_triangles_[of_joint_[joint]] = true;
  }

  const std::vector<Body>& of_joints() const { return of_joint_; }

  std::vector<Body> of_triangles(std::span<const std::uint16_t> main_joints) const {
    std::vector<Body> bodies;
    bodies.reserve(main_joints.size());
    for (const std::uint16_t joint : main_joints) bodies.push_back(of_joint_[joint]);
    return bodies;
  }

  /// The next body above that moves triangles.
  std::optional<Body> above(Body body) const {
    std::uint32_t node = asset_.nodes[highest_node(body)].parent;
    while (node != asset::kNoParent) {
      const std::uint32_t highest = highest_[node];
      if (const auto found = at_node_[highest]; found && has_triangles_[*found]) return found;
      node = asset_.nodes[highest].parent;
    }
    return std::nullopt;
  }

 private:
  std::uint32_t highest_node(std::size_t joint) const {
    return highest_[asset_.joints[joint].node];
  }

  const asset::Asset& asset_;
  std::vector<std::uint32_t> highest_;        // [nodes] see rigid_nodes
  std::vector<std::optional<Body>> at_node_;  // [nodes] by highest node
  std::vector<Body> of_joint_;                // [J]
  std::vector<bool> has_triangles_;           // [J] by body
};

/// A body with a triangle corner at a rest position.
struct BodyAt {
  std::array<float, 3> position;
  Body body;
  std::uint32_t vertex;

  friend bool operator<(const BodyAt& a, const BodyAt& b) {
    return std::tie(a.position, a.body, a.vertex) < std::tie(b.position, b.body, b.vertex);
  }
  friend bool operator==(const BodyAt& a, const BodyAt& b) {
    return std::tie(a.position, a.body) == std::tie(b.position, b.body);
  }
};

/// Returns the bodies of all corners, ascending, each once at a position.
std::vector<BodyAt> bodies_at_corners(const asset::Asset& asset,
                                      std::span<const Body> triangle_bodies) {
  std::vector<BodyAt> corners;
  corners.reserve(3 * asset.triangles.size());
  for (std::size_t t = 0; t < asset.triangles.size(); ++t)
    for (const std::uint32_t vertex : asset.triangles[t]) {
      const Vec3& p = asset.rest_positions[vertex];
      corners.push_back({{p.x, p.y, p.z}, triangle_bodies[t], vertex});
    }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Adds the pairs of bodies of one position of which one is above the other.
void add_adjoining(std::span<const BodyAt> here, const Bodies& bodies, Borders& borders) {
  constexpr int kMostSteps = 64;  // limits the cost of hostile files
  const auto is_here = [&](Body body) {
    return std::any_of(here.begin(), here.end(), [&](const BodyAt& b) { return b.body == body; });
  };
  if (here.size() < 2 || here.size() > kMostSteps) return;
  for (const BodyAt& corner : here) {
    const std::size_t count = borders.pairs.size();
    std::optional<Body> above = bodies.above(corner.body);
    for (int step = 0; above && step < kMostSteps; ++step, above = bodies.above(*above))
      if (is_here(*above)) borders.pairs.push_back({corner.body, *above});
    if (borders.pairs.size() > count) borders.vertices.push_back({corner.body, corner.vertex});
  }
}

template <typename T>
void sort_unique(std::vector<T>& elements) {
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

Borders find_borders(std::span<const BodyAt> corners, const Bodies& bodies) {
  Borders borders;
  for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
    while (end < corners.size() && corners[end].position == corners[begin].position) ++end;
    add_adjoining(corners.subspan(begin, end - begin), bodies, borders);
  }
  sort_unique(borders.pairs);
  sort_unique(borders.vertices);
  return borders;
}

/// Adds each body with itself, and with the next above unless they adjoin.
void add_hierarchy(const Bodies& bodies, const Borders& borders, std::vector<IndexPair>& pairs) {
  for (std::size_t j = 0; j < bodies.of_joints().size(); ++j) {
    const auto body = static_cast<Body>(j);
    if (bodies.of_joints()[j] != body) continue;
    pairs.push_back({body, body});
    if (const auto above = bodies.above(body))
      if (const IndexPair pair = {body, *above};
          !std::binary_search(borders.pairs.begin(), borders.pairs.end(), pair))
        pairs.push_back(pair);
  }
}

}  // namespace

NearJoints near_joints(const asset::Asset& asset, std::span<const std::uint16_t> main_joints,
                       std::span<const Contact> at_rest) {
  const Bodies bodies(asset, main_joints);
  const std::vector<std::uint16_t> triangle_bodies = bodies.of_triangles(main_joints);
  const Borders borders = find_borders(bodies_at_corners(asset, triangle_bodies), bodies);

  NearJoints near = {bodies.of_joints(), {}, {}, {}};
  add_hierarchy(bodies, borders, near.joint_pairs);
  for (const Contact& contact : at_rest)
    near.joint_pairs.push_back(
        {triangle_bodies[contact.triangle_a], triangle_bodies[contact.triangle_b]});
  JointZones zones = joint_zones(asset, triangle_bodies, borders);
  near.zones = std::move(zones.triangles);
  const auto unzoned = borders.pairs.begin() + static_cast<std::ptrdiff_t>(zones.pair_count);
  near.joint_pairs_in_zones.assign(borders.pairs.begin(), unzoned);
  near.joint_pairs.insert(near.joint_pairs.end(), unzoned, borders.pairs.end());
  sort_unique(near.joint_pairs);
  return near;
}

}  // namespace pelt::scenes
