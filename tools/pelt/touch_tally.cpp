#include "tools/pelt/touch_tally.hpp"

#include "scenes/names.hpp"

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

TouchTally::TouchTally(const scenes::Scene& scene, std::span<const Collider> colliders)
    : scene_(scene), colliders_(colliders) {
  for (const scenes::Character& character : scene.characters) {
    labels_.push_back(label_triangles(character.asset));
  }
}

TouchTally::Labels TouchTally::label_triangles(const asset::Asset& asset) {
  Labels labels;
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

void TouchTally::add(const FrameContacts& found) {
  for (const FrameContacts::Pair& pair : found.pairs) {
    const std::uint32_t a = colliders_[pair.a].instance, b = colliders_[pair.b].instance;
    const Labels& labels_a = labels_[scene_.instances[a].character];
    const Labels& labels_b = labels_[scene_.instances[b].character];
    for (const Contact& contact : found.of(pair)) {
      const std::uint32_t s = contact.triangle_a, t = contact.triangle_b;
      ++joints_[{Place{a, labels_a.joint[s]}, Place{b, labels_b.joint[t]}}];
      ++parts_[{Place{a, labels_a.part[s]}, Place{b, labels_b.part[t]}}];
    }
  }
}

std::vector<TouchTally::Row> TouchTally::joints(std::size_t most) const {
  return rows(joints_, most, scenes::joint_name);
}

std::vector<TouchTally::Row> TouchTally::parts(std::size_t most) const {
  return rows(parts_, most, scenes::part_name);
}

const asset::Asset& TouchTally::asset_of(std::uint32_t instance) const {
  return scene_.characters[scene_.instances[instance].character].asset;
}

std::vector<TouchTally::Row> TouchTally::rows(const Counts& counts, std::size_t most,
                                              Name name) const {
  const auto full_name = [&](const Place& place) {
    const std::string& character =
        scene_.characters[scene_.instances[place.instance].character].name;
    return character + " " + std::to_string(place.instance) + " " +
           name(asset_of(place.instance), place.index);
  };
  std::vector<Row> rows;
  for (const auto& [places, contacts] : counts) {
    rows.push_back({full_name(places.first), full_name(places.second), contacts});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.contacts > b.contacts; });
  if (rows.size() > most) rows.resize(most);
  return rows;
}

}  // namespace pelt::tools
