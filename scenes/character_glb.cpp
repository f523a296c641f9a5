#include "scenes/character_glb.hpp"

#include "base/assert.hpp"
#include "scenes/glb_builder.hpp"

namespace pelt::scenes {
namespace {

using asset::Asset;
using nlohmann::ordered_json;

void add_nodes(const Asset& asset, GlbBuilder& glb) {
  ordered_json& nodes = glb.json["nodes"];
  for (const asset::Node& node : asset.nodes) {
    ordered_json json = {{"name", node.name}};
    json["translation"] = node.local.translation;
    json["rotation"] = node.local.rotation;
    json["scale"] = node.local.scale;
    nodes.push_back(std::move(json));
  }
  for (std::size_t n = 0; n < asset.nodes.size(); ++n) {
    const std::uint32_t parent = asset.nodes[n].parent;
    ordered_json& list =
        parent == asset::kNoParent ? glb.json["scenes"][0]["nodes"] : nodes[parent]["children"];
    list.push_back(n);
  }
}

void add_skin(const Asset& asset, GlbBuilder& glb) {
  std::vector<float> matrices;
  ordered_json joints = ordered_json::array();
  for (const asset::Joint& joint : asset.joints) {
    joints.push_back(joint.node);
    matrices.insert(matrices.end(), joint.inverse_bind.m.begin(), joint.inverse_bind.m.end());
  }
  const std::size_t inverse = glb.add_floats(matrices, asset.joints.size(), "MAT4");
  glb.json["skins"].push_back({{"joints", std::move(joints)}, {"inverseBindMatrices", inverse}});
  glb.json["nodes"][0]["skin"] = 0;
}

void add_morph_targets(const Asset& asset, GlbBuilder& glb, ordered_json& mesh) {
  for (std::size_t m = 0; m < asset.morph_targets.size(); ++m) {
    const std::size_t begin = asset.morph_begin[m], count = asset.morph_begin[m + 1] - begin;
    const std::size_t accessor = glb.add_sparse(
        asset.rest_positions.size(), std::span(asset.morph_vertices).subspan(begin, count),
        std::span(asset.morph_displacements).subspan(begin, count));
    mesh["primitives"][0]["targets"][m]["POSITION"] = accessor;
    mesh["weights"].push_back(asset.morph_targets[m].default_weight);
    mesh["extras"]["targetNames"].push_back(asset.morph_targets[m].name);
  }
}

void add_mesh(const Asset& asset, GlbBuilder& glb) {
  const std::size_t vertex_count = asset.rest_positions.size();
  const asset::Part& part = asset.parts[0];
  ordered_json mesh;
  mesh["name"] = part.mesh;
  ordered_json& primitive = mesh["primitives"][0];
  primitive["attributes"] = {
      {"POSITION", glb.add_positions(asset.rest_positions)},
      {"JOINTS_0", glb.add_shorts(asset.joint_indices, vertex_count, "VEC4")},
      {"WEIGHTS_0", glb.add_floats(asset.weights, vertex_count, "VEC4")}};
  primitive["indices"] = glb.add_indices(asset.triangles);
  primitive["material"] = 0;
  add_morph_targets(asset, glb, mesh);
  glb.json["meshes"].push_back(std::move(mesh));
  glb.json["materials"][0]["name"] = part.material;
  glb.json["nodes"][0]["mesh"] = 0;
}

const char* name_of(asset::Path path) {
  switch (path) {
    case asset::Path::translation:
      return "translation";
    case asset::Path::rotation:
      return "rotation";
    case asset::Path::scale:
      return "scale";
    case asset::Path::weights:
      break;
  }
  return "weights";
}

std::size_t add_values(const asset::Channel& channel, GlbBuilder& glb) {
  const std::size_t floats = channel.values.size();
  if (channel.path == asset::Path::weights) return glb.add_floats(channel.values, floats, "SCALAR");
  const bool is_rotation = channel.path == asset::Path::rotation;
  return glb.add_floats(channel.values, floats / (is_rotation ? 4 : 3),
                        is_rotation ? "VEC4" : "VEC3");
}

void add_clip(const asset::Clip& clip, GlbBuilder& glb) {
  ordered_json samplers = ordered_json::array(), channels = ordered_json::array();
  for (const asset::Channel& channel : clip.channels) {
    PELT_ASSERT(channel.interpolation == asset::Interpolation::linear);
    channels.push_back({{"sampler", samplers.size()},
                        {"target", {{"node", channel.node}, {"path", name_of(channel.path)}}}});
    samplers.push_back(
        {{"input", glb.add_times(channel.times)}, {"output", add_values(channel, glb)}});
  }
  glb.json["animations"].push_back(
      {{"name", clip.name}, {"samplers", std::move(samplers)}, {"channels", std::move(channels)}});
}

}  // namespace

std::vector<std::byte> character_glb(const Asset& asset) {
  PELT_ASSERT(asset.parts.size() == 1 && asset.influences_per_vertex == 4);
  GlbBuilder glb;
  add_nodes(asset, glb);
  add_mesh(asset, glb);
  add_skin(asset, glb);
  for (const asset::Clip& clip : asset.clips) add_clip(clip, glb);
  return glb.file();
}

}  // namespace pelt::scenes
