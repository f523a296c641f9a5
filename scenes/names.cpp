#include "scenes/names.hpp"

#include <string_view>
#include <unordered_map>

namespace pelt::scenes {
namespace {

std::string part_name(const asset::Part& part, std::size_t index, bool is_alone) {
  const std::string& node = part.node.empty() ? part.mesh : part.node;
  if (is_alone && !node.empty()) return node;
  const std::string material = part.material.empty() ? std::to_string(index) : part.material;
  return (node.empty() ? "part" : node) + ":" + material;
}

}  // namespace

std::vector<std::string> part_names(const asset::Asset& asset) {
  std::unordered_map<std::string_view, std::size_t> parts_of_node;
  for (const asset::Part& part : asset.parts) ++parts_of_node[part.node];
  std::vector<std::string> names;
  names.reserve(asset.parts.size());
  for (const asset::Part& part : asset.parts)
    names.push_back(part_name(part, names.size(), parts_of_node[part.node] == 1));
  return names;
}

std::string joint_name(const asset::Asset& asset, std::uint32_t joint) {
  const std::string& name = asset.joint_name(joint);
  return name.empty() ? "joint " + std::to_string(joint) : name;
}

std::vector<std::string> joint_names(const asset::Asset& asset) {
  std::vector<std::string> names;
  names.reserve(asset.joints.size());
  for (std::uint32_t j = 0; j < asset.joints.size(); ++j) names.push_back(joint_name(asset, j));
  return names;
}

}  // namespace pelt::scenes
