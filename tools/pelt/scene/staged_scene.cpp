#include "tools/pelt/scene/staged_scene.hpp"

#include "scenes/names.hpp"
#include "text/printable.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <unordered_map>

namespace pelt::tools::scene {
namespace {

/// The joint with the largest weight at a point of a triangle; among equal ones the lowest.
std::uint32_t dominant_joint(const asset::Asset& asset, const Triangle& triangle,
                             const std::array<float, 3>& barycentrics) {
  std::map<std::uint32_t, double> shares;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const std::size_t first = std::size_t{triangle[corner]} * asset.influences_per_vertex;
    for (std::size_t i = first; i < first + asset.influences_per_vertex; ++i)
      shares[asset.joint_indices[i]] +=
          static_cast<double>(barycentrics[corner]) * static_cast<double>(asset.weights[i]);
  }
  const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::max_element(shares.begin(), shares.end(), less)->first;
}

}  // namespace

SceneNames::SceneNames(const scenes::Scene& scene) {
  for (const scenes::Character& character : scene.characters)
    parts_.push_back(scenes::part_names(character.asset));
  std::unordered_map<std::string_view, std::uint32_t> copies;
  for (const scenes::Instance& instance : scene.instances)
    copies_.push_back(copies[scene.characters[instance.character].name]++);
}

std::string collider_name(const StagedScene& staged, const Collider& collider) {
  const std::uint32_t character = staged.scene.instances[collider.instance].character;
  const std::string name = text::printable_name(staged.scene.characters[character].name) + " " +
                           std::to_string(collider.instance);
  if (!collider.part) return name;
  return name + " " + text::printable_name(staged.names->part(character, *collider.part));
}

NamedPoint name_point(const StagedScene& staged, const Collider& collider,
                      const SurfacePoint& point) {
  const std::uint32_t character = staged.scene.instances[collider.instance].character;
  const asset::Asset& asset = staged.scene.characters[character].asset;
  const std::uint32_t triangle = collider.number_in_asset(point.triangle);
  const auto part = &asset.part_of(triangle) - asset.parts.data();
  const std::uint32_t joint = dominant_joint(asset, asset.triangles[triangle], point.barycentrics);
  return {triangle, staged.names->part(character, static_cast<std::uint32_t>(part)),
          scenes::joint_name(asset, joint)};
}

std::string place_words(const StagedScene& staged, const Collider& collider,
                        const SurfacePoint& point) {
  const NamedPoint named = name_point(staged, collider, point);
  std::string words = collider_name(staged, collider);
  if (!collider.part) words.append(" ").append(text::printable_name(named.part));
  return words + " (" + text::printable_name(named.joint) + ", triangle " +
         std::to_string(named.triangle) + ")";
}

}  // namespace pelt::tools::scene
