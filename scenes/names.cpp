#include "scenes/names.hpp"

#include <algorithm>

namespace pelt::scenes {

std::string part_name(const asset::Asset& asset, std::uint32_t part) {
  const asset::Part& p = asset.parts[part];
  const auto shares_node = [&](const asset::Part& other) {
    return &other != &p && other.node == p.node;
  };
  const bool alone = std::none_of(asset.parts.begin(), asset.parts.end(), shares_node);
  const std::string node = p.node.empty() ? p.mesh : p.node;
  if (alone && !node.empty()) return node;
  const std::string material = p.material.empty() ? std::to_string(part) : p.material;
  return (node.empty() ? "part" : node) + ":" + material;
}

std::string joint_name(const asset::Asset& asset, std::uint32_t joint) {
  const std::string& name = asset.joint_name(joint);
  return name.empty() ? "joint " + std::to_string(joint) : name;
}

}  // namespace pelt::scenes
