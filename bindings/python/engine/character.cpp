#include <pelt/asset.hpp>

#include "bindings/python/engine/array_view.hpp"
#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace pelt::python {
namespace {

using asset::Asset;
using asset::Clip;

/// A character of a file: its asset, and the model made of it.
class Character {
 public:
  Character(Asset asset, SkinnedModel model) : asset_(std::move(asset)), model_(std::move(model)) {}

  const Asset& asset() const { return asset_; }
  const SkinnedModel& model() const { return model_; }

  /// -1 is the default pose. Throws an error if there is no such clip.
  const Clip* clip(int index) const {
    if (index == -1) return nullptr;
    if (index >= 0 && static_cast<std::size_t>(index) < asset_.clips.size())
      return &asset_.clips[static_cast<std::size_t>(index)];
    throw ArgumentError("clip: there is no clip " + std::to_string(index));
  }

 private:
  Asset asset_;
  SkinnedModel model_;
};

using Seconds = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// Messages of the reader start with the path.
Asset file_of(const std::string& path, const asset::GltfOptions& options) {
  Result<Asset> asset = asset::load_gltf(path, options);
  if (!asset) throw ArgumentError(asset.error().message);
  return *std::move(asset);
}

Character load(const std::string& path, const std::vector<std::string>& exclude_nodes,
               bool unskinned_parts, bool renormalise) {
  const py::gil_scoped_release unlocked;
  Asset asset = file_of(path, {unskinned_parts, exclude_nodes});
  ModelOptions options;
  if (renormalise) options.off_weights = OffWeights::renormalise;
  SkinnedModel model = value_of(build_model(asset.mesh(), options), path);
  return {std::move(asset), std::move(model)};
}

/// Sines of an infinite time have no meaning.
void check_seconds(const Seconds& seconds) {
  check_shape(seconds, "seconds", {-1}, "[F]");
  for (py::ssize_t f = 0; f < seconds.size(); ++f)
    if (!std::isfinite(seconds.at(f)))
      throw ArgumentError("seconds: frame " + std::to_string(f) + " is not finite");
}

Matrix4 placement_at(const FloatView& placements, std::size_t frame) {
  const std::size_t placed = placements.size(0) == 1 ? 0 : frame;
  Matrix4 placement;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      placement.m[4 * column + row] = placements.at(placed, row, column);
  return placement;
}

/// Writes the matrices row by row.
void write_rows(std::span<const Matrix4> palette, float* out) {
  for (const Matrix4& matrix : palette)
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column) *out++ = matrix.m[4 * column + row];
}

/// Returns the palettes [F, J, 4, 4]. `placements`: [F, 4, 4] or [1, 4, 4].
py::array_t<float> palettes(const Character& character, int clip_index, const Seconds& seconds,
                            const py::array& placements, const Run& run) {
  check_seconds(seconds);
  check_shape(placements, "placement",
              {placements.ndim() == 3 && placements.shape(0) == 1 ? 1 : seconds.size(), 4, 4},
              "[4, 4] or [" + std::to_string(seconds.size()) + ", 4, 4]");
  const Clip* const clip = character.clip(clip_index);
  const FloatView placed(placements, "placement");
  const auto frames = static_cast<std::size_t>(seconds.size());
  const std::size_t joints = character.asset().joints.size();
  py::array_t<float> result = new_array<float>({frames, joints, 4, 4});
  float* const out = result.mutable_data();
  const float* const times = seconds.data();
  run_frames(frames, run, [&](FrameQueue& queue) {
    asset::SampleScratch scratch;
    std::vector<Matrix4> palette(joints);
    while (const auto frame = queue.next()) {
      asset::sample_palette(character.asset(), clip, times[*frame], placement_at(placed, *frame),
                            scratch, palette);
      write_rows(palette, out + *frame * joints * 16);
    }
  });
  return result;
}

/// Returns the morph weights [F, M].
py::array_t<float> morph_weights(const Character& character, int clip_index,
                                 const Seconds& seconds) {
  check_seconds(seconds);
  const Clip* const clip = character.clip(clip_index);
  const auto frames = static_cast<std::size_t>(seconds.size());
  const std::size_t targets = character.asset().morph_targets.size();
  py::array_t<float> result = new_array<float>({frames, targets});
  for (std::size_t f = 0; f < frames; ++f)
    asset::sample_morph_weights(character.asset(), clip, seconds.data()[f],
                                std::span(result.mutable_data() + f * targets, targets));
  return result;
}

std::vector<std::string> joint_names(const Character& character) {
  std::vector<std::string> names;
  for (std::uint32_t j = 0; j < character.asset().joints.size(); ++j)
    names.push_back(character.asset().joint_name(j));
  return names;
}

/// The joint above each joint: that of the nearest node above its node that is a joint, or -1.
std::vector<int> joint_parents(const Character& character) {
  const Asset& asset = character.asset();
  std::vector<int> joint_of_node(asset.nodes.size(), -1);
  for (std::size_t j = asset.joints.size(); j-- > 0;)
    joint_of_node[asset.joints[j].node] = static_cast<int>(j);
  std::vector<int> parents;
  for (const asset::Joint& joint : asset.joints) {
    std::uint32_t node = asset.nodes[joint.node].parent;
    while (node != asset::kNoParent && joint_of_node[node] < 0) node = asset.nodes[node].parent;
    parents.push_back(node == asset::kNoParent ? -1 : joint_of_node[node]);
  }
  return parents;
}

/// The rigid body of each joint, and the body above each, or -1.
std::pair<std::vector<int>, std::vector<int>> joint_bodies(const Character& character) {
  const JointBodies bodies = asset::joint_bodies(character.asset());
  std::vector<int> above;
  for (const std::uint16_t body : bodies.above) above.push_back(body == kNoJoint ? -1 : body);
  return {{bodies.of_joints.begin(), bodies.of_joints.end()}, std::move(above)};
}

std::vector<std::tuple<std::string, float>> clips(const Character& character) {
  std::vector<std::tuple<std::string, float>> result;
  for (const Clip& clip : character.asset().clips) result.emplace_back(clip.name, clip.duration);
  return result;
}

/// The names of node, mesh and material of each part, its first triangle and their number.
using PartRow = std::tuple<std::string, std::string, std::string, std::uint32_t, std::uint32_t>;
std::vector<PartRow> parts(const Character& character) {
  std::vector<PartRow> result;
  for (const asset::Part& part : character.asset().parts)
    result.emplace_back(part.node, part.mesh, part.material, part.first_triangle,
                        part.triangle_count);
  return result;
}

std::vector<std::string> morph_target_names(const Character& character) {
  std::vector<std::string> names;
  for (const asset::MorphTarget& target : character.asset().morph_targets)
    names.push_back(target.name);
  return names;
}

py::array_t<float> rest(const Character& character) {
  const std::vector<Vec3>& positions = character.asset().rest_positions;
  py::array_t<float> result = new_array<float>({positions.size(), 3});
  std::memcpy(result.mutable_data(), positions.data(), positions.size() * sizeof(Vec3));
  return result;
}

py::array_t<std::int32_t> faces(const Character& character) {
  const std::vector<Triangle>& triangles = character.asset().triangles;
  py::array_t<std::int32_t> result = new_array<std::int32_t>({triangles.size(), 3});
  std::memcpy(result.mutable_data(), triangles.data(), triangles.size() * sizeof(Triangle));
  return result;
}

}  // namespace

void add_character(py::module_& module) {
  py::class_<Character>(module, "Character")
      .def_property_readonly("model", [](const Character& c) { return c.model(); })
      .def_property_readonly("clips", &clips)
      .def_property_readonly("joint_names", &joint_names)
      .def_property_readonly("joint_parents", &joint_parents)
      .def_property_readonly("joint_bodies", &joint_bodies)
      .def_property_readonly("morph_target_names", &morph_target_names)
      .def_property_readonly("parts", &parts)
      .def_property_readonly("warnings", [](const Character& c) { return c.asset().warnings; })
      .def_property_readonly("rest", &rest)
      .def_property_readonly("faces", &faces)
      .def("palettes", &palettes, py::arg("clip"), py::arg("seconds"), py::arg("placement"),
           py::arg("run"))
      .def("morph_weights", &morph_weights, py::arg("clip"), py::arg("seconds"));
  module.def("load", &load, py::arg("path"), py::arg("exclude_nodes"), py::arg("unskinned_parts"),
             py::arg("renormalise"));
}

}  // namespace pelt::python
